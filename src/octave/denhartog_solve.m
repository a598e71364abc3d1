function solution = denhartog_solve(scene, r, beta, digits, proved)
% DENHARTOG_SOLVE  The steady motion of a scene at one point or at many, in every regime.
%   solution = denhartog_solve(scene)                   at the scene's own frequency and friction
%   solution = denhartog_solve(scene, r, beta)          at frequency ratios r and friction ratios beta
%   solution = denhartog_solve(scene, r, beta, digits)  to so many significant digits, 1 to 15; 0 aims at 6
%   solution = denhartog_solve(scene, r, beta, digits, true)  at one point, every number and every bound proved
%
%   scene  a struct or text in JSON, see denhartog_json; its mu counts
%   r      frequency ratio omega sqrt(m_1 / k_1), Eq. (10)
%   beta   friction ratio F / P, Eq. (11); of the size of r, or one of the two is one number for all points
%
%   Fields of the answer. Displacements are in units of P / k_1, angles in radians. Points run down the rows, in the order
%   of r(:), masses along the columns. What is marked * has the size of r and beta; NaN says that there is no number.
%     r, beta *        the points
%     regime *         'continuous', 'stick_slip' or 'permanent_sticking'; 'none' where there are no numbers
%     status *         'answered'; 'on_boundary' where the regime could be the neighbour; 'not_converged', 'at_a_pole' or
%                      'failed' where there are no numbers. regime and status are text for one point, else cell arrays
%     stops *          rests of the contact in a period of the motion
%     periods *        that period, in periods of the force
%     amplitude        largest displacements, amplitude_error the bounds of their errors
%     phase            lags behind the force, in (-pi, pi], phase_error the bounds of their errors; NaN for a mass at rest
%
%   One point has more:
%     stop_start, stop_end  when the rests begin and end, tau from the maximum of the force; stop_start_error,
%                           stop_end_error the bounds of their errors
%     rest_interval         [from, to] where the contact may rest for ever; empty where it does not
%     rest_error            bound of the error of both; 0 where there is none
%     relative_error        the largest error of the amplitudes, relative, and of the phases
%     unique                true where the velocities are known not to depend on the start
%     from_rest             false where the motion is a steady one, and the start from rest is not known to lead to it
%     symmetric             true where the motion mirrors itself after half its period, Eq. (25)
%     proved                true where every number and every bound is proved; else the bounds are estimates
%     warning               text: what the amplitudes depend on too much, a mode next to its resonance and with next to no
%                           damping; empty where there is nothing to say
%     absolute_amplitude    where base, wall or both move: largest absolute displacements, absolute_phase their lags behind
%                           what moves, transmissibility the amplitudes over its own; absolute_amplitude_error,
%                           absolute_phase_error, transmissibility_error the bounds of their errors
%     dimensional           of a dimensional scene at its own point: frequency, frequency_hz, force, friction,
%                           displacement_unit (P / k_1), amplitude, amplitude_error, stop_start, stop_end (times),
%                           stop_start_error, stop_end_error, rest_interval, rest_error, all in the units of the scene
%
%   One point that has no answer is an error, denhartog:domain at a pole, denhartog:precision where the digits are not
%   reached or something is not proved. Among many points it has its status.
  if nargin < 2, r = []; end
  if nargin < 3, beta = []; end
  if nargin < 4, digits = 0; end
  if nargin < 5, proved = false; end
  point = scene_point(scene, r, beta);
  shape = size(point.r);
  if isscalar(point.r)
    shape = size(point.beta);
  elseif ~isscalar(point.beta) && ~isequal(size(point.beta), shape)
    error('denhartog:size', 'r and beta must have the same size, or one of them must be one number');
  end
  raw = denhartog_mex('solve', point.text, point.r, point.beta, point.mu, digits, double(proved));
  solution = struct('r', point.r + zeros(shape), 'beta', point.beta + zeros(shape));
  solution.regime = names_of('regime', raw.regime, shape);
  solution.status = names_of('status', raw.status, shape);
  solution.stops = counted(raw.stops, shape);
  solution.periods = counted(raw.periods, shape);
  for key = setdiff(fieldnames(raw)', fieldnames(solution)', 'stable')
    solution.(key{1}) = raw.(key{1});
  end
  if ~isempty(point.units)
    solution.dimensional = in_units(solution, point.units);
  end
end

function dimensional = in_units(solution, units)
  dimensional = struct('frequency', units.omega, 'frequency_hz', units.omega / (2 * pi), 'force', units.force);
  dimensional.friction = units.force * solution.beta;
  dimensional.displacement_unit = units.length;
  dimensional.amplitude = units.length * solution.amplitude;
  dimensional.amplitude_error = units.length * solution.amplitude_error;
  dimensional.stop_start = solution.stop_start / units.omega;
  dimensional.stop_end = solution.stop_end / units.omega;
  dimensional.stop_start_error = solution.stop_start_error / units.omega;
  dimensional.stop_end_error = solution.stop_end_error / units.omega;
  dimensional.rest_interval = units.length * solution.rest_interval;
  dimensional.rest_error = units.length * solution.rest_error;
end
