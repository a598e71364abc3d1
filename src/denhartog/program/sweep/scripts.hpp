/// @file
/// @brief The scripts that give the chunks of a study to an engine: Slurm, GNU parallel, Dask. All run the same chunks.
#pragma once

#include <string>
#include <vector>

namespace denhartog::program {

/// @brief A script.
struct Script {
    std::string name; ///< of its file
    std::string text; ///< its content
};

/// @brief The scripts of a study.
/// @param folder   absolute path of its folder
/// @param program  absolute path of this program
/// @param chunks   number of chunks
/// @return         slurm.sh, parallel.sh and with_dask.py
[[nodiscard]] std::vector<Script> scripts_of(const std::string& folder, const std::string& program, std::size_t chunks);

} // namespace denhartog::program
