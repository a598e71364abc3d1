/// @file
/// @brief What the tests of the ledger share: the project's own rows, a folder that goes away, a search in a list of faults.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include "derivation/ledger/ledger_rows.hpp"
#include "tests/catch.hpp"

namespace denhartog::tests {

/// @brief The project's folder. @return the path that the test run is told by DENHARTOG_SOURCE_DIR
[[nodiscard]] inline std::filesystem::path project() {
    const char* folder = std::getenv("DENHARTOG_SOURCE_DIR");
    REQUIRE(folder != nullptr);
    return folder;
}

/// @brief The hand-written rows of the project. @return a JSON array
[[nodiscard]] inline ledger::Json project_rows() { return derivation::read_rows(project() / "docs/ledger/equations.json"); }

/// @brief Whether one of the faults holds a text. @param faults sentences @param part the text @return true where one does
[[nodiscard]] inline bool tells(const std::vector<std::string>& faults, const std::string& part) {
    for (const std::string& fault : faults)
        if (fault.find(part) != std::string::npos) return true;
    return false;
}

/// @brief A folder of its own for a test; it goes when the test ends.
class Folder {
public:
    Folder() {
        static int count = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("denhartog-ledger-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// @brief Writes a file. @param name its name, may have folders @param text what it holds @return its path
    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file.string();
    }

private:
    std::filesystem::path path_;
};

} // namespace denhartog::tests
