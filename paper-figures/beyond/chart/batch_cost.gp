# Cost of a batch against the number of modes, of frequency ratios, of points (r, beta). Reads batch_cost.csv, which
# `speed-accuracy batch --output FOLDER` writes into the folder of the pictures; without it the picture says so.
width = 1240; height = 480
type = 14
load '../../style.gp'
csv = folder.'/batch_cost.csv'
if (system("test -f '".csv."' && echo yes") ne 'yes') {
    unset border; unset tics
    set label 1 'not measured: speed-accuracy batch --output FOLDER writes batch\_cost.csv' at screen 0.5, 0.5 center
    plot [0:1] [0:1] NaN
    exit
}
series(name) = sprintf("<grep '^\"%s\"' '%s'", name, csv)
set datafile separator ','
set multiplot layout 1, 3 margins 0.06, 0.985, 0.14, 0.9 spacing 0.06, 0
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set ylabel 'milliseconds' offset 1
set key top left
set title '(a)  2000 frequency ratios' offset 0, -0.6
set xlabel 'modes N'
plot series('modes') using 2:($6 * 1e-6) with linespoints lt 1 title 'modes and sums', \
     '' using 2:(2000 * $2 * 7.5e-6) with lines lt 7 dt (8,4) lw 1 title '7.5 ns an (r, mode)'
unset ylabel
set title '(b)  five masses' offset 0, -0.6
set xlabel 'frequency ratios'
plot series('frequency ratios') using 3:($6 * 1e-6) with linespoints lt 1 title 'modes and sums', \
     '' using 3:(5 * $3 * 7.5e-6) with lines lt 7 dt (8,4) lw 1 title '7.5 ns an (r, mode)'
set title '(c)  amplitude and regime over a grid' offset 0, -0.6
set xlabel 'points (r, β)'
plot series('points') using 7:($6 * 1e-6) with linespoints lt 1 title 'one core', \
     series('points on all cores') using 7:($6 * 1e-6) with linespoints lt 2 title 'all cores', \
     series('points') using 7:($7 * 1e-6) with lines lt 7 dt (8,4) lw 1 title '1 ns a point'
unset multiplot
