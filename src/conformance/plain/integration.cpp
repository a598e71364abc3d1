#include "conformance/plain/closed_form.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/formulas/stuck.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

constexpr double period = 2 * std::numbers::pi;

// Displacement of a mass on a stretch of motion of one period from the maximum of the force on.
double displacement_at(ExactSolver& solver, const std::vector<Phase>& phases, double tau, std::size_t k) {
    std::size_t n = 0;
    while (n + 1 < phases.size() && phases[n].end < tau) ++n;
    return solver.state_at(n, tau).x[k];
}

// Where the contact turns or comes to rest as far from zero as it gets, but for rounding: it may rest there at both ends of the
// stretch as well, where it does not arrive.
Extremum largest_of_contact(const ExactMotion& motion, std::size_t contact, Extremum largest) {
    const std::size_t N = motion.end.x.size();
    const double least = std::abs(largest.x) * (1 - 1e-12);
    bool arrives = false;
    for (std::size_t n = 1; n < motion.phases.size(); ++n) {
        const double x = motion.states[2 * N * n + contact];
        const bool rested = motion.phases[n - 1].direction == 0;
        if (rested || (arrives ? std::abs(x) <= std::abs(largest.x) : std::abs(x) < least)) continue;
        largest = {x, motion.phases[n].start, 0};
        arrives = true;
    }
    return largest;
}

// The answer that a period of a solver shows.
std::optional<Value> read_off(ExactSolver& solver, const ExactMotion& motion, const ProtocolQuestion& q) {
    const std::size_t contact = solver.system().contact.index;
    const std::size_t k = q.mass > 0 ? static_cast<std::size_t>(q.mass - 1) : contact;
    if (q.quantity == "motion_under_force")
        return sampled(q, [&](double tau) { return displacement_at(solver, motion.phases, tau, k); });
    Extremum largest = solver.largest_displacements()[k];
    if (k == contact) largest = largest_of_contact(motion, k, largest);
    if (q.quantity == "amplitude") return Value{{std::abs(largest.x)}, ""};
    if (q.quantity == "phase") return Value{{std::remainder(largest.instant + (largest.x < 0 ? pi<double>() : 0), period)}, ""};
    return std::nullopt;
}

std::vector<double> durations(const std::vector<Stop>& stops) {
    std::vector<double> lengths;
    for (const Stop& stop : stops) lengths.push_back(stop.end - stop.start);
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

std::optional<Value> answer_of_stuck_motion(const ProtocolQuestion& q, const Scene<double>& scene) {
    const StuckConfiguration stuck = stuck_configuration(scene.system, modal_basis(scene.system));
    const StuckResponse response = stuck_response(stuck, scene.system.load, *scene.r);
    if (q.quantity == "rest_interval") {
        const double margin = paper::sticking_margin(modulus(response.contact_load), scene.mu, *scene.beta);
        return margin < 0 ? std::nullopt : std::optional(Value{{margin / stuck.k_contact}, ""});
    }
    if (q.quantity == "stops_per_period") return Value{{0}, ""};
    if (q.quantity == "stop_durations") return Value{};
    const StuckMass& mass = response.masses[static_cast<std::size_t>(q.mass - 1)];
    if (q.quantity == "amplitude") return Value{{mass.amplitude}, ""};
    if (q.quantity == "phase") return mass.phase ? std::optional(Value{{*mass.phase}, ""}) : std::nullopt;
    return sampled(q, [&](double tau) { return times_cosine(mass.X, tau); });
}

} // namespace

std::optional<Value> answer_of_steady_motion(const ProtocolQuestion& q) {
    const Scene<double> scene = scene_of(q);
    const ContactSystem system = contact_system(scene.system);
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    OrbitSearch how;
    how.contact_only = true;
    how.with_stability = false;
    how.most_periods = 4000;
    const PeriodicOrbit orbit = periodic_orbit(solver, at_rest(q.mass_ratios.size()), how);
    if (orbit.status == OrbitStatus::permanently_stuck) return answer_of_stuck_motion(q, scene);
    if (orbit.status != OrbitStatus::periodic || orbit.periods != 1) return std::nullopt;
    if (q.quantity == "stops_per_period") return Value{{static_cast<double>(orbit.stops.size())}, ""};
    if (q.quantity == "stop_durations") return Value{durations(orbit.stops), ""};
    return read_off(solver, solver.run(orbit.start, 0.0, period), q);
}

std::vector<std::optional<Value>> answers_of_transient(const ProtocolQuestion& q, int first, int last) {
    if (!is_of_the_paper(q)) return std::vector<std::optional<Value>>(static_cast<std::size_t>(last - first + 1));
    const Scene<double> scene = scene_of(q);
    const ContactSystem system = contact_system(scene.system);
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    State state = at_rest(q.mass_ratios.size());
    std::vector<std::optional<Value>> answers;
    for (int n = 1; n <= last; ++n) {
        const ExactMotion& motion = solver.run(state, 0.0, period);
        state = motion.end;
        if (n >= first) answers.push_back(read_off(solver, motion, q));
    }
    return answers;
}

std::optional<Value> answer_of_creep(const ProtocolQuestion& q, double width) {
    if (q.mass != q.contact || !is_of_the_paper(q)) return std::nullopt;
    const Scene<double> scene = scene_of(q);
    const StuckConfiguration stuck = stuck_configuration(scene.system, modal_basis(scene.system));
    const Complex<double> load = stuck_response(stuck, scene.system.load, *scene.r).contact_load;
    const double share = modulus(load) / *scene.beta;
    if (!(share < 1)) return std::nullopt;
    // The integral of the velocity from 0 to s, by the midpoint rule: the integrand is smooth and of period 2 pi.
    const auto path = [&](double s) {
        constexpr int steps = 2048;
        double sum = 0;
        for (int n = 0; n < steps; ++n) {
            const double x = share * elementary::cos(s * (n + 0.5) / steps);
            sum += elementary::log((1 + x) / (1 - x));
        }
        return -width * sum * s / (2 * steps);
    };
    if (q.quantity == "amplitude") return Value{{std::abs(path(period / 4))}, ""};
    if (q.quantity != "motion_under_force") return std::nullopt;
    return sampled(q, [&](double tau) { return path(std::remainder(tau + argument(load), period)); });
}

} // namespace denhartog::conformance
