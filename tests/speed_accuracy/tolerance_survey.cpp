#include "tests/speed_accuracy/tolerance_survey.hpp"

#include <cmath>
#include <map>

#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "tests/support/plain_response.hpp"

namespace denhartog::tests {
namespace {

bool integrate(const Scene<double>& scene, const PaperSettings& settings, PaperMotion& motion) {
    motion = paper_algorithm(scene, settings);
    return motion.status == IntegrationStatus::complete;
}

} // namespace

std::vector<Tolerance> tolerances() { return {{1e-6, 1e-3}, {1e-6, 1e-6}, {1e-8, 1e-8}, {1e-10, 1e-10}, {1e-12, 1e-12}}; }

std::string name(const Tolerance& t) {
    return digits(t.absolute, "%.0e") + (t.relative == t.absolute ? "" : ", rel " + digits(t.relative, "%.0e"));
}

ToleranceErrors tolerance_errors(const std::vector<NamedScene<double>>& scenes, const Tolerance& tolerance, int cycles,
                                 bool with_rest) {
    ToleranceErrors errors;
    for (const NamedScene<double>& named : scenes) {
        const Response<double> closed = response(named.scene);
        if (!closed.steady_state) continue;
        const std::vector<MassResponse<double>>& masses = closed.steady_state->masses;
        PaperSettings settings;
        settings.cycles = cycles;
        settings.absolute_tolerance = tolerance.absolute;
        settings.relative_tolerance = tolerance.relative;
        PaperMotion motion;
        const auto amplitude_error = [&](std::size_t k) {
            return std::abs(motion.masses[k].amplitude / masses[k].amplitude - 1);
        };
        if (with_rest) {
            if (integrate(named.scene, settings, motion))
                for (std::size_t k = 0; k < masses.size(); ++k) errors.from_rest.note(amplitude_error(k), named.name);
            else
                ++errors.failed;
        }
        const Scene<double>& scene = named.scene;
        const ModeSums<double> sums = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
        settings.start = at_maximum_of_force(sums, *closed.steady_state);
        if (!integrate(named.scene, settings, motion)) {
            ++errors.failed;
            continue;
        }
        for (std::size_t k = 0; k < masses.size(); ++k) {
            errors.on_closed.note(amplitude_error(k), named.name);
            if (motion.masses[k].phase)
                errors.phase.note(std::abs(wrapped(*motion.masses[k].phase - masses[k].phase)), named.name);
        }
    }
    return errors;
}

std::vector<std::pair<std::string, std::vector<NamedScene<double>>>> paper_scene_groups() {
    std::vector<std::pair<std::string, std::vector<NamedScene<double>>>> groups;
    for (const NamedScene<double>& scene : paper_scenes<double>()) {
        const std::string group = scene.name.substr(0, scene.name.find(" r="));
        if (groups.empty() || groups.back().first != group) groups.push_back({group, {}});
        groups.back().second.push_back(scene);
    }
    return groups;
}

} // namespace denhartog::tests
