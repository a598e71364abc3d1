function names = names_of(what)
% NAMES_OF  The names of the regimes, 0 to 2, or of what became of a point, 0 to 4, as a cell array; the last stands for -1.
  if strcmp(what, 'regime')
    names = {'continuous', 'stick_slip', 'permanent_sticking', 'none'};
  else
    names = {'answered', 'on_boundary', 'not_converged', 'at_a_pole', 'failed'};
  end
end
