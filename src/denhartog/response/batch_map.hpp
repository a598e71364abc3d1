/// @file
/// @brief X_j and the boundary (67) over arrays of r and beta, with everything of beta taken out of the sums.
///
/// A frequency ratio costs its modes once, \f$ |V_{dj}| \f$ and two limits; a friction ratio then costs a square root:
/// \f[ \overline{X}_j = \sqrt{(|V_{dj}|-\beta|U_{dj}|)(|V_{dj}|+\beta|U_{dj}|)} - \beta G_j, \f]
/// (38) with the difference of squares as a product, which does not cancel near \f$ \beta|U_{dj}|=|V_{dj}| \f$. The regime comes
/// from the boundaries that the caller gives, e.g. those of `boundary_curves`; where the contact does not slide throughout there is
/// no amplitude.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "denhartog/response/batch_sums.hpp"
#include "denhartog/response/regime_map.hpp"

namespace denhartog {

/// @brief The boundary (67), with (72), over an array of frequency ratios: an upper bound of beta_lim.
/// @eq{67,72}
/// @param sums  sums over modes at the mass in contact
/// @param mu    static over kinetic friction, Eq. (3); at least 1
/// @return      the friction ratio, an entry a frequency ratio; 0 at poles
/// @throws      InputError where mu breaks its rule
[[nodiscard]] std::vector<double> approximate_limits(const ContactSums& sums, double mu);

/// @brief What a point of a batch is.
enum class BatchPoint : std::uint8_t {
    continuous = 0,         ///< the contact slides throughout: there is an amplitude
    stick_slip = 1,         ///< it sticks and slips: no amplitude
    permanent_sticking = 2, ///< it rests: no amplitude
    without_numbers = 3     ///< there is no boundary, as at the resonance of a mode without damping: no amplitude
};

/// @brief Amplitudes of the mass in contact over a grid.
struct ContactMap {
    std::size_t rows = 0;           ///< number of friction ratios
    std::vector<BatchPoint> points; ///< point n of column m at m times `rows` plus n
    std::vector<double> X_j; ///< amplitude, Eq. (38), at the same place; 0 stands for none where `points` is not `continuous`
};

/// @brief The amplitude at a point of a map.
/// @param map     the map
/// @param column  number of the frequency ratio
/// @param row     number of the friction ratio
/// @return        X_j in units of P / k_1; none where the contact does not slide throughout
[[nodiscard]] std::optional<double> amplitude_at(const ContactMap& map, std::size_t column, std::size_t row);

/// @brief Amplitudes of the mass in contact over a grid of (r, beta).
/// @eq{38,69}
/// @param sums    sums over modes at the mass in contact, an entry a frequency ratio
/// @param limits  the boundaries, an entry a frequency ratio
/// @param beta    friction ratios, Eq. (11); zero or positive
/// @param threads threads, at least 1; the result does not depend on it
/// @return        the map
/// @throws        InputError where a beta or the number of threads breaks its rule, or `limits` has another length than the sums
[[nodiscard]] ContactMap contact_map(const ContactSums& sums, std::span<const BoundaryPoint> limits,
                                     const std::vector<double>& beta, unsigned threads);

/// @brief The same in a map that is there already: its memory serves again.
/// @param sums    sums over modes at the mass in contact, an entry a frequency ratio
/// @param limits  the boundaries, an entry a frequency ratio
/// @param beta    friction ratios, Eq. (11); zero or positive
/// @param threads threads, at least 1
/// @param map     written over
/// @throws        as above
void contact_map(const ContactSums& sums, std::span<const BoundaryPoint> limits, const std::vector<double>& beta,
                 unsigned threads, ContactMap& map);

} // namespace denhartog
