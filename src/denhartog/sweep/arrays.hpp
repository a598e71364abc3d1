/// @file
/// @brief The arrays of a study's results as a Zarr store, format version 2, not compressed: one raw file a chunk of an array.
///
/// `_ARRAY_DIMENSIONS` names the axes as xarray has it. Numbers are stored least significant byte first.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "denhartog/sweep/plan.hpp"

namespace denhartog::sweep {

/// @brief A type of numbers in a store.
enum class Stored : std::uint8_t {
    int8,   ///< `|i1`
    int32,  ///< `<i4`
    int64,  ///< `<i8`
    float64 ///< `<f8`
};

/// @brief Bytes of a number. @param type its type @return their number
[[nodiscard]] std::size_t bytes_of(Stored type);

/// @brief An array of the results.
struct Array {
    std::string name;                    ///< its name
    Stored type = Stored::float64;       ///< its numbers
    std::vector<std::string> dimensions; ///< names of its axes
    std::vector<std::size_t> shape;      ///< their lengths
    std::vector<std::size_t> chunk;      ///< shape of a chunk
    nlohmann::ordered_json attributes;   ///< what is said of it

    /// @brief Its metadata. @return the content of `.zarray`
    [[nodiscard]] nlohmann::ordered_json metadata() const;
    /// @brief Its attributes. @return the content of `.zattrs`
    [[nodiscard]] nlohmann::ordered_json all_attributes() const;
    /// @brief Number of chunks along each axis. @return the numbers
    [[nodiscard]] std::vector<std::size_t> boxes() const;
};

/// @brief A coordinate: an array of one chunk with its content.
struct Coordinate {
    Array array;       ///< the array
    std::string bytes; ///< the content of its only chunk
};

/// @brief Arrays that have a value a point of the grid. @param plan the plan @return the arrays, in the order of the results
[[nodiscard]] std::vector<Array> arrays_of_points(const Plan& plan);

/// @brief Arrays of a reduction. @param plan the plan @param r the reduction @return the arrays, as `finished` has them
[[nodiscard]] std::vector<Array> arrays_of(const Plan& plan, const Reduction& r);

/// @brief The axes with their values, and what was drawn for each sample where there are at most 2^20. @param plan the plan
/// @return the coordinates
[[nodiscard]] std::vector<Coordinate> coordinates_of(const Plan& plan);

/// @brief The name of the file of a chunk. @param place its place along each axis
/// @return e.g. `0.3.1`; `0` where there are no axes
[[nodiscard]] std::string chunk_name(const std::vector<std::size_t>& place);

/// @brief The bytes of a chunk. Those at the end of an axis are as large as all others: zeros fill them up.
/// @param array  the array
/// @param count  how many numbers it has along each axis
/// @param bytes  their bytes, the last axis running fastest
/// @return       the content of its file
[[nodiscard]] std::string chunk_content(const Array& array, const std::vector<std::size_t>& count, std::string bytes);

/// @brief Numbers as bytes. @param numbers the numbers @return their bytes, least significant first
template <class T>
[[nodiscard]] std::string stored(const std::vector<T>& numbers);

} // namespace denhartog::sweep
