/// @file
/// @brief What a page offers to take away and to try: the formula as code, and a check of the reader's own number.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace denhartog::pages {

/// @brief A certified question for the reader's number, with the answers of known mistakes.
struct CheckScene {
    std::string scene;                                                 ///< plain text
    std::string quantity;                                              ///< as the protocol has it
    std::vector<double> right;                                         ///< the certified value
    std::vector<std::pair<std::string, std::vector<double>>> mistakes; ///< what a mistake is, and what it answers
};

/// @brief For each equation some certified questions that mistakes in it get wrong, or that ask for it.
/// @param vectors  the folder of the certified vectors
/// @return         the questions by the numbers of the equations
/// @throws         InputError where the vectors cannot be read
[[nodiscard]] std::map<std::string, std::vector<CheckScene>> check_scenes(const std::filesystem::path& vectors);

/// @brief The formula to copy: LaTeX, and the library's function as C++, Python and MATLAB where it is offered.
/// @param equation  its number
/// @param latex     what holds
/// @return          raw HTML for Doxygen
[[nodiscard]] std::string copy_text(const std::string& equation, const std::string& latex);

/// @brief The check of the reader's number. @param equation its number @param scenes the certified questions on it
/// @return raw HTML for Doxygen; empty where there is neither a formula nor a question
[[nodiscard]] std::string check_text(const std::string& equation, const std::vector<CheckScene>& scenes);

} // namespace denhartog::pages
