// A number over one step of an integration, theta in [0, 1], and its zeros, by the search of `search/zeros.hpp`.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "denhartog/search/zeros.hpp"

namespace denhartog {

// c_0 + c_1 theta + ... + c_5 theta^5 + C cos(h theta) + S sin(h theta).
struct StepFunction {
    std::array<double, 6> c; // coefficients of the polynomial
    double cosine = 0;       // C
    double sine = 0;         // S
    double h = 0;            // length of the step; radians

    // The function with its derivatives, and what bounds them from there on.
    [[nodiscard]] Jet operator()(double theta) const;
};

// A quantity over a step by Runge-Kutta's dense output, of fifth degree in theta.
struct StepValues {
    double f_0;          // at the start
    double h_f_prime_0;  // its derivative there with respect to theta
    double f_1;          // at the end
    double h_f_prime_1;  // its derivative there with respect to theta
    double f_third;      // at theta = 1/3
    double f_two_thirds; // at theta = 2/3
};

// The polynomial of fifth degree with given values.
[[nodiscard]] StepFunction quintic(const StepValues& values);

// The function taken from a number.
[[nodiscard]] StepFunction operator-(double limit, const StepFunction& f);

// Where a function changes its sign within (0, 1), ascending; where it touches zero, one place or two next to each other.
void sign_changes(const StepFunction& f, std::vector<double>& zeros);

// Where a function that is not negative from the start becomes negative; 0 where at once, none where it stays.
//
// A zero at the start does not count: derivatives that rounding explains, `noise` of the leading coefficients, are taken for zero
// there, and the first one that is larger tells where the function goes.
[[nodiscard]] std::optional<double> first_fall(const StepFunction& f, double noise);

} // namespace denhartog
