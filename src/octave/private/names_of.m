function names = names_of(what, codes, shape)
% NAMES_OF  The names of the regimes, 0 to 2, or of what became of a point, 0 to 4, as a cell array; the last stands for -1.
%   With codes of points: their names in a cell array of a shape, or the name of the only one.
  if strcmp(what, 'regime')
    names = {'continuous', 'stick_slip', 'permanent_sticking', 'none'};
  else
    names = {'answered', 'on_boundary', 'not_converged', 'at_a_pole', 'failed'};
  end
  if nargin < 2
    return
  end
  codes = double(codes);
  codes(codes < 0) = numel(names) - 1;
  names = reshape(names(codes + 1), shape);
  if isscalar(names)
    names = names{1};
  end
end
