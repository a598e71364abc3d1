/// @file
/// @brief Amplitude, phase and regime of the mass in contact over a grid of (r, beta): no sum is taken twice.
///
/// A frequency ratio costs its modes once, \f$ |V_{dj}| \f$ and two limits; a friction ratio then costs a square root:
/// \f[ \overline{X}_j = \sqrt{(|V_{dj}|-\beta U_{dj})(|V_{dj}|+\beta U_{dj})} - \beta G_j, \f]
/// (38) with the difference of squares as a product, which does not cancel near \f$ \beta|U_{dj}|=|V_{dj}| \f$. Where the contact
/// does not slide throughout there is no amplitude and no phase.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/map/contact_limits.hpp"
#include "denhartog/map/contact_sums.hpp"

namespace denhartog {

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

/// @brief Amplitudes of the mass in contact over a grid of (r, beta), from nothing but the system.
/// @eq{38,69}
/// @param basis    modal basis of the system
/// @param contact  the mass in contact, j
/// @param load     the loaded mass, l
/// @param mu       static over kinetic friction, Eq. (3); at least 1
/// @param r        frequency ratios, Eq. (10); positive
/// @param beta     friction ratios, Eq. (11); zero or positive
/// @param threads  threads, at least 1; the result does not depend on it
/// @return         the map, its regimes those of `regime_boundary` at every point
/// @throws         InputError where an argument breaks its rule; PrecisionError where a sum is beyond the range of a double
[[nodiscard]] ContactMap contact_map(const ModalBasis<double>& basis, Mass contact, Mass load, double mu,
                                     const std::vector<double>& r, const std::vector<double>& beta, unsigned threads);

/// @brief The same from sums and limits that are there already, in a map that is there already: its memory serves again.
/// @eq{38,69}
/// @param sums     sums over modes at the mass in contact, an entry a frequency ratio
/// @param limits   the limits, an entry a frequency ratio; points within `limit_margin()` of one by arrays need `settle_limits`
/// @param beta     friction ratios, Eq. (11); zero or positive
/// @param threads  threads, at least 1; the result does not depend on it
/// @param map      written over
/// @throws         InputError where a beta or the number of threads breaks its rule, or `limits` has another length than the sums
void contact_map(const ContactSums& sums, const ContactLimits& limits, const std::vector<double>& beta, unsigned threads,
                 ContactMap& map);

/// @brief Phases of the mass in contact over the grid of a map.
/// @eq{39}
/// @param sums     sums over modes at the mass in contact
/// @param map      regimes over the grid
/// @param beta     friction ratios of the map
/// @param threads  threads, at least 1; the result does not depend on it
/// @param phi_j    lag behind the force, Eq. (39), radians in [-pi, pi], point after point as in the map; 0 stands for none where
///                 `points` is not `continuous`
/// @throws         InputError where the number of threads breaks its rule, or the map has another size
void contact_phases(const ContactSums& sums, const ContactMap& map, const std::vector<double>& beta, unsigned threads,
                    std::vector<double>& phi_j);

/// @brief (38) over an array of friction ratios, the difference of squares as a product.
/// @eq{38}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function, Eq. (34)
/// @param G_j   second damping function, Eq. (35)
/// @param beta  friction ratios, Eq. (11)
/// @param X_j   where the amplitudes go; as long as beta
void amplitudes_of_contact(const Complex<double>& V_dj, double U_dj, double G_j, std::span<const double> beta,
                           std::span<double> X_j);

} // namespace denhartog
