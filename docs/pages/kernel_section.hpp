/// @file
/// @brief The section of an equation's page on the kernel of Coq: theorems, certificates, and what the kernel says of them.
#pragma once

#include <string>

#include "claim_text.hpp"

namespace denhartog::pages {

/// @brief What the kernel says of an equation.
/// @param book      what the pages are made of
/// @param entry     the equation's entry of the ledger
/// @param equation  its number
/// @return          the section, with its head
[[nodiscard]] std::string kernel_section(const Book& book, const Json& entry, const std::string& equation);

/// @brief A text in the language of Coq as raw HTML, its keywords and comments marked. @param text the text
/// @return a block for Doxygen
[[nodiscard]] std::string coq_block(const std::string& text);

} // namespace denhartog::pages
