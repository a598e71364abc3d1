/// @file
/// @brief What of Doxygen's pages nobody reads is left out, and the long pages of namespaces are parted by header.
#pragma once

#include <map>
#include <string>

namespace denhartog::pages {

/// @brief Leaves out lists of members, folders, pages of files outside of the library and of types that are not part of its
/// interface, and parts the page of each namespace: a list of names by header stays, and what is said of them goes to a page for
/// each header.
/// Links follow: to a page of a file that is left out they lead to its source, elsewhere their text stays.
/// @param texts  HTML of the pages by the name of the file, finished; those left out are taken away, the new ones are added
void trim(std::map<std::string, std::string>& texts);

} // namespace denhartog::pages
