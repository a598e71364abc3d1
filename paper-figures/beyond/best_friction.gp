# A chain of three masses: the friction ratio at which the largest displacement of the loaded mass over all frequencies is lowest,
# and that displacement, over two stiffness ratios. The data come from a sweep, docs/sweep.md, by sweep_data.py; they stand beside
# this script.
width = 1240; height = 560
load '../style.gp'
data = 'best_friction.dat'
set multiplot layout 1, 2 margins 0.08, 0.92, 0.16, 0.92 spacing 0.17, 0
set xlabel 'third stiffness ratio' offset 0, 0.4
set ylabel 'second stiffness ratio' offset 1
set xrange [-2.25:2.25]
set yrange [-2.25:2.25]
set xtics ('1/4' -2, '1/2' -1, '1' 0, '2' 1, '4' 2)
set ytics ('1/4' -2, '1/2' -1, '1' 0, '2' 1, '4' 2)
set palette defined (0 '#F7FBFF', 0.5 '#6BAED6', 1 '#08306B')
exponent(x) = log(x) / log(2)
set logscale cb
set cbtics (1, 1.5, 2, 3, 4, 5, 7)
set title '(a)  best friction ratio' offset 0, -0.6
plot data index 0 nonuniform matrix using (exponent($1)):(exponent($2)):3 with image pixels
set title '(b)  the lowest peak, units of P / k_1' offset 0, -0.6
set cbtics (1, 2, 5, 10, 20, 50)
plot data index 1 nonuniform matrix using (exponent($1)):(exponent($2)):3 with image pixels
unset multiplot
