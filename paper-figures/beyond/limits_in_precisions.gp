width = 1250; height = 1400
load '../style.gp'
unset key
set multiplot layout 4, 3 margins 0.07, 0.985, 0.13, 0.945 spacing 0.03, 0.1
names = 'undamped resonance third low high critical'
ends = '"ζ = x → 0, R = 3/4" "ζ = x → 0, R = 1" "R = (1 + x)/3, ζ = x → 0" "R = x → 0, ζ = 0.1" '.\
       '"R = 1/x → ∞, ζ = 0.01" "ζ = 1 − x → 1, R = 3/4"'
types = 'double long 50'
words = '"double" "long double" "50 digits"'
functions = 'u g'
set xrange [-41:0]
set xtics ('' -40, '10^{−30}' -30, '' -20, '10^{−10}' -10, '' 0)
set yrange [-1:54]
set ytics 10
panel = 0
do for [row = 1:2] {
    f = word(functions, row)
    do for [place = 1:6] {
        panel = panel + 1
        name = word(names, place)
        set title sprintf("(%s)  %s\n%s", substr('abcdefghijkl', panel, panel), f, word(ends, place)) offset 0, -0.7
        if (place % 3 == 1) { set ylabel 'decimal digits' offset 1.2; set format y '%g' } else { set ylabel; set format y '' }
        if (row == 2 && place > 3) { set xlabel 'x' offset 0, 0.4 }
        plot for [t = 1:3] data index name.' '.word(types, t).';' using (log10($1)):(column(3 + row)) with lines lt t lw 2.4, \
         for [t = 1:3] '' index name.' '.word(types, t).';' using (log10($1)):(column(1 + row)) with lines lt t lw 1.6 dt (5,4)
    }
}
# the key, below the panels
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 0.08
set bmargin at screen 0
unset title; unset xlabel; unset ylabel; unset border; unset xtics; unset ytics; unset grid
set key at screen 0.5, 0.065 center top horizontal maxrows 2 Left reverse
plot for [t = 1:3] NaN with lines lt t lw 2.4 title word(words, t).', shipped', \
     for [t = 1:3] NaN with lines lt t lw 1.6 dt (5,4) title word(words, t).', printed'
unset multiplot
