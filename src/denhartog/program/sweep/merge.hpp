/// @file
/// @brief `denhartog sweep merge`: whether every chunk is there exactly once, and what several chunks have a part in.
#pragma once

#include <string>
#include <vector>

#include "denhartog/program/sweep/folder.hpp"
#include "denhartog/sweep/arrays.hpp"

namespace denhartog::program {

/// @brief What stands against putting the chunks together.
struct MergeFaults {
    std::vector<std::size_t> missing; ///< chunks without a record
    std::vector<std::string> faults;  ///< of chunks that have one, and files that belong to none
    /// @brief Whether there is nothing. @return whether there is nothing
    [[nodiscard]] bool none() const { return missing.empty() && faults.empty(); }
};

/// @brief Checks every chunk with its files and checksums, and that no file is there that no chunk wrote. @param study the study
/// @return what is wrong
[[nodiscard]] MergeFaults faults_of(const StudyFolder& study);

/// @brief Puts together the reductions that several chunks have a part in, and completes the store.
/// @param study a study without faults
/// @throws InputError where a file cannot be read or written
void merge(const StudyFolder& study);

/// @brief All arrays of the results, coordinates first. @param plan the plan @return the arrays
[[nodiscard]] std::vector<sweep::Array> all_arrays(const sweep::Plan& plan);

} // namespace denhartog::program
