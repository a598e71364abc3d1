#include "denhartog/orbit/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/stick_slip/event_errors.hpp"

namespace denhartog {
namespace {

/// Error of the map's Jacobian in the largest sum of a row: some units in the last place for every phase and period of the modes.
double jacobian_error(const OrbitMap& map, const Matrix<double>& jacobian) {
    const ContactSystem& s = map.solver().system();
    const double turns = s.basis.r_n.back() / map.solver().excitation().r * map.half_periods();
    const double units = 4 * (static_cast<double>(map.motion().phases.size()) + 4 * turns);
    return units * std::numeric_limits<double>::epsilon() * largest_row_sum(jacobian);
}

/// The multipliers of a Jacobian between coordinates of the energy, where no event lets deviations grow by more than `growth`.
std::vector<Multiplier> multipliers_in_energy(const OrbitMap& map, const Matrix<double>& jacobian, double error, double growth) {
    const long n = jacobian.rows();
    map.solver().effort().spend(n * n * n / 32); // what making the matrix diagonal takes
    const bool is_known = error >= 0;            // else it is no number
    return multipliers_of(jacobian, is_known ? error : std::numeric_limits<double>::infinity(),
                          growth * (1 + std::numeric_limits<double>::epsilon()));
}

/// What the events of a motion make of deviations, in the norm of the energy.
class Events {
public:
    Events(const OrbitMap& map, const ErrorsOfOrbit& errors)
        : solver_(map.solver()), e_(solver_.excitation()), basis_(solver_.system().basis),
          at_ends_(solver_, errors.displacement, errors.velocity), inertia_(solver_.system().contact_shape.squaredNorm()) {
        double damping = 0;
        if (basis_.coupled())
            damping = largest_row_sum(basis_.D);
        else
            for (std::size_t i = 0; i < basis_.r_n.size(); ++i)
                damping = std::max(damping, 2 * std::abs(basis_.zeta[i]) * basis_.r_n[i]);
        rate_ = highest_over_force(solver_) + damping / e_.r;
        std::vector<double> velocities; // for a unit of energy
        for (Eigen::Index k = 0; k < map.N; ++k) velocities.push_back(basis_.phi.row(k).norm());
        velocities.push_back(solver_.system().contact_shape.norm()); // where the contact has a row of its own
        load_ = ErrorsAtEnds(solver_, displacement_of_energy(map), velocities).of_load;
    }

    void add(std::size_t n, const Phase& phase, int next) {
        const bool slides = phase.direction != 0;
        const EndOfPhase end = solver_.end_of(n);
        const double apart = at_ends_.of_instant(end, slides); // infinite where the rate may vanish
        error += 2 * rate_ * apart;
        // That of the rate at the event, relative.
        const double off =
            (2 * end.second * apart + at_ends_.fastest * (slides ? at_ends_.of_velocity : at_ends_.of_load)) / end.rate;
        if (!slides) { // static friction ends, and the force drops: d load / rate is by how much the instant shifts
            if (e_.mu == 1) return;
            const double drop = (e_.mu - 1) * e_.beta * sqrt(inertia_) / e_.r * load_ / end.rate;
            take(drop * off, 1 + drop);
        } else if (next != 0) { // the force changes sides, and what is left of the acceleration is of the same sign
            const double jump = 2 * e_.beta * inertia_ / (e_.r * e_.r) / end.rate;
            take(jump * off, std::max(1.0, jump - 1));
        } else if (std::ranges::any_of(solver_.system().stuck.m_j, [](double tie) { return tie != 0; })) {
            take(off + at_ends_.of_load * inertia_ / (e_.r * e_.r) / end.rate, 1);
        }
    }

    double error = 0;  // of the derivative, of all events
    double growth = 1; // of deviations

private:
    void take(double of_event, double factor) {
        error += of_event;
        if (e_.mu > 1) growth *= factor;
    }

    ExactSolver& solver_;
    const Excitation& e_;
    const ModalBasis<double>& basis_;
    ErrorsAtEnds at_ends_;
    double inertia_; // w^T M^-1 w
    double rate_;    // how fast phases turn deviations
    double load_;    // of the contact that sticks, for a unit of energy
};

} // namespace

bool attracts(const OrbitMap& map) {
    map.solver().effort().spend(map.N * map.N * map.N / 4); // some dozen products of whole matrices in `contracts`
    const Matrix<double>& jacobian = map.energy_jacobian();
    return contracts(jacobian, jacobian_error(map, jacobian));
}

std::vector<Multiplier> multipliers_of_orbit(const OrbitMap& map, const ErrorsOfOrbit& errors) {
    Events events(map, errors);
    const std::vector<Phase>& phases = map.motion().phases;
    for (std::size_t n = 0; n + 1 < phases.size(); ++n) events.add(n, phases[n], phases[n + 1].direction);
    double error = events.growth * (events.error + map.rounding_of_jacobian());
    if (map.motion().touching > 0) error = std::numeric_limits<double>::infinity();
    return multipliers_in_energy(map, map.energy_jacobian(), error, events.growth);
}

StabilityOfRest stability_of_rest(const OrbitMap& map) {
    const ContactSystem& s = map.solver().system();
    if (map.N == 1) return {true, {}};
    const Contact& contact = s.stuck.contact;
    Matrix<double> all = map.jacobian();
    std::vector<Eigen::Index> kept;
    for (const Eigen::Index of_part : {Eigen::Index(0), map.N}) {
        if (contact.b) // which moves a
            all.col(of_part + static_cast<Eigen::Index>(*contact.b)) += all.col(of_part + static_cast<Eigen::Index>(contact.a));
        for (const Mass& k : s.stuck.masses) kept.push_back(of_part + static_cast<Eigen::Index>(k.index));
    }
    const Matrix<double> jacobian = all(kept, kept);
    const double r = map.solver().excitation().r, slowest = s.stuck.r_n.front(), fastest = s.stuck.r_n.back();
    // A stiffness that is off by some units of the largest, over the stretch, and products with mode shapes.
    const double phases = static_cast<int>(map.motion().phases.size()), eps = std::numeric_limits<double>::epsilon();
    const double turn = map.half_periods() * pi<double>() * fastest / r;
    const double error =
        4 * (static_cast<int>(map.N) + 8) * eps * (phases + turn) * static_cast<int>(map.N) * (fastest / slowest);
    const Matrix<double> momentum = transpose_times(s.stuck.phi, s.stuck.M);
    const Matrix<double> in_energy = in_energy_coordinates(jacobian, momentum, s.stuck.phi, s.stuck.r_n, r);
    return {contracts(jacobian, jacobian_error(map, jacobian)), multipliers_in_energy(map, in_energy, error, 1)};
}

} // namespace denhartog
