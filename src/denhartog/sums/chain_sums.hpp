/// @file
/// @brief V and U of a chain without damping from its springs and masses: no sum over modes, nothing cancels.
///
/// Far above the natural frequencies a chain hands the force on from mass to mass, each time smaller by \f$ 1/r^2 \f$, while
/// every mode contributes as much as to the loaded mass: the sum over modes of (33) and (34) loses about
/// \f$ 2|k-l|\log_{10}r \f$ digits.
/// Without damping \f$ V_d \f$ is a column of \f$ (K-r^2M)^{-1} \f$, by elimination from both ends, and \f$ U_d \f$ with
/// \f$ p=1/R^2 \f$ and \f$ R\tan\frac{\pi}{2R} = \frac{4}{\pi}\sum_{n\ge1}(1-4^{-n})\,\zeta(2n)\,p^{n-1} \f$ a power series of
/// \f$ M^{-1}K/r^2 \f$ applied to the contact, in which all terms of a mass have one sign.
#pragma once

#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {

/// @brief Sums over modes with bounds of their errors; of a chain without damping, V and U the other way where that
/// has the smaller bound.
/// @eq{33,34}
/// @param system  the system
/// @param modes   its modes
/// @return        modes and sums
/// @throws        DomainError at a pole of a mode without damping
[[nodiscard]] ModeSums<Bounded<double>> bounded_sums(const System<double>& system, BoundedModes<double>& modes);

/// @brief A column of \f$ (K-r^2M)^{-1} \f$ of a chain: \f$ V_{dk} \f$ without damping.
/// @eq{33}
/// @param gamma  masses, N values
/// @param kappa  springs, N values or N + 1
/// @param load   the loaded mass, l
/// @param r      frequency ratio
/// @return       N values; the bounds are infinite where an elimination may divide by zero
[[nodiscard]] std::vector<Bounded<double>> undamped_response_of_chain(const std::vector<Bounded<double>>& gamma,
                                                                      const std::vector<Bounded<double>>& kappa, Mass load,
                                                                      const Bounded<double>& r);

/// @brief \f$ U_{dk} \f$ of a chain without damping by its power series.
/// @eq{34}
/// @param gamma    masses, N values
/// @param kappa    springs, N values or N + 1
/// @param contact  the mass in contact, j
/// @param r        frequency ratio
/// @param highest  the highest natural frequency ratio, at most r / 2
/// @return         N values
[[nodiscard]] std::vector<Bounded<double>> undamped_damping_function_of_chain(const std::vector<Bounded<double>>& gamma,
                                                                              const std::vector<Bounded<double>>& kappa,
                                                                              Mass contact, const Bounded<double>& r,
                                                                              const Bounded<double>& highest);

} // namespace denhartog
