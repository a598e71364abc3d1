/// @file
/// @brief Matrices of balls of which few entries are not zero, by Arb.
#pragma once

#include <utility>
#include <vector>

#include "denhartog/number/ball_matrix.hpp"

namespace denhartog {

/// @brief A matrix whose zeros cost nothing in a product.
class SparseBalls {
public:
    /// @brief The entries of a matrix that are not zero.
    explicit SparseBalls(const BallMatrix& A) : rows_(static_cast<std::size_t>(A.rows())) {
        for (slong i = 0; i < A.rows(); ++i)
            for (slong k = 0; k < A.columns(); ++k) {
                if (A(i, k).is_zero()) continue;
                Row& row = rows_[static_cast<std::size_t>(i)];
                row.columns.push_back(k);
                row.entries.push_back(A(i, k));
                ++count_;
            }
    }
    /// @brief Number of entries that are not zero.
    [[nodiscard]] long count() const { return count_; }
    /// @brief The product with column `from` of x, which goes to column `to` of y; that may be another one of the same matrix.
    void times_column(const BallMatrix& x, slong from, BallMatrix& y, slong to) const {
        std::vector<arb_struct> picked; // copies of the numbers' handles, which own nothing
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            picked.clear();
            for (const slong k : rows_[i].columns) picked.push_back(*x(k, from).a);
            arb_dot(y(static_cast<slong>(i), to).a, nullptr, 0, picked.empty() ? nullptr : rows_[i].entries.front().a, 1,
                    picked.data(), 1, static_cast<slong>(picked.size()), ball_bits);
        }
    }

private:
    struct Row {
        std::vector<slong> columns{}; // of the entries that are not zero
        std::vector<Ball> entries{};
    };
    std::vector<Row> rows_;
    long count_ = 0;
};

/// @brief Exponential of a square matrix with many zeros, by Taylor's series of a part of it whose norm is at most 1. Never
/// exponentiate a wide ball. What is zero in the result may be uncertain.
[[nodiscard]] inline BallMatrix exp_of_sparse(const BallMatrix& A) {
    const slong n = A.rows();
    BallMatrix part(n, n), sum = unit_matrix(n), product(n, n);
    double left = norm(A);
    if (!(left < 1e300)) {
        arb_mat_indeterminate(sum.a);
        return sum;
    }
    slong squarings = 0;
    for (; left > 1; left /= 2) ++squarings;
    const Bits more(ball_bits + 8 + 4 * squarings); // a squaring doubles what is uncertain, and a product widens it
    arb_mat_scalar_mul_2exp_si(part.a, A.a, -squarings);
    const SparseBalls B(part);
    mag_t size, rest;
    mag_init(size);
    mag_init(rest);
    arb_mat_bound_inf_norm(size, part.a);
    mag_one(rest); // the first term left out; all of them are at most twice that
    slong terms = 0;
    while (mag_cmp_2exp_si(rest, -ball_bits) > 0) {
        mag_mul(rest, rest, size);
        mag_div_ui(rest, rest, static_cast<ulong>(++terms));
    }
    Ball product_of_k(1);
    for (slong k = terms - 1; k > 0; --k) { // ((B + 3) B + 3 * 2) B + 3 * 2 * 1, over the last number
        product_of_k *= Ball(k);
        for (slong c = 0; c < n; ++c) {
            B.times_column(sum, c, product, c);
            arb_add(product(c, c).a, product(c, c).a, product_of_k.a, ball_bits);
        }
        std::swap(sum, product);
    }
    arb_mat_scalar_div_arb(sum.a, sum.a, product_of_k.a, ball_bits);
    mag_mul_2exp_si(rest, rest, 1);
    for (slong i = 0; i < n; ++i)
        for (slong c = 0; c < n; ++c) arb_add_error_mag(sum(i, c).a, rest);
    mag_clear(size);
    mag_clear(rest);
    for (; squarings > 0; --squarings) arb_mat_sqr(sum.a, sum.a, ball_bits);
    return sum;
}

} // namespace denhartog
