/// @file
/// @brief The symbols of the paper as the notation page has them, for the formulas in which they stand.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace denhartog::pages {

/// @brief A symbol of the paper.
struct Symbol {
    std::vector<std::string> latex;     ///< how formulas write it; the first is shown
    std::string meaning;                ///< with formulas between dollars
    std::vector<std::string> equations; ///< where it is defined
    std::string units;                  ///< empty where it has none
};

/// @brief Reads the tables of the paper's symbols. @param notation path of docs/notation.md @return the symbols in its order
/// @throws InputError where it cannot be read or has none
[[nodiscard]] std::vector<Symbol> read_symbols(const std::filesystem::path& notation);

/// @brief The symbols that stand in a formula. @param symbols all of them @param latex the formula @return those, in the
/// order of the
/// notation page
[[nodiscard]] std::vector<const Symbol*> symbols_in(const std::vector<Symbol>& symbols, const std::string& latex);

/// @brief The symbols for the script of the pages. @param symbols all of them @return a JSON array
[[nodiscard]] std::string symbols_as_json(const std::vector<Symbol>& symbols);

} // namespace denhartog::pages
