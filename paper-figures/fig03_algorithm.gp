# Flow chart of the paper's numerical algorithm, Section 3.1.
width = 900; height = 860; diagram = 1
load 'style.gp'
unset border
unset tics
unset grid
unset key
set margins 0, 0, 0, 0
set xrange [0:90]
set yrange [0:86]
ink = 0x222222
set style arrow 1 head filled size 1.1, 20 lw 1.4 lc rgb ink
set style arrow 2 nohead lw 1.4 lc rgb ink
# input
set object rectangle from 20, 74 to 70, 84 fc rgb colour[6] fs solid 0.2 border lc rgb ink
set label 'Input: r, β, μ, ζ_i, γ_i, κ_i, or the matrices (7);' at 45, 81 center
set label 'N, j, l; initial displacements and velocities; N_{cyc}' at 45, 77.5 center
set arrow from 45, 74 to 45, 70.5 arrowstyle 1
set object rectangle from 27, 64 to 63, 70.5 fc rgb '#FFFFFF' fs solid border lc rgb ink
set label 'Matrices M̄, C̄, K̄ by (8), (19), (7); τ = 0' at 45, 67.3 center
set arrow from 45, 64 to 45, 60 arrowstyle 1
# sticking conditions
set object polygon from 45, 60 to 67, 51 to 45, 42 to 23, 51 to 45, 60 fc rgb colour[5] fs solid 0.2 border lc rgb ink
set label "Contact at rest, x̄'_j = 0," at 45, 53.2 center
set label 'and held, Σ_j ≤ μβ?  (74)' at 45, 49.6 center
set arrow from 23, 51 to 20, 51 arrowstyle 2
set arrow from 20, 51 to 20, 38 arrowstyle 1
set label 'yes' at 19.3, 47 right
set arrow from 67, 51 to 70, 51 arrowstyle 2
set arrow from 70, 51 to 70, 38 arrowstyle 1
set label 'no' at 70.7, 47 left
# the two phases
set object rectangle from 4, 24 to 40, 38 fc rgb colour[2] fs solid 0.15 border lc rgb ink
set label 'Sticking phase' at 22, 35.8 center font sprintf(',%g', sized(1))
set label 'contact held, x̄_j = x̄_{j0}; all N equations' at 22, 32.4 center
set label 'without friction, Runge–Kutta (4, 5),' at 22, 29.4 center
set label 'until Σ_j > μβ or τ = 2π N_{cyc}' at 22, 26.4 center
set object rectangle from 50, 24 to 86, 38 fc rgb colour[3] fs solid 0.15 border lc rgb ink
set label 'Sliding phase' at 68, 35.8 center font sprintf(',%g', sized(1))
set label '(6) with friction of one sign,' at 68, 32.4 center
set label 'Runge–Kutta (4, 5),' at 68, 29.4 center
set label "until x̄'_j = 0 or τ = 2π N_{cyc}" at 68, 26.4 center
# the final time
set arrow from 22, 24 to 22, 16 arrowstyle 2
set arrow from 22, 16 to 29, 16 arrowstyle 1
set arrow from 68, 24 to 68, 16 arrowstyle 2
set arrow from 68, 16 to 61, 16 arrowstyle 1
set object polygon from 45, 22 to 61, 16 to 45, 10 to 29, 16 to 45, 22 fc rgb colour[5] fs solid 0.2 border lc rgb ink
set label 'τ = 2π N_{cyc}?' at 45, 16 center
set arrow from 45, 22 to 45, 42 arrowstyle 1
set label 'no' at 45.7, 31 left
set arrow from 45, 10 to 45, 7 arrowstyle 1
set label 'yes' at 45.7, 8.7 left
set object rectangle from 12, 1 to 78, 7 fc rgb colour[6] fs solid 0.2 border lc rgb ink
set label 'Over the last period: largest |x̄_k|; phases where the contact slides throughout' at 45, 4 center
plot -1
