# The one style of all figures. A script may set `width` and `height` (pixels) before it loads this; `draw` sets folder, name,
# format.
if (!exists("width")) width = 900
if (!exists("height")) height = 560
# A page shows a figure about 700 pixels wide: type is at least 10 of them high, lines one wide. `small` is the type of the least
# labels.
if (!exists("type")) type = width > 980 ? ceil(width / 70.0) : 14
# SVG counts in pixels, PNG in points. A PDF is for a column of 90 mm: each panel has a page of its own, with labels on both axes,
# as `draw` leaves `multiplot` out. A diagram stays whole, 170 mm wide.
alone = format eq 'pdf'
if (!exists("diagram")) diagram = 0
in_pdf = diagram ? 170 / 25.4 * 72 / width * type : 6.5 # points
sized(k) = k * (alone ? in_pdf : format eq 'svg' ? type : 0.75 * type)
small = sprintf(',%g', sized(1))
face = 'DejaVu Sans'.small
if (format eq 'svg') {
    set terminal svg size width, height dynamic enhanced font face linewidth (type > 14 ? 1.3 : 1) background 'white'
} else { if (format eq 'pdf') {
    set terminal pdfcairo size (diagram ? 17 : 9) cm, (diagram ? 17.0 * height / width : 6.4) cm enhanced font face linewidth 0.7 \
        pointscale (diagram ? 1 : 0.5) dashlength 0.6 background 'white'
    if (!diagram) { set tmargin 2 }
} else {
    set terminal pngcairo size width, height enhanced font face linewidth (type > 14 ? 1.3 : 1) background 'white'
} }
set output folder.'/'.name.'.'.format
data = folder.'/'.name.'.dat'
set encoding utf8
# Seven colours, the last black, each with its own marker. Their hues are those of Okabe and Ito, but dark enough: on white each
# has a contrast of 3.1 or more, and readers with any kind of colour blindness tell them apart as well as the originals or better.
array colour[7] = ['#0056A0', '#9E4010', '#008F68', '#CC72A8', '#DA7A00', '#5488FA', '#000000']
array marker[7] = [6, 4, 8, 12, 10, 2, 1]
do for [n = 1:7] { set linetype n lc rgb colour[n] lw 1.8 pt marker[n] ps 0.8 }
set linetype cycle 7
set border 3 lc rgb '#444444'
set tics nomirror out scale 0.6 textcolor rgb '#222222'
set grid lc rgb '#DDDDDD' lw 0.6 lt 1 dt solid
set key noautotitle spacing 1.15 samplen 2.2
