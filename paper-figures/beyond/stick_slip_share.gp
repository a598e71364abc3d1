# Five masses with uncertain damping, friction and static friction: the share of the samples in which the contact sticks and
# slips, and quantiles of its amplitude at two friction ratios. The data come from a sweep, docs/sweep.md, by sweep_data.py; they
# stand beside this script.
width = 1240; height = 560
load '../style.gp'
data = 'stick_slip_share.dat'
set multiplot layout 1, 2 margins 0.085, 0.985, 0.155, 0.92 spacing 0.16, 0
set title '(a)  share of stick-slip' offset 0, -0.6
set xlabel 'frequency ratio r' offset 0, 0.4
set ylabel 'friction ratio β' offset 1
set xrange [0.1:2]
set yrange [0.05:2.5]
set cbrange [0:1]
set palette defined (0 '#F7FBFF', 0.5 '#6BAED6', 1 '#08306B')
# No share of stick-slip has two reasons, and one colour.
set label 1 'sticks for ever' at 0.875, 2.3 center front
set label 2 'slides throughout' at 1.02, 0.2 center front
plot data index 0 nonuniform matrix using 2:1:3 with image pixels
unset label
set title '(b)  amplitude of the contact, 5th to 95th percentile' offset 0, -0.6
set ylabel 'amplitude X̄_2' offset 1
set autoscale y
set logscale y
set format y '%g'
set yrange [0.02:*]
set key top right
plot data index 1 using 1:2:4 with filledcurves lc rgb colour[1] fs transparent solid 0.25 noborder, \
     data index 1 using 1:3 with lines lt 1 title 'β = 0.5, median', \
     data index 2 using 1:2:4 with filledcurves lc rgb colour[2] fs transparent solid 0.25 noborder, \
     data index 2 using 1:3 with lines lt 2 dt (8, 4) title 'β = 1.5, median'
unset multiplot
