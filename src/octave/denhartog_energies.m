function found = denhartog_energies(scene, r, beta, digits)
% DENHARTOG_ENERGIES  What a steady motion dissipates in a period of the force, and the forces that it hands over.
%   found = denhartog_energies(scene)                   at the scene's own frequency and friction
%   found = denhartog_energies(scene, r, beta, digits)  at a frequency ratio r and a friction ratio beta, [] for the scene's
%                                                       own, to so many significant digits, 1 to 15; 0 for 6
%
%   Every number is proved, in every regime; each has the bound of its error in a field of the same name and _error.
%     contact, dampers    energies that friction and the dampers dissipate, in units of P^2 / k_1; means where the motion is
%                         longer than a period of the force
%     friction            the largest friction force, in units of P
%     on_base             the largest force of springs and dampers on the base, without a constant load, in units of P
%     equivalent_damping  c = W / (pi omega X^2) with the energy W and the amplitude X of the contact, in units of
%                         sqrt(k_1 m_1); equivalent_damping_ratio is c / (2 sqrt(k_1 m_1))
%     textbook_contact    4 F X; textbook_contact_off is by what part of contact it is off
%     textbook_amplitude  X by a dashpot 4 F / (pi omega X) in place of friction, in units of P / k_1;
%                         textbook_amplitude_off is by what part of the amplitude it is off
%   NaN says that there is no such number: of a contact at rest, and of an amplitude where friction is too large for that.
%     dimensional         of a dimensional scene at its own point: contact, dampers, friction, on_base and
%                         equivalent_damping in the units of the scene
  if nargin < 2, r = []; end
  if nargin < 3, beta = []; end
  if nargin < 4, digits = 0; end
  point = scene_point(scene, r, beta);
  found = denhartog_mex('energies', point.text, point.r, point.beta, point.mu, digits);
  if isempty(point.units), return; end
  P = point.units.force;
  damping = P * point.r / (point.units.length * point.units.omega);
  found.dimensional = struct('contact', P * point.units.length * found.contact, ...
                             'dampers', P * point.units.length * found.dampers, 'friction', P * found.friction, ...
                             'on_base', P * found.on_base, 'equivalent_damping', damping * found.equivalent_damping);
end
