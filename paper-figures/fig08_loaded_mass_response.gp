betas = '0.1 0.2 0.4 0.8 1.2'
last_r = 2.5
X = 'X̄₁'; phase = 'φ₁'
column_X = 6; column_phase = 7 # (52), (53)
least_phase = -45; largest_phase = 190; step_phase = 45
sliding(z) = z == 3 ? 4 : 5
stuck = 1; name_points = 'invariant points, (87)'
damping(z) = 'ζ_i = '.z.'/r_{n,i}'
some = 2; inset = 0; note = "200 periods\nfrom rest have\nnot settled"
direct = 0
load 'common/response_over_r.gp'
