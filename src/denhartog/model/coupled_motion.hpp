/// @file
/// @brief A linear system \f$ z' = A z \f$ from a start, at any instants in any order.
///
/// The state is carried by exponentials of the system over \f$ 2^k \f$ times a step: the work grows as the logarithm of rate
/// times time. Each exponential is kept less the identity, so that slow motions keep their digits beside fast ones. Within a step
/// the state is a power series in time, kept for other instants. A step is not longer than one over the largest rate. Where many
/// instants of one start are asked, half a period is a power of 2 of them; where many starts have a few instants each, it is a part
/// of that length, whose series is shorter.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A power series in a part of a step.
struct PowerSeries {
    std::uint64_t step = 0; ///< whole steps before it
    Matrix<double> terms{}; ///< a column for each power, and some that are not used
    Eigen::Index count = 0; ///< columns in use
};

/// @brief The motion of a linear system.
class CoupledMotion {
public:
    /// @brief The questions that are asked most often.
    enum class Asked : std::uint8_t {
        instants_of_one_start, ///< many instants of one start
        many_starts            ///< a few instants of many starts
    };

    CoupledMotion() = default;
    /// @brief Of a matrix A with no rate faster than `rate`: its entries over that are not much larger than 1 once its rows are
    /// scaled. Its exponentials spend of `effort`, if there is one.
    CoupledMotion(const Matrix<double>& A, double rate, Asked asked, Effort* const* effort);

    void pay_no_more() { effort_ = nullptr; } ///< what follows is not paid for

    void start(const Column& z); ///< starts at t = 0 with a state

    /// @brief The state at time t from the start, until the next call; of NaN if t has no digits left for a step.
    [[nodiscard]] const Column& at(double t);

    /// @brief The rate \f$ Az \f$ of a state.
    [[nodiscard]] Column rates(const Column& z) const;
    /// @brief Operations that a state with three derivatives costs at another instant: a series, and two leaps or so.
    [[nodiscard]] long cost() const {
        return cost_of_products(64 * rows() + 3 * static_cast<Eigen::Index>(entries_.size()) + 2 * rows() * rows());
    }

    /// @brief \f$ e^{A\pi}-\mathbf{1} \f$, the exponential of the system over half a period, less the identity, where many
    /// instants of one start are asked. Half a period holds fewer than \f$ 2^{53} \f$ steps.
    [[nodiscard]] const Matrix<double>& growth_over_half_period() { return leap(doublings_); }

    /// @brief Other states of the same system, a column each, carried over a time; not numbers where t has no digits left for a
    /// step.
    Matrix<double> carried(double t, Matrix<double> z);

private:
    [[nodiscard]] Eigen::Index rows() const { return static_cast<Eigen::Index>(ends_.size()); }
    void spend_products(Eigen::Index count) const;
    bool add_term(const double* entry, double factor, const double* before, double* term, double* sum) const;
    [[nodiscard]] Matrix<double> growth(const std::vector<double>& entries, Matrix<double> z) const;
    [[nodiscard]] Matrix<double> doubled(const Matrix<double>& grown) const;
    const Matrix<double>& leap(std::size_t k);
    [[nodiscard]] std::optional<std::uint64_t> steps_in(double t) const;
    [[nodiscard]] double part_after(std::uint64_t n, double t) const;
    void leap_over(std::uint64_t n, double* z, Eigen::Index columns);
    void sum_up(const PowerSeries& series, double s);
    void form_terms(PowerSeries& series);
    const PowerSeries& series_after(std::uint64_t n);

    // Entries of A that are not zero, row by row. Most are zero: half of the rows say that a velocity is one.
    std::vector<double> entries_;
    std::vector<Eigen::Index> columns_; // of each of them
    std::vector<std::size_t> ends_;     // of each row in them
    std::size_t doublings_ = 0;         // of a step, which then is half a period
    double rate_ = 1.0;                 // steps a unit of time
    std::uint64_t single_steps_ = 0;    // so many are made one by one
    Effort* const* effort_ = nullptr;
    Column state_;                      // at the start
    Column now_;                        // working space for a state, which `at` returns
    std::vector<Matrix<double>> leaps_; // as `leap` has them
    std::vector<PowerSeries> series_;   // as `series_after` has them, and behind them those of earlier starts, to be written over
    std::size_t known_ = 0;             // series of this start
    std::vector<double> sum_, leapt_;   // working space
};

} // namespace denhartog
