# Microseconds of an answer against its digits, a panel a scene; what failed anywhere stands left of zero, by kind, and in small
# at the digits that it had where it was right. Grey: condition times eps of double, and one exp, sin and cos a mode.
width = 1500; height = 1300
type = 14
load '../../style.gp'
names = int(system("grep -c '^# name ' ".data))
titles = int(system("grep -c '^# title ' ".data))
entry(what, n) = system(sprintf("sed -n 's/^# %s %d //p' %s", what, n, data))
array digits[titles]
array bare[titles]
do for [s = 1:titles] {
    stats data index sprintf('limits scene=%d;', s) using 1 nooutput
    digits[s] = STATS_min
    stats data index sprintf('limits scene=%d;', s) using 2 nooutput
    bare[s] = STATS_min
}
grey = '#999999'
band = '#F2E6E6'
faint = '#886666'
array mark[13] = [7, 6, 4, 8, 12, 10, 2, 1, 3, 5, 9, 11, 13]
do for [m = 1:names] {
    wide = entry('name', m) eq 'solve' ? 3.5 : 1.2
    set style line m lc rgb colour[1 + (m - 1) % 7] pt mark[1 + m % 13] lw wide ps 0.8
}
set multiplot layout 3, 2 margins 0.06, 0.985, 0.05, 0.965 spacing 0.07, 0.075
set logscale y
set format y '10^{%L}'
set yrange [1e-2:1e8]
set xrange [-5.7:36.5]
set xtics 0, 4
set label 11 'did not finish' at first -1, graph 0.02 left rotate font ',9' textcolor rgb faint
do for [k = 2:5] {
    set label 10 + k word('- stalled "wrong regime" "not a number" "outside its domain"', k) \
        at first -k, graph 0.99 right rotate font ',9' textcolor rgb faint
}
set ylabel 'microseconds a point' offset 1
set xlabel 'digits at the worst point' offset 0, 0.4
do for [s = 1:titles] {
    set title entry('title', s) offset 0, -0.6
    set object 1 rectangle from graph 0, 0 to first -0.4, graph 1 fillcolor rgb band fillstyle solid noborder behind
    set arrow 1 from first digits[s], graph 0 to first digits[s], graph 1 nohead lc rgb grey lw 2 back
    set arrow 2 from first -0.4, first bare[s] to graph 1, first bare[s] nohead lc rgb grey lw 2 back
    plot for [m = 1:names] data index sprintf('scene=%d; method=%d;', s, m) using ($6 >= 1 ? $1 : NaN):3 \
             with linespoints ls m, \
         for [m = 1:names] '' index sprintf('scene=%d; method=%d;', s, m) using ($6 < 1 || $1 < 0 ? $1 : NaN):3 \
             with points ls m ps 0.4, \
         for [m = 1:names] for [k = 1:5] '' index sprintf('scene=%d; method=%d;', s, m) using (column(6 + k) > 0 ? -k : NaN):3 \
             with points ls m ps 0.7
}
unset object; unset arrow; unset label; unset title; unset xlabel; unset ylabel; unset xtics; unset ytics; unset border; unset grid
set key center center font ',11' samplen 3 maxrows 20
plot for [m = 1:names] NaN with linespoints ls m title entry('name', m), \
     NaN with lines lc rgb grey lw 2 title 'condition times eps; exp, sin and cos a mode'
unset multiplot
