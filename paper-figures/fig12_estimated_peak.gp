width = 1250; height = 500
load 'style.gp'
array zeta[3] = ['0.001', '0.01', '0.1']
array dashes[3] = [2, 3, 1]
set multiplot layout 1,3 margins 0.055, 0.985, 0.14, 0.91 spacing 0.075
set xlabel 'β'
set xrange [0:0.8]
set xtics 0.2
set title '(a) peak over that without friction' offset 0, -0.4
set ylabel '2ζ X̄' offset 1
set yrange [0:1]
set key at graph 0.98, 0.99 right top reverse Left samplen 2
plot for [n=1:3] data index 'estimated zeta='.zeta[n].';' using 1:2 with lines lc rgb '#999999' lw 1.4 \
         title n == 1 ? '(83)' : '', \
     for [n=1:3] data index 'actual zeta='.zeta[n].';' using 1:3 with lines lt n dt dashes[n] \
         title 'peak, ζ = '.zeta[n], \
     for [n=1:3] data index 'actual zeta='.zeta[n].';' using 1:2 every 4 with points lt n pt 6 ps 0.7 lw 1.2, \
     keyentry with points lt 7 pt 6 ps 0.7 lw 1.2 title '(52) at r = 1'
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
set yrange [1e-5:100]
set format y '10^{%L}'
set key at graph 0.02, 0.99 left top
plot for [n=1:3] data index 'actual zeta='.zeta[n].';' using 4:6 with lines lt n dt dashes[n] title 'peak, ζ = '.zeta[n], \
     for [n=1:3] data index 'actual zeta='.zeta[n].';' using 4:7 every 4 with points lt n pt 6 ps 0.7 lw 1.2, \
     keyentry with points lt 7 pt 6 ps 0.7 lw 1.2 title 'r = 1'
unset logscale
unset key
unset xlabel
unset ylabel
unset format
unset title
set lmargin at screen 0.09
set rmargin at screen 0.185
set bmargin at screen 0.205
set tmargin at screen 0.45
set border 15
set object rectangle from graph 0,0 to graph 1,1 fc rgb 'white' behind
set xrange [0.55:0.8]
set yrange [0:0.3]
set xtics 0.1 font ',9'
set ytics 0.1 font ',9'
set tics offset 0.2, 0.2
plot for [n=1:3] data index 'estimated zeta='.zeta[n].';' using 1:2 with lines lc rgb '#999999' lw 1.4, \
     for [n=1:3] data index 'actual zeta='.zeta[n].';' using 1:3 with lines lt n dt dashes[n], \
     for [n=1:3] data index 'actual zeta='.zeta[n].';' using 1:2 every 4 with points lt n pt 6 ps 0.7 lw 1.2
unset multiplot
