/// @file
/// @brief The page of one numbered equation.
#pragma once

#include <string>

#include "claim_text.hpp"

namespace denhartog::pages {

/// @brief A page of the site.
struct Page {
    std::string name; ///< its label and the name of its file
    std::string text; ///< Markdown for Doxygen
};

/// @brief The first line of a page. @param name its label @param title plain text @return the heading
[[nodiscard]] std::string page_head(const std::string& name, const std::string& title);

/// @brief The page of an equation: what is printed and what holds, in words and with the difference marked; proof, function, the
/// reader's own number, figures, tests, what the text says. And a page behind it with the library's other forms, where it
/// has any.
/// @param book      the run
/// @param equation  its number
/// @return          the pages, its own first
/// @throws          InputError where a function is not at its line, or a claim has no record
[[nodiscard]] std::vector<Page> equation_pages(const Book& book, const std::string& equation);

/// @brief Links to equations, separated by commas. @param equations an array of numbers @return text for Doxygen, or a dash
[[nodiscard]] std::string equation_links(const Json& equations);

/// @brief A link to a function's own documentation. @param function an entry of the ledger @return text for Doxygen
[[nodiscard]] std::string function_link(const Json& function);

/// @brief Rows of the records of accuracy for an equation; all of them for an empty number.
/// @param run       the record
/// @param equation  its number, or empty
/// @return          a table, or nothing where no record speaks of the equation
[[nodiscard]] std::string accuracy_table(const RunRecord& run, const std::string& equation);

} // namespace denhartog::pages
