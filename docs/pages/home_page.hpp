/// @file
/// @brief The first page, the sheet of errata to print, and the lists that the script of the pages reads.
#pragma once

#include <string>
#include <vector>

#include "equation_page.hpp"

namespace denhartog::pages {

/// @brief The first page: the system in motion, results, the costliest misprints, a box to go somewhere, doors. @param book
/// the run
/// @return the main page
[[nodiscard]] Page home_page(const Book& book);

/// @brief The errata on one sheet of paper. @param book the run @return the page `errata_sheet`
[[nodiscard]] Page errata_sheet(const Book& book);

/// @brief A file for the scripts.
struct ScriptFile {
    std::string name; ///< of the file
    std::string text; ///< JSON or a script
};

/// @brief Symbols and statements for the formulas, sections and figures for the box to go somewhere. @param book the run
/// @return the files
[[nodiscard]] std::vector<ScriptFile> script_files(const Book& book);

/// @brief Remarks on equations that do not depart from the print, with numbers that the library computes. @return by equation
[[nodiscard]] std::map<std::string, std::string> computed_remarks();

} // namespace denhartog::pages
