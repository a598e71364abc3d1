width = 1200; height = 580
load 'style.gp'
array zeta[3] = ['0.001', '0.01', '0.1']
array wide[3] = [3.4, 2, 1]
array mark[3] = [6, 4, 8]
set multiplot layout 1,2 margins 0.085, 0.985, 0.15, 0.8 spacing 0.085
set xrange [0:2]
set xtics ('0' 0, 'π/2' 0.5, 'π' 1, '3π/2' 1.5, '2π' 2)
set xlabel 'τ'
set xzeroaxis lc rgb '#888888'
set key at screen 0.05, 0.985 left top horizontal maxrows 2 samplen 2.5 reverse Left
set title '(a) displacement' offset 0, -0.4
set ylabel 'x̄' offset 1
plot for [n=1:3] data index 'zeta='.zeta[n].';' using 1:2 with lines lt n lw wide[n] title 'ζ = '.zeta[n].', exact', \
     for [n=1:3] data index 'numerical zeta='.zeta[n].';' using 1:2 with points lt n pt mark[n] ps 0.7 lw 1.2 \
         title 'numerical'
unset key
set title '(b) velocity'
set ylabel 'x̄′'
plot for [n=1:3] data index 'zeta='.zeta[n].';' using 1:3 with lines lt n lw wide[n], \
     for [n=1:3] data index 'numerical zeta='.zeta[n].';' using 1:3 with points lt n pt mark[n] ps 0.7 lw 1.2
unset multiplot
