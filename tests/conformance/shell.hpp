/// @file
/// @brief Compilers and interpreters of other languages, as the tests run them.
#pragma once

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

namespace denhartog::tests {

/// @brief Runs a shell command. @param command the command @param input standard input @return status and what it wrote
inline Run run_shell(const std::string& command, const std::string& input = "") {
    const auto in = file_with("shell-input", input), out = scratch() / "shell-output", err = scratch() / "shell-error";
    const std::string whole = "{ " + command + "\n} <'" + in.string() + "' >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(whole.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content_of(out), content_of(err)};
}

/// @brief Whether a command is there. @param name its name @return whether the shell finds it
inline bool has_command(const std::string& name) { return run_shell("command -v " + name).status == 0; }

/// @brief The same; if it is not there, the test says that it is skipped. @param name its name @return whether it is there
inline bool is_there_or_skipped(const std::string& name) {
    const bool there = has_command(name);
    if (!there) SKIPPED(name << " is not there");
    return there;
}

} // namespace denhartog::tests
