#!/usr/bin/env bash
# Options of pictures: every command that draws honours all of them, and the script that is kept draws the same picture; texts are
# texts, of which gnuplot does nothing; what cannot be is refused, by name, before anything is written.
source "$JLT_SOURCE_DIR/tests/scratch.sh"
gnuplot --version > /dev/null 2>&1 || exit 77
export LC_ALL=C.UTF-8 XDG_CACHE_HOME=$scratch/.cache

# Scripts say what was asked for, and gnuplot draws the same from them.
look=(--size=8x6cm '--font=DejaVu Sans,7' --xrange=0.1:0.9 --yrange=0.2:0.7 '--title=A title' --style=grey,nokey,points=7,lines=9)
# A picture without the second in which a PDF was made, which cairo may pack away; with it go lengths and places of parts.
undated() {
    python3 - "$1" << 'END'
import re, sys, zlib

data = open(sys.argv[1], "rb").read()
if data.startswith(b"%PDF"):
    parts = re.findall(rb"(<<(?:(?!stream\r?\n).)*?>>)\s*stream\r?\n(.*?)\nendstream", data, re.S)
    parts = [zlib.decompress(body) if b"/FlateDecode" in head else body for head, body in parts if b"/XRef" not in head]
    data = re.sub(rb"CreationDate \(D:[^)]*\)", b"", b"\n".join(parts))
sys.stdout.buffer.write(data)
END
}
draw() {
    local kind pattern
    for kind in svg pdf png; do
        rm -f p.* rows.csv
        jellett "$@" "${look[@]}" --plot p.$kind --keep p.gp -o rows.csv > /dev/null 2> log ||
            { fail "jellett $*: $(cat log)"; return; }
        mv p.$kind first
        gnuplot p.gp 2> log && [ ! -s log ] || fail "gnuplot on the script of jellett $*: $(cat log)"
        cmp <(undated first) <(undated p.$kind) || fail "jellett $*: the script draws another .$kind"
    done
    for pattern in "^set terminal pngcairo size 945,709 .* font 'DejaVu Sans,7'" "title 'A title' noenhanced" \
        'set xrange \[0\.1:0\.9\]' \
        'set yrange \[0\.2:0\.7\]' '^unset key$'; do
        grep -q -- "$pattern" p.gp || fail "jellett $*: no '$pattern' in the script"
    done
    grep -q '^set key' p.gp && fail "jellett $*: a key, in spite of nokey"
    grep -oE "#[0-9a-f]{6}" p.gp | grep -vE '#(..)\1\1' && fail "jellett $*: colours, in spite of grey"
    grep -oE ' lw [0-9.]+' p.gp | grep -vxE ' lw (18|10\.8|0\.7)' && fail "jellett $*: lines of another width"
    sed 's/keyentry with points pt 7 ps 0.8//g' p.gp | { grep -oE ' ps [0-9.]+' || true; } | awk '$2 < 7 * 0.2 - 1e-6 { exit 1 }' ||
        fail "jellett $*: points of another size"
}
top="--start gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3 --times 0,1"
while read -r line; do
    # shellcheck disable=SC2086
    draw $line
done << END
section lorenz --section z=27 --start x=-13.76,y=-19.58 --returns 3
orbits lorenz --section z=27 --period 2 --start x=-13.76,y=-19.58
fates lorenz --section z=27 --grid x=-20:20:3,y=-20:20:3 --returns 2
fates lorenz --section z=27 --start x=1,y=2 --returns 2
fates lorenz --section z=27 --grid x=-20:20:3,y=-20:20:3 --returns 2 --sweep rho=20:28:2
lyapunov lorenz --section z=27 --start x=-13.76,y=-19.58 --returns 4
lyapunov lorenz --section z=27 --grid x=-14:-13:2,y=-20:-19:2 --returns 1
manifolds --length 0.002 --seed 1e-3
continue --along E=2.14:2.15 --decreasing
transfer lorenz --section z=27 --boxes x=-20:20:8,y=-20:20:8 --strata 3
separation --grid eta=0.40:0.48:3,gamma3=-0.63:-0.61:2 --returns 2 --settle 0 --cells 10x10
drift --returns 4
simulate lorenz --start x=1,y=1,z=20 --times 0,1/2,1
simulate lorenz --start x=1,y=1,z=20 --times 0,1/2,1 --axes z,t
simulate $top
simulate $top --track
eigen --set a3=0,I1=2/5 --at v_nu=0.7,omega3=1.1 --sweep gamma3=-0.9:0.9:4
eigen lorenz
measure --set I3=0 --points 3
rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 --sweep omega_n=0.2:2:3
portrait --set I1=2/5,I3=1/4 --level E=1,G=-0.2,F0=0.15 --orbits 2 --until 1
END

# Where a larger table observes but one quantity more that is drawn against t; where it has no values at all, the states are.
cat > swing.tt << END
model swing
state q
state p
eq q = p
eq p = - q
lift half : into half.tt with q = q, p = p, phi = 0
END
cat > half.tt << END
model half
state q
state p
state phi
eq q = p
eq p = - q
eq phi = 1
observe many = q^64
reduction onto_half : onto swing.tt with q = q, p = p
tier half "a phase"
END
for start in "1 1:5" "1e10 1:2"; do
    jellett simulate ./swing.tt --start q=${start% *},p=0 --times 0,1/2,1 --track --plot p.svg --keep p.gp > rows.csv 2> log &&
        grep -q "^plot .ROWS using ${start#* } " p.gp || fail "one quantity more, from q = ${start% *}: $(cat log)"
done

# Texts that would be commands, if they were not quoted, or not quoted enough.
rm -f ./*
base=(jellett simulate lorenz --start x=1,y=1,z=20 --times "0,1/2,1")
texts=("'" "''" "'''" "'; !touch stolen; '" "\`touch stolen\`" '"`touch stolen`"' "'\`touch stolen\`'" '$(touch stolen)' '\' "\\'" \
    '"' '@GPVAL_TERM' "'@GPVAL_TERM'"
    "'.system('touch stolen').'" '".system("touch stolen")."' $'\n!touch stolen\n' $'a\nset output "stolen"\nreplot' \
        '{/*9 a} a_b^c ~a{b} &{c}' '%s %d'
    '<b>&amp;</b>' '# not a comment' 'Ω γ₃ — “q”' '\n' '$ROWS' "$(printf 'a long title %.0s' {1..40})")
for text in "${texts[@]}"; do
    "${base[@]}" --title "$text" --plot p.svg --keep p.gp -o rows.csv 2> log || fail "--title '$text': $(cat log)"
    [ ! -s log ] || fail "--title '$text': $(cat log)"
    gnuplot p.gp 2> log && [ ! -s log ] || fail "--title '$text', again: $(cat log)"
    # what the picture shows is the text, with its lines broken
    want=$(tr -d '\n ' <<< "$text")
    shown=$(sed -nE 's/^\t\t<text>(.*)<\/text>$/\1/p' p.svg | grep -v '^<tspan' | sed 's/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g' |
        tr -d '\n ')
    [ "$shown" = "$want" ] || fail "--title '$text': the picture shows '$shown'"
    [ "$(echo *)" = "log p.gp p.svg rows.csv" ] || fail "--title '$text' leaves $(echo *)"
done
name="it's \`touch stolen\` @a \$b \\ \"c\".svg"
"${base[@]}" --plot "$name" --keep p.gp -o rows.csv && mv "$name" p.svg && gnuplot p.gp && cmp p.svg "$name" ||
    fail "the path '$name'"
[ ! -e stolen ] || fail "a text was done"

# No line of a caption or a title is wider than the picture: 60 letters of 8 points and less are 8 cm.
for title in --style=grey "--title=$(printf 'long words %.0s' {1..40})"; do
    "${base[@]}" --size 8x6 "$title" --plot p.svg -o rows.csv
    sed -nE 's/^\t\t<text>(.*)<\/text>$/\1/p' p.svg | sed 's/<[^>]*>//g' |
        awk -v what="$title" 'length > 60 { print what ": a line of " length " letters: " $0; exit 1 }' || status=1
done

# Nor is it cut off at an edge where long numbers beside the axis push the axes, and the title above them, aside.
jellett continue --along E=2.14:2.15 --decreasing --size 8x6 --plot p.png -o rows.csv 2> log || fail "continue: $(cat log)"
python3 - p.png << 'END' || status=1
import struct, sys, zlib
data, place, packed = open(sys.argv[1], "rb").read(), 8, b""
while place < len(data):
    length, kind = struct.unpack(">I4s", data[place:place + 8])
    if kind == b"IHDR": width, height, depth, colour = struct.unpack(">IIBB", data[place + 8:place + 18])
    if kind == b"IDAT": packed += data[place + 8:place + 8 + length]
    place += 12 + length
assert (depth, colour) == (8, 2), "no picture of red, green and blue"
rows, above, size = zlib.decompress(packed), bytes(3 * width), 3 * width
for y in range(height):
    row, how = bytearray(rows[y * (size + 1) + 1:(y + 1) * (size + 1)]), rows[y * (size + 1)]
    for i in range(size):
        left, up, corner = (row[i - 3], above[i], above[i - 3]) if i > 2 else (0, above[i], 0)
        guess = left + up - corner
        nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
        row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[how]) % 256
    if row[:9] + row[-9:] != b"\xff" * 18: sys.exit(f"continue: in row {y} something is drawn at the picture's edge")
    above = row
END
jellett continue --along a3=0.509:0.51 --decreasing --count 3 --plot p.svg --keep p.gp -o rows.csv 2> log
grep -q "^set xlabel 'a_{3} \[m\]'" p.gp || fail "continue: the parameter that runs has no unit: $(grep xlabel p.gp)"

# Columns of a key do not run into each other: msadams is 4.334 sizes of letters wide in Helvetica, by its metrics.
jellett drift --returns 2 --plot p.svg -o rows.csv 2> log || fail "drift: $(cat log)"
python3 - << 'END' || status=1
import re, sys
start, size, line = re.search(r"translate\(([0-9.]+),[^>]*font-size=\"([0-9.]+)\"[^>]*>\s*<text><tspan[^>]*>(msadams)</tspan>.*?"
                             r"<title>E</title>.*?d='M([0-9.]+),", open("p.svg").read(), re.S).group(1, 2, 4)
if float(start) + 4.334 * float(size) > float(line): sys.exit("drift: in the key msadams runs into the line of E")
END

# Long names: no text leaves the picture or lies over another panel, a caption leaves room for the axes, a single row is seen.
# Widths are those of Helvetica's letters, 0.55 sizes on average.
long=position_of_the_first_body_on_the_rail other=velocity_of_the_first_body_on_the_rail
cat > long.tt << END
model a_rather_long_name_of_a_model_with_so_many_letters_in_it
param stiffness_of_the_first_spring > 0
param mass_of_the_first_body_on_the_rail > 0
param another_one_that_is_not_used_but_long
state $long
state $other
eq $long = $other + 0*another_one_that_is_not_used_but_long
eq $other = - stiffness_of_the_first_spring*$long/mass_of_the_first_body_on_the_rail
default stiffness_of_the_first_spring = 1, mass_of_the_first_body_on_the_rail = 1, another_one_that_is_not_used_but_long = 1
END
start="$long=1,$other=0"
for look in "--size 8x6" "--size 18x13" "--size 8x6 --axes $long,$other"; do
    jellett simulate ./long.tt --start "$start" --until 9 --every 1/2 $look --plot p.svg --keep p.gp -o rows.csv 2> log ||
        fail "long names, $look: $(cat log)"
    python3 - "$look" << 'END' || status=1
import re, sys
picture = open("p.svg").read()
width = float(re.search(r'viewBox="0 0 ([0-9.]+)', picture).group(1))
frame = [float(x) for d in re.findall(r"d='M[^']*?Z", picture) for x in re.findall(r"[ML]([0-9.]+),", d) if d.count("L") == 4]
wrong = []
for place, size, anchor, text in re.findall(
        r'translate\(([0-9.]+),[0-9.]+\)"[^>]*font-size="([0-9.]+)" *text-anchor="(\w+)">\s*<text>(.*?)</text>', picture, re.S):
    sizes = [(float(s or size), t) for s, t in re.findall(r'<tspan(?: [^>]*?font-size="([0-9.]+)")?[^>]*>([^<]*)', text)]
    long = 0.5 * sum(s * len(t) for s, t in sizes or [(float(size), text)])
    place, shown = float(place), re.sub(r"<[^>]*>", "", text)
    left = place - {"start": 0, "middle": long / 2, "end": long}[anchor]
    if left < 0 or left + long > width: wrong.append(f"{shown} lies outside")
    if re.match("position|velocity", shown) and anchor == "start" and left < max(frame): wrong.append(f"{shown} lies over a panel")
if wrong: sys.exit(f"long names, {sys.argv[1]}: " + "; ".join(wrong))
END
done
[ "$(grep -c 'set title.*stiffness' p.gp)" -eq 0 ] || fail "long names: the caption takes the room of the axes"
jellett simulate ./long.tt --start "$start" --times 0 --plot p.svg --keep p.gp -o rows.csv 2> log
grep -q '^plot .* with points' p.gp || fail "a single row is drawn as a line, which is not seen: $(cat log)"
jellett rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 --sweep omega_n=1:1:1 --plot p.svg --keep p.gp -o rows.csv
grep -q '^plot .* with points' p.gp || fail "a single row of rod is drawn as a line, which is not seen"
jellett continue --along E=2.1:2.2 --count 1 --plot p.svg --keep p.gp -o rows.csv 2> log
grep -q '^plot .* with points' p.gp || fail "a single orbit of continue is drawn as a line, which is not seen: $(cat log)"
# A colour box of one value has room for its label as well.
jellett eigen --set a3=0 --at v_nu=0.7,omega3=1.1 --sweep gamma3=0.3:0.3:1 --plot p.svg --keep p.gp -o rows.csv
grep -q '^set rmargin' p.gp || fail "eigen: the label of a colour box of one value leaves the picture"

# Numbers beside an axis tell its ticks apart and do not run into each other, over any range; numbers are written as in print, not
# as in programs; and a key says what cells without a value are.
cat > scaled.tt << END
model scaled
param k > 0
state x [m]
state v [m/s]
state phi
eq x = v
eq v = - k*x
eq phi = 1
integral energy = v^2 + k*x^2
default k = 1
END
map="./scaled.tt --section phi=0 --modulo phi=2*pi"
while read -r line; do
    jellett $line --size 8x6 --plot p.svg --keep p.gp -o rows.csv 2> log || { fail "jellett $line: $(cat log)"; continue; }
    python3 - "$line" << 'END' || status=1
import re, sys
picture, axes = open("p.svg").read(), {}
width = float(re.search(r'viewBox="0 0 ([0-9.]+)', picture).group(1))
for x, y, size, anchor, inner in re.findall(
        r'translate\(([0-9.]+),([0-9.]+)\)"[^>]*font-size="([0-9.]+)" *text-anchor="(\w+)">\s*<text>(.*?)</text>', picture, re.S):
    parts = [(float(s or size), t) for s, t in re.findall(r'<tspan(?: [^>]*?font-size="([0-9.]+)")?[^>]*>([^<]*)', inner)]
    text = re.sub(r"<[^>]*>", "", inner).strip()
    if re.search("[0-9]e[-+]?[0-9]", text): sys.exit(f"{sys.argv[1]}: '{text}' is not how numbers are printed")
    long = 0.5 * sum(s * len(t) for s, t in parts or [(float(size), text)])
    place = (x if anchor == "end" else y, anchor)
    if re.fullmatch("[−0-9.π/×]+", text): axes.setdefault(place, []).append((float(x), float(y), long, text))
for (_, anchor), ticks in axes.items():
    ticks.sort(key=lambda t: t[0] if anchor == "middle" else t[1])
    for a, b in zip(ticks, ticks[1:]):
        if a[3] == b[3] and "×" not in a[3] and abs(b[1] - a[1]) < 60: sys.exit(f"{sys.argv[1]}: two ticks say {a[3]}")
        if anchor == "middle" and b[0] - a[0] < (a[2] + b[2]) / 2: sys.exit(f"{sys.argv[1]}: {a[3]} runs into {b[3]}")
        if anchor == "end" and b[1] - a[1] < 8: sys.exit(f"{sys.argv[1]}: {a[3]} lies over {b[3]}")
if not any(len(ticks) > 1 for (_, anchor), ticks in axes.items() if anchor == "middle"): sys.exit(f"{sys.argv[1]}: no scale in x")
if not any(len(ticks) > 1 for (_, anchor), ticks in axes.items() if anchor == "end"): sys.exit(f"{sys.argv[1]}: no scale in y")
END
done << END
simulate ./scaled.tt --start x=1e-300,v=0,phi=0 --until 9 --every 1/10
simulate ./scaled.tt --start x=1e150,v=0,phi=1e9 --until 9 --every 1/10
simulate ./scaled.tt --start x=1,v=0,phi=0 --until 1e-3 --every 1e-4
simulate ./scaled.tt --start x=1e-9,v=0,phi=0 --until 9 --every 1/10 --axes x,v
section $map --start x=1,v=0 --returns 9 --xrange 1:1.00000001 --yrange -1e-300:1e300
continue --along E=2.1499999:2.15 --decreasing
drift $map --start x=1,v=0 --returns 20 --xrange 2:8
drift $map --start x=1,v=0 --returns 20 --yrange 2e-15:8e-15
lyapunov $map --start x=1,v=0 --returns 20 --xrange 20:90
lyapunov --grid eta=0.3:0.3000001:3,gamma3=-0.63:-0.61:2 --returns 1
eigen --set a3=0,I1=2/5 --at v_nu=0.7,omega3=1.1 --sweep gamma3=0.3:0.3000001:3
rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0 --sweep omega_n=1:1.00001:30
END
jellett simulate ./scaled.tt --start x=1e-300,v=0,phi=0 --until 9 --every 1/10 --size 8x6 --plot p.svg --keep p.gp -o rows.csv
[ "$(grep -c "^set label '.*×10^{−300}}' at graph" p.gp)" -eq 2 ] ||
    fail "two panels do not say their power of ten: $(grep label p.gp)"
# An integral that does not drift at all is drawn, at the least that the axis says.
cat > still.tt << END
model still
state phi
state p
eq phi = 1
eq p = 0
integral momentum = p
END
jellett drift ./still.tt --section phi=0 --modulo phi=2*pi --start p=1 --returns 4 --plot p.svg --keep p.gp -o rows.csv 2> log &&
    grep -q '^1 1e-17$' p.gp && grep -q "^set ylabel '.*≥ 10^{−17}'" p.gp || fail "no drift is no picture: $(cat log)"

jellett lyapunov --grid 5x4 --returns 5 --plot p.svg --keep p.gp -o rows.csv 2> log || fail "lyapunov: $(cat log)"
grep -q "title '$(grep -vc '^#\|^eta\|,[^,]\+,[^,]\+,[^,]' rows.csv) ended before 5 returns'" p.gp ||
    fail "a chart does not say what its white cells are"
jellett transfer --boxes 8x8 --plot p.svg --keep p.gp -o rows.csv 2> log || fail "transfer: $(cat log)"
# Boxes of density 0 are as white as those without states.
white=$((65 - $(grep -vc '^#' rows.csv))) empty=$(awk -F, '/^eta/ { for (i = 1; i <= NF; i++) if ($i == "density") c = i }
    c && $c == "0" { n++ } END { print n + 0 }' rows.csv)
grep -q "title '$((white + empty)) without states or of density 0'" p.gp || fail "a density does not say what its white boxes are"
sed -n '/^\$GRID/,/^END/p' p.gp | grep -cx '[nN]a[nN]' | grep -qx $((white + empty)) || fail "boxes of density 0 have a colour"

# A table's own columns have units in the picture of a sweep as well.
for axes in "lambda1 λ_{1} 1/s" "t t s" "divergence divergence 1/s"; do
    read -r name shown unit <<< "$axes"
    jellett lyapunov --start eta=0.02,gamma3=-0.61 --returns 3 --sweep a3=0.5:0.51:2 --axes a3,$name \
        --plot p.svg --keep p.gp -o rows.csv 2> log || fail "lyapunov --sweep: $(cat log)"
    grep -q "set ylabel '$shown \[.*$unit\]'" p.gp || fail "lyapunov --sweep: no unit in $(grep ylabel p.gp)"
done
# Low panels have room for fewer labels beside their axes.
jellett portrait --level E=2,G=0.3,F0=0.1 --orbits 2 --until 1 --size 8x8.1 --plot p.svg --keep p.gp -o rows.csv 2> log &&
    ticks=$(grep "^set ytics" p.gp) || fail "portrait: $(cat log)"
[ "$ticks" = "set ytics 1" ] || fail "portrait of 8x8.1 cm: $ticks"

# Every unit has its panel, and panels have room for a line of letters for each of their two ticks and for their gap: letters are
# smaller in small pictures, and a picture that would take letters of less than five points is refused.
printf '%s\n' 'model units' 'state a [m]' 'state b [m/s]' 'state c [rad]' 'state d [kg]' 'state e [kg*m]' 'state f [s]' 'eq a = b' \
    'eq b = -a' 'eq c = 1' 'eq d = a' 'eq e = b' 'eq f = 1' > units.tt
orbit="./units.tt --start a=1,b=0,c=0,d=0,e=0,f=0 --until 1"
for size in 18x13 8x8 8x6 5x5.3; do
    jellett simulate $orbit --size $size --plot p.svg --keep p.gp -o rows.csv 2> log || fail "six units, $size: $(cat log)"
    [ "$(grep -c '^plot' p.gp)" -eq 6 ] || fail "six units, $size: $(grep -c '^plot' p.gp) panels"
    awk -v size=$size -F "[, ']+" '/^set terminal/ { em = $(NF - 1) * 2.54 / 72 / substr(size, index(size, "x") + 1) }
        /^set multiplot/ { for (i = 1; i <= NF; i++) if ($i == "margins") { bottom = $(i + 3); top = $(i + 4); gap = $(i + 7) } }
        END { if ((top - bottom - 5 * gap) / 6 + gap < 3.9 * em) exit 1 }' p.gp || fail "six units, $size: the panels are too low"
done
jellett simulate $orbit --plot p.svg --keep p.gp -o rows.csv 2> log
grep -q 'set multiplot .*; start' p.gp && fail "a caption without parameters begins with a semicolon"
for size in "8x5.2 5.3" "5x5 5.3" "18x13:Times,13 13.7"; do
    rm -f p.svg
    read -r look least <<< "$size"
    expect 2 "^jellett: --size: 6 panels .* $least cm at least; or choose two columns by --axes$" \
        jellett simulate $orbit --size ${look/:/ --font } --plot p.svg -o rows.csv
    [ ! -e p.svg ] || fail "six units, $size: a picture in spite of the refusal"
done
jellett simulate ./long.tt --start "$start" --until 9 --style nokey --plot p.svg --keep p.gp -o rows.csv 2> log
grep -q 'margins [0-9.]*,0\.8[0-9]*,' p.gp || fail "without a key its room stays empty: $(grep margins p.gp)"
# Axes of one scale are as long as the shorter side of their panel, and have as many ticks as fit there.
jellett simulate --start gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3 --until 20 --every 1/2 --track --size 8x8.1 \
    --plot p.svg --keep p.gp -o rows.csv 2> log
[ "$(grep -m 1 '^set xtics' p.gp)" = "set xtics 20" ] || fail "a track to scale: $(grep -m 1 '^set xtics' p.gp)"

refuse() { # WORDS OPTION...: status 2, the option named, and nothing written
    local words=$1 code
    shift
    rm -f ./*
    "${base[@]}" --plot p.svg "$@" > out 2> err
    code=$?
    [ $code -eq 2 ] || fail "$*: status $code"
    [ ! -s out ] && [ ! -e p.svg ] && [ ! -e stolen ] || fail "$*: something is written"
    grep -qF -- "$words" err || fail "$*: says '$(head -1 err)', not '$words'"
}
for value in 8 8x 8x6km 2x2 4.9x8 8x3.9 -8x6cm 1e9x1 nanx6 6cm x 8x6cmcm ''; do refuse --size "--size=$value"; done
for value in "a'b" '$(HOME)' '' ,8 Arial,0 Arial,x Arial,8,9 'Arial"' $'Arial\n!touch stolen' Arial,1e9; do refuse \
    --font "--font=$value"; done
for value in 1 1:1 2:1 :1 1: 1:nan a:b '1:2]; !touch stolen' -1e308:1e308 ''; do refuse --xrange "--xrange=$value"; done
refuse --yrange --yrange=3:pi/2
for value in $'a\tb' $'\xff' $'\xe2\x82' $'\xed\xa0\x80' $'\xe0\x80\x80' $'\xf4\x90\x80\x80' $'\xef\xbf\xbf' $'\xc2\x85'; do
    refuse --title "--title=$value"; done
for value in gray points points=0 points=x lines=1e9 grey,,dots nokey=1 greyish; do refuse --style "--style=$value"; done
for value in x x,w x,y,z ,x 'x,'; do refuse --axes "--axes=$value"; done
base=(jellett drift --returns 4 --method dop853) && refuse --yrange --yrange=-1:1 && refuse --xrange --xrange=0:1
base=(jellett lyapunov --returns 4) && refuse --xrange --xrange=0:1 && refuse --axes --axes=eta,gamma3
base=(jellett separation) && refuse --xrange --xrange=0:1
cat > observing.tt <<'T'
model observing
param k > 0
default k = 1
state x
state v
state z
eq x = v
eq v = - k*x
eq z = 0
observe energy = x^2/2 + v^2/2 [J]
observe nothing = 1/z
T
draws() { # STATUS TEXT OPTION...: of the model above
    local want=$1 text=$2 got=0
    shift 2
    jellett simulate ./observing.tt --start x=1,v=0,z=0 --times 0,1,2 -o observing.csv --plot observing.svg "$@" > out 2> err ||
        got=$?
    [ $got -eq "$want" ] && { [ -z "$text" ] || grep -qF -- "$text" err; } || fail "simulate $*: status $got: $(cat err)"
}
draws 0 '' --axes x,energy
grep -q energy observing.svg || fail "what the table observes is not on its axis"
draws 0 '' --sweep k=1:2:2 --axes k,energy
draws 3 '--axes: nothing has no value in any row: nothing is drawn' --axes t,nothing
draws 3 '--axes: nothing has no value in any row: nothing is drawn' --axes nothing,energy
draws 3 '--plot: nothing has no number in any row: nothing is drawn' --sweep k=1:2:2 --axes k,nothing
draws 3 '--plot: fate has no number in any row: nothing is drawn' --sweep k=1:2:2 --axes k,fate
base=(jellett fates --sweep E=1:2:2) && refuse --axes --axes=eta,gamma3
# The range of an axis in which nothing lies is told, and the table is there; gnuplot's own words are not shown.
rm -f ./*
jellett drift --returns 4 --method dop853 --xrange 1e5:1e6 --plot p.svg -o rows.csv 2> err
[ $? -eq 3 ] && [ -s rows.csv ] && [ ! -e p.svg ] && grep -qF -- '--xrange' err && ! grep -qF 'plot $' err ||
    fail "an empty range: $(cat err)"
for range in xrange=5:6 yrange=2:6; do
    jellett measure --set I3=0 --$range --plot p.svg -o rows.csv 2> err
    [ $? -eq 0 ] && grep -qF -- "nothing lies within --${range%%=*}" err || fail "an empty picture: $(cat err)"
done
jellett measure --set I3=0 --xrange 0.9:6 --plot p.svg -o rows.csv 2> err && [ ! -s err ] || fail "a part of a picture: $(cat err)"
for what in "eigen --sweep gamma3=-0.9:0.9:3" \
    "rod --start gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=0,omega3=0 --sweep v_nu=0.2:2:5"; do
    rm -f ./*
    jellett $what --plot p.svg -o rows.csv 2> err
    [ $? -eq 3 ] && [ -s rows.csv ] && [ ! -e p.svg ] && grep -qF 'nothing that could be drawn came out' err &&
        ! grep -qF 'plot $' err || fail "$what, of which nothing comes out: $(cat err)"
done

# The picture of a grid does not grow with its cells.
jellett fates lorenz --section z=27 --grid x=-20:20:80,y=-20:20:80 --returns 1 --plot p.svg -o rows.csv 2> err
[ "$(wc -c < p.svg)" -lt 100000 ] || fail "6400 cells are drawn in $(wc -c < p.svg) bytes"

jellett eigen --size 8x6cm > out 2> err
[ $? -eq 2 ] && grep -q -- '--plot' err || fail "options of a picture without one are not refused"
exit $status
