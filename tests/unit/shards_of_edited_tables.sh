#!/usr/bin/env bash
# All pieces of a study, and of its shards, are of the tables that it was opened with, whichever of them is edited meanwhile.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
trap 'kill $(jobs -p) 2>/dev/null; wait; rm -rf "$scratch"' EXIT
unset OMPI_COMM_WORLD_RANK PMI_RANK PMIX_RANK SLURM_PROCID SLURM_ARRAY_TASK_ID PARALLEL_SEQ
expect() { # STATUS TEXT COMMAND...
    local want=$1 text=$2 code
    shift 2
    "$@" > out 2> err
    code=$?
    [ $code -eq "$want" ] || fail "$*: status $code, not $want: $(head -3 err)"
    [ -z "$text" ] || grep -qF -- "$text" out err || fail "$*: nothing is said of '$text': $(head -3 err)"
}

cat > ends.scene << 'END'
levels = { E = 2.15; G = -0.56; };
accuracy = { tolerance = 1e-9; };
piece = 11;
compute = ( { what = "fates"; grid = { eta = (-3, 3, 9); gamma3 = (-0.9999, 0.9999, 15); }; returns = 3; } );
END

# A table that is edited while its pieces are computed; --resume sees it.
printf '%s\n' 'model edited' 'param k' 'default k = 1' 'state x' 'state y' 'state z' 'eq x = y' 'eq y = -k*x' 'eq z = 1' > edited.tt
cat > edited.scene << 'END'
model = "./edited.tt";
piece = 4;
compute = ( { what = "section"; section = { y = 0; }; grid = { x = (0.1, 1, 400); z = (0, 1, 40); }; returns = 2; } );
END
expect 0 "" jellett sweep edited.scene --into=edited
jellett sweep edited.scene --into=meanwhile 2> log &
meanwhile=$!
for _ in $(seq 1200); do grep -q "of them are there" log && break; sleep 0.05; done
sed -i.before 's/-k\*x/-2*k*x/' edited.tt
wait $meanwhile
code=$?
[ $code = 0 ] || { [ $code = 5 ] && grep -q "was edited" log; } || fail "a table that is edited meanwhile: $code, $(cat log)"
expect 3 "kernels.edited: there" jellett sweep edited.scene --into=meanwhile --resume
mv edited.tt.before edited.tt
expect 0 "" jellett sweep edited.scene --into=meanwhile --resume
for into in edited meanwhile; do jellett merge $into -o $into.csv || fail "$into cannot be merged"; done
cmp edited.csv meanwhile.csv || fail "a table that is edited meanwhile: rows of both"
# Tables that the model's records lead to count as it does.
cp "$JLT_SOURCE_DIR"/codegen/models/spherical_top*.tt .
sed 's/^model.*//; s/^levels/model = ".\/spherical_top.tt"; levels/' ends.scene > beside.scene
echo "# edited" >> spherical_top_balanced.tt
expect 0 "" jellett sweep beside.scene
echo "# edited" >> spherical_top_balanced.tt
expect 3 "kernels.spherical_top_balanced.tt: there" jellett sweep beside.scene --resume
# So do those that only records of the tables beside it lead to, even if nothing else is edited: here the levels are a default.
cp "$JLT_SOURCE_DIR"/codegen/models/spherical_top*.tt .
sed 's/^levels.*//; s/^model.*//; 1i model = "./spherical_top.tt";' ends.scene > levels.scene
expect 0 "" jellett sweep levels.scene --shard=1/2
sed -i 's/E = 2.15/E = 2.25/' spherical_top_section.tt
expect 3 "kernels.spherical_top_section.tt: there" jellett sweep levels.scene --shard=1/2 --resume
# Nor are they followed while pieces are computed.
cp "$JLT_SOURCE_DIR"/codegen/models/spherical_top_section.tt .
printf '%s\n' 'model = "./spherical_top.tt"; piece = 1;' \
    'compute = ( { what = "fates"; grid = "6x6"; returns = 3000; } );' > long.scene
expect 0 "" jellett sweep long.scene --into=before
jellett sweep long.scene --into=during 2> log &
during=$!
for _ in $(seq 1200); do grep -q "of them are there" log && break; sleep 0.05; done
sed -i 's/E = 2.15/E = 2.25/' spherical_top_section.tt
wait $during || fail "a table of coordinates that is edited meanwhile: $?, $(cat log)"
for into in before during; do jellett merge $into -o $into.csv || fail "$into cannot be merged"; done
cmp before.csv during.csv || fail "a table of coordinates that is edited meanwhile: rows of both"
# Also behind a reduction onto a table that stands between.
cp "$JLT_SOURCE_DIR"/codegen/models/spherical_top*.tt .
sed 's/spherical_top.tt/spherical_top_track.tt/' levels.scene > behind.scene
expect 0 "" jellett sweep behind.scene --shard=1/2
sed -i 's/E = 2.15/E = 2.25/' spherical_top_section.tt
expect 3 "kernels.spherical_top_section.tt: there" jellett sweep behind.scene --shard=1/2 --resume
exit $status
