/// @file
/// @brief What the passes over finished HTML share.
#pragma once

#include <string>
#include <vector>

namespace denhartog::pages {

/// @brief What stands between two marks, from a place on. @return the text; empty where the marks are not there
/// @param text  the text
/// @param open  the first mark
/// @param close  the second mark
/// @param from  where the search begins
[[nodiscard]] std::string between(const std::string& text, const std::string& open, const std::string& close,
                                  std::size_t from = 0);

/// @brief Values of an attribute in the tags of a page. @param page the HTML @param attribute its name @return the values
[[nodiscard]] std::vector<std::string> values_of(const std::string& page, const std::string& attribute);

} // namespace denhartog::pages
