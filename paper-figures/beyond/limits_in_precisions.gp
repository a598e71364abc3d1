width = 1000; height = 820
load '../style.gp'
unset key
set multiplot layout 2, 2 margins 0.085, 0.985, 0.2, 0.92 spacing 0.04, 0.14
# The four ways to the ends of the domain on which the printed forms lose digits: function, name of the data, and the way.
functions = 'u u g g'
names = 'resonance third resonance high'
ends = '"ζ = x → 0, R = 1" "R = (1 + x)/3, ζ = x → 0" "ζ = x → 0, R = 1" "R = 1/x → ∞, ζ = 0.01"'
types = 'double long 50'
words = '"double" "long double" "50 digits"'
set xrange [-41:0]
set xtics ('10^{−40}' -40, '10^{−30}' -30, '10^{−20}' -20, '10^{−10}' -10, '1' 0)
set yrange [-1:54]
set ytics 10
do for [panel = 1:4] {
    f = word(functions, panel)
    row = f eq 'u' ? 1 : 2
    name = word(names, panel)
    set title sprintf("(%s)  %s, %s", substr('abcd', panel, panel), f, word(ends, panel)) offset 0, -0.7
    if (panel % 2 == 1 || alone) { set ylabel 'decimal digits' offset 0.5; set format y '%g' } else { set ylabel; set format y '' }
    if (panel > 2 || alone) { set xlabel 'x' offset 0, 0.4 }
    plot for [t = 1:3] data index name.' '.word(types, t).';' using (log10($1)):(column(3 + row)) with lines lt t lw 2.4, \
     for [t = 1:3] '' index name.' '.word(types, t).';' using (log10($1)):(column(1 + row)) with lines lt t lw 1.6 dt (5,4)
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
