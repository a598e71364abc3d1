// `denhartog map`: regimes and amplitudes over a grid of r and beta, or of frequency and a force, and the boundaries as curves,
// written to a file. Read `answer`; the axes may be given in ratios or in the units of the scene.
#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "denhartog/map/regime_map.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/program/output/result_files.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog::program {
namespace {

struct MapOptions : SceneOptions {
    std::string r, beta, frequency, frequency_hz, friction, force, unbalance, output;
    std::vector<long> masses;
    std::string start = "rest";
    bool boundaries = false;
    bool from_ground = false;
    bool phases = false;
    unsigned threads = 0;
};

constexpr double most_values = 10'000'000;

// Equally spaced values from a text FROM:TO:COUNT, both ends included.
std::vector<double> grid_values(const std::string& quantity, const std::string& text) {
    const InputError fault_of_form(quantity, "must be FROM:TO:COUNT, three numbers", text);
    if (std::ranges::count(text, ':') != 2) throw fault_of_form;
    const std::size_t first = text.find(':'), second = text.find(':', first + 1);
    const auto number = [&](const std::string& part) {
        double x = 0;
        if (part.empty()) throw fault_of_form;
        if (const NumberFault fault = number_from_text(part, x); fault != NumberFault::none)
            throw InputError(quantity, number_rule(fault), part);
        return x;
    };
    const double from = number(text.substr(0, first)), to = number(text.substr(first + 1, second - first - 1)),
                 count = number(text.substr(second + 1));
    if (!(count >= 1 && count <= most_values) || count != std::floor(count))
        throw InputError(quantity, "must have a whole COUNT from 1 to 10000000", text);
    if (to < from) throw InputError(quantity, "must have TO not below FROM", text);
    if (count == 1 && to != from) throw InputError(quantity, "must have TO equal to FROM where COUNT is 1", text);
    const auto last = static_cast<std::int64_t>(count) - 1;
    std::vector<double> values;
    for (std::int64_t n = 0; n <= last; ++n) {
        const double part = last == 0 ? 0 : static_cast<double>(n) / static_cast<double>(last);
        values.push_back(n == last ? to : from + (to - from) * part);
    }
    return values;
}

std::atomic<bool> stop{false};

void show_columns(std::size_t done, std::size_t columns) {
    static const bool on_terminal = ::isatty(STDERR_FILENO) != 0;
    if (!on_terminal) return;
    const std::size_t percent = 100 * done / columns;
    if (done != columns && percent == 100 * (done - 1) / columns) return;
    std::fprintf(stderr, "\r%3zu %% of %zu columns%s", percent, columns, done == columns ? "\n" : "");
}

// A scene whose force depends on a frequency that it lacks gets one of the map, which takes its place anyhow.
Scene<double> scene_of(const std::string& path, const std::string& damping, const MapAxis& columns) {
    const std::string text = read_input(path);
    SceneOrError<double> read = read_scene<double>(only_scene(text));
    if (read.error && read.error->quantity == "frequency" && columns.name != "r") {
        nlohmann::json completed = nlohmann::json::parse(text);
        completed[columns.name] = columns.values.front();
        const std::string again = completed.dump();
        read = read_scene<double>(SceneText{again});
    }
    if (read.error) throw InputError(*read.error);
    Scene<double> scene = *read.scene;
    if (damping != as_given) scene.system.damping_tolerance = largest_damping_tolerance;
    return scene;
}

std::vector<Mass> masses_of(const std::vector<long>& numbers, const Scene<double>& scene) {
    if (numbers.empty()) return {scene.system.contact};
    const std::size_t N = number_of_masses(scene.system);
    std::vector<Mass> masses;
    for (const long k : numbers) {
        const Mass mass = mass_from(k, N, "mass");
        if (std::ranges::find(masses, mass) != masses.end())
            throw InputError("mass", "must not be given twice", std::to_string(k));
        masses.push_back(mass);
    }
    return masses;
}

// An axis that a user gave: one of several ways to give it.
struct GivenAxis {
    const char* name;
    const std::string* text;
};

// The one that is given of several; throws InputError where there are two. Null where there is none.
const GivenAxis* only_one_of(const std::vector<GivenAxis>& ways) {
    const GivenAxis* given = nullptr;
    for (const GivenAxis& each : ways) {
        if (each.text->empty()) continue;
        if (given != nullptr) throw InputError(each.name, std::string("must not be given together with ") + given->name, "");
        given = &each;
    }
    return given;
}

// The columns in one kind of numbers, ratios or the units of the scene, and what of the rows is not of that kind.
GivenAxis columns_of(const MapOptions& options) {
    const bool ratios = !options.r.empty() || !options.beta.empty();
    const bool units = !options.frequency_hz.empty() || !options.frequency.empty() || !options.friction.empty() ||
                       !options.force.empty() || !options.unbalance.empty();
    if (ratios && units) throw InputError("frequency_hz and friction", "must not be given together with r and beta", "");
    const std::vector<GivenAxis> ways{
        {"frequency_hz", &options.frequency_hz}, {"frequency", &options.frequency}, {"r", &options.r}};
    if (const GivenAxis* given = only_one_of(ways)) return *given;
    throw units ? InputError("frequency_hz", "must be given as FROM:TO:COUNT", "")
                : InputError("r", "must be given as FROM:TO:COUNT (or frequency_hz in its place)", "");
}

ResultTable boundaries(const MapOptions& options, const MapAxis& axis, const Scene<double>& scene, bool units) {
    for (const auto& [name, given] :
         {std::pair("force", !options.force.empty()), std::pair("unbalance", !options.unbalance.empty()),
          std::pair("phases", options.phases), std::pair("from-ground", options.from_ground),
          std::pair("beta", !options.beta.empty()), std::pair("friction", !options.friction.empty()),
          std::pair("mass", !options.masses.empty()), std::pair("start", options.start != "rest")})
        if (given) throw InputError(name, "must not be given together with boundaries", "");
    const std::vector<BoundaryPoint> curves =
        units ? curves_in_units(scene, frequencies_in_units(scene, axis.name, axis.values)) : boundary_curves(scene, axis.values);
    return curves_table(axis, curves);
}

void answer(const MapOptions& options, ExitStatus& status) {
    const auto write = [&, as_npy = as_npy(options.output)](const ResultTable& table) {
        write_output(options.output, as_npy ? npy(table) : csv(table));
    };
    const GivenAxis columns = columns_of(options);
    const bool units = columns.text != &options.r;
    MapGrid grid{{columns.name, grid_values(columns.name, *columns.text)}, {}, {}};
    const Scene<double> scene = scene_of(options.scene, options.damping, grid.frequency);
    if (options.boundaries) return write(boundaries(options, grid.frequency, scene, units));
    const std::vector<GivenAxis> ways{
        {"friction", &options.friction}, {"force", &options.force}, {"unbalance", &options.unbalance}};
    const GivenAxis in_ratio{"beta", &options.beta};
    const GivenAxis* rows = units ? only_one_of(ways) : options.beta.empty() ? nullptr : &in_ratio;
    if (rows == nullptr) throw InputError(units ? "friction" : "beta", "must be given as FROM:TO:COUNT", "");
    grid.rows = {rows->name, grid_values(rows->name, *rows->text)};
    const RowsOf rows_of = rows->text == &options.force       ? RowsOf::force
                           : rows->text == &options.unbalance ? RowsOf::unbalance
                                                              : RowsOf::friction;
    grid.masses = masses_of(options.masses, scene);
    MapRequest request;
    request.masses = grid.masses;
    request.start = options.start == "sliding" ? MapStart::sliding : MapStart::rest;
    request.effort = allowed_operations(options.effort);
    request.from_ground = options.from_ground;
    request.phases = options.phases;
    request.threads = options.threads != 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
    if (!options.output.empty()) check_writable(options.output);
    Interruptible interruptible(stop);
    const auto progress = [&](std::size_t done) { show_columns(done, grid.frequency.values.size()); };
    RegimeMap map;
    if (units) {
        map = map_in_units(scene, frequencies_in_units(scene, grid.frequency.name, grid.frequency.values), rows_of,
                           grid.rows.values, request, stop, progress);
    } else {
        request.r = grid.frequency.values;
        request.beta = grid.rows.values;
        map = regime_map(scene, request, stop, progress);
    }
    const int signal = interruptible.end();
    if (map.complete) return write(map_table(grid, map));
    status.signal = signal;
    report("interrupted: nothing is written");
}

} // namespace

void add_map_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command = app.add_subcommand("map", "Regime, amplitudes and stops per period over a grid of (r, beta)");
    const auto options = std::make_shared<MapOptions>();
    add_one_scene_option(*command, *options);
    command->add_option("--r", options->r, "frequency ratios, FROM:TO:COUNT with both ends");
    command->add_option("--beta", options->beta,
                        "friction ratios, FROM:TO:COUNT with both ends; ascending values help each other");
    command->add_option("--frequency-hz", options->frequency_hz,
                        "frequencies in periods per unit of time, instead of --r, for a scene of masses and stiffnesses");
    command->add_option("--frequency", options->frequency, "the same in radians per unit of time");
    command->add_option("--friction", options->friction,
                        "friction forces, instead of --beta; goes with --frequency-hz or --frequency");
    command->add_option("--force", options->force, "levels of the load instead, with the friction of the scene");
    command->add_option("--unbalance", options->unbalance, "unbalances of a scene with one instead, with its friction");
    command
        ->add_option("--mass", options->masses, "mass whose amplitude is wanted; may be repeated; by default the mass in contact")
        ->allow_extra_args(false);
    command->add_option("--start", options->start, "which motion, where there is more than one")
        ->check(CLI::IsMember({"rest", "sliding"}))
        ->capture_default_str();
    command->add_flag("--from-ground", options->from_ground,
                      "amplitudes of absolute displacements, for a scene whose base or wall moves");
    command->add_flag("--phases", options->phases,
                      "phases as well, phase_K of each mass K: lags behind the force; every point is answered as by solve");
    command->add_flag("--boundaries", options->boundaries, "the four boundaries over r, without a grid of beta");
    command->add_option("--output", options->output,
                        "file to write, .csv or .npy; it appears when it is complete. Default: CSV on standard output");
    command->add_option("--threads", options->threads,
                        "number of threads; by default, and with 0, as many as the machine has; the map does not depend on it");
    add_effort_and_damping(*command, *options);
    command->footer(
        "r and beta of the scene are not used. CSV with a line for each point, beta fastest: r, beta, regime (continuous,\n"
        "stick_slip, permanent_sticking), stops_per_period, periods (of the force in a period of the motion), amplitude_K of\n"
        "each mass K in units of P / k_1, status. If double does not decide the regime or has fewer than 6 digits of an\n"
        "amplitude, `solve` answers the point. status: answered; on_boundary, beta equals a boundary to rounding\n"
        "and the neighbouring regime is possible; not_converged, no steady motion is known to follow from the start; at_a_pole,\n"
        "a mode without damping resonates; failed, digits or work do not suffice. In the last three the numbers are nan and\n"
        "there is no regime.\n"
        "NPY: an array of records (r by beta) with the same fields; regime is 0, 1, 2 in the order above and -1 for none,\n"
        "status 0 to 4, whole numbers -1 if they are not known. A contact that rests is taken to rest at zero;\n"
        "the amplitude of a mass that moves by no more than rounding is zero.\n"
        "With mu = 1 and damping in every mode the velocities do not depend on the start. Otherwise --start rest follows the\n"
        "start from rest at every point, as solve does; sliding takes the sliding motion as far as it exists and from there\n"
        "the motion that is reached as beta rises. With mu = 1 both take the motion from the boundaries.\n"
        "With --frequency-hz (or --frequency) and --friction the map is in the units of the scene: columns frequency_hz and\n"
        "friction in place of r and beta, amplitudes and boundaries as lengths and forces; the scene needs its force, "
        "unbalance,\n"
        "base_displacement or base_acceleration. With --force or --unbalance the load varies in place of friction, which the\n"
        "scene then has.\n"
        "--boundaries: r, exact, paper, approximate, sticking as `boundary` has them, status; sticking is nan if no\n"
        "friction holds the contact. An interruption leaves no file; the exit status is then 128 plus the signal.");
    command->callback([options, &status] { off_poles([&] { answer(*options, status); }); });
}

} // namespace denhartog::program
