function need_point(point, needs_beta)
% NEED_POINT  Fails where neither the call nor the scene has a frequency, or a friction where that is needed.
  if isempty(point.r)
    error('denhartog:input', 'the frequency is missing: give r, or a scene with r, frequency or frequency_hz');
  end
  if needs_beta && isempty(point.beta)
    error('denhartog:input', 'the friction is missing: give r and beta, or a scene with beta, or with friction and force');
  end
end
