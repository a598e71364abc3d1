/// @file
/// @brief Links from the finished pages to lines of sources, which only Doxygen knows the addresses of.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace denhartog::pages {

/// @brief Addresses in a site.
struct Addresses {
    std::map<std::string, std::string> sources; ///< page with the source of a file, by its path from the root of the sources
    std::map<std::string, std::string> pages;   ///< page, by its label
};

/// @brief Reads Doxygen's tag file. @param xml its text @param root the root of the sources @return the addresses
[[nodiscard]] Addresses read_tags(const std::string& xml, const std::filesystem::path& root);

/// @brief Replaces `href="source:FILE:LINE"`, the same without a line, and `href="page:LABEL"` in one page.
/// @param page       its HTML
/// @param addresses  of the site
/// @param missing    takes what cannot be resolved
/// @param targets    takes each address with an anchor that was put in
/// @return           the page
[[nodiscard]] std::string with_links(const std::string& page, const Addresses& addresses, std::vector<std::string>& missing,
                                     std::map<std::string, std::string>& targets);

/// @brief Resolves the links of all pages of a site, and makes sure that each leads to a line that is there.
/// @param site      the folder with the HTML
/// @param tag_file  Doxygen's tag file
/// @param root      the root of the sources
/// @param resolved  how many were put in
/// @return          what cannot be resolved, a sentence each; where there is any, no page is changed
/// @throws          InputError where a file cannot be read or written
[[nodiscard]] std::vector<std::string> link_site(const std::filesystem::path& site, const std::filesystem::path& tag_file,
                                                 const std::filesystem::path& root, std::size_t& resolved);

} // namespace denhartog::pages
