# SPDX-License-Identifier: MIT
# gnuplot -e "dir='OUT_DIR'" plots.gp: the pictures of the demo from the tables it wrote.
set datafile separator ","
set terminal svg size 900,480 font "sans-serif,14" background "white"
set grid lc rgb "#dddddd"
set key left top
set xlabel "time, s"

set output dir."/energy.svg"
set title "Energy error: kinetic energy over its initial value, minus one"
set ylabel "relative energy change"
set format y "%.0e"
set logscale x
set xrange [0.01:*]
plot dir."/satellite_energy.csv" using 1:2 with lines lw 2 title "satellite", \
     dir."/t_handle_energy.csv" using 1:2 with lines lw 2 title "t\\_handle", \
     dir."/tumblers_energy.csv" using 1:2 with lines lw 2 title "tumblers (64 balls, elastic)"
unset logscale x
set xrange [*:*]
set format y "%g"

set output dir."/t_handle_flip.svg"
set title "The T-handle flips: spin about its middle axis"
set ylabel "omega, rad/s"
set key left bottom
plot dir."/t_handle_flip.csv" using 1:3 with lines lw 5 lc rgb "#bbccee" title "Euler's equations, extended precision", \
     dir."/t_handle_flip.csv" using 1:2 with lines lw 1.5 lc rgb "#aa2222" title "ingot, 60 Hz"

set output dir."/drop_heights.svg"
set title "Dropped: height of the centre of mass"
set ylabel "height, m"
set key right top
set xrange [0:6]
plot for [column=2:7] dir."/drop_heights.csv" using 1:column with lines lw 2 title word("flat edge corner askew ball,e=0.5 ball,e=0.9", column - 1)
