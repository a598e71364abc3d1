/// @file
/// @brief Answers as JSON objects, the keys in the order of the documentation, and as tables.
#pragma once

#include "denhartog/answer/solution.hpp"
#include "denhartog/program/json/number_json.hpp"

namespace denhartog::program {

/// @brief An answer to `response`: regime, boundary, method and, in the sliding regime, every mass.
/// @param solution  the answer, with beta
/// @param write     how numbers are written
/// @return          the object; fields that mean nothing in the regime are absent
[[nodiscard]] Json response_json(const Solution& solution, const NumberWriter& write);

/// @brief An answer to `boundary`: the friction ratios that bound the regimes, and the condition that binds.
/// @param solution  the answer, without beta
/// @param write     how numbers are written
/// @return          the object
[[nodiscard]] Json boundary_json(const Solution& solution, const NumberWriter& write);

/// @brief An answer of `solve`: the object of `response` in every regime, with what is known besides.
/// @param solution  the answer
/// @param write     how numbers are written
/// @return          the object; fields that mean nothing in the regime, or were not asked for, are absent
[[nodiscard]] Json solution_json(const Solution& solution, const NumberWriter& write);

/// @brief How an answer was computed, as a line. @param method the method as JSON
/// @return model, precision, whether it is proved, and why
[[nodiscard]] std::string method_in_words(const Json& method);

/// @brief Where the contact is, in words. @param contact the object `contact` of an answer @return a line without its end
[[nodiscard]] std::string contact_in_words(const Json& contact);

/// @brief The same for reading.
/// @param answer  the object
/// @return        lines of text
[[nodiscard]] std::string solution_table(const Json& answer);

} // namespace denhartog::program
