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

// The rows of a map: what varies, and what of the scene goes with it.
struct RowsInUnits {
    RowsOf of;
    const std::vector<double>& values;
    double level = 1;    // of the load of the scene
    double friction = 0; // of the scene, where the load varies

    // P at row n of a column whose force in the scene is `force`.
    [[nodiscard]] double force(std::size_t n, double force) const {
        return of == RowsOf::friction ? force : values[n] * (force / level);
    }

    // The friction ratios of a column.
    [[nodiscard]] std::vector<double> ratios(double force_of_scene) const {
        std::vector<double> beta;
        for (std::size_t n = 0; n < values.size(); ++n) {
            const double P = force(n, force_of_scene), F = of == RowsOf::friction ? values[n] : friction;
            beta.push_back(P > 0 ? paper::friction_ratio(F, P) : -1);
            if (F >= 0 && beta.back() >= 0 && std::isfinite(beta.back()) && std::isfinite(P)) continue;
            if (of == RowsOf::friction)
                throw InputError("friction", "must not be negative, and its ratio to the force must be finite",
                                 number_to_text(F));
            throw InputError(of == RowsOf::force ? "force" : "unbalance",
                             "must be positive, and the ratio of friction to it must be finite", number_to_text(values[n]));
        }
        return beta;
    }
};

RowsInUnits rows_of(const Scene<double>& scene, RowsOf of, const std::vector<double>& values) {
    RowsInUnits rows{of, values};
    if (of == RowsOf::friction) return rows;
    const Units& units = *scene.units;
    const bool is_unbalance = units.base && scene.system.base_motion == BaseMotion::none;
    const bool has_force = !units.force_changes() && scene.system.base_motion == BaseMotion::none;
    if (of == RowsOf::force && !has_force)
        throw InputError("force",
                         is_unbalance ? "must not be varied of a scene with an unbalance: vary unbalance"
                                      : "must not be varied of a scene whose base or wall moves",
                         "");
    if (of == RowsOf::unbalance && !is_unbalance) throw InputError("unbalance", "must be given in the scene", "");
    if (!scene.beta) throw InputError("friction", "must be given in the scene, if the load varies", "");
    rows.level = of == RowsOf::force ? *units.force : *units.base * units.mass;
    rows.friction = *scene.beta * *units.force;
    return rows;
}

} // namespace

FrequenciesInUnits frequencies_in_units(const Scene<double>& scene, const std::string& quantity,
                                        const std::vector<double>& values) {
    if (!scene.units)
        throw InputError(quantity, "must be given for scenes of masses and stiffnesses only; others have r", "a scene in ratios");
    if (values.empty()) throw InputError(quantity, "must have at least one value", "none");
    FrequenciesInUnits all;
    for (const double each : values) {
        if (!(each > 0)) throw InputError(quantity, "must be positive", number_to_text(each));
        const double omega = quantity == "frequency_hz" ? 2 * pi<double>() * each : each;
        const std::optional<double> P = scene.units->force_at(omega);
        if (!P) throw InputError("force", "must be given (or base_displacement in its place)", "");
        if (!(*P > 0) || !std::isfinite(*P))
            throw InputError(quantity, "must leave the force of the base within the range of a double", number_to_text(each));
        all.r.push_back(paper::frequency_ratio(omega, scene.units->mass, scene.units->stiffness));
        all.force.push_back(*P);
    }
    return all;
}

RegimeMap map_in_units(const Scene<double>& scene, const FrequenciesInUnits& frequencies, RowsOf of,
                       const std::vector<double>& values, MapRequest request, const std::atomic<bool>& stop,
                       const std::function<void(std::size_t done)>& done) {
    const RowsInUnits rows = rows_of(scene, of, values);
    request.r = frequencies.r;
    RegimeMap map;
    if (scene.units->force_changes()) {
        request.beta = values; // each column has ratios of its own
        map = map_by_columns(
            request,
            [&](std::size_t m, MapRequest one) {
                one.beta = rows.ratios(frequencies.force[m]);
                return regime_map(scene, one, stop);
            },
            done);
    } else {
        request.beta = rows.ratios(frequencies.force.front());
        map = regime_map(scene, request, stop, done);
    }
    const std::size_t masses = request.masses.size();
    for (std::size_t n = 0; n < map.points.size(); ++n) {
        const double P = rows.force(n % values.size(), frequencies.force[n / values.size()]);
        const double length = displacement_unit(*scene.units, P);
        const auto amplitudes = std::span(map.amplitudes).subspan(n * masses, masses);
        for (double& each : amplitudes) each *= length;
        if (!has_numbers(map.points[n].status) || std::ranges::all_of(amplitudes, [](double x) { return std::isfinite(x); }))
            continue;
        map.points[n] = {};
        std::ranges::fill(amplitudes, std::nan(""));
        if (request.phases) std::ranges::fill(std::span(map.phases).subspan(n * masses, masses), std::nan(""));
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
