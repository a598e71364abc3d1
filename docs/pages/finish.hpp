/// @file
/// @brief The last pass over the finished site: headings, the list for the search, the map of the site; and its checks.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace denhartog::pages {

/// @brief A page as readers get it: its title as the heading of first order, wide tables in boxes that scroll.
/// @param page  the HTML that Doxygen wrote
/// @return      the HTML
[[nodiscard]] std::string finished_page(std::string page);

/// @brief What a page is about, for the order of what the search finds. @param name of its file
/// @return 0 an equation, 1 a figure or the derivation, 2 another text, 3 what is behind an equation, 4 code
[[nodiscard]] int kind_of_page(const std::string& name);

/// @brief What the search knows of a page: an entry for the page and one for each documented name on it.
/// @param page  its HTML, finished
/// @param name  its file
/// @return      objects with title, url and text; empty where the page has no heading
[[nodiscard]] std::vector<nlohmann::json> search_documents(const std::string& page, const std::string& name);

/// @brief The text of a piece of HTML: no tags, no scripts, single blanks. @param html the piece @return the text
[[nodiscard]] std::string text_of_html(const std::string& html);

/// @brief What finishing a site came to.
struct FinishedSite {
    std::size_t pages = 0;           ///< pages
    std::size_t links = 0;           ///< links followed within the site
    std::size_t documents = 0;       ///< entries of the search
    std::vector<std::string> faults; ///< a sentence each: broken links, missing anchors, addresses elsewhere
};

/// @brief Finishes all pages of a site and follows their links.
/// @param site  the folder with the HTML; gets `search-documents.js`
/// @return      counts and faults
/// @throws      InputError where a file cannot be read or written
[[nodiscard]] FinishedSite finish_site(const std::filesystem::path& site);

} // namespace denhartog::pages
