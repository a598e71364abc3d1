/// @file
/// @brief Runs of the built program, which the environment names.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/named_scenes.hpp"

namespace denhartog::tests {

/// @brief Whether the programs are built under the address sanitizer.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool with_address_sanitizer = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool with_address_sanitizer = true;
#else
inline constexpr bool with_address_sanitizer = false;
#endif
#else
inline constexpr bool with_address_sanitizer = false;
#endif

/// @brief What a run left.
struct Run {
    int status;         ///< exit status
    std::string output; ///< standard output
    std::string error;  ///< standard error
};

/// @brief A directory of this test process, gone at its end.
inline const std::filesystem::path& scratch() {
    struct Directory {
        std::filesystem::path path = std::filesystem::temp_directory_path() / ("denhartog-tests-" + std::to_string(::getpid()));
        Directory() { std::filesystem::create_directories(path); }
        ~Directory() { std::filesystem::remove_all(path); }
    };
    static const Directory directory;
    return directory.path;
}

inline std::string content_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline std::filesystem::path file_with(const std::string& name, const std::string& text) {
    std::ofstream(scratch() / name, std::ios::binary) << text;
    return scratch() / name;
}

/// @brief Runs a shell command. @param command the command @param input standard input @return status and what it wrote
inline Run run_shell(const std::string& command, const std::string& input = "") {
    const auto in = file_with("input", input), out = scratch() / "output", err = scratch() / "error";
    const std::string whole = "{ " + command + "\n} <'" + in.string() + "' >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(whole.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content_of(out), content_of(err)};
}

/// @brief A program that is built beside the one under test. @param name its name; without one it is that itself
inline std::filesystem::path built_program(const std::string& name = "") {
    const char* program = std::getenv("DENHARTOG_PROGRAM");
    if (program == nullptr) throw std::runtime_error("DENHARTOG_PROGRAM must name the program: run the tests by ctest");
    return name.empty() ? std::filesystem::path(program) : std::filesystem::path(program).parent_path() / name;
}

/// @brief The same as a shell is told it. @param name its name; without one it is the one under test @return the path in quotes
inline std::string quoted_program(const std::string& name = "") { return "'" + built_program(name).string() + "'"; }

/// @brief Runs the program.
inline Run run_program(const std::string& arguments, const std::string& input = "") {
    return run_shell(quoted_program() + " " + arguments, input);
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

inline std::vector<double> numbers_of(const std::string& csv) {
    std::vector<double> numbers;
    std::istringstream in(csv);
    for (std::string cell; std::getline(in, cell, ',');) numbers.push_back(std::stod(cell));
    return numbers;
}

} // namespace denhartog::tests
