# Figs. 6, 8 and 9: a damping ratio a column, amplitude above and phase below. A script sets before it loads this:
# betas, last_r, X and phase (labels), column_X and column_phase (of the lines while the contact slides), least_phase,
# largest_phase, step_phase, sliding(z) (how many of the friction ratios slide anywhere), stuck (1 with the stuck
# configuration), name_points (of the invariant points, empty without), damping(z) (the title of a column), some (one marker in
# how many is drawn), direct (1 with the friction ratios written at the ends of the lines), inset (1 with the peak of the first
# column enlarged), note (what is to be said of its markers on the right).
width = 1240; height = 980
load 'style.gp'
zetas = '0.001 0.01 0.1'
degrees = 180 / pi
line(z, b) = sprintf('zeta=%s beta=%s;', word(zetas, z), b)
marks(z, b) = sprintf('markers zeta=%s beta=%s;', word(zetas, z), b)
edge(z) = sprintf('boundary zeta=%s;', word(zetas, z))
held(z) = sprintf('stuck zeta=%s;', word(zetas, z))
dotted = 'with lines lt 7 lw 2.2 dt (2, 3)'
star = 'with points lt 7 pt 3 ps 1.3 lc rgb (c == 3 ? "#AAAAAA" : "#000000")'
star_key = 'with points lt 7 pt 3 ps 1.3'
at_end(r) = abs(r - last_r) < 1e-9 ? r : NaN
at_ends(column, shift) = sprintf("using (at_end($1)):%s:(word(betas, b)) with labels left offset 0.4, %s", column, shift)
direct_X = direct ? ', for [b = 3:4] data index line(c, word(betas, b)) '.at_ends('column_X', '0').\
                    ', for [b = 4:5] data index line(c, word(betas, b)) '.at_ends('3', '0') : ''
direct_phase = direct ? ', for [b = 1:sliding(c)] data index line(c, word(betas, b)) '.\
                        at_ends('(column(column_phase) * degrees)', '(b == 1 ? 0.4 : b == 2 ? -0.2 : 0)') : ''
stuck_X = stuck ? ', data index held(c) using 1:2 '.dotted : ''
stuck_phase = stuck ? ', data index held(c) using 1:($3 * degrees) '.dotted : ''
stuck_key = stuck ? ', NaN '.dotted." title 'stuck configuration'" : ''
points_X = name_points eq '' ? '' : ", data index 'invariant points;' using 1:2 ".star
points_key = name_points eq '' ? '' : ', NaN '.star_key.' title name_points'
set multiplot
set xrange [0:last_r]
set xtics 0.5
left(c) = 0.075 + 0.308 * (c - 1)
do for [c = 1:3] {
    set lmargin at screen left(c)
    set rmargin at screen left(c) + 0.27
    set tmargin at screen 0.96
    set bmargin at screen 0.53
    set logscale y
    set yrange [0.02:1000]
    set ytics format (c == 1 || alone ? '10^{%T}' : '')
    set xtics format (alone ? '%g' : '')
    set xlabel (alone ? 'frequency ratio r' : '')
    set ylabel (c == 1 || alone ? 'transmissibility '.X : '') offset 1, 0
    set title sprintf('(%s)  %s', word('a b c', c), damping(word(zetas, c))) offset 0, -0.6
    if (c == 1 && note ne '') {
        set label 9 note at last_r - 0.04, 0.12 right textcolor rgb '#333333'
        set arrow 9 from last_r - 0.45, 0.15 to last_r - 0.45, 0.32 lw 1 lc rgb '#333333' size screen 0.006, 20 filled
    }
    plot data index edge(c) using 1:2 with lines lw 5 lc rgb '#BBBBBB', \
         data index line(c, '0') using 1:column_X with lines lt 7 lw 1, \
         for [b = 1:sliding(c)] data index line(c, word(betas, b)) using 1:column_X with lines lt b, \
         for [b = 1:5] data index line(c, word(betas, b)) using 1:3 with lines lt b lw 1 dt (9, 5), \
         for [b = 1:5] data index marks(c, word(betas, b)) using 1:2 every some with points lt b @stuck_X @points_X @direct_X
    unset label 9
    unset arrow 9
    unset logscale y
    set tmargin at screen 0.49
    set bmargin at screen 0.235
    set yrange [least_phase:largest_phase]
    set ytics step_phase format (c == 1 || alone ? '%g' : '')
    set xtics format '%g'
    set xlabel 'frequency ratio r'
    set ylabel (c == 1 || alone ? 'phase '.phase.' in degrees' : '') offset 1, 0
    set title sprintf('(%s)', word('d e f', c)) offset 0, -0.9
    plot data index edge(c) using 1:($3 * degrees) with lines lw 5 lc rgb '#BBBBBB', \
         data index line(c, '0') using 1:(column(column_phase) * degrees) with lines lt 7 lw 1, \
         for [b = 1:sliding(c)] data index line(c, word(betas, b)) using 1:(column(column_phase) * degrees) with lines lt b, \
         for [b = 1:sliding(c)] data index marks(c, word(betas, b)) using 1:($3 * degrees) every some with points lt b @stuck_phase @direct_phase
    set ytics autofreq
}
if (inset) {
    set lmargin at screen left(1) + 0.175
    set rmargin at screen left(1) + 0.265
    set tmargin at screen 0.95
    set bmargin at screen 0.77
    unset title; unset xlabel; unset ylabel
    set xrange [0.99:1.01]
    set xtics ('0.99' 0.99, '1' 1, '1.01' 1.01) offset 0, 0.3
    set yrange [0:500]
    set ytics 250 format '%g' offset 0.4, 0
    set border 15
    plot data index line(1, '0') using 1:column_X with lines lt 7 lw 1, \
         for [b = 1:sliding(1)] data index line(1, word(betas, b)) using 1:column_X with lines lt b
}
# the keys, below the panels
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 0.1
set bmargin at screen 0.005
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset grid
set yrange [0:1]
set key at screen 0.5, 0.15 center top horizontal samplen 2.5 width 1 Left reverse
plot NaN with lines lt 7 lw 1 title 'β = 0', \
     for [b = 1:5] NaN with linespoints lt b title sprintf('β = %s', word(betas, b))
set key at screen 0.5, 0.115 width -5
plot NaN with lines lt 7 title 'closed form', \
     NaN with lines lt 7 lw 1 dt (9, 5) title 'exact solver, stick-slip', \
     NaN with points lt 7 pt 6 title 'numerical', \
     NaN with lines lw 5 lc rgb '#BBBBBB' title 'boundary of continuous motion' @stuck_key @points_key
unset multiplot
