#!/usr/bin/env bash
# src/jellett.h serves C11, C++17 and C++20 under strict warnings, with gcc and, where it is installed, clang: it compiles, twice
# over; all languages and compilers agree on the layout of structures; and the functions are C's in C++ too. It includes no header
# of commands and none of outside libraries.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
set -e
cd "$JLT_SOURCE_DIR"

cat > "$scratch/use.c" <<'C'
#include "jellett.h"
#include "jellett.h"

#include <stdio.h>

#define TELL(type) printf("%s %zu\n", #type, sizeof(type))

int main(void)
{
    const char *(*text)(jlt_status) = jlt_status_text;
    TELL(jlt_complex);
    TELL(jlt_quantity);
    TELL(jlt_kernel_batch);
    TELL(jlt_descriptor);
    TELL(jlt_stepper);
    TELL(jlt_field);
    TELL(jlt_options);
    TELL(jlt_flow);
    TELL(jlt_return);
    TELL(jlt_image);
    TELL(jlt_system);
    TELL(jlt_surface);
    TELL(jlt_chart_section);
    TELL(jlt_continuation_point);
    TELL(jlt_linearization);
    TELL(jlt_plan);
    TELL(jlt_course_row);
    printf("last %zu %zu\n", offsetof(jlt_descriptor, equilibria), offsetof(jlt_flow, units));
    return text == NULL;
}
C
cp "$scratch/use.c" "$scratch/use.cpp"
cat > "$scratch/text.c" <<'C'
#include "core/status.h"
const char *jlt_status_text(jlt_status status) { (void)status; return ""; }
C

warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Isrc -Igenerated)
used=()
expected=
check() { # COMPILER OPTION SOURCE
    if ! "$1" "$2" "${warnings[@]}" -c "$3" -o "$scratch/use.o"; then
        fail "jellett.h: not by $1 $2"
        return
    fi
    nm "$scratch/use.o" | grep -E '^ +U jlt_status_text$' > /dev/null || fail "$1 $2: jlt_status_text is not a function of C"
    "$1" "$scratch/use.o" "$scratch/text.o" -o "$scratch/use"
    sizes=$("$scratch/use")
    : "${expected:=$sizes}"
    [ "$sizes" = "$expected" ] || fail "$1 $2: another layout: $(diff <(echo "$expected") <(echo "$sizes"))"
    used+=("$1 $2")
}
gcc -std=c11 -Isrc -Igenerated -c "$scratch/text.c" -o "$scratch/text.o"
for compiler in gcc clang; do
    command -v $compiler > /dev/null && check $compiler -std=c11 "$scratch/use.c"
done
for compiler in g++ clang++; do
    for standard in c++17 c++20; do
        command -v $compiler > /dev/null && check $compiler -std=$standard "$scratch/use.cpp"
    done
done
[[ " ${used[*]} " == *" gcc "* && " ${used[*]} " == *" g++ "* ]] || fail "gcc and g++ are wanted: tools/install-deps"

gcc -Isrc -Igenerated -MM "$scratch/use.c" | tr ' ' '\n' | grep -E '^(src|generated)/' | sort -u > "$scratch/headers"
! grep -E '^src/(cli|report)/|/command_|/kernel_ball\.h$' "$scratch/headers" || fail "^ these are no headers for users"
# shellcheck disable=SC2046
foreign=$(grep -hoE '^#include <[^>]+>' $(cat "$scratch/headers") | sort -u |
    grep -vE '<(complex|fenv|math|signal|stdbool|stddef|stdint)\.h>' || true)
[ -z "$foreign" ] || fail "users would need $foreign"
[ $status -ne 0 ] || echo "$(wc -l < "$scratch/headers") headers by ${used[*]}"
exit $status
