function [r_n, zeta, r_n_error, zeta_error] = denhartog_natural_frequencies(scene)
% DENHARTOG_NATURAL_FREQUENCIES  Natural frequency ratios omega_i sqrt(m_1 / k_1), ascending, and modal damping ratios.
%   [r_n, zeta, r_n_error, zeta_error] = denhartog_natural_frequencies(scene)
%
%   scene                  a struct or text in JSON, see denhartog_json
%   r_n                    a row, as many as masses
%   zeta                   likewise, Eq. (18)
%   r_n_error, zeta_error  bounds of their errors
  raw = denhartog_mex('natural_frequencies', denhartog_json(scene));
  r_n = raw.r_n;
  zeta = raw.zeta;
  r_n_error = raw.r_n_error;
  zeta_error = raw.zeta_error;
end
