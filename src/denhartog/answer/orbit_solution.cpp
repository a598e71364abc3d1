#include "denhartog/answer/orbit_solution.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/orbit/floquet.hpp"
#include "denhartog/stick_slip/event_errors.hpp"

namespace denhartog {
namespace {

using std::abs;

// The states of an orbit. One that mirrors itself after half its period is moved along that half alone.
template <class T>
class OnOrbit {
public:
    OnOrbit(ExactSolver<T>& solver_, const PeriodicOrbit<T>& orbit)
        : solver(solver_), mirrors(orbit.symmetric), stretch((mirrors ? 1 : 2) * orbit.periods * pi<T>()) {
        phases = solver.run(orbit.start, T(0), stretch).phases;
    }

    // How that vanishes which ends the phase before an instant, one of sliding or of sticking; the search for the end may have come
    // to other last digits before. None where no such phase ends there.
    std::optional<EndOfPhase<T>> end_at(T tau, bool slides) {
        while (tau >= stretch) tau -= stretch;
        T nearest = sqrt(unit_of<T>()) * stretch;
        std::optional<std::size_t> found;
        for (std::size_t n = 0; n < phases.size(); ++n) {
            const Phase<T>& p = phases[n];
            if ((p.direction != 0) != slides || !(p.end > p.start)) continue;
            const T apart = abs(T(p.end - tau)), either_way = std::min(apart, T(abs(T(apart - stretch))));
            if (either_way > nearest) continue;
            nearest = either_way;
            found = n;
        }
        return found ? std::optional(solver.end_of(*found)) : std::nullopt;
    }

    State<T> at(T tau) {
        bool mirrored = false;
        for (; tau < 0; tau += stretch) mirrored = mirrors && !mirrored;
        for (; tau > stretch; tau -= stretch) mirrored = mirrors && !mirrored;
        const auto found = std::ranges::lower_bound(phases, tau, {}, &Phase<T>::end);
        const auto last = static_cast<std::ptrdiff_t>(phases.size()) - 1;
        State<T> state = solver.state_at(static_cast<std::size_t>(std::min(found - phases.begin(), last)), tau);
        for (std::vector<T>* part : {&state.x, &state.x_prime}) {
            add_displacements(solver.system().coordinates, *part);
            for (T& each : *part)
                if (mirrored) each = -each;
        }
        return state;
    }

private:
    ExactSolver<T>& solver;
    bool mirrors;
    T stretch;
    std::vector<Phase<T>> phases;
};

// How far the extremum of a mass may be from where it was found: as far as it takes until its size surely grows on one side and
// falls on the other, by more than the error of the velocity. A value alone does not tell the place: next to the extremum others
// are as large to all digits. A contact that comes to rest moves on one side only, and there by twice the error: what is left of
// the true velocity then ends within as much again.
template <class T>
T error_of_extremum(OnOrbit<T>& orbit, std::size_t k, const MassMotion<T>& mass, int periods, const T& velocity_error) {
    T nearest(-1), instant(0);
    for (int n = 0; n < 2 * periods; ++n) {
        const T tau = mass.phase + n * pi<T>();
        const T apart = abs(T(abs(orbit.at(tau).x[k]) - mass.amplitude));
        if (nearest >= 0 && apart >= nearest) continue;
        nearest = apart;
        instant = tau;
    }
    // How fast the size grows before the instant, and how fast it falls after it.
    const auto rates = [&](const T& apart) {
        const auto growth = [&](const State<T>& state) { return state.x[k] < 0 ? T(-state.x_prime[k]) : state.x_prime[k]; };
        return std::pair{growth(orbit.at(T(instant - apart))), T(-growth(orbit.at(T(instant + apart))))};
    };
    const T step = T(1) / 1024;
    const auto [grows, falls] = rates(step);
    const T acceleration = std::max(T(abs(grows)), T(abs(falls))) / step;
    T apart = acceleration > 0 ? T(velocity_error / acceleration) : step;
    for (; apart < pi<T>(); apart *= 2) {
        const auto [before, after] = rates(apart);
        const T less = std::min(before, after);
        if (less >= velocity_error) return apart;
        if (less == 0 && std::max(before, after) >= 2 * velocity_error) return 2 * apart;
    }
    return pi<T>();
}

// The stops of an orbit.
template <class T>
std::vector<SolvedStop> stops_of(OnOrbit<T>& on_orbit, const ExactSolver<T>& solver, const PeriodicOrbit<T>& orbit) {
    const ErrorsAtEnds<T> errors(solver, orbit.error_bound, orbit.velocity_errors);
    const auto instant = [&](const T& tau, bool slides) {
        const T anywhere = orbit.periods * pi<T>();
        const std::optional<EndOfPhase<T>> end = on_orbit.end_at(tau, slides);
        const T found = end ? T(errors.of_instant(*end, slides) + 8 * unit_of<T>() * (1 + tau)) : anywhere;
        return certified(Bounded<T>(tau, std::min(found, anywhere)));
    };
    std::vector<SolvedStop> stops;
    for (const Stop<T>& stop : orbit.stops)
        stops.push_back({instant(stop.start, true), instant(stop.end, false), certified(Bounded<T>(stop.x, orbit.error_bound))});
    return stops;
}

} // namespace

template <class T>
OrbitSolution orbit_solution(ExactSolver<T>& solver, const PeriodicOrbit<T>& orbit, std::optional<Mass> only) {
    OnOrbit<T> on_orbit(solver, orbit);
    const std::size_t j = solver.system().contact.index,
                      count = orbit.start.x.size() + solver.system().coordinates.replaced.size();
    T largest = orbit.contact.amplitude; // of the other masses the state at the start, where their maxima were not sought
    for (const T& x : orbit.start.x) largest = std::max(largest, T(abs(x)));
    for (const MassMotion<T>& mass : orbit.masses) largest = std::max(largest, mass.amplitude);
    const auto number = [](const T& x, const T& error) { return certified(Bounded<T>(x, error)); };
    OrbitSolution solution;
    solution.stops = stops_of(on_orbit, solver, orbit);
    for (std::size_t k = 0; k < count; ++k) {
        if (only && k != only->index) {
            solution.masses.push_back({});
            continue;
        }
        const MassMotion<T>& mass = k == j ? orbit.contact : orbit.masses[k];
        const T rounding = std::numeric_limits<T>::epsilon() * (16 * largest);
        if (does_not_move(mass.amplitude, T(orbit.error_bound + rounding), largest)) {
            solution.masses.push_back({number(mass.amplitude, orbit.error_bound), std::nullopt, std::nullopt});
            continue;
        }
        const T velocity_error = orbit.velocity_errors[k] + rounding / 16;
        const T of_instant = error_of_extremum(on_orbit, k, mass, orbit.periods, velocity_error);
        const T phase_error = std::min(pi<T>(), T(of_instant + mass.spread + 4 * unit_of<T>()));
        solution.masses.push_back({number(mass.amplitude, orbit.error_bound), number(mass.phase, phase_error), std::nullopt});
        const T relative = mass.amplitude > 0 ? T(orbit.error_bound / mass.amplitude) : T(1);
        solution.relative_amplitude = std::max(solution.relative_amplitude, static_cast<double>(relative));
        solution.phase_error = std::max(solution.phase_error, static_cast<double>(phase_error));
    }
    return solution;
}

template <class T>
std::optional<Certified> place_of_rest(const PeriodicOrbit<T>& orbit, Mass contact) {
    const bool is_bounded = orbit.error_bound - orbit.error_bound == 0;
    if (!is_bounded) return std::nullopt;
    return certified(Bounded<T>(orbit.start.x[contact.index], orbit.error_bound));
}

template <class T>
Stability stability_of(const PeriodicOrbit<T>& orbit) {
    Stability stability{orbit.stable, {}};
    for (const Multiplier& each : orbit.multipliers) stability.multipliers.push_back({size_of(each.value), each.error, {}});
    return stability;
}

template OrbitSolution orbit_solution(ExactSolver<double>&, const PeriodicOrbit<double>&, std::optional<Mass>);
template std::optional<Certified> place_of_rest(const PeriodicOrbit<double>&, Mass);
template Stability stability_of(const PeriodicOrbit<double>&);

} // namespace denhartog
