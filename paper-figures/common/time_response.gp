# Figs. 4 and 5: two panels, five masses each. Masses differ in colour and in the dashes of the line; all markers are round.
set dashtype 1 solid
set dashtype 2 (14,3)
set dashtype 3 (7,3)
set dashtype 4 (3,2.5)
set dashtype 5 (12,3,2,3)
set multiplot layout 1,2 margins 0.085, 0.985, 0.165, 0.8 spacing 0.09
set xrange [0:2]
set xtics ('0' 0, 'π/2' 0.5, 'π' 1, '3π/2' 1.5, '2π' 2)
set xlabel 'τ, from the maximum of the force'
set ylabel 'x̄ₖ' offset 1
set xzeroaxis lc rgb '#888888'
set key at screen 0.05, 0.985 left top horizontal maxrows 1 samplen 3.5 width 2 reverse Left
set title '(a) ζᵢ = 0.01' offset 0, -0.4
plot for [k=1:5] data index 'lines a;' using 1:(column(k + 1)) with lines lt k dt k title sprintf('m_%d', k), \
     for [k=1:5] data index 'markers a;' using 1:(column(k + 1)) with points lt k pt 6 ps 0.7 lw 1.2, \
     NaN with points lt 7 pt 6 ps 0.7 lw 1.2 title 'numerical'
set title '(b) ζᵢ = 0.1'
plot for [k=1:5] data index 'lines b;' using 1:(column(k + 1)) with lines lt k dt k, \
     for [k=1:5] data index 'markers b;' using 1:(column(k + 1)) with points lt k pt 6 ps 0.7 lw 1.2
unset multiplot
