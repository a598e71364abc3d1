/// @file
/// @brief `denhartog sweep run`: chunks, each computed and written once.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "denhartog/program/sweep/folder.hpp"

namespace denhartog::program {

/// @brief What a run of chunks came to.
struct ChunksRun {
    std::size_t computed = 0;    ///< chunks that it computed
    std::size_t found_done = 0;  ///< chunks that were done before
    std::optional<int> signal{}; ///< the signal that ended it
};

/// @brief Computes chunks that are not done. Two runs of one chunk at once write the same bytes under the same names.
/// @param study   the study
/// @param chunks  their numbers
/// @param jobs    how many at once
/// @param told    told after each chunk how many are done of those asked for; by one thread at a time
/// @return        what it came to; after a signal the chunks that were not finished have left nothing
/// @throws        InputError where a file cannot be written; the chunk is then not done
[[nodiscard]] ChunksRun run_chunks(const StudyFolder& study, const std::vector<std::size_t>& chunks, unsigned jobs,
                                   const std::function<void(std::size_t done)>& told);

} // namespace denhartog::program
