width = 1000; height = 620
load 'style.gp'
set xlabel 'ζ'
set ylabel 'β'
set logscale x
set xrange [0.001:0.5]
set yrange [0:1]
set xtics ('0.001' 0.001, '0.002' 0.002, '0.005' 0.005, '0.01' 0.01, '0.02' 0.02, '0.05' 0.05, '0.1' 0.1, '0.2' 0.2, '0.5' 0.5)
set ytics 0.2
set key at graph 0.99, 0.99 right top reverse Left maxrows 2 samplen 3.5 width 2
set margins 9, 3, 4, 1
levels = '1 2 5 10 20 50 100 200'
set for [n=1:8] label n 'X̄ = '.word(levels, n) at 0.43 / real(word(levels, n)), 0.07 right
set label 9 'π/4' at 0.00102, pi / 4 + 0.025
plot for [X in levels] data index 'estimated X='.X.';' using 1:2 with lines lt 1 lw 1.6 \
         title X eq '1' ? 'estimated peak (84)' : '', \
     for [X in levels] data index 'actual X='.X.';' using 1:2 with points lt 2 pt 6 ps 0.8 lw 1.4 \
         title X eq '1' ? 'actual peak of (52)' : '', \
     data index 'boundaries;' using 1:2 with lines lt 7 lw 2.4 title 'boundary (85)', \
     data index 'boundaries;' using 1:3 with lines lt 7 lw 1.8 dt (6,4) title 'boundary (69) at r = 1'
