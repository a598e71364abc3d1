function [x, x_error] = denhartog_place_of_rest(scene)
% DENHARTOG_PLACE_OF_REST  Where the constant load of a scene, static_load, holds the masses.
%   [x, x_error] = denhartog_place_of_rest(scene)   N places in units of P / k_1, and the proved bounds of their errors
%
%   Displacements of every motion count from there. Without a constant load they are 0.
  raw = denhartog_mex('place_of_rest', denhartog_json(scene));
  x = raw.x;
  x_error = raw.x_error;
end
