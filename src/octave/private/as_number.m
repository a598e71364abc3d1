function x = as_number(value)
% AS_NUMBER  The first number of a list, a matrix, a cell array or a text; NaN where there is none.
  while iscell(value) && ~isempty(value)
    value = value{1};
  end
  if ischar(value) || isa(value, 'string')
    x = str2double(value);
  elseif (isnumeric(value) || islogical(value)) && ~isempty(value)
    x = double(value(1));
  else
    x = NaN;
  end
end
