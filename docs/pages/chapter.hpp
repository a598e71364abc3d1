/// @file
/// @brief The derivation as a chapter: prose by hand, every formula from the run.
///
/// A file is a page. It begins with `# Title`; `## Title` begins a section, an empty line ends a paragraph; `$...$` is a formula,
/// `` `...` `` is code, and the number of an equation in brackets becomes a link. Place-holders stand on lines of their own:
/// `{{equation 26}}` is the form that holds, `{{printed 26}}` the printed one, `{{steps A.5/constants}}` the steps of a claim as
/// the run recorded them, `{{claims 26}}` a list of the claims on an equation whose steps the chapter does not show.
#pragma once

#include <set>
#include <vector>

#include "equation_page.hpp"

namespace denhartog::pages {

/// @brief A file of the chapter.
struct ChapterFile {
    std::string name; ///< of its page, e.g. `derivation_2_1`
    std::string text; ///< its text
};

/// @brief What the chapter has said so far.
struct Mentioned {
    std::set<std::string> claims; ///< claims whose steps are shown, or that are listed
};

/// @brief Reads the chapter. @param folder with `chapter.md` and a file a section @return the files, `derivation_chapter` first
/// @throws InputError where there is no `chapter.md`
[[nodiscard]] std::vector<ChapterFile> read_chapter(const std::filesystem::path& folder);

/// @brief The pages of the chapter.
/// @param book      the run
/// @param files     what was written by hand
/// @param faults    takes a sentence for each place-holder that is unknown, and each claim that the chapter leaves out
/// @return          the pages
[[nodiscard]] std::vector<Page> chapter_pages(const Book& book, const std::vector<ChapterFile>& files,
                                              std::vector<std::string>& faults);

/// @brief Claims that the chapter has to mention: those on results among (4)-(72) and (A.1)-(A.15), but for observations.
/// @param run  the record
/// @return     their ids
[[nodiscard]] std::set<std::string> claims_to_mention(const RunRecord& run);

} // namespace denhartog::pages
