// Regimes and amplitudes over a grid. `regime_map` has the arrays of `contact_alone.hpp` for many columns at once, and
// `compute_column` for each; phases and absolute numbers come point by point from `decide`. `map_in_units` scales friction and
// amplitudes for a scene in units.
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
#include "denhartog/solve/decision.hpp"

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
    Arrays(const PreparedSystem& prepared, const MapRequest& request)
        : system(prepared), wanted(answers_together(prepared, request)) {
        if (wanted) ascending = request.beta;
        std::ranges::sort(ascending);
    }

    void compute(std::span<const double> r, unsigned threads) {
        if (!wanted) return;
        contact_sums(*system.bounded, system.moving->contact, system.moving->load, r, threads, sums);
        contact_limits(sums, system.scene().mu, threads, limits);
    }

    [[nodiscard]] std::optional<ContactColumn> at(std::size_t m) const {
        if (!wanted || !limits_tell(limits, m, ascending)) return std::nullopt;
        return ContactColumn{{sums.V_re[m], sums.V_im[m]}, sums.U[m], sums.G[m], {limits.exact[m], limits.sticking[m]}};
    }

private:
    const PreparedSystem& system;
    bool wanted;
    std::vector<double> ascending;
    ContactSums sums;
    ContactLimits limits;
};

// Absolute amplitudes, or phases, as `solve` answers at every point.
RegimeMap map_by_solve(const Scene<double>& scene, const MapRequest& request, const std::atomic<bool>& stop,
                       const std::function<void(std::size_t done)>& done) {
    const bool absolute = request.from_ground;
    if (absolute && scene.system.base_motion == BaseMotion::none)
        throw InputError("base_motion", "must be given for absolute amplitudes", "");
    if (request.start != MapStart::rest)
        throw InputError("start", absolute ? "must be rest for absolute amplitudes" : "must be rest for phases", "sliding");
    const PreparedSystem prepared = prepare(scene_source(scene), {}, Prepared::every_regime);
    const std::size_t columns = request.r.size(), rows = request.beta.size(), masses = request.masses.size();
    RegimeMap map;
    map.points.resize(columns * rows);
    map.amplitudes.assign(map.points.size() * masses, std::nan(""));
    if (request.phases) map.phases = map.amplitudes;
    const Question question{absolute ? Asked::motion : Asked::phase, std::nullopt};
    Progress progress(done);
    parallel_for(columns, request.threads, [&](std::size_t m) {
        for (std::size_t n = 0; n < rows; ++n) {
            if (stop) return false;
            QuestionEffort effort(number_of_masses(scene.system), request.effort, [&stop] { return stop.load(); });
            const Tried<Solution> answer = decide(prepared, {request.r[m], request.beta[n], nullptr, &effort}, question);
            MapPoint& point = map.points[m * rows + n] = map_point(answer);
            if (!answer.is_answered()) continue;
            const Solution& s = *answer.value;
            if (has_numbers(point.status) && ((absolute && s.from_ground.empty()) || !s.digits_reached)) point = {};
            for (std::size_t k = 0; k < masses && has_numbers(point.status); ++k) {
                const std::size_t mass = request.masses[k].index, at = (m * rows + n) * masses + k;
                map.amplitudes[at] = absolute ? s.from_ground[mass].amplitude.value : s.masses[mass].amplitude.value;
                const std::optional<Certified>& phase = absolute ? s.from_ground[mass].phase : s.masses[mass].phase;
                if (request.phases && phase) map.phases[at] = phase->value;
            }
        }
        progress.add(1);
        return true;
    });
    map.complete = progress.done() == columns;
    return map;
}

// A map of which each column has a scene of its own: the load or its unit changes with the frequency. `column_at` gives the map of
// the m-th frequency ratio alone.
RegimeMap map_by_columns(const MapRequest& request, const std::function<RegimeMap(std::size_t m, MapRequest one)>& column_at,
                         const std::function<void(std::size_t done)>& done) {
    const std::size_t columns = request.r.size(), rows = request.beta.size(), amplitudes = rows * request.masses.size();
    check_size_of_map(columns, amplitudes);
    RegimeMap all;
    all.points.resize(columns * rows);
    all.amplitudes.resize(columns * amplitudes);
    if (request.phases) all.phases.resize(columns * amplitudes);
    Progress progress(done);
    parallel_for(columns, request.threads, [&](std::size_t m) {
        MapRequest one = request;
        one.threads = 1;
        one.r = {request.r[m]};
        const RegimeMap column = column_at(m, std::move(one));
        if (!column.complete) return false;
        std::ranges::copy(column.points, all.points.begin() + static_cast<std::ptrdiff_t>(m * rows));
        std::ranges::copy(column.amplitudes, all.amplitudes.begin() + static_cast<std::ptrdiff_t>(m * amplitudes));
        std::ranges::copy(column.phases, all.phases.begin() + static_cast<std::ptrdiff_t>(request.phases ? m * amplitudes : 0));
        progress.add(1);
        return true;
    });
    all.complete = progress.done() == columns;
    return all;
}

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
    check(scene);
    check_request(request, number_of_masses(scene.system));
    if (request.from_ground || request.phases) return map_by_solve(scene, request, stop, done);
    if (load_depends_on_frequency(scene.system) && !(request.r.size() == 1 && scene.r == request.r.front()))
        return map_by_columns(
            request,
            [&](std::size_t m, const MapRequest& one) {
                Scene<double> there = scene;
                there.r = request.r[m];
                return regime_map(there, one, stop);
            },
            done);
    const PreparedSystem prepared = prepare(scene_source(scene), {}, Prepared::every_regime);
    Arrays arrays(prepared, request);
    const std::size_t columns = request.r.size(), rows = request.beta.size(), masses = request.masses.size();
    RegimeMap map;
    map.points.resize(columns * rows);
    map.amplitudes.assign(map.points.size() * masses, std::nan(""));
    Progress progress(done);
    for (std::size_t start = 0; start < columns && !stop; start += columns_at_a_time) {
        const std::size_t n = std::min(columns_at_a_time, columns - start);
        arrays.compute(std::span(request.r).subspan(start, n), request.threads);
        parallel_for(n, request.threads, [&](std::size_t column) {
            if (stop) return false;
            const std::size_t m = start + column;
            compute_column(prepared, request, request.r[m], arrays.at(column), stop,
                           std::span(map.points).subspan(m * rows, rows),
                           std::span(map.amplitudes).subspan(m * rows * masses, rows * masses));
            if (stop) return false;
            progress.add(1);
            return true;
        });
    }
    map.complete = progress.done() == columns;
    return map;
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
