/// @file
/// @brief The product of two matrices of doubles, the same to the last bit on every machine.
#pragma once

#include <cstddef>

namespace denhartog {

/// @brief A matrix by columns.
struct ColumnsOfDoubles {
    const double* data;     ///< its first number
    std::ptrdiff_t rows;    ///< its rows
    std::ptrdiff_t columns; ///< its columns
    std::ptrdiff_t stride;  ///< from a column to the next
};

/// @brief \f$ AB \f$: each number is the sum of its terms from the first to the last, one after the other. Loops become vectors,
/// as they run over the rows.
void product_of_doubles(const ColumnsOfDoubles& A, const ColumnsOfDoubles& B, double* product);

} // namespace denhartog
