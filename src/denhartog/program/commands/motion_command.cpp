// `denhartog motion`: displacement and velocity of every mass over a period, (46), while the contact slides throughout, as CSV or
// NPY. Read `sampled`.
#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "denhartog/number/effort.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/commands/scene_command.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/program/output/result_files.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/solve/quantities.hpp"

namespace denhartog::program {
namespace {

struct MotionOptions : SceneOptions {
    std::string output;
    int samples = 400;
    int digits_of_motion = 10;
    std::string units{in_ratios};
};

std::string sampled(const SceneText& part, const MotionOptions& options, Effort* effort) {
    const SceneSource source = source_of(part, options.damping, effort);
    const Scene<double>& scene = source->in_double();
    (void)frequency_ratio_of(scene);
    (void)friction_ratio_of(scene);
    const auto samples = static_cast<std::size_t>(options.samples);
    check_samples("samples", samples, number_of_masses(scene.system));
    const std::optional<MotionUnits> units = motion_units(scene, options.units);
    const SampledClosedForm all =
        off_poles([&] { return sampled_closed_form(source, 0, samples, options.digits_of_motion, false); });
    const QuantitiesAnswer& found = all.found;
    const Bounded<double>& limit = found.numbers.beta_lim;
    if (!found.numbers.X_j)
        throw InputError("beta",
                         "must be below beta_lim = " + number_in_certain_digits(limit.x, limit.e, *scene.beta) +
                             ", Eq. (69), for the motion to be known",
                         number_to_text(*scene.beta), "/beta");
    if (found.method.proved) report("computed by the reference: " + in_words(found.method.why));
    return csv(motion_table(all.motion, units));
}

void answer(const MotionOptions& options) {
    const std::optional<long> allowed = allowed_operations(options.effort);
    std::optional<QuestionEffort> effort;
    if (allowed) effort.emplace(0, allowed);
    const std::string text = read_input(options.scene);
    write_output(options.output, sampled(only_scene(text), options, effort ? &*effort : nullptr));
}

} // namespace

void add_motion_command(CLI::App& app, ExitStatus& status) {
    CLI::App* command = app.add_subcommand("motion", "Displacement and velocity of every mass over one period, as CSV");
    const auto options = std::make_shared<MotionOptions>();
    add_one_scene_option(*command, *options);
    add_samples_option(*command, options->samples, "number of instants in a period");
    command->add_option("--digits", options->digits_of_motion, "significant digits of every displacement and velocity, 1 to 15")
        ->capture_default_str();
    add_effort_and_damping(*command, *options);
    add_units_option(*command, options->units);
    command->add_option("--output", options->output, "file to write; it appears when it is complete");
    command->footer(
        "Columns: tau from 0 to below 2 pi, 0 at the maximum of the mass in contact; x_1..x_N in units of P / k_1; v_1..v_N,\n"
        "the derivatives with respect to tau. The contact must slide throughout. Digits are relative to the amplitude (52)\n"
        "of the mass; if double does not reach them, the reference is used, and standard error says so.");
    command->callback([options, &status] {
        try {
            answer(*options);
        } catch (const PrecisionError& e) {
            status.digits_missing = true;
            report(e.what());
        }
    });
}

} // namespace denhartog::program
