/// @file
/// @brief Numbers in the reports of `denhartog conform`.
#pragma once

#include <optional>
#include <string>

#include "conformance/verdict.hpp"

namespace denhartog::program {

/// @brief A number with few digits. @param x a number @return two significant digits
[[nodiscard]] std::string rough(double x);

/// @brief Digits of an answer in a table. @param digits the digits, if any @return one decimal, or a dash
[[nodiscard]] std::string digits_cell(const std::optional<double>& digits);

/// @brief Numbers or a regime in a line: decimal with hexadecimal where there is one number, long lists cut short.
/// @param value  the value
/// @return       its text; `nothing` where it is empty
[[nodiscard]] std::string value_text(const conformance::Value& value);

/// @brief The true answer of a vector. @param v the vector @return it
[[nodiscard]] conformance::Value truth_of(const conformance::Vector& v);

} // namespace denhartog::program
