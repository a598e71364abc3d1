function text = denhartog_json(scene)
% DENHARTOG_JSON  The text of a scene in JSON.
%   text = denhartog_json(scene)
%
%   scene  a struct with the keys of a scene as its fields, or text in JSON, which is given back as it is.
%
%   A number stays a number, a vector becomes a list, a matrix a list of its rows. A cell array becomes a list of any
%   length, one included. Numbers are written with 17 digits, so that the library reads the same doubles. Numbers given
%   as text, such as '0.1', stay text. A struct, such as struct('direction', w) of a contact, stays an object. A field "comment" is left out.
  if is_text(scene)
    text = reshape(char(scene), 1, []);
    return
  end
  if ~isstruct(scene) || numel(scene) ~= 1
    error('denhartog:input', 'the scene must be one struct, or text in JSON');
  end
  keys = setdiff(fieldnames(scene), {'comment'}, 'stable');
  members = cell(1, numel(keys));
  for k = 1:numel(keys)
    members{k} = ['"', keys{k}, '":', value_text(keys{k}, scene.(keys{k}))];
  end
  text = ['{', strjoin(members, ','), '}'];
end

function text = value_text(key, value)
  if is_text(value)
    text = jsonencode(char(value));
  elseif isstruct(value) && numel(value) == 1
    text = denhartog_json(value); % the direction of a contact
  elseif iscell(value)
    text = list(cellfun(@(each) value_text(key, each), reshape(value, 1, []), 'UniformOutput', false));
  elseif ~(isnumeric(value) || islogical(value)) || ndims(value) > 2
    error('denhartog:input', '"%s" must be a number, a vector, a matrix, a cell array or text', key);
  elseif ~isreal(value) || any(~isfinite(value(:)))
    error('denhartog:input', '"%s" must be real and finite', key);
  else
    text = numbers_text(key, full(double(value)));
  end
end

function text = numbers_text(key, x)
  is_matrix = any(strcmp(key, {'mass_matrix', 'stiffness_matrix', 'damping_matrix'})) || all(size(x) > 1);
  if is_matrix && ~isempty(x)
    text = list(cellfun(@row, num2cell(x, 2)', 'UniformOutput', false));
  elseif isscalar(x)
    text = sprintf('%.17g', x);
  else
    text = row(x);
  end
end

function text = row(x)
  text = list({strjoin(arrayfun(@(each) sprintf('%.17g', each), reshape(x, 1, []), 'UniformOutput', false), ',')});
end

function text = list(items)
  text = ['[', strjoin(items, ','), ']'];
end

function yes = is_text(value)
  yes = ischar(value) || (isa(value, 'string') && isscalar(value));
end
