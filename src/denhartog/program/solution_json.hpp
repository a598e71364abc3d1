/// @file
/// @brief Answers of `solve` as JSON objects and as tables.
#pragma once

#include "denhartog/program/number_json.hpp"
#include "denhartog/solve/solution.hpp"

namespace denhartog::program {

/// @brief An answer of `solve`: the object of `response` in every regime, with what is known besides.
/// @param solution  the answer
/// @param write     how numbers are written
/// @return          the object; fields that mean nothing in the regime, or were not asked for, are absent
[[nodiscard]] Json solution_json(const Solution& solution, const NumberWriter& write);

/// @brief The same for reading.
/// @param answer  the object
/// @return        lines of text
[[nodiscard]] std::string solution_table(const Json& answer);

} // namespace denhartog::program
