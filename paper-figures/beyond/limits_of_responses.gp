# Digits against what falls to zero, or the number of masses; (e) the difference from the limit on both sides of the boundary.
width = 1240; height = 980
load '../style.gp'
unset key
set multiplot layout 2, 3 margins 0.075, 0.985, 0.235, 0.95 spacing 0.085, 0.14
names = 'merging heavy light resonance'
ends = '"γ_2 = κ_2 = x → 0: they merge" "γ_2 = 1/x → ∞: a heavy mass" "γ_2 = x → 0: a light mass" '.\
       '"r = 1, ζ = x → 0, β = (π/4)(1 − 2x)"'
types = 'float double "long double" "50 digits"'
set logscale x
unset mxtics
unset mytics
do for [panel = 1:4] {
    set title sprintf('(%s)  %s', substr('abcd', panel, panel), word(ends, panel)) offset 0, -0.6
    set xlabel 'x' offset 0, 0.4
    set ylabel (panel == 1 || panel == 4 ? 'decimal digits of X̄_j' : '') offset 1.2
    set xrange [(panel < 3 ? 1e-31 : panel == 3 ? 1e-18 : 1e-9):1]
    set format x '10^{%T}'
    step = panel < 3 ? 1e8 : panel == 3 ? 1e4 : 100
    set xtics step
    set yrange [-1:54]
    set ytics 10
    plot for [t = 1:4] data index word(names, panel).';' using 1:(column(5 + t)) with lines lt t lw 2.4, \
         for [t = 1:4] '' index word(names, panel).';' using 1:(column(1 + t)) with lines lt t lw 1.6 dt (5,4), \
         '' index word(names, panel).';' using 1:10 with points pt 6 ps 0.8 lc rgb '#000000'
}
set title '(e)  X̄ less its limit, β = β_{lim}(1 ∓ x)' offset 0, -0.6
unset ylabel
set xlabel 'x'
set xrange [1e-20:1]
set xtics 1e4
set logscale y
set yrange [1e-20:1]
set ytics 1e4
set format y '10^{%T}'
plot for [t = 1:4] data index 'boundary;' using 1:(column(3 + t)) with lines lt t lw 1.6 dt (5,4), \
     '' index 'boundary;' using 1:2 with points pt 10 ps 1 lc rgb '#000000', \
     '' index 'boundary;' using 1:3 with points pt 8 ps 1 lc rgb '#000000'
unset logscale y
set format y '%g'
set title '(f)  N masses, l = 1, j = N, r = 3, β = 0' offset -2, -0.6
set ylabel 'decimal digits of X̄_j' offset 0.2
set xlabel 'N'
set xrange [2:200]
set format x '%g'
set xtics (2, 5, 10, 20, 50, 100, 200)
set yrange [-1:54]
set ytics 10
plot for [t = 1:4] data index 'chain;' using 1:(column(5 + t)) with lines lt t lw 2.4, \
     for [t = 1:4] '' index 'chain;' using 1:(column(1 + t)) with lines lt t lw 1.6 dt (5,4)
# the key, below the panels
unset logscale
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 0.15
set bmargin at screen 0
unset title; unset xlabel; unset ylabel; unset border; unset xtics; unset ytics; unset grid
set xrange [0:1]
set yrange [0:1]
set key at screen 0.5, 0.15 center top horizontal maxrows 6 Left reverse
plot for [t = 1:4] NaN with lines lt t lw 2.4 title word(types, t).', shipped', \
     for [t = 1:4] NaN with lines lt t lw 1.6 dt (5,4) title word(types, t).', printed', \
     NaN with points pt 6 lc rgb '#000000' title '`answer`, 12 digits asked for', \
     NaN with points pt 10 lc rgb '#000000' title '(e) below β_{lim}, `solve`: sliding', \
     NaN with points pt 8 lc rgb '#000000' title '(e) above: stick-slip'
unset multiplot
