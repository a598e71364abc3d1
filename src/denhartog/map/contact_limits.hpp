/// @file
/// @brief The friction ratios that part the regimes over an array of frequency ratios: (67), (69) and permanent sticking.
///
/// (69) is (67) wherever the sum (57) is largest for tau -> 0. `evaluation::certainty_of_start` tells where this is certain, and
/// the arrays answer. Elsewhere `regime_boundary` has to: where the maximum is to be sought, where the sums cancel too far, where
/// the load does not reach the contact, and at a resonance of the system with its contact held.
#pragma once

#include <cstdint>
#include <vector>

#include "denhartog/map/contact_sums.hpp"

namespace denhartog {

/// @brief Limits over an array of frequency ratios.
struct ContactLimits {
    std::vector<double> exact;         ///< beta_lim, Eq. (69)
    std::vector<double> sticking;      ///< the contact rests from here on
    std::vector<std::uint8_t> certain; ///< 1 where both are within `limit_margin()` of what `regime_boundary` has
};

/// @brief How far limits by arrays can be from those of `regime_boundary`, relative. @return a bound, far above both roundings
[[nodiscard]] constexpr double limit_margin() { return 0x1p-30; }

/// @brief The limits over an array of frequency ratios.
/// @eq{54,67,69,72}
/// @param sums     sums over modes there, from `contact_sums`
/// @param mu       static over kinetic friction, Eq. (3); at least 1
/// @param threads  threads, at least 1; the result does not depend on it
/// @param limits   written over: their memory serves again
/// @throws         InputError where mu or the number of threads breaks its rule
void contact_limits(const ContactSums& sums, double mu, unsigned threads, ContactLimits& limits);

/// @brief Whether the limits at a frequency ratio tell the regime at every friction ratio.
/// @param limits     the limits
/// @param m          index of the frequency ratio
/// @param ascending  friction ratios, sorted
/// @return           false where a limit is not certain, or a friction ratio is within `limit_margin()` of one
[[nodiscard]] bool limits_tell(const ContactLimits& limits, std::size_t m, const std::vector<double>& ascending);

} // namespace denhartog
