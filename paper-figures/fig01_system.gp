# The chain of N masses. The load acts on the mass l, friction on the mass j; damping is that of the modes.
width = 1100; height = 380; diagram = 1
load 'style.gp'
unset border
unset tics
unset grid
unset key
set margins 0, 0, 0, 0
set xrange [0:110]
set yrange [0:36]
$spring << END
0 0
0.15 0
0.21 1
0.33 -1
0.45 1
0.57 -1
0.69 1
0.79 -1
0.85 0
1 0
END
array left[4] = [6, 26, 59, 85]
array right[4] = [16, 36, 69, 95]
array stiffness[4] = ['k_1', 'k_2', 'k_j', 'k_N']
array mass[4] = [16, 41, 69, 95]
array index[4] = ['1', 'l', 'j', 'N']
array gap_from[3] = [36, 51, 79]
array gap_to[3] = [41, 59, 85]
ink = 0x222222
# the fixed walls: on the left, and under the mass in contact
set arrow from 6, 13 to 6, 28 nohead lw 2 lc rgb ink
do for [n=0:6] { set arrow from 6, 14 + 2.2 * n to 4.4, 12.6 + 2.2 * n nohead lw 1 lc rgb ink }
set arrow from 65, 10 to 83, 10 nohead lw 2 lc rgb ink
do for [n=0:8] { set arrow from 66 + 2 * n, 10 to 64.6 + 2 * n, 8.4 nohead lw 1 lc rgb ink }
set object rectangle from 71.5, 10 to 76.5, 14 fc rgb colour[2] fs solid 0.35 border lc rgb colour[2]
set label '{/:Italic F_f} = −{/:Italic F} sgn(d{/:Italic x_j}/d{/:Italic t}),  static up to {/:Italic μF}' at 74, 5.6 center
set arrow from 70.3, 12 to 64.5, 12 lw 2.2 lc rgb colour[2] size 1.2, 20 filled
# masses, displacements, springs' names
do for [n=1:4] {
    set object rectangle from mass[n], 14 to mass[n] + 10, 27 fc rgb colour[1] fs solid 0.12 border lc rgb ink
    set label sprintf('{/:Italic m_{%s}}', index[n]) at mass[n] + 5, 20.5 center font sprintf(',%g', sized(1.2))
    set arrow from mass[n] + 5, 28.5 to mass[n] + 5, 32 nohead lw 1 lc rgb ink
    set arrow from mass[n] + 5, 30.5 to mass[n] + 10, 30.5 lw 1.2 lc rgb ink size 0.9, 20 filled
    set label sprintf('{/:Italic x_{%s}}', index[n]) at mass[n] + 10.6, 30.8 left
    set label '{/:Italic '.stiffness[n].'}' at (left[n] + right[n]) / 2.0, 27.5 center
}
set arrow from 51, 17.5 to 58, 17.5 lw 2.2 lc rgb colour[3] size 1.2, 20 filled
set label '{/:Italic P} cos {/:Italic ωt}' at 51.6, 19.8 left
set label 'Viscous damping is not drawn: it acts on the modes, by the ratios {/:Italic ζ_i} of (18) and (19).' at 6, 2 left
plot for [n=1:4] $spring using (left[n] + (right[n] - left[n]) * $1):(23.5 + 1.7 * $2) with lines lc rgb ink lw 1.5, \
     for [n=1:3] '+' using (gap_from[n] + (gap_to[n] - gap_from[n]) * $0 / 99):(23.5) with lines lc rgb ink lw 1.2 dt (3, 4)
