/// @file
/// @brief The certified vectors of the source tree, read once.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "conformance/vector.hpp"

namespace denhartog::tests {

/// @brief Where the vectors are. @return the folder in the source tree
[[nodiscard]] inline std::filesystem::path vector_folder() {
    const char* source = std::getenv("DENHARTOG_SOURCE_DIR");
    return std::filesystem::path(source != nullptr ? source : ".") / "tests/conformance/vectors";
}

/// @brief All vectors. @return the vectors, by file and line
[[nodiscard]] inline const std::vector<conformance::Vector>& vectors() {
    static const std::vector<conformance::Vector> all = conformance::read_vectors(vector_folder());
    return all;
}

} // namespace denhartog::tests
