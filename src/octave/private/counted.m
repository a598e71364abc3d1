function x = counted(counts, shape)
% COUNTED  Whole numbers of the library as doubles; NaN in place of -1, which says that there is no number.
  x = reshape(double(counts), shape);
  x(x < 0) = NaN;
end
