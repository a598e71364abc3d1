#include "denhartog/orbit/stability.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "denhartog/stick_slip/event_errors.hpp"

namespace denhartog {
namespace {

/// Error of the map's Jacobian in the largest sum of a row: some units in the last place for every phase and period of the modes.
template <class T>
double jacobian_error(const OrbitMap<T>& map, const Matrix<double>& jacobian) {
    const ContactSystem<T>& s = map.solver().system();
    const double turns = static_cast<double>(T(s.basis.r_n.back() / map.solver().excitation().r)) * map.half_periods();
    const double units = 4 * (static_cast<double>(map.motion().phases.size()) + 4 * turns);
    const double eps = std::max(std::numeric_limits<double>::epsilon(), static_cast<double>(std::numeric_limits<T>::epsilon()));
    return units * eps * largest_row_sum(jacobian);
}

/// The multipliers of a Jacobian between coordinates of the energy, where no event lets deviations grow by more than `growth`.
template <class T>
std::vector<Multiplier> multipliers_in_energy(const OrbitMap<T>& map, const Matrix<T>& jacobian, const T& error,
                                              const T& growth) {
    const long n = jacobian.rows();
    map.solver().effort().spend(n * n * n / 32); // what making the matrix diagonal takes
    const bool is_known = error >= 0;            // else it is no number
    return multipliers_of(in_double(jacobian), is_known ? static_cast<double>(error) : std::numeric_limits<double>::infinity(),
                          static_cast<double>(growth) * (1 + std::numeric_limits<double>::epsilon()));
}

/// What the events of a motion make of deviations, in the norm of the energy.
template <class T>
class Events {
public:
    Events(const OrbitMap<T>& map, const ErrorsOfOrbit<T>& errors)
        : solver_(map.solver()), e_(solver_.excitation()), basis_(solver_.system().basis),
          at_ends_(solver_, errors.displacement, errors.velocity),
          inertia_(basis_.phi.row(static_cast<Eigen::Index>(solver_.system().contact.index)).squaredNorm()) {
        using std::abs;
        T damping(0);
        if (basis_.coupled())
            damping = largest_row_sum(basis_.D);
        else
            for (std::size_t i = 0; i < basis_.r_n.size(); ++i)
                damping = std::max(damping, T(2 * abs(basis_.zeta[i]) * basis_.r_n[i]));
        rate_ = highest_over_force(solver_) + damping / e_.r;
        std::vector<T> velocities; // of the coordinates, for a unit of energy
        for (Eigen::Index k = 0; k < map.N; ++k) velocities.push_back(basis_.phi.row(k).norm());
        load_ = ErrorsAtEnds<T>(solver_, displacement_of_energy(map), velocities).of_load;
    }

    void add(std::size_t n, const Phase<T>& phase, int next) {
        const bool slides = phase.direction != 0;
        const EndOfPhase<T> end = solver_.end_of(n);
        const T apart = at_ends_.of_instant(end, slides); // infinite where the rate may vanish
        error += 2 * rate_ * apart;
        // That of the rate at the event, relative.
        const T off = (2 * end.second * apart + at_ends_.fastest * (slides ? at_ends_.of_velocity : at_ends_.of_load)) / end.rate;
        if (!slides) { // static friction ends, and the force drops: d load / rate is by how much the instant shifts
            if (e_.mu == 1) return;
            const T drop = (e_.mu - 1) * e_.beta * sqrt(inertia_) / e_.r * load_ / end.rate;
            take(drop * off, 1 + drop);
        } else if (next != 0) { // the force changes sides, and what is left of the acceleration is of the same sign
            const T jump = 2 * e_.beta * inertia_ / (e_.r * e_.r) / end.rate;
            take(jump * off, std::max(T(1), T(jump - 1)));
        } else if (std::ranges::any_of(solver_.system().stuck.m_j, [](const T& tie) { return tie != 0; })) {
            take(off + at_ends_.of_load * inertia_ / (e_.r * e_.r) / end.rate, T(1));
        }
    }

    T error{0};  // of the derivative, of all events
    T growth{1}; // of deviations

private:
    void take(const T& of_event, const T& factor) {
        error += of_event;
        if (e_.mu > 1) growth *= factor;
    }

    ExactSolver<T>& solver_;
    const Excitation<T>& e_;
    const ModalBasis<T>& basis_;
    ErrorsAtEnds<T> at_ends_;
    T inertia_; // e_j M^-1 e_j
    T rate_;    // how fast phases turn deviations
    T load_;    // of the contact that sticks, for a unit of energy
};

} // namespace

template <class T>
bool attracts(const OrbitMap<T>& map) {
    map.solver().effort().spend(map.N * map.N * map.N / 4); // some dozen products of whole matrices in `contracts`
    const Matrix<double> jacobian = in_double(map.energy_jacobian());
    return contracts(jacobian, jacobian_error(map, jacobian));
}

template <class T>
std::vector<Multiplier> multipliers_of_orbit(const OrbitMap<T>& map, const ErrorsOfOrbit<T>& errors) {
    Events<T> events(map, errors);
    const std::vector<Phase<T>>& phases = map.motion().phases;
    for (std::size_t n = 0; n + 1 < phases.size(); ++n) events.add(n, phases[n], phases[n + 1].direction);
    T error = events.growth * (events.error + map.rounding_of_jacobian());
    if (map.motion().touching > 0) error = std::numeric_limits<T>::infinity();
    return multipliers_in_energy(map, map.energy_jacobian(), error, events.growth);
}

template <class T>
StabilityOfRest stability_of_rest(const OrbitMap<T>& map) {
    const ContactSystem<T>& s = map.solver().system();
    const auto j = static_cast<Eigen::Index>(s.contact.index), others = map.N - 1;
    if (others == 0) return {true, {}};
    std::vector<Eigen::Index> kept;
    for (Eigen::Index k = 0; k < 2 * map.N; ++k)
        if (k != j && k != map.N + j) kept.push_back(k);
    const Matrix<T> jacobian = map.jacobian()(kept, kept);
    const Matrix<double> in_masses = in_double(jacobian);
    const T &r = map.solver().excitation().r, &slowest = s.stuck.r_n.front(), &fastest = s.stuck.r_n.back();
    // A stiffness that is off by some units of the largest, over the stretch, and products with mode shapes.
    const T phases = static_cast<int>(map.motion().phases.size()), eps = std::numeric_limits<T>::epsilon();
    const T turn = map.half_periods() * pi<T>() * fastest / r;
    const T error = 4 * (static_cast<int>(map.N) + 8) * eps * (phases + turn) * static_cast<int>(map.N) * (fastest / slowest);
    const Matrix<T> momentum = transpose_times(s.stuck.phi, s.stuck.M);
    const Matrix<T> in_energy = in_energy_coordinates(jacobian, momentum, s.stuck.phi, s.stuck.r_n, r);
    return {contracts(in_masses, jacobian_error(map, in_masses)), multipliers_in_energy(map, in_energy, error, T(1))};
}

template bool attracts(const OrbitMap<double>&);
template std::vector<Multiplier> multipliers_of_orbit(const OrbitMap<double>&, const ErrorsOfOrbit<double>&);
template StabilityOfRest stability_of_rest(const OrbitMap<double>&);

} // namespace denhartog
