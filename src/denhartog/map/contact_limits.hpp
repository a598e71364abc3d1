/// @file
/// @brief The friction ratios that part the regimes over an array of frequency ratios: (67), (69) and permanent sticking.
///
/// (69) is (67) wherever the sum (57) is largest for tau -> 0. `evaluation::certainty_of_start` tells where this is certain, and
/// the arrays answer; elsewhere the maximum is sought by `regime_boundary`, one frequency ratio at a time, and counted. So is
/// what cancels too far in the sums, a load that does not reach the contact, and a resonance of the system with its contact held.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "denhartog/map/contact_sums.hpp"

namespace denhartog {

/// @brief Where the limits of a frequency ratio come from.
enum class LimitSource : std::uint8_t {
    arrays = 0, ///< the arrays: within `limit_margin()` of what `regime_boundary` has
    search = 1, ///< `regime_boundary`
    none = 2    ///< there is none: a mode without damping resonates, or the digits of double do not suffice
};

/// @brief Limits over an array of frequency ratios.
struct ContactLimits {
    std::vector<double> exact;       ///< beta_lim, Eq. (69); 0 where there is none
    std::vector<double> sticking;    ///< the contact rests from here on; infinite where no friction can hold it
    std::vector<LimitSource> source; ///< where they come from
};

/// @brief How far limits by arrays can be from those of `regime_boundary`, relative. @return a bound, far above both roundings
[[nodiscard]] constexpr double limit_margin() { return 0x1p-30; }

/// @brief The boundary (67), with (72), over an array of frequency ratios: an upper bound of beta_lim.
/// @eq{67,72}
/// @param sums  sums over modes at the mass in contact
/// @param mu    static over kinetic friction, Eq. (3); at least 1
/// @return      the friction ratio, an entry a frequency ratio; 0 at poles
/// @throws      InputError where mu breaks its rule
[[nodiscard]] std::vector<double> approximate_limits(const ContactSums& sums, double mu);

/// @brief The limits over an array of frequency ratios.
/// @eq{54,67,69,72}
/// @param basis    modal basis of the system
/// @param contact  the mass in contact, j
/// @param load     the loaded mass, l
/// @param mu       static over kinetic friction, Eq. (3); at least 1
/// @param r        frequency ratios
/// @param sums     sums over modes there, from `contact_sums`
/// @param threads  threads, at least 1; the result does not depend on it
/// @return         the limits
/// @throws         InputError where an argument breaks its rule, or the sums have another length than r
[[nodiscard]] ContactLimits contact_limits(const ModalBasis<double>& basis, Mass contact, Mass load, double mu,
                                           const std::vector<double>& r, const ContactSums& sums, unsigned threads);

/// @brief The same in limits that are there already: their memory serves again.
/// @param basis    modal basis of the system
/// @param contact  the mass in contact, j
/// @param load     the loaded mass, l
/// @param mu       static over kinetic friction, Eq. (3); at least 1
/// @param r        frequency ratios
/// @param sums     sums over modes there, from `contact_sums`
/// @param threads  threads, at least 1
/// @param limits   written over
/// @throws         as above
void contact_limits(const ModalBasis<double>& basis, Mass contact, Mass load, double mu, const std::vector<double>& r,
                    const ContactSums& sums, unsigned threads, ContactLimits& limits);

/// @brief Replaces the limits that a friction ratio is within `limit_margin()` of by those of `regime_boundary`.
/// @param basis    modal basis of the system
/// @param contact  the mass in contact, j
/// @param load     the loaded mass, l
/// @param mu       static over kinetic friction, Eq. (3)
/// @param r        frequency ratios
/// @param beta     friction ratios
/// @param limits   the limits, written over
/// @return         how many frequency ratios were looked at again
std::size_t settle_limits(const ModalBasis<double>& basis, Mass contact, Mass load, double mu, const std::vector<double>& r,
                          const std::vector<double>& beta, ContactLimits& limits);

/// @brief How many limits over arrays were left to `regime_boundary` since the program started; tests gate on it.
/// @return the count, over all threads
[[nodiscard]] long limits_left_to_search();

} // namespace denhartog
