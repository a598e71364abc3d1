# The one style of all figures. A script may set `width` and `height` (pixels) before it loads this; `draw` sets folder, name, format.
# Colours are those of Okabe and Ito, which colour-blind readers tell apart; 7 is black. Each colour has its own marker.
if (!exists("width")) width = 900
if (!exists("height")) height = 560
# A page shows a figure about 700 pixels wide: type is at least 10 of them high, lines one wide. `small` is the type of the least labels.
if (!exists("type")) type = width > 980 ? ceil(width / 70.0) : 14
small = sprintf(',%g', format eq 'svg' ? type : 0.75 * type) # PNG counts in points
face = 'DejaVu Sans'.small
if (format eq 'svg') {
    set terminal svg size width, height dynamic enhanced font face linewidth (type > 14 ? 1.3 : 1) background 'white'
} else {
    set terminal pngcairo size width, height enhanced font face linewidth (type > 14 ? 1.3 : 1) background 'white'
}
set output folder.'/'.name.'.'.format
data = folder.'/'.name.'.dat'
set encoding utf8
set linetype 1 lc rgb '#0072B2' lw 1.8 pt 6 ps 0.8
set linetype 2 lc rgb '#D55E00' lw 1.8 pt 4 ps 0.8
set linetype 3 lc rgb '#009E73' lw 1.8 pt 8 ps 0.8
set linetype 4 lc rgb '#CC79A7' lw 1.8 pt 12 ps 0.8
set linetype 5 lc rgb '#E69F00' lw 1.8 pt 10 ps 0.8
set linetype 6 lc rgb '#56B4E9' lw 1.8 pt 2 ps 0.8
set linetype 7 lc rgb '#000000' lw 1.8 pt 1 ps 0.8
set linetype cycle 7
set border 3 lc rgb '#444444'
set tics nomirror out scale 0.6 textcolor rgb '#222222'
set grid lc rgb '#DDDDDD' lw 0.6 lt 1 dt solid
set key noautotitle spacing 1.15 samplen 2.2
