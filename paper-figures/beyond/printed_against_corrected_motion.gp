width = 1250; height = 540
load '../style.gp'
set multiplot layout 1, 3 margins 0.065, 0.985, 0.165, 0.77 spacing 0.08, 0.1
set key at screen 0.05, 0.985 left top Left reverse maxrows 2 width 0
set xlabel 'τ / π'
set xtics 0.5
set xrange [0:2]
set xzeroaxis lc rgb '#888888'
set ylabel 'x̄₁' offset 1
set label 1 '(a)  mass in contact' at graph 0.03, 1.04
plot data index 'a;' using 1:2 with lines lt 1 title 'as corrected', \
     '' index 'a;' using 1:3 with lines lt 2 dt '-' title '(46) as printed', \
     NaN with lines lt 3 dt '.' lw 2.4 title '(44), (45) as printed', \
     NaN with lines lt 5 dt '_.' title '(A.7) as printed', \
     '' index 'markers a;' using 1:2 with points lt 7 pt 6 title 'numerical'
unset key
set ylabel 'x̄₃'
set label 1 '(b)  mass 3'
plot data index 'b;' using 1:2 with lines lt 1, \
     '' index 'b;' using 1:3 with lines lt 2 dt '-', \
     '' index 'b;' using 1:4 with lines lt 3 dt '.' lw 2.4, \
     '' index 'markers b;' using 1:2 with points lt 7 pt 6
set ylabel "η₂'"
set label 1 '(c)  velocity of mode 2'
plot data index 'c;' using 1:2 with lines lt 1, \
     '' index 'c;' using 1:3 with lines lt 5 dt '_.', \
     '' index 'markers c;' using 1:2 with points lt 7 pt 6
unset multiplot
