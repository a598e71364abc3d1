/// @file
/// @brief The numbers of one point, each with a bound of its error: V, U, G, H, S, beta_lim, X_j, phi_j, and x_k at an instant.
///
/// In double they are computed on `Bounded` numbers, first with bounds of the modes that cost no eigen-solve, then with the modes
/// of long double, see `bounded_modes.hpp`. Where a bound exceeds what is asked for the next precision is taken: 50 digits, whose
/// errors are measured in 100. The values handed out are doubles in every case; the bound then holds their rounding and the
/// error measured. What made a step necessary is said, and steps are counted.
#pragma once

#include <functional>
#include <optional>

#include "denhartog/response/answer.hpp"
#include "denhartog/response/bounded_modes.hpp"
#include "denhartog/response/steady_state.hpp"

namespace denhartog {

/// @brief The numbers of one point.
template <class T>
struct Quantities {
    std::vector<Complex<T>> V; ///< complex response functions of the masses, Eq. (33)
    std::vector<T> U;          ///< first damping functions of the masses, Eq. (34)
    std::vector<T> G;          ///< second damping functions of the masses, Eq. (35)
    T H_j{};                   ///< Eq. (64)
    T S{};                     ///< the maximum over tau of the sum over modes of (57)'s expression
    T beta_lim{};              ///< the boundary of the sliding regime, Eq. (69)
    std::optional<T> X_j;      ///< amplitude of the mass in contact, Eq. (38); none outside the sliding regime
    std::optional<T> phi_j;    ///< its phase, Eq. (39); radians in (-pi, pi]
    std::vector<T> x;          ///< displacements (41) at the instant asked for, N values; empty outside the sliding regime
    std::vector<T> x_size;     ///< amplitudes of the monoharmonic motions, Eq. (52): what errors of x are relative to
    T instant{};               ///< where S is taken; 0 stands for the limit
};

/// @brief What is read off a point: its numbers are listed with the size that their errors are relative to.
template <class T>
using QuantityReader = std::function<void(const char* name, std::size_t mass, const T& value, const T& size)>;

/// @brief Lists all numbers of a point. Errors of parts of V are relative to |V|, of a phase absolute, of x_k relative to (52).
/// @param q     the numbers
/// @param read  called for each
template <class T>
void list(const Quantities<T>& q, const QuantityReader<T>& read);

/// @brief What friction does not change: V, U, G, H, and S with the boundary.
/// @eq{33,34,35,56,64,69}
/// @param sums     modes at the frequency ratio
/// @param mu       static over kinetic friction, Eq. (3)
/// @param instant  where the sum over modes of (57)'s expression is largest; 0 stands for the limit
/// @return         the numbers, without X_j, phi_j and x
template <class T>
[[nodiscard]] Quantities<T> quantities_without_motion(const ModeSums<T>& sums, const T& mu, const T& instant);

/// @brief Adds the motion, where the friction ratio is below the boundary.
/// @eq{38,39,41,52}
/// @param q     the numbers without it; gets X_j, phi_j, x
/// @param sums  modes at the frequency ratio
/// @param beta  friction ratio, Eq. (11)
/// @param tau   instant of the displacements, any; zero at a maximum of x_j
template <class T>
void add_motion(Quantities<T>& q, const ModeSums<T>& sums, const T& beta, const T& tau);

/// @brief The numbers of a point in double with bounds of their errors, known beforehand.
/// @eq{33,34,35,38,39,41,56,64,69}
/// @param scene   the scene, with r and beta
/// @param modes   its modes
/// @param tau     instant of the displacements, any; zero at a maximum of x_j
/// @param inputs  how far to trust beta, mu and tau
/// @return        the numbers
/// @throws        DomainError at a pole of a mode without damping; PrecisionError where a maximum is not settled
[[nodiscard]] Quantities<Bounded> bounded_quantities(const Scene<double>& scene, BoundedModes& modes, double tau, Inputs inputs);

/// @brief The numbers of a point with the digits asked for.
struct QuantitiesAnswer {
    Quantities<Bounded> numbers; ///< values in double with their bounds
    Method method;               ///< how they were computed, and why that way
    double relative = 0;         ///< the largest bound over its size, see `list`
};

/// @brief The numbers of a point to the digits asked for, by the cheapest precision whose bounds have them.
/// @eq{33,34,35,38,39,41,56,64,69}
/// @param source  the scene, with r and beta, damping given by ratios
/// @param tau     instant of the displacements
/// @param digits  significant digits of every number, from 1 to 15
/// @return        the numbers
/// @throws        InputError for a bad scene or bad digits; DomainError at a pole of a mode without damping; PrecisionError where
///                50 digits do not have the digits: what is zero without being so by its formula has none
[[nodiscard]] QuantitiesAnswer quantities(const SceneSource& source, double tau, int digits);

} // namespace denhartog
