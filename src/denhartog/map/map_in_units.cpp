#include "denhartog/map/map_in_units.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "denhartog/formulas/system.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

std::vector<double> friction_ratios(const std::vector<double>& friction, double P) {
    std::vector<double> beta;
    for (const double F : friction) {
        beta.push_back(paper::friction_ratio(F, P));
        if (!(F >= 0) || !std::isfinite(beta.back()))
            throw InputError("friction", "must not be negative, and its ratio to the force must be finite", number_to_text(F));
    }
    return beta;
}

} // namespace

FrequenciesInUnits frequencies_in_units(const Scene<double>& scene, const std::vector<double>& hertz) {
    if (!scene.units)
        throw InputError("frequency_hz", "must be given for scenes of masses and stiffnesses only; others have r",
                         "a scene in ratios");
    if (hertz.empty()) throw InputError("frequency_hz", "must have at least one value", "none");
    FrequenciesInUnits all{hertz, {}, {}};
    for (const double each : hertz) {
        if (!(each > 0)) throw InputError("frequency_hz", "must be positive", number_to_text(each));
        const double omega = 2 * pi<double>() * each;
        const std::optional<double> P = scene.units->force_at(omega);
        if (!P) throw InputError("force", "must be given (or base_displacement in its place)", "");
        if (!(*P > 0) || !std::isfinite(*P))
            throw InputError("frequency_hz", "must leave the force of the base within the range of a double",
                             number_to_text(each));
        all.r.push_back(paper::frequency_ratio(omega, scene.units->mass, scene.units->stiffness));
        all.force.push_back(*P);
    }
    return all;
}

RegimeMap map_in_units(const Scene<double>& scene, const FrequenciesInUnits& frequencies, const std::vector<double>& friction,
                       MapRequest request, const std::atomic<bool>& stop, const std::function<void(std::size_t done)>& done) {
    RegimeMap map;
    if (scene.units->force_changes()) {
        request.r = frequencies.r;
        request.beta = friction; // each column has ratios of its own
        map = map_by_columns(
            request,
            [&](std::size_t m, MapRequest one) {
                one.beta = friction_ratios(friction, frequencies.force[m]);
                return regime_map(scene, one, stop);
            },
            done);
    } else {
        request.r = frequencies.r;
        request.beta = friction_ratios(friction, frequencies.force.front());
        map = regime_map(scene, request, stop, done);
    }
    const std::size_t masses = request.masses.size();
    for (std::size_t n = 0; n < map.points.size(); ++n) {
        const double length = displacement_unit(*scene.units, frequencies.force[n / friction.size()]);
        const auto amplitudes = std::span(map.amplitudes).subspan(n * masses, masses);
        for (double& each : amplitudes) each *= length;
        if (!has_numbers(map.points[n].status) || std::ranges::all_of(amplitudes, [](double x) { return std::isfinite(x); }))
            continue;
        map.points[n] = {};
        std::ranges::fill(amplitudes, std::nan(""));
    }
    return map;
}

std::vector<BoundaryPoint> curves_in_units(const Scene<double>& scene, const FrequenciesInUnits& frequencies) {
    std::vector<BoundaryPoint> curves = boundary_curves(scene, frequencies.r);
    for (std::size_t n = 0; n < curves.size(); ++n) {
        const double P = frequencies.force[n];
        curves[n].exact *= P;
        curves[n].paper *= P;
        curves[n].approximate *= P;
        if (curves[n].sticking) *curves[n].sticking *= P;
        for (const double limit : {curves[n].exact, curves[n].paper, curves[n].approximate, curves[n].sticking.value_or(0)})
            if (!std::isfinite(limit)) curves[n].status = PointStatus::failed;
    }
    return curves;
}

} // namespace denhartog
