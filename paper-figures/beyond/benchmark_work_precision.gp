# Work against precision on the benchmark of forced scenes: processor seconds a scene against digits of the displacements; a line
# is a method, a point a setting, filled where every scene is within 1e-3. `./verify chart` measures anew; until then the data are
# those beside this script.
width = 1240; height = 760
load '../style.gp'
if (system("test -s '".data."' && echo yes") ne 'yes') data = 'benchmark_work_precision.dat'
names = int(system("grep -c '^# name ' ".data))
entry(n) = system(sprintf("sed -n 's/^# name %d //p' %s", n, data))
array open_mark[8] = [6, 4, 8, 10, 12, 14, 6, 4]
array full_mark[8] = [7, 5, 9, 11, 13, 15, 7, 5]
set linetype 8 lc rgb '#888888' lw 1.8
set linetype cycle 8
set multiplot layout 1, 2 margins 0.08, 0.985, 0.34, 0.935 spacing 0.08, 0
set logscale y
set format y '10^{%L}'
set yrange [1e-5:10]
set xrange [-0.3:16.5]
set ylabel 'processor seconds a scene, median' offset 1
do for [panel = 1:2] {
    set title panel == 1 ? '(a)  the median scene answered' : '(b)  nine scenes of ten; a missing answer has 0 digits' offset 0, -0.6
    set xlabel panel == 1 ? 'digits, median' : 'digits that nine of ten scenes have'
    if (panel == 2) { set key at screen 0.5, 0.2 center top vertical maxrows 4 Left reverse noenhanced } else { unset key }
    if (panel == 2 && !alone) { unset ylabel }
    plot for [m = 1:names] data index sprintf('method=%d;', m) using panel:3 with linespoints lt m pt open_mark[1 + (m - 1) % 8] \
             title entry(m), \
         for [m = 1:names] '' index sprintf('method=%d;', m) using ($4 >= 1 ? column(panel) : NaN):3 \
             with points lt m pt full_mark[1 + (m - 1) % 8] ps 1.1
}
unset multiplot
