// The motion of the masses along a periodic orbit, and the stops of the contact. Read `set_motion_of_orbit`; `OnOrbit` has the
// states that it needs. `other_motions` seeks more orbits from other starts.

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/orbit/floquet.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/steady_state.hpp"

namespace denhartog {
namespace {

using std::abs;

// The states of an orbit. One that mirrors itself after half its period is moved along that half alone.
class OnOrbit {
public:
    OnOrbit(ExactSolver& solver_, const PeriodicOrbit& orbit)
        : solver(solver_), mirrors(orbit.symmetric), stretch((mirrors ? 1 : 2) * orbit.periods * pi<double>()) {
        phases = solver.run(orbit.start, 0.0, stretch).phases;
    }

    // The end of the phase before an instant, one of sliding or of sticking; the search for the end may have come to other last digits
    // before. None if no such phase ends there.
    std::optional<EndOfPhase> end_at(double tau, bool slides) {
        while (tau >= stretch) tau -= stretch;
        double nearest = sqrt(unit_of<double>()) * stretch;
        std::optional<std::size_t> found;
        for (std::size_t n = 0; n < phases.size(); ++n) {
            const Phase& p = phases[n];
            if ((p.direction != 0) != slides || !(p.end > p.start)) continue;
            const double apart = abs(p.end - tau), either_way = std::min(apart, abs(apart - stretch));
            if (either_way > nearest) continue;
            nearest = either_way;
            found = n;
        }
        return found ? std::optional(solver.end_of(*found)) : std::nullopt;
    }

    double frame = 0; // by how much the frame moves, if the states are wanted as they are seen from the ground

    State at(double tau) {
        const double instant = tau;
        bool mirrored = false;
        for (; tau < 0; tau += stretch) mirrored = mirrors && !mirrored;
        for (; tau > stretch; tau -= stretch) mirrored = mirrors && !mirrored;
        State state = solver.state_at(tau);
        for (std::vector<double>* part : {&state.x, &state.x_prime}) {
            solver.system().stuck.contact.append(*part);
            for (double& each : *part)
                if (mirrored) each = -each;
        }
        if (!(frame > 0)) return state;
        const auto [sine, cosine] = sine_cosine(instant);
        for (std::size_t k = 0; k < state.x.size(); ++k) {
            state.x[k] += frame * cosine;
            state.x_prime[k] -= frame * sine;
        }
        return state;
    }

private:
    ExactSolver& solver;
    bool mirrors;
    double stretch;
    std::vector<Phase> phases;
};

// Bound of the distance of the extremum of a mass from where it was found: as far as it takes until its size surely grows on one side and
// falls on the other, by more than the error of the velocity. A value alone does not tell the place: next to the extremum others
// are as large to all digits. A contact that comes to rest moves on one side only, and there by twice the error: what is left of
// the true velocity then ends within as much again.
double error_of_extremum(OnOrbit& orbit, std::size_t k, const MassMotion& mass, int periods, double velocity_error) {
    double nearest(-1), instant(0);
    for (int n = 0; n < 2 * periods; ++n) {
        const double tau = mass.phase + n * pi<double>();
        const double apart = abs(abs(orbit.at(tau).x[k]) - mass.amplitude);
        if (nearest >= 0 && apart >= nearest) continue;
        nearest = apart;
        instant = tau;
    }
    // The rates at which the size grows before the instant and falls after it.
    const auto rates = [&](double apart) {
        const auto growth = [&](const State& state) { return state.x[k] < 0 ? -state.x_prime[k] : state.x_prime[k]; };
        return std::pair{growth(orbit.at(instant - apart)), -growth(orbit.at(instant + apart))};
    };
    const double step = 1.0 / 1024;
    const auto [grows, falls] = rates(step);
    const double acceleration = std::max(abs(grows), abs(falls)) / step;
    double apart = acceleration > 0 ? velocity_error / acceleration : step;
    for (; apart < pi<double>(); apart *= 2) {
        const auto [before, after] = rates(apart);
        const double less = std::min(before, after);
        if (less >= velocity_error) return apart;
        if (less == 0 && std::max(before, after) >= 2 * velocity_error) return 2 * apart;
    }
    return pi<double>();
}

// The stops of an orbit.
std::vector<SolvedStop> stops_of(OnOrbit& on_orbit, const ExactSolver& solver, const PeriodicOrbit& orbit) {
    const auto instant = [&](double tau, bool slides) {
        const double anywhere = orbit.periods * pi<double>();
        const std::optional<EndOfPhase> end = on_orbit.end_at(tau, slides);
        const double found = end ? end->error_of_instant(solver.error_at_ends(slides, orbit.error_bound, orbit.velocity_errors)) +
                                       8 * unit_of<double>() * (1 + tau)
                                 : anywhere;
        return certified(Bounded<double>(tau, std::min(found, anywhere)));
    };
    std::vector<SolvedStop> stops;
    for (const Stop& stop : orbit.stops)
        stops.push_back(
            {instant(stop.start, true), instant(stop.end, false), certified(Bounded<double>(stop.x, orbit.error_bound))});
    return stops;
}

constexpr int seeded_starts = 12;
constexpr int sweep_steps = 6;
constexpr double sweep_reach = 0.15; // of r and of beta, to either side
constexpr int most_periods_followed = 3000;

State scaled(State z, double factor) {
    for (std::vector<double>* part : {&z.x, &z.x_prime})
        for (double& each : *part) each *= factor;
    return z;
}

class Explorer {
public:
    Explorer(const Scene<double>& scene_, const ContactSystem& system_,
             const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis_, Effort* effort_)
        : scene(scene_), system(system_), basis(*basis_), effort(effort_), solver(system, at(*scene.r, *scene.beta)),
          N(system.basis.r_n.size()), size(std::max(N, system.contact.index + 1), 1) {
        const auto slides = [&] {
            const ModeSums<double> sums = values_of(bounded_sums(scene.system, basis, as_input(*scene.r), effort));
            for (std::size_t k = 0; k < size.size(); ++k) size[k] = std::max(modulus(sums.V[k]), 1e-3);
            const Boundary<double> limits = boundary(sums, scene.mu);
            if (*scene.beta < limits.exact) sliding = sliding_at_maximum_of_force(sums, *scene.beta);
            return sliding.has_value();
        };
        (void)tried(slides);
    }

    std::vector<OtherMotion> all() {
        follow(at_rest(N), Why::start_from_rest);
        if (scene.mu == 1 && every_motion_is_damped(system.basis)) return motions;
        from_displaced_contact();
        from_sliding();
        from_seeds();
        for (const double side : {-1.0, 1.0}) {
            sweep(side * sweep_reach, 0, {Why::sweep, 0, side > 0});
            sweep(0, side * 2 * sweep_reach, {Why::sweep, 1, side > 0});
        }
        return motions;
    }

private:
    [[nodiscard]] Excitation at(double r, double beta) const { return {r, beta, scene.mu}; }

    void from_sliding() {
        if (!sliding) return;
        constexpr double factors[] = {1.0, 0.5, 2.0};
        for (int n = 0; n < 3; ++n) try_start(scaled(*sliding, factors[n]), {Why::scaled_sliding, n});
    }

    void from_displaced_contact() {
        const Contact& contact = system.stuck.contact;
        for (const double x : {0.5, 1.0, -1.0, 3.0}) {
            State z = at_rest(N);
            z.x[contact.a] = contact.over(x * size[system.contact.index]);
            try_start(z, Why::displaced);
        }
    }

    void from_seeds() {
        std::mt19937_64 generator(20220535); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same motions are found every time
        const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1; };
        for (int n = 0; n < seeded_starts; ++n) {
            State z = at_rest(N);
            const double scale = std::ldexp(1.0, n % 4 - 2);
            for (std::size_t k = 0; k < N; ++k) {
                z.x[k] = scale * size[k] * uniform();
                z.x_prime[k] = scale * size[k] * uniform();
            }
            try_start(z, {Why::random_start, n + 1});
        }
    }

    // Orbits of points on the way to the scene's, each started from the one before.
    void sweep(double r_away, double beta_away, const Reasons& found) {
        std::optional<State> z = sliding && beta_away < 0 ? *sliding : at_rest(N);
        for (int n = 0; n < sweep_steps; ++n) {
            const double left = 1 - static_cast<double>(n) / sweep_steps;
            solver.set(at(*scene.r * (1 + r_away * left), *scene.beta * (1 + beta_away * left)));
            const PeriodicOrbit orbit = periodic_orbit(solver, *z, search(true));
            if (!is_from_start(orbit)) break;
            z = orbit.start;
        }
        solver.set(at(*scene.r, *scene.beta));
        try_start(*z, found);
    }

    [[nodiscard]] OrbitSearch search(bool follow_start) const {
        OrbitSearch how;
        how.effort = effort;
        how.most_periods = follow_start ? most_periods_followed : 8;
        how.follow_start = follow_start;
        return how;
    }

    void try_start(const State& start, const Reasons& found) {
        follow(start, found);
        const PeriodicOrbit orbit = periodic_orbit(solver, start, search(false));
        if (orbit.status == OrbitStatus::periodic) add(orbit, orbit.start, Reasons(Why::newton) + found);
    }

    void follow(const State& start, const Reasons& found) {
        const PeriodicOrbit orbit = periodic_orbit(solver, start, search(true));
        if (is_from_start(orbit)) add(orbit, start, found);
    }

    void add(const PeriodicOrbit& orbit, const State& from, const Reasons& found) {
        const bool rests = orbit.status == OrbitStatus::permanently_stuck;
        for (const OtherMotion& known : motions)
            if (rests ? known.regime == Regime::permanent_sticking : same(known, orbit)) return;
        const Regime moves = orbit.stops.empty() ? Regime::continuous : Regime::stick_slip;
        const Regime regime = rests ? Regime::permanent_sticking : moves;
        OtherMotion motion{regime, from, found, orbit.periods, orbit.symmetric, stability_of(orbit), {}, {}, orbit.start, {}};
        Solution s;
        if (rests) {
            set_stuck_response(scene, system.stuck, basis, std::nullopt, s);
            if (std::isfinite(s.rest_interval->to.error)) { // where double gives one
                motion.rest_interval = s.rest_interval;
                motion.rest_interval->rests_at = place_of_rest(orbit);
            }
        } else {
            set_motion_of_orbit(scene, {Asked::phase, std::nullopt}, solver, orbit, s);
            motion.stops = std::move(s.stops);
        }
        motion.masses = std::move(s.masses);
        motions.push_back(std::move(motion));
    }

    // Whether an orbit is a known motion, or some periods of the force behind it.
    bool same(const OtherMotion& known, const PeriodicOrbit& orbit) {
        if (known.regime == Regime::permanent_sticking || known.periods != orbit.periods) return false;
        double scale = 0;
        for (const std::vector<double>* part : {&orbit.start.x, &orbit.start.x_prime})
            for (const double each : *part) scale = std::max(scale, std::abs(each));
        const double near = 1e-6 * scale + 4 * orbit.error_bound;
        State z = orbit.start;
        for (int n = 0; n < orbit.periods; ++n) {
            double apart = 0;
            for (std::size_t k = 0; k < N; ++k)
                apart = std::max({apart, std::abs(z.x[k] - known.start.x[k]), std::abs(z.x_prime[k] - known.start.x_prime[k])});
            if (apart <= near) return true;
            z = State(solver.run(z, 0, 2 * pi<double>()).end);
        }
        return false;
    }

    const Scene<double>& scene;
    const ContactSystem& system;
    const ModalBasis<Bounded<double>>& basis;
    Effort* effort;
    ExactSolver solver;
    std::size_t N;
    std::vector<double> size; // of the motion without friction
    std::optional<State> sliding;
    std::vector<OtherMotion> motions;
};

} // namespace

void set_motion_of_orbit(const Scene<double>& scene, const Question& question, ExactSolver& solver, const PeriodicOrbit& orbit,
                         Solution& s) {
    const bool all = question.asked == Asked::motion && !question.mass;
    const Contact& contact = solver.system().stuck.contact;
    const std::size_t j = solver.system().contact.index, N = orbit.start.x.size(), count = std::max(N, j + 1);
    const auto base = all ? amplitude_of_frame(scene.system.base_motion, as_input(*scene.r)) : std::nullopt;
    const double frame = base ? base->x : 0;
    OnOrbit on_orbit(solver, orbit);
    std::vector<MassMotion> absolute;
    if (frame > 0)
        for (const Extremum& each : solver.largest_displacements(orbit.error_bound, frame))
            absolute.push_back({std::abs(each.x), wrapped(each.x < 0 ? each.instant + pi<double>() : each.instant), each.spread});
    double largest = std::max(orbit.contact.amplitude, frame); // with the state at the start, where maxima were not sought
    for (double x : orbit.start.x) largest = std::max(largest, abs(x));
    for (const MassMotion& mass : orbit.masses) largest = std::max(largest, mass.amplitude);
    const double rounding = std::numeric_limits<double>::epsilon() * (16 * largest);
    const auto number = [](double x, double error) { return certified(Bounded<double>(x, error)); };
    const auto solved = [&](std::size_t k, const MassMotion& mass) {
        if (does_not_move(mass.amplitude, orbit.error_bound + rounding, largest))
            return SolvedMass{number(mass.amplitude, orbit.error_bound), std::nullopt, std::nullopt};
        const double velocity_error = orbit.velocity_errors[k] + rounding / 16;
        const double error_of_instant = error_of_extremum(on_orbit, k, mass, orbit.periods, velocity_error);
        const double phase_error = std::min(pi<double>(), error_of_instant + mass.spread + 4 * unit_of<double>());
        return SolvedMass{number(mass.amplitude, orbit.error_bound), number(mass.phase, phase_error), std::nullopt};
    };
    s.stops = stops_of(on_orbit, solver, orbit);
    s.masses = std::vector<SolvedMass>(count);
    s.relative_error = 0;
    for (std::size_t k = 0; k < count; ++k) {
        if (question.mass && k != question.mass->index) continue;
        const SolvedMass& mass = s.masses[k] = solved(k, k == j ? orbit.contact : orbit.masses[k]);
        if (!mass.phase) continue;
        const double relative = mass.amplitude.value > 0 ? orbit.error_bound / mass.amplitude.value : 1.0;
        s.relative_error = std::max({s.relative_error, relative, question.asked == Asked::amplitude ? 0 : mass.phase->error});
    }
    on_orbit.frame = frame;
    s.from_ground.clear();
    for (std::size_t k = 0; k < absolute.size(); ++k) s.from_ground.push_back(from_ground(solved(k, absolute[k]), *base));
    State start = orbit.start;
    for (std::vector<double>* part : {&start.x, &start.x_prime}) contact.append(*part);
    s.start.emplace();
    for (std::size_t k = 0; k < start.x.size(); ++k) {
        s.start->x.push_back(number(start.x[k], orbit.error_bound));
        s.start->x_prime.push_back(number(start.x_prime[k], orbit.velocity_errors[k]));
    }
    s.periods = orbit.periods;
    s.symmetric = orbit.symmetric;
    if (question.asked == Asked::motion) s.stability = stability_of(orbit);
}

std::optional<Certified> place_of_rest(const PeriodicOrbit& orbit) {
    const bool is_bounded = orbit.error_bound - orbit.error_bound == 0;
    if (!is_bounded) return std::nullopt;
    return certified(Bounded<double>(orbit.stops.front().x, orbit.error_bound));
}

Stability stability_of(const PeriodicOrbit& orbit) {
    Stability stability{orbit.stable, {}};
    for (const Multiplier& each : orbit.multipliers) stability.multipliers.push_back({size_of(each.value), each.error, {}});
    return stability;
}

std::vector<OtherMotion> other_motions(const Scene<double>& scene, const ContactSystem& system,
                                       const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis, Effort* effort) {
    return Explorer(scene, system, basis, effort).all();
}

} // namespace denhartog
