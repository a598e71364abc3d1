/// @file
/// @brief All generated pages of the site.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "home_page.hpp"

namespace denhartog::pages {

/// @brief The pages, and why they cannot be taken.
struct Site {
    std::vector<Page> pages;         ///< in no order that matters
    std::vector<ScriptFile> scripts; ///< what the scripts of the pages read
    std::vector<std::string> faults; ///< a sentence each; empty where all is well
};

/// @brief Makes all pages.
/// @param run      what a run wrote
/// @param sources  the sources
/// @param chapter  the folder with the hand-written half of the chapter
/// @return         the pages and their faults
[[nodiscard]] Site make_site(const RunRecord& run, const Sources& sources, const std::filesystem::path& chapter);

/// @brief Writes the pages, a file each; a file that is unchanged is left alone, one of an earlier run that is no page is
/// removed.
/// @param pages   the pages
/// @param folder  where to
/// @return        how many files were written
/// @throws        InputError where one cannot be written
[[nodiscard]] std::size_t write_pages(const std::vector<Page>& pages, const std::filesystem::path& folder);

/// @brief Writes the files for the scripts. @param scripts the files @param folder where to @throws InputError where one
/// cannot be written
void write_scripts(const std::vector<ScriptFile>& scripts, const std::filesystem::path& folder);

} // namespace denhartog::pages
