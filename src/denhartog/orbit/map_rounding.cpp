#include "denhartog/orbit/map_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

struct RoundingOfPhases {
    const ContactSystem& s;
    const Excitation& e;
    const ExactMotion& motion;
    double length; // of the stretch
    Eigen::Index N = static_cast<Eigen::Index>(s.basis.r_n.size());

    // How far errors may turn a mode towards another one, and what that then makes of it.
    struct Turn {
        double angle;
        double damping;   // difference of their dampings
        double stiffness; // forces of the one on the other over the amplitude and the angle
    };

    Turn turn_of(std::size_t i, std::size_t k) const {
        const double r_i = s.basis.r_n[i], r_k = s.basis.r_n[k];
        const double angle =
            angle_of_turn(Bounded<double>(r_i, r_i * s.detuned[i]), Bounded<double>(r_k, r_k * s.detuned[k])) / 8;
        const double damping = 2 * std::abs(s.basis.zeta[i] * r_i - s.basis.zeta[k] * r_k);
        return {angle, damping, std::abs(r_i - r_k) * (r_i + r_k) + damping * std::max(e.r, r_k)};
    }

    // Damping hands the rounding of one mode to the others: in energy it is that of all of them, over the steps of the series.
    void add_coupled_modes(const std::vector<double>& amplitudes, Column<double>& modal) const {
        const ModalBasis<double>& basis = s.basis;
        const double r = e.r;
        double energy = 0;
        for (Eigen::Index i = 0; i < N; ++i)
            energy += basis.r_n[static_cast<std::size_t>(i)] / r * amplitudes[static_cast<std::size_t>(i)];
        const double rounding = of_coupled_modes() * energy;
        for (Eigen::Index i = 0; i < N; ++i) modal(i) += rounding * r / basis.r_n[static_cast<std::size_t>(i)];
    }

    // The same over the energy.
    double of_coupled_modes() const {
        const ModalBasis<double>& basis = s.basis;
        const double rate = 1 + (basis.r_n.back() + largest_row_sum(basis.D)) / e.r;
        const double steps = static_cast<int>(motion.phases.size()) + length * rate;
        return 4 * static_cast<int>(2 * N + 2) * std::numeric_limits<double>::epsilon() * steps;
    }

    // What rounding makes of the image: a bound of each modal coordinate's error that is kept until the next time.
    //
    // Every phase adds some units in the last place of the terms of the coordinate. A natural frequency that is some units
    // off, at least N, turns the mode by that part of its phase angle, which is the larger the more of its periods fit in the
    // stretch. Modes are turned towards each other by rounding: the difference of their stiffnesses and of their dampings then
    // lets the one force the other, which follows it at rest or is driven over the stretch. Of modes of nearly one frequency the
    // angle may be large; where they are damped differently, that damps each of them by some of the other's damping. All these
    // errors are taken as an eighth of the bounds of the closed form. What a damping matrix loses on its way to the modes, where
    // large dashpots nearly cancel, is a force on each mode over the whole stretch.
    MapRounding of_image() const {
        const auto n = static_cast<std::size_t>(N);
        const double eps = std::numeric_limits<double>::epsilon();
        std::vector<double> amplitudes;
        Column<double> modal(N), turned = Column<double>::Zero(N);
        for (Eigen::Index i = 0; i < N; ++i) {
            const double r_n = s.basis.r_n[static_cast<std::size_t>(i)];
            double largest = 0, largest_sum = 0; // amplitude of the mode; the same with the sums over masses of sizes
            for (std::size_t a = 0; a < motion.phases.size(); ++a) {
                const double *x = &motion.states[2 * n * a], *v = x + n;
                double q = 0, p = 0, q_sum = 0, p_sum = 0;
                for (Eigen::Index k = 0; k < N; ++k) {
                    const double q_k = s.momentum(i, k) * x[k], p_k = s.momentum(i, k) * v[k];
                    q += q_k;
                    p += p_k;
                    q_sum += std::abs(q_k);
                    p_sum += std::abs(p_k);
                }
                const double slow = e.r / r_n;
                largest = std::max(largest, q * q + slow * slow * p * p);
                largest_sum = std::max(largest_sum, std::max(q_sum, slow * p_sum));
            }
            const double friction = e.beta * std::abs(s.contact_shape(i)) / (r_n * r_n);
            amplitudes.push_back(sqrt(largest) + friction);
            const double of_frequency = length * r_n / e.r * amplitudes.back();
            modal(i) =
                eps * (static_cast<int>(motion.phases.size()) * (largest_sum + friction) + static_cast<int>(N) * of_frequency);
            // No step of Newton's method mends what a frequency is off by beyond that.
            turned(i) = std::max(0.0, s.detuned[static_cast<std::size_t>(i)] / 8 - static_cast<int>(N) * eps) * of_frequency;
        }
        if (s.basis.coupled()) add_coupled_modes(amplitudes, modal);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < n; ++k) {
                if (k == i) continue;
                const double r_i = s.basis.r_n[i], r_k = s.basis.r_n[k];
                const Turn turn = turn_of(i, k);
                double& of_mode = turned(static_cast<Eigen::Index>(i));
                const double force = turn.stiffness * amplitudes[k];
                of_mode += (2 + length) * (turn.angle + static_cast<int>(N + 1) * eps) * force / (r_i * std::max(e.r, r_i));
                if (s.damping_fixes_modes || 64 * std::abs(r_i - r_k) > r_i + r_k) continue;
                const double of_others = turn.angle * r_k / r_i * amplitudes[k],
                             of_itself = turn.angle * turn.angle * amplitudes[i];
                of_mode += length * turn.damping / e.r * (of_others + of_itself);
            }
        for (Eigen::Index i = 0; i < s.damping_error.rows(); ++i)
            for (Eigen::Index k = 0; k < N; ++k) {
                const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
                turned(i) += length * s.damping_error(i, k) / e.r * (s.basis.r_n[b] / s.basis.r_n[a]) * amplitudes[b];
            }
        return {std::move(modal), std::move(turned)};
    }

    double of_jacobian() const {
        const double r = e.r, eps = std::numeric_limits<double>::epsilon();
        const double phases = static_cast<int>(motion.phases.size()), units = 4 * (static_cast<int>(N) + 8) * eps * phases;
        Column<double> rows = Column<double>::Zero(N), columns = rows; // sums of what errors hand from mode to mode
        for (Eigen::Index i = 0; i < N; ++i)
            for (Eigen::Index k = 0; k < N; ++k) {
                const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
                const double r_i = s.basis.r_n[a], r_k = s.basis.r_n[b];
                double part = units * std::max(1.0, r_i / r_k); // products with mode shapes
                if (i == k) {
                    part += length * r_i / r * std::max(s.detuned[a] / 8, static_cast<int>(N) * eps);
                } else {
                    const Turn turn = turn_of(a, b);
                    const double angle = turn.angle + static_cast<int>(N + 1) * eps;
                    part += (2 + length) * angle * (turn.stiffness / (r_k * std::max(r, r_i)) + turn.damping / r);
                }
                if (s.damping_error.size() > 0) part += length * s.damping_error(i, k) / r;
                rows(i) += part;
                columns(k) += part;
            }
        double sum = sqrt(rows.maxCoeff() * columns.maxCoeff());
        if (s.basis.coupled()) sum += of_coupled_modes();
        return sum;
    }
};

} // namespace

MapRounding rounding_of_map(const ExactSolver& solver, const ExactMotion& motion, double length) {
    return RoundingOfPhases{solver.system(), solver.excitation(), motion, length}.of_image();
}

double rounding_of_jacobian(const ExactSolver& solver, const ExactMotion& motion, double length) {
    return RoundingOfPhases{solver.system(), solver.excitation(), motion, length}.of_jacobian();
}

} // namespace denhartog
