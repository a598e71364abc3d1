/// @file
/// @brief A linear system \f$ z' = A z \f$ from a start, at any instants in any order.
///
/// The state is carried by exponentials of the system over \f$ 2^k \f$ times a step that is one over its largest rate: the work
/// grows as the logarithm of rate times time. Each exponential is kept less the identity, so that slow motions keep their digits
/// beside fast ones. Within a step the state is a power series in time, kept for other instants.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief The motion of a linear system.
template <class T>
class CoupledMotion {
public:
    CoupledMotion() = default;
    /// @param A       the system
    /// @param rate    no rate of it is faster: its entries over it are not much larger than 1 once its rows are scaled
    /// @param effort  what its exponentials spend; null: nothing
    CoupledMotion(Matrix<T> A, const T& rate, Effort* const* effort);

    /// @brief Starts at t = 0. @param z the state
    void start(Column<T> z);

    /// @brief The state at an instant. @param t time from the start @return z; not a number where t has no digits left for a step
    [[nodiscard]] Column<T> at(const T& t);

    /// @brief Other states of the same system, carried over a time. @param t the time @param z the states, a column each
    /// @return them then; not numbers where t has no digits left for a step
    Matrix<T> carried(const T& t, Matrix<T> z);

private:
    void spend_product(Eigen::Index columns) const;
    [[nodiscard]] Matrix<T> growth(const Matrix<T>& B, Matrix<T> z) const;
    [[nodiscard]] Matrix<T> doubled(const Matrix<T>& grown) const;
    const Matrix<T>& leap(std::size_t k);
    [[nodiscard]] std::optional<std::uint64_t> steps_in(const T& t) const;
    [[nodiscard]] T part_after(std::uint64_t n, const T& t) const;
    template <class Numbers>
    void leap_over(std::uint64_t n, Numbers& z);
    [[nodiscard]] Matrix<T> terms_from(const Column<T>& z) const;
    const Matrix<T>& series_after(std::uint64_t n);

    // An entry of a row that is not zero. Most entries are zero: half of the rows say that a velocity is one.
    struct Entry {
        Eigen::Index column;
        T value;
    };

    Matrix<T> A_;
    std::vector<Entry> entries_;    // row by row
    std::vector<std::size_t> ends_; // of each row in them
    T rate_ = T(1);
    Effort* const* effort_ = nullptr;
    Column<T> state_;                           // at the start
    std::vector<Matrix<T>> leaps_;              // as `leap` has them
    std::map<std::uint64_t, Matrix<T>> series_; // as `series_after` has them
};

} // namespace denhartog
