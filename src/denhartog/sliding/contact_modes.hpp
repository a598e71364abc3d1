/// @file
/// @brief The mass in contact alone, in the sliding regime: (33)-(39) with error bounds at the cost of the modes.
///
/// Amplitude and phase of the contact need two rows of the mode shapes and three sums. That it slides is certain below the
/// boundary (69) with an upper bound of the demand (57) of every mode: its value at the start where that is certain to be the
/// largest, else that of `largest_demand`; where these do not tell, the largest demand is searched for.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/evaluation/mode.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/bounded.hpp"

namespace denhartog {

/// @brief A mode as the contact has it, the same at every r.
template <class T>
struct ContactMode {
    Bounded<T> r_n;                                 ///< natural frequency ratio
    Bounded<T> zeta;                                ///< damping ratio
    evaluation::ArrayWeights<Bounded<T>> weights{}; ///< in the sums
};

/// @brief The modes of a system as the contact has them.
template <class T>
struct ContactModes {
    std::shared_ptr<const ModalBasis<Bounded<T>>> basis; ///< frequencies, damping ratios, and a row of shapes a mass that is kept
    Mass contact;                                        ///< the row of the mass in contact
    Mass load;                                           ///< the row of the loaded mass
    std::vector<ContactMode<T>> modes;                   ///< N
};

/// @brief Prepares the modes for many frequency ratios.
/// @param basis    a modal basis with errors
/// @param contact  the row of its shapes that the mass in contact has
/// @param load     the row that the loaded mass has
/// @return         the modes
template <class T>
[[nodiscard]] ContactModes<T> contact_modes(std::shared_ptr<const ModalBasis<Bounded<T>>> basis, Mass contact, Mass load);

/// @brief The sums over modes that the contact needs.
template <class T>
struct SumsAtContact {
    Complex<Bounded<T>> V; ///< complex response function, Eq. (33)
    Bounded<T> U;          ///< first damping function, Eq. (34)
    Bounded<T> G;          ///< second damping function, Eq. (35)
    T demand;              ///< what the largest (57) does not exceed
    T least;               ///< what it is not below: its value at the start
};

/// @brief The sums over modes, each as it is known: evaluated, or static with a bound of what that leaves out.
/// @eq{33,34,35,57}
/// @param all        the modes
/// @param r          frequency ratio with its error
/// @param functions  (23), (28), (29) of every mode at r, N values
/// @return           the sums
template <class T>
[[nodiscard]] SumsAtContact<T> sums_at_contact(const ContactModes<T>& all, const Bounded<T>& r,
                                               const std::vector<evaluation::ModeFunctions<Bounded<T>>>& functions);

/// @brief What the contact does in the sliding regime.
template <class T>
struct ContactSolution {
    Bounded<T> amplitude;    ///< X_j, Eq. (38), units of P / k_1
    Bounded<T> phase;        ///< phi_j, Eq. (39), radians in (-pi, pi]
    Bounded<T> slides_below; ///< the boundary (69) is not below it
};

/// @brief Amplitude and phase of the contact in the sliding regime, mu = 1, from sums. @eq{38,39,69}
/// @param sums  sums over modes
/// @param beta  friction ratio with its error
/// @return      the solution; none where their bound of (57) leaves open whether the contact slides
template <class T>
[[nodiscard]] std::optional<ContactSolution<T>> contact_solution(const SumsAtContact<T>& sums, const Bounded<T>& beta);

/// @brief The same on all modes; where the bound leaves it open the largest (57) is searched for. @eq{33,34,35,38,39,69}
/// @param modes  the modes
/// @param r      frequency ratio with its error
/// @param beta   friction ratio with its error
/// @return       the solution; none where sliding is not certain
template <class T>
[[nodiscard]] std::optional<ContactSolution<T>> contact_solution(const ContactModes<T>& modes, const Bounded<T>& r,
                                                                 const Bounded<T>& beta);

/// @brief An upper bound of (57) of a mode at any instant: \f$ \frac{\pi}{2}\left(|c_i| + R_i^2|u_i|\right) \f$ with
/// \f$ |c_i| \f$ the size of its free motion in (40).
///
/// Of two amplitudes where the mode oscillates; where it does not, the root of \f$ R^2y'^2 + R^4y''^2 \f$ at tau = 0, which never
/// grows.
/// @eq{40,57}
/// @param R     modal frequency ratio with its error
/// @param zeta  modal damping ratio with its error
/// @param f     damping functions of the mode, Eqs. (28), (29)
/// @return      the bound
template <class T>
[[nodiscard]] T largest_demand(const Bounded<T>& R, const Bounded<T>& zeta, const evaluation::DampingFunctions<Bounded<T>>& f);

} // namespace denhartog
