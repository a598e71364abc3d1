/// @file
/// @brief The numbers of one point, each with a bound of its error: V, U, G, H, S, beta_lim, X_j, phi_j, and x_k at instants.
///
/// They are computed on numbers that carry a bound of their error, in double and, where that exceeds what is asked for, in 50 and
/// in 100 digits. The values handed out are doubles in every case; the bound then holds their rounding. What made a step
/// necessary is said, and steps are counted.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/solve/prepared_system.hpp"
#include "denhartog/sums/bounded_modes.hpp"

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
    std::vector<T> x;          ///< displacements (41), N values an instant asked for; empty outside the sliding regime
    std::vector<T> x_prime;    ///< velocities with respect to tau, as many
    std::vector<T> x_size;     ///< amplitudes of the monoharmonic motions, Eq. (52): what errors of x and x' are relative to
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
/// @param unsure   how much larger that sum may be elsewhere
/// @return         the numbers, without X_j, phi_j and x
template <class T>
[[nodiscard]] Quantities<T> quantities_without_motion(const ModeSums<T>& sums, const T& mu, const T& instant,
                                                      const T& unsure = T(0));

/// @brief Adds the motion, where the friction ratio is below the boundary.
/// @eq{38,39,41,52}
/// @param q     the numbers without it; gets X_j, phi_j, x, x'
/// @param sums  modes at the frequency ratio
/// @param beta  friction ratio, Eq. (11)
/// @param tau   instants, any; zero at a maximum of x_j
template <class T>
void add_motion(Quantities<T>& q, const ModeSums<T>& sums, const T& beta, const std::vector<T>& tau);

/// @brief Which numbers of a point are asked for.
enum class PointNumbers : std::uint8_t {
    sums,   ///< V, U, G, H, S and beta_lim: what friction does not change
    motion, ///< x and x': the sums need not have the digits
    all     ///< both
};

/// @brief The numbers of a point with the digits asked for.
struct QuantitiesAnswer {
    Quantities<Bounded<double>> numbers; ///< values in double with their bounds
    Method method;                       ///< how they were computed, and why that way
    double relative = 0;                 ///< the largest bound of those asked for over its size, see `list`
};

/// @brief The numbers of a point to the digits asked for, by the cheapest precision whose bounds have them.
///
/// A number that 50 digits find below 1e-25 of the largest of its kind, and to which their bound does not leave the digits asked
/// for, comes out as zero with its bound: it is zero without being so by its formula, as at an antiresonance, or lies too low to
/// tell.
/// @eq{33,34,35,38,39,41,56,64,69}
/// @param source  the scene, with r and, where the motion is asked for, beta
/// @param tau     instants of the motion, any; zero at a maximum of x_j
/// @param digits  significant digits, from 1 to 15
/// @param asked   which numbers must have them
/// @return        the numbers; no motion outside the sliding regime
/// @throws        InputError for a bad scene, instant or digits; DomainError at a pole of a mode without damping; PrecisionError
///                where 50 digits do not have the digits
[[nodiscard]] QuantitiesAnswer quantities(const SceneSource& source, std::span<const double> tau, int digits,
                                          PointNumbers asked = PointNumbers::all);

/// @brief The same at a point of a system prepared for every regime, without an eigen-solve where double has the digits.
/// @param system  the system, prepared
/// @param point   the same system with r, beta and mu in every number type
/// @param tau     instants of the motion
/// @param digits  significant digits, from 1 to 15
/// @param asked   which numbers must have them
/// @return        the numbers
[[nodiscard]] QuantitiesAnswer quantities(const PreparedSystem& system, const SceneSource& point, std::span<const double> tau,
                                          int digits, PointNumbers asked);

} // namespace denhartog
