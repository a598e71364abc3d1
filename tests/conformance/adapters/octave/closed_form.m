% The steady motion of a chain with one Coulomb contact, in closed form: Marino & Cicirello, JSV 535 (2022) 117085.
% Numbers in brackets are its equations, with the corrections that the ledger of denhartog lists. Forms other than the paper's
% equal them and keep their digits. Modes with zeta >= 1, which the paper leaves out, obey them with w = i w_1: all stays real.
% A script that defines functions: values of modes are rows, those of masses columns.
1;
% c: a scene with rows gamma, kappa, zeta and numbers j, l, mu, r, beta.
function c = prepared(c)
  [c.r_n, c.phi] = natural_modes(c.gamma, c.kappa);
  c.R = c.r ./ c.r_n; % (22)
  [v, c.u, c.g] = arrayfun(@mode_functions, c.R, c.zeta);
  c.to_contact = c.phi .* c.phi(c.j, :) ./ c.r_n.^2; % psi_ki psi_ji R_i^2, mass by mode
  c.psi_j_squared = (c.phi(c.j, :) / c.r).^2;
  c.V = sum(c.phi .* c.phi(c.l, :) ./ c.r_n.^2 .* v, 2); % (33)
  c.U = sum(c.to_contact .* c.u, 2); % (34)
  c.G = sum(c.to_contact .* c.g, 2); % (35)
  c.H_j = sum(c.psi_j_squared .* (c.g + 2 * c.zeta .* c.R .* c.u)); % (64)
  c.samples = 64 * min(4096, ceil(2 + 1 / min(c.R))); % the fastest mode turns w / (2 R) times in [0, pi]
end
% r_i = omega_i sqrt(m_1/k_1), ascending, and phi with phi^T diag(gamma) phi = 1, (15), (17): psi = phi / r.
function [r_n, phi] = natural_modes(gamma, kappa)
  N = numel(gamma); % K = B^T B with the stretched springs as rows of B: r_i are its singular values, no root of a square
  B = sqrt(kappa') .* (eye(N) - diag(ones(1, N - 1), -1)) ./ sqrt(gamma);
  [~, S, phi] = svd(B);
  r_n = flip(diag(S)');
  phi = flip(phi, 2) ./ sqrt(gamma');
end
% zeta >= 1: rates a = zeta - w_1 and b = zeta + w_1 = 1 / a with w_1 = sqrt(zeta^2 - 1), and q_i at tau = R x.
function [a, b, q] = decay(x, zeta)
  w_1 = sqrt(zeta - 1) * sqrt(zeta + 1);
  a = 1 / (zeta + w_1);
  b = zeta + w_1;
  q = exp(-a * x) .* x;
  if w_1 > 0, q = exp(-a * x) .* (-expm1(-2 * w_1 * x) / (2 * w_1)); end
end
% sinh(zeta x)/(zeta x) - sin(w x)/(w x) = sum of D_k x^2k/(2k+1)!, D_{k+1} = zeta^2 D_k + (-w^2)^k: nothing cancels.
function total = sinhc_less_sinc(x, zeta)
  X = (zeta * x)^2;
  Y = (zeta - 1) * x * ((zeta + 1) * x); % -(w x)^2
  term = x * x / 6;
  power = term;
  total = 0;
  for k = 1:39
    total += term;
    power *= Y / ((2 * k + 2) * (2 * k + 3));
    term = X * term / ((2 * k + 2) * (2 * k + 3)) + power;
  end
end
% v_di (23), u_di (28), g_i (29): 1 - R^2 as a product, D = 2 E (cosh delta + cos theta) as a sum of squares.
function [v, u, g] = mode_functions(R, zeta)
  v = 1 / complex((1 - R) * (1 + R), 2 * zeta * R);
  x = pi / R;
  delta = pi * zeta / R;
  E = exp(-delta);
  if zeta >= 1 % sinh delta - zeta S = (sinh delta - sinh w_1 x) - a S with S = sinh(w_1 x)/w_1
    [a, b, q] = decay(x, zeta);
    D = (1 + exp(-a * x)) * (1 + exp(-b * x));
    u = 2 * q / (R * D);
    g = tanh(a * x / 2) - a * R * u;
  else
    w = sqrt((1 - zeta) * (1 + zeta));
    sin_theta = sin(pi * w / R);
    cos_half_theta = cos(pi * w / R / 2);
    if zeta < 0.5 % theta = pi (n + y), n the odd number next to 1 / R; 1 - n R is exact with R in two parts
      n = 2 * floor(1 / R / 2) + 1;
      R_high = double(single(R));
      y = ((1 - n * R_high) - n * (R - R_high) - zeta^2 / (1 + w)) / R;
      sin_theta = -sin(pi * y);
      cos_half_theta = sin(pi * y / 2); % but for its sign
    end
    D = expm1(-delta)^2 + 4 * E * cos_half_theta^2; % zero at a pole: then u and g are no finite numbers
    u = 2 * E * sin_theta / (R * w * D);
    g = (-expm1(-delta) * (1 + E) - 2 * zeta * E * sin_theta / w) / D;
  end
  if max(1, zeta) * x <= 4, g = 2 * E * delta * sinhc_less_sinc(x, zeta) / D; end
end
% 1 - d_i, q_i, R_i q_i' and R_i q_i' - cos tau from (A.8), (A.9), without cancellation for tau -> 0 and R -> infinity.
function [less_d, q, Rq_prime, difference] = free_motion(tau, R, zeta)
  x = tau / R;
  if zeta < 1
    w = sqrt((1 - zeta) * (1 + zeta));
    E = exp(-zeta * x);
    C = cos(w * x);
    q = E .* sin(w * x) / w;
    Rq_prime = E .* C - zeta * q;
    less_d = 1 - (E .* C + zeta * q);
    cosines = -2 * sin((w * x + tau) / 2) .* sin(((1 - R) - zeta^2 / (1 + w)) * x / 2); % cos(w x) - cos(tau)
    difference = expm1(-zeta * x) .* C + cosines - zeta * q;
  else
    [a, b, q] = decay(x, zeta);
    Rq_prime = exp(-b * x) - a * q;
    less_d = -expm1(-a * x) - a * q;
    difference = expm1(-b * x) - a * q + 2 * sin(tau / 2).^2;
  end
  small = max(1, 2 * zeta) * x < 1; % there 1 - d by its power series: m'' + 2 zeta m' + m = 1
  x = x(small);
  before = total = 0 * x;
  term = x.^2 / 2;
  for k = 2:21 * (isargout(1) && any(small))
    total += term;
    next = -(2 * zeta * x * k .* term + x.^2 .* before) / (k * (k + 1));
    before = term;
    term = next;
  end
  less_d(small) = total;
end
% Largest value and its place: f gives values and numbers with the sign of the slope, bisected where that turns.
function [value, place] = largest(f, tau)
  [~, slope] = f(tau);
  turns = find(slope(1:end - 1) > 0 & !(slope(2:end) > 0));
  a = tau(turns);
  b = tau(turns + 1);
  for step = 1:60 * !isempty(turns)
    [~, slope] = f((a + b) / 2);
    [a(slope > 0), b(!(slope > 0))] = deal(((a + b) / 2)(slope > 0), ((a + b) / 2)(!(slope > 0)));
  end
  [value, n] = max(f([tau, a]));
  place = [tau, a](n);
end
% Largest sum of weights times (57) as corrected, 0 < tau < pi, or its limit (71) for tau -> 0; that at pi is less.
function S = demand(c, weights)
  tau = pi * (1:c.samples - 1) / c.samples;
  tau = [logspace(-9, log10(tau(1)), 200)(1:end - 1), tau]; % heavily damped modes are quick at first
  S = max(sum(weights .* (1 + c.g + 2 * c.zeta .* c.R .* c.u)), largest(@(tau) integrand(c, weights, tau), tau));
end
function [value, slope] = integrand(c, weights, tau)
  N = N_prime = 0; % the sum times sin tau, and its derivative
  for i = find(weights)
    [~, q, Rq_prime, difference] = free_motion(tau, c.R(i), c.zeta(i));
    u = c.u(i) * c.R(i);
    N += weights(i) * ((1 + c.g(i)) * c.R(i) * q - u * c.R(i) * difference);
    N_prime += weights(i) * ((1 + c.g(i)) * Rq_prime + u * (2 * c.zeta(i) * Rq_prime + q - c.R(i) * sin(tau)));
  end
  value = N ./ sin(tau);
  slope = N_prime .* sin(tau) - N .* cos(tau);
end
function beta = beta_lim(c, S) % (67), (69)
  beta = abs(c.V(c.j)) / hypot(c.U(c.j), max(S, c.H_j + c.mu / (c.gamma(c.j) * c.r^2)));
end
% Contact held, (88): X_k in x_k = Re{X_k exp(i tau)}; the least beta that does it; how far from zero it may rest.
function [X, limit, rest] = held(c)
  C_half = c.gamma' .* c.phi .* sqrt(2 * c.zeta .* c.r_n * c.r); % (19): C = C_half C_half^T
  K = diag(c.kappa + [c.kappa(2:end), 0]) - diag(c.kappa(2:end), 1) - diag(c.kappa(2:end), -1);
  Z = K - c.r^2 * diag(c.gamma) + 1i * (C_half * C_half');
  load = (1:numel(c.gamma))' == c.l;
  others = 1:numel(c.gamma) != c.j;
  X = zeros(size(load));
  X(others) = Z(others, others) \ load(others);
  limit = abs(Z(c.j, :) * X - load(c.j)) / c.mu; % more friction bears the springs from the ground to the contact
  rest = c.mu * (c.beta - limit) * sum(1 ./ c.kappa(1:c.j));
end
function name = regime(c)
  limit = beta_lim(c, demand(c, c.psi_j_squared));
  name = 'stick_slip';
  if isnan(limit), error('a mode without damping at its resonance'); end
  if c.beta < limit, name = 'continuous'; elseif c.beta >= nthargout(2, @held, c), name = 'permanent_sticking'; end
end
% phi_j, (39), and V_dk exp(i phi_j) with (36), (37): V_dj exp(i phi_j) = root - i beta U_dj; x_k and x_k' at 0, (44), (45).
function [phi_j, W, start] = sliding(c)
  if !strcmp(regime(c), 'continuous'), error('the contact does not slide throughout'); end
  bU = c.beta * c.U(c.j);
  root = sqrt((abs(c.V(c.j)) - bU) * (abs(c.V(c.j)) + bU));
  phi_j = atan2(-bU, root) - arg(c.V(c.j));
  W = c.V * (complex(root, -bU) / c.V(c.j));
  W(c.j) = complex(root, -bU);
  start = [real(W) - c.beta * c.G, -imag(W) - c.beta * c.U];
end
% x_k by (46) as corrected, and its derivative; tau = 0 at the maximum of x_j, x_k(tau + pi) = -x_k(tau).
function [x, x_prime] = motion(c, W, k, time)
  tau = mod(time, pi);
  x = real(W(k) * exp(1i * tau));
  x_prime = -imag(W(k) * exp(1i * tau));
  for i = 1:numel(c.R)
    [less_d, q, Rq_prime] = free_motion(tau, c.R(i), c.zeta(i));
    x += c.beta * c.to_contact(k, i) * (less_d - c.g(i) * (1 - less_d) - c.u(i) * c.R(i) * q);
    x_prime += c.beta * c.to_contact(k, i) * ((1 + c.g(i)) * q / c.R(i) - c.u(i) * Rq_prime);
  end
  half_period = 1 - 2 * mod(floor(time / pi), 2);
  x .*= half_period;
  x_prime .*= half_period;
end
function [size, slope] = size_of_motion(varargin)
  [x, x_prime] = motion(varargin{:});
  size = abs(x);
  slope = x .* x_prime;
end
function [amplitude, phase] = amplitude_and_phase(c, k)
  if strcmp(regime(c), 'permanent_sticking'), amplitude = abs(held(c)(k)); phase = -arg(held(c)(k)); return; end
  [phi_j, W, start] = sliding(c);
  if k == c.j, amplitude = start(k, 1); phase = phi_j; return; end % (38), (39)
  [amplitude, tau] = largest(@(tau) size_of_motion(c, W, k, tau), pi * (0:c.samples) / c.samples);
  phase = phi_j + tau + pi * (motion(c, W, k, tau) < 0); % (47)
end
function x = motion_under_force(c, k, tau) % tau = 0 at the maximum of the force
  if strcmp(regime(c), 'permanent_sticking')
    x = real(held(c)(k) * exp(1i * tau));
  else
    [phi_j, W] = sliding(c);
    x = motion(c, W, k, tau - phi_j);
  end
end
