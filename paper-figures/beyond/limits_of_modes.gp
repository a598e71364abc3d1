# A table for each of v, u, g: a row for each path has the limit and the digits kept, dark if few of those of the number type are
# left.
width = 900; height = 1650
load '../style.gp'
unset key; unset grid; unset border; unset xtics; unset ytics; unset colorbox
set lmargin at screen 0.005; set rmargin at screen 0.995; set tmargin at screen 0.995; set bmargin at screen 0.045
set palette defined (0 '#440154', 0.25 '#3A548C', 0.5 '#21A585', 0.75 '#89D548', 1 '#FFFFDD')
set cbrange [0:1]
rows = 22
function_of(c) = floor(c / 8)
top(f) = 3.2 + (rows + 3.4) * f                                        # the head of the table of a function
left(c) = 21.2 + 3.45 * (int(c) % 8) + (int(c) % 8 > 3 ? 0.8 : 0)      # a cell's left edge
y(f, row) = top(f) + 1.6 + row
set xrange [0:50]
set yrange [y(2, rows) + 0.6:-0.6]
set label "Fewest correct decimal digits on the way to the limit, x → 0, in float (f, 7 digits), double (d, 16),\n".\
    'long double (l, 19) and 50 digits (50, 51).   θ = πw/R,  δ = πζ/R,  q = π/R' at 0.1, 0.2
functions = '"|v|" "u" "g"'
do for [f = 0:2] {
    set label 'path' at 0.1, top(f)
    set label word(functions, f + 1).' →' at 11.2, top(f)
    set label 'printed' at left(8 * f) + 6.9, top(f) - 0.6 center
    set label 'shipped' at left(8 * f + 4) + 6.9, top(f) - 0.6 center
    do for [c = 0:7] { set label word('f d l 50', c % 4 + 1) at left(c) + 1.72, top(f) + 0.5 center }
}
set colorbox horizontal user origin screen 0.3, 0.027 size screen 0.4, 0.008
set cbtics ('none' 0, 'half of the digits of the type' 0.5, 'all' 1) scale 0 offset 0, 0.5
middle(c) = left(c) + 1.72
plot data index 'cells;' using (middle($1)):(y(function_of($1), $2)):(left($1) + 0.06):(left($1) + 3.39): \
         (y(function_of($1), $2) - 0.47):(y(function_of($1), $2) + 0.47):4 with boxxyerror fill solid noborder lc palette, \
     '' index 'cells;' using (middle($1)):($4 > 0.45 ? y(function_of($1), $2) : NaN):(sprintf('%.0f', $3)) \
         with labels tc rgb '#000000', \
     '' index 'cells;' using (middle($1)):($4 > 0.45 ? NaN : y(function_of($1), $2)):(sprintf('%.0f', $3)) \
         with labels tc rgb '#FFFFFF', \
     for [f = 0:2] '' index 'words;' using (0.1):(y(f, $1)):2 with labels left, \
     for [f = 0:2] '' index 'words;' using (11.2):(y(f, $1)):(strcol(3 + f)) with labels left
