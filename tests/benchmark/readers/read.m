% Reads the pack and says of each scene how far the contact goes at the 64 instants: octave-cli read.m FOLDER
% From the CSV: jsondecode of Octave 7 rounds some numbers to a neighbour.
folder = argv(){1};
table = @(name) cellfun(@(line) strsplit(line, ",", "CollapseDelimiters", false), ...
                        strsplit(strtrim(fileread([folder "/" name])), "\n"), "UniformOutput", false);
column = @(rows, n) cellfun(@(row) row{n}, rows(2:end), "UniformOutput", false);
scenes = table("scenes.csv"); events = table("events.csv"); samples = table("samples.csv");
of = column(samples, 1); mass = str2double(column(samples, 2));
numbers = @(rows, n) cell2mat(cellfun(@(list) str2double(strsplit(list, " ")), column(rows, n), "UniformOutput", false)');
x = numbers(samples, 3); v = numbers(samples, 4);  % a row a mass, at t = (0:63) * period / 64
stops = column(events, 1)(strcmp(column(events, 4), "stops"));
names = scenes{1};
for n = 2:numel(scenes)
  s = cell2struct(scenes{n}, names, 2);  % lists have spaces: s.m, s.k, s.c, s.c_ground, s.amplitude
  mine = strcmp(of, s.scene) & mass == str2double(s.contact);
  printf("%s %s %s %d %.17g %.17g\n", s.scene, s.masses, s.regime, sum(strcmp(stops, s.scene)), ...
         max(abs(x(mine, :))), max(abs(v(mine, :))));
end
