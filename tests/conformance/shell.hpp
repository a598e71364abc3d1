/// @file
/// @brief Compilers and interpreters of other languages, as the tests run them.
#pragma once

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

namespace denhartog::tests {

/// @brief Whether a command is there. @param name its name @return whether the shell finds it
inline bool has_command(const std::string& name) { return run_shell("command -v " + name).status == 0; }

/// @brief The same; if it is not there, the test says that it is skipped. @param name its name @return whether it is there
inline bool is_there_or_skipped(const std::string& name) {
    const bool there = has_command(name);
    if (!there) SKIPPED(name << " is not there");
    return there;
}

/// @brief Whether a program with somebody else's solver was built; if not, the test says that it is skipped. @param name its name
inline bool is_built_or_skipped(const std::string& name) {
    const bool built = std::filesystem::exists(built_program(name));
    if (!built) SKIPPED(name << " is not built, as its package is missing");
    return built;
}

} // namespace denhartog::tests
