width = 1250; height = 920
load '../style.gp'
set multiplot layout 2, 3 margins 0.075, 0.985, 0.095, 0.83 spacing 0.085, 0.15
set key at screen 0.05, 0.995 left top Left reverse maxrows 3 width 1
set logscale x
set xrange [1e-15:1]
set format x '10^{%L}'
set xtics 1e3
set xlabel 'x' offset 0, 0.3
names = '"R=1" "p=1/2" "p=1" "p=2" "p=3" "zeta=0" "p=1/2 below"'
labels = '"R = 1, ζ = x" "R = 1 + x, ζ = x^{1/2}" "R = 1 + x, ζ = x" "R = 1 + x, ζ = x²" '.\
         '"R = 1 + x, ζ = x³" "R = 1 + x, ζ = 0" "R = 1 − x, ζ = x^{1/2}"'
array widths[7] = [1.8, 1.8, 1.8, 4.5, 2.2, 1.2, 3]
array colours[7] = [7, 1, 2, 6, 3, 7, 1]
array dashes[7] = [1, 1, 1, 1, 2, 3, 3]
set logscale y
set format y '10^{%L}'
set ytics 1e3
set ylabel '|v|' offset 1
set label 1 '(a)  complex response' at graph 0.03, 1.05
plot for [n = 1:7] data index word(names, n).';' using 1:2 with lines lt colours[n] lw widths[n] dt dashes[n] \
    title word(labels, n)
unset key
set ylabel '|u|'
set label 1 '(b)  first damping function'
plot for [n = 1:7] data index word(names, n).';' using 1:3 with lines lt colours[n] lw widths[n] dt dashes[n]
set ylabel 'g'
set yrange [1e-6:*]
set label 1 '(c)  second damping function'
plot for [n = 1:7] data index word(names, n).';' using 1:4 with lines lt colours[n] lw widths[n] dt dashes[n]
unset logscale
set format
set xtics autofreq
set ytics autofreq
set xrange [-2:2]
set yrange [*:*]
set xlabel 't'
set ylabel 'u'
set key default
set key noautotitle spacing 1.15 samplen 2.2 bottom right
set xzeroaxis lc rgb '#888888'
set label 1 '(d)  R = 1 + t ζ²'
plot data index 'beside;' using 1:4 with lines lt 7 title 'ζ → 0', \
     '' index 'beside;' using 1:3 with lines lt 1 dt '-' title 'ζ = 0.1', \
     '' index 'beside;' using 1:2 with lines lt 2 dt '.' lw 2.4 title 'ζ = 0.3'
unset xzeroaxis
set logscale x
set xrange [1e-15:1]
set format x '10^{%L}'
set xtics 1e3
set xlabel 'x'
set yrange [0:18]
set ytics 2
set ylabel 'digits of u, g'
set label 1 '(e)  in double, shipped forms'
plot for [n in '1 2 3 4 5 7'] data index 'digits '.word(names, n + 0).';' using 1:3 with lines lt colours[n + 0] lw 1.6 \
         dt dashes[n + 0], \
     for [n in '1 2 3 4 5 7'] '' index 'digits '.word(names, n + 0).';' using 1:4 with lines lt colours[n + 0] lw 1.2 dt 3, \
     '' index 'digits p=2;' using 1:9 with lines lc rgb '#888888' lw 5 dt 2 title 'u, R off by 2^{−53}'
set label 1 '(f)  in double, forms of the paper'
plot for [n in '1 2 3 4 5 7'] data index 'digits '.word(names, n + 0).';' using 1:6 with lines lt colours[n + 0] lw 1.6 \
         dt dashes[n + 0], \
     for [n in '1 2 3 4 5 7'] '' index 'digits '.word(names, n + 0).';' using 1:7 with lines lt colours[n + 0] lw 1.2 dt 3, \
     NaN with lines lt 7 lw 1.6 title 'u', NaN with lines lt 7 lw 1.2 dt 3 title 'g'
unset multiplot
