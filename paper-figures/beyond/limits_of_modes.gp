# The failures: for each of v, u, g the paths on which a form keeps less than half of the digits of a number type, a row each with
# the limit and the digits kept, dark if few of those of the type are left.
width = 900; height = 1040; diagram = 1
load '../style.gp'
unset key; unset grid; unset border; unset xtics; unset ytics; unset colorbox
set lmargin at screen 0.005; set rmargin at screen 0.995; set tmargin at screen 0.995; set bmargin at screen 0.07
set palette defined (0 '#440154', 0.25 '#3A548C', 0.5 '#21A585', 0.75 '#89D548', 1 '#FFFFDD')
set cbrange [0:1]
stats data index 'words;' using 1 name 'row' nooutput
middle(c) = 22.9 + 3.45 * c + (c > 3 ? 0.8 : 0)
set xrange [0:50]
set yrange [row_max + 0.6:-4.4]
set label "Fewest correct decimal digits on the way to the limit, x → 0, in float (f, 7 digits), double (d, 16),\n".\
    'long double (l, 19) and 50 digits (50, 51).   θ = πw/R,  δ = πζ/R,  q = π/R' at 0.1, -4
do for [c = 0:7] { set label word('f d l 50', c % 4 + 1) at middle(c), -0.9 center }
set label 'printed' at middle(1.5), -1.8 center
set label 'shipped' at middle(5.5), -1.8 center
set colorbox horizontal user origin screen 0.3, 0.043 size screen 0.4, 0.012
set cbtics ('none' 0, 'half of the digits of the type' 0.5, 'all' 1) scale 0 offset 0, 0.5
plot data index 'cells;' using (middle($1)):2:(middle($1) - 1.66):(middle($1) + 1.67):($2 - 0.47):($2 + 0.47):4 \
         with boxxyerror fill solid noborder lc palette, \
     '' index 'cells;' using (middle($1)):($4 > 0.45 ? $2 : NaN):(sprintf('%.0f', $3)) with labels tc rgb '#000000', \
     '' index 'cells;' using (middle($1)):($4 > 0.45 ? NaN : $2):(sprintf('%.0f', $3)) with labels tc rgb '#FFFFFF', \
     '' index 'words;' using (0.1):1:2 with labels left, '' index 'words;' using (11.2):1:3 with labels left
