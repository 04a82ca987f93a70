# usage: gnuplot -c stability.gp DIR [TERMINAL]: the pictures of tools/bench/stability, from DIR/*.csv to DIR/*.svg (or .png).
extension = ARGC > 1 ? ARG2 : 'svg'
size = '1200,620'
if (extension eq 'png') { set terminal pngcairo size @size font 'sans,12' } else { set terminal svg size @size font 'sans,16' background 'white' }
set datafile separator ','
set encoding utf8
set format x '10^{%T}'
set format y '10^{%T}'
set logscale xy
set grid lc rgb '#dddddd'
set key noenhanced samplen 3 spacing 0.9
file(name) = sprintf('%s/%s.%s', ARG1, name, extension)
# Rows of a table whose columns have these values: "< awk ..."; 0 stands for any.
rows(name, a, b) = sprintf("< awk -F, 'NR>1 && (\"%s\"==\"0\" || $1==\"%s\") && (\"%s\"==\"0\" || $2==\"%s\")' '%s/%s.csv'", a, a, b, b, ARG1, name)
methods = 'dop853 gauss taylor rk8pd rkf45 msadams'
colours = '#0072b2 #009e73 #cc79a7 #d55e00 #e69f00 #56b4e9'
colour(i) = word(colours, i)
marks = '7 5 9 11 13 2' # so that methods are told apart in grey; a small pentagon looks like a circle
mark(i) = int(word(marks, i))


set output file('pole_approach')
set multiplot layout 1,2 title 'Into a pole at tolerance 10^{-12}: solid in regularised time, dashed in plain time'
set xrange [1:1e-12] reverse
set xlabel 's, distance from the pole'
set ylabel 'steps so far'
set key top left reverse Left
set yrange [10:1e5]
plot for [i=1:6] rows('pole_approach', 'five', word(methods, i)) using (column(3)):4 with linespoints lw 1.5 pt mark(i) ps 1 lc rgb colour(i) title word(methods, i), \
     for [i=1:6] rows('pole_approach', 'unwatched', word(methods, i)) using (column(3)):4 with linespoints dt 2 pt mark(i) ps 1 lc rgb colour(i) notitle
set ylabel 'error in v_ν, ω_τ, ω_n, ω_3, t at that s'
unset key
set yrange [1e-14:1]
set arrow 1 from 3.8e-6, 1e-14 to 3.8e-6, 1 nohead lc rgb '#888888'
set label 1 'plain time is refused beyond' at 2e-6, 0.1
plot for [i=1:6] rows('pole_approach', 'five', word(methods, i)) using (column(3)):5 with linespoints lw 1.5 pt mark(i) ps 1 lc rgb colour(i), \
     for [i=1:6] rows('pole_approach', 'unwatched', word(methods, i)) using (column(3)):5 with linespoints dt 2 pt mark(i) ps 1 lc rgb colour(i)
unset arrow 1
unset label 1
unset multiplot

set output file('pole_passages')
passage(form, method, eta) = sprintf("< awk -F, '$1==\"%s\" && $2==\"%s\" && $5==\"%s\" && $11==\"return\"' '%s/pole_passages.csv'", form, method, eta, ARG1)
set multiplot layout 1,2 title 'One return past a pole: solid in regularised time (tolerance 10^{-14}), dashed in plain time (10^{-12}) as far as it gets'
set xrange [1:1e-9] reverse
set yrange [1e-17:1e1]
set xlabel 's at the closest'
set ylabel 'error of the return'
do for [k=1:2] {
    eta = word('0.7 -0.7', k)
    set title (k == 1 ? 'forgets where it came from: condition 13' : 'its mirror image: condition up to 10^{13}') offset 0,-0.5
    if (k == 1) { set key top left reverse Left } else { unset key }
    plot for [i=1:6] passage('level', word(methods, i), eta) using (column(6)):9 with linespoints lw 1.5 pt mark(i) ps 1 lc rgb colour(i) title word(methods, i), \
         passage('level', 'batch', eta) using (column(6)):9 with points pt 6 lc rgb 'black' title 'batch', \
         for [i=1:6] passage('five_plain', word(methods, i), eta) using (column(6)):9 with linespoints dt 2 pt mark(i) ps 1 lc rgb colour(i) notitle, \
         passage('level', 'gauss', eta) using (column(6)):(column(7)*1.1e-16) with lines lc rgb 'black' dt 3 title 'condition times rounding'
}
unset title
unset multiplot

set output file('energy_drift')
orbits = 'regular chaotic saddle'
drift(orbit, form, method, tolerance) = sprintf("< cat '%s'/energy_drift*.csv | awk -F, '$1==\"%s\" && $2==\"%s\" && $3==\"%s\" && $4==\"%s\"' | sort -t, -k5,5g -u", ARG1, orbit, form, method, tolerance)
set multiplot layout 1,3 title 'Drift of E: solid at tolerance 10^{-12}, dashed at 10^{-14}'
set xrange [1:1e8] noreverse
set yrange [1e-16:1e3]
set xlabel 'returns'
set ylabel 'largest drift so far'
do for [k=1:3] {
    set title word(orbits, k) offset 0,-0.5
    if (k == 1) { set key top left reverse Left } else { unset key }
    plot for [i=1:6] drift(word(orbits, k), 'level', word(methods, i), '1e-12') using 5:6 with linespoints lw 1.5 pt mark(i) ps 1 lc rgb colour(i) title word(methods, i), \
         drift(word(orbits, k), 'level', 'batch', '1e-12') using 5:6 with lines lw 1 lc rgb 'black' title 'batch', \
         drift(word(orbits, k), 'level', 'batch projected', '1e-12') using 5:6 with lines lw 4 lc rgb 'black' title 'batch, projected', \
         drift(word(orbits, k), 'five', 'projected', '1e-12') using 5:6 with lines lw 4 lc rgb '#999999' title 'dop853, projected', \
         for [i=1:4] drift(word(orbits, k), 'level', word(methods, i), '1e-14') using 5:6 with linespoints dt 2 pt mark(i) ps 1 lc rgb colour(i) notitle
}
unset title
unset multiplot

set output file('reversal')
set multiplot layout 1,3 title 'There and back again, tolerance 10^{-14}: distance from the start'
set xrange [1:1000]
set yrange [1e-16:10]
set xlabel 'returns there, and as many back'
set ylabel 'defect in (η, γ_3)'
do for [k=1:3] {
    set title word(orbits, k) offset 0,-0.5
    if (k == 1) { set key top left reverse Left } else { unset key }
    plot for [i=1:4] rows('reversal', word(orbits, k), word(methods, i)) using 3:5 with linespoints lw 1.5 pt mark(i) ps 1 lc rgb colour(i) title word(methods, i), \
         rows('reversal', word(orbits, k), 'dop853') using 3:7 with lines lc rgb 'black' dt 3 title 'bound by DP'
}
unset title
unset multiplot

set output file('small_spin')
set title 'Eigenvalues at a fixed point (4.4) as ω_3 → 0, where zero becomes defective'
set key top left reverse Left
set xrange [1:1e-20] reverse
set yrange [1e-17:10]
set xlabel 'ω_3'
set ylabel 'error'
plot rows('small_spin', '0', '0') using (column(1)):4 with linespoints pt 7 ps 1 lc rgb '#d55e00' title 'QR: relative error of the small eigenvalue', \
     rows('small_spin', '0', '0') using (column(1)):(column(6) > 2*column(2)/-0.2 ? column(6) : NaN) with linespoints dt 2 pt 5 ps 1 lc rgb '#e69f00' title 'QR in turned axes: what should be zero, over the largest', \
     rows('small_spin', '0', '0') using (column(1)):(column(3) > 1e-17 ? column(3) : 1e-17) with linespoints dt 4 pt 9 ps 1 lc rgb '#0072b2' title 'deflated: relative error of the small eigenvalue; the zeros are exact'

set output file('grazing_grid')
set title 'The grazing grid: ten returns of 64 orbits, tolerances 10^{-12} and 10^{-14}, every method in every form'
forms = 'level five level_plain five_plain level_omega_n level_omega3'
set key outside right
set xrange [1000:30000] noreverse
set yrange [1e-14:1e3]
set format x '%g'
set xlabel 'evaluations of the field a return (taylor: not shown)'
set ylabel 'largest error'
plot for [f=1:6] for [i=1:6] rows('grazing_grid', word(forms, f), word(methods, i)) using 5:4 with points pt (f <= 2 ? 2*f+3 : 2*f) ps 1.2 lc rgb colour(f) title (i == 1 ? word(forms, f) : '')
set format x '10^{%T}'

set output file('separatrix_angle')
set title 'Angle of crossing separatrices: its error against the error bar that comes with it'
set key inside top left reverse Left
set xrange [1e-14:1e-7]
set yrange [1e-11:1e-3]
set xlabel 'tolerance'
set ylabel 'rad'
angles = system(sprintf("awk -F, 'NR>1 {print $1}' '%s/separatrix_angle.csv' | sort -u", ARG1))
plot for [i=1:words(angles)] rows('separatrix_angle', word(angles, i), '0') using 2:5 with linespoints pt mark(i) ps 1 lw 1.5 lc rgb colour(i) title 'error, crossing at η = '.word(angles, i), \
     for [i=1:words(angles)] rows('separatrix_angle', word(angles, i), '0') using 2:6 with linespoints dt 2 pt mark(i) ps 1 lc rgb colour(i) title (i == 1 ? 'error bars' : '')
