/// @file
/// @brief The exponential and the products of sine and cosine of `evaluation/detail/vector_functions.hpp` over arrays, and nothing else.
#pragma once

#include <span>

namespace denhartog::tests {

/// @brief exp(-|x|), sin cos and cos^2 of pi / (2 x) over arrays, with the widest vectors of the processor.
/// @param x         arguments, not zero, of size 2^-27 to 2^200
/// @param exps      where the exponentials go
/// @param products  where the products of sine and cosine go
/// @param squares   where the squares of the cosine go
void own_functions(std::span<const double> x, std::span<double> exps, std::span<double> products, std::span<double> squares);

} // namespace denhartog::tests
