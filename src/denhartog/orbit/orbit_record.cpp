// What is said of an orbit that was found? `orbit_of` reads stops, amplitudes, phases and multipliers off it, `errors_of` bounds
// how far it may be from the true one, and `rest_of` does the same for a contact at rest.
#include "denhartog/orbit/periodic_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {
namespace {

// A displacement of its largest size as amplitude and phase.
MassMotion motion_with(double x, double tau, double spread = 0.0) {
    if (x < 0) return {-x, wrapped(tau + pi<double>()), spread};
    return {x, wrapped(tau), spread};
}

// Stops within the period, those across the section and the mirror point in one piece; starts ascending in [0, period).
std::vector<Stop> stops_of(const OrbitMap& map) {
    const ExactMotion& motion = map.motion();
    const auto N = static_cast<std::size_t>(map.N);
    const Contact& contact = map.solver().system().stuck.contact;
    const bool mirrored = map.half_periods() % 2 != 0;
    const double stretch = map.half_periods() * pi<double>(), period = mirrored ? 2 * stretch : stretch;
    std::vector<Stop> stops;
    bool resting = false; // at the end of what was looked at
    for (int part = 0; part < (mirrored ? 2 : 1); ++part)
        for (std::size_t n = 0; n < motion.phases.size(); ++n) {
            const Phase& p = motion.phases[n];
            if (!(p.end > p.start)) continue;
            const double end = p.end + part * stretch, x_j = contact.of(&motion.states[2 * N * n]);
            if (p.direction == 0 && resting)
                stops.back().end = end;
            else if (p.direction == 0)
                stops.push_back({p.start + part * stretch, end, part == 0 ? x_j : -x_j});
            resting = p.direction == 0;
        }
    if (resting && stops.size() > 1 && stops.front().start == 0) {
        stops.back().end = stops.front().end + period;
        stops.erase(stops.begin());
    }
    return stops;
}

// Amplitude and phase of the mass in contact, which is farthest out where it turns back or comes to rest. Another such place may
// be the farthest as well, if the displacements there differ by no more than their error.
MassMotion contact_motion(const OrbitMap& map, double error) {
    const ExactMotion& motion = map.motion();
    const auto N = static_cast<std::size_t>(map.N);
    const auto x_at = [&](std::size_t n) { return map.solver().system().stuck.contact.of(&motion.states[2 * N * n]); };
    // A rest counts from its start: neither where it ends, nor, of one across the start of the stretch, what the stretch has of
    // it first. Elsewhere the start of the stretch comes last and has to be larger by more than rounding.
    const bool rests_across =
        motion.phases.size() > 1 && motion.phases.front().direction == 0 && motion.phases.back().direction == 0;
    double x = rests_across ? 0.0 : x_at(0) * (1 - 16 * double_epsilon), tau = 0;
    for (std::size_t n = 1; n < motion.phases.size(); ++n) {
        if (motion.phases[n - 1].direction == 0) continue;
        const double x_j = x_at(n);
        if (std::abs(x_j) > std::abs(x)) {
            x = x_j;
            tau = motion.phases[n].start;
        }
    }
    MassMotion contact = motion_with(x, tau);
    for (std::size_t n = 1; n < motion.phases.size(); ++n) {
        const double x_j = x_at(n);
        if (motion.phases[n - 1].direction == 0 || std::abs(x_j) < contact.amplitude - 2 * error) continue;
        const double apart = wrapped(motion_with(x_j, motion.phases[n].start).phase - contact.phase);
        contact.spread = std::max(contact.spread, std::abs(apart));
    }
    return contact;
}

// The multipliers of a Jacobian between energies, if no event lets deviations grow by more than `growth`.
std::vector<Multiplier> multipliers_in_energy(const OrbitMap& map, const Matrix<double>& jacobian, double error, double growth) {
    const long n = jacobian.rows();
    map.solver().effort().spend(n * n * n / 32); // what making the matrix diagonal takes
    const bool is_known = error >= 0;            // else it is no number
    return multipliers_of(jacobian, is_known ? error : std::numeric_limits<double>::infinity(), growth * (1 + double_epsilon));
}

// Multipliers of the others, over the stretch of the map that was applied to a motion whose contact rested throughout.
std::vector<Multiplier> multipliers_of_rest(const OrbitMap& map) {
    const ContactSystem& s = map.solver().system();
    if (map.N == 1) return {};
    const double r = map.solver().excitation().r, slowest = s.stuck.r_n.front(), fastest = s.stuck.r_n.back();
    // A stiffness that is off by some units of the largest, over the stretch, and products with mode shapes.
    const double phases = static_cast<int>(map.motion().phases.size());
    const double turn = map.half_periods() * pi<double>() * fastest / r;
    const double error =
        4 * (static_cast<int>(map.N) + 8) * double_epsilon * (phases + turn) * static_cast<int>(map.N) * (fastest / slowest);
    return multipliers_in_energy(map, in_energy_coordinates(map.jacobian(), s.stuck.momentum, s.stuck.shapes, s.stuck.r_n, r),
                                 error, 1);
}

} // namespace

std::optional<ErrorsOfOrbit> errors_of(const OrbitMap& map) {
    const Matrix<double>& jacobian = map.energy_jacobian();
    const LinearSystem system(Matrix<double>(Matrix<double>::Identity(2 * map.N, 2 * map.N) - jacobian));
    if (!system.is_regular()) return std::nullopt;
    const Matrix<double> inverse = system.inverse();
    const Column apart = map.in_energy(map.difference()).cwiseAbs();
    const double growth = map.solver().excitation().mu > 1 ? std::max(1.0, jacobian.norm()) : 1.0;
    const auto energy = [&](bool mode_errors) {
        return growth * product_of_sizes(inverse, Column(apart + map.rounding_in_energy(mode_errors))).norm();
    };
    const ContactSystem& s = map.solver().system();
    const Contact& contact = s.stuck.contact;
    double sizes = 1; // of the terms of the displacement of the contact
    for (const BesideContact& other : contact.others) sizes += std::abs(other.share);
    const double terms = std::max(1.0, std::abs(contact.w_a) * sizes);
    const auto displacement = [&](double by_energy, const Column& rounding) {
        return map.displacement_of_energy() * by_energy + terms * rounding.head(map.N).maxCoeff();
    };
    const double with_modes = energy(true);
    const Column rounding = map.rounding(true);
    ErrorsOfOrbit errors{displacement(energy(false), map.rounding(false)), displacement(with_modes, rounding), {}};
    for (Eigen::Index k = 0; k < map.N; ++k)
        errors.velocity.push_back(s.basis.phi.row(k).norm() * with_modes + rounding(map.N + k));
    if (contact.has_own_row()) {
        const auto of = [&](std::size_t k) { return rounding(map.N + static_cast<Eigen::Index>(k)); };
        double sum = s.contact_shape.norm() * with_modes + std::abs(contact.w_a) * of(contact.a);
        for (const BesideContact& other : contact.others) sum += std::abs(other.w) * of(other.k);
        errors.velocity.push_back(sum);
    }
    return errors;
}

std::optional<PeriodicOrbit> orbit_of(const OrbitMap& map, const State& z, const OrbitSearch& search) {
    const std::optional<ErrorsOfOrbit> errors = errors_of(map);
    if (!errors) return std::nullopt;
    PeriodicOrbit orbit;
    const double bound = errors->settled;
    orbit.contact = contact_motion(map, bound);
    if (!map.slides_throughout() && !(bound < orbit.contact.amplitude)) return std::nullopt; // no sure slip
    double largest = orbit.contact.amplitude, unsure = 0;
    for (const double x : z.x) largest = std::max(largest, x < 0 ? -x : x);
    if (!search.contact_only) {
        for (const Extremum& extremum : map.solver().largest_displacements(bound)) {
            orbit.masses.push_back(motion_with(extremum.x, extremum.instant, extremum.spread));
            unsure = std::max(unsure, extremum.unsure);
        }
        orbit.masses[map.solver().system().contact.index] = orbit.contact;
    }
    for (const MassMotion& mass : orbit.masses) largest = std::max(largest, mass.amplitude);
    orbit.error_bound = bound + unsure;
    if (!std::isfinite(largest) || !(100 * orbit.error_bound < largest)) return std::nullopt; // as at a resonance without damping
    orbit.error_bound = errors->displacement + unsure;
    orbit.velocity_errors = errors->velocity;
    const int h = map.half_periods();
    orbit.status = OrbitStatus::periodic;
    orbit.start = z;
    orbit.symmetric = h % 2 != 0;
    orbit.periods = orbit.symmetric ? h : h / 2;
    orbit.stops = stops_of(map);
    orbit.touching = map.motion().touching;
    if (search.with_stability) {
        orbit.multipliers = multipliers_of_orbit(map, *errors);
        // With mu = 1, or without stops, no deviation grows, wherever the events are; if every motion is damped it falls.
        const bool shrinks = map.solver().excitation().mu == 1 || (map.slides_throughout() && orbit.touching == 0);
        orbit.stable = are_inside(orbit.multipliers) ||
                       (shrinks && (every_motion_is_damped(map.solver().system().basis) ||
                                    (map.solver().excitation().mu == 1 && are_inside(multipliers_next_to(map)))));
        if (orbit.symmetric) orbit.multipliers = squared(std::move(orbit.multipliers));
    }
    if (orbit.touching > 0) orbit.reason = Why::grazes;
    return orbit;
}

std::optional<PeriodicOrbit> rest_of(OrbitMap& map, const LastingRest& rest, double x_j, const OrbitSearch& search) {
    PeriodicOrbit orbit;
    orbit.start = rest.steady_state(x_j);
    if (!map.apply(orbit.start, 2, true) || !map.held()) return std::nullopt;
    orbit.status = OrbitStatus::permanently_stuck;
    orbit.symmetric = x_j == 0;
    orbit.stops = {{0, 2 * pi<double>(), x_j}};
    for (std::size_t k = 0; k < orbit.start.x.size(); ++k) orbit.masses.push_back(rest.motion(k, x_j));
    orbit.contact = motion_with(x_j, 0);
    if (map.solver().system().stuck.contact.has_own_row()) orbit.masses.push_back(orbit.contact);
    if (search.contact_only) orbit.masses.clear();
    orbit.error_bound = map.rounding(true).maxCoeff() + map.difference().cwiseAbs().maxCoeff();
    if (search.with_stability) {
        orbit.multipliers = multipliers_of_rest(map);
        orbit.stable = every_motion_is_damped(map.solver().system().basis) || map.N == 1 || are_inside(orbit.multipliers);
    }
    return orbit;
}

std::vector<Multiplier> multipliers_next_to(const OrbitMap& map) {
    const double growth = map.solver().excitation().mu == 1 ? 1 : std::numeric_limits<double>::infinity();
    return multipliers_in_energy(map, map.energy_jacobian(), map.rounding_of_jacobian(), growth);
}

// The Jacobian is as far off as rounding makes it and as the instants of events are off: a phase that is longer by delta turns it by
// delta times the rate of the fastest mode, and what an event makes of deviations depends on the acceleration, or the rate of the
// load, at its instant. In the norm of the energy neither a phase nor, with mu = 1, an event lets deviations grow, so that the
// errors add up; for mu > 1 the product of the growths is allowed for.
std::vector<Multiplier> multipliers_of_orbit(const OrbitMap& map, const ErrorsOfOrbit& errors) {
    const ExactMotion& motion = map.motion();
    ExactSolver& solver = map.solver();
    const ContactSystem& s = solver.system();
    const Excitation& e = solver.excitation();
    const ModalBasis<double>& basis = s.basis;
    double damping = basis.coupled() ? largest_row_sum(basis.D) : 0;
    for (std::size_t i = 0; i < basis.r_n.size() && !basis.coupled(); ++i)
        damping = std::max(damping, 2 * std::abs(basis.zeta[i]) * basis.r_n[i]);
    const double fastest = solver.highest_over_force(), rate = fastest + damping / e.r; // how fast phases turn deviations
    const double inertia = s.contact_shape.squaredNorm();                               // w^T M^-1 w
    std::vector<double> velocities;                                                     // for a unit of energy
    for (Eigen::Index k = 0; k < map.N; ++k) velocities.push_back(basis.phi.row(k).norm());
    velocities.push_back(s.contact_shape.norm()); // where the contact has a row of its own
    const double load =
        solver.error_at_ends(false, map.displacement_of_energy(), velocities); // of a contact that sticks, likewise
    const double error_of_velocity = solver.error_at_ends(true, errors.displacement, errors.velocity),
                 error_of_load_at_end = solver.error_at_ends(false, errors.displacement, errors.velocity);
    const bool tied = std::ranges::any_of(s.stuck.m_j, [](double tie) { return tie != 0; });
    double error = map.rounding_of_jacobian(), growth = 1; // of the derivative, of all events; of deviations
    const auto take = [&](double error_of_event, double factor) {
        error += error_of_event;
        if (e.mu > 1) growth *= factor;
    };
    for (std::size_t n = 0; n + 1 < motion.phases.size(); ++n) {
        const bool slides = motion.phases[n].direction != 0;
        const EndOfPhase end = solver.end_of(n);
        const double apart =
            end.error_of_instant(slides ? error_of_velocity : error_of_load_at_end); // infinite where the rate may vanish
        error += 2 * rate * apart;
        // That of the rate at the event, relative.
        const double off = (2 * end.second * apart + fastest * (slides ? error_of_velocity : error_of_load_at_end)) / end.rate;
        if (!slides) { // static friction ends, and the force drops: d load / rate is by how much the instant shifts
            if (e.mu == 1) continue;
            const double drop = (e.mu - 1) * e.beta * sqrt(inertia) / e.r * load / end.rate;
            take(drop * off, 1 + drop);
        } else if (motion.phases[n + 1].direction != 0) { // the force changes sides, and the acceleration keeps its sign
            const double jump = 2 * e.beta * inertia / (e.r * e.r) / end.rate;
            take(jump * off, std::max(1.0, jump - 1));
        } else if (tied) {
            take(off + error_of_load_at_end * inertia / (e.r * e.r) / end.rate, 1);
        }
    }
    if (motion.touching > 0) error = std::numeric_limits<double>::infinity();
    return multipliers_in_energy(map, map.energy_jacobian(), growth * error, growth);
}

} // namespace denhartog
