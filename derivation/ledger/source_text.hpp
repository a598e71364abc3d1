/// @file
/// @brief C++ source cut into code, comments and literals: what the indexes of functions and of tests read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief A stretch of source of one sort.
struct Piece {
    /// @brief The kind of a stretch of source.
    enum class Sort {
        code,    ///< neither comment nor literal
        comment, ///< a comment, with its slashes
        literal  ///< what a string or character literal holds, escapes resolved
    };
    Sort sort = Sort::code; ///< which sort
    std::string text;       ///< the text
    int line = 1;           ///< line on which it starts, from 1
};

/// @brief Cuts source into pieces. The quotes of literals belong to no piece.
/// @param source  C++ source
/// @return        the pieces in order
[[nodiscard]] std::vector<Piece> pieces_of(const std::string& source);

/// @brief All of a file. @param file a path @return its bytes @throws InputError where it cannot be read
[[nodiscard]] std::string text_of(const std::filesystem::path& file);

/// @brief Files of a folder and the folders in it, in alphabetical order.
/// @param folder     a folder; where there is none, the answer is empty
/// @param extension  with its dot, e.g. `.hpp`
/// @return           the paths
[[nodiscard]] std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, const std::string& extension);

} // namespace denhartog::derivation
