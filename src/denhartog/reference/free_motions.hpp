/// @file
/// @brief The free motions \f$ \mathrm e^{\lambda_i\tau} \f$ of a linear system \f$ \mathbf z' = \mathbf B\mathbf z \f$.
#pragma once

#include <acb_mat.h>

#include <memory>
#include <vector>

#include "denhartog/number/ball_matrix.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/reference/series.hpp"

namespace denhartog::reference {

/// @brief A complex number in a rectangle.
struct ComplexBall {
    acb_t a; ///< the number as Arb has it

    ComplexBall() { acb_init(a); }
    /// @brief A copy.
    ComplexBall(const ComplexBall& b) : ComplexBall() { acb_set(a, b.a); }
    /// @brief Takes the number of another one.
    ComplexBall(ComplexBall&& b) noexcept : ComplexBall() { acb_swap(a, b.a); }
    /// @brief Assignment.
    ComplexBall& operator=(ComplexBall b) noexcept {
        acb_swap(a, b.a);
        return *this;
    }
    ~ComplexBall() { acb_clear(a); }
    /// @brief Real part.
    [[nodiscard]] const Ball& re() const { return reinterpret_cast<const Ball&>(*acb_realref(a)); }
    /// @brief Imaginary part.
    [[nodiscard]] const Ball& im() const { return reinterpret_cast<const Ball&>(*acb_imagref(a)); }
};

/// @brief A square matrix of complex numbers, or a row of them.
class ComplexMatrix {
public:
    acb_mat_t a; ///< the matrix as Arb has it
    /// @brief A matrix of zeros.
    ComplexMatrix(slong rows, slong columns) { acb_mat_init(a, rows, columns); }
    /// @brief A real matrix as a complex one.
    explicit ComplexMatrix(const BallMatrix& A) : ComplexMatrix(A.rows(), A.columns()) { acb_mat_set_arb_mat(a, A.a); }
    ComplexMatrix(const ComplexMatrix&) = delete;
    ComplexMatrix& operator=(const ComplexMatrix&) = delete;
    ~ComplexMatrix() { acb_mat_clear(a); }
    /// @brief The numbers, row by row.
    [[nodiscard]] acb_ptr all() const { return a->entries; }
};

/// @brief The free motions of a system, if its eigenvalues are proved simple: \f$ \mathrm e^{\mathbf B\tau} = \sum_i
/// \mathbf r_i\mathrm e^{\lambda_i\tau}\mathbf l_i^{\mathrm T} \f$.
class FreeMotions {
public:
    /// @brief Of the free motion z' = B z. What is computed is paid from `effort`.
    explicit FreeMotions(const BallMatrix& B, Effort* effort = nullptr);

    /// @brief Whether every eigenvalue is proved simple.
    [[nodiscard]] bool are_simple() const { return simple_; }
    /// @brief A rate of the free motion.
    [[nodiscard]] const ComplexBall& lambda(std::size_t i) const { return lambda_[i]; }
    /// @brief Share of each free motion in a state: \f$ \mathbf l_i^{\mathrm T}\mathbf z \f$.
    [[nodiscard]] std::vector<ComplexBall> shares_of(const BallMatrix& z) const;
    /// @brief Weights of the free motions in a number, a row over states: of the real and the imaginary part of each in turn.
    [[nodiscard]] std::vector<Ball> weights(const BallMatrix& row, const std::vector<ComplexBall>& shares) const;
    /// @brief The state that shares of the free motions have come to at a time.
    [[nodiscard]] BallMatrix state(std::vector<ComplexBall> shares, const Ball& t) const;
    /// @brief The free motions in time: real and imaginary part of each in turn.
    [[nodiscard]] std::shared_ptr<Remembered<std::vector<Series>>> in_time() const;

private:
    std::vector<ComplexBall> lambda_{}, L_{}, R_{}; // eigenvalues, left and right vectors, row by row
    bool simple_ = false;
    Effort* effort_;
};

/// @brief The sum of numbers times functions of time.
[[nodiscard]] Series sum_of(const std::vector<Ball>& weights, const std::vector<Series>& e, Series sum);

} // namespace denhartog::reference
