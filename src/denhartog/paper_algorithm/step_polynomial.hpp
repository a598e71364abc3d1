/// @file
/// @brief Polynomials over one step of an integration, \f$ \theta \in [0,1] \f$, by their Bernstein coefficients.
///
/// A polynomial lies within the range of its coefficients and has no more zeros than they have changes of sign. Splitting the
/// step until each part has at most one therefore finds every change of sign, two close together included, and in order.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace denhartog {

/// @brief A polynomial on [0, 1].
struct StepPolynomial {
    static constexpr int highest_degree = 13; ///< degree at which a cosine over a step of pi / 4 is exact to rounding
    std::array<double, highest_degree + 1> b; ///< Bernstein coefficients, degree + 1 of them
    int degree;                               ///< the degree
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
[[nodiscard]] StepPolynomial quintic(const StepValues& values);

/// @brief A polynomial of fifth degree with a cosine added: \f$ p + a\cos(\tau + h\theta) \f$.
/// @param p    the polynomial
/// @param a    amplitude of the cosine
/// @param tau  its angle at the start of the step; radians
/// @param h    length of the step, at most pi / 4; radians
/// @return     the sum, to rounding
[[nodiscard]] StepPolynomial with_cosine(const StepPolynomial& p, double a, double tau, double h);

/// @brief A value. @param p a polynomial @param theta in [0, 1] @return p(theta)
[[nodiscard]] double value(const StepPolynomial& p, double theta);

/// @brief Where a polynomial changes sign within (0, 1).
/// @param p      the polynomial
/// @param zeros  gets the places, ascending; emptied first
void sign_changes(const StepPolynomial& p, std::vector<double>& zeros);

/// @brief Where a function that is not negative from the start becomes negative.
///
/// Zeros at the start of any order do not count: coefficients that rounding explains are taken for zero there, and the first
/// that is larger tells where the function goes.
/// @param p      the function
/// @param noise  rounding error of the leading coefficients; 0 where the function is known to be positive at the start
/// @return       the place, on the negative side of the zero; 0 where it becomes negative at once; none where it stays
[[nodiscard]] std::optional<double> first_fall(const StepPolynomial& p, double noise);

} // namespace denhartog
