#include "denhartog/program/output/motion_file.hpp"

#include <CLI/CLI.hpp>
#include <cmath>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog::program {

void add_units_option(CLI::App& command, std::string& units) {
    command
        .add_option(
            "--units", units,
            "units of the motion: ratios, or scene for those of its masses, stiffnesses and force, with t from the\nsame instant "
            "instead of tau")
        ->check(CLI::IsMember({in_ratios, in_scene}))
        ->capture_default_str();
}

std::optional<MotionUnits> motion_units(const Scene<double>& scene, const std::string& units) {
    if (units == in_ratios) return std::nullopt;
    if (!scene.units) throw InputError("units", "must be ratios where the scene has no masses and stiffnesses", units);
    const double omega = angular_frequency(*scene.units, frequency_ratio_of(scene));
    const std::optional<double> P = scene.units->force_at(omega);
    if (!P) throw InputError("units", "must be ratios where the scene has no force", units);
    return MotionUnits{omega, displacement_unit(*scene.units, *P)};
}

std::string motion_csv(const SampledSolution& motion, const std::optional<MotionUnits>& units) {
    const double time = units ? 1 / units->omega : 1, length = units ? units->length : 1;
    const double velocity = units ? units->length * units->omega : 1;
    const auto cell = [](double x) {
        if (!std::isfinite(x)) throw PrecisionError("the motion holds a number beyond the range of a double");
        return "," + number_to_text(x == 0 ? 0.0 : x);
    };
    std::string csv = units ? "t" : "tau";
    for (const char* letter : {"x", "v"})
        for (std::size_t k = 1; k <= motion.states.front().x.size(); ++k)
            csv += std::string(",") + letter + "_" + std::to_string(k);
    csv += "\n";
    for (std::size_t n = 0; n < motion.tau.size(); ++n) {
        csv += number_to_text(time * motion.tau[n]);
        for (const double x : motion.states[n].x) csv += cell(length * x);
        for (const double v : motion.states[n].x_prime) csv += cell(velocity * v);
        csv += "\n";
    }
    return csv;
}

} // namespace denhartog::program
