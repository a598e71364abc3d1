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

/// @brief A motion that dies out without oscillations: \f$ (c + d\tau)e^{\lambda\tau} \f$.
struct MotionThatDiesOut {
    Ball rate{};   ///< lambda, below zero
    Ball factor{}; ///< c
    Ball slope{};  ///< d
};

/// @brief The friction motion of a mode.
///
/// Below critical damping it is that of (41). Beyond, with the rates \f$ \lambda_{1,2} \f$ of the free motion and
/// \f$ E_n = e^{\lambda_n\tau}/(1 + e^{\lambda_n\pi}) \f$, the motion that mirrors itself is
/// \f$ F = 1 - 2(\lambda_1 E_2 - \lambda_2 E_1)/(\lambda_1 - \lambda_2) \f$; with critical damping it is the limit of that.
/// @eq{41}
struct FrictionMotionOfMode {
    Ball R{};                               ///< modal frequency ratio, Eq. (22)
    Ball zeta{};                            ///< modal damping ratio
    Ball u{};                               ///< first damping function, Eq. (28)
    Ball g{};                               ///< second damping function, Eq. (29)
    Ball speed{};                           ///< 1 / R
    Ball stiffness{};                       ///< 1 / R^2
    Ball damping{};                         ///< 2 zeta / R
    Ball largest{};                         ///< a bound of |F - 1| throughout, below critical damping
    std::vector<MotionThatDiesOut> parts{}; ///< of F - 1, from critical damping on

    /// @param R     modal frequency ratio @param zeta  modal damping ratio, told from critical damping
    FrictionMotionOfMode(const Ball& R, const Ball& zeta);
    /// @brief The motion and its derivatives at an instant. @param tau the instant, exact @return the series
    [[nodiscard]] Series at(const Ball& tau) const;
    /// @brief The same over a stretch. @param in_the_middle its series there @param tau the stretch @return the series
    [[nodiscard]] Series over(const Series& in_the_middle, const Ball& tau) const;
    /// @brief How large F - 1 is over a stretch and later, below critical damping: it is e^(-zeta tau / R) times a cosine.
    /// @param tau  the stretch @return a bound
    [[nodiscard]] Ball most_of(const Ball& tau) const;
    /// @brief The derivatives that follow from two of them. @param c Taylor's coefficients at an instant, of which the first three are
    /// known @param terms  how many are wanted
    void go_on(std::vector<Ball>& c, std::size_t terms) const;
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
    std::vector<bool> cancels{};                               ///< of each row, whether it is a small difference of them

    /// @brief One row from the shared functions. @param row a mass, or the contact at N @param e what `shared` gave @return F_k
    [[nodiscard]] Series of(std::size_t row, const std::vector<Series>& e) const;
    /// @brief One row. @param row as above @param tau an instant or a stretch @return F_k; over a stretch of a row that is a small
    /// difference of the motions of the modes from as many derivatives in its middle as the bits show
    [[nodiscard]] Series at(std::size_t row, const Ball& tau) const;
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
    bool modal = true;    ///< whether each mode moves by itself, see `are_told_apart`; false if the scene gives a matrix C
    ModesInBalls modes{}; ///< the modes, where damping is given by their ratios; else none

    /// @brief Place of the contact among the rows. @return N
    [[nodiscard]] std::size_t contact() const { return V.size() - 1; }
};

/// @brief Whether damping is told from critical damping. @param zeta a damping ratio @return true where it is below, beyond, or
/// critical to the last digit
[[nodiscard]] inline bool is_told_from_critical(const Ball& zeta) {
    return zeta < Ball(1) || zeta > Ball(1) || (zeta - 1).is_zero();
}

/// @brief Whether every mode moves by itself: it is told apart from the others, and its damping from critical damping.
/// @param modes  the modes, with their damping ratios
/// @return       true where it is certain
[[nodiscard]] bool are_told_apart(const ModesInBalls& modes);

/// @brief The response functions by the paper's formulas, and those of modes that are damped critically or beyond.
/// @eq{23,28,29,33,34,35,41,64,65}
/// @param scene  the scene
/// @param modes  its modes, told apart
/// @return       the functions
/// @throws       Unproved where the bits do not suffice
[[nodiscard]] ResponsesInBalls responses_of_modes(const SceneInBalls& scene, ModesInBalls modes);

/// @brief The same where the scene gives a damping matrix, or modes are not told apart.
///
/// Between two turns of the contact the state \f$ \mathbf z = (\bar{\mathbf x}, \bar{\mathbf x}') \f$ obeys
/// \f$ \mathbf z' = \mathbf A\mathbf z + \mathbf b \f$ under a unit force on the contact. The motion that mirrors itself is
/// \f$ \mathbf F(\tau) = \mathbf F_\infty - 2e^{\mathbf A\tau}(\mathbf I + e^{\mathbf A\pi})^{-1}\mathbf F_\infty \f$, with the
/// static displacements \f$ \mathbf F_\infty \f$. Where the eigenvalues are proved simple, the exponential is a sum of free
/// motions \f$ e^{\lambda\tau} \f$.
/// @param scene  the scene with its damping matrix
/// @return       the functions
[[nodiscard]] ResponsesInBalls responses_of_state(const SceneInBalls& scene);

/// @brief The same of one mass at r = R, which is a mode by itself: for modes whose damping is not told from critical damping.
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      the functions
[[nodiscard]] ResponsesInBalls responses_of_one_mass(const Ball& R, const Ball& zeta);

} // namespace denhartog::reference
