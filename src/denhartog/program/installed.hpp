/// @file
/// @brief Where the program finds what it reads by default: in the tree it was built from or, once installed, beside itself.
#pragma once

#include <string>

namespace denhartog::program {

/// @brief The program that runs. @return its path; `denhartog` where the system does not tell
[[nodiscard]] std::string this_program();

/// @brief The certified vectors. @return their folder
[[nodiscard]] std::string vectors_folder();

/// @brief The hand-written half of the ledger. @return the path of equations.json
[[nodiscard]] std::string equations_file();

/// @brief What the last derivation left. @param name `ledger.json` or `derivation.json` @return its path
[[nodiscard]] std::string derivation_file(const std::string& name);

} // namespace denhartog::program
