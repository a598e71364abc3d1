betas = '0.1 0.2 0.4 0.8 1.2'
last_r = 2.5
X = 'X̄₂'; phase = 'φ₂'
column_X = 2; column_phase = 5
least_phase = -45; largest_phase = 375; step_phase = 90
sliding(z) = z == 3 ? 4 : 5
stuck = 0; name_points = 'invariant points, U_2 = 0'
damping(z) = 'ζ_i = '.z.'/r_{n,i}'
some = 2; inset = 0; note = ''
direct = 0
load 'common/response_over_r.gp'
