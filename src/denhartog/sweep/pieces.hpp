/// @file
/// @brief The files that a chunk leaves in the folder of a study.
#pragma once

#include <string>
#include <vector>

#include "denhartog/sweep/plan.hpp"
#include "denhartog/sweep/points.hpp"
#include "denhartog/sweep/reduce.hpp"

namespace denhartog::sweep {

/// @brief A file.
struct Piece {
    std::string path;  ///< from the folder of the study, e.g. `result.zarr/regime/0.3`
    std::string bytes; ///< its content
};

/// @brief The folder of the results in that of a study.
inline constexpr const char* result_folder = "result.zarr";

/// @brief The paths of the files that a chunk leaves. @param plan the plan @param K its number @return the paths
[[nodiscard]] std::vector<std::string> paths_of(const Plan& plan, std::size_t K);

/// @brief The files that a chunk leaves. @param plan the plan @param K its number @param points what it found
/// @return its chunk of every array; of a reduction that other chunks have a part in, its part
[[nodiscard]] std::vector<Piece> pieces_of(const Plan& plan, std::size_t K, const Points& points);

/// @brief Where the part of a chunk of a reduction stands. @param r the reduction @param K the chunk @return the path
[[nodiscard]] std::string path_of_part(const Reduction& r, std::size_t K);

/// @brief The files of a reduction that is complete. @param plan the plan @param r the reduction @param box one of its chunks
/// @param part what was put together @return a chunk of each of its arrays
[[nodiscard]] std::vector<Piece> pieces_of(const Plan& plan, const Reduction& r, const Box& box, const Partial& part);

/// @brief Bytes that all chunks together leave. @param plan the plan @return their number, without records and coordinates
[[nodiscard]] double bytes_of_study(const Plan& plan);

} // namespace denhartog::sweep
