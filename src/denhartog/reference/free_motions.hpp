/// @file
/// @brief The free motions \f$ \mathrm e^{\lambda_i\tau} \f$ of a linear system \f$ \mathbf z' = \mathbf B\mathbf z \f$.
#pragma once

#include <acb.h>

#include <memory>
#include <vector>

#include "denhartog/number/ball_matrix.hpp"
#include "denhartog/reference/remembered.hpp"

namespace denhartog::reference {

/// @brief A complex number in a rectangle.
struct ComplexBall {
    acb_t a; ///< the number as Arb has it

    /// @brief Zero.
    ComplexBall() { acb_init(a); }
    /// @param b  a number, copied to all its bits
    ComplexBall(const ComplexBall& b) : ComplexBall() { acb_set(a, b.a); }
    /// @param b  a number, whose value is taken
    ComplexBall(ComplexBall&& b) noexcept : ComplexBall() { acb_swap(a, b.a); }
    /// @brief Copies or takes a number. @param b the number @return this
    ComplexBall& operator=(ComplexBall b) noexcept {
        acb_swap(a, b.a);
        return *this;
    }
    /// @brief Frees the number.
    ~ComplexBall() { acb_clear(a); }
    /// @brief The real part. @return it
    [[nodiscard]] const Ball& re() const { return reinterpret_cast<const Ball&>(*acb_realref(a)); }
    /// @brief The imaginary part. @return it
    [[nodiscard]] const Ball& im() const { return reinterpret_cast<const Ball&>(*acb_imagref(a)); }
};

/// @brief The free motions of a system, where its eigenvalues are proved simple: \f$ \mathrm e^{\mathbf B\tau} = \sum_i
/// \mathbf r_i\mathrm e^{\lambda_i\tau}\mathbf l_i^{\mathrm T} \f$.
class FreeMotions {
public:
    /// @param B  a square matrix
    explicit FreeMotions(const BallMatrix& B);

    /// @brief Whether every eigenvalue is proved simple. @return true where the rest holds
    [[nodiscard]] bool are_simple() const { return simple_; }
    /// @brief An eigenvalue. @param i which @return lambda_i
    [[nodiscard]] const ComplexBall& lambda(std::size_t i) const { return lambda_[i]; }
    /// @brief How much of each free motion is in a state. @param z the state, a column @return \f$ \mathbf l_i^{\mathrm T}\mathbf z \f$
    [[nodiscard]] std::vector<ComplexBall> shares_of(const BallMatrix& z) const;
    /// @brief What the free motions add to a number. @param row the number, as a row over states
    /// @param shares  how much of each there is
    /// @return        factors of the real and the imaginary part of each free motion in turn, as `in_time` has them
    [[nodiscard]] std::vector<Ball> weights(const BallMatrix& row, const std::vector<ComplexBall>& shares) const;
    /// @brief A state later. @param shares how much of each free motion there is now @param t how much later @return the state
    [[nodiscard]] BallMatrix state(std::vector<ComplexBall> shares, const Ball& t) const;
    /// @brief The free motions in time. @return real and imaginary part of each in turn
    [[nodiscard]] std::shared_ptr<Remembered<std::vector<Series>>> in_time() const;

private:
    std::vector<ComplexBall> lambda_{}, L_{}, R_{}; // eigenvalues, left and right vectors, row by row
    bool simple_ = false;
};

/// @brief The sum of numbers times functions of time. @param weights the numbers @param e the functions @param sum added to it
/// @return the sum
[[nodiscard]] Series sum_of(const std::vector<Ball>& weights, const std::vector<Series>& e, Series sum);

} // namespace denhartog::reference
