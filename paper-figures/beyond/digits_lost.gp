# Colours are those of viridis, light for few digits; orange where a form gives no number, grey where the function is below
# the range of double. The axes of R - 1 and of zeta near 1 go by the decades of the distance.
width = 1240; height = 1560
load '../style.gp'
set palette maxcolors 18 defined (0 '#BBBBBB', 1 '#FFFFEE', 2 '#FDE725', 3 '#D8E219', 4 '#B0DD2F', 5 '#89D548', 6 '#65CB5E', \
    7 '#46C06F', 8 '#2EB37C', 9 '#21A585', 10 '#1F978B', 11 '#23898E', 12 '#2A788E', 13 '#31688E', 14 '#3A548C', \
    15 '#433E85', 16 '#440154', 17 '#D55E00')
set cbrange [-1:17]
unset grid
unset colorbox
set border 15
set multiplot layout 5, 3 margins 0.125, 0.985, 0.13, 0.977 spacing 0.025, 0.075
set yrange [-0.5:94.5]
functions = 'u u g g v'
maps = 'wide near wide near near'
whats = 'printed shipped condition'
titles = '"as printed" "as shipped" "condition number"'
panel = 0
do for [row = 1:5] {
    f = word(functions, row)
    m = word(maps, row)
    do for [column = 1:3] {
        panel = panel + 1
        set title sprintf('(%s)  %s, %s', substr('abcdefghijklmno', panel, panel), f, word(titles, column)) offset 0, -0.8
        set ylabel 'ζ' offset 2.4
        set ytics ('10^{−16}' 0, '10^{−12}' 16, '10^{−8}' 32, '10^{−4}' 48, '1/2' 62.5, '1 − 10^{−6}' 74, '1 − 10^{−11}' 84, \
            '1 − 10^{−16}' 94)
        if (column > 1) {
            set ylabel
            set ytics ('' 0, '' 16, '' 32, '' 48, '' 62.5, '' 74, '' 84, '' 94)
        }
        if (m eq 'wide') {
            set xlabel 'R' offset 0, 0.6
            set xrange [-3.01:2.01]
            set xtics ('10^{−3}' -3, '10^{−2}' -2, '' -1, '1/3' -log10(3), '1' 0, '10' 1, '' 2)
            plot data index m.' '.f.' '.word(whats, column).';' matrix using (-3 + $1 / 37.0):2:3 with image
        } else {
            set xlabel 'R − 1' offset 0, 0.6
            set xrange [-61.5:61.5]
            set xtics ('−10^{−2}' -55, '−10^{−8}' -31, '0' 0, '10^{−8}' 31, '10^{−2}' 55)
            plot data index m.' '.f.' '.word(whats, column).';' matrix using ($1 - 61):2:3 with image
        }
    }
}
# the colours, below the panels
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 0.1
set bmargin at screen 0.01
unset title; unset xlabel; unset ylabel; unset border; unset xtics; unset ytics
set xrange [0:1]
set yrange [0:1]
set colorbox horizontal user origin screen 0.15, 0.055 size screen 0.75, 0.02
set cbtics ('too small' -0.5, '1' 1, '3' 3, '5' 5, '7' 7, '9' 9, '11' 11, '13' 13, '15' 15, 'no number' 16.5) \
    scale 0.3 offset 0, 0.4
set cblabel 'decimal digits lost in double; power of ten of the condition number, in R or in ζ' offset 0, 0.6
plot NaN with points palette
unset multiplot
