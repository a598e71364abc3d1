# Honesty: the error got against the tolerance asked for, at the worst point of every scene where the answer was right.
width = 1500; height = 1300
type = 14
load '../../style.gp'
names = int(system("grep -c '^# name ' ".data))
titles = int(system("grep -c '^# title ' ".data))
entry(what, n) = system(sprintf("sed -n 's/^# %s %d //p' %s", what, n, data))
grey = '#999999'
array mark[13] = [7, 6, 4, 8, 12, 10, 2, 1, 3, 5, 9, 11, 13]
do for [m = 1:names] {
    wide = entry('name', m) eq 'solve' ? 3.5 : 1.2
    set style line m lc rgb colour[1 + (m - 1) % 7] pt mark[1 + m % 13] lw wide ps 0.8
}
set multiplot layout 3, 2 margins 0.06, 0.985, 0.05, 0.965 spacing 0.07, 0.075
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xrange [0.1:1e-31]
set yrange [1e-36:10]
set xtics 1e-28, 1e4, 1
set ytics 1e4
set ylabel 'error got' offset 1
set xlabel 'tolerance asked for' offset 0, 0.4
do for [s = 1:titles] {
    set title entry('title', s) offset 0, -0.6
    plot x with lines lc rgb grey lw 2, \
         for [m = 1:names] data index sprintf('scene=%d; method=%d;', s, m) using ($5 > 0 && $6 >= 1 ? $5 : NaN):(10**(-$1)) \
             with linespoints ls m, \
         for [m = 1:names] '' index sprintf('scene=%d; method=%d;', s, m) \
             using ($5 > 0 && ($6 < 1 || $1 < 0) ? $5 : NaN):(10**(-$1)) \
             with points ls m ps 0.4
}
unset title; unset xlabel; unset ylabel; unset xtics; unset ytics; unset border; unset grid
set key center center font ',11' samplen 3 maxrows 20
plot for [m = 1:names] NaN with linespoints ls m title entry('name', m), \
     NaN with lines lc rgb grey lw 2 title 'error as asked for'
unset multiplot
