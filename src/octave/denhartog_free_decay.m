function found = denhartog_free_decay(scene, beta, x, v, r, tau_end)
% DENHARTOG_FREE_DECAY  The motion from a start without the harmonic load, until the contact rests for good.
%   found = denhartog_free_decay(scene, beta, x)              from displacements x, N numbers
%   found = denhartog_free_decay(scene, beta, x, v, r, tau_end) with velocities v, at a frequency ratio r, no further than tau_end
%
%   P and the frequency are units and nothing more: r is 1 if it is not given. With r = 1 and beta = F / k_1 in metres,
%   displacements are in metres, and tau is omega_1 t with omega_1 = sqrt(k_1 / m_1). The constant load of a scene,
%   static_load, stays.
%
%   Every number is proved; each field has the bounds of its errors in one of the same name and _error.
%     turn, turn_x                  tau and the displacement of the contact where it turns; at the last it rests for good
%     stop_start, stop_end, stop_x  stops before that
%     at_rest                       true where the contact rests for good
%     rest_from, rest_at            tau from then on, and where; NaN where it does not
%     masses                        places of rest of all masses
%     others                        'come_to_rest', 'vibrate' for ever, or 'not_known': the other masses
%     on_limit                      true where the springs pull with static friction, to all digits
  if nargin < 4, v = []; end
  if nargin < 5 || isempty(r), r = 1; end
  if nargin < 6 || isempty(tau_end), tau_end = 0; end
  point = scene_point(scene, r, beta);
  found = denhartog_mex('free_decay', point.text, point.r, point.beta, point.mu, x, v, tau_end);
  names = {'come_to_rest', 'vibrate', 'not_known'};
  found.others = names{found.others + 1};
end
