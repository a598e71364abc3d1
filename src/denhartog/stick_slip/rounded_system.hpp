/// @file
/// @brief A system in double with the modes of 50 digits.
#pragma once

#include <string>

#include "denhartog/number/multiprecision.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief A system that 50 digits have prepared, rounded to double.
/// @param s        the system
/// @param because  why double has no modes of its own, or not their digits
/// @return         the same; its natural frequencies may be off by a unit in the last place
[[nodiscard]] ContactSystem<double> rounded(const ContactSystem<Real50>& s, const std::string& because);

} // namespace denhartog
