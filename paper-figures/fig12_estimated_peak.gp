width = 1250; height = 560
load 'style.gp'
array zeta[3] = ['0.001', '0.01', '0.1']
array dashes[3] = [2, 3, 1]
set multiplot layout 1,3 margins 0.06, 0.985, 0.17, 0.91 spacing 0.09
set xlabel 'β'
set xrange [0:0.8]
set xtics 0.2
set title '(a) one damping ratio, ζ = 0.1' offset 0, -0.4
set ylabel 'X̄' offset 1
set yrange [0:5.4]
set key at graph 0.98, 0.99 right top reverse Left samplen 2
plot data index 'estimated zeta=0.1;' using 1:3 with lines lt 7 lw 1.2 dt 2 title 'estimate (83)', \
     data index 'actual zeta=0.1;' using 1:(5 * $2) with lines lt 2 title '(52) at r = 1', \
     data index 'actual zeta=0.1;' using 1:(5 * $3) with lines lt 1 title 'true peak over r'
set title '(b) estimate (83)'
set ylabel 'X̄'
set yrange [0:50]
array damping[4] = ['0.01', '0.02', '0.05', '0.1']
plot for [n=1:4] data index 'estimated zeta='.damping[n].';' using 1:3 with lines lt n dt n title 'ζ = '.damping[n]
set title '(c) error of (83)'
set xlabel 'β / β_{lim}, (69) at r = 1'
set ylabel 'percent'
set xrange [0:1]
set logscale y
set yrange [1e-5:1e5]
set format y '10^{%L}'
set ytics 100
set key at graph 0.02, 0.995 left top
plot for [n=1:3] data index 'actual zeta='.zeta[n].';' using 4:6 with lines lt n dt dashes[n] title 'peak, ζ = '.zeta[n], \
     for [n=1:3] data index 'actual zeta='.zeta[n].';' using 4:7 every 4 with points lt n pt 6 ps 0.7 lw 1.2, \
     keyentry with points lt 7 pt 6 ps 0.7 lw 1.2 title 'r = 1'
unset multiplot
