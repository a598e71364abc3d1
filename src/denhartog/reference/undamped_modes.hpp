/// @file
/// @brief V and U of masses without damping over x = 1/r, with their poles multiplied out. Included by sources only.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "denhartog/number/effort.hpp"
#include "denhartog/reference/polynomial.hpp"
#include "denhartog/reference/scene_in_balls.hpp"

namespace denhartog::reference {

/// @brief Masses that hang together: no other mass is coupled to them.
using CoupledMasses = std::vector<slong>;

/// @brief The masses of a scene, part by part.
/// @param s     the scene
/// @param held  a mass that is left out, which couples no others; -1 for none
/// @return      the parts
[[nodiscard]] std::vector<CoupledMasses> coupled_masses(const SceneInBalls& s, slong held = -1);

/// @brief Products of the shapes of the modes at two rows.
struct WeightsInBalls {
    std::vector<Ball> sum{};  ///< of each mode, or of each cluster as a whole
    std::vector<Ball> open{}; ///< factor by which the radius of a cluster's function leaves its term open; zero of one mode

    /// @brief Whether they are zero and nothing else. @return true where the rows have no mode in common
    [[nodiscard]] bool vanish() const;
};

/// @brief v and u of each mode or cluster over x. Up to a common factor, \f$ V = x^2\sum w_iv_i \f$ and \f$ U = \sum w_iu_i \f$.
struct TermsOverX {
    std::vector<PolynomialInBalls> v{}; ///< \f$ 1/(r_{n,i}^2x^2-1) \f$, times what is multiplied out of V
    std::vector<PolynomialInBalls> u{}; ///< \f$ \tan(\pi r_{n,i}x/2)/r_{n,i} \f$, times what is multiplied out of U
};

/// @brief Which modes have their poles multiplied out: \f$ r_{n,i}^2x^2-1 \f$ of V, \f$ \cos(\pi r_{n,i}x/2) \f$ of U.
struct FactorsOverX {
    std::vector<bool> of_V{}; ///< of each mode or cluster
    std::vector<bool> of_U{}; ///< of each mode or cluster
};

/// @brief A stretch of x as it was seen: the functions of the modes in its middle, over it, and at its ends.
struct SeenOverX {
    FactorsOverX factors{}; ///< what is multiplied out
    Ball off{};             ///< the stretch less its middle
    TermsOverX middle{};    ///< series about the middle
    TermsOverX over{};      ///< coefficients over the whole stretch
    TermsOverX at_a{};      ///< values at its lower end
    TermsOverX at_b{};      ///< values at its upper end
};

/// @brief The modes of parts of a system.
class UndampedModesInBalls {
public:
    /// @param s      the scene
    /// @param parts  masses whose modes are taken
    /// @throws       Unproved as `modes_in_balls`
    UndampedModesInBalls(const SceneInBalls& s, const std::vector<CoupledMasses>& parts);

    /// @brief Natural frequency ratios. @return one of each mode or cluster
    [[nodiscard]] const std::vector<Ball>& r_n() const { return r_n_; }
    /// @brief Weights between two rows: a mass, N for the contact, N + 1 for the load. @param a a row @param b a row
    /// @return the weights
    [[nodiscard]] WeightsInBalls weights(std::size_t a, std::size_t b) const;
    /// @brief The functions of the modes. @param x 1/r, a number or a stretch @param terms number of terms
    /// @param factors  what is multiplied out @return the functions
    [[nodiscard]] TermsOverX terms(const Ball& x, slong terms, const FactorsOverX& factors) const;
    /// @brief Nothing multiplied out. @return it
    [[nodiscard]] FactorsOverX nothing() const;
    /// @brief A stretch, remembered for searches of other masses.
    /// @param a       its lower end
    /// @param b       its upper end
    /// @param effort  what it costs is counted there
    /// @return        the stretch, which lasts until the next call
    const SeenOverX& seen(double a, double b, Effort& effort);

private:
    [[nodiscard]] FactorsOverX poles_in(const Ball& x) const;

    std::vector<Ball> r_n_{};
    std::vector<bool> cluster_{}, loaded_{};
    std::vector<std::vector<std::vector<Ball>>> psi_{}; // of each mode or cluster: of each row, its modes
    std::map<std::pair<double, double>, SeenOverX> all_{};
};

/// @brief A sum over the modes. @param w the weights @param f a function of each mode or cluster @return the sum
[[nodiscard]] PolynomialInBalls sum_over_modes(const WeightsInBalls& w, const std::vector<PolynomialInBalls>& f);

} // namespace denhartog::reference
