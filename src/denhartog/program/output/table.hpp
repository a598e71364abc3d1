/// @file
/// @brief Aligned columns of text.
#pragma once

#include <string>
#include <vector>

namespace denhartog::program {

/// @brief Rows of cells as lines, each column as wide as its widest cell.
/// @param rows  the rows; the first is the heading
/// @return      the lines
[[nodiscard]] std::string aligned(const std::vector<std::vector<std::string>>& rows);

} // namespace denhartog::program
