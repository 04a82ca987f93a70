#!/usr/bin/env bash
# Every command that integrates gives a problem in other units of mass, length and time (8 kg, 1/4 m, 32 s) the same answer in those
# units, to the last digit. test_scaling.c asks it of random tops.
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
plain=(--set m=1,R=1,g=1,I1=1/3,I3=1/3,a3=0.51)
scaled=(--set m=8,R=1/4,g=1/4096,I1=1/6,I3=1/6,a3=0.1275)
levels=(--level E=2.15,G=-0.56)
scaled_levels=(--level E=215/204800,G=-56/25600)
start='eta=0.3,gamma3=-0.6'

# Rows of one.csv times the units of their columns are those of two.csv.
compare() {
    awk -F, -v what="$*" '
        BEGIN {
            unit["t"] = unit["t_end"] = unit["T"] = 32
            unit["v_nu"] = unit["v_nu_end"] = unit["v_slip"] = 1 / 128
            unit["omega_tau"] = unit["omega_n"] = unit["omega3"] = unit["omega_tau_end"] = unit["omega3_end"] = 1 / 32
            unit["lambda1"] = unit["lambda2"] = unit["divergence"] = 1 / 32
            unit["trace"] = unit["re1"] = unit["re2"] = unit["im1"] = unit["im2"] = 1 / 32
            unit["determinant"] = 1 / 1024
            unit["contact_min"] = unit["contact_force"] = 1 / 512
            unit["x"] = unit["y"] = unit["x_contact"] = unit["y_contact"] = 1 / 4
        }
        /^#/ { next }
        { file = FILENAME; row[file]++ }
        file == "one.csv" { for (i = 1; i <= NF; i++) told[row[file], i] = $i; rows++; next }
        FNR && row[file] == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
        {
            for (i = 1; i <= NF; i++) {
                u = name[i] in unit ? unit[name[i]] : 1
                same = told[row[file], i] == $i || (u != 1 && told[row[file], i] * u == $i + 0)
                if (!same) { print what ": row " row[file] ", " name[i] " = " $i ", not " told[row[file], i] " times " u; exit }
            }
        }
        END { if (rows < 2 || rows != row["two.csv"]) print what ": " rows " rows and " row["two.csv"] + 0 }
    ' one.csv two.csv
}

pair() {
    jellett "$@" "${plain[@]}" "${levels[@]}" -o one.csv 2> err
    jellett "$@" "${scaled[@]}" "${scaled_levels[@]}" -o two.csv 2> err
    compare "$@"
}

{
    pair section --start $start --returns 6 --contact report
    pair section --grid 6x4 --returns 6
    pair fates --grid 6x4 --returns 10
    pair orbits --period 1 --start eta=0.01,gamma3=-0.61
    pair lyapunov --start $start --returns 20
    pair drift --method gauss --returns 50
    pair drift --project --method dop853 --returns 50
    for tier in level five track full; do
        jellett simulate --tier $tier "${plain[@]}" --start gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3 \
            --times 0,1,2 -o one.csv 2> err
        jellett simulate --tier $tier "${scaled[@]}" --times 0,32,64 -o two.csv 2> err \
            --start gamma3=0.25,v_nu=8/1280,omega_tau=-6/320,omega_n=11/320,omega3=-23/320
        compare simulate --tier $tier
    done
    # How many of the orbits are attracted within --until is said in the picture.
    jellett portrait --set m=1,R=1,g=1,I1=1/3,I3=1/4 --start gamma3=0.5,v_nu=0.8,omega_tau=0,omega_n=0,omega3=0.9 --until 1/4 \
        -o one.csv --plot one.svg --keep one.gp --size 40x15
    jellett portrait --set m=8,R=1/4,g=1/4096,I1=1/6,I3=1/8 --until 8 \
        --start gamma3=0.5,v_nu=8/1280,omega_tau=0,omega_n=0,omega3=9/320 -o two.csv --plot two.svg --keep two.gp --size 40x15
    compare portrait
    attracted() { grep -m 1 -o 'of 60 orbits [0-9]* are attracted' "$1"; }
    [ "$(attracted one.gp)" = "$(attracted two.gp)" ] || echo "portrait: attracted $(attracted one.gp), and $(attracted two.gp)"
} > wrong
cat wrong
[ ! -s wrong ]
