function boundary = denhartog_boundary(scene, r)
% DENHARTOG_BOUNDARY  The friction ratios that part the regimes.
%   boundary = denhartog_boundary(scene)     at the scene's own frequency
%   boundary = denhartog_boundary(scene, r)  at frequency ratios r
%
%   Fields of the answer, each of the size of r:
%     r            the frequency ratios
%     exact        beta_lim, Eq. (69), with the maximum over tau of the sum over modes: below it the contact slides throughout
%     paper        (69) with (56), the sum of the maxima of the modes; never above exact
%     approximate  (67); never below exact
%     sticking     the smallest beta at which the contact never moves; NaN where no friction holds it
%     exact_error, paper_error, approximate_error, sticking_error: bounds of their errors
%     status       'answered'; 'at_a_pole' or 'failed' where there are no numbers. Text for one r, else a cell array
%   With its own frequency a dimensional scene with a force adds dimensional: these numbers and their bounds as friction
%   forces. To 10 digits. One r that has no answer is an error; among many it has its status, and NaN.
  if nargin < 2, r = []; end
  if isempty(r)
    point = scene_point(scene, [], [], false);
  else
    point = scene_point(scene, r, 0);
  end
  raw = denhartog_mex('boundary', point.text, point.r, point.mu);
  boundary = struct('r', point.r);
  kinds = {'exact', 'paper', 'approximate', 'sticking'};
  kinds = [kinds, strcat(kinds, '_error')];
  for k = 1:numel(kinds)
    boundary.(kinds{k}) = reshape(raw.(kinds{k}), size(point.r));
  end
  boundary.status = names_of('status', raw.status, size(point.r));
  if ~isempty(point.units)
    for k = 1:numel(kinds)
      boundary.dimensional.(kinds{k}) = point.units.force * boundary.(kinds{k});
    end
  end
end
