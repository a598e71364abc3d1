/// @file
/// @brief Which function computes which equation: read from the tag `eq` in the doc comments of the headers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief A function, or a type, whose doc comment names an equation.
struct FunctionEntry {
    std::string equation; ///< as the ledger writes it, or as it stands where the paper has no such equation
    std::string name;     ///< with its namespaces
    std::string file;     ///< from the folder above the source root, e.g. `src/denhartog/formulas/mode.hpp`
    int line = 0;         ///< where the name stands, from 1
    /// @brief Same entry. @return whether it is
    bool operator==(const FunctionEntry&) const = default;
};

/// @brief Functions documented in one header.
/// @param source  the text of the header
/// @param file    its name, as the entries are to carry it
/// @return        one entry an equation and function, in the order of the text
/// @throws        InputError where a tag names nothing or belongs to nothing that has a name
[[nodiscard]] std::vector<FunctionEntry> functions_of_header(const std::string& source, const std::string& file);

/// @brief Functions documented in all headers under a folder.
/// @param source_root  the folder `src`
/// @return             one entry an equation and function, by file and line
/// @throws             InputError as `functions_of_header`, and where there is no header at all
[[nodiscard]] std::vector<FunctionEntry> functions_of_sources(const std::filesystem::path& source_root);

/// @brief Whether a function is the formula itself, in the namespaces `paper` or `evaluation`; others make use of the equation.
/// @param function  an entry
/// @return          true for a formula that is shipped
[[nodiscard]] bool is_formula(const FunctionEntry& function);

/// @brief Whether a function is the printed form of a refuted equation, kept for comparison and not shipped.
/// @param function  an entry
/// @return          true in the namespace `as_printed`
[[nodiscard]] bool is_as_printed(const FunctionEntry& function);

} // namespace denhartog::derivation
