# usage: gnuplot -c figure3.gp DIR OUT.png: the picture of tools/scenes/figure3. Letters are large enough for a column of 8 cm.
set terminal pngcairo size 1600,860 font 'DejaVu Sans,31' lw 2
set output ARG2
file(name) = ARG1.'/'.name.'.txt'
set encoding utf8
set border lw 0.8
set tics scale 0.6 front
set xlabel 'η' offset 0,0.6
set multiplot layout 1,2 margins 0.08,0.985,0.145,0.90 spacing 0.105

set title '(a)  Poincaré map of (5.1)' offset 0,-0.5
set label 1 'γ₃' at graph -0.03,0.95 right
set xrange [-pi:pi]
set yrange [-1:0.2]
set xtics ('−π' -pi, '0' 0, 'π' pi)
set ytics 0.5
set key at graph 0.985,0.97 samplen 0.6 spacing 1 box lw 0.5 opaque font ',26'
set object 1 rectangle from -0.6,-0.72 to 0.6,-0.5 fillstyle empty border lc rgb 'black' lw 1.2 front
plot file('fig3a_ends') with points pt 7 ps 0.5 lc rgb '#c8864a' notitle, \
     file('fig3a_lives') with points pt 7 ps 0.12 lc rgb 'black' notitle, \
     keyentry with points pt 7 ps 1.4 lc rgb '#c8864a' title 'ends at a pole', \
     keyentry with points pt 7 ps 1.4 lc rgb 'black' title 'lives on'
unset object 1

set title '(b)  separatrices of the saddle' offset 0,-0.5
set label 1 at graph -0.03,0.77
set xrange [-0.6:0.6]
set yrange [-0.72:-0.5]
set xtics 0.5
set ytics 0.1
plot file('fig3a_island') with points pt 7 ps 0.12 lc rgb '#c4c4c4' notitle, \
     file('fig3b_stable') with lines lw 1.1 lc rgb '#0072b2' notitle, \
     file('fig3b_unstable') with lines lw 1.1 lc rgb '#d55e00' notitle, \
     keyentry with lines lw 3 lc rgb '#d55e00' title 'unstable', \
     keyentry with lines lw 3 lc rgb '#0072b2' title 'stable'
unset multiplot
