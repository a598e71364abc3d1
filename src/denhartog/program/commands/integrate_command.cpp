// `denhartog integrate`: the paper's numerical approach, Section 3.1, or the exact motion, from a start over some periods; and a
// scene without a load. Read `integrated`, which chooses among them.
#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/program/commands/free_motion.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/json/solution_json.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/program/output/result_files.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog::program {
namespace {

struct IntegrateOptions : SceneOptions {
    std::string method = "paper", units{in_ratios}, start, history, output;
    bool method_given = false, cycles_given = false, units_given = false;
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
            all["contact"].update(contact_name(s));
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
    if (a.contains("history")) text += history_table(a.at("history"));
    std::string counters;
    for (const auto& item : a.at("counters").items())
        counters += (counters.empty() ? "" : ", ") + item.key() + " " + in_table(item.value());
    return text + "method: " + cell(a, "method") + ", " + cell(a, "cycles") + " cycles; " + counters + "\n" +
           dimensional_table(a) + "\n";
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

// Settings of the history; InputError if they break a rule.
HistorySettings history_settings(const IntegrateOptions& options, const State& start) {
    HistorySettings settings;
    settings.cycles = options.settings.cycles;
    settings.start = start;
    settings.samples = options.settings.samples;
    if (options.history == "all") return settings;
    double periods = 0;
    const NumberFault fault = number_from_text(options.history, periods);
    if (fault != NumberFault::none || periods != std::floor(periods) || !(periods >= 1 && periods <= 1e6))
        throw InputError("history", "must be all, or a whole number of periods from 1 to the number of cycles", options.history);
    settings.last = static_cast<int>(periods);
    return settings;
}

void report_end(const std::string& reason, const SceneText& part, ExitStatus& status) {
    status.digits_missing = true;
    report(reason + (part.alone ? "" : " (line " + std::to_string(part.line) + ")"));
}

// The instants asked for as a file, or as CSV to be printed; nothing where the end was not reached.
std::string sampled(const SampledSolution& motion, const std::optional<MotionUnits>& units, const std::vector<int>& directions,
                    const std::string& output) {
    if (motion.tau.empty()) return "";
    const ResultTable table = motion_table(motion, units, directions);
    if (output.empty()) return csv(table);
    write_file(output, as_npy(output) ? npy(table) : csv(table));
    return "";
}

// The answer to a scene without a load.
std::string freed(const UnloadedScene& unloaded, const SceneText& part, const IntegrateOptions& options, ExitStatus& status,
                  Effort* effort) {
    if (options.method_given && options.method == "paper") throw InputError("method", "must be exact where force is 0", "paper");
    const SceneSource source = source_of(SceneText{unloaded.text, part.line, part.alone}, options.damping, effort);
    if (options.units_given && options.units == in_ratios) throw InputError("units", "must be scene where force is 0", in_ratios);
    if (options.start.empty()) throw InputError("start", "must be given where force is 0", "");
    const std::size_t N = number_of_masses(source->in_double().system);
    check(options.settings, N);
    State start = start_from(options.start, N);
    for (double& v : start.x_prime) v /= unloaded.omega;
    std::optional<MotionHistory> history;
    if (!options.history.empty() || options.settings.samples > 0) {
        IntegrateOptions history_options = options;
        if (options.history.empty()) history_options.history = "all";
        HistorySettings settings = history_settings(history_options, start);
        settings.without_load = true;
        settings.period = unloaded.period;
        if (!options.cycles_given) settings.cycles = periods_to_rest(unloaded, source, start);
        history = motion_history(source, settings);
        if (history->status != IntegrationStatus::complete) {
            report_end(history->reason, part, status);
            history.reset();
        }
    }
    if (options.settings.samples > 0 && !history) return "";
    if (options.settings.samples > 0)
        return sampled({history->times, history->states}, MotionUnits{unloaded.omega, 1}, history->directions, options.output);
    const auto periods = options.cycles_given ? std::optional(options.settings.cycles) : std::nullopt;
    const Json json = free_motion_json(unloaded, source, start, periods, history);
    return options.json ? json.dump() + "\n" : free_motion_table(json);
}

std::string integrated(const SceneText& part, const IntegrateOptions& options, ExitStatus& status, Effort* effort) {
    if (options.settings.samples > 0 && !part.alone)
        throw InputError("the input", "must be one scene where samples are asked for", "");
    if (const std::optional<UnloadedScene> unloaded = unloaded_scene(part))
        return freed(*unloaded, part, options, status, effort);
    const SceneSource source = source_of(part, options.damping, effort);
    const Scene<double>& scene = source->in_double();
    PaperSettings settings = options.settings;
    const std::optional<MotionUnits> units = motion_units(scene, options.units);
    if (!options.start.empty()) settings.start = start_from(options.start, number_of_masses(scene.system));
    if (units && settings.start) {
        for (double& x : settings.start->x) x /= units->length;
        for (double& v : settings.start->x_prime) v /= units->length * units->omega;
    }
    std::optional<MotionHistory> history;
    if (!options.history.empty()) {
        const State start = settings.start.value_or(at_rest(number_of_masses(scene.system)));
        history = motion_history(source, history_settings(options, start));
        if (settings.samples > 0) {
            if (history->status != IntegrationStatus::complete) report_end(history->reason, part, status);
            return sampled({history->times, history->states}, units, history->directions, options.output);
        }
    }
    const PaperMotion motion = options.method == "paper" ? paper_algorithm(scene, settings) : exact_cycles(source, settings);
    if (motion.status != IntegrationStatus::complete) report_end(motion.reason, part, status);
    if (settings.samples > 0) return sampled({motion.sample_times, motion.samples}, units, {}, options.output);
    Json json = motion_json(motion, scene, options);
    if (history && history->status == IntegrationStatus::complete) {
        json["history"] = history_json(*history, 1, 1);
        if (json.contains("dimensional")) {
            const double omega = angular_frequency(*scene.units, *scene.r);
            json["dimensional"]["history"] =
                history_json(*history, 1 / omega, displacement_unit(*scene.units, *scene.units->force));
        }
    }
    return options.json ? json.dump() + "\n" : as_table(json);
}

void answer(const IntegrateOptions& given, ExitStatus& status) {
    IntegrateOptions options = given;
    if (options.method != "paper" && options.method != "exact")
        throw InputError("method", "must be paper or exact", options.method);
    if (!options.history.empty()) {
        if (options.method_given && options.method == "paper")
            throw InputError("history", "must be asked for with --method exact, which it takes by default", options.history);
        options.method = "exact";
    }
    if (options.settings.samples > 0 && options.json)
        throw InputError("samples", "must not be given with --json: samples are CSV", "");
    if (!options.output.empty()) {
        if (options.settings.samples <= 0) throw InputError("output", "must be given with --samples", options.output);
        (void)as_npy(options.output);
        check_writable(options.output);
    }
    answer_scenes(
        options, [&](const SceneText& part, Effort* effort) { return integrated(part, options, status, effort); }, status);
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
    add_samples_option(*command, settings.samples,
                       "print this many instants of the last period as CSV: tau, x_1..x_N, v_1..v_N. With --history they are\n"
                       "those of a period of the history, with a last column, direction: 1 or -1 as the contact slides, 0 while\n"
                       "it sticks");
    command->add_option(
        "--history", options->history,
        "all, or the number of periods at the end: every stop in them, times from the start of the motion. By the\n"
        "exact method");
    command->add_option("--output", options->output, "file for the samples, .csv or .npy; it appears when it is complete");
    command->footer(
        "Amplitudes are the largest |x_k| over the last period. The phase is the instant of the largest displacement after a\n"
        "maximum of the force, if the contact does not stop. Stops are those that end in the last period. The exact method\n"
        "has no tolerances. dimensional: the same in the units of a scene that was given by masses and stiffnesses; only with\n"
        "--units scene are the start and the samples in these, and not in P / k_1 and radians of the force. If the final time\n"
        "is not reached, the exit status is 3, and the answer has status and reason.\n"
        "With \"force\": 0 the motion is free. The answer says, in the units of the scene, where and from when on the contact\n"
        "rests for good, and where it turned before, every number with a proved bound. Periods are those of the scene's\n"
        "frequency, if it has one, else of mass 1 on spring 1 alone; --cycles is by default as many as it takes to rest.\n"
        "Other masses that nothing damps may set the contact in motion for ever: --cycles then ends the answer.");
    command->callback([options, command, &status] {
        options->method_given = command->count("--method") > 0;
        options->units_given = command->count("--units") > 0;
        options->cycles_given = command->count("--cycles") > 0;
        answer(*options, status);
    });
}

} // namespace denhartog::program
