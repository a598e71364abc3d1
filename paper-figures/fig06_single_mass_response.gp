betas = '0.1 0.2 0.4 0.6 0.8'
last_r = 2
X = 'X̄'; phase = 'φ'
column_X = 2; column_phase = 5
least_phase = -45; largest_phase = 190; step_phase = 45
sliding(z) = z == 3 ? 4 : 5 # with zeta = 0.1 no motion at beta = 0.8 slides throughout
stuck = 0; name_points = ''
damping(z) = 'ζ = '.z
some = 3; inset = 1; note = ''
direct = 1
load 'common/response_over_r.gp'
