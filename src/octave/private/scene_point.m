function point = scene_point(scene, r, beta)
% SCENE_POINT  The text of a scene, its mu, and the point asked for: r and beta as given, or the scene's own where both are [].
%   Fields: text, mu, r, beta, and units, a struct with omega, length (P / k_1) and force; [] where the point is given or
%   the scene is not dimensional.
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
    point.mu = as_number(scene.mu);
  end
  if ~own
    return
  end
  if ~isfield(scene, 'masses')
    point.r = value_of(scene, 'r');
    point.beta = value_of(scene, 'beta');
    return
  end
  m_1 = as_number(scene.masses);
  k_1 = as_number(scene.stiffnesses);
  if isfield(scene, 'frequency')
    omega = as_number(scene.frequency);
  elseif isfield(scene, 'frequency_hz')
    omega = 2 * pi * as_number(scene.frequency_hz);
  else
    omega = [];
  end
  point.r = omega * sqrt(m_1 / k_1);
  P = [];
  if isfield(scene, 'force')
    P = as_number(scene.force);
  elseif isfield(scene, 'base_displacement') && strcmp(scene.base_motion, 'alone')
    P = k_1 * as_number(scene.base_displacement);
  elseif isfield(scene, 'base_displacement')
    P = m_1 * omega ^ 2 * as_number(scene.base_displacement);
  end
  if ~isempty(P)
    point.beta = as_number(scene.friction) / P;
  end
  if ~isempty(P) && ~isempty(omega)
    point.units = struct('omega', omega, 'length', P / k_1, 'force', P);
  end
end

function x = value_of(scene, key)
  x = [];
  if isfield(scene, key)
    x = as_number(scene.(key));
  end
end
