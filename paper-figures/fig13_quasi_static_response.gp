width = 1200; height = 580
load 'style.gp'
array zeta[3] = ['0.001', '0.01', '0.1']
array dashes[3] = [2, 3, 1]
set multiplot layout 1,2 margins 0.085, 0.985, 0.15, 0.8 spacing 0.085
set xrange [0:2]
set xtics ('0' 0, 'π/2' 0.5, 'π' 1, '3π/2' 1.5, '2π' 2)
set xlabel 'τ'
set xzeroaxis lc rgb '#888888'
set key at screen 0.05, 0.985 left top horizontal maxrows 1 samplen 3.5 width 2 reverse Left
set label 1 'lines: exact solver    circles: numerical, 200 periods from rest' at screen 0.985, 0.965 right
set title '(a) displacement' offset 0, -0.4
set ylabel 'x̄' offset 1
plot for [n=1:3] data index 'zeta='.zeta[n].';' using 1:2 with lines lt n dt dashes[n] title 'ζ = '.zeta[n], \
     for [n=1:3] data index 'numerical zeta='.zeta[n].';' using 1:2 with points lt n pt 6 ps 0.7 lw 1.2
unset label 1
unset key
set title '(b) velocity'
set ylabel 'x̄′'
plot for [n=1:3] data index 'zeta='.zeta[n].';' using 1:3 with lines lt n dt dashes[n], \
     for [n=1:3] data index 'numerical zeta='.zeta[n].';' using 1:3 with points lt n pt 6 ps 0.7 lw 1.2
unset multiplot
