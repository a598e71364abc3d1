width = 1250; height = 840
load '../style.gp'
set multiplot layout 2, 3 margins 0.075, 0.985, 0.1, 0.875 spacing 0.08, 0.14
set key at screen 0.05, 0.99 left top Left reverse maxrows 2 width 2
set xrange [0:2.5]
set yrange [0:*]
set xlabel 'r' offset 0, 0.4
set ylabel 'β' offset 1
array titles[6] = ['(a)  (57), ζ = 0.1', '(b)  (56), j = 4', '(c)  (59), (63), j = 1', \
    '(d)  (68), μ = 2.5', '(e)  (70), ζ = 0.1', '(f)  (88), j = 5']
do for [n = 1:6] {
    panel = substr('abcdef', n, n)
    set label 1 titles[n] at graph 0.03, 1.05
    # (56) and (88) are off in a part of the frequencies, which is what these panels show.
    set xrange [0:2.5]; set xtics 0.5; set yrange [0:*]
    if (n == 2) { set xrange [0.54:0.7]; set xtics 0.05; set yrange [0.03:0.15] }
    if (n == 6) { set xrange [2:2.5]; set xtics 0.1; set logscale y; set yrange [0.002:0.1]; set format y '%g' }
    if (n == 1) {
        plot data index panel.';' using 1:2 with lines lt 1 title 'as corrected', \
             '' index panel.';' using 1:3 with lines lt 2 dt '-' title 'as printed (57: 99 instants)', \
             '' index panel.';' using 1:4 with lines lt 5 dt '.' lw 2.4 title '(57): 999 instants', \
             '' index 'markers '.panel.';' using 1:2 with points lt 7 pt 6 title 'numerical'
    } else {
        plot data index panel.';' using 1:2 with lines lt 1, \
             '' index panel.';' using 1:3 with lines lt 2 dt '-', \
             '' index 'markers '.panel.';' using 1:2 with points lt 7 pt 6
    }
    unset key
}
unset multiplot
