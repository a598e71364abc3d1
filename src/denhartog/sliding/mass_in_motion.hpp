/// @file
/// @brief The motion (46) of one mass over the half-period, instant by instant.
#pragma once

#include <span>
#include <vector>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/friction_motion.hpp"
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/sums/mode_sums.hpp"

namespace denhartog {

/// @brief The load's part of the motion of a mass. @eq{41} @param s modes @param k mass @param beta friction ratio @return its terms
template <class T>
[[nodiscard]] evaluation::HarmonicPart<T> harmonic_part(const ModeSums<T>& s, std::size_t k, const T& beta) {
    const std::size_t j = s.contact.index;
    return evaluation::harmonic_part(s.V[k], s.V[j], s.U[j], beta);
}

/// @brief Factors of the braces in (41), without beta. @eq{41} @param s modes @param k mass @return N factors
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

    /// @param s modes @param k mass @param beta_ friction ratio
    MassInMotion(const ModeSums<T>& s, std::size_t k, const T& beta_)
        : h(harmonic_part(s, k, beta_)), beta(beta_), weights(friction_weights(s, k)) {}
    /// @brief The motion. @eq{46} @param tau instant in [0, pi] @param y friction's share of every mode there @return x, x', x''
    [[nodiscard]] evaluation::MotionOfMass<T> at(const T& tau, const std::vector<evaluation::FrictionMotion<T>>& y) const {
        return evaluation::motion_of_mass(tau, h, beta, std::span<const T>(weights),
                                          std::span<const evaluation::FrictionMotion<T>>(y));
    }
};

} // namespace denhartog
