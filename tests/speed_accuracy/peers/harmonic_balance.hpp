/// @file
/// @brief Harmonic balance by alternating frequency and time, as small as it can be: odd harmonics, one contact.
///
/// Unknown are the harmonics \f$ \lambda_n \f$ of friction on the contact alone: the linear system is condensed to its
/// receptances there, \f$ X_n = \delta_{n1} h_l - h_n \lambda_n \f$. In time, friction is a law of its trial
/// \f$ \lambda \f$ and of \f$ \bar{x}_j' \f$. Odd harmonics describe every motion that mirrors itself after half a
/// period, Eq. (25).
#pragma once

#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief The law of friction in time, with a width w in velocity.
enum class FrictionLaw {
    regularised,         ///< beta tanh(v / w)
    augmented_lagrangian ///< exact Coulomb: lambda is what lies nearest in [-beta, beta] to lambda + beta v / w
};

/// @brief A setting of harmonic balance.
struct HarmonicBalanceSetting {
    FrictionLaw law;       ///< the law
    int highest;           ///< highest harmonic, odd
    double sharpness = 10; ///< width of the law: the velocity of the first harmonic over (highest times sharpness)
};

/// @brief Harmonic balance at one setting. @param setting the setting @return the method; its unit of work is a Newton step
[[nodiscard]] Peer harmonic_balance(const HarmonicBalanceSetting& setting);

/// @brief Both laws with harmonics up to 1, 3, 5, 11, 21, 51, 101. @return the methods
[[nodiscard]] std::vector<Peer> harmonic_balance_peers();

} // namespace denhartog::tests
