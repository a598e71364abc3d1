/// @file
/// @brief The page of a type, without what Doxygen says twice.
#pragma once

#include <string>

namespace denhartog::pages {

/// @brief The page of a type as a reader wants it.
///
/// The description comes first. A member whose documentation is the sentence beside its declaration has no box of its own; its
/// name leads to the line of the source. Every place that another page may link to stays on the page.
/// @param page  the page as Doxygen wrote it
/// @param name  the name of its file
/// @return      the page
[[nodiscard]] std::string class_page(std::string page, const std::string& name);

} // namespace denhartog::pages
