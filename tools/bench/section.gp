# usage: gnuplot -c section.gp TABLE.csv PICTURE.svg: error against time a return, a curve for each program, method and form.
set terminal svg size 1100,800 font 'sans,12'
set output ARG2
set datafile separator ','
set logscale xy
set format x '10^{%T}'
set xlabel 'largest error over the first ten returns of all orbits'
set ylabel 'time per return [µs]: median, least and largest'
set key outside right noenhanced
set title 'Section map of the spherical top at (5.1)' noenhanced
plot for [i = 1:words(system(sprintf("grep -v '^#' '%s' | tail -n +2 | cut -d, -f1-4 | tr ' ' '~' | awk '!seen[$0]++'", ARG1)))] \
    sprintf("< grep -F \"$(grep -v '^#' '%s' | tail -n +2 | cut -d, -f1-4 | awk '!seen[$0]++' | sed -n %dp),\" '%s'", ARG1, i, ARG1) \
    using 6:(1e6/$7):(1e6/$9):(1e6/$8) with yerrorlines ps 0.4 \
    title system(sprintf("grep -v '^#' '%s' | tail -n +2 | cut -d, -f2-4 | awk '!seen[$0]++' | sed -n %dp", ARG1, i))
