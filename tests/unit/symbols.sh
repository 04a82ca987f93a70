#!/usr/bin/env bash
# A public symbol says where it lives: in src/ it begins with jlt_ and the stem of its file, or of the header in the same
# folder that declares it (jlt_linear_solve: linear.c or linear.h; a plural stem may drop its s); a const table may carry
# the header of the interface that it implements (jlt_method_dop853: method.h). In generated/ it begins with jlt_, in
# codegen/ with ttc_. Everything else is static.
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
cd "$JLT_SOURCE_DIR"
status=0

# OBJECT KIND SYMBOL, one a line. Sanitizers add symbols that begin with two underscores, OpenMP with a dot.
defined() {
    nm -A --defined-only -g "$1" | awk '$(NF-1) ~ /^[A-Z]$/ && $NF !~ /^(__|\.)/ {
        object = $1; sub(/^[^:]*:/, "", object); sub(/:.*/, "", object); print object, $(NF-1), $NF }'
}

check_library() { # ARCHIVE FOLDER...: every symbol of the archive against the files of the folders
    local archive=$1 object kind symbol stem file folder headers header found
    shift
    while read -r object kind symbol; do
        stem=${object%.o}
        stem=${stem%.c}
        stem=${stem%.cc}
        [[ ${symbol}_ != jlt_${stem}_* && "$* $symbol" != "codegen ttc_"* ]] || continue # as nearly all: no need to look for it
        found=no
        while IFS= read -r file; do
            folder=${file%/*}
            case $file in
                codegen/*) [[ $symbol == ttc_* ]] && found=yes ;;
                generated/*) [[ $symbol == jlt_* ]] && found=yes ;;
                *)
                    headers=$(grep -lw -- "$symbol" "$folder"/*.h || true)
                    [[ $kind != [DRB] ]] || headers=$(ls "$folder"/*.h)
                    for header in "$stem" $headers; do
                        header=${header##*/}
                        header=${header%.h}
                        [[ ${symbol}_ == jlt_${header}_* || ${symbol}_ == jlt_${header%s}_* ]] && found=yes
                    done
                    ;;
            esac
        done < <(find "$@" \( -name "$stem.[ch]" -o -name "$stem.cc" \
            \)) # runtime.c is made by the build: runtime.h declares what is in it
        if [ $found = no ]; then
            echo "$(find "$@" \( -name "$stem.[ch]" -o -name "$stem.cc" \) | head -1): $symbol:" \
                "public, but neither its file's nor its header's stem" \
                "(want jlt_${stem}_... in src/, ttc_... in codegen/; or make it static)"
            status=1
        fi
    done < <(defined "$archive")
}

check_library "$JLT_BINARY_DIR/libjellett.a" src generated
check_library "$JLT_BINARY_DIR/libjellett_exact.a" src/spectrum src/validated src/claims
check_library "$JLT_BINARY_DIR/libjellett_shards.a" src/shards
check_library "$JLT_BINARY_DIR/libttc_core.a" codegen
while read -r object symbol; do
    [[ $symbol == main || $symbol == jlt_* ]] && continue
    echo "$(basename "$object" .o): $symbol: public, but without the prefix jlt_"
    status=1
done < <(find "$JLT_BINARY_DIR"/CMakeFiles/{jellett,jellett_cli,jellett-bench}.dir -name '*.o' -exec nm -A --defined-only -g {} + |
    awk '$(NF-1) ~ /^[A-Z]$/ && $NF !~ /^(__|\.)/ { sub(/:.*/, "", $1); print $1, $NF }')
[ $status -ne 0 ] || echo "$(defined "$JLT_BINARY_DIR/libjellett.a" | wc -l) +" \
    "$(defined "$JLT_BINARY_DIR/libttc_core.a" | wc -l) public symbols carry their prefix"
exit $status
