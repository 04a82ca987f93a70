#!/usr/bin/env bash
# An installed tree serves: a small program builds against it and runs, found by pkg-config and by CMake, with the shared
# library and with the static one, also after the tree was moved.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
set -e
cmake --install "$JLT_BINARY_DIR" --prefix "$scratch/before" > "$scratch/log" || { cat "$scratch/log"; exit 1; }
mv "$scratch/before" "$scratch/tree"
tree=$scratch/tree

for path in bin/ttc bin/jellett libexec/jellett/jellett-bench share/man/man1/ttc.1 share/man/man1/jellett.1 \
    share/jellett/generated/kernel_abi.h share/jellett/models/spherical_top.tt include/jellett/core/status.h \
    include/jellett/jellett.h \
    share/jellett/examples/orbit.c share/doc/jellett/tools/docs/library.md; do
    [ -e "$tree/$path" ] || fail "not installed: $path"
done
(cd "$tree/share/doc/jellett" && find . -name '*.md' -exec python3 "$JLT_SOURCE_DIR/tools/docs/links" {} +) > "$scratch/links" ||
    fail "links of the installed pages: $(cat "$scratch/links")"
"$tree/bin/jellett" check "$tree/share/jellett/certificates/lorenz_ab.json" > "$scratch/check" ||
    fail "an installed certificate fails"
"$tree/bin/ttc" --version > /dev/null || fail "the installed ttc does not start"
"$tree/bin/jellett" --version > /dev/null || fail "the installed jellett does not start"
"$tree/bin/jellett" bench --help > "$scratch/help" || fail "the installed jellett-bench does not start"
grep -qx 'Usage: jellett bench \[OPTION...\] KIND' "$scratch/help" || fail "jellett bench --help: $(head -n 1 "$scratch/help")"
mv "$tree/libexec/jellett/jellett-bench" "$scratch/"
got=0
"$tree/bin/jellett" bench --help 2> "$scratch/missing" || got=$?
[ $got = 5 ] && grep -q '^jellett: jellett-bench, which measures, is neither beside' "$scratch/missing" ||
    fail "without jellett-bench: exit status $got, $(cat "$scratch/missing")"

cp "$JLT_SOURCE_DIR/tests/unit/install_consumer.c.in" "$scratch/consumer.c"
sanitize=()
if nm "$JLT_BINARY_DIR/libjellett.a" 2>/dev/null | grep __asan_init > /dev/null; then sanitize=(-fsanitize=address,undefined); fi

pc=$(find "$tree" -name jellett.pc)
library=$(dirname "$(find "$tree" -name 'libjellett.so')")
# No other package is looked at: a user of the shared library need not have what it is made with.
export PKG_CONFIG_LIBDIR=${pc%/*} PKG_CONFIG_PATH=
soname=$(readelf -d "$library/libjellett.so" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
[ "$soname" = libjellett.so.0 ] || fail "soname is '$soname', not libjellett.so.0"

strict=(-std=c11 -Wall -Wextra -Wpedantic -Werror)
# Word splitting is how pkg-config's answer is meant to be read.
# shellcheck disable=SC2046
"$JLT_CC" "${strict[@]}" "${sanitize[@]}" "$scratch/consumer.c" -o "$scratch/by_pc_shared" $(pkg-config --cflags --libs jellett) -lm
# shellcheck disable=SC2046
"$JLT_CC" "${strict[@]}" "${sanitize[@]}" "$scratch/consumer.c" -o "$scratch/by_pc_static" $(pkg-config --cflags jellett) \
    $(pkg-config --static --libs jellett | sed 's/-ljellett/-l:libjellett.a/')

mkdir "$scratch/project"
cat > "$scratch/project/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.20)
project(consumer C)
find_package(jellett 0.1 REQUIRED)
foreach(kind shared static)
  add_executable(by_cmake_${kind} ../consumer.c)
  target_link_libraries(by_cmake_${kind} PRIVATE jellett::${kind} m)
endforeach()
CMAKE
unset PKG_CONFIG_LIBDIR # what the static library is linked with is found by CMake
cmake -G Ninja -S "$scratch/project" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$tree" -DCMAKE_C_COMPILER="$JLT_CC" \
    -DCMAKE_C_FLAGS="${sanitize[*]}" > "$scratch/log" && cmake --build "$scratch/build" >> "$scratch/log" ||
    { cat "$scratch/log"; exit 1; }

expected=
for program in by_pc_shared by_pc_static build/by_cmake_shared build/by_cmake_static; do
    output=$(LD_LIBRARY_PATH=$library "$scratch/$program") || fail "$program: exit status $?"
    : "${expected:=$output}"
    [ "$output" = "$expected" ] || fail "$program says '$output', not '$expected'"
    libraries=$(ldd "$scratch/$program")
    case $program in
        *shared) [[ $libraries == *libjellett.so.0* ]] || fail "$program does not use the shared library" ;;
        *static) [[ $libraries != *libjellett* ]] || fail "$program uses the shared library" ;;
    esac
done
echo "$expected"
exit $status
