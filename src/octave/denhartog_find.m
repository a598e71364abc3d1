function found = denhartog_find(scene, vary, between, so_that, samples)
% DENHARTOG_FIND  What a number of a scene has to be so that an amplitude is as wanted.
%   found = denhartog_find(scene, vary, between, so_that)
%   found = denhartog_find(scene, vary, between, so_that, samples)
%
%   vary is the key of the number that varies, such as 'friction'; of a list with the place, counted from 1, such as
%   'damping_ratios/2'. between has the two ends of its interval. so_that says what is wanted:
%     'amplitude of mass 2 = 0.075'
%     'amplitude of mass 2 is least'
%     'largest amplitude of mass 2 over frequency_hz 1:10 is least'
%   samples is the number of parts into which the interval is divided at first, 128 unless it is given.
%
%   Fields of the answer, a row each place: at, where it most likely is; from and to, the interval that holds it; amplitude and
%   error_bound, in the scene's unit of length, or in units of P / k_1; is, 0 crossing, 1 jump, 2 undecided, 3 extreme, 4 end of
%   the interval. unanswered counts values of the number at which no steady motion was certain. What lies between two samples
%   and shows at neither is not found.
  if nargin < 5, samples = 128; end
  found = denhartog_mex('find', denhartog_json(scene), vary, double(between), so_that, double(samples));
end
