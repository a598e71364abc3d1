#include "denhartog/map/map_column.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "denhartog/map/contact_amplitudes.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/regime.hpp"
#include "denhartog/stick_slip/at_maximum_of_force.hpp"
#include "denhartog/stick_slip/periodic_orbit.hpp"

namespace denhartog {
namespace {

class MapColumn {
public:
    MapColumn(const MapSystem& map_, double r_, const std::optional<ContactColumn>& arrays, std::span<MapPoint> points_,
              std::span<double> amplitudes_)
        : map(map_), r(r_), by_arrays(arrays.has_value()), column(arrays ? *arrays : evaluated()), points(points_),
          amplitudes(amplitudes_),
          contact_alone(std::ranges::all_of(map.masses, [&](Mass k) { return k == map.system.contact; })) {}

    void answer(std::size_t n) {
        const double beta = map.beta[n];
        const bool may_differ = map.mu > 1 && beta > 0;
        if (may_differ && map.start == MapStart::rest)
            follow(n, at_rest<double>(map.system.basis.r_n.size()));
        else if (slides(beta))
            slide(n);
        else if (rests(beta) && (!may_differ || !last))
            stick(n);
        else
            sweep(n);
        if (points[n].status == PointStatus::answered && near_limit(beta)) points[n].status = PointStatus::on_boundary;
    }

    // As many points from n on as the closed form or the rest answer without a motion to follow; the contact's amplitude alone.
    std::size_t answer_together(std::size_t n) {
        if (!answers_together(map)) return 0;
        const std::size_t first = n;
        while (n < points.size() && slides(map.beta[n])) ++n;
        contact_amplitudes(column.V_dj, column.U_dj, column.G_j, std::span(map.beta).subspan(first, n - first),
                           amplitudes.subspan(first, n - first));
        for (std::size_t m = first; m < n; ++m) {
            if (std::isfinite(amplitudes[m]))
                put(m, Regime::continuous);
            else
                n = m;
        }
        if (n > first) sliding = n - 1;
        for (; n < points.size() && map.mu == 1 && rests(map.beta[n]); ++n) {
            amplitudes[n] = 0;
            put(n, Regime::permanent_sticking);
        }
        if (n > first) last.reset();
        return n - first;
    }

private:
    const ModeSums<double>& sums() {
        if (!sums_) sums_ = mode_sums(map.system.basis, map.system.contact, map.system.load, r);
        return *sums_;
    }

    const RegimeBoundary<double>& limits() {
        if (!limits_) limits_ = regime_boundary(sums(), map.mu);
        return *limits_;
    }

    ContactColumn evaluated() {
        const std::size_t j = map.system.contact.index;
        const double never = std::numeric_limits<double>::infinity();
        return {sums().V[j], sums().U[j], sums().G[j], limits().exact, limits().sticking.value_or(never)};
    }

    bool slides(double beta) const { return beta < column.exact; }
    bool rests(double beta) const { return !slides(beta) && beta >= column.sticking; }

    // Whether the regime could be the neighbour's; never where the arrays tell it.
    bool near_limit(double beta) { return !by_arrays && on_boundary(limits(), beta, rounding_of(limits())); }

    void put(std::size_t n, Regime regime) {
        points[n] = {near_limit(map.beta[n]) ? PointStatus::on_boundary : PointStatus::answered, regime, 0, 1};
    }

    void write(std::size_t n, std::size_t place, double amplitude) {
        if (!std::isfinite(amplitude)) throw PrecisionError("the amplitude is beyond the range of a double");
        amplitudes[n * map.masses.size() + place] = amplitude;
    }

    void slide(std::size_t n) {
        const double beta = map.beta[n];
        if (contact_alone) {
            double X_j = 0;
            contact_amplitudes(column.V_dj, column.U_dj, column.G_j, {&beta, 1}, {&X_j, 1});
            for (std::size_t m = 0; m < map.masses.size(); ++m) write(n, m, X_j);
        } else {
            const SteadyState<double> state = steady_state(sums(), limits(), beta);
            for (std::size_t m = 0; m < map.masses.size(); ++m) write(n, m, state.masses[map.masses[m].index].amplitude);
        }
        points[n] = {PointStatus::answered, Regime::continuous, 0, 1};
        sliding = n;
        last.reset();
    }

    void stick(std::size_t n) {
        if (!contact_alone && !held) held = stuck_response(map.system.stuck, map.system.contact, map.system.load, r);
        for (std::size_t m = 0; m < map.masses.size(); ++m)
            write(n, m, map.masses[m] == map.system.contact ? 0 : held->masses[map.masses[m].index].amplitude);
        points[n] = {PointStatus::answered, Regime::permanent_sticking, 0, 1};
        last.reset();
    }

    // From the motion at the friction ratio before; where that leads nowhere, from rest.
    void sweep(std::size_t n) {
        if (!last && sliding) last = at_maximum_of_force(sums(), steady_state(sums(), limits(), map.beta[*sliding]));
        if (last) follow(n, *last);
        if (!last || points[n].status != PointStatus::answered) follow(n, at_rest<double>(map.system.basis.r_n.size()));
    }

    void follow(std::size_t n, const State<double>& start) {
        const Excitation<double> excitation{r, map.beta[n], map.mu};
        if (solver)
            solver->set(excitation);
        else
            solver.emplace(map.system, excitation);
        OrbitSearch<double> search;
        search.follow_start = map.mu > 1 && map.start == MapStart::rest;
        search.contact_only = contact_alone;
        search.with_stability = false;
        const PeriodicOrbit<double> orbit = periodic_orbit(*solver, start, search);
        if (orbit.status == OrbitStatus::permanently_stuck && (map.mu > 1 || column.sticking == map.beta[n])) return stick(n);
        points[n].status = PointStatus::not_converged;
        if (orbit.status != OrbitStatus::periodic) return;
        for (std::size_t m = 0; m < map.masses.size(); ++m)
            write(n, m, contact_alone ? orbit.contact.amplitude : orbit.masses[map.masses[m].index].amplitude);
        // With mu = 1 the boundary tells the regime, also where it is so near that no stop is seen.
        const Regime regime = orbit.stops.empty() && map.mu > 1 ? Regime::continuous : Regime::stick_slip;
        points[n] = {PointStatus::answered, regime, static_cast<std::int32_t>(orbit.stops.size()), orbit.periods};
        last = orbit.start;
    }

    const MapSystem& map;
    double r;
    std::optional<ModeSums<double>> sums_;         // evaluated when they are first needed
    std::optional<RegimeBoundary<double>> limits_; // the same
    bool by_arrays;                                // whether `column` comes from the arrays
    ContactColumn column;
    std::span<MapPoint> points;
    std::span<double> amplitudes;
    bool contact_alone;
    std::optional<std::size_t> sliding;        // the last point where the closed form answered
    std::optional<State<double>> last;         // the last periodic orbit
    std::optional<StuckResponse<double>> held; // found when it is first needed
    std::optional<ExactSolver<double>> solver; // set up when it is first needed
};

} // namespace

bool answers_together(const MapSystem& map) {
    return map.masses.size() == 1 && map.masses.front() == map.system.contact && (map.mu == 1 || map.start == MapStart::sliding);
}

void compute_column(const MapSystem& map, double r, const std::optional<ContactColumn>& arrays, const std::atomic<bool>& stop,
                    std::span<MapPoint> points, std::span<double> amplitudes) {
    const std::size_t masses = map.masses.size();
    const auto without_numbers = [&](std::size_t n, PointStatus status) {
        points[n] = {status, Regime::continuous, 0, 1};
        std::ranges::fill(amplitudes.subspan(n * masses, masses), std::nan(""));
    };
    const std::size_t modes = map.system.basis.r_n.size();
    const std::function<bool()> stopped = [&stop] { return stop.load(std::memory_order_relaxed); };
    std::optional<MapColumn> column;
    PointStatus fault = PointStatus::failed;
    try {
        const QuestionEffort effort(modes, map.effort, stopped);
        column.emplace(map, r, arrays, points, amplitudes);
    } catch (const DomainError&) {
        fault = PointStatus::at_a_pole;
    } catch (const PrecisionError&) {
    }
    for (std::size_t n = 0; n < points.size() && !stop; ++n) {
        if (!column) {
            without_numbers(n, fault);
            continue;
        }
        if (const std::size_t together = column->answer_together(n); together > 0) {
            n += together - 1;
            continue;
        }
        try {
            const QuestionEffort effort(modes, map.effort, stopped);
            column->answer(n);
            if (points[n].status == PointStatus::not_converged) without_numbers(n, PointStatus::not_converged);
        } catch (const DomainError&) {
            without_numbers(n, PointStatus::at_a_pole);
        } catch (const PrecisionError&) {
            without_numbers(n, PointStatus::failed);
        }
    }
}

} // namespace denhartog
