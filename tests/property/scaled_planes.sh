#!/usr/bin/env bash
# A table with units gives a problem in other units of mass, length and time the same answer in those units, to the last digit, on
# sections STATE=VALUE and on those that tables describe: in everyday ones (8 kg, 1/4 m, 32 s) and in those of atoms (2^-89 kg,
# 2^-33 m, 2^-50 s).
set -euo pipefail
awk() { LC_ALL=C command awk "$@"; } # numbers have points in any locale
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
export XDG_CACHE_HOME=$PWD/cache
cat > pair.tt <<'T'
model pair
title "Two coupled springs, the second hardening"
param m > 0 [kg]
param k > 0 [kg/s^2]
param L > 0 [m]
param c >= 0 [1/s]
state x [m]
state y [m]
state v [m/s]
state w [m/s]
eq x = v
eq y = w
eq v = - k*x/m - k*y^2*x/(m*L^2) - c*v
eq w = - 2*k*y/m - k*x^2*y/(m*L^2) - k*y^3/(m*L^2) - c*w
default m = 1, k = 1, L = 1, c = 0
variant free : c = 0
integral E = m*(v^2 + w^2)/2 + k*x^2/2 + k*y^2 + k*x^2*y^2/(2*L^2) + k*y^4/(4*L^2) when c = 0
T
# Its parameters say nothing of lengths, its states do.
cat > planet.tt <<'T'
model planet
title "A planet of the sun"
param GM > 0 [m^3/s^2]
state x [m]
state y [m]
state u [m/s]
state v [m/s]
root r = sqrt(x^2 + y^2)
eq x = u
eq y = v
eq u = - GM*x/r^3
eq v = - GM*y/r^3
T
# The same without damping, with a section that a table describes.
sed -e 's/model pair/model free/' -e '/^param c/d' -e '/^variant/d' -e 's/, c = 0//' -e 's/ when c = 0//' -e 's/ - c\*[vw]$//' \
    pair.tt > free.tt
cat >> free.tt << 'T'
reversor x -> -x, w -> -w
section crossing : by free_section.tt at x = 0 with y = y, w = w, E = E beside v
T
cat > free_section.tt << 'T'
model free_section
param m > 0 [kg]
param k > 0 [kg/s^2]
param L > 0 [m]
param E [kg*m^2/s^2]
default m = 1, k = 1, L = 1, E = 1/2
state y [m]
state w [m/s]
let square = 2*E/m - w^2 - 2*k*y^2/m - k*y^4/(2*m*L^2)
domain reached : square > 0
root v = sqrt(square)
lift into free.tt with x = 0, y = y, v = v, w = w
T
ttc prove pair.tt free.tt planet.tt > proofs || { cat proofs; exit 1; }

# The words with every @NUMBER{KG,M,S} counted in units of 2^kg, 2^m and 2^s: a quantity of dimension kg^KG m^M s^S.
in_units() { # KG M S WORD...
    local units="$1 $2 $3"
    shift 3
    printf '%s\n' "$@" | awk -v units="$units" '
        BEGIN { split(units, unit, " ") }
        {
            count = split($0, part, "@")
            out = part[1]
            for (i = 2; i <= count; i++) {
                split(part[i], at, /[{}]/)
                split(at[2], power, ",")
                out = out sprintf("%.17g", at[1] * 2^-(unit[1]*power[1] + unit[2]*power[2] + unit[3]*power[3])) at[3]
            }
            print out
        }'
}

# Rows of one.csv are those of two.csv times the units of their columns.
compare() { # KG M S WHAT...
    awk -F, -v kg="$1" -v m="$2" -v s="$3" -v what="${*:4}" '
        BEGIN {
            unit["t"] = unit["t_end"] = unit["T"] = 2^s
            unit["x"] = unit["x_end"] = unit["y"] = unit["y_end"] = 2^m
            unit["u"] = unit["v"] = unit["w"] = unit["u_end"] = unit["v_end"] = unit["w_end"] = 2^(m - s)
            unit["k"] = 2^(kg - 2*s)
            unit["lambda1"] = unit["lambda2"] = unit["lambda3"] = unit["exponent"] = 2^-s
        }
        /^#/ { next }
        { file = FILENAME; row[file]++ }
        file == "one.csv" { for (i = 1; i <= NF; i++) told[row[file], i] = $i; rows++; next }
        row[file] == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
        {
            for (i = 1; i <= NF; i++) {
                u = name[i] in unit ? unit[name[i]] : 1
                same = told[row[file], i] == $i || (u != 1 && told[row[file], i] + 0 == $i * u)
                if (!same) { print what ": row " row[file] ", " name[i] " = " $i ", not " told[row[file], i] " over " u; exit }
            }
        }
        END { if (rows < 2 || rows != row["two.csv"]) print what ": " rows " rows and " row["two.csv"] + 0 }
    ' one.csv two.csv
}

pair() { # COMMAND...
    each "$1" ./pair.tt --section x=0 --set "m=@1{1,0,0},k=@1{1,0,-2},L=@1{0,1,0},c=${damping:-0}" "${@:2}"
}

described() { # ENERGY COMMAND...
    each "$2" ./free.tt --section crossing --set 'm=@1{1,0,0},k=@1{1,0,-2},L=@1{0,1,0}' --level "E=@$1{1,2,-2}" "${@:3}"
}

planet() { # COMMAND...
    each "$1" ./planet.tt --section y=0 --set 'GM=@1{0,3,-2}' "${@:2}"
}

each() { # COMMAND...
    local command=("$@") units
    for units in "3 -2 5" "-89 -33 -50"; do
        mapfile -t first < <(in_units 0 0 0 "${command[@]}")
        mapfile -t second < <(in_units $units "${command[@]}")
        jellett "${first[@]}" -o one.csv 2> err || cat err
        jellett "${second[@]}" -o two.csv 2> err || cat err
        compare $units "$@"
    done
}

level=(--level 'E=@0.5{1,2,-2}' --solve 'v=@0.9{0,1,-1}')
start='y=@0.3{0,1,0},w=@0.2{0,1,-1}'
grid='y=@-0.4{0,1,0}:@0.4{0,1,0}:4,w=@-0.4{0,1,-1}:@0.4{0,1,-1}:4'
{
    pair section --start "$start,v=@0.9{0,1,-1}" --returns 5
    pair section --start "$start,v=@0.9{0,1,-1}" --start 'y=@-0.5{0,1,0},w=@0.1{0,1,-1},v=@0.8{0,1,-1}' --returns 5
    damping='@0.125{0,0,-1}' pair section --start "$start,v=@0.9{0,1,-1}" --returns 5
    pair section "${level[@]}" --start "$start" --returns 5 --check
    pair section "${level[@]}" --grid "$grid" --returns 5 --project
    pair fates --grid "$grid,v=@0.5{0,1,-1}:@1{0,1,-1}:3" --returns 5
    pair orbits "${level[@]}" --grid "$grid" --period 1
    pair lyapunov "${level[@]}" --start "$start" --returns 20
    pair lyapunov "${level[@]}" --grid "$grid" --returns 5
    pair drift --start "$start,v=@0.9{0,1,-1}" --returns 20
    pair manifolds --level 'E=@8{1,2,-2}' --solve 'v=@4{0,1,-1}' --start 'y=@0{0,1,0},w=@0{0,1,-1}' \
        --length 0.8
    pair continue "${level[@]}" --along 'k=@1{1,0,-2}:@1.5{1,0,-2}' --start 'y=@0{0,1,0},w=@0{0,1,-1}' --step 0.1
    planet section --start 'x=@1{0,1,0},u=@0{0,1,-1},v=@1.125{0,1,-1}' --returns 5 --check
    planet lyapunov --start 'x=@1{0,1,0},u=@0{0,1,-1},v=@1.125{0,1,-1}' --returns 20
    planet fates --grid 'x=@1{0,1,0}:@2{0,1,0}:4,u=@0{0,1,-1}:@0.5{0,1,-1}:2,v=@0.875{0,1,-1}' --returns 5
    described 0.5 section --start "$start" --start 'y=@-0.5{0,1,0},w=@0.1{0,1,-1}' --returns 5 --check
    described 0.5 section --grid "$grid" --returns 5
    described 0.5 fates --grid "$grid" --returns 5
    described 0.5 orbits --grid "$grid" --period 1
    described 0.5 lyapunov --start "$start" --returns 20
    described 0.5 lyapunov --grid "$grid" --returns 5
    described 0.5 drift --start "$start" --returns 20
    described 0.5 separation --grid "$grid" --cells "$grid" --returns 8
    described 0.5 continue --along 'k=@1{1,0,-2}:@1.5{1,0,-2}' --start 'y=@0{0,1,0},w=@0{0,1,-1}' --step 0.1
    described 8 manifolds --start 'y=@0{0,1,0},w=@0{0,1,-1}' --length 0.8
} > wrong
cat wrong
[ ! -s wrong ]
