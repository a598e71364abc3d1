width = 1200; height = 1500
load '../style.gp'
if (alone) { set rmargin 6 }
set multiplot layout 3, 2 margins 0.105, 0.925, 0.055, 0.965 spacing 0.175, 0.085
set key bottom right
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xrange [1e-5:0.3]
set yrange [1e-12:10]
set ytics 1e2
set xlabel 'ζ' offset 0, 0.3
set ylabel 'error' offset 1
set arrow 1 from graph 0, first 1e-2 to graph 1, first 1e-2 nohead lt 7 lw 1 dt 2 back
set arrow 2 from graph 0, first 1e-4 to graph 1, first 1e-4 nohead lt 7 lw 1 dt 3 back
set label 2 '1 %' at graph 1.01, first 1e-2
set label 3 '0.01 %' at graph 1.01, first 1e-4
set label 1 '(a)  response functions' at graph 0.03, 1.05
plot data index 'a (76);' using 1:2 with lines lt 1 title '(76)', \
     '' index 'a (77);' using 1:2 with lines lt 2 dt '-' title '(77)', \
     '' index 'a (78);' using 1:2 with lines lt 3 dt '.' lw 2.4 title '(78)'
unset ylabel
set label 1 '(b)  second damping functions'
plot data index 'b (79);' using 1:2 with lines lt 1 title '(79)', \
     '' index 'b (80);' using 1:2 with lines lt 2 dt '-' title '(80), mode 1', \
     '' index 'b (80) second;' using 1:2 with lines lt 3 dt '.' lw 2.4 title '(80), mode 2'
set ylabel 'error' offset 1
set label 1 '(c)  amplitude at r_{n,i}'
plot data index 'c (81);' using 1:2 with lines lt 1 title '(81)', \
     '' index 'c (82);' using 1:2 with lines lt 2 dt '-' title '(82), (83)', \
     '' index 'c (84);' using 1:2 with lines lt 3 dt '.' lw 2.4 title '(84), SDOF'
unset ylabel
set label 1 '(d)  (83), height of the peak'
plot data index 'd mode 1 mass 1;' using 1:2 with lines lt 1 title 'mode 1, mass 1', \
     '' index 'd mode 1 mass 2;' using 1:2 with lines lt 2 dt '-' title 'mode 1, mass 2', \
     '' index 'd mode 2 mass 1;' using 1:2 with lines lt 3 dt '.' lw 2.4 title 'mode 2, mass 1', \
     '' index 'd mode 2 mass 2;' using 1:2 with lines lt 4 dt '_.' title 'mode 2, mass 2'
set key top left
set ylabel 'error' offset 1
set label 1 '(e)  (84), SDOF'
unset logscale x
set format x
set xtics 0.2
set xrange [0:1]
set yrange [1e-8:10]
set xlabel 'β / β_n'
plot data index 'e zeta=0.001;' using 1:2 with lines lt 1 title 'ζ = 0.001', \
     '' index 'e zeta=0.01;' using 1:2 with lines lt 2 dt '-' title 'ζ = 0.01', \
     '' index 'e zeta=0.1;' using 1:2 with lines lt 3 dt '.' lw 2.4 title 'ζ = 0.1'
set key bottom right
unset ylabel
set label 1 '(f)  (85)'
set logscale x
set format x '10^{%L}'
set xtics 10
set xrange [1e-5:0.3]
set xlabel 'ζ'
plot data index 'f SDOF;' using 1:2 with lines lt 1 title 'SDOF', \
     '' index 'f mode 1;' using 1:2 with lines lt 2 dt '-' title '2DOF, mode 1', \
     '' index 'f mode 2;' using 1:2 with lines lt 3 dt '.' lw 2.4 title '2DOF, mode 2'
unset multiplot
