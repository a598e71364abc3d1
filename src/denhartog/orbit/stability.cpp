/// @file
/// @brief Stability of a periodic orbit: what is known of the eigenvalues of the map over its period.
#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/orbit/orbit_record.hpp"

namespace denhartog {
namespace {

// The multipliers of a Jacobian between energies, where no event lets deviations grow by more than `growth`.
std::vector<Multiplier> multipliers_in_energy(const OrbitMap& map, const Matrix<double>& jacobian, double error, double growth) {
    const long n = jacobian.rows();
    map.solver().effort().spend(n * n * n / 32); // what making the matrix diagonal takes
    const bool is_known = error >= 0;            // else it is no number
    return multipliers_of(jacobian, is_known ? error : std::numeric_limits<double>::infinity(),
                          growth * (1 + std::numeric_limits<double>::epsilon()));
}

} // namespace

std::vector<Multiplier> multipliers_next_to(const OrbitMap& map) {
    const double growth = map.solver().excitation().mu == 1 ? 1 : std::numeric_limits<double>::infinity();
    return multipliers_in_energy(map, map.energy_jacobian(), map.rounding_of_jacobian(), growth);
}

std::vector<Multiplier> multipliers_of_orbit(const OrbitMap& map, const ErrorsOfOrbit& errors) {
    const ExactMotion& motion = map.motion();
    ExactSolver& solver = map.solver();
    const ContactSystem& s = solver.system();
    const Excitation& e = solver.excitation();
    const ModalBasis<double>& basis = s.basis;
    double damping = basis.coupled() ? largest_row_sum(basis.D) : 0;
    for (std::size_t i = 0; i < basis.r_n.size() && !basis.coupled(); ++i)
        damping = std::max(damping, 2 * std::abs(basis.zeta[i]) * basis.r_n[i]);
    const double fastest = highest_over_force(solver), rate = fastest + damping / e.r; // how fast phases turn deviations
    const double inertia = s.contact_shape.squaredNorm();                              // w^T M^-1 w
    std::vector<double> velocities;                                                    // for a unit of energy
    for (Eigen::Index k = 0; k < map.N; ++k) velocities.push_back(basis.phi.row(k).norm());
    velocities.push_back(s.contact_shape.norm()); // where the contact has a row of its own
    const double load =
        error_at_ends(solver, false, displacement_of_energy(map), velocities); // of a contact that sticks, likewise
    const double of_velocity = error_at_ends(solver, true, errors.displacement, errors.velocity),
                 of_load = error_at_ends(solver, false, errors.displacement, errors.velocity);
    const bool tied = std::ranges::any_of(s.stuck.m_j, [](double tie) { return tie != 0; });
    double error = map.rounding_of_jacobian(), growth = 1; // of the derivative, of all events; of deviations
    const auto take = [&](double of_event, double factor) {
        error += of_event;
        if (e.mu > 1) growth *= factor;
    };
    for (std::size_t n = 0; n + 1 < motion.phases.size(); ++n) {
        const bool slides = motion.phases[n].direction != 0;
        const EndOfPhase end = solver.end_of(n);
        const double apart = end.error_of_instant(slides ? of_velocity : of_load); // infinite where the rate may vanish
        error += 2 * rate * apart;
        // That of the rate at the event, relative.
        const double off = (2 * end.second * apart + fastest * (slides ? of_velocity : of_load)) / end.rate;
        if (!slides) { // static friction ends, and the force drops: d load / rate is by how much the instant shifts
            if (e.mu == 1) continue;
            const double drop = (e.mu - 1) * e.beta * sqrt(inertia) / e.r * load / end.rate;
            take(drop * off, 1 + drop);
        } else if (motion.phases[n + 1].direction != 0) { // the force changes sides, and the acceleration keeps its sign
            const double jump = 2 * e.beta * inertia / (e.r * e.r) / end.rate;
            take(jump * off, std::max(1.0, jump - 1));
        } else if (tied) {
            take(off + of_load * inertia / (e.r * e.r) / end.rate, 1);
        }
    }
    if (motion.touching > 0) error = std::numeric_limits<double>::infinity();
    return multipliers_in_energy(map, map.energy_jacobian(), growth * error, growth);
}

std::vector<Multiplier> multipliers_of_rest(const OrbitMap& map) {
    const ContactSystem& s = map.solver().system();
    if (map.N == 1) return {};
    const double r = map.solver().excitation().r, slowest = s.stuck.r_n.front(), fastest = s.stuck.r_n.back();
    // A stiffness that is off by some units of the largest, over the stretch, and products with mode shapes.
    const double phases = static_cast<int>(map.motion().phases.size()), eps = std::numeric_limits<double>::epsilon();
    const double turn = map.half_periods() * pi<double>() * fastest / r;
    const double error =
        4 * (static_cast<int>(map.N) + 8) * eps * (phases + turn) * static_cast<int>(map.N) * (fastest / slowest);
    return multipliers_in_energy(map, in_energy_coordinates(map.jacobian(), s.stuck.momentum, s.stuck.shapes, s.stuck.r_n, r),
                                 error, 1);
}

} // namespace denhartog
