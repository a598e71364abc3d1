/// @file
/// @brief LaTeX of GiNaC expressions for a reader: the same bytes on every run.
///
/// GiNaC orders terms and factors by addresses in memory, which change from run to run. Here they are ordered by what is printed:
/// numbers in front, then the paper's symbols in the order in which the paper writes them, exponentials, sums in brackets,
/// circular and hyperbolic functions. A sum starts with a term that is not negative where it has one; a quotient has one bar.
#pragma once

#include <ginac/ginac.h>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief A term of a sum, printed.
struct LatexTerm {
    bool negative = false; ///< whether it is subtracted
    std::string latex;     ///< without its sign
};

/// @brief The terms of an expression in the order in which they are printed; one where it is not a sum.
/// @param e  the expression
/// @return   its terms
[[nodiscard]] std::vector<LatexTerm> latex_terms(const GiNaC::ex& e);

/// @brief LaTeX of an expression in one line. @param e the expression @return LaTeX
[[nodiscard]] std::string latex_line(const GiNaC::ex& e);

/// @brief `left = e`; where that is wider than a line, broken before terms of the sum in an `aligned` block.
/// @param left  LaTeX of the left side
/// @param e     the right side
/// @return      LaTeX for a display
[[nodiscard]] std::string latex_equation(const std::string& left, const GiNaC::ex& e);

/// @brief Puts two pieces of LaTeX side by side: a control word does not swallow the letter that follows it.
/// @param a  the left piece
/// @param b  the right piece
/// @return   both
[[nodiscard]] std::string joined(const std::string& a, const std::string& b);

} // namespace denhartog::derivation
