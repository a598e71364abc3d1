function [tau, x, v] = denhartog_motion(scene, r, beta, samples)
% DENHARTOG_MOTION  The steady motion of all masses over its period, at equally spaced instants.
%   [tau, x, v] = denhartog_motion(scene)                    at the scene's own frequency and friction, 256 instants
%   [tau, x, v] = denhartog_motion(scene, [], [], samples)   so many instants
%   [tau, x, v] = denhartog_motion(scene, r, beta, samples)  at a frequency ratio r and a friction ratio beta
%
%   tau  instants from the maximum of the force, a column: omega t from 0 to 2 pi times the periods of the force in a
%        period of the motion, the end left out
%   x    displacements in units of P / k_1, samples by masses
%   v    their derivatives with respect to tau, likewise
%   A contact that rests for ever is taken to rest at zero. A point that has no answer is an error, as of denhartog_solve.
%   In the units of a dimensional scene: t = tau / dimensional.frequency, and dimensional.displacement_unit times x.
  if nargin < 2, r = []; end
  if nargin < 3, beta = []; end
  if nargin < 4, samples = 256; end
  point = scene_point(scene, r, beta);
  raw = denhartog_mex('motion', point.text, point.r, point.beta, point.mu, samples);
  tau = 2 * pi * raw.periods * (0:samples - 1)' / samples;
  x = raw.x';
  v = raw.v';
end
