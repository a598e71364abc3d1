// Matrices of balls, by Arb: full ones, those of which few entries are not zero, and complex ones. Nothing here knows of
// masses or friction.
#pragma once

#include <acb_mat.h>

#include <utility>
#include <vector>

#include "denhartog/number/ball.hpp"

namespace denhartog {

// A matrix of balls; a column is one of one column.
class BallMatrix {
public:
    arb_mat_t a; // the matrix as Arb has it

    explicit BallMatrix(slong rows = 0, slong columns = 0) { arb_mat_init(a, rows, columns); }
    BallMatrix(const BallMatrix& b) : BallMatrix(b.rows(), b.columns()) { arb_mat_set(a, b.a); }
    BallMatrix(BallMatrix&& b) noexcept : BallMatrix() { arb_mat_swap(a, b.a); }
    BallMatrix& operator=(BallMatrix b) noexcept {
        arb_mat_swap(a, b.a);
        return *this;
    }
    ~BallMatrix() { arb_mat_clear(a); }

    [[nodiscard]] slong rows() const { return arb_mat_nrows(a); }
    [[nodiscard]] slong columns() const { return arb_mat_ncols(a); }
    [[nodiscard]] Ball& operator()(slong r, slong c = 0) { return reinterpret_cast<Ball&>(*arb_mat_entry(a, r, c)); }
    [[nodiscard]] const Ball& operator()(slong r, slong c = 0) const {
        return reinterpret_cast<const Ball&>(*arb_mat_entry(a, r, c));
    }

    friend BallMatrix operator*(const BallMatrix& x, const BallMatrix& y) {
        BallMatrix r(x.rows(), y.columns());
        arb_mat_mul(r.a, x.a, y.a, ball_bits);
        return r;
    }
    friend BallMatrix operator*(const BallMatrix& x, const Ball& s) {
        BallMatrix r(x.rows(), x.columns());
        arb_mat_scalar_mul_arb(r.a, x.a, s.a, ball_bits);
        return r;
    }
    friend BallMatrix operator/(const BallMatrix& x, const Ball& s) {
        BallMatrix r(x.rows(), x.columns());
        arb_mat_scalar_div_arb(r.a, x.a, s.a, ball_bits);
        return r;
    }
    friend BallMatrix operator-(const BallMatrix& x) {
        BallMatrix r(x.rows(), x.columns());
        arb_mat_neg(r.a, x.a);
        return r;
    }
    friend BallMatrix operator+(const BallMatrix& x, const BallMatrix& y) {
        BallMatrix r(x.rows(), x.columns());
        arb_mat_add(r.a, x.a, y.a, ball_bits);
        return r;
    }
    friend BallMatrix operator-(const BallMatrix& x, const BallMatrix& y) {
        BallMatrix r(x.rows(), x.columns());
        arb_mat_sub(r.a, x.a, y.a, ball_bits);
        return r;
    }
};
static_assert(sizeof(Ball) == sizeof(arb_struct), "an entry of a matrix is a ball");

[[nodiscard]] inline BallMatrix unit_matrix(slong n) {
    BallMatrix r(n, n);
    arb_mat_one(r.a);
    return r;
}

[[nodiscard]] inline BallMatrix transposed(const BallMatrix& x) {
    BallMatrix r(x.columns(), x.rows());
    arb_mat_transpose(r.a, x.a);
    return r;
}

// Exponential of a square matrix; wide if x is: never exponentiate a wide ball.
[[nodiscard]] inline BallMatrix exp(const BallMatrix& x) {
    BallMatrix r(x.rows(), x.columns());
    arb_mat_exp(r.a, x.a, ball_bits);
    return r;
}

// A matrix rounded to the current bits.
[[nodiscard]] inline BallMatrix rounded(const BallMatrix& A) {
    BallMatrix r(A.rows(), A.columns());
    for (slong i = 0; i < A.rows(); ++i)
        for (slong k = 0; k < A.columns(); ++k) arb_set_round(r(i, k).a, A(i, k).a, ball_bits);
    return r;
}

// The part of a matrix from a row and a column on.
[[nodiscard]] inline BallMatrix part_of(const BallMatrix& A, slong row, slong column, slong rows, slong columns) {
    BallMatrix r(rows, columns);
    for (slong i = 0; i < rows; ++i)
        for (slong k = 0; k < columns; ++k) r(i, k) = A(row + i, column + k);
    return r;
}

// Writes a matrix into a larger one, from a row and a column on.
inline void put(BallMatrix& A, slong row, slong column, const BallMatrix& part) {
    for (slong i = 0; i < part.rows(); ++i)
        for (slong k = 0; k < part.columns(); ++k) A(row + i, column + k) = part(i, k);
}

// The midpoints, exact.
[[nodiscard]] inline BallMatrix middle(const BallMatrix& x) {
    BallMatrix r(x.rows(), x.columns());
    arb_mat_get_mid(r.a, x.a);
    return r;
}

// Solves x y = b; false if x may be singular.
[[nodiscard]] inline bool solved(const BallMatrix& x, const BallMatrix& b, BallMatrix& y) {
    y = BallMatrix(x.rows(), b.columns());
    return arb_mat_solve(y.a, x.a, b.a, ball_bits) != 0;
}

// An upper bound of the largest sum of sizes in a row.
[[nodiscard]] inline double norm(const BallMatrix& x) {
    mag_t b;
    mag_init(b);
    arb_mat_bound_inf_norm(b, x.a);
    const double d = mag_get_d(b);
    mag_clear(b);
    return d;
}

// A matrix whose zeros cost nothing in a product.
class SparseBalls {
public:
    // The entries of a matrix that are not zero.
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
    // Number of entries that are not zero.
    [[nodiscard]] long count() const { return count_; }
    // The product with column `from` of x, which goes to column `to` of y; that may be another one of the same matrix.
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

// A complex number in a rectangle.
struct ComplexBall {
    acb_t a; // the number as Arb has it

    ComplexBall() { acb_init(a); }
    ComplexBall(const ComplexBall& b) : ComplexBall() { acb_set(a, b.a); }
    ComplexBall(ComplexBall&& b) noexcept : ComplexBall() { acb_swap(a, b.a); }
    ComplexBall& operator=(ComplexBall b) noexcept {
        acb_swap(a, b.a);
        return *this;
    }
    ~ComplexBall() { acb_clear(a); }
    [[nodiscard]] const Ball& re() const { return reinterpret_cast<const Ball&>(*acb_realref(a)); }
    [[nodiscard]] const Ball& im() const { return reinterpret_cast<const Ball&>(*acb_imagref(a)); }
};

// A square matrix of complex numbers, or a row of them.
class ComplexMatrix {
public:
    acb_mat_t a; // the matrix as Arb has it
    ComplexMatrix(slong rows, slong columns) { acb_mat_init(a, rows, columns); }
    explicit ComplexMatrix(const BallMatrix& A) : ComplexMatrix(A.rows(), A.columns()) { acb_mat_set_arb_mat(a, A.a); }
    ComplexMatrix(const ComplexMatrix&) = delete;
    ComplexMatrix& operator=(const ComplexMatrix&) = delete;
    ~ComplexMatrix() { acb_mat_clear(a); }
    // The numbers, row by row.
    [[nodiscard]] acb_ptr all() const { return a->entries; }
};

} // namespace denhartog
