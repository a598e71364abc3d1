/// @file
/// @brief Answers in a file: CSV with the heading `id,value`, or JSON Lines as the protocol has them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "conformance/question.hpp"

namespace denhartog::conformance {

/// @brief Reads answers. A file whose first character is `{` is JSON Lines; any other is CSV, cells in quotes where they need it,
/// lines ended by LF or CRLF.
/// @param text   the file
/// @param known  the ids of all vectors
/// @return       the answers by id
/// @throws       InputError if the heading is missing, a line is not an answer, or an id is unknown or given twice
[[nodiscard]] std::map<std::string, Answer> answers_in(std::string_view text, const std::set<std::string>& known);

} // namespace denhartog::conformance
