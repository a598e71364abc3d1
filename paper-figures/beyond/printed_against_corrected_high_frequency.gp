width = 1150; height = 520
load '../style.gp'
set multiplot layout 1, 2 margins 0.085, 0.985, 0.17, 0.87 spacing 0.09, 0.1
unset key
set xlabel 'r'
set ylabel 'β' offset 1
set yrange [0:0.8]
set label 1 '(a)  boundary of sliding, ζ = 0.1' at graph 0.03, 1.05
set logscale x
set xrange [0.5:300]
do for [n = 0:3] {
    mu = word('1 1.5 2 3', n + 1)
    set label (10 + n) 'μ = '.mu at 5.5, word('0.560 0.484 0.417 0.321', n + 1) + 0
}
plot for [n = 2:5] data index 'a;' using 1:n with lines lt 1, \
     for [n = 0:3] '' index 'limits;' every ::n::n using (20):2:(280):(0) with vectors nohead lt 7 dt '.' lw 2, \
     for [n = 0:3] '' index 'limits;' every ::n::n using (20):3:(280):(0) with vectors nohead lt 2 dt '-'
do for [n = 0:3] { unset label (10 + n) }
unset logscale x
set key top right
set xlabel 'μ'
set ylabel 'β_∞'
set xrange [1:3]
set label 1 '(b)  limit for r → ∞'
plot data index 'b;' using 1:2 with lines lt 7 dt '.' lw 2 title '(86) as corrected', \
     '' index 'b;' using 1:3 with lines lt 2 dt '-' title '(86) as printed', \
     '' index 'b;' every 20 using 1:4 with points lt 1 pt 2 title '(69) at r = 1000', \
     '' index 'markers b;' using 1:2 with points lt 7 pt 6 title 'numerical, r = 20'
unset multiplot
