width = 1200; height = 1180
load '../style.gp'
set dashtype 2 (10,4)
set dashtype 3 (3,2.5)
set dashtype 4 (10,3,2,3)
array mu[4] = ['1', '1.5', '2', '3']
plane(c, n) = word('SDOF 2DOF', c).' mu='.mu[n].';'
name(c) = c == 1 ? 'one mass' : 'two masses, contact on 2, load on 1'
left(c) = 0.08 + 0.5 * (c - 1)
set style fill transparent solid 0.3 noborder
set xlabel 'frequency ratio r' offset 0, 0.6
set multiplot
set xrange [0:3]
set xtics 0.5
set tmargin at screen 0.96
set bmargin at screen 0.67
set ylabel 'friction ratio β' offset 0.5
do for [c = 1:2] {
    set lmargin at screen left(c)
    set rmargin at screen left(c) + 0.395
    set title sprintf('(%s)  %s', word('a b', c), name(c)) offset 0, -0.6
    set yrange [0:(c == 1 ? 1.1 : 1.3)]
    set ytics 0.2
    plot for [n=1:4] data index plane(c, n) using 1:5:2 with filledcurves below fc rgb '#888888', \
         for [n=1:4] data index plane(c, n) using 1:5 with lines lt n dt n lw 1.2, \
         for [n=1:4] data index plane(c, n) using 1:2 with lines lt n dt n lw 2.4, \
         for [n=1:4] data index 'numerical '.plane(c, n) using 1:2 with points lt n pt 1 ps 0.9 lw 1.2, \
         for [n=1:4] data index 'numerical '.plane(c, n) using 1:3 with points lt n pt 6 ps 0.8 lw 1.2, \
         for [n=1:4] data index 'numerical '.plane(c, n) using 1:4 with points lt n pt 4 ps 0.6 lw 1.2
}
set tmargin at screen 0.565
set bmargin at screen 0.245
set ylabel 'friction ratio β' offset 0.5
set logscale xy
set xrange [0.02:30]
set xtics ('0.02' 0.02, '0.05' 0.05, '0.1' 0.1, '0.2' 0.2, '0.5' 0.5, '1' 1, '2' 2, '5' 5, '10' 10, '30' 30)
set ytics 10 format '10^{%T}'
do for [c = 1:2] {
    set lmargin at screen left(c)
    set rmargin at screen left(c) + 0.395
    set title sprintf('(%s)  %s, logarithmic', word('c d', c), name(c)) offset 0, -0.6
    set yrange [5e-5:(c == 1 ? 2 : 6)]
    plot for [n=1:4] data index 'wide '.plane(c, n) using 1:5 with lines lt n dt n lw 1.2, \
         for [n=1:4] data index 'wide '.plane(c, n) using 1:2 with lines lt n dt n lw 2.4, \
         for [n=1:4] data index 'limits '.plane(c, n) using 1:2 with lines lt 7 lw 0.8, \
         for [n=1:4] data index 'limits '.plane(1, n) using 1:(c == 1 ? $3 : NaN) with lines lt 7 lw 0.8
}
# the keys, below the panels
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 0.18
set bmargin at screen 0.005
unset logscale
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset grid
set yrange [0:1]
set key at screen 0.5, 0.185 center top horizontal samplen 4 width 2 Left reverse
plot for [n = 1:4] NaN with lines lt n dt n lw 2.4 title 'μ = '.mu[n].', (69)'
set key at screen 0.5, 0.15
plot for [n = 1:4] NaN with lines lt n dt n lw 1.2 title 'μ = '.mu[n].', (88)'
set key at screen 0.5, 0.115 samplen 2.5
plot NaN with lines lt 7 lw 0.8 title 'limits r → 0 and (86)', \
     NaN with filledcurves fc rgb '#888888' title 'below (69) and above (88)'
set key at screen 0.5, 0.08 maxrows 1
plot NaN with points lt 7 pt 1 ps 0.9 title 'numerical, from the closed form', \
     NaN with points lt 7 pt 6 ps 0.8 title 'from rest', NaN with points lt 7 pt 4 ps 0.6 title 'from the stuck motion'
unset multiplot
