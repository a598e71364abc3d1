/// @file
/// @brief Matrices of balls, by Arb. Nothing here knows of masses or friction.
#pragma once

#include <arb_mat.h>

#include "denhartog/number/ball.hpp"

namespace denhartog {

/// @brief A matrix of balls; a column is one of one column.
class BallMatrix {
public:
    arb_mat_t a; ///< the matrix as Arb has it

    /// @brief Zeros.
    explicit BallMatrix(slong rows = 0, slong columns = 0) { arb_mat_init(a, rows, columns); }
    /// @brief A copy.
    BallMatrix(const BallMatrix& b) : BallMatrix(b.rows(), b.columns()) { arb_mat_set(a, b.a); }
    /// @brief Takes the entries of another matrix.
    BallMatrix(BallMatrix&& b) noexcept : BallMatrix() { arb_mat_swap(a, b.a); }
    /// @brief Assigns.
    BallMatrix& operator=(BallMatrix b) noexcept {
        arb_mat_swap(a, b.a);
        return *this;
    }
    /// @brief Frees the entries.
    ~BallMatrix() { arb_mat_clear(a); }

    /// @brief Number of rows.
    [[nodiscard]] slong rows() const { return arb_mat_nrows(a); }
    /// @brief Number of columns.
    [[nodiscard]] slong columns() const { return arb_mat_ncols(a); }
    /// @brief An entry.
    [[nodiscard]] Ball& operator()(slong r, slong c = 0) { return reinterpret_cast<Ball&>(*arb_mat_entry(a, r, c)); }
    /// @brief An entry.
    [[nodiscard]] const Ball& operator()(slong r, slong c = 0) const {
        return reinterpret_cast<const Ball&>(*arb_mat_entry(a, r, c));
    }

    /// @brief Product.
    friend BallMatrix operator*(const BallMatrix& x, const BallMatrix& y) {
        BallMatrix r(x.rows(), y.columns());
        arb_mat_mul(r.a, x.a, y.a, ball_bits);
        return r;
    }
    /// @brief Multiple.
    friend BallMatrix operator*(const BallMatrix& x, const Ball& s) {
        BallMatrix r(x.rows(), x.columns());
        arb_mat_scalar_mul_arb(r.a, x.a, s.a, ball_bits);
        return r;
    }
    /// @brief Sum.
    friend BallMatrix operator+(const BallMatrix& x, const BallMatrix& y) {
        BallMatrix r(x.rows(), x.columns());
        arb_mat_add(r.a, x.a, y.a, ball_bits);
        return r;
    }
    /// @brief Difference.
    friend BallMatrix operator-(const BallMatrix& x, const BallMatrix& y) {
        BallMatrix r(x.rows(), x.columns());
        arb_mat_sub(r.a, x.a, y.a, ball_bits);
        return r;
    }
};
static_assert(sizeof(Ball) == sizeof(arb_struct), "an entry of a matrix is a ball");

/// @brief The unit matrix.
[[nodiscard]] inline BallMatrix unit_matrix(slong n) {
    BallMatrix r(n, n);
    arb_mat_one(r.a);
    return r;
}

/// @brief Rows for columns.
[[nodiscard]] inline BallMatrix transposed(const BallMatrix& x) {
    BallMatrix r(x.columns(), x.rows());
    arb_mat_transpose(r.a, x.a);
    return r;
}

/// @brief Exponential of a square matrix; wide if x is: never exponentiate a wide ball.
[[nodiscard]] inline BallMatrix exp(const BallMatrix& x) {
    BallMatrix r(x.rows(), x.columns());
    arb_mat_exp(r.a, x.a, ball_bits);
    return r;
}

/// @brief A matrix rounded to the current bits.
[[nodiscard]] inline BallMatrix rounded(const BallMatrix& A) {
    BallMatrix r(A.rows(), A.columns());
    for (slong i = 0; i < A.rows(); ++i)
        for (slong k = 0; k < A.columns(); ++k) arb_set_round(r(i, k).a, A(i, k).a, ball_bits);
    return r;
}

/// @brief The midpoints, exact.
[[nodiscard]] inline BallMatrix middle(const BallMatrix& x) {
    BallMatrix r(x.rows(), x.columns());
    arb_mat_get_mid(r.a, x.a);
    return r;
}

/// @brief Solves x y = b; false if x may be singular.
[[nodiscard]] inline bool solved(const BallMatrix& x, const BallMatrix& b, BallMatrix& y) {
    y = BallMatrix(x.rows(), b.columns());
    return arb_mat_solve(y.a, x.a, b.a, ball_bits) != 0;
}

/// @brief An upper bound of the largest sum of sizes in a row.
[[nodiscard]] inline double norm(const BallMatrix& x) {
    mag_t b;
    mag_init(b);
    arb_mat_bound_inf_norm(b, x.a);
    const double d = mag_get_d(b);
    mag_clear(b);
    return d;
}

} // namespace denhartog
