/// @file
/// @brief What a worker makes of the points of its chunk, and how the parts of several chunks are put together.
///
/// Counts add up, and of two largest values the larger counts, or of equal ones that with the earlier place: the result is the
/// same in any order. Exact quantiles are taken within a chunk, which holds their axes whole: linear between order statistics,
/// the smallest at probability 0 and the largest at 1. Quantiles with bins come from the histogram, linear within a bin, and are
/// as exact as it is.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "denhartog/sweep/plan.hpp"

namespace denhartog::sweep {

/// @brief Numbers over some axes of a chunk, the last running fastest; NaN where a point has none.
struct Field {
    std::vector<std::size_t> dimensions; ///< the axes, ascending
    std::vector<double> values;          ///< the numbers
};

/// @brief A reduction of one chunk, or of several that were put together.
struct Partial {
    std::vector<std::size_t> dimensions; ///< axes that are left, ascending
    std::size_t cells = 1;               ///< number of points over them
    std::vector<double> values;          ///< largest or smallest value, or quantiles, of each cell
    std::vector<std::int64_t> counts;    ///< counts of each cell; of a largest value its place over the reduced axes, or -1
};

/// @brief Reduces a field of a chunk. @param plan the plan @param r the reduction @param box the chunk @param field the field
/// @return what is made of it
[[nodiscard]] Partial reduced(const Plan& plan, const Reduction& r, const Box& box, const Field& field);

/// @brief Puts another part to a reduction. @param r the reduction @param all what there is @param part the other part
void put_together(const Reduction& r, Partial& all, const Partial& part);

/// @brief A part as bytes, from which it can be read again. @param part the part @return the bytes
[[nodiscard]] std::string to_bytes(const Partial& part);

/// @brief Reads a part again. @param plan the plan @param r the reduction @param box its chunk @param bytes the bytes
/// @return the part
/// @throws InputError where there are not as many as there must be
[[nodiscard]] Partial from_bytes(const Plan& plan, const Reduction& r, const Box& box, const std::string& bytes);

/// @brief An array of the results of a reduction.
struct Reduced {
    std::string name;                 ///< its name
    bool whole_numbers = false;       ///< whether they are counts
    std::vector<double> values;       ///< the numbers, cell after cell
    std::vector<std::int64_t> counts; ///< the counts in place of numbers
};

/// @brief The results of a reduction that is complete.
/// @param plan  the plan
/// @param r     the reduction
/// @param part  what was put together
/// @return      shares, counts or quantiles; of a largest value also the values of the reduced axes at its place
[[nodiscard]] std::vector<Reduced> finished(const Plan& plan, const Reduction& r, const Partial& part);

} // namespace denhartog::sweep
