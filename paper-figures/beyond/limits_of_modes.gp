# A table: a row a path, for v, u, g each the limit and the digits kept, dark where few are left of those of the number type.
width = 1300; height = 790
load '../style.gp'
unset key; unset grid; unset border; unset xtics; unset ytics; unset colorbox
set lmargin at screen 0.005; set rmargin at screen 0.995; set tmargin at screen 0.99; set bmargin at screen 0.055
set palette defined (0 '#440154', 0.25 '#3A548C', 0.5 '#21A585', 0.75 '#89D548', 1 '#FFFFDD')
set cbrange [0:1]
rows = 22
start(f) = 6.2 + 14.6 * f                                           # where the block of a function begins
left(c) = start(floor(c / 8)) + 5.6 + int(c) % 8 + (int(c) % 8 > 3 ? 0.3 : 0) # a cell's left edge
set xrange [0:50]
set yrange [rows - 0.4:-3.2]
functions = '"|v|" "u" "g"'
do for [f = 1:3] {
    set label word(functions, f) at start(f - 1) + 0.1, -1.9 font ',12'
    set label 'printed' at start(f - 1) + 7.6, -1.9 center font ',10'
    set label 'shipped' at start(f - 1) + 11.9, -1.9 center font ',10'
    do for [c = 0:7] {
        set label word('f d l 50', c % 4 + 1) at left(8 * f - 8 + c) + 0.5, -1 center font ',9'
    }
}
set label 'path' at 0.1, -1.9 font ',12'
set label 'Fewest correct decimal digits on the way to the limit, x → 0, in float (f, 7 digits), double (d, 16), long double '.\
    '(l, 19) and 50 digits (50, 51).   θ = πw/R,  δ = πζ/R,  q = π/R' at 0.1, -2.8 font ',10'
set colorbox horizontal user origin screen 0.36, 0.032 size screen 0.28, 0.014
set cbtics ('none' 0, 'half of the digits of the type' 0.5, 'all' 1) scale 0 offset 0, 0.5 font ',9'
plot data index 'cells;' using (left($1) + 0.5):2:(left($1) + 0.02):(left($1) + 0.98):($2 - 0.47):($2 + 0.47):4 \
         with boxxyerror fill solid noborder lc palette, \
     '' index 'cells;' using (left($1) + 0.5):($4 > 0.45 ? $2 : NaN):(sprintf('%.0f', $3)) with labels font ',8' tc rgb '#000000', \
     '' index 'cells;' using (left($1) + 0.5):($4 > 0.45 ? NaN : $2):(sprintf('%.0f', $3)) with labels font ',8' tc rgb '#FFFFFF', \
     '' index 'words;' using (0.1):1:2 with labels left font ',9', \
     for [f = 0:2] '' index 'words;' using (start(f) + 0.1):1:(strcol(3 + f)) with labels left font ',9'
