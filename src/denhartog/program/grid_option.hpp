/// @file
/// @brief Equally spaced values from a text FROM:TO:COUNT.
#pragma once

#include <string>
#include <vector>

namespace denhartog::program {

/// @brief The values of a grid, both ends included.
/// @param quantity  what the values are of, for messages
/// @param text      FROM:TO:COUNT
/// @return          COUNT values, ascending
/// @throws          InputError where the text is none, COUNT is below 1, or TO is below FROM
[[nodiscard]] std::vector<double> grid_values(const std::string& quantity, const std::string& text);

} // namespace denhartog::program
