/// @file
/// @brief What the load and the friction each add to the motion: V, U, G, H and the friction motion, (23) to (35), (41), (64).
#pragma once

#include <memory>
#include <vector>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/reference/modes.hpp"
#include "denhartog/reference/remembered.hpp"
#include "denhartog/reference/series.hpp"

namespace denhartog::reference {

/// @brief The friction motion of a mode, damped below critical.
/// @eq{41}
struct FrictionMotionOfMode {
    Ball R{};         ///< modal frequency ratio, Eq. (22)
    Ball zeta{};      ///< modal damping ratio
    Ball u{};         ///< first damping function, Eq. (28)
    Ball g{};         ///< second damping function, Eq. (29)
    Ball speed{};     ///< 1 / R
    Ball stiffness{}; ///< 1 / R^2
    Ball damping{};   ///< 2 zeta / R
    Ball turning{};   ///< w / R: F - 1 is e^(-zeta tau / R) times sine and cosine of this times tau
    Ball of_sine{};   ///< factor of the sine in 1 - F
    Ball largest{};   ///< a bound of |F - 1| throughout

    /// @param R     modal frequency ratio @param zeta  modal damping ratio, below 1
    FrictionMotionOfMode(const Ball& R, const Ball& zeta);
    /// @brief The motion and its derivatives at an instant. @param tau the instant, exact @return the series
    [[nodiscard]] Series at(const Ball& tau) const;
    /// @brief The same over a stretch. @param in_the_middle its series there @param tau the stretch @return the series
    [[nodiscard]] Series over(const Series& in_the_middle, const Ball& tau) const;
    /// @brief First and third derivative, added, by the equation of motion: next to a resonance the sum is a small difference of
    /// large terms. @param F the motion @return value, slope and curvature of the sum; the rest is not known
    [[nodiscard]] Series rate_and_third(const Series& F) const;
};

/// @brief The motion F_k that a unit of friction adds over the half-period in which the contact moves down, as (41) has it.
///
/// It is a sum of functions of time that all masses share, \f$ F_k(\tau) = c_k + \sum_i a_{ki} e_i(\tau) \f$. Its values at both
/// ends of the half-period are \f$ -G_k \f$ and \f$ G_k \f$, its rates \f$ -U_{dk} \f$ and \f$ U_{dk} \f$.
struct FrictionInTime {
    std::vector<Ball> constant{};                              ///< c_k; N masses, then the contact
    std::vector<std::vector<Ball>> weight{};                   ///< a_ki, as many rows
    std::shared_ptr<Remembered<std::vector<Series>>> shared{}; ///< e_i at an instant or over a stretch
    std::vector<FrictionMotionOfMode> modes{};                 ///< those whose motions the e_i are; none of free motions

    /// @brief One row from the shared functions. @param row a mass, or the contact at N @param e what `shared` gave @return F_k
    [[nodiscard]] Series of(std::size_t row, const std::vector<Series>& e) const;
    /// @brief First and third derivative of F_k, added. @param row as above @param e as above, of modes
    /// @return  see `FrictionMotionOfMode`
    [[nodiscard]] Series rate_and_third(std::size_t row, const std::vector<Series>& e) const;
};

/// @brief Acceleration of the contact by a unit force on it: the sum of (w^T psi_i)^2 over the modes is w^T M^-1 w / r^2.
/// @eq{65}
/// @param scene  the scene
/// @return       the acceleration
/// @throws       Unproved where the mass matrix is not proved regular
[[nodiscard]] Ball acceleration_of_contact(const SceneInBalls& scene);

/// @brief Response functions at a frequency ratio, of the N masses and then of the contact, w^T x.
struct ResponsesInBalls {
    std::vector<Complex<Ball>> V{}; ///< complex response functions, Eq. (33)
    std::vector<Ball> U{};          ///< first damping functions, Eq. (34)
    std::vector<Ball> G{};          ///< second damping functions, Eq. (35)
    Ball H{};                       ///< Eq. (64)
    Ball squares{};                 ///< acceleration of the contact by a unit force on it: the sum (65)
    Complex<Ball> Y{};              ///< displacement of the contact by a unit harmonic force on it
    FrictionInTime friction{};      ///< the friction motion
    bool modal = true;    ///< whether the paper's formulas hold, see `are_of_papers_form`; false if the scene gives a matrix C
    ModesInBalls modes{}; ///< the modes, where damping is given by their ratios; else none

    /// @brief Place of the contact among the rows. @return N
    [[nodiscard]] std::size_t contact() const { return V.size() - 1; }
};

/// @brief Whether the paper's formulas hold: every mode is damped below critical, and told apart from the others.
/// @param modes  the modes, with their damping ratios
/// @return       true where it is certain
[[nodiscard]] bool are_of_papers_form(const ModesInBalls& modes);

/// @brief The response functions by the paper's formulas.
/// @eq{23,28,29,33,34,35,41,64,65}
/// @param scene  the scene
/// @param modes  its modes, of the paper's form
/// @return       the functions
/// @throws       Unproved where the bits do not suffice
[[nodiscard]] ResponsesInBalls responses_of_modes(const SceneInBalls& scene, ModesInBalls modes);

/// @brief The same where the scene gives a damping matrix, modes are not told apart, or one is damped critically or beyond.
///
/// Between two turns of the contact the state \f$ \mathbf z = (\bar{\mathbf x}, \bar{\mathbf x}') \f$ obeys
/// \f$ \mathbf z' = \mathbf A\mathbf z + \mathbf b \f$ under a unit force on the contact. The motion that mirrors itself is
/// \f$ \mathbf F(\tau) = \mathbf F_\infty - 2e^{\mathbf A\tau}(\mathbf I + e^{\mathbf A\pi})^{-1}\mathbf F_\infty \f$, with the
/// static displacements \f$ \mathbf F_\infty \f$. Where the eigenvalues are proved simple, the exponential is a sum of free
/// motions \f$ e^{\lambda\tau} \f$.
/// @param scene  the scene with its damping matrix
/// @return       the functions
[[nodiscard]] ResponsesInBalls responses_of_state(const SceneInBalls& scene);

/// @brief The same of one mass at r = R, which is a mode by itself: for modes damped critically or beyond.
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      the functions
[[nodiscard]] ResponsesInBalls responses_of_one_mass(const Ball& R, const Ball& zeta);

} // namespace denhartog::reference
