#include "denhartog/answer/orbit_solution.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/held_solution.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/sliding/coupled_sums.hpp"

namespace denhartog {
namespace {

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
        if (rests) {
            const HeldSolution held = held_solution(scene, system.stuck, basis);
            motion.masses = held.masses;
            if (std::isfinite(held.rest_interval.to.error)) { // where double gives one
                motion.rest_interval = held.rest_interval;
                motion.rest_interval->rests_at = place_of_rest(orbit);
            }
        } else {
            const OrbitSolution found_orbit = orbit_solution(solver, orbit);
            motion.masses = found_orbit.masses;
            motion.stops = found_orbit.stops;
        }
        motions.push_back(std::move(motion));
    }

    // The same motion, or one that is some periods of the force behind.
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

std::vector<OtherMotion> other_motions(const Scene<double>& scene, const ContactSystem& system,
                                       const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis, Effort* effort) {
    return Explorer(scene, system, basis, effort).all();
}

} // namespace denhartog
