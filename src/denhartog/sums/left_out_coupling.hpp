/// @file
/// @brief What sums over modes may be off by because a damping matrix couples the modes by less than rounding tells.
///
/// With \f$ Q_i \f$ the share of mode i in the motion, \f$ x_k = \sum_i \psi_{ki}Q_i \f$, what is left out of (20) is a force
/// \f$ -\sum_m (E_{im}/r)\,Q_m' \f$ on it, of which bounds of E are known. The response of a mode to any force that changes its
/// sign after half a period is at most \f$ \int_0^\pi|\Gamma_i| \f$ times the largest force, with the kernel
/// \f[ \Gamma_i(\tau) = \frac{R_i}{w_i}\,\mathrm{Im}\frac{e^{\rho_i\tau}}{1+e^{\rho_i\pi}}, \qquad
///     \rho_i = \frac{-\zeta_i+\mathrm{i}w_i}{R_i}, \qquad \frac{1}{|1+e^{\rho_i\pi}|} = \frac{w_i}{2}\,|c_i|, \f]
/// where the brace of (40) is \f$ 1 - \mathrm{Re}\{c_ie^{\rho_i\tau}\} \f$. It is therefore at most \f$ \pi|c_i|R_i/2 \f$ times
/// that force, its derivative \f$ \pi|c_i|/2 \f$ times. From \f$ \zeta_i = 1/2 \f$ on the response to an impulse dies away within
/// a swing: \f$ 2R_i^2 \f$ and \f$ 2R_i \f$ bound both, and the brace has \f$ R_i|y_i'| \le 2 \f$,
/// \f$ R_i^2|y_i''| \le 3+4\zeta_i \f$.
///
/// What is left out exerts such forces in its turn. Where these are below half of it, which is asked for, they at most double the
/// largest of all modes.
#pragma once

#include "denhartog/number/bounded.hpp"
#include "denhartog/sums/mode_sums.hpp"

namespace denhartog {

/// @brief A mode as it answers to the forces of others and exerts forces on them: bounds.
template <class T>
struct ModeUnderCoupling {
    T gain;         ///< amplitude under a unit harmonic force
    T kernel;       ///< largest response to a unit force that changes its sign
    T kernel_prime; ///< its largest derivative
    T of_load;      ///< amplitude under the load
    T of_contact;   ///< amplitude under a unit harmonic force on the contact
    T speed;        ///< largest derivative under the friction force
    T acceleration; ///< largest second derivative
};

/// @brief The bounds of a mode.
template <class T>
[[nodiscard]] ModeUnderCoupling<T> mode_under_coupling(const ModeSums<Bounded<T>>& s, std::size_t i) {
    const T R = s.R[i].most(), gain = R * R * modulus(s.v[i]).most();
    const T psi_j = mode_shapes_at(s, s.contact)[i].most(), psi_l = mode_shapes_at(s, s.load)[i].most();
    if (s.zeta[i].least() >= T(1) / 2)
        return {gain, 2 * R * R, 2 * R, gain * psi_l, gain * psi_j, 2 * R * psi_j, (3 + 4 * s.zeta[i].most()) * psi_j};
    const T c = amplitude_of_brace(s, i).most(), half_turn = T(11) / 7; // more than pi / 2
    return {gain, half_turn * c * R, half_turn * c, gain * psi_l, gain * psi_j, c * R * psi_j, c * psi_j};
}

/// @brief Nothing is left out where numbers have no bounds.
template <class T>
[[nodiscard]] std::vector<LeftOut<T>> left_out_coupling(const ModalBasis<T>&, const ModeSums<T>&) {
    return {};
}

/// @brief Bounds of what the coupling left out makes of the motion of each row of the shapes. There are none where nothing is
/// left out, and infinite ones where the forces of what is left out are not small. The sums of `s` are not used. @eq{33,40}
template <class T>
[[nodiscard]] std::vector<LeftOut<T>> left_out_coupling(const ModalBasis<Bounded<T>>& basis, const ModeSums<Bounded<T>>& s) {
    if (basis.left_out.size() == 0) return {};
    const std::size_t N = basis.r_n.size();
    std::vector<ModeUnderCoupling<T>> modes;
    for (std::size_t i = 0; i < N; ++i) modes.push_back(mode_under_coupling(s, i));
    // Forces on each mode: of the motion without coupling, then of what is left out as well.
    struct Forces {
        T load{}, contact{}, friction{}, friction_prime{}, of_unit{};
    };
    std::vector<Forces> forces(N);
    T V(0), Y(0), x_prime(0), x_double_prime(0), largest(0);
    const auto acceleration_of = [&](std::size_t i) { // of what the force of friction's share makes
        const T rate = 1 / s.R[i].least(), force = forces[i].friction;
        return T((2 * s.zeta[i].most() * rate * modes[i].kernel_prime + rate * rate * modes[i].kernel + 1) * force);
    };
    for (std::size_t i = 0; i < N; ++i) {
        Forces& on = forces[i];
        for (std::size_t m = 0; m < N; ++m) {
            const T E = basis.left_out(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m)).x / s.r.least();
            on.load += E * modes[m].of_load;
            on.contact += E * modes[m].of_contact;
            on.friction += E * modes[m].speed;
            on.friction_prime += E * modes[m].acceleration;
            on.of_unit += E;
        }
        V = std::max(V, T(modes[i].gain * on.load));
        Y = std::max(Y, T(modes[i].gain * on.contact));
        x_prime = std::max(x_prime, T(modes[i].kernel_prime * on.friction));
        largest = std::max(largest, T(std::max(modes[i].gain, modes[i].kernel_prime) * on.of_unit));
    }
    const T slack = 2 * largest < 1 ? T(T(17) / 16) : std::numeric_limits<T>::infinity(); // roundings, or there is no bound
    for (std::size_t i = 0; i < N; ++i) {
        forces[i].load += 2 * forces[i].of_unit * V;
        forces[i].contact += 2 * forces[i].of_unit * Y;
        forces[i].friction += 2 * forces[i].of_unit * x_prime;
        x_double_prime = std::max(x_double_prime, acceleration_of(i));
    }
    std::vector<LeftOut<T>> rows(s.psi.size() / N);
    for (std::size_t i = 0; i < N; ++i) {
        const Forces& on = forces[i];
        const T rate = 1 / s.R[i].least(), acceleration = acceleration_of(i);
        const T jerk = 2 * s.zeta[i].most() * rate * acceleration + rate * rate * modes[i].kernel_prime * on.friction +
                       on.friction_prime + on.of_unit * x_double_prime;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const T psi = slack * mode_shapes_at(s, Mass{k})[i].most();
            rows[k].V += psi * modes[i].gain * on.load;
            rows[k].Y += psi * modes[i].gain * on.contact;
            rows[k].x += psi * modes[i].kernel * on.friction;
            rows[k].x_prime += psi * modes[i].kernel_prime * on.friction;
            rows[k].x_double_prime += psi * acceleration;
            rows[k].x_triple_prime += psi * jerk;
        }
    }
    return rows;
}

} // namespace denhartog
