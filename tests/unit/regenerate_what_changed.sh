#!/usr/bin/env bash
# tools/regenerate writes what changed alone: nothing where nothing did, the files of one table where it did, everything where
# a written file is not what it was. What it writes is what an undisturbed run gives, and --check sees any other content.
source "$JLT_SOURCE_DIR/tests/scratch.sh"

mkdir -p "$scratch/tree/codegen/models"
cp -r "$JLT_SOURCE_DIR/tools" "$scratch/tree/"
cp "$JLT_SOURCE_DIR/CMakeLists.txt" "$scratch/tree/"
for name in lorenz roessler chaplygin_sleigh; do cp "$JLT_SOURCE_DIR/codegen/models/$name.tt" "$scratch/tree/codegen/models/"; done
cd "$scratch/tree" || exit 1
# A compiler that notes what it was asked to do.
export TTC=$scratch/ttc
printf '#!/bin/sh\necho "$@" >> "%s"\nexec "%s" "$@"\n' "$scratch/calls" "$JLT_BINARY_DIR/bin/ttc" > "$TTC"
chmod +x "$TTC"

regenerate() { # NUMBER OF CALLS OF ttc
    : > "$scratch/calls"
    tools/regenerate > "$scratch/said" 2>&1 || fail "regenerate: $(cat "$scratch/said")"
    [ "$(wc -l < "$scratch/calls")" -eq "$1" ] || fail "ttc is called: $(cat "$scratch/calls"), not $1 times"
}
like_fresh() {
    rm -rf "$scratch/fresh"
    "$JLT_BINARY_DIR/bin/ttc" generate --effort full --out "$scratch/fresh" codegen/models/*.tt
    diff -r -x origin.tsv "$scratch/fresh" generated || fail "$1: generated/ is not what a run from nothing gives"
    tools/regenerate --check > /dev/null || fail "$1: --check does not agree"
}

regenerate 1
like_fresh "first"
regenerate 0

# One table: the files of the others are not touched.
find generated -type f -exec touch -d '2001-01-01' {} +
sed -i 's/^title.*/title "Another title"/' codegen/models/lorenz.tt
regenerate 1
like_fresh "one table"
find generated/roessler generated/chaplygin_sleigh -type f -newermt 2002-01-01 | grep . && fail "files of other tables are written"
regenerate 0

# The coordinates of a section change the files of its model.
printf 'model points\nparam E\nstate q\ndomain inside : E > 0\nroot r = sqrt(2*E)\nlift into moves.tt with q = q, x = 0, u = r\n' \
    > codegen/models/points.tt
printf 'model moves\nstate q\nstate x\nstate u\neq q = u\neq x = u\neq u = 0*u\nintegral E = u^2/2\n%s\n' \
    'section cut : by points.tt at x = 0 with q = q, E = E' > codegen/models/moves.tt
regenerate 1
like_fresh "coordinates"
echo 'start here : q = 1' >> codegen/models/points.tt
regenerate 1
like_fresh "other coordinates"
grep -q '"here"' generated/moves/general.c || fail "the kernels have the coordinates of before"
rm codegen/models/points.tt codegen/models/moves.tt
regenerate 1

# A table less, a table more, a variant less.
mv codegen/models/roessler.tt "$scratch/"
regenerate 1
like_fresh "a table less"
mv "$scratch/roessler.tt" codegen/models/
sed -i '/^ *variant balanced/d' codegen/models/chaplygin_sleigh.tt
regenerate 1
like_fresh "a table more"

# A file that is not what was written, then another compiler.
echo '/* by hand */' >> generated/roessler/general.c
tools/regenerate --check > /dev/null 2>&1 && fail "--check does not see a changed file"
regenerate 1
like_fresh "a changed file"
echo '# another' >> "$TTC"
regenerate 1
regenerate 0

# A table that is wrong changes nothing.
cp -r generated "$scratch/before"
echo 'state' >> codegen/models/lorenz.tt
tools/regenerate > /dev/null 2>&1 && fail "a wrong table passes"
diff -r generated "$scratch/before" || fail "a wrong table changes files"
exit $status
