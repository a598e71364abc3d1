width = 1200; height = 1240
load '../style.gp'
if (alone) { set rmargin 6 }
set multiplot layout 3, 3 margins 0.08, 0.925, 0.075, 0.9 spacing 0.085, 0.105
set key at screen 0.05, 0.995 left top Left reverse maxrows 2 width 2
set logscale y
set format y '10^{%L}'
set yrange [1e-8:10]
set ytics 1e2
set xrange [0:2.5]
set xtics 0.5
set xlabel 'r' offset 0, 0.4
set ylabel 'error' offset 1
titles = '"(a)  (52) against (46)" "(b)  (48), (49) over X̄₁" "(c)  (53), radians" "(d)  ζ = 0.01, r = 0.9" '.\
         '"(e)  (67), SDOF" "(f)  (67), 2DOF" "(g)  (71)" "(h)  (72), 2DOF" "(i)  (88), 5DOF, j = 3 and 5"'
set object 1 rectangle from graph 0, graph 0 to graph 1, first 1e-2 fc rgb '#EAF3EC' fs solid noborder behind
set arrow 1 from graph 0, first 1e-2 to graph 1, first 1e-2 nohead lt 7 lw 1 dt 2 back
set arrow 2 from graph 0, first 1e-4 to graph 1, first 1e-4 nohead lt 7 lw 1 dt 3 back
do for [n = 1:9] {
    p = substr('abcdefghi', n, n)
    set label 1 word(titles, n) at graph 0.03, 1.05
    set label 2 (n % 3 == 0 || alone ? '1 %' : '') at graph 1.01, first 1e-2
    set label 3 (n % 3 == 0 || alone ? '0.01 %' : '') at graph 1.01, first 1e-4
    if (n == 7) { set xlabel 'R' } else { set xlabel 'r' }
    if (n % 3 == 1 || alone) { set ylabel 'error' offset 1 } else { unset ylabel }
    if (n == 4) {
        set logscale x
        set format x '10^{%L}'
        set xtics 10
        set xrange [1e-3:1]
        set xlabel 'β / β_{lim}'
        set key default
        set key noautotitle spacing 1.15 samplen 2.2 bottom right
        plot data index 'd (48);' using 1:2 with lines lt 1 title '(48)', \
             '' index 'd (52);' using 1:2 with lines lt 2 dt '-' title '(52)', \
             '' index 'd (53);' using 1:2 with lines lt 3 dt '.' lw 2.4 title '(53)'
        unset logscale x
        set format x
        set xtics 0.5
        set xrange [0:2.5]
        unset key
    } else {
        if (n >= 5 && n <= 8) { set xrange [0.1:0.7]; set xtics 0.2 } else { set xrange [0:2.5]; set xtics 0.5 }
        plot data index p.' zeta=0.001;' using 1:2 with lines lt 1 title (n == 1 ? 'ζ = 0.001' : ''), \
             '' index p.' zeta=0.01;' using 1:2 with lines lt 2 dt '-' title (n == 1 ? 'ζ = 0.01' : ''), \
             '' index p.' zeta=0.1;' using 1:2 with lines lt 3 dt '.' lw 2.4 title (n == 1 ? 'ζ = 0.1' : ''), \
             data index 'i j=5;' using 1:(n == 9 ? $2 : NaN) with lines lt 4 dt '_.' \
                title (n == 1 ? 'ζ = 0.1, j = 5, in (i)' : '')
        unset key
    }
}
unset multiplot
