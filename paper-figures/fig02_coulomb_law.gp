width = 620; height = 420
load 'style.gp'
set xlabel 'velocity of the contact, ẋ_j'
set ylabel 'sgn(ẋ_j) = −F_f / F'
set xrange [-1.05:1.05]
set yrange [-1.9:1.9]
set xtics (0)
set ytics ('−μ' -1.5, '−1' -1, '0' 0, '1' 1, 'μ' 1.5)
set xzeroaxis lc rgb '#888888'
set label 'sticks: any value in [−μ, μ]' at -0.05, 0.5 right
set label 'slides' at 0.62, 1.18
set label 'slides' at -0.72, -1.2
plot data index 'slides to the left;' using 1:2 with lines lt 1 lw 2.5, \
     data index 'slides to the right;' using 1:2 with lines lt 1 lw 2.5, \
     data index 'sticks;' using 1:2 with lines lt 2 lw 2.5
