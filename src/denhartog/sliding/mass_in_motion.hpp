/// @file
/// @brief The motion (46) of one mass over the half-period, instant by instant.
#pragma once

#include <span>
#include <vector>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/friction_motion.hpp"
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/sums/coupled_friction.hpp"
#include "denhartog/sums/friction_motion.hpp"
#include "denhartog/sums/mode_sums.hpp"

namespace denhartog {

/// @brief Factors of the braces in (41), without beta. @eq{41}
template <class T>
[[nodiscard]] std::vector<T> friction_weights(const ModeSums<T>& s, std::size_t k) {
    const auto psi_k = mode_shapes_at(s, Mass{k});
    const auto psi_j = mode_shapes_at(s, s.contact);
    std::vector<T> weights;
    weights.reserve(s.R.size());
    for (std::size_t i = 0; i < s.R.size(); ++i) weights.push_back(psi_k[i] * psi_j[i] * s.R[i] * s.R[i]);
    return weights;
}

/// @brief A mass at instants of the half-period.
template <class T>
struct MassInMotion {
    evaluation::HarmonicPart<T> h; ///< what the load does
    T beta;                        ///< friction ratio, Eq. (11)
    std::vector<T> weights;        ///< of `friction_weights`

    /// @brief Mass k of the modes at a friction ratio.
    MassInMotion(const ModeSums<T>& s, std::size_t k, const T& beta_)
        : h(evaluation::harmonic_part(s.V[k], s.V[s.contact.index], s.U[s.contact.index], beta_)), beta(beta_),
          weights(friction_weights(s, k)) {}
    /// @brief The motion x, x', x'' at an instant in [0, pi], of which the cosine and the sine are given; `so_far` is friction's
    /// share that is no mode's. @eq{46}
    [[nodiscard]] evaluation::MotionOfMass<T> at(const T& C, const T& S, std::span<const evaluation::FrictionMotion<T>> y,
                                                 const evaluation::FrictionMotion<T>& so_far = {T(0), T(0), T(0)}) const {
        return evaluation::motion_of_mass(C, S, h, beta, std::span<const T>(weights), y, so_far);
    }
};

/// @brief Friction's share of the motion at an instant: of every mode, or of a mass if damping couples them.
template <class T>
struct FrictionShare {
    T cosine;                                            ///< of the instant
    T sine;                                              ///< of the instant
    std::vector<evaluation::FrictionMotion<T>> of_modes; ///< N; none if damping couples the modes
    evaluation::FrictionMotion<T> of_mass;               ///< then that of the mass, else zero
};

/// @brief Friction's share, at an instant in [0, pi], of the motion of a mass that is no mode's: all of it if damping couples
/// the modes, else none.
template <class T>
[[nodiscard]] evaluation::FrictionMotion<T> share_of_no_mode(const ModeSums<T>& s, std::size_t k, const T& tau) {
    return s.coupled ? s.coupled->motion(k, tau) : evaluation::FrictionMotion<T>{T(0), T(0), T(0)};
}

/// @brief Friction's share of the motion of a mass at an instant in [0, pi].
template <class T>
[[nodiscard]] FrictionShare<T> friction_share(const ModeSums<T>& s, std::size_t k, const T& tau) {
    const SineCosine<T> at = sine_cosine(tau);
    return {at.c, at.s, s.coupled ? std::vector<evaluation::FrictionMotion<T>>{} : friction_motions(s, tau),
            share_of_no_mode(s, k, tau)};
}

/// @brief Motion (46) of a mass with friction's share at an instant. @eq{46}
template <class T>
[[nodiscard]] evaluation::MotionOfMass<T> motion_with(const MassInMotion<T>& mass, const FrictionShare<T>& y) {
    return mass.at(y.cosine, y.sine, y.of_modes, y.of_mass);
}

} // namespace denhartog
