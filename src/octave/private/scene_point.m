function point = scene_point(scene, r, beta, needs_beta)
% SCENE_POINT  The text of a scene, its mu, and the point asked for: r and beta as given, or the scene's own where both are [].
%   Fields: text, mu, r, beta, and units, a struct with omega, length (P / k_1) and force; [] where the point is given or
%   the scene is not dimensional. Fails where there is no frequency, or no friction unless needs_beta is false.
  point = struct('text', denhartog_json(scene), 'mu', 1, 'r', r, 'beta', beta, 'units', []);
  own = isempty(r) && isempty(beta);
  if ~isstruct(scene)
    try
      scene = jsondecode(point.text);
    catch
      scene = [];
    end
  end
  if own || ~isstruct(scene)
    denhartog_mex('natural_frequencies', point.text); % says what is wrong with the scene
  end
  if isfield(scene, 'mu')
    point.mu = value_of(scene, 'mu');
  end
  if own && isfield(scene, 'masses')
    point = dimensional_point(point, scene);
  elseif own
    point.r = value_of(scene, 'r');
    point.beta = value_of(scene, 'beta');
  end
  if isempty(point.r)
    error('denhartog:input', 'the frequency is missing: give r, or a scene with r, frequency or frequency_hz');
  end
  if isempty(point.beta) && (nargin < 4 || needs_beta)
    error('denhartog:input', 'the friction is missing: give r and beta, or a scene with beta, or with friction and force');
  end
end

function point = dimensional_point(point, scene)
  m_1 = value_of(scene, 'masses');
  k_1 = value_of(scene, 'stiffnesses');
  omega = value_of(scene, 'frequency');
  if isempty(omega)
    omega = 2 * pi * value_of(scene, 'frequency_hz');
  end
  point.r = omega * sqrt(m_1 / k_1);
  P = value_of(scene, 'force');
  X = value_of(scene, 'base_displacement');
  A = value_of(scene, 'base_acceleration');
  together = isfield(scene, 'base_motion') && strcmp(scene.base_motion, 'with_wall');
  if ~isempty(A) && together
    P = m_1 * A;
  elseif ~isempty(A)
    P = k_1 * A / omega ^ 2;
  elseif ~isempty(X) && together
    P = m_1 * omega ^ 2 * X;
  elseif ~isempty(X)
    P = k_1 * X;
  end
  if ~isempty(P)
    point.beta = value_of(scene, 'friction') / P;
  end
  if ~isempty(P) && ~isempty(omega)
    point.units = struct('omega', omega, 'length', P / k_1, 'force', P);
  end
end

% The first number of a list, a matrix, a cell array or a text; [] where the scene has none.
function x = value_of(scene, key)
  x = [];
  if ~isfield(scene, key)
    return
  end
  value = scene.(key);
  while iscell(value) && ~isempty(value)
    value = value{1};
  end
  if ischar(value) || isa(value, 'string')
    x = str2double(value);
  elseif (isnumeric(value) || islogical(value)) && ~isempty(value)
    x = double(value(1));
  else
    x = NaN;
  end
end
