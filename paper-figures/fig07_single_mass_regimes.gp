width = 1000; height = 620
load 'style.gp'
set xlabel 'r'
set ylabel 'β'
set xrange [0:3]
set yrange [0:1.2]
set xtics 0.5
set ytics 0.2
set key at graph 0.98, 0.33 right reverse Left
set dashtype 2 (10,4)
set dashtype 3 (3,2.5)
set label 'permanent sticking' at 1.5, 1.1 center
set label 'stick-slip' at 2, 0.8 center
set label 'continuous' at 1.2, 0.3 center
stats data index 'limit;' using 2 name 'limit' nooutput
set label sprintf('β_∞ = %.3f, (86)', limit_max) at 0.03, limit_max + 0.03
set margins 9, 3, 4, 1
array zeta[3] = ['0.001', '0.01', '0.1']
plot data index 'limit;' using 1:2 with lines lt 7 lw 1.2 dt (6,5), \
     for [n=1:3] data index 'zeta='.zeta[n].';' using 1:2 with lines lt n dt n title 'ζ = '.zeta[n].', (69)', \
     data index 'zeta=0.1;' using 1:5 with lines lt 7 title 'β = 1/μ, (88)', \
     for [n=1:3] data index 'numerical zeta='.zeta[n].';' using 1:2 with points lt n pt 6 ps 0.75 lw 1.2, \
     data index 'numerical zeta=0.1;' using 1:3 with points lt 7 pt 6 ps 0.75 lw 1.2 title 'numerical, 200 periods from rest'
