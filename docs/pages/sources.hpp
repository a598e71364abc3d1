/// @file
/// @brief What the pages take from the sources: the lines of functions, and where claims and tests stand.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace denhartog::pages {

/// @brief A place in a source.
struct Place {
    std::string file; ///< path from the root of the sources
    int line = 0;     ///< from 1; 0 where nothing was found
};

/// @brief Lines of a source.
struct Snippet {
    std::string file;               ///< path from the root of the sources
    int first = 0;                  ///< line of the first, from 1
    std::vector<std::string> lines; ///< the lines as they stand
    std::size_t signature = 0;      ///< how many of them come before the body
};

/// @brief The sources of the project, read when asked for.
class Sources {
public:
    /// @brief Takes the root and reads where claims and tests stand. @param root the folder with `src`, `derivation`, `tests`
    explicit Sources(std::filesystem::path root);

    /// @brief A function or a type, from its template head to its closing brace.
    /// @param name  with its namespaces
    /// @param at    where its name stands
    /// @return      its lines
    /// @throws      InputError where the file has no such line, or the name does not stand in it
    [[nodiscard]] Snippet snippet(const std::string& name, const Place& at) const;

    /// @brief Where a claim is made. @param id its id, of which a source may have the beginning alone @return the place; line 0
    /// where none
    [[nodiscard]] Place claim(const std::string& id) const;

    /// @brief Where a test is declared. @param name its name as it ran @return the place; line 0 where none
    [[nodiscard]] Place test(const std::string& name) const;

    /// @return the root
    [[nodiscard]] const std::filesystem::path& root() const { return root_; }

private:
    [[nodiscard]] const std::vector<std::string>& lines(const std::string& file) const;

    std::filesystem::path root_;
    std::map<std::string, Place> makers_;   ///< literals that a claim takes as its id
    std::map<std::string, Place> literals_; ///< other literals of the derivation with a slash
    std::map<std::string, int> lines_of_;   ///< lines of literals without one, by file and text
    std::map<std::string, Place> tests_;
    mutable std::map<std::string, std::vector<std::string>> files_;
};

/// @brief A snippet as raw HTML, its lines numbered and linked. @param snippet the lines @return a block for Doxygen
[[nodiscard]] std::string code_block(const Snippet& snippet);

} // namespace denhartog::pages
