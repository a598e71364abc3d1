/// @file
/// @brief A number over one step of an integration, \f$ \theta \in [0,1] \f$, and its zeros, by the search of `first_zero.hpp`.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "denhartog/search/first_zero.hpp"

namespace denhartog {

/// @brief \f$ c_0 + c_1\theta + \dots + c_5\theta^5 + C\cos h\theta + S\sin h\theta \f$.
struct StepFunction {
    std::array<double, 6> c; ///< coefficients of the polynomial
    double cosine = 0;       ///< C
    double sine = 0;         ///< S
    double h = 0;            ///< length of the step; radians

    /// @brief The function with its derivatives. @param theta in [0, 1] @return both, and what bounds them from there on
    [[nodiscard]] Jet<double> operator()(double theta) const;
};

/// @brief What Runge-Kutta's dense output knows of a quantity over a step: it is of fifth degree in theta.
struct StepValues {
    double f_0;          ///< at the start
    double h_f_prime_0;  ///< its derivative there with respect to theta
    double f_1;          ///< at the end
    double h_f_prime_1;  ///< its derivative there with respect to theta
    double f_third;      ///< at theta = 1/3
    double f_two_thirds; ///< at theta = 2/3
};

/// @brief The polynomial of fifth degree with given values. @param values the values @return the polynomial
[[nodiscard]] StepFunction quintic(const StepValues& values);

/// @brief The function taken from a number. @param limit the number @param f the function @return limit - f
[[nodiscard]] StepFunction operator-(double limit, const StepFunction& f);

/// @brief Where a function changes its sign within (0, 1); where it touches zero, one place or two next to each other.
/// @param f      the function
/// @param zeros  gets the places, ascending; emptied first
void sign_changes(const StepFunction& f, std::vector<double>& zeros);

/// @brief Where a function that is not negative from the start becomes negative.
///
/// A zero at the start does not count: derivatives that rounding explains are taken for zero there, and the first one that is
/// larger tells where the function goes.
/// @param f      the function
/// @param noise  rounding error of the leading coefficients; 0 where the function is known to be positive at the start
/// @return       the place; 0 where it becomes negative at once; none where it stays
[[nodiscard]] std::optional<double> first_fall(const StepFunction& f, double noise);

} // namespace denhartog
