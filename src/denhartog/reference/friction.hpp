/// @file
/// @brief The shares of load and friction in the motion: V, U, G, H and the friction motion, (23) to (35), (41), (64).
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/reference/modes.hpp"
#include "denhartog/reference/series.hpp"

namespace denhartog::reference {

/// @brief A motion that dies out without oscillations: \f$ (c + d\tau)e^{\lambda\tau} \f$.
struct MotionThatDiesOut {
    Ball rate{};   ///< lambda, below zero
    Ball factor{}; ///< c
    Ball slope{};  ///< d
};

/// @brief The friction motion of a mode whose damping is proved critical, or proved not critical.
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
    Ball largest{};                         ///< a bound of |F - 1| throughout
    std::vector<MotionThatDiesOut> parts{}; ///< of F - 1, from critical damping on

    /// @brief Of a modal frequency ratio and a damping ratio.
    FrictionMotionOfMode(const Ball& R, const Ball& zeta);
    /// @brief The motion and its derivatives at an instant, exact.
    [[nodiscard]] Series at(const Ball& tau) const;
    /// @brief Bound of F - 1 over a stretch and later, below critical damping: it is e^(-zeta tau / R) times a cosine.
    [[nodiscard]] Ball most_of(const Ball& tau) const;
    /// @brief Largest difference, at any instant, of \f$ y = R^2F \f$ of two modes whose R is in the ball.
    ///
    /// They obey \f$ y'' + dy' + \lambda y = 1 \f$, with \f$ d = 2\zeta/R \f$ and \f$ \lambda = 1/R^2 \f$. Their difference
    /// \f$ \delta \f$ obeys it with \f$ -(\Delta d\,y' + \Delta\lambda\,y) \f$ in place of 1. Damping takes energy away, so that
    /// \f$ \sqrt{\delta'^2 + \lambda\delta^2} \f$ grows by less than the integral of that; at 0 it follows from u and g.
    [[nodiscard]] Ball apart() const;
    /// @brief Largest rate of such a difference: its derivative of order n is at most so often as large as this to the n.
    [[nodiscard]] Ball changes() const { return 4 * (1 + zeta) * (1 + speed); }
    /// @brief Taylor's coefficients that follow from the first three, as many as are wanted.
    void go_on(std::vector<Ball>& c, std::size_t terms) const;
    /// @brief First and third derivative, added, by the equation of motion: next to a resonance the sum is a small difference of
    /// large terms. Of the series the value, the slope and the curvature are known.
    [[nodiscard]] Series rate_and_third(const Series& F) const;
};

/// @brief The motion F_k that a unit of friction adds over the half-period in which the contact moves down, as (41) has it.
///
/// It is a sum of functions of time that all masses share, \f$ F_k(\tau) = c_k + \sum_i a_{ki} e_i(\tau) \f$. Its values at both
/// ends of the half-period are \f$ -G_k \f$ and \f$ G_k \f$, its rates \f$ -U_{dk} \f$ and \f$ U_{dk} \f$. A row is a mass, or the
/// contact at N.
struct FrictionInTime {
    std::vector<Ball> constant{};                              ///< c_k
    std::vector<std::vector<Ball>> weight{};                   ///< a_ki
    std::shared_ptr<Remembered<std::vector<Series>>> shared{}; ///< e_i at an instant or over a stretch
    std::vector<FrictionMotionOfMode> modes{};                 ///< those whose motions the e_i are; none of free motions
    std::vector<Ball> open{};                                  ///< of each row, by how much clusters may put it off, see `apart`
    Ball fastest{};                                            ///< how fast that changes, as `changes` has it
    std::vector<bool> cancels{};                               ///< of each row, whether it is a small difference of them
    Effort* effort = nullptr;                                  ///< that of the scene

    /// @brief F_k from what `shared` gave.
    [[nodiscard]] Series of(std::size_t row, const std::vector<Series>& e) const;
    /// @brief F_k at an instant or over a stretch; over a stretch of a row that is a small difference of the motions of the modes
    /// from as many derivatives in its middle as the bits show.
    [[nodiscard]] Series at(std::size_t row, const Ball& tau) const;
    /// @brief First and third derivative of F_k, added, as `FrictionMotionOfMode` has it.
    [[nodiscard]] Series rate_and_third(std::size_t row, const std::vector<Series>& e) const;

private:
    // Makes the derivatives over n! uncertain by what changes as fast as `fastest`.
    void widen(std::span<Ball> c, Ball off) const;
};

/// @brief Response functions at a frequency ratio, of the N masses and then of the contact, w^T x.
struct ResponsesInBalls {
    std::vector<Complex<Ball>> V{}; ///< complex response functions, Eq. (33)
    std::vector<Ball> U{};          ///< first damping functions, Eq. (34)
    std::vector<Ball> G{};          ///< second damping functions, Eq. (35)
    Ball H{};                       ///< Eq. (64)
    Ball squares{};                 ///< acceleration of the contact by a unit force on it: the sum (65)
    Complex<Ball> Y{};              ///< displacement of the contact by a unit harmonic force on it
    FrictionInTime friction{};      ///< the friction motion
    ModesInBalls modes{};           ///< the modes, if damping is given by their ratios; else none

    /// @brief Place of the contact among the rows.
    [[nodiscard]] std::size_t contact() const { return V.size() - 1; }
};

/// @brief Whether damping is below critical damping, beyond it, or critical to the last digit.
[[nodiscard]] inline bool is_told_from_critical(const Ball& zeta) {
    return zeta < Ball(1) || zeta > Ball(1) || (zeta - 1).is_zero();
}

/// @brief Whether every mode moves by itself: its damping is proved critical, or proved not critical.
[[nodiscard]] inline bool are_told_apart(const ModesInBalls& modes) {
    return std::ranges::all_of(modes.zeta, is_told_from_critical);
}

/// @brief The response functions by the paper's formulas, and those of modes that are damped critically or beyond.
/// @eq{23,28,29,33,34,35,41,64,65}
/// @throws Unproved if the bits do not suffice
[[nodiscard]] ResponsesInBalls responses_of_modes(const SceneInBalls& scene, ModesInBalls modes);

/// @brief Responses of a scene that gives a damping matrix, or whose damping may be critical.
///
/// Between two turns of the contact the state \f$ \mathbf z = (\bar{\mathbf x}, \bar{\mathbf x}') \f$ obeys
/// \f$ \mathbf z' = \mathbf A\mathbf z + \mathbf b \f$ under a unit force on the contact. The motion that mirrors itself is
/// \f$ \mathbf F(\tau) = \mathbf F_\infty - 2e^{\mathbf A\tau}(\mathbf I + e^{\mathbf A\pi})^{-1}\mathbf F_\infty \f$, with the
/// static displacements \f$ \mathbf F_\infty \f$. If the eigenvalues are proved simple, the exponential is a sum of free
/// motions \f$ e^{\lambda\tau} \f$.
[[nodiscard]] ResponsesInBalls responses_of_state(const SceneInBalls& scene);

/// @brief Complex amplitudes of the N masses, and of the contact behind them, under a harmonic force and without friction.
/// `imaginary` is the part of the force in quadrature, with N rows; it is empty where there is none.
/// @throws Unproved if the system may resonate
[[nodiscard]] std::vector<Complex<Ball>> harmonic_response(const SceneInBalls& scene, const BallMatrix& force,
                                                           const BallMatrix& imaginary = BallMatrix());

/// @brief Responses of one mass at r = R, which is a mode by itself: for modes whose damping may be critical.
[[nodiscard]] ResponsesInBalls responses_of_one_mass(const Ball& R, const Ball& zeta, Effort* effort = nullptr);

} // namespace denhartog::reference
