// The full surveys of the mode functions, the bounds, the time domain and batches: each prints its tables in Markdown, writes
// them to a file, and fails where a gate does.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include "tests/speed_accuracy/adversarial_survey.hpp"
#include "tests/speed_accuracy/batches.hpp"
#include "tests/speed_accuracy/bounds_survey.hpp"
#include "tests/speed_accuracy/functions_survey.hpp"
#include "tests/speed_accuracy/surveys.hpp"
#include "tests/support/paper_systems.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// Tables of a survey, and whether its gates hold.
struct RunOutcome {
    std::vector<Table> tables;
    bool good = true;
};

RunOutcome regimes(int points) {
    const RegimeSurvey survey = survey_regimes(points, 10, 1000, 7);
    return {{table_of(survey)}, survey.unexplained.empty()};
}

RunOutcome cycles() {
    std::vector<double> r;
    for (int n = 10; n <= 250; ++n) r.push_back(n / 100.0);
    std::vector<CyclesSurvey> all;
    int unanswered = 0;
    for (const double beta : {0.05, 0.2, 0.5})
        for (const double zeta : {0.001, 0.01, 0.1})
            for (const denhartog::NamedSystem<double>& s : denhartog::paper_systems(zeta)) {
                all.push_back(survey_cycles(s.name, s.system, zeta, beta, r, 200));
                unanswered += all.back().unanswered;
            }
    return {{table_of(all, 200)}, unanswered == 0};
}

RunOutcome stick_slip(int scenes) {
    const std::vector<StickSlipScene> sample = stick_slip_scenes(scenes, 24);
    Table table{"Stick-slip: the exact solver against the paper's algorithm, " + std::to_string(scenes) + " scenes",
                stick_slip_head(),
                {},
                ""};
    bool good = true;
    const auto add = [&](const std::string& what, const StickSlipSurvey& survey) {
        table.rows.push_back(row_of(what, survey));
        good = good && survey.differently.empty();
        for (const std::string& line : survey.differently) table.note += "\nDifferently, " + what + ": " + line;
    };
    for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
        const std::string at = ", tolerance " + digits(tolerance, "%.0e");
        const StickSlipSurvey rest = from_rest(sample, 10, tolerance), orbits = on_orbits(sample, tolerance);
        if (tolerance > 1e-12) {
            table.rows.push_back(row_of("ten periods from rest" + at, rest));
            table.rows.push_back(row_of("on the orbits" + at, orbits));
        } else {
            add("ten periods from rest" + at, rest);
            add("on the orbits" + at, orbits);
        }
    }
    return {{table}, good};
}

RunOutcome mode_functions(int points) {
    RunOutcome outcome;
    const auto add = [&outcome](const std::string& title, const std::vector<FunctionInZone>& all) {
        outcome.tables.push_back(table_of(title, all));
        outcome.good = outcome.good && worst_of(all, &FunctionInZone::shipped).error <= most_allowed &&
                       worst_of(all, &FunctionInZone::light).error <= most_allowed_with_exact_R;
    };
    for (const auto& [precision, count] :
         {std::pair{Precision::in_float, points}, std::pair{Precision::in_double, points},
          std::pair{Precision::in_long_double, points / 4}, std::pair{Precision::in_50_digits, points / 50}}) {
        add("Mode functions in " + name(precision), survey_mode_functions(precision, count));
        add("Free motion and the expression of (57) in " + name(precision), survey_motion(precision, count));
        add("Resonance in " + name(precision), survey_resonance(precision, count));
    }
    add("Mode functions in double over arrays", survey_array_mode_functions(points));
    return outcome;
}

/// Writes a file.
bool write_text(const std::string& directory, const std::string& name, const std::string& text) {
    std::filesystem::create_directories(directory);
    std::ofstream file(std::filesystem::path(directory) / name);
    file << text;
    file.close();
    if (!file) std::fprintf(stderr, "%s/%s cannot be written\n", directory.c_str(), name.c_str());
    return bool(file);
}

RunOutcome bounds(long scenes, std::uint64_t seed) {
    const BoundsSurvey survey = survey_bounds(scenes, seed);
    return {tables_of(survey), survey.violations() == 0 && survey.largest_median() < 40};
}

RunOutcome adversarial(AdversarialRun run) {
    const AdversarialSurvey survey = survey_in_children(run);
    return {tables_of(survey), survey.faults.empty() && contradictions_of(survey) == 0};
}

/// Prints and writes the tables.
bool publish(const std::string& name, const RunOutcome& outcome, const std::string& directory) {
    std::string text;
    for (const Table& table : outcome.tables) text += markdown(table);
    std::fputs(text.c_str(), stdout);
    if (!outcome.good) std::puts("A gate failed.");
    if (directory.empty()) return outcome.good;
    return write_text(directory, name + ".md", text) && outcome.good;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Surveys of accuracy and speed: the mode functions, bounds, both solvers of the time domain, and batches",
                 "speed-accuracy"};
    app.require_subcommand(1);
    std::string directory;
    int points = 10000, scenes = 200, repeats = 9, mode_points = 1000000;
    long bounded_scenes = 1000000;
    std::uint64_t seed = 1;
    bool good = true;
    const auto add = [&](const char* name, const char* what, const std::function<RunOutcome()>& run) {
        CLI::App* sub = app.add_subcommand(name, what);
        sub->add_option("--output", directory, "Directory for the tables");
        sub->callback([&good, &directory, name, run] { good = publish(name, run(), directory) && good; });
        return sub;
    };
    add("regimes", "Regime by boundary formulas and by the exact solver", [&] { return regimes(points); })
        ->add_option("--points", points, "How many points")
        ->check(CLI::PositiveNumber);
    add("cycles", "Where 200 cycles from rest are not the steady state", [] { return cycles(); });
    add("stick-slip", "Exact solver against the paper's algorithm, in stick-slip", [&] { return stick_slip(scenes); })
        ->add_option("--scenes", scenes, "How many scenes")
        ->check(CLI::PositiveNumber);
    add("mode-functions", "v, u, g, d, q, their rates, (57), (79), (83)-(85) against up to 1100 digits, zone by zone",
        [&] { return mode_functions(mode_points); })
        ->add_option("--points", mode_points,
                     "How many points in float and double; a quarter in long double, a fiftieth in 50 digits")
        ->check(CLI::PositiveNumber);
    CLI::App* of_bounds =
        add("bounds", "Bounds of rounding errors in double against 100 digits", [&] { return bounds(bounded_scenes, seed); });
    of_bounds->add_option("--scenes", bounded_scenes, "How many scenes")->check(CLI::PositiveNumber);
    of_bounds->add_option("--seed", seed, "Seed of the scenes");
    AdversarialRun run;
    const std::map<std::string, AdversarialRange> ranges{
        {"everything", everything}, {"doubles", any_double}, {"contrasts", contrasts}, {"mild", mild}, {"units", units}};
    std::string range = "everything";
    const auto add_adversarial = [&](const char* name, const char* what, bool questions) {
        CLI::App* sub = add(name, what, [&run, &range, &ranges, questions] {
            run.range = ranges.at(range);
            run.questions = questions;
            run.contradictions = !questions;
            if (!questions) run.seconds_a_question *= 20; // a comparison asks up to 20
            return adversarial(run);
        });
        sub->add_option("--scenes", run.scenes, "How many scenes")->check(CLI::PositiveNumber);
        sub->add_option("--seed", run.seed, "Seed of the scenes");
        sub->add_option("--range", range, "What they are drawn from")->check(CLI::IsMember(ranges));
        sub->add_option("--seconds", run.seconds_a_question, "Processor time that a question may take")
            ->check(CLI::PositiveNumber);
        sub->add_option("--effort", run.effort, "Operations that a question may spend, if not the default")
            ->check(CLI::PositiveNumber);
        sub->add_flag("!--without-all", run.all_motions, "Whether all motions are asked for");
    };
    add_adversarial("adversarial", "Every question to scenes from the corners of what a scene may be", true);
    add_adversarial("contradictions", "Answers of few digits beside those of many, number by number", false);
    add("batch", "Time of batches beside the bare functions, errors of those, and cost against the size of the task",
        [&] {
            const std::vector<BatchCost> costs = batch_costs(repeats);
            bool written = true;
            if (!directory.empty()) written = write_text(directory, "batch_cost.csv", batch_cost_csv(costs, repeats));
            return RunOutcome{{batch_speed(repeats), vector_function_errors(), table_of(costs)}, written};
        })
        ->add_option("--repeats", repeats, "Runs of which the median is taken")
        ->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    return good ? 0 : 1;
}
