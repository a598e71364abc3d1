% Answers `denhartog conform` by closed_form.m, in the plain dialect: jsondecode is not exact to the last digit.
run(fullfile(fileparts(mfilename('fullpath')), 'closed_form.m'));
function value = answer(quantity, c, k, tau, samples)
  wrapped = @(phi) phi - 2 * pi * ceil((phi - pi) / (2 * pi)); % to (-pi, pi]
  switch quantity
    case 'natural_frequency_ratios', value = c.r_n; case 'modal_frequency_ratios', value = c.R;
    case 'mode_shape_products', value = c.phi(k, :) .* c.phi(c.j, :) / c.r^2;
    case 'complex_response', value = [real(c.V(k)), imag(c.V(k))];
    case 'first_damping_function', value = c.U(k); case 'second_damping_function', value = c.G(k);
    case 'H_j', value = c.H_j; case 'S_j', value = demand(c, c.psi_j_squared);
    case 'beta_lim_exact', value = beta_lim(c, demand(c, c.psi_j_squared));
    case 'beta_lim_paper', value = beta_lim(c, sum(arrayfun(@(i) demand(c, c.psi_j_squared .* (c.R == c.R(i))), 1:numel(c.R))));
    case 'beta_lim_approximate', value = beta_lim(c, 0);
    case 'beta_lim_sticking', [~, value] = held(c);
    case 'beta_lim_high_frequency', value = 2 / hypot(2 * c.mu, pi); % (86) as corrected, j = l
    case 'regime', value = regime(c);
    case 'rest_interval', [~, ~, value] = held(c); value /= strcmp(regime(c), 'permanent_sticking');
    case 'amplitude', value = amplitude_and_phase(c, k);
    case 'phase', [size, value] = amplitude_and_phase(c, k); value = wrapped(value) / (size > 0);
    case 'motion_under_force', value = motion_under_force(c, k, 2 * pi * (0:samples - 1) / samples);
    case 'initial_displacement', [~, ~, start] = sliding(c); value = start(k, 1);
    case 'initial_velocity', [~, ~, start] = sliding(c); value = start(k, 2);
    case 'amplitude_monoharmonic', [~, ~, start] = sliding(c); value = norm(start(k, :)); % (52)
    case 'phase_monoharmonic', [phi_j, ~, start] = sliding(c); value = wrapped(phi_j + atan2(start(k, 2), start(k, 1))); % (53)
    case 'displacement', [~, W] = sliding(c); value = motion(c, W, k, tau);
    otherwise, error('not in the closed form');
  end
  if !all(isfinite(value)), error('at a pole, or not in this regime'); end
end
function rule = broken_rule(quantity, x) % x: the numbers of the question, N first
  [rule, of_a_mass] = deal('', '^(mode_|complex|first|second|amplitude|phase|initial|displacement|motion)');
  in_range = @(k) any(k == 1:x(1));
  if !all(isfinite(x)) || numel(x) != 9 + 3 * x(1) || x(1) < 1, rule = 'finite numbers, N of each ratio';
  elseif !all(x(10:9 + 2 * x(1)) > 0) || any(x(10 + 2 * x(1):end) < 0), rule = 'positive ratios, damping ratios not negative';
  elseif x(10) != 1 || x(10 + x(1)) != 1, rule = 'the first ratio of masses and of stiffnesses 1';
  elseif !in_range(x(2)) || !in_range(x(3)) || !in_range(x(4)) && any(regexp(quantity, of_a_mass)), rule = 'masses from 1 to N';
  elseif x(7) < 1 || x(8) <= 0 || x(9) < 0, rule = 'mu at least 1, r positive, beta not negative';
  elseif x(6) < 0 || x(6) >= 2 * pi || strcmp(quantity, 'motion_under_force') && x(5) < 1, rule = '0 <= tau < 2 pi, a sample'; end
end
sigterm_dumps_octave_core(false); % no file is left where the program is ended
warning('error', 'Octave:singular-matrix');
while true
  try words = strsplit(input('', 's')); catch, break; end % fgetl would wait for the line after
  x = str2double(words(3:end));
  if numel(words) < 3, printf("denhartog-conform 1 plain closed form in Octave\n");
  elseif any(isnan(x)), printf("%s skip not a scene of the paper\n", words{1}); % a word such as contact_with among the numbers
  elseif !isempty(rule = broken_rule(words{2}, x)), printf("%s reject %s\n", words{1}, rule);
  else
    try
      c = struct('j', x(2), 'l', x(3), 'mu', x(7), 'r', x(8), 'beta', x(9));
      [c.gamma, c.kappa, c.zeta] = num2cell(reshape(x(10:end), [], 3)', 2){:};
      value = answer(words{2}, prepared(c), x(4), x(6), x(5));
      if ischar(value), text = [' ', value]; else text = sprintf(' %.17g', value); end
      printf("%s value%s\n", words{1}, text);
    catch reason
      printf("%s skip %s\n", words{1}, strtok(reason.message, "\n"));
    end
  end
  fflush(stdout);
end
