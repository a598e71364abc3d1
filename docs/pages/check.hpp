/// @file
/// @brief What can be wrong with the pages before Doxygen reads them.
#pragma once

#include <string>
#include <vector>

#include "equation_page.hpp"

namespace denhartog::pages {

/// @brief Labels, formulas and equations of the pages.
/// @param pages  all of them
/// @return       a sentence for each equation without a page, label that is there twice or not at all, formula that is not closed
/// or
///               whose braces do not match, and LaTeX outside of a formula
[[nodiscard]] std::vector<std::string> faults_of(const std::vector<Page>& pages);

} // namespace denhartog::pages
