width = 1000; height = 480
load '../style.gp'
set dashtype 6 (14, 4)
set multiplot layout 1, 2 margins 0.08, 0.98, 0.15, 0.88 spacing 0.11, 0.1
set ylabel 'top storey, mm' offset 1
set logscale y
set xlabel 'frequency, Hz' offset 0, 0.4
set label 1 '(a)  over frequency' at graph 0.03, 1.05
set key top left Left reverse
set xrange [1:4.5]
forces = '0 5 20 40 60 120'
plot for [n = 1:6] data index 'a '.word(forces, n).' N;' using 1:2 with lines lt n dt n title word(forces, n).' N'
set xlabel 'friction force, N'
set label 1 '(b)  over the friction force'
set key bottom left
set yrange [0.3:100]
set xrange [0:120]
plot for [n = 1:3] data index 'b '.word('2.6 2.9 3.2', n).' Hz;' using 1:2 with lines lt n dt n title word('2.6 2.9 3.2', n).' Hz'
unset multiplot
