// `denhartog solve`: the steady motion of a scene in any regime, with its digits and how it was found. Read `solved`, which asks
// the question and adds to the answer what the options ask for.
#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "denhartog/number/number_text.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/json/solution_json.hpp"
#include "denhartog/program/output/result_files.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_rules.hpp"
#include "denhartog/solve/find.hpp"
#include "denhartog/solve/sampled_solution.hpp"
#include "denhartog/solve/solve.hpp"

namespace denhartog::program {
namespace {

struct SolveOptions : SceneOptions {
    std::string ask = "motion";
    bool all = false;
    std::optional<long> mass;
    int samples = 0;
    bool condition = false;
    bool energy = false;
    std::string units{in_ratios};
};

Asked asked(const std::string& text) {
    if (text == "amplitude") return Asked::amplitude;
    if (text == "phase") return Asked::phase;
    if (text == "regime") return Asked::regime;
    return Asked::motion;
}

// The question; masses count from 1 here and from 0 there.
Question question_of(const SolveOptions& options, std::size_t N) {
    Question question{asked(options.ask), options.digits, options.all};
    question.proved = options.proved;
    if (options.mass) question.mass = mass_from(*options.mass, N, "mass");
    return question;
}

// The relative change of each amplitude over that of a number: to three digits, of which two are meant.
void add_condition(Json& answer, const SceneText& part, const SolveOptions& options, Effort* effort) {
    const double tolerance = options.damping == as_given ? 0 : largest_damping_tolerance;
    for (const ConditionOfAmplitudes& c : conditions_of(part.text, tolerance, effort)) {
        Json row = Json::array();
        for (const std::optional<double>& each : c.of_masses)
            row.push_back(each ? Json::parse(number_in_digits(*each, 3)) : Json());
        answer["condition"][c.number] = std::move(row);
    }
}

std::string condition_table(const Json& answer) {
    if (!answer.contains("condition")) return "";
    Rows rows{{"relative change of the amplitude of mass"}};
    for (std::size_t k = 1; k <= answer.at("condition").front().size(); ++k) rows.front().push_back(std::to_string(k));
    for (const auto& [number, row] : answer.at("condition").items()) {
        rows.push_back({"for one of " + number});
        for (const Json& each : row) rows.back().push_back(each.is_null() ? "-" : in_table(each));
    }
    return aligned(rows) + "\n";
}

std::string solved(const SceneText& part, const SolveOptions& options, Effort* effort) {
    if (options.samples > 0 && options.ask != "motion")
        throw InputError("samples", "must be given with --ask motion only", options.ask);
    if (options.samples == 0 && options.units != in_ratios)
        throw InputError("units", "must be given with --samples only: an answer has both", options.units);
    if (options.samples > 0 && options.json) throw InputError("samples", "must not be given with --json: samples are CSV", "");
    if (options.condition && (options.samples > 0 || options.mass || options.ask == "regime"))
        throw InputError("condition", "must be given without --samples, --mass and --ask regime", "");
    if (options.energy && (options.samples > 0 || options.mass || options.ask != "motion"))
        throw InputError("energy", "must be given without --samples, --mass and any --ask but motion", "");
    if (options.samples > 0 && (options.mass || options.all))
        throw InputError("samples", "must be given without --mass and --all", "");
    const SceneSource source = source_of(part, options.damping, effort);
    const std::size_t N = number_of_masses(source->in_double().system);
    if (options.samples > 0) check_samples("samples", static_cast<std::size_t>(options.samples), N);
    const Solution solution = solve(source, question_of(options, N));
    if (options.samples > 0 && !solution.not_from_rest.empty())
        report("the start from rest is not known to lead to this motion: " + in_words(solution.not_from_rest));
    if (options.samples > 0)
        return csv(motion_table(sampled_solution(source, solution, static_cast<std::size_t>(options.samples)),
                                motion_units(source->in_double(), options.units)));
    Json answer = solution_json(solution, NumberWriter{options.digits});
    add_damping(answer, source);
    add_dimensional(answer, source, solution, NumberWriter{options.digits});
    add_place_of_rest(answer, source);
    const std::string warning = warning_of(source, solution);
    if (!warning.empty()) answer["warning"] = warning;
    if (options.energy)
        add_energies(answer, source, solution, energies(source, solution, options.digits), NumberWriter{options.digits});
    if (options.condition) add_condition(answer, part, options, effort);
    if (options.json) return answer.dump() + "\n";
    const std::string damping = damping_line(answer);
    return solution_table(answer) + warning_line(answer) + damping + (damping.empty() ? "" : "\n") + place_of_rest_lines(answer) +
           from_ground_table(answer) + dimensional_table(answer) + energy_table(answer) + condition_table(answer);
}

} // namespace

void add_solve_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command = app.add_subcommand("solve", "The steady motion at the point (r, beta) of a scene, in every regime");
    const auto options = std::make_shared<SolveOptions>();
    add_scene_options(*command, *options);
    add_digits_option(*command, *options);
    command->add_option("--ask", options->ask, "what is wanted; asking for less is cheaper")
        ->check(CLI::IsMember({"amplitude", "phase", "motion", "regime"}))
        ->capture_default_str();
    command->add_option("--mass", options->mass,
                        "ask about this mass alone, counted from 1: only it is listed, and only it must have the digits");
    command->add_flag("--all", options->all, "look for other motions too, from seeded starts and from sweeps in r and beta");
    add_samples_option(*command, options->samples,
                       "print the motion as CSV, this many instants in its period: tau from the maximum of the force, x_1..x_N,\n"
                       "v_1..v_N (derivatives with respect to tau)");
    command->add_flag("--condition", options->condition,
                      "say how much each amplitude changes with each number of the scene: relative change over relative change");
    command->add_flag(
        "--energy", options->energy,
        "say what contact and dampers dissipate, friction as an equivalent dashpot, and the forces on wall and base");
    add_units_option(*command, options->units);
    command->footer(
        "The answer is that of `response` if the contact slides throughout. If it sticks and slips, amplitudes and phases\n"
        "come from a periodic orbit of the exact solver; stops lists start and end of each stop, tau from the maximum of the\n"
        "force, within the period of the motion (periods, in periods of the force), and where the contact rests; start is the\n"
        "state at tau = 0. If it rests for ever, rest_interval is where it may rest, and amplitudes are for rest at zero.\n"
        "method says which model answers, in which precision, and why: the cheapest that is certain to have the digits.\n"
        "unique: whether the velocities are known not to depend on the start. If not, the answer is the motion that the start\n"
        "from rest leads to; from_rest is there if that is not known: the motion is then another steady one, and\n"
        "from_rest_because says how far the motion from rest had come. kept_mode: a mode without damping of which the motion\n"
        "keeps the share that the start leads to, and the amplitude of the contact with the largest share.\n"
        "stable: all Floquet multipliers are inside the unit circle, by more than their errors; multipliers are their sizes in\n"
        "double, multiplier_error_bounds their bounds, null if none is known.\n"
        "regime_by_56: the regime by the paper's condition, if it differs. beta_lim.at_least: a bound that was enough.\n"
        "error_bound is absolute, in units of P / k_1; phase_error_bound in radians. counters: what the answer cost.\n"
        "dimensional: the same in the units of a scene that was given by masses and stiffnesses; times from the maximum of the\n"
        "force.\n"
        "place_of_rest: where a constant load of the scene holds the masses; displacements count from there.\n"
        "from_ground: if base, wall or both move, the absolute displacement of each mass, its transmissibility, which is that\n"
        "over base_amplitude, and its phase behind them.\n"
        "damping: for a damping matrix that couples the modes, whether the coupling was included, and how large it is.\n"
        "warning: if a unit in the last place of a number of the scene changes amplitudes by more than a thousandth.\n"
        "condition (--condition): an estimate for each mass by each number of the scene that is not zero, null if it is not "
        "known\n"
        "to two digits.\n"
        "energy (--energy), proved in every regime: contact and dampers, what they dissipate in a period of the force, in units\n"
        "of P^2 / k_1, as a mean if the motion is longer; friction, the largest friction force, and on_base, the largest force "
        "of\n"
        "springs and dampers on the base, in units of P, without a constant load; equivalent_damping c = W / (pi omega X^2) "
        "with\n"
        "the contact's energy W and amplitude X, in units of sqrt(k_1 m_1), and equivalent_damping_ratio c / (2 sqrt(k_1 m_1)).\n"
        "textbook: contact, 4 F X; amplitude, that of a dashpot 4 F / (pi omega X) in place of friction; contact_off and\n"
        "amplitude_off, by what part of the true numbers these are off.\n"
        "--all: motions lists each motion found, with its stability, from, a state at the maximum of the force that leads to\n"
        "it, and found, where that start comes from. A motion that is not listed may still exist.\n"
        "If no steady motion is found, or not to the digits asked for, the answer has a reason and the exit status is 3.");
    answer_every_scene(*command, options, status, solved);
}

} // namespace denhartog::program
