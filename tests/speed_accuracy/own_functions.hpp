/// @file
/// @brief The exponential and the products of sine and cosine of `evaluation/detail/vector_functions.hpp` over arrays, and nothing else.
#pragma once

#include <span>

namespace denhartog::tests {

/// @brief exp(-|x|), sin cos and cos^2 of pi / (2 x) over arrays, with the widest vectors of the processor. Arguments are not
/// zero, and of size 2^-27 to 2^200.
void own_functions(std::span<const double> x, std::span<double> exps, std::span<double> products, std::span<double> squares);

} // namespace denhartog::tests
