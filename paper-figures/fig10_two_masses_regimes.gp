width = 1200; height = 720
load 'style.gp'
set dashtype 2 (10,4)
set dashtype 3 (3,2.5)
array zeta[3] = ['0.001', '0.01', '0.1']
set multiplot layout 1,2 margins 0.08, 0.985, 0.27, 0.935 spacing 0.085
set xlabel 'r'
set ylabel 'β' offset 1
unset key
set title '(a)' offset 0, -0.4
set xrange [0:3]
set yrange [0:3]
set xtics 0.5
set ytics 0.5
set label 'permanent sticking' at 0.55, 1.6 center
set label 'stick-slip' at 2.1, 1.3 left
set arrow 1 from 2.08, 1.26 to 1.72, 1.0 lw 1 lc rgb '#333333' size screen 0.006, 20 filled
set label 'continuous' at 1.5, 0.3 center
plot for [n=1:3] data index 'zeta='.zeta[n].';' using 1:2 with lines lt n dt n lw 2.4, \
     for [n=1:3] data index 'zeta='.zeta[n].';' using 1:5 with lines lt n dt n lw 1.2, \
     for [n=1:3] data index 'numerical zeta='.zeta[n].';' using 1:2 with points lt n pt 6 ps 0.75 lw 1.2, \
     for [n=1:3] data index 'numerical zeta='.zeta[n].';' using 1:3 with points lt n pt 6 ps 0.75 lw 1.2
unset label
unset arrow 1
set title '(b) both axes logarithmic'
set logscale xy
set xrange [0.05:30]
set yrange [1e-4:500]
set xtics ('0.05' 0.05, '0.1' 0.1, '0.5' 0.5, '1' 1, '2' 2, '5' 5, '10' 10, '30' 30)
set ytics 10 format '10^{%T}'
set label 'permanent sticking' at 0.22, 8 center
set label 'stick-slip' at 0.1, 0.08 center
set label 'continuous' at 1, 0.01 center
plot for [n=1:3] data index 'wide zeta='.zeta[n].';' using 1:2 with lines lt n dt n lw 2.4, \
     for [n=1:3] data index 'wide zeta='.zeta[n].';' using 1:5 with lines lt n dt n lw 1.2
# the key, below the panels
unset logscale
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 0.17
set bmargin at screen 0
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset grid; unset label
set yrange [0:1]
set key at screen 0.5, 0.155 center top vertical maxrows 3 reverse Left samplen 3
plot for [n=1:3] NaN with lines lt n dt n lw 2.4 title 'ζ_i = '.zeta[n].'/r_{n,i}, (69)', \
     for [n=1:3] NaN with lines lt n dt n lw 1.2 title 'ζ_i = '.zeta[n].'/r_{n,i}, (88)', \
     NaN with points lt 7 pt 6 ps 0.75 lw 1.2 title 'numerical, both'
unset multiplot
