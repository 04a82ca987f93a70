#!/usr/bin/env bash
# What scene/handle.h gives to Python through ctypes is what `jellett section` and `jellett simulate` write, bit for bit.
set -euo pipefail
library=$JLT_BINARY_DIR/libjellett.so
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export XDG_CACHE_HOME=$scratch

# A sanitizer in the library has to be in Python from its start, which does not free all that it allocates.
if nm -D "$library" | grep -E ' U __(asan|tsan)_init' > "$scratch/sanitizer"; then
    name=$(sed -E 's/.*__(.)san_init.*/\1san/' "$scratch/sanitizer" | head -1)
    for runtime in "libclang_rt.$name-$(uname -m).so" "lib$name.so"; do
        path=$("$JLT_CC" -print-file-name="$runtime")
        [ "$path" = "$runtime" ] || break
    done
    export LD_PRELOAD=$path ASAN_OPTIONS=detect_leaks=0
fi
table=$JLT_SOURCE_DIR/codegen/models/lotka_volterra.tt
object=$(LD_PRELOAD='' ttc build "$table")
# Another table of the name to which nothing is proved to lead.
sed 's/^title .*/title "another table"/' "$JLT_SOURCE_DIR/codegen/models/spherical_top_level.tt" > "$scratch/spherical_top_level.tt"
foreign=$(LD_PRELOAD='' ttc build "$scratch/spherical_top_level.tt")
# A top that names no pole, as the tables that serve in its place do.
cp "$JLT_SOURCE_DIR"/codegen/models/spherical_top*.tt "$scratch"
top=$scratch/spherical_top.tt
sed -i '/^pole/d' "$top"
poleless=$(LD_PRELOAD='' ttc build "$top")
python3 "$JLT_SOURCE_DIR/tests/unit/handles.py" "$library" "$object" "$table" "$foreign" "$poleless" "$top"

# The lines of Python in the page of the library.
sed -n '/^    import ctypes/,/^$/s/^    //p' "$JLT_SOURCE_DIR/tools/docs/library.md" |
    sed "s|libjellett.so.0|$library.0|" > "$scratch/page.py"
python3 "$scratch/page.py" > "$scratch/page"
LD_PRELOAD='' jellett section --start eta=0.1,gamma3=-0.6 --returns 100 | tail -1 | cut -d, -f3-5 | tr , ' ' |
    diff "$scratch/page" - ||
    { echo "tools/docs/library.md: Python says another row"; exit 1; }
