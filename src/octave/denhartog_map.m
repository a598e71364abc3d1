function map = denhartog_map(scene, r, beta, masses, varargin)
% DENHARTOG_MAP  Regime, amplitudes and stops over a grid of frequency and friction ratios.
%   map = denhartog_map(scene, r, beta)          amplitudes of all masses
%   map = denhartog_map(scene, r, beta, masses)  amplitudes of these masses, counted from 1; [] takes all
%   map = denhartog_map(scene, r, beta, masses, 'phases')       phases as well; every point is answered as by denhartog_solve
%   map = denhartog_map(scene, r, beta, masses, 'from_ground')  absolute displacements, where base or wall move; both may follow
%
%   scene  a struct or text in JSON, see denhartog_json; its mu counts, its own frequency and friction do not
%   r      frequency ratios, Eq. (10)
%   beta   friction ratios, Eq. (11); ascending ones help each other
%
%   Matrices of the answer are beta by r: friction runs down the rows, frequency along the columns, as contourf(map.r,
%   map.beta, map.amplitude(:, :, 1)) wants it. NaN says that there is no number.
%     r, beta, masses  the grid, as rows
%     regime           0, 1, 2: place in regime_names less 1
%     status           0 to 4: place in status_names less 1
%     stops            rests of the contact in a period of the motion
%     periods          that period, in periods of the force
%     amplitude        beta by r by masses, in units of P / k_1
%     phase            the same of phases, if they were asked for: lags behind the force, or behind base or wall
%     regime_names     'continuous', 'stick_slip', 'permanent_sticking'
%     status_names     'answered', 'on_boundary', 'not_converged', 'at_a_pole', 'failed'
%   To 6 digits of every amplitude; the numbers are those of `denhartog map`, to the last bit.
  if nargin < 4, masses = []; end
  if isempty(r) || isempty(beta)
    error('denhartog:input', 'a map needs r and beta: its grid has no point of the scene''s own');
  end
  point = scene_point(scene, r, beta);
  unknown = setdiff(varargin, {'phases', 'from_ground'});
  if ~isempty(unknown)
    error('denhartog:input', 'what is wanted besides must be phases or from_ground, but is %s', unknown{1});
  end
  asked = @(name) double(any(strcmp(name, varargin)));
  raw = denhartog_mex('map', point.text, point.r, point.beta, point.mu, masses, asked('phases'), asked('from_ground'));
  shape = size(raw.regime);
  if isempty(masses)
    masses = 1:(numel(raw.amplitude) / numel(raw.regime));
  end
  map = struct('r', reshape(r, 1, []), 'beta', reshape(beta, 1, []), 'masses', reshape(masses, 1, []));
  map.regime = counted(raw.regime, shape);
  map.status = double(raw.status);
  map.stops = counted(raw.stops, shape);
  map.periods = counted(raw.periods, shape);
  map.amplitude = reshape(raw.amplitude, shape(1), shape(2), []);
  if isfield(raw, 'phase')
    map.phase = reshape(raw.phase, shape(1), shape(2), []);
  end
  names = names_of('regime');
  map.regime_names = names(1:3);
  map.status_names = names_of('status');
end
