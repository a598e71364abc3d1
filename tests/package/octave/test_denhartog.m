% Tests the functions for Octave against the program. The environment variable DENHARTOG_PROGRAM names the program.
% They are sentences: each is printed when it has been found true, and the first that is not ends the script.
1;

function text = program(command, scene, options)
  file = [tempname(), '.json'];
  id = fopen(file, 'w');
  fputs(id, scene);
  fclose(id);
  [status, text] = system(sprintf('"%s" %s "%s" %s', getenv('DENHARTOG_PROGRAM'), command, file, options));
  unlink(file);
  assert(status, 0);
end

function answer = solved(scene)
  text = program('solve', denhartog_json(scene), '--json');
  answer = jsondecode(strrep(text, '"end"', '"finish"')); % a word of the language names no field
end

% One number of each mass or stop; NaN where it has none, as a mass at rest has no phase.
function row = each(list, key)
  if isstruct(list)
    list = num2cell(list);
  end
  row = NaN(1, numel(list));
  for k = 1:numel(list)
    if isfield(list{k}, key)
      row(k) = list{k}.(key);
    end
  end
end

function close_to(found, wanted)
  assert(size(found), size(wanted));
  assert(isnan(found), isnan(wanted));
  number = ~isnan(wanted);
  assert(all(abs(found(number) - wanted(number)) <= 1e-12 * max(1, abs(wanted(number)))));
end

function says(identifier, part, call)
  caught = [];
  try
    call();
  catch caught
  end
  assert(~isempty(caught), 'there was no error');
  assert(caught.identifier, identifier);
  assert(~isempty(strfind(caught.message, part)), caught.message);
end

function same_as_program(scene)
  mine = denhartog_solve(scene);
  theirs = solved(scene);
  masses = theirs.masses;
  close_to([mine.r, mine.beta], [theirs.r, theirs.beta]);
  assert(mine.regime, theirs.regime);
  assert(mine.status, 'answered');
  close_to(mine.amplitude, each(masses, 'amplitude'));
  close_to(mine.amplitude_error, each(masses, 'error_bound'));
  close_to(mine.phase, each(masses, 'phase'));
  close_to(mine.phase_error, each(masses, 'phase_error_bound'));
  assert(mine.periods, theirs.periods);
  assert(isfield(theirs, 'rest_interval'), ~isempty(mine.rest_interval));
  if isfield(theirs, 'rest_interval')
    close_to(mine.rest_interval, [theirs.rest_interval.from, theirs.rest_interval.to]);
    assert(mine.stops, 0);
  else
    assert(mine.stops, theirs.stops_per_period);
  end
  if mine.stops > 0
    close_to(mine.stop_start, each(theirs.stops, 'start'));
    close_to(mine.stop_end, each(theirs.stops, 'finish'));
    close_to(mine.stop_start_error, each(theirs.stops, 'start_error_bound'));
    close_to(mine.stop_end_error, each(theirs.stops, 'end_error_bound'));
  end
  assert(mine.unique, theirs.unique);
  if isfield(theirs, 'dimensional')
    units = theirs.dimensional;
    close_to(mine.dimensional.amplitude, each(units.masses, 'amplitude'));
    close_to(mine.dimensional.amplitude_error, each(units.masses, 'error_bound'));
    for key = {'frequency', 'frequency_hz', 'force', 'friction', 'displacement_unit'}
      close_to(mine.dimensional.(key{1}), units.(key{1}));
    end
    if isfield(units, 'rest_interval')
      close_to(mine.dimensional.rest_interval, [units.rest_interval.from, units.rest_interval.to]);
    end
    if mine.stops > 0
      close_to(mine.dimensional.stop_start, each(units.stops, 'start'));
      close_to(mine.dimensional.stop_end, each(units.stops, 'finish'));
      close_to(mine.dimensional.stop_start_error, each(units.stops, 'start_error_bound'));
      close_to(mine.dimensional.stop_end_error, each(units.stops, 'end_error_bound'));
    end
  else
    assert(~isfield(mine, 'dimensional'));
  end
end

function [regime, stops, periods, amplitude, status] = program_map(options, scene)
  lines = strsplit(strtrim(program('map', denhartog_json(scene), options)), "\n");
  cells = cellfun(@(line) strsplit(line, ','), lines(2:end), 'UniformOutput', false);
  cells = vertcat(cells{:});
  regime = cells(:, 3);
  [stops, periods] = deal(str2double(cells(:, 4)), str2double(cells(:, 5)));
  amplitude = str2double(cells(:, 6:end - 1));
  status = cells(:, end);
end

chain = struct('mass_ratios', [1, 2.5, 0.75], 'stiffness_ratios', [1, 0.625, 1.875], 'damping_ratios', [0.03, 0.06, 0.09], ...
               'contact', 2, 'load', 1, 'mu', 1.375, 'r', 1.125, 'beta', 0.15625);
one = struct('mass_ratios', 1, 'stiffness_ratios', 1, 'damping_ratios', 0.01, 'contact', 1, 'load', 1, 'r', 0.1, 'beta', 0.2);
undamped = setfield(one, 'damping_ratios', 0);
frame = struct('masses', [12, 11.5, 9.8], 'stiffnesses', [18500, 17200, 16900], 'damping_ratios', [0.012, 0.009, 0.011], ...
               'contact', [2, 1], 'base_motion', 'with_wall', 'base_displacement', 0.002, 'friction', 6.5, 'frequency_hz', 2.6);
matrices = struct('mass_matrix', [1, 0.25; 0.25, 2], 'stiffness_matrix', [1, -0.5; -0.5, 0.75], 'damping_ratios', 0.05, ...
                  'contact', 2, 'load', [1, 0.5], 'r', 0.75, 'beta', 0.3);

same_as_program(chain);
same_as_program(setfield(chain, 'beta', 0.9));
same_as_program(setfield(chain, 'beta', 2));
printf("a chain in every regime has the program's numbers\n");

same_as_program(one);
same_as_program(setfield(one, 'load', {1}));
assert(denhartog_json(struct('load', {{1}}, 'contact', 1)), '{"load":[1],"contact":1}');
printf("a chain of one mass has the program's numbers, and a list of one number is a cell array\n");

same_as_program(matrices);
assert(denhartog_json(struct('mass_matrix', [1, 2; 3, 4], 'damping_matrix', 5)), ...
       '{"mass_matrix":[[1,2],[3,4]],"damping_matrix":[[5]]}');
same_as_program(struct('masses', 3, 'stiffnesses', 100, 'damping_matrix', 0.5, 'contact', 1, 'load', 1, 'force', 2, ...
                       'friction', 0.7, 'frequency', 4));
printf("matrices are written row by row, that of one mass too\n");

same_as_program(frame);
same_as_program(setfield(frame, 'friction', 1));
same_as_program(setfield(frame, 'friction', 60));
absolute = rmfield(setfield(frame, 'base_motion', 'alone'), {'frequency_hz'});
same_as_program(setfield(setfield(absolute, 'damping_ratios', 0), 'frequency', 16));
pushed = setfield(setfield(rmfield(frame, {'base_motion', 'base_displacement'}), 'load', [0, 0, 1]), 'force', 8);
same_as_program(setfield(pushed, 'masses', diag([12, 11.5, 9.8])));
same_as_program(setfield(rmfield(frame, 'damping_ratios'), 'damping_matrix', [40, 0, 0; 0, 65, -65; 0, -65, 65]));
same_as_program(setfield(absolute, 'frequency', 16));
wall = setfield(rmfield(setfield(absolute, 'base_motion', 'wall'), 'base_displacement'), 'base_acceleration', 0.5);
same_as_program(setfield(setfield(wall, 'contact', 2), 'frequency', 16));
same_as_program(setfield(rmfield(setfield(frame, 'base_acceleration', 0.5), 'base_displacement'), 'friction', 1));
seen = denhartog_solve(frame);
assert(seen.transmissibility, seen.absolute_amplitude * seen.r ^ 2, 1e-9);
assert(numel(seen.absolute_phase), 3);
assert(! isfield(denhartog_solve(chain), 'transmissibility'));
same_as_program(setfield(setfield(chain, 'load', [1, 0.5, 0.25]), 'load_phases', [0, 1.25, -2]));
printf("a dimensional scene has the program's numbers in its own units, under a force and on a base that moves\n");

assert(denhartog_json(struct('beta', 0.1 + 0.2)), '{"beta":0.30000000000000004}');
assert(denhartog_json(struct('comment', {{1}}, 'beta', '0.1', 'contact', int32(2))), '{"beta":"0.1","contact":2}');
text = denhartog_json(frame);
assert(denhartog_solve(text).amplitude, denhartog_solve(frame).amplitude, 1e-12);
printf("numbers are written to the last bit, and text in JSON is a scene as well\n");

r = [0.4, 0.9, 1.125; 1.4, 2, 0.1];
beta = [0.1, 0.9, 0.15625; 2, 0.05, 0.3];
many = denhartog_solve(chain, r, beta);
assert(size(many.regime), size(r));
for n = 1:numel(r)
  single = denhartog_solve(chain, r(n), beta(n));
  assert(many.regime{n}, single.regime);
  assert(many.status{n}, single.status);
  assert([many.r(n), many.beta(n), many.stops(n), many.periods(n)], [single.r, single.beta, single.stops, single.periods]);
  for key = {'amplitude', 'amplitude_error', 'phase', 'phase_error'}
    close_to(many.(key{1})(n, :), single.(key{1}));
  end
end
along = denhartog_solve(chain, r(:), 0.3);
assert(along.beta, 0.3 * ones(6, 1));
close_to(along.amplitude(2, :), denhartog_solve(chain, r(2), 0.3).amplitude);
assert(denhartog_solve(chain, 1.125, [0.1; 0.2; 0.9]).r, [1.125; 1.125; 1.125]);
assert(all(denhartog_solve(chain, 1, 0.9, 12).amplitude_error <= 1e-12 * max(denhartog_solve(chain, 1, 0.9).amplitude)));
printf("an array of points has the numbers of its points one by one, and one number serves all\n");

for scene = {chain, setfield(chain, 'beta', 0.9), frame}
  plain = denhartog_solve(scene{1});
  assert(plain.proved, false);
  try
    proof = denhartog_solve(scene{1}, [], [], 0, true);
  catch caught
    assert(~isempty(strfind(caught.message, 'DENHARTOG_REFERENCE=OFF')), caught.message);
    says('denhartog:precision', 'DENHARTOG_REFERENCE=OFF', @() denhartog_solve(scene{1}, [], [], 0, true));
    continue
  end
  assert(proof.proved, true);
  assert({proof.regime, proof.stops}, {plain.regime, plain.stops});
  assert(all(abs(proof.amplitude - plain.amplitude) <= proof.amplitude_error + plain.amplitude_error));
  assert(all(proof.amplitude_error <= 1e-15 * max(proof.amplitude)));
end
says('denhartog:input', 'point by point', @() denhartog_solve(chain, [1, 2], 0.1, 0, true));
printf("a proved solution is the other one within both bounds, and says that it is proved\n");

map = denhartog_map(chain, linspace(0.5, 1.5, 5), linspace(0, 1.2, 4), [3, 1]);
[regime, stops, periods, amplitude, status] = program_map('--r 0.5:1.5:5 --beta 0:1.2:4 --mass 3 --mass 1', chain);
assert(size(map.regime), [4, 5]);
assert(size(map.amplitude), [4, 5, 2]);
assert(map.regime_names(map.regime(:) + 1)', regime);
assert(map.status_names(map.status(:) + 1)', status);
assert([map.stops(:), map.periods(:)], [stops, periods]);
close_to(reshape(map.amplitude, [], 2), amplitude);
assert(numel(unique(regime)), 3);
whole = denhartog_map(chain, linspace(0.5, 1.5, 5), linspace(0, 1.2, 4));
assert(whole.masses, 1:3);
assert(whole.amplitude(:, :, [3, 1]), map.amplitude);
assert(size(denhartog_map(one, 0.1, 0.2).amplitude), [1, 1]);
close_to(denhartog_map(one, 0.1, 0.2).amplitude, denhartog_solve(one).amplitude);
function phase = program_phases(options, scene)
  lines = strsplit(strtrim(program('map', denhartog_json(scene), options)), "\n");
  column = find(strcmp(strsplit(lines{1}, ','), 'phase_1'));
  phase = cellfun(@(line) str2double(strsplit(line, ','){column}), lines(2:end))';
end
seen = denhartog_map(chain, linspace(0.5, 1.5, 5), linspace(0, 1.2, 4), 1, 'phases');
close_to(seen.phase(:), program_phases('--r 0.5:1.5:5 --beta 0:1.2:4 --mass 1 --phases', chain));
close_to(seen.amplitude, map.amplitude(:, :, 2));
absolute = denhartog_map(frame, linspace(0.3, 0.6, 4), [0.1, 0.4], 1, 'from_ground', 'phases');
close_to(absolute.phase(:), program_phases('--r 0.3:0.6:4 --beta 0.1:0.4:2 --mass 1 --phases --from-ground', frame));
close_to(absolute.amplitude(1, 1), denhartog_solve(frame, 0.3, 0.1).absolute_amplitude(1));
says('denhartog:input', 'must be phases or from_ground', @() denhartog_map(chain, 1, 0.1, 1, 'everything'));
says('denhartog:input', 'base', @() denhartog_map(chain, 1, 0.1, 1, 'from_ground'));
printf("a map has the program's phases and absolute displacements\n");

pole = denhartog_map(undamped, [0.5, 1], [0, 0.1]);
assert(pole.status_names{pole.status(1, 2) + 1}, 'at_a_pole');
assert(isnan(pole.amplitude), logical([0, 1; 0, 1]));
assert(isnan(pole.regime) & isnan(pole.stops) & isnan(pole.periods), logical([0, 1; 0, 1]));
printf("a map is beta by r by masses and has the program's numbers, and none at a pole\n");

lever = struct('masses', [20, 12, 8], 'stiffnesses', [9000, 6000, 4000], 'damping_ratios', 0.02, 'load', 3, 'force', 40, ...
               'friction', 12, 'frequency_hz', 2);
lever.contact = struct('direction', [-0.5, 1, 0]);
same_as_program(lever);
same_as_program(struct('mass_ratios', 1, 'stiffness_ratios', 1, 'damping_ratios', 0.05, 'load', 1, 'r', 0.75, 'beta', 0.125, ...
                       'contact', struct('direction', 1)));
printf("a contact may have any direction\n");

near_pole = setfield(setfield(undamped, 'r', 1 - 2^-45), 'beta', 0.125);
assert(denhartog_solve(near_pole).warning, solved(near_pole).warning);
assert(isempty(denhartog_solve(chain, 1, 0.1).warning));
printf("an answer has the program's warning\n");

for scene = {chain, one, frame}
  [tau, x, v] = denhartog_motion(scene{1}, [], [], 32);
  lines = strsplit(strtrim(program('solve', denhartog_json(scene{1}), '--samples 32')), "\n");
  table = str2double(vertcat(cellfun(@(line) strsplit(line, ','), lines(2:end), 'UniformOutput', false){:}));
  close_to([tau, x, v], table);
end
[tau, x] = denhartog_motion(one, 0.1, 0.2);
assert(numel(tau), 256);
assert(max(abs(x)), denhartog_solve(one).amplitude, 1e-4);
printf("a motion has the program's instants, displacements and velocities\n");

at = linspace(0.3, 2.1, 7);
limits = denhartog_boundary(chain, at);
lines = strsplit(strtrim(program('map', denhartog_json(chain), '--r 0.3:2.1:7 --boundaries')), "\n");
cells = vertcat(cellfun(@(line) strsplit(line, ','), lines(2:end), 'UniformOutput', false){:});
close_to([limits.r', limits.exact', limits.paper', limits.approximate', limits.sticking'], str2double(cells(:, 1:5)));
assert(limits.status', cells(:, 6));
own = denhartog_boundary(frame);
theirs = solved(frame);
close_to([own.exact, own.paper, own.sticking], [theirs.beta_lim.exact, theirs.beta_lim.paper, theirs.beta_lim.sticking]);
bounds = theirs.beta_lim_error_bounds;
assert([own.exact_error, own.sticking_error] < 1e-9 * [own.exact, own.sticking]);
assert([bounds.exact, bounds.sticking] < 1e-5 * [own.exact, own.sticking]);
assert([own.exact_error, own.paper_error, own.approximate_error, own.sticking_error] > 0);
limit = theirs.dimensional.friction_limit;
close_to([own.dimensional.exact, own.dimensional.sticking], [limit.exact, limit.sticking]);
pole = denhartog_boundary(undamped, [0.5, 1]);
assert(pole.status, {'answered', 'at_a_pole'});
assert(isnan([pole.exact, pole.sticking(2), pole.exact_error]), logical([0, 1, 1, 0, 1]));
printf("boundaries have the program's numbers, as ratios and as friction forces\n");

[r_n, zeta, r_n_error, zeta_error] = denhartog_natural_frequencies(frame);
modes = jsondecode(program('functions', denhartog_json(frame), '--json')).modes;
bounds = [modes.error_bounds];
assert(r_n_error, [bounds.natural_frequency_ratio], -1e-12);
assert(zeta_error, [bounds.zeta], -1e-12);
close_to(denhartog_natural_frequencies(setfield(one, 'damping_ratios', 0.5)), 1);
lambda = sort(eig([35700, -17200, 0; -17200, 34100, -16900; 0, -16900, 16900], diag([12, 11.5, 9.8])));
assert(r_n, sqrt(lambda' * 12 / 18500), 1e-12);
assert(zeta, [0.012, 0.009, 0.011], 1e-15);
assert(~isempty(regexp(denhartog_mex('version'), '^\d+\.\d+\.\d+$')));
printf("natural frequencies are those of the eigenproblem\n");

says('denhartog:input', 'did you mean masses?', @() denhartog_solve(struct('mases', 1)));
says('denhartog:input', 'must be JSON', @() denhartog_solve('{"contact": 1', 1, 0));
says('denhartog:input', 'must be JSON', @() denhartog_solve('{"contact": 1'));
says('denhartog:input', 'r must', @() denhartog_solve(chain, -1, 0.1));
says('denhartog:input', 'beta must', @() denhartog_solve(chain, [1, 2], [0.1, -0.1]));
says('denhartog:input', 'mu must', @() denhartog_solve(setfield(chain, 'mu', 0.5)));
says('denhartog:input', 'r must be real', @() denhartog_solve(chain, 1 + 2i, 0.1));
says('denhartog:input', 'frequency is missing', @() denhartog_solve(rmfield(chain, {'r', 'beta'})));
says('denhartog:input', 'friction is missing', @() denhartog_solve(rmfield(chain, 'beta')));
says('denhartog:input', 'digits must', @() denhartog_solve(chain, 1, 0.1, 2.5));
says('denhartog:input', '"masses" must be real and finite', @() denhartog_solve(setfield(frame, 'masses', [1, NaN, 2])));
says('denhartog:input', 'must be one struct', @() denhartog_json(5));
says('denhartog:input', 'masses must be', @() denhartog_map(chain, 1, 0.1, 4));
says('denhartog:input', 'a map needs r and beta', @() denhartog_map(chain, [], []));
says('denhartog:input', 'first argument', @() denhartog_mex('solve', '{}'));
says('denhartog:input', 'first argument', @() denhartog_mex(1));
says('denhartog:input', 'text in JSON', @() denhartog_mex('natural_frequencies', 1));
says('denhartog:input', 'zero character', @() denhartog_solve([denhartog_json(chain), char(0)], 1, 0.1));
says('denhartog:size', 'the same size', @() denhartog_solve(chain, [1, 2], [0.1, 0.2, 0.3]));
says('denhartog:size', 'the same size', @() denhartog_solve(chain, [1, 2], [0.1; 0.2]));
says('denhartog:size', 'samples must', @() denhartog_motion(chain, 1, 0.1, 1e12));
says('denhartog:domain', 'no damping and R = 1', @() denhartog_solve(undamped, 1, 0));
says('denhartog:domain', 'no damping and R = 1', @() denhartog_boundary(undamped, 1));
says('denhartog:precision', 'work allowed is spent', @() denhartog_solve(one, 1e-12, 0.2));
assert(denhartog_solve(chain).status, 'answered');
printf("errors have an identifier and the library's words, and the next call is well\n");

linear = struct('mass_ratios', 1, 'stiffness_ratios', 1, 'damping_ratios', 0.1, 'contact', 1, 'load', 1, 'r', 1, 'beta', 0);
found = denhartog_find(linear, 'r', [0.05, 3], 'amplitude of mass 1 = 2', 16);
half = 1 - 2 * 0.1^2; % (1 - s)^2 + 4 zeta^2 s = 1 / 4 of s = r^2
close_to(found.at, sqrt(half + [-1; 1] * sqrt(half^2 - 0.75)));
assert(double(found.is), [0; 0]);
assert(all(found.from <= found.at & found.at <= found.to));
assert(found.unanswered, 0);
says('denhartog:input', 'vary must', @() denhartog_find(linear, 'omega', [1, 2], 'amplitude of mass 1 = 2'));
says('denhartog:input', 'so-that must', @() denhartog_find(linear, 'r', [1, 2], 'phase'));
says('denhartog:input', 'two numbers', @() denhartog_find(linear, 'r', 1, 'amplitude of mass 1 = 2'));
says('denhartog:input', 'samples must', @() denhartog_find(linear, 'r', [1, 2], 'amplitude of mass 1 = 2', 1));
printf("the inverse question has the textbook's roots\n");

alone = struct('mass_ratios', 1, 'stiffness_ratios', 1, 'damping_ratios', 0, 'contact', 1, 'load', 1, 'r', 1.75, 'beta', 0.25);
found = denhartog_energies(alone, [], [], 12);
X = denhartog_solve(alone, [], [], 12).amplitude;
close_to(found.contact, 4 * 0.25 * X);
close_to(found.equivalent_damping, 4 * 0.25 / (pi * 1.75 * X));
close_to(found.textbook_amplitude, sqrt(1 - (1 / pi)^2) / (1.75^2 - 1)); % Rao's formula
assert(found.contact_error < 1e-11);
resting = denhartog_energies(alone, 1.75, 2);
assert(isnan(resting.equivalent_damping) && resting.contact == 0);
says('denhartog:input', 'digits must', @() denhartog_energies(alone, 1.75, 2, 16));

decay = denhartog_free_decay(alone, 0.125, 1); % every half-period takes 2 F / k
close_to(decay.turn, pi * (1:4)');
close_to(1 + decay.turn_x, 1 + [-0.75; 0.5; -0.25; 0]);
assert(decay.at_rest);
assert(decay.others, 'not_known'); % there are none
past = denhartog_history(alone, 1, 0.125, 2, 'x', 1, 'samples', 4, 'load', false);
assert(size(past.x), [8, 1]);
close_to(past.x(3), -0.75);
[x, x_error] = denhartog_place_of_rest(setfield(alone, 'static_load', 0.5));
close_to(x, 0.5);
assert(x_error < 1e-12);
[X, X_error] = denhartog_quantity(alone, 'amplitude', 1, 1.75, 0.1);
close_to(X, denhartog_solve(alone, 1.75, 0.1, 12).amplitude);
assert(X_error < 1e-8);
assert(numel(denhartog_quantity(alone, 'motion_under_force', 1, 1.75, 0.1, 0, 8)), 8);
says('denhartog:domain', 'no quantity of this name', @() denhartog_quantity(alone, 'speed', 1, 1.75, 0.1));
says('denhartog:input', 'name must', @() denhartog_quantity(alone, 1, 1, 1.75, 0.1));
says('denhartog:input', 'mass must', @() denhartog_quantity(alone, 'amplitude', 2, 1.75, 0.1));
says('denhartog:size', 'samples must', @() denhartog_quantity(alone, 'amplitude', 1, 1.75, 0.1, 0, 0));
says('denhartog:size', 'one number for each mass', @() denhartog_free_decay(alone, 0.1, [1, 2]));
says('denhartog:input', 'beta must', @() denhartog_free_decay(alone, -0.1, 1));
says('denhartog:size', 'cycles, last and samples', @() denhartog_history(alone, 1, 0.1, 0));
says('denhartog:input', 'pairs of a name', @() denhartog_history(alone, 1, 0.1, 2, 'y', 1));
printf("energies are the textbook's, and a free decay loses 2 F / k every half-period\n");

page = fileread(fullfile(fileparts(mfilename('fullpath')), '..', '..', '..', 'docs', 'octave.md'));
examples = regexp(page, '```matlab\n(.*?)```\s*```text\n(.*?)```', 'tokens');
assert(numel(examples), 7);
clear scene frame motion limit map many undamped;
for example = examples
  assert(strtrim(evalc(example{1}{1})), strtrim(example{1}{2}));
end
printf("the examples in docs/octave.md print what stands there\n");
