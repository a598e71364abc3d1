/// @file
/// @brief The appearance of LaTeX: its width on the page, and its reading on a terminal.
#pragma once

#include <string>
#include <utility>

namespace denhartog::derivation {

/// @brief Width of typeset LaTeX in characters: the wider part of a fraction, 0.6 for an index. @param latex it @return the width
[[nodiscard]] double visible_width(const std::string& latex);

/// @brief Numerator and denominator of LaTeX that is one fraction. @param latex LaTeX @return both; empty if it is none
[[nodiscard]] std::pair<std::string, std::string> parts_of_fraction(const std::string& latex);

/// @brief A sentence for a terminal: what stands between dollar signs in plain characters, `$\psi_{ji}R_i^2$` as `psi_ji R_i^2`.
/// @param text  a sentence with formulas between dollar signs
/// @return      the sentence without
[[nodiscard]] std::string plain_sentence(const std::string& text);

} // namespace denhartog::derivation
