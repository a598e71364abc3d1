// Bounds of an orbit in double, and of the map of which it is a fixed point. `bound_rounding` bounds what rounding makes of the image,
// `rounding_of_jacobian` what it makes of the derivative. `errors_of` follows: how far the orbit is from the true one;
// `multipliers_of_orbit` adds what the instants of events leave open.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

// The multipliers of a Jacobian between energies, if no event lets deviations grow by more than `growth`.
std::vector<Multiplier> multipliers_in_energy(const OrbitMap& map, const Matrix<double>& jacobian, double error, double growth) {
    const long n = jacobian.rows();
    map.solver().effort().spend(n * n * n / 32); // what making the matrix diagonal takes
    const bool is_known = error >= 0;            // else it is no number
    return multipliers_of(jacobian, is_known ? error : std::numeric_limits<double>::infinity(), growth * (1 + double_epsilon));
}

} // namespace

// The largest size of each mode over the motion, in energy; between the starts of phases friction may shift it.
Column OrbitMap::largest_energies() const {
    const ContactSystem& s = solver_->system();
    const auto n = static_cast<std::size_t>(N);
    Column largest = Column::Zero(N);
    for (std::size_t phase = 0; phase < motion_->phases.size(); ++phase) {
        const Column z = in_energy(Eigen::Map<const Column>(&motion_->states[2 * n * phase], 2 * N));
        for (Eigen::Index i = 0; i < N; ++i) largest(i) = std::max(largest(i), elementary::hypot(z(i), z(N + i)));
    }
    for (std::size_t i = 0; i < n; ++i)
        largest(i) += solver_->excitation().beta * std::abs(s.contact_shape(i)) / (s.basis.r_n[i] * solver_->excitation().r);
    return largest;
}

// Error in each mode, the row, over the stretch, by a unit of energy of one mode, the column.
//
// Every phase adds some units in the last place of what it makes of the modes; Newton's method settles each mode to its own. A
// natural frequency that is some units off, at least N, turns the mode by that part of its phase angle, which is the larger the
// more of its periods fit in the stretch. Modes are turned towards each other by rounding: the difference of their stiffnesses
// and of their dampings then lets the one force the other, which follows it at rest or is driven over the stretch. Of modes of
// nearly one frequency the angle may be large; if they are damped differently, that damps each of them by some of the
// other's damping. All these errors are taken as an eighth of the bounds of the closed form. What a damping matrix loses on its
// way to the modes, where large dashpots nearly cancel, is a force on each mode over the whole stretch.
Matrix<double> OrbitMap::errors_between_modes(double units, bool mode_errors) const {
    const ContactSystem& s = solver_->system();
    const double r = solver_->excitation().r, length = h_ * pi<double>();
    Matrix<double> E = Matrix<double>::Zero(N, N);
    for (std::size_t i = 0; i < s.basis.r_n.size(); ++i) {
        const double r_i = s.basis.r_n[i];
        for (std::size_t k = 0; k < s.basis.r_n.size(); ++k) {
            const double r_k = s.basis.r_n[k];
            E(i, k) += units * (mode_errors ? std::max(1.0, r_i / r_k) : i == k);
            if (i == k)
                E(i, i) += length * r_i / r * std::max(mode_errors ? s.detuned[i] / 8 : 0, static_cast<int>(N) * double_epsilon);
            if (i == k || !mode_errors) continue;
            const double angle =
                static_cast<int>(N + 1) * double_epsilon +
                angle_of_turn(Bounded<double>(r_i, r_i * s.detuned[i]), Bounded<double>(r_k, r_k * s.detuned[k])) / 8;
            const double damping = 2 * std::abs(s.basis.zeta[i] * r_i - s.basis.zeta[k] * r_k);
            const double stiffness = std::abs(r_i - r_k) * (r_i + r_k) + damping * std::max(r, r_k);
            E(i, k) += (2 + length) * angle * stiffness / (r_k * std::max(r, r_i));
            if (s.damping_fixes_modes && 64 * std::abs(r_i - r_k) <= r_i + r_k) continue;
            E(i, k) += (2 + length) * angle * damping / r;
            E(i, i) += length * angle * angle * damping / r;
        }
    }
    if (mode_errors && s.damping_error.size() > 0) E += length / r * s.damping_error;
    return E;
}

// Damping hands the rounding of one mode to the others: in energy it is that of all of them, over the steps of the series.
double OrbitMap::rounding_of_coupled_modes() const {
    const ModalBasis<double>& basis = solver_->system().basis;
    if (!basis.coupled()) return 0;
    const double rate = 1 + (basis.r_n.back() + largest_row_sum(basis.D)) / solver_->excitation().r;
    const double steps = static_cast<int>(motion_->phases.size()) + h_ * pi<double>() * rate;
    return 4 * static_cast<int>(2 * N + 2) * double_epsilon * steps;
}

void OrbitMap::bound_rounding() {
    const Column energies = largest_energies();
    const double units = double_epsilon * static_cast<int>(motion_->phases.size());
    const double rounding_of_coupled = rounding_of_coupled_modes() * energies.sum();
    rounding_ = (errors_between_modes(units, false) * energies).array() + rounding_of_coupled;
    with_mode_errors_ = (errors_between_modes(units, true) * energies).array() + rounding_of_coupled;
}

double OrbitMap::rounding_of_jacobian() const {
    const double phases = static_cast<int>(motion_->phases.size());
    const double units = 4 * (static_cast<int>(N) + 8) * double_epsilon * phases;
    const Matrix<double> E = errors_between_modes(units, true);
    return sqrt(E.rowwise().sum().maxCoeff() * E.colwise().sum().maxCoeff()) + rounding_of_coupled_modes();
}

Column OrbitMap::rounding_in_energy(bool mode_errors) const {
    return (mode_errors ? with_mode_errors_ : rounding_).replicate(2, 1);
}

Column OrbitMap::rounding(bool mode_errors) const {
    const Column& of = mode_errors ? with_mode_errors_ : rounding_;
    Column bound = Column::Zero(2 * N);
    for (Eigen::Index k = 0; k < N; ++k)
        for (Eigen::Index i = 0; i < N; ++i) {
            const double v = std::abs(solver_->system().basis.phi(k, i)) * of(i);
            bound(k) += v / omega(i);
            bound(N + k) += v;
        }
    return bound;
}

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
        solver.error_at_ends(false, map.displacement_of_energy(), velocities); // of a contact that sticks, for a unit of energy
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
