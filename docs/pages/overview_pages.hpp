/// @file
/// @brief Pages on all equations: the index, the departures, the graph of what rests on what.
#pragma once

#include <vector>

#include "equation_page.hpp"

namespace denhartog::pages {

/// @brief The index of the numbered equations, a row each. @param book the run @return the page `equations`
[[nodiscard]] Page index_page(const Book& book);

/// @brief Every departure by kind: printed, corrected, proof, witness, loss, figure. @param book the run @return the page
/// `errata`
[[nodiscard]] Page errata_page(const Book& book);

/// @brief The graph of what rests on what, as a picture with links and as a table. @param book the run
/// @return the page `equation_graph`
[[nodiscard]] Page graph_page(const Book& book);

/// @brief The shipped functions that the proofs take by their theorem and not by their text. @param book the run
/// @return the page `stand_ins`
[[nodiscard]] Page stand_ins_page(const Book& book);

/// @brief The audit: how each equation was decided, and what remains assumed. @param book the run @return the page `audit`
[[nodiscard]] Page audit_page(const Book& book);

/// @brief An equation's place in the picture of the graph.
struct Node {
    std::string equation;     ///< its number
    int row = 0;              ///< from the top: below everything that it rests on
    int column = 0;           ///< from the left
    std::string section = {}; ///< in whose band it stands
};

/// @brief Lays the graph out: an equation stands below all that it rests on, in the band of its section.
/// @param ledger   entries with `equation` and `rests_on`
/// @param longest  how many columns there are, shared out among the sections; more equations go on in the row below
/// @return         the nodes, in the order of the entries
/// @throws         InputError where an equation rests on itself by some way round, or on one that is not there
[[nodiscard]] std::vector<Node> layout(const Json& ledger, int longest);

} // namespace denhartog::pages
