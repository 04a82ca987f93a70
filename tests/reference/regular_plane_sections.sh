#!/usr/bin/env bash
# Sections STATE=VALUE of a table whose poles are proved go in the time that lifts their root: orbits end at poles by name, and
# returns and their derivatives are what closed forms say; one at a time by every method, and in lanes; with levels and without.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
rows() { # FILE COMMAND...
    local file=$1
    shift
    jellett "$@" > all.csv 2> err || fail "$*: $(cat err)"
    grep -v '^#' all.csv > "$file"
}

# x = sin(theta), theta = theta(0) + w(0) (1 - exp(-c t))/c, beside a clock that crosses h = 0 upwards every 2 pi.
cat > mast.tt <<'T'
model mast
param c > 0
default c = 1/10
state x in (-1, 1)
state w
state h
state q
root s = sqrt(1 - x^2)
eq x = s*w
eq w = - c*w
eq h = q
eq q = - h
integral K = (h^2 + q^2)/2
pole x
time regular : s lifting s
T
ttc prove mast.tt > verdicts 2>&1 || fail "mast.tt: $(cat verdicts)"
# Orbits from x = 0 by w: 0.3 and -0.3 come to the poles; 0.1 does not in three turns, and is at theta = 1 - exp(-0.1 t) then.
starts=(--start x=0,w=0.3,q=1 --start x=0,w=-0.3,q=1 --start x=0,w=0.1,q=1)
solved=(--level K=1/2 --solve q=0.9 --start x=0,w=0.3 --start x=0,w=-0.3 --start x=0,w=0.1)
judge='function off(a, b) { if ((a - b)^2 > 1e-20*(1 + b*b)) bad = 1 }
    BEGIN { pi = atan2(0, -1); end = -log(1 - pi/6)/0.1 }
    $NF ~ /^pole/ { poles++; off($3, end); if ($2 != int(end/(2*pi)) + 1 || $NF != ($1 == 0 ? "pole+" : "pole-") || $1 > 1) bad = 1;
    next }
    $1 == 2 || $2 > 0 { w0 = $1 == 2 ? 0.1 : $1 == 1 ? -0.3 : 0.3; t = 2*pi*$2; theta = w0*(1 - exp(-0.1*t))/0.1; returns++
                        off($3, t); off($4, sin(theta)); off($5, w0*exp(-0.1*t)); off($6, 1) }
    END { exit bad || poles != 2 || returns != 6 }'
for how in "" "--method gauss" "--method dop853" "--method taylor" "--method rk8pd"; do
    rows free.csv section ./mast.tt --section h=0 --returns 3 $how "${starts[@]}"
    rows level.csv section ./mast.tt --section h=0 --returns 3 $how "${solved[@]}"
    for file in free.csv level.csv; do
        tail -n +2 $file | awk -F, "$judge" || fail "$file ${how:-in lanes}: $(cat $file)"
    done
done
grep -q 'time regular' all.csv || fail "the header does not name the time: $(head -3 all.csv)"
# What is told of ends is the states, without the root.
rows fates.csv fates ./mast.tt --section h=0 --returns 3 "${starts[@]}"
awk -F, 'NR == 1 { if ($0 !~ /x_end,w_end,h_end,q_end$/) bad = 1; next } NF != 9 || $4 != ($1 == 0 &&
    $2 > 0.2 ? "pole+" : $2 < 0 ? "pole-" : "alive") { bad = 1 }
         /pole/ { if ($6 != ($4 == "pole+" ? 1 : -1)) bad = 1 } END { exit bad || NR != 4 }' fates.csv ||
             fail "fates: $(cat fates.csv)"
# theta' = theta + w (1 - e)/c, w' = e w with e = exp(-2 pi c): trace and determinant of the return map in (x, w) and q, or of (x,
# w).
rows check.csv section ./mast.tt --section h=0 --returns 1 --check --start x=0,w=0.1,q=1
rows checked.csv section ./mast.tt --section h=0 --returns 1 --check --level K=1/2 --solve q=0.9 --start x=0,w=0.1
for file in check.csv:1 checked.csv:0; do
    tail -1 "${file%:*}" | awk -F, -v more="${file#*:}" '{ pi = atan2(0, -1); e = exp(-0.2*pi); theta = 1 - e
        trace = cos(theta) + e + more; det = cos(theta)*e
        exit !(($(NF - 3) - trace)^2 < 1e-18 && ($(NF - 2) - det)^2 < 1e-18 && $NF^2 < 1e-18) }' || fail "DP: $(cat "${file%:*}")"
done
# Where the pole is not proved orbits go in plain time, which stops before it.
sed '/^pole/d' mast.tt > bare.tt
rows bare.csv section ./bare.tt --section h=0 --returns 3 --start x=0,w=0.3,q=1
grep -q left_domain bare.csv || fail "without the record the orbit does not end at its interval: $(cat bare.csv)"
# A claim beside, of an integral that is none, takes nothing from the field: orbits end at poles by name all the same.
{ cat mast.tt; echo 'integral W = w'; } > beside.tt
ttc prove beside.tt > verdicts 2>&1 && fail "W is no integral: $(cat verdicts)"
rows beside.csv section ./beside.tt --section h=0 --returns 3 "${starts[@]}"
tail -n +2 beside.csv | awk -F, "$judge" || fail "beside a claim that is refuted: $(cat beside.csv)"
exit $status
