/// @file
/// @brief Expressions in the language of the proof assistant Coq, the same text on every run.
#pragma once

#include <ginac/ginac.h>
#include <map>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief The names of symbols, and those that stand for the inverse of something.
struct CoqNames {
    std::map<GiNaC::ex, std::string, GiNaC::ex_is_less> names;    ///< of symbols whose own name does not do
    std::map<GiNaC::ex, std::string, GiNaC::ex_is_less> inverses; ///< symbol -> the name of what it is the inverse of
};

/// @brief A name that Coq takes for a variable: letters, digits and underscores, and none that the real numbers have already.
/// @param name  any name @return the name
[[nodiscard]] std::string coq_name(const std::string& name);

/// @brief An expression as Coq reads it, in the scope of the real numbers.
///
/// Terms and factors are sorted by their text, because GiNaC's own order changes from run to run.
/// @param e      the expression
/// @param names  of its symbols
/// @return       the text
/// @throws       std::domain_error where a part of it has no name in Coq
[[nodiscard]] std::string coq_text(const GiNaC::ex& e, const CoqNames& names = {});

/// @brief Sorts expressions by their text in Coq; those that have none come first.
/// @param first  the first
/// @param last   behind the last
void sort_by_text(std::vector<GiNaC::ex>::iterator first, std::vector<GiNaC::ex>::iterator last);

/// @brief A sentence that can stand in a comment of Coq. @param sentence the sentence @return the same without quotes and marks
[[nodiscard]] std::string coq_comment(std::string sentence);

} // namespace denhartog::derivation
