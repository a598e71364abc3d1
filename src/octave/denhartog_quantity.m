function [values, errors] = denhartog_quantity(scene, name, mass, r, beta, tau, samples)
% DENHARTOG_QUANTITY  Any quantity of the conformance kit by its name, and the bounds of its errors.
%   [values, errors] = denhartog_quantity(scene, name, mass)           at the scene's own frequency and friction
%   [values, errors] = denhartog_quantity(scene, name, mass, r, beta)  at a frequency ratio r and a friction ratio beta
%   [values, errors] = denhartog_quantity(scene, name, mass, r, beta, tau, samples)
%
%   name     as on the page of the protocol, such as 'first_damping_function' or 'stop_durations'
%   mass     from 1; of no meaning for a quantity of no mass
%   tau      an instant, for 'displacement' alone
%   samples  instants in the period, for 'motion_under_force' alone
%   values   a row of numbers in the units of the protocol; regimes are 0 to 2 in their order
%   errors   as many bounds
%   An error says if there is no quantity of this name, or none at this point, such as the phase of a mass at rest.
  if nargin < 3, mass = 1; end
  if nargin < 4, r = []; end
  if nargin < 5, beta = []; end
  if nargin < 6, tau = 0; end
  if nargin < 7, samples = 400; end
  point = scene_point(scene, r, beta);
  found = denhartog_mex('quantity', point.text, point.r, point.beta, point.mu, name, mass, tau, samples);
  values = found.values;
  errors = found.errors;
end
