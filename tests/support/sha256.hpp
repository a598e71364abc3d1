/// @file
/// @brief SHA-256, the checksum of files of reference data, by `sha256sum` of the GNU coreutils.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace denhartog::tests {

/// @brief The checksum of some bytes. @param bytes the bytes @return 64 hexadecimal digits
[[nodiscard]] inline std::string sha256(const std::string& bytes) {
    const auto file = std::filesystem::temp_directory_path() / ("denhartog-checksum-" + std::to_string(::getpid()));
    std::ofstream(file, std::ios::binary) << bytes;
    FILE* pipe = ::popen(("sha256sum '" + file.string() + "'").c_str(), "r");
    std::string digits(64, ' ');
    const bool read = pipe != nullptr && std::fread(digits.data(), 1, digits.size(), pipe) == digits.size();
    const bool ended = pipe != nullptr && ::pclose(pipe) == 0;
    std::filesystem::remove(file);
    if (!read || !ended) throw std::runtime_error("sha256sum of the GNU coreutils must be there");
    return digits;
}

} // namespace denhartog::tests
