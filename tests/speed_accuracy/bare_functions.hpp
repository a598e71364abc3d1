/// @file
/// @brief Exponential, sine and cosine of arrays by the compiler's vector maths library: what batches are measured against.
#pragma once

#include <span>

namespace denhartog::tests {

/// @brief exp, sin and cos, each a loop of its own that the compiler can make vectors of. The exponentials are exp(-|x|).
void bare_functions(std::span<const double> x, std::span<double> exps, std::span<double> sines, std::span<double> cosines);

/// @brief A square root of every entry: the limit of X_j over friction ratios. Arguments are not negative.
void bare_roots(std::span<const double> x, std::span<double> roots);

} // namespace denhartog::tests
