width = 1250; height = 620
load '../style.gp'
set multiplot layout 1, 3 margins 0.075, 0.985, 0.165, 0.71 spacing 0.075, 0.1
set key at screen 0.05, 0.985 left top Left reverse maxrows 4
set ylabel 'X̄₁' offset 1
set yrange [0:*]
set label 1 '(a)  β = 0.25' at graph 0.03, 1.04
set xlabel 'r'
plot data index 'a;' using 1:($3) with lines lt 1 title '(52) as corrected', \
     '' index 'a;' using 1:($4) with lines lt 2 dt '-' title '(52) as printed', \
     '' index 'a;' using 1:($5) with lines lt 3 dt '.' lw 2.4 title '(50) as printed, with (51)', \
     '' index 'markers a;' using 1:3 with points lt 7 pt 6 title 'numerical'
unset key
set label 1 '(b)  r = 0.9'
set xtics 0.1
set xlabel 'β'
plot data index 'b;' using 2:($3) with lines lt 1, \
     '' index 'b;' using 2:($4) with lines lt 2 dt '-', \
     '' index 'b;' using 2:($5) with lines lt 3 dt '.' lw 2.4, \
     '' index 'markers b;' using 2:3 with points lt 7 pt 6
set key at screen 0.67, 0.985 left top Left reverse maxrows 4
set label 1 '(c)  r = r_{n,1}'
plot data index 'c;' using 1:3 with lines lt 1 lw 3.5 title '(81) as corrected', \
     '' index 'c;' using 1:5 with lines lt 2 dt '-' title '(81) as printed', \
     '' index 'c;' using 1:4 with lines lt 4 dt '.' lw 2.4 title '(82) as corrected', \
     '' index 'c;' using 1:6 with lines lt 5 dt '-' title '(82) as the scan has it', \
     '' index 'markers c;' using 1:2 with points lt 7 pt 6
unset multiplot
