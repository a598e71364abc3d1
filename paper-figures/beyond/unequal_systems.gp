width = 1240; height = 1240
load '../style.gp'
set dashtype 2 (3,2.5)
chains = 'before after on'
betas = '0.1 0.3 0.6'
array words[3] = ['γ = 1, 0.4, 1;  κ = 1, 1, 1;  j = 2, l = 1', 'γ = 1, 4, 1;  κ = 1, 2, 2;  j = 2, l = 3', \
                  'γ = 1, 1, 1;  κ = 1, ¼, ¼;  j = l = 1']
array contact[3] = ['X̄₂, contact', 'X̄₂, contact', 'X̄₁, contact']
array other[3] = ['X̄₁', 'X̄₃', 'X̄₃']
line(c, of, b) = sprintf('%s %s beta=%s;', word(chains, c), of, b)
left(c) = 0.08 + 0.315 * (c - 1)
set multiplot
set xrange [0:3]
set xtics 0.5
do for [c = 1:3] {
    set lmargin at screen left(c)
    set rmargin at screen left(c) + 0.24
    do for [row = 1:2] {
        of = word('contact other', row)
        set tmargin at screen (row == 1 ? 0.97 : 0.695)
        set bmargin at screen (row == 1 ? 0.745 : 0.47)
        set title (row == 1 ? sprintf('(%s)  %s', word('a b c', c), words[c]) : sprintf('(%s)', word('d e f', c))) offset 0, -0.6
        set ylabel (row == 1 ? contact[c] : other[c]) offset 1
        set logscale y
        set yrange [0.002:30]
        set ytics 10 format '10^{%T}'
        set xtics format (alone ? '%g' : '')
        if (alone) { set xlabel 'frequency ratio r' }
        plot data index line(c, of, '0') using 1:2 with lines lt 7 lw 1, \
             for [b = 1:3] data index line(c, of, word(betas, b)) using 1:4 with lines lt b lw 1.2 dt (2,3), \
             for [b = 1:3] data index line(c, of, word(betas, b)) using 1:3 with lines lt b lw 1.2 dt (9,5), \
             for [b = 1:3] data index line(c, of, word(betas, b)) using 1:2 with lines lt b, \
             for [b = 1:3] data index 'markers '.line(c, of, word(betas, b)) using 1:2 with points lt b
    }
    set tmargin at screen 0.42
    set bmargin at screen 0.195
    set title sprintf('(%s)', word('g h i', c)) offset 0, -0.6
    set xtics format '%g'
    set xlabel 'frequency ratio r' offset 0, 0.6
    set ylabel (c == 1 || alone ? 'friction ratio β' : '')
    set yrange [0.001:60]
    set label 1 'permanent sticking' at 2.95, 28 right
    if (c == 1) { set label 2 'stick-slip' at 0.1, 2.6 }
    set label 3 'continuous' at 1.6, 0.02
    plot for [b = 1:3] word(betas, b) + 0 with lines lt b lw 0.8 dt 2, \
         data index 'printed '.word(chains, c).';' using 1:2 with lines lt 4 lw 4, \
         data index word(chains, c).' mu=1;' using 1:2 with lines lt 7, \
         '' index word(chains, c).' mu=1;' using 1:5 with lines lt 7 lw 1.4 dt (8,4), \
         data index 'numerical '.word(chains, c).' mu=1;' using 1:3 with points lt 7 pt 6 ps 0.8, \
         '' index 'numerical '.word(chains, c).' mu=1;' using 1:4 with points lt 7 pt 4 ps 0.7
    set xlabel
    unset label
}
# the keys, below the panels
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 0.13
set bmargin at screen 0.005
unset logscale
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset grid
set yrange [0:1]
set key at screen 0.5, 0.14 center top horizontal samplen 3 width 1 Left reverse
plot NaN with lines lt 7 lw 1 title 'β = 0', for [b = 1:3] NaN with linespoints lt b title 'β = '.word(betas, b), \
     NaN with points lt 7 pt 6 title 'numerical'
set key at screen 0.5, 0.112
plot NaN with lines lt 7 title 'contact slides, closed form', \
     NaN with lines lt 7 lw 1.2 dt (9,5) title 'stick-slip, exact solver', \
     NaN with lines lt 7 lw 1.2 dt (2,3) title 'contact rests'
set key at screen 0.5, 0.06
plot NaN with linespoints lt 7 pt 6 ps 0.8 title '(69), end of sliding', \
     NaN with linespoints lt 7 dt (8,4) pt 4 ps 0.7 title 'start of permanent sticking', \
     NaN with lines lt 4 lw 4 title '(88) as printed'
unset multiplot
