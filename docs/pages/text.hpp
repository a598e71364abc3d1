/// @file
/// @brief Text for Doxygen: what is special to it is escaped, formulas, symbols and the numbers of equations become what they
/// are.
#pragma once

#include <string>

namespace denhartog::pages {

/// @brief Text that Doxygen shows as it is. @param text any text @return the same with its special characters escaped
[[nodiscard]] std::string escaped(const std::string& text);

/// @brief Text for an attribute or a raw block of HTML. @param text any text @return the same with `&`, `<`, `>`, `"` as entities
[[nodiscard]] std::string html(const std::string& text);

/// @brief A formula in a line. @param latex LaTeX without delimiters @return the formula, delimited for Doxygen
[[nodiscard]] std::string formula(const std::string& latex);

/// @brief A formula on a line of its own. @param latex LaTeX without delimiters @return the formula, delimited for Doxygen
[[nodiscard]] std::string displayed(const std::string& latex);

/// @brief The label of an equation's page. @param equation its number, e.g. `A.8` @return e.g. `eq_A_8`
[[nodiscard]] std::string equation_label(const std::string& equation);

/// @brief A label made of a name: all but letters and digits becomes `_`. @param kind what comes first @param name the name
/// @return the label
[[nodiscard]] std::string label(const std::string& kind, const std::string& name);

/// @brief A link to an equation's page. @param equation its number @return the link, shown as the number in brackets
[[nodiscard]] std::string equation_link(const std::string& equation);

/// @brief A link to a line of a source, resolved when the site is there. @param file path from the root @param line from 1
/// @param shown what is to be seen, as plain text @return an element `a`
[[nodiscard]] std::string source_link(const std::string& file, int line, const std::string& shown);

/// @brief LaTeX of a symbol that the run names in plain text. @param name e.g. `eta_prime_0` @param alone whether the name stands
/// by itself, so that one letter is a symbol @return e.g. `\eta_{0}'`, or nothing where it is no symbol
[[nodiscard]] std::string symbol(const std::string& name, bool alone);

/// @brief A sentence of the run: escaped, its symbols typeset, the numbers of equations linked. @param text plain text
/// @return text for Doxygen
[[nodiscard]] std::string prose(const std::string& text);

/// @brief Text with formulas between dollars and code between backquotes; the rest as `prose`. @param text the text
/// @param place where it stands, for the message @return text for Doxygen @throws InputError where one is not closed
[[nodiscard]] std::string typeset(const std::string& text, const std::string& place);

/// @brief A sentence that a note of the ledger becomes: its first word with a capital, a full stop at its end. @param note plain
/// text
/// @return text for Doxygen
[[nodiscard]] std::string sentence(std::string note);

/// @brief A name of a witness, typeset where it is a symbol. @param name the name @return text for Doxygen
[[nodiscard]] std::string witness_name(const std::string& name);

/// @brief A value of a witness: a fraction typeset, a long decimal cut to 20 digits with an ellipsis. @param value as recorded
/// @return text for Doxygen
[[nodiscard]] std::string witness_value(const std::string& value);

/// @brief A number in few digits. @param x the number @param format as `printf` has it @return its text
[[nodiscard]] std::string digits(double x, const char* format = "%.3g");

/// @brief A count with its noun. @param n the count @param one the noun @param many its plural @return e.g. `1 claim`, `2 claims`
[[nodiscard]] std::string counted(std::size_t n, const std::string& one, const std::string& many);

} // namespace denhartog::pages
