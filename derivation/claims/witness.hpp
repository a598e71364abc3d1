/// @file
/// @brief Witnesses of claims that are decided by numbers: names and values as text.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace denhartog::derivation {

/// @brief Names and values.
using Witness = std::vector<std::pair<std::string, std::string>>;

/// @brief A number with all its digits. @param x a number @return text that reads back as the same number
[[nodiscard]] std::string text(double x);

/// @brief A witness with more values. @param w a witness @param more names and values @return both
[[nodiscard]] Witness with(Witness w, std::initializer_list<std::pair<std::string, std::string>> more);

} // namespace denhartog::derivation
