/// @file
/// @brief The mass in contact alone, in the sliding regime: (33)-(39), (64), (65) and the boundaries at the cost of the modes, at one
/// frequency ratio with bounds, and over arrays of frequency ratios.
///
/// With \f$ \psi_i=\phi_i/r \f$ and \f$ R_i=r/r_{n,i} \f$ the weights \f$ \psi_{ki}\psi_{li}R_i^2 \f$ of (33)-(35) are
/// \f$ \phi_{ki}\phi_{li}/r_{n,i}^2 \f$: nothing of them depends on r. Amplitude and phase need two rows of the mode shapes. One
/// summation serves a number with its bound and arrays of r. `mode_sums` forms the products of the paper instead: answers for all
/// masses come from it, and their last digits differ.
///
/// At one frequency ratio the contact certainly slides below the boundary (69) if an upper bound of (57) for each mode takes the
/// place of the maximum: the value at the start if that is certainly the largest, else
/// \f$ \frac{\pi}{2}\left(|c_i| + R_i^2|u_i|\right) \f$ with \f$ |c_i| \f$ the size of the mode's free motion in (40). The values
/// at the start add up to (72). If the bounds do not decide, the largest demand is searched for.
///
/// Over arrays each mode is evaluated once a frequency ratio, and each sum comes with the size of its terms: what rounding and the
/// errors of the modes make of a term is below `error_of_size()` of that. (69) is (67) wherever the sum (57) is largest for
/// tau -> 0. `evaluation::certainty_of_start` tells where this is certain, and the arrays answer. Elsewhere `regime_boundary` has
/// to: where the maximum is to be sought, where the sums cancel too far, where the load does not reach the contact, and at a
/// resonance of the system with its contact held.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/bounded.hpp"

namespace denhartog {

/// @brief A mode as the contact has it, the same at every r.
template <class T>
struct ContactMode {
    T r_n;                               ///< natural frequency ratio
    T zeta;                              ///< damping ratio
    evaluation::ArrayWeights<T> weights; ///< in the sums
};

/// @brief The modes of a system as the contact has them.
struct ContactModes {
    std::shared_ptr<const ModalBasis<Bounded<double>>> basis; ///< frequencies, damping ratios, and a row of shapes a mass kept
    Mass contact;                                             ///< the row of the mass in contact
    Mass load;                                                ///< the row of the loaded mass
    std::vector<ContactMode<Bounded<double>>> modes;          ///< N
};

/// @brief Prepares the modes for many frequency ratios; contact and load are rows of the shapes that the basis has.
[[nodiscard]] ContactModes contact_modes(std::shared_ptr<const ModalBasis<Bounded<double>>> basis, Mass contact, Mass load);

/// @brief Motion of the contact in the sliding regime.
struct ContactSolution {
    Bounded<double> amplitude;    ///< X_j, Eq. (38), units of P / k_1
    Bounded<double> phase;        ///< phi_j, Eq. (39), radians in (-pi, pi]
    Bounded<double> slides_below; ///< the boundary (69) is not below it
};

/// @brief Amplitude and phase of the contact in the sliding regime, mu = 1; none if sliding is not certain.
/// @eq{33,34,35,38,39,57,69}
[[nodiscard]] std::optional<ContactSolution> contact_solution(const ContactModes& modes, const Bounded<double>& r,
                                                              const Bounded<double>& beta);

/// @brief Bound of the error of a term, in units of its size: a thousand times a few units in the last place.
[[nodiscard]] constexpr double error_of_size() { return 0x1p-40; }

/// @brief Sums over modes at the mass in contact: numbers, references to them, or arrays with an entry a frequency ratio.
template <class Numbers>
struct SumsAtContact {
    Numbers V_re;           ///< real part of V_dj, Eq. (33)
    Numbers V_im;           ///< imaginary part of V_dj, Eq. (33)
    Numbers U;              ///< first damping function, Eq. (34)
    Numbers G;              ///< second damping function, Eq. (35)
    Numbers H;              ///< Eq. (64)
    Numbers sum_of_squares; ///< Eq. (65)
};

/// @brief Sums over arrays of frequency ratios, with the response to a force on the contact and the sizes of their terms.
template <class Numbers>
struct SumsOverRatios : SumsAtContact<Numbers> {
    Numbers Y_re;      ///< real part of Y_jj, the response of the contact to a unit force there
    Numbers Y_im;      ///< imaginary part of Y_jj
    Numbers size_of_V; ///< sum of the sizes of the terms of V_dj, real and imaginary parts added
    Numbers size_of_Y; ///< of Y_jj
    Numbers size_of_U; ///< of U_dj, each term 1 larger than (28)
    Numbers size_of_H; ///< of H_j, each term 1 larger than in (64)
    Numbers certainty; ///< least of the modes' `evaluation::certainty_of_start`: positive where (57) is largest at 0; none is
                       ///< positive where a natural frequency has too few digits for `error_of_size()`
};

/// @brief Sums over any number of frequency ratios.
struct ContactSums : SumsOverRatios<std::vector<double>> {
    std::vector<std::uint8_t> without_numbers; ///< 1 where a mode without damping resonates, or a sum is beyond the range of a
                                               ///< double: the other entries mean nothing and are 0
    std::size_t modes = 0;                     ///< how many modes were summed
};

/// @brief Evaluates the modes over an array of frequency ratios and sums them. The result does not depend on the number of
/// threads. `sums` is written over: its memory serves again. InputError where an r, j, l or the number of threads breaks its
/// rule. @eq{22,23,28,29,33,34,35,64,65}
void contact_sums(const ModalBasis<Bounded<double>>& basis, Mass contact, Mass load, std::span<const double> r, unsigned threads,
                  ContactSums& sums);

/// @brief Limits over an array of frequency ratios.
struct ContactLimits {
    std::vector<double> exact;         ///< beta_lim, Eq. (69)
    std::vector<double> sticking;      ///< the contact rests from here on
    std::vector<std::uint8_t> certain; ///< 1 where both are within `limit_margin()` of what `regime_boundary` has
};

/// @brief Relative distance of limits by arrays from those of `regime_boundary`: a bound far above both roundings.
[[nodiscard]] constexpr double limit_margin() { return 0x1p-30; }

/// @brief The limits over an array of frequency ratios, from the sums there; threads, memory and errors are as with
/// `contact_sums`. @eq{54,67,69,72}
void contact_limits(const ContactSums& sums, double mu, unsigned threads, ContactLimits& limits);

/// @brief True if the limits at frequency ratio m tell the regime at every friction ratio of the sorted list: both are certain, and
/// no friction ratio is within `limit_margin()` of one.
[[nodiscard]] bool limits_tell(const ContactLimits& limits, std::size_t m, const std::vector<double>& ascending);

/// @brief `evaluation::displacement_transmissibility_of_contact` over an array of friction ratios, with the same digits. X_j is
/// as long as beta. @eq{38}
void contact_amplitudes(const Complex<double>& V_dj, double U_dj, double G_j, std::span<const double> beta,
                        std::span<double> X_j);

} // namespace denhartog
