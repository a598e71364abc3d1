width = 1200; height = 540
load '../style.gp'
if (alone) { set rmargin 6 }
set multiplot layout 1, 3 margins 0.085, 0.945, 0.16, 0.81 spacing 0.1, 0.095
set key at screen 0.05, 0.99 left top Left reverse maxrows 1 width 2
set logscale y
set format y '10^{%L}'
set yrange [1e-6:10]
set ytics 1e1
set ylabel 'error' offset 1
set arrow 1 from graph 0, first 1e-2 to graph 1, first 1e-2 nohead lt 7 lw 1 dt 2 back
set label 2 '1 %' at graph 1.01, first 1e-2
titles = '"(a)  amplitudes, β = 0.02" "(b)  boundary (69)" "(c)  amplitudes at the worst r"'
do for [n = 1:3] {
    p = substr('abc', n, n)
    set label 1 word(titles, n) at graph 0.03, 1.05
    if (n == 3) {
        set logscale x
        set format x '10^{%L}'
        set xrange [1e-3:1]
        set xlabel 'largest coefficient left out' offset 0, 0.4
    } else { set xrange [0:2.5]; set xlabel 'r' offset 0, 0.4 }
    plot data index p.' uneven;' using 1:2 with lines lt 1 title (n == 1 ? 'dashpots 0.2, 0, 0.6' : ''), \
         '' index p.' light;' using 1:2 with lines lt 2 dt '-' title (n == 1 ? 'a fifth of them' : ''), \
         '' index p.' nearly even;' using 1:2 with lines lt 3 dt '.' lw 2.4 title (n == 1 ? '0.2, 0.3, 0.25' : '')
    unset key
    unset ylabel
}
unset multiplot
