function found = denhartog_history(scene, r, beta, cycles, varargin)
% DENHARTOG_HISTORY  The motion from a start at a maximum of the force: every stop of it, and its states.
%   found = denhartog_history(scene, r, beta, cycles)               from rest, over so many periods of the force; [] for the
%                                                                   scene's own r and beta
%   found = denhartog_history(scene, r, beta, cycles, Name, Value)  with
%     'x', 'v'    displacements in units of P / k_1 and velocities dx/dtau at the start, N numbers each
%     'last'      how many of the periods are wanted, at the end
%     'samples'   instants in a period at which the state is wanted
%     'load'      false to take the harmonic load away
%
%   Fields of the answer, whose errors are not known; tau counts from the start of the motion.
%     stop_start, stop_end, stop_x  every stop; the end is NaN of a rest that lasts to the end
%     tau, x, v                     instants, and displacements and velocities there, a row an instant
%     direction                     1 or -1 as the contact slides, 0 while it sticks
  options = struct('x', [], 'v', [], 'last', 0, 'samples', 0, 'load', true);
  for k = 1:2:numel(varargin)
    if k == numel(varargin) || ~ischar(varargin{k}) || ~isfield(options, varargin{k})
      error('denhartog:input', 'options must be pairs of a name (x, v, last, samples or load) and a value');
    end
    options.(varargin{k}) = varargin{k + 1};
  end
  point = scene_point(scene, r, beta);
  found = denhartog_mex('history', point.text, point.r, point.beta, point.mu, options.x, options.v, cycles, options.last, ...
                        options.samples, double(options.load));
  found.x = found.x';
  found.v = found.v';
  found.stop_end(found.stop_end < 0) = NaN;
end
