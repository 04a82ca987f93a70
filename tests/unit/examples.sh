#!/usr/bin/env bash
# The examples are short, build against an installed tree as pkg-config says, and compute what the programs do by their own ways, or
# what theory says; in C++ likewise.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
set -e
cmake --install "$JLT_BINARY_DIR" --prefix "$scratch/tree" > "$scratch/log" || { cat "$scratch/log"; exit 1; }
pc=$(find "$scratch/tree" -name jellett.pc)
library=$(dirname "$(find "$scratch/tree" -name 'libjellett.so')")
export PKG_CONFIG_LIBDIR=${pc%/*} PKG_CONFIG_PATH= LD_LIBRARY_PATH=$library
export PATH=$scratch/tree/bin:$PATH

sanitize=()
if nm "$JLT_BINARY_DIR/libjellett.a" 2>/dev/null | grep __asan_init > /dev/null; then sanitize=(-fsanitize=address,undefined); fi
build() { # COMPILER STANDARD SOURCE PROGRAM
    # Word splitting is how pkg-config's answer is meant to be read.
    # shellcheck disable=SC2046
    "$1" "$2" -Wall -Wextra -Wpedantic -Werror "${sanitize[@]}" "$3" -o "$4" $(pkg-config --cflags --libs jellett) -lm
}

# Numbers agree to 1e-9 of the larger, or of 1: the default tolerance is 1e-12, and these orbits amplify an error by less than a
# hundred.
agree() { # NAME: $scratch/NAME.said against $scratch/NAME.expected
    [ -s "$scratch/$1.said" ] || fail "$1 says nothing"
    paste -d ';' "$scratch/$1.said" "$scratch/$1.expected" | awk -F ';' -v name="$1" '
        function size(a) { return a < 0 ? -a : a }
        {
            n = split($1, said, ","); m = split($2, expected, ",")
            if (n != m) wrong = 1
            for (i = 1; i <= n && i <= m; i++) {
                if (said[i] == expected[i]) continue
                scale = size(expected[i]) > 1 ? size(expected[i]) : 1
                if (said[i] + 0 == 0 && expected[i] !~ /^[-0-9]/ || !(size(said[i] - expected[i]) <= 1e-9 * scale)) wrong = 1
            }
            if (wrong) { print name ": " $1 ", not " $2; exit 1 }
        }' || status=1
}

for name in orbit section continuation own_field; do
    source=$scratch/tree/share/jellett/examples/$name.c
    [ "$(wc -l < "$source")" -lt 30 ] || fail "$name.c has 30 lines or more"
    build "$JLT_CC" -std=c11 "$source" "$scratch/$name"
    "$scratch/$name" > "$scratch/$name.said" || fail "$name: exit status $?"
done
rows() { grep -v '^#' | sed 1d; }
jellett simulate lorenz --start x=1,y=2,z=20 --times 0.5,1,1.5,2 --method taylor | rows | cut -d, -f1-4 > "$scratch/orbit.expected"
jellett section --start eta=0.1,gamma3=-0.6 --returns 5 --method dop853 | rows | sed 1d |
    cut -d, -f2-5,9 > "$scratch/section.expected"
jellett continue --along E=1.9:2.15 2> "$scratch/log" | rows | grep doubling |
    cut -d, -f2,17 > "$scratch/continuation.expected"
awk 'BEGIN { for (k = 1; k <= 3; k++) printf "%.15g,0.4\n", 2 * k * atan2(0, -1) }' > "$scratch/own_field.expected"
for name in orbit section continuation own_field; do agree $name; done

cat > "$scratch/section.cpp" <<'CPP'
#include <jellett.h>
#include <cstdio>
#include <memory>
#include <vector>

int main()
{
    jlt_handle_section *opened = nullptr;
    if (jlt_handle_section_known(&opened, "spherical_top", nullptr, nullptr, 0, 0) != JLT_OK) return 1;
    const std::unique_ptr<jlt_handle_section, decltype(&jlt_handle_section_destroy)> section(opened, jlt_handle_section_destroy);
    const double start[] = { 0.1, -0.6 };
    std::vector<double> q(10), t(5);
    std::size_t rows = 0;
    int fate = 0;
    if (jlt_handle_section_start(section.get(), start, 1) != JLT_OK) return 2;
    if (jlt_handle_section_returns(section.get(), q.data(), t.data(), nullptr, &rows, &fate, 5) != JLT_OK) return 3;
    for (std::size_t i = 0; i < rows; i++)
        std::printf("%zu,%.15g,%.15g,%.15g,%s\n", i + 1, t[i], q[2 * i], q[2 * i + 1], jlt_section_fate_name(JLT_FATE_ALIVE));
    return fate;
}
CPP
cxx=g++
[[ $JLT_CC != *clang* ]] || cxx=${JLT_CC/clang/clang++}
build "$cxx" -std=c++17 "$scratch/section.cpp" "$scratch/section_cpp"
"$scratch/section_cpp" | diff - "$scratch/section.said" || fail "C++ and C differ"

# Kernels alone, with those in balls: Arb's library has two names.
cd "$JLT_SOURCE_DIR"
flags=(-std=c11 -Wall -Wextra -Wpedantic -Werror -O2 -ffp-contract=off -Igenerated -DJLT_WITHOUT_LANES)
sources=(tools/examples/kernel_alone.c generated/lorenz/general.c generated/lorenz/table.c)
"$JLT_CC" "${flags[@]}" -DJLT_WITHOUT_BALLS "${sources[@]}" -lm -o "$scratch/alone"
[[ $(ldd "$scratch/alone") != *jellett* && $(ldd "$scratch/alone") != *flint* ]] || fail "the kernels are not alone"
"$scratch/alone" | sed 's/.* //' | paste -sd , > "$scratch/alone.said"
jellett simulate lorenz --start x=1,y=2,z=20 --times 0.01 | rows | cut -d, -f2-4 > "$scratch/alone.expected"
agree alone
arb=-lflint
unset PKG_CONFIG_LIBDIR
ldconfig=$(PATH=$PATH:/sbin:/usr/sbin ldconfig -p)
[[ $ldconfig != *libflint-arb.so* ]] || arb="-lflint-arb -lflint"
# shellcheck disable=SC2086
"$JLT_CC" "${flags[@]}" "${sources[@]}" generated/lorenz/lorenz_ball.c generated/kernel_ball.c $arb -lm -o "$scratch/with_balls"
"$scratch/with_balls" | diff - <("$scratch/alone") || fail "with balls the other kernels differ"
for macro in __FAST_MATH__ __ASSOCIATIVE_MATH__ __RECIPROCAL_MATH__; do # as compilers define them for such options
    if "$JLT_CC" "${flags[@]}" -D$macro -c generated/lorenz/general.c -o "$scratch/fast.o" 2> "$scratch/log" ||
        ! grep -q 'kernels need IEEE arithmetic' "$scratch/log"; then fail "kernels with $macro: $(cat "$scratch/log")"; fi
done
[ $status -ne 0 ] || echo "four examples, one in C++, kernels alone and with balls"
exit $status
