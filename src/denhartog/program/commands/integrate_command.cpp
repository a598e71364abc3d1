#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <vector>

#include "denhartog/answer/exact_cycles.hpp"
#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/json/solution_json.hpp"
#include "denhartog/program/output/result_files.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog::program {
namespace {

struct IntegrateOptions : SceneOptions {
    std::string method = "paper";
    std::string start;
    std::string units{in_ratios};
    PaperSettings settings;
};

std::string name(IntegrationStatus status) {
    constexpr std::array names{"complete", "chattering", "step_limit", "overflow"};
    return names.at(static_cast<std::size_t>(status));
}

Json mass_json(std::size_t k, const PaperMassMotion& m) {
    const NumberWriter write;
    Json all{{"mass", k + 1}, {"amplitude", write(m.amplitude)}};
    if (m.phase) all["phase"] = write(*m.phase);
    return all;
}

// A motion in the units of a scene in physical ones. Its errors are not known.
Json dimensional_json(const PaperMotion& m, const Scene<double>& scene) {
    const NumberWriter write;
    Json all = units_json(*scene.units, *scene.r, scene.beta, scene.mu);
    const double omega = angular_frequency(*scene.units, *scene.r), length = displacement_unit(*scene.units, *scene.units->force);
    all["displacement_unit"] = write(length);
    for (std::size_t k = 0; k < m.masses.size(); ++k)
        all["masses"].push_back({{"mass", k + 1}, {"amplitude", write(length * m.masses[k].amplitude)}});
    for (const Stop& stop : m.stops)
        all["stops"].push_back(
            {{"start", write(stop.start / omega)}, {"end", write(stop.end / omega)}, {"x", write(length * stop.x)}});
    return all;
}

Json motion_json(const PaperMotion& m, const Scene<double>& scene, const IntegrateOptions& options) {
    const NumberWriter write;
    const bool paper = options.method == "paper";
    Json all{{"method", options.method}, {"status", name(m.status)}};
    if (m.status != IntegrationStatus::complete) all["reason"] = m.reason;
    all["r"] = write(*scene.r);
    all["beta"] = write(*scene.beta);
    all["cycles"] = options.settings.cycles;
    if (paper) {
        const double absolute = options.settings.absolute_tolerance;
        all["absolute_tolerance"] = write(absolute);
        all["relative_tolerance"] = write(options.settings.relative_tolerance.value_or(absolute));
    }
    if (m.status == IntegrationStatus::complete) {
        const System<double>& s = scene.system;
        all["regime"] = denhartog::name(regime_seen(m));
        all["contact"] = mass_json(s.contact.index, m.between ? *m.between : m.masses[s.contact.index]);
        if (m.between) {
            all["contact"].erase("mass");
            all["contact"]["between"] = {s.contact.index + 1, s.contact_with->index + 1};
        }
        all["masses"] = Json::array();
        for (std::size_t k = 0; k < m.masses.size(); ++k) all["masses"].push_back(mass_json(k, m.masses[k]));
        if (!m.rests) {
            all["stops_per_period"] = m.stops.size();
            all["stops"] = Json::array();
            for (const Stop& stop : m.stops)
                all["stops"].push_back({{"start", write(stop.start)}, {"end", write(stop.end)}, {"x", write(stop.x)}});
        }
        if (const char* frame = frame_of(scene.system)) all["relative_to"] = frame;
        if (scene.units && scene.units->force) all["dimensional"] = dimensional_json(m, scene);
    }
    Json counters = Json::object();
    if (paper) counters = {{"steps", m.steps}, {"rejected_steps", m.rejected_steps}, {"right_hand_sides", m.right_hand_sides}};
    counters["phases"] = m.phases;
    all["counters"] = counters;
    return all;
}

std::string as_table(const Json& a) {
    std::string text = "status: " + cell(a, "status") + (a.contains("reason") ? ": " + cell(a, "reason") : "") + "\n";
    if (a.contains("masses")) {
        text += "regime over the last period: " + cell(a, "regime") + "\n";
        text += aligned({"mass", "amplitude", "phase"}, a.at("masses"), {"mass", "amplitude", "phase"});
        text += contact_in_words(a.at("contact")) + units_in_words(a);
        if (a.contains("stops") && !a.at("stops").empty())
            text += "stops in the last period, tau from a maximum of the force:\n" +
                    aligned({"start", "end", "x"}, a.at("stops"), {"start", "end", "x"});
    }
    std::string counters;
    for (const auto& item : a.at("counters").items())
        counters += (counters.empty() ? "" : ", ") + item.key() + " " + in_table(item.value());
    return text + "method: " + cell(a, "method") + ", " + cell(a, "cycles") + " cycles; " + counters + "\n" + dimensional_table(a) +
           "\n";
}

State start_from(const std::string& text, std::size_t N) {
    std::vector<double> numbers;
    for (std::size_t from = 0, to = 0; to != std::string::npos; from = to + 1) {
        to = text.find(',', from);
        const std::string part = text.substr(from, to == std::string::npos ? to : to - from);
        const NumberFault fault = number_from_text(part, numbers.emplace_back());
        if (fault != NumberFault::none) throw InputError("start", number_rule(fault), part);
    }
    if (numbers.size() != 2 * N)
        throw InputError("start", "must have " + std::to_string(2 * N) + " numbers, displacements then velocities",
                         std::to_string(numbers.size()));
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(N);
    return {{numbers.begin(), middle}, {middle, numbers.end()}};
}

std::string integrated(const SceneText& part, const IntegrateOptions& options, ExitStatus& status) {
    const SceneSource source = source_of(part, options.damping);
    const Scene<double>& scene = source->in_double();
    PaperSettings settings = options.settings;
    const std::optional<MotionUnits> units = motion_units(scene, options.units);
    if (!options.start.empty()) settings.start = start_from(options.start, number_of_masses(scene.system));
    if (units && settings.start) {
        for (double& x : settings.start->x) x /= units->length;
        for (double& v : settings.start->x_prime) v /= units->length * units->omega;
    }
    const PaperMotion motion = options.method == "paper" ? paper_algorithm(scene, settings) : exact_cycles(source, settings);
    if (motion.status != IntegrationStatus::complete) {
        status.digits_missing = true;
        report(motion.reason + (part.alone ? "" : " (line " + std::to_string(part.line) + ")"));
    }
    if (settings.samples > 0)
        return motion.status == IntegrationStatus::complete
                   ? motion_csv(SampledSolution(motion.sample_times, motion.samples), units)
                   : "";
    const Json json = motion_json(motion, scene, options);
    return options.json ? json.dump() + "\n" : as_table(json);
}

void answer(const IntegrateOptions& options, ExitStatus& status) {
    if (options.method != "paper" && options.method != "exact")
        throw InputError("method", "must be paper or exact", options.method);
    if (options.settings.samples > 0 && options.json)
        throw InputError("samples", "must not be given with --json: samples are CSV", "");
    answer_scenes(
        options,
        [&](const SceneText& part) {
            if (options.settings.samples > 0 && !part.alone)
                throw InputError("the input", "must be one scene where samples are asked for", "");
            return integrated(part, options, status);
        },
        status);
}

} // namespace

void add_integrate_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command =
        app.add_subcommand("integrate", "Motion from a start over a number of periods, by the paper's algorithm or exactly");
    const auto options = std::make_shared<IntegrateOptions>();
    PaperSettings& settings = options->settings;
    add_scene_options(*command, *options);
    command
        ->add_option("--method", options->method,
                     "paper: Runge-Kutta with events, Section 3.1; exact: closed form between events")
        ->capture_default_str();
    command->add_option("--cycles", settings.cycles, "number of periods of the force, N_cyc")->capture_default_str();
    command
        ->add_option("--absolute-tolerance", settings.absolute_tolerance,
                     "absolute tolerance of displacements and velocities in a step")
        ->capture_default_str();
    command->add_option("--relative-tolerance", settings.relative_tolerance, "relative tolerance; by default the absolute one");
    command->add_option("--start", options->start,
                        "N displacements, then N velocities, separated by commas, in the units of --units; by default rest at "
                        "zero");
    add_units_option(*command, options->units);
    command->add_option("--samples", settings.samples,
                        "print this many instants of the last period as CSV: tau, x_1..x_N, v_1..v_N");
    command->footer(
        "Amplitudes are the largest |x_k| over the last period. The phase is the instant of the largest displacement after a\n"
        "maximum of the force, if the contact does not stop. Stops are those that end in the last period. The exact method\n"
        "has no tolerances. dimensional: the same in the units of a scene that was given by masses and stiffnesses; only with\n"
        "--units scene are the start and the samples in these, and not in P / k_1 and radians of the force. If the final time\n"
        "is not reached, the exit status is 3, and the answer has status and reason.");
    command->callback([options, &status] { answer(*options, status); });
}

} // namespace denhartog::program
