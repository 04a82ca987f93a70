#!/usr/bin/env bash
# What must not be found: pow in generated kernels; compiler flags or pragmas that let the compiler decide accuracy; exit,
# abort and printing in the libraries; unfinished business anywhere.
set -euo pipefail
cd "$JLT_SOURCE_DIR"
status=0
refuse() { # REASON PATTERN FILE...: no line of the files, as far as they are text, may match
    local reason=$1 pattern=$2
    shift 2
    [ $# -gt 0 ] || return 0
    if grep -InE -- "$pattern" "$@" /dev/null; then
        echo "^ $reason"
        status=1
    fi
}
list() { find "$@" -type f; }

mapfile -t kernels < <(list generated -name '*.c')
refuse "powers are multiplications in generated kernels" '\bc?pow[fl]?[[:space:]]*\(' "${kernels[@]}"

mapfile -t build < <(list tools tests CMakeLists.txt CMakePresets.json .ci ! -name forbidden.sh)
mapfile -t sources < <(list src codegen generated tests \( -name '*.c' -o -name '*.h' \))
accuracy='-O''fast|-f''fast-math|-funsafe-math|-fassociative-math|-ffinite-math|-freciprocal-math|-ffp-contract=(fast|on)'
accuracy+='|pragma[[:space:]]+STDC[[:space:]]+FP_CONTRACT[[:space:]]+ON|__attribute__.*optimize'
refuse "the compiler never decides accuracy" "$accuracy" "${build[@]}" "${sources[@]}"

mapfile -t library < <(list src generated \( -name '*.c' -o -name '*.h' \) ! -path 'src/cli/*' ! -path 'src/top/command_*')
mapfile -t compiler < <(list codegen -name '*.c' ! -name main.c ! -name 'command*.c')
refuse "a library never ends the program" '\b(exit|_Exit|abort|quick_exit)[[:space:]]*\(' "${library[@]}" "${compiler[@]}"
refuse "a library never prints" '(^|[^a-z_])(printf|puts|putchar|perror)[[:space:]]*\(|(^|[^/a-z_])(stdout|stderr)\b' \
    "${library[@]}"

mapfile -t prose < <(list src codegen generated tests tools README.md CMakeLists.txt ! -name forbidden.sh)
refuse "nothing is left unfinished" '\b(TO''DO|FIX''ME|X''XX|HA''CK)\b' "${prose[@]}"
[ $status -ne 0 ] || echo "nothing forbidden in ${#prose[@]} files"
exit $status
