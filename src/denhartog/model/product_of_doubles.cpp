// The product of two matrices of doubles, column by column, each sum in the order of its terms: its digits are the same on every
// processor. The file is one of those that are compiled with more optimization.
#include "denhartog/model/detail/product_of_doubles.hpp"

#include <algorithm>

namespace denhartog {
namespace {

// Adds four columns, each times a number, to a column.
void add_four(const double* __restrict a, std::ptrdiff_t stride, const double* __restrict b, double* __restrict sum,
              std::ptrdiff_t rows) {
    const double *a_1 = a + stride, *a_2 = a_1 + stride, *a_3 = a_2 + stride;
    const double b_0 = b[0], b_1 = b[1], b_2 = b[2], b_3 = b[3];
    for (std::ptrdiff_t i = 0; i < rows; ++i) sum[i] = (((sum[i] + a[i] * b_0) + a_1[i] * b_1) + a_2[i] * b_2) + a_3[i] * b_3;
}

void add_one(const double* __restrict a, double b, double* __restrict sum, std::ptrdiff_t rows) {
    for (std::ptrdiff_t i = 0; i < rows; ++i) sum[i] += a[i] * b;
}

} // namespace

void product_of_doubles(const ColumnsOfDoubles& A, const ColumnsOfDoubles& B, double* product) {
    std::fill_n(product, A.rows * B.columns, 0.0);
    for (std::ptrdiff_t j = 0; j < B.columns; ++j) {
        const double* b = B.data + j * B.stride;
        double* sum = product + j * A.rows;
        std::ptrdiff_t k = 0;
        for (; k + 4 <= A.columns; k += 4) add_four(A.data + k * A.stride, A.stride, b + k, sum, A.rows);
        for (; k < A.columns; ++k) add_one(A.data + k * A.stride, b[k], sum, A.rows);
    }
}

} // namespace denhartog
