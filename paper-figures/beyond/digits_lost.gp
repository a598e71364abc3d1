# Colours are those of viridis, light for few digits; orange where a form gives no number, grey where the function is below
# the range of double. The axes of R - 1 and of zeta near 1 go by the decades of the distance.
width = 1000; height = 840
load '../style.gp'
set palette maxcolors 18 defined (0 '#BBBBBB', 1 '#FFFFEE', 2 '#FDE725', 3 '#D8E219', 4 '#B0DD2F', 5 '#89D548', 6 '#65CB5E', \
    7 '#46C06F', 8 '#2EB37C', 9 '#21A585', 10 '#1F978B', 11 '#23898E', 12 '#2A788E', 13 '#31688E', 14 '#3A548C', \
    15 '#433E85', 16 '#440154', 17 '#D55E00')
set cbrange [-1:17]
unset grid
unset colorbox
set border 15
set multiplot layout 2, 2 margins 0.125, 0.985, 0.24, 0.95 spacing 0.03, 0.15
set yrange [-0.5:94.5]
set xrange [-61.5:61.5]
functions = 'u g'
whats = 'printed shipped'
panel = 0
do for [row = 1:2] {
    f = word(functions, row)
    do for [column = 1:2] {
        panel = panel + 1
        set title sprintf('(%s)  %s, as %s', substr('abcd', panel, panel), f, word(whats, column)) offset 0, -0.8
        set ylabel 'ζ' offset 2.4
        set ytics ('10^{−16}' 0, '10^{−12}' 16, '10^{−8}' 32, '10^{−4}' 48, '1/2' 62.5, '1 − 10^{−6}' 74, '1 − 10^{−16}' 94)
        if (column > 1 && !alone) {
            set ylabel
            set ytics ('' 0, '' 16, '' 32, '' 48, '' 62.5, '' 74, '' 94)
        }
        set xlabel 'R − 1' offset 0, 0.6
        set xtics ('−10^{−2}' -55, '−10^{−8}' -31, '0' 0, '10^{−8}' 31, '10^{−2}' 55)
        plot data index 'near '.f.' '.word(whats, column).';' matrix using ($1 - 61):2:3 with image
    }
}
# the colours, below the panels
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 0.15
set bmargin at screen 0.01
unset title; unset xlabel; unset ylabel; unset border; unset xtics; unset ytics
set xrange [0:1]
set yrange [0:1]
set colorbox horizontal user origin screen 0.15, 0.09 size screen 0.75, 0.03
set cbtics ('too small' -0.5, '1' 1, '3' 3, '5' 5, '7' 7, '9' 9, '11' 11, '13' 13, '15' 15, 'no number' 16.5) \
    scale 0.3 offset 0, 0.4
set cblabel 'decimal digits lost in double' offset 0, 0.6
plot NaN with points palette
unset multiplot
