/// @file
/// @brief Functions over arrays alone: by the compiler's vector maths library, what batches are measured against, and those of
/// `evaluation/detail/vector_functions.hpp`.
#pragma once

#include <span>

namespace denhartog::tests {

/// @brief exp, sin and cos, each a loop of its own that the compiler can make vectors of. The exponentials are exp(-|x|).
void bare_functions(std::span<const double> x, std::span<double> exps, std::span<double> sines, std::span<double> cosines);

/// @brief A square root of every entry: the limit of X_j over friction ratios. Arguments are not negative.
void bare_roots(std::span<const double> x, std::span<double> roots);

/// @brief exp(-|x|), sin cos and cos^2 of pi / (2 x) over arrays, with the widest vectors of the processor. Arguments are not
/// zero, and of size 2^-27 to 2^200.
void own_functions(std::span<const double> x, std::span<double> exps, std::span<double> products, std::span<double> squares);

} // namespace denhartog::tests
