# Colours are those of viridis, light for few stops; white while the contact slides, grey while it rests.
width = 1240; height = 720
load '../style.gp'
zetas = '0.001 0.01 0.1'
left = log10(0.02)
step = (log10(3) - left) / 359
set palette maxcolors 14 defined (0 '#BBBBBB', 1 '#FFFFFF', 2 '#FFF2A0', 3 '#C2DF23', 4 '#86D549', 5 '#52C569', \
    6 '#2AB07F', 7 '#1E9B8A', 8 '#25858E', 9 '#2D708E', 10 '#38588C', 11 '#433E85', 12 '#482173', 13 '#2A0038')
set cbrange [-3:25]
set cbtics 2 scale 0 offset 0, 0.4
set cbtics add ('rest' -2)
set cblabel 'stops of the contact in a period of the force' offset 0, 0.8
set multiplot layout 1, 3 margins 0.075, 0.985, 0.39, 0.945 spacing 0.03
set xrange [log10(0.02):log10(3)]
set yrange [0:1.1]
set xtics ('0.02' log10(0.02), '0.05' log10(0.05), '0.1' -1, '0.2' log10(0.2), '0.5' log10(0.5), '1' 0, '2' log10(2))
set xlabel 'frequency ratio r' offset 0, 0.4
set ylabel 'friction ratio β' offset 1.6
set ytics 0.2
set label 1 'permanent sticking' at log10(0.25), 1.045 center front
set label 2 'continuous' at log10(2.9), 0.3 right front
unset grid
unset colorbox
do for [c = 1:3] {
    z = word(zetas, c)
    set title sprintf('(%s)  ζ = %s', word('a b c', c), z) offset 0, -0.6
    plot data index 'map zeta='.z.';' matrix using (left + step * $1):(0.0025 + 0.005 * $2):($3 < 0 ? -2 : $3) with image, \
         data index 'boundary zeta='.z.';' using (log10($1)):2 with lines lt 7, \
         '' index 'boundary zeta='.z.';' using (log10($1)):5 with lines lt 7 dt (8,4), \
         '' index 'markers zeta='.z.';' using (log10($1)):2:($3 == $4 ? 6 : 2) with points lc 7 pt variable ps 0.45 lw 0.8, \
         '' index 'point of Fig. 13;' using (log10($1)):2 with points lt 2 pt 3 ps 1.2
    if (!alone) { set ylabel; set ytics format '' }
}
# the keys, below the panels
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 0.27
set bmargin at screen 0.01
unset title; unset label; unset xlabel; unset ylabel; unset border; unset xtics; unset ytics
set yrange [0:1]
set key at screen 0.5, 0.275 center top horizontal maxrows 2 samplen 2.5 width 1 Left reverse
set colorbox horizontal user origin screen 0.2, (alone ? 0.5 : 0.115) size screen 0.6, 0.03
plot NaN with lines lt 7 title 'boundary of continuous motion (69)', NaN with lines lt 7 dt (8,4) title 'β = 1/μ, (88)', \
     NaN with points lt 7 pt 6 ps 0.6 title 'numerical, as many stops', \
     NaN with points lt 7 pt 2 ps 0.6 title 'another number', \
     NaN with points lt 2 pt 3 ps 1.2 title 'r, β of Fig. 13', \
     data index 'point of Fig. 13;' using (10):(10):(0) with points palette
unset multiplot
