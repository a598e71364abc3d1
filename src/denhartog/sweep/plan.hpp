/// @file
/// @brief The points of a study as a grid, and its division into chunks. Nothing here depends on machine or time.
///
/// The axes of the grid: those of the study in its order, but frequency and friction last, and before them `sample`. A chunk is
/// a box of the grid, all boxes have one shape but for the last along each axis, and number K counts them in the order of the
/// results, the last axis running fastest. A column of friction is never split, nor an axis over which exact quantiles are taken.
#pragma once

#include <string>
#include <vector>

#include "denhartog/sweep/study/study.hpp"

namespace denhartog::sweep {

/// @brief An axis of the grid.
struct Dimension {
    std::string name;           ///< its name in results
    std::size_t size = 1;       ///< number of values
    std::vector<double> values; ///< its values; none for `sample`
    /// @brief A value of it. @param n its place @return the value; the place itself for `sample`
    [[nodiscard]] double value(std::size_t n) const { return values.empty() ? static_cast<double>(n) : values[n]; }
};

/// @brief A part of the grid: a range along each axis.
struct Box {
    std::vector<std::size_t> place; ///< which box along each axis
    std::vector<std::size_t> start; ///< the first point along each axis
    std::vector<std::size_t> count; ///< the number of points along each axis
    /// @brief Number of points. @return their number
    [[nodiscard]] std::size_t points() const;
};

/// @brief The division of a study.
struct Plan {
    Study study;                       ///< the study
    std::vector<Dimension> dimensions; ///< the axes of the grid
    std::vector<std::size_t> chunk;    ///< shape of a chunk
    std::vector<std::size_t> boxes;    ///< number of chunks along each axis
    std::size_t chunks = 0;            ///< number of chunks
    std::size_t points = 0;            ///< number of points

    /// @brief The place of an axis. @param name its name @return its place; the number of axes where it is none
    [[nodiscard]] std::size_t place_of(const std::string& name) const;
    /// @brief A chunk. @param K its number, from 0 @return its box
    [[nodiscard]] Box box(std::size_t K) const;
    /// @brief Whether chunks divide an axis. @param dimension the axis @return whether they do
    [[nodiscard]] bool splits(std::size_t dimension) const { return boxes[dimension] > 1; }
    /// @brief Whether a reduction has to be put together from several chunks. @param r the reduction @return whether it has
    [[nodiscard]] bool splits(const Reduction& r) const;
    /// @brief An earlier maximum or minimum. @param name its name @return the reduction; null where there is none
    [[nodiscard]] const Reduction* reduction(const std::string& name) const;
    /// @brief The axes that are left of a field or after a reduction. @param name the name of the one or the other
    /// @return their places, ascending
    [[nodiscard]] std::vector<std::size_t> dimensions_of(const std::string& name) const;
};

/// @brief The most chunks of a study.
inline constexpr std::size_t most_chunks = 10'000'000;

/// @brief Divides a study, and checks what depends on several of its parts.
/// @param study  the study
/// @return       its plan
/// @throws       InputError naming quantity, rule and value
[[nodiscard]] Plan plan_of(const Study& study);

} // namespace denhartog::sweep
