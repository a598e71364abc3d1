# Reads the pack and says of each scene how far the contact goes at the 64 instants: julia read.jl FOLDER
using Printf

table(name) = begin
    lines = [split(line, ',') for line in eachline(joinpath(ARGS[1], name))]
    [Dict(zip(lines[1], cells)) for cells in lines[2:end]]
end
scenes, events, samples = table("scenes.csv"), table("events.csv"), table("samples.csv")
for s in scenes
    # lists have spaces: m = parse.(Float64, split(s["m"])) and so for k, c, c_ground, amplitude
    j = s["contact"]
    mine = only(row for row in samples if row["scene"] == s["scene"] && row["mass"] == j)
    x, v = parse.(Float64, split(mine["x"])), parse.(Float64, split(mine["v"])) # at t = (0:63) * period / 64
    stops = count(e -> e["scene"] == s["scene"] && e["what"] == "stops", events)
    @printf("%s %s %s %d %.17g %.17g\n", s["scene"], s["masses"], s["regime"], stops, maximum(abs.(x)), maximum(abs.(v)))
end
