// Regimes and amplitudes over a grid. Read `map_of`: it has the arrays of `contact_alone.hpp` for many columns at once, and
// `compute_column` for each. `map_in_units` scales friction and amplitudes for a scene in units.
#include "denhartog/map/regime_map.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "denhartog/formulas/system.hpp"
#include "denhartog/map/map_column.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/contact_alone.hpp"
#include "denhartog/solve/solve.hpp"

namespace denhartog {
namespace {

constexpr std::size_t most_points = std::size_t(1) << 28;
constexpr std::size_t columns_at_a_time = 4096;

void check_frequencies(const std::vector<double>& r) {
    if (r.empty()) throw InputError("r", "must have at least one value", "none");
    for (const double each : r) check_frequency_ratio(each);
}

void check_size_of_map(std::size_t columns, std::size_t amplitudes) {
    if (amplitudes > 0 && columns > most_points / amplitudes)
        throw InputError("the map", "must have at most " + std::to_string(most_points) + " amplitudes",
                         std::to_string(columns) + " times " + std::to_string(amplitudes));
}

void check_request(const MapRequest& request, std::size_t N) {
    check_frequencies(request.r);
    if (request.beta.empty()) throw InputError("beta", "must have at least one value", "none");
    for (const double beta : request.beta) check_friction_ratio(beta);
    if (request.masses.empty()) throw InputError("mass", "must be given at least once", "none");
    for (const Mass k : request.masses) check_mass(k, N, "mass");
    if (request.threads < 1) throw InputError("threads", "must be at least 1", std::to_string(request.threads));
    check_size_of_map(request.r.size(), request.beta.size() * request.masses.size());
}

// Sums and limits of many columns at once, where the contact alone is asked for and the limits tell its regime.
class Arrays {
public:
    Arrays(const PreparedSystem& prepared, const MapRequest& request, std::span<const double> r, unsigned threads)
        : wanted(answers_together(prepared, request)) {
        if (!wanted) return;
        contact_sums(*prepared.bounded, prepared.moving->contact, prepared.moving->load, r, threads, sums);
        contact_limits(sums, prepared.scene().mu, threads, limits);
    }

    // A column of them; none where its limits do not part the friction ratios for certain.
    [[nodiscard]] std::optional<ContactColumn> at(std::size_t m, std::vector<double> beta) const {
        if (!wanted) return std::nullopt;
        if (!std::ranges::is_sorted(beta)) std::ranges::sort(beta);
        if (!limits_tell(limits, m, beta)) return std::nullopt;
        return ContactColumn{{sums.V_re[m], sums.V_im[m]}, sums.U[m], sums.G[m], {limits.exact[m], limits.sticking[m]}};
    }

private:
    bool wanted;
    ContactSums sums;
    ContactLimits limits;
};

// The rows of a map in units, with the level of the load and the friction of the scene.
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

// A map whose columns have friction ratios of their own, as many as the request has.
RegimeMap map_of(const Scene<double>& scene, const MapRequest& request,
                 const std::function<std::vector<double>(std::size_t m)>& ratios_of_column, const std::atomic<bool>& stop,
                 const std::function<void(std::size_t done)>& done) {
    check(scene);
    check_request(request, number_of_masses(scene.system));
    const bool absolute = request.from_ground;
    if (absolute && scene.system.base_motion == BaseMotion::none)
        throw InputError("base_motion", "must be given for absolute amplitudes", "");
    if ((absolute || request.phases) && request.start != MapStart::rest)
        throw InputError("start", absolute ? "must be rest for absolute amplitudes" : "must be rest for phases", "sliding");
    const std::size_t columns = request.r.size(), rows = request.beta.size();
    RegimeMap map;
    map.points.resize(columns * rows);
    map.amplitudes.assign(map.points.size() * request.masses.size(), std::nan(""));
    if (request.phases) map.phases = map.amplitudes;
    Progress progress(done);
    const bool own_loads = load_depends_on_frequency(scene.system); // each column then has a system of its own
    for (std::size_t start = 0; start < columns && !stop; start += columns_at_a_time) {
        const std::span<const double> r = std::span(request.r).subspan(start, std::min(columns_at_a_time, columns - start));
        const auto prepared_for = [&](std::span<const double> some, unsigned threads) {
            Scene<double> there = scene;
            if (own_loads) there.r = some.front();
            PreparedSystem prepared = prepare(scene_source(there), {}, Prepared::every_regime);
            Arrays arrays(prepared, request, some, threads);
            return std::pair{std::move(prepared), std::move(arrays)};
        };
        const auto all = own_loads ? std::nullopt : std::optional(prepared_for(r, request.threads));
        parallel_for(r.size(), request.threads, [&](std::size_t column) {
            if (stop) return false;
            const std::vector<double> beta = ratios_of_column(start + column);
            const auto own = own_loads ? std::optional(prepared_for(r.subspan(column, 1), 1)) : std::nullopt;
            const auto& [prepared, arrays] = own ? *own : *all;
            compute_column(prepared, request, start + column, beta, arrays.at(own ? 0 : column, beta), stop, map);
            if (stop) return false;
            progress.add(1);
            return true;
        });
    }
    map.complete = progress.done() == columns;
    return map;
}

} // namespace

std::string name(PointStatus status) {
    switch (status) {
    case PointStatus::answered: return "answered";
    case PointStatus::on_boundary: return "on_boundary";
    case PointStatus::not_converged: return "not_converged";
    case PointStatus::at_a_pole: return "at_a_pole";
    case PointStatus::failed: return "failed";
    }
    return {};
}

RegimeMap regime_map(const Scene<double>& scene, const MapRequest& request, const std::atomic<bool>& stop,
                     const std::function<void(std::size_t done)>& done) {
    return map_of(
        scene, request, [&](std::size_t) { return request.beta; }, stop, done);
}

std::vector<BoundaryPoint> boundary_curves(const Scene<double>& scene, const std::vector<double>& r) {
    check(scene);
    check_frequencies(r);
    const SceneSource source = scene_source(scene);
    std::shared_ptr<const ModalBasis<Bounded<double>>> modes;
    if (!load_depends_on_frequency(scene.system)) modes = modes_with_errors(source->in_double().system);
    std::vector<BoundaryPoint> curves(r.size());
    for (std::size_t n = 0; n < r.size(); ++n) {
        const Tried<Solution> answer = decide_sliding(at_frequency(source, r[n]), {Asked::regime, {}}, modes);
        curves[n].status = answer.outcome == Outcome::at_a_pole ? PointStatus::at_a_pole : PointStatus::failed;
        if (!answer.is_answered() || !answer.value->digits_reached) continue;
        const Limits& b = *answer.value->limits;
        const auto has_number = [](const Certified& limit) { return limit.value >= 0 && std::isfinite(limit.value); };
        if (!has_number(b.exact) || !has_number(b.paper) || !has_number(b.approximate)) continue; // beyond the range of a double
        curves[n] = {PointStatus::answered, b.exact.value, b.paper.value, b.approximate.value, std::nullopt};
        if (b.sticking) curves[n].sticking = b.sticking->value;
    }
    return curves;
}

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
    request.beta = rows.ratios(frequencies.force.front());
    RegimeMap map = map_of(
        scene, request, [&](std::size_t m) { return rows.ratios(frequencies.force[m]); }, stop, done);
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
