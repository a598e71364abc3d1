/// @file
/// @brief The contact over arrays: the sums over modes (33)-(35), (64), (65) and the boundaries over frequency ratios, (38) over
/// friction ratios.
///
/// Each mode is evaluated once a frequency ratio. With \f$ \psi_i=\phi_i/r \f$ and \f$ R_i=r/r_{n,i} \f$ the weights
/// \f$ \psi_{ki}\psi_{li}R_i^2 \f$ of (33)-(35) are \f$ \phi_{ki}\phi_{li}/r_{n,i}^2 \f$: nothing of them depends on r. Memory is
/// that of the results and a few blocks. Each sum comes with the size of its terms: what rounding and the errors of the modes
/// make of a term is below `error_of_size()` of that.
///
/// (69) is (67) wherever the sum (57) is largest for tau -> 0. `evaluation::certainty_of_start` tells where this is certain, and
/// the arrays answer. Elsewhere `regime_boundary` has to: where the maximum is to be sought, where the sums cancel too far, where
/// the load does not reach the contact, and at a resonance of the system with its contact held.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/bounded.hpp"

namespace denhartog {

/// @brief What errors make of a term, in units of its size: a thousand times a few units in the last place.
[[nodiscard]] constexpr double error_of_size() { return 0x1p-40; }

/// @brief Sums over modes at the mass in contact, an entry a frequency ratio.
struct ContactSums {
    std::vector<double> V_re;           ///< real part of V_dj, Eq. (33)
    std::vector<double> V_im;           ///< imaginary part of V_dj, Eq. (33)
    std::vector<double> U;              ///< first damping function, Eq. (34)
    std::vector<double> G;              ///< second damping function, Eq. (35)
    std::vector<double> H;              ///< Eq. (64)
    std::vector<double> sum_of_squares; ///< Eq. (65)
    std::vector<double> Y_re;           ///< real part of Y_jj, the response of the contact to a unit force there
    std::vector<double> Y_im;           ///< imaginary part of Y_jj
    std::vector<double> size_of_V;      ///< sum of the sizes of the terms of V_dj, real and imaginary parts added
    std::vector<double> size_of_Y;      ///< of Y_jj
    std::vector<double> size_of_U;      ///< of U_dj, each term 1 larger than (28)
    std::vector<double> size_of_H;      ///< of H_j, each term 1 larger than in (64)
    std::vector<double> certainty; ///< least of the modes' `evaluation::certainty_of_start`: positive where (57) is largest at 0;
                                   ///< none is positive where a natural frequency has too few digits for `error_of_size()`
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

/// @brief How far limits by arrays can be from those of `regime_boundary`, relative: a bound far above both roundings.
[[nodiscard]] constexpr double limit_margin() { return 0x1p-30; }

/// @brief The limits over an array of frequency ratios, from the sums there; threads, memory and errors are as with
/// `contact_sums`. @eq{54,67,69,72}
void contact_limits(const ContactSums& sums, double mu, unsigned threads, ContactLimits& limits);

/// @brief Whether the limits at frequency ratio m tell the regime at every friction ratio, of which the list is sorted: both are
/// certain, and no friction ratio is within `limit_margin()` of one.
[[nodiscard]] bool limits_tell(const ContactLimits& limits, std::size_t m, const std::vector<double>& ascending);

/// @brief `evaluation::displacement_transmissibility_of_contact` over an array of friction ratios, with the same digits. X_j is
/// as long as beta. @eq{38}
void contact_amplitudes(const Complex<double>& V_dj, double U_dj, double G_j, std::span<const double> beta,
                        std::span<double> X_j);

} // namespace denhartog
