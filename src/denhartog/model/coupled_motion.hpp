/// @file
/// @brief A linear system \f$ z' = A z \f$ from a start, at any instants in any order.
///
/// The state is carried by exponentials of the system over \f$ 2^k \f$ times a step that is one over its largest rate: the work
/// grows as the logarithm of rate times time. Each exponential is kept less the identity, so that slow motions keep their digits
/// beside fast ones. Within a step the state is a power series in time, kept for other instants.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
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
    CoupledMotion(Matrix<T> A, const T& rate, Effort* const* effort) : A_(std::move(A)), rate_(rate), effort_(effort) {
        for (Eigen::Index row = 0; row < A_.rows(); ++row) {
            for (Eigen::Index column = 0; column < A_.cols(); ++column)
                if (A_(row, column) != 0) entries_.push_back({column, A_(row, column)});
            ends_.push_back(entries_.size());
        }
    }

    /// @brief Starts at t = 0. @param z the state
    void start(Column<T> z) {
        state_ = std::move(z);
        series_.clear();
    }

    /// @brief The state at an instant. @param t time from the start @return z; not a number where t has no digits left for a step
    [[nodiscard]] Column<T> at(const T& t) {
        const std::optional<std::uint64_t> n = steps_in(t);
        if (!n) return state_ * std::numeric_limits<T>::quiet_NaN();
        return sum_of(series_after(*n), part_after(*n, t));
    }

    /// @brief Other states of the same system, carried over a time. @param t the time @param z the states, a column each
    /// @return them then; not numbers where t has no digits left for a step
    Matrix<T> carried(const T& t, Matrix<T> z) {
        const std::optional<std::uint64_t> n = steps_in(t);
        if (!n) return z * std::numeric_limits<T>::quiet_NaN();
        leap_over(*n, z);
        return z + growth(A_ * T(part_after(*n, t) / rate_), z);
    }

private:
    // A product of the system with some columns is to be formed.
    void spend_product(Eigen::Index columns) const {
        if (effort_ == nullptr) return;
        (*effort_)->spend(cost_of_products<T>(static_cast<long>(A_.size() * columns)));
        if ((*effort_)->exhausted()) throw PrecisionError((*effort_)->ending());
    }

    // exp(B) z - z by its series; no entry of B is much larger than 1 once its rows are scaled.
    Matrix<T> growth(const Matrix<T>& B, Matrix<T> z) const {
        Matrix<T> sum = Matrix<T>::Zero(z.rows(), z.cols());
        for (int k = 1; k <= most_terms; ++k) {
            spend_product(z.cols());
            z = B * z / T(k);
            Matrix<T> next = sum + z;
            if (next == sum) break;
            sum.swap(next);
        }
        return sum;
    }

    // From exp(B) less the identity the same of 2 B.
    [[nodiscard]] Matrix<T> doubled(const Matrix<T>& grown) const {
        spend_product(A_.cols());
        return grown * grown + T(2) * grown;
    }

    // exp(A 2^k / rate) less the identity. The first is doubled up from a part of the step, whose series has fewer terms.
    const Matrix<T>& leap(std::size_t k) {
        constexpr int doublings = std::numeric_limits<T>::digits / 32;
        if (leaps_.empty()) {
            const Matrix<T> part = A_ / T(rate_ * (1 << doublings));
            Matrix<T> grown = growth(part, Matrix<T>::Identity(A_.rows(), A_.cols()));
            for (int n = 0; n < doublings; ++n) grown = doubled(grown);
            leaps_.push_back(std::move(grown));
        }
        while (leaps_.size() <= k) leaps_.push_back(doubled(leaps_.back()));
        return leaps_[k];
    }

    // Whole steps in a time; none where nothing is left of the time's digits.
    [[nodiscard]] std::optional<std::uint64_t> steps_in(const T& t) const {
        const double steps = std::floor(static_cast<double>(T(t * rate_)));
        if (!(steps < 0x1p53)) return std::nullopt;
        return static_cast<std::uint64_t>(steps);
    }

    // What is left of a time after n steps, as a part of a step.
    [[nodiscard]] T part_after(std::uint64_t n, const T& t) const { return (t - T(static_cast<double>(n)) / rate_) * rate_; }

    template <class Numbers>
    void leap_over(std::uint64_t n, Numbers& z) {
        for (std::size_t k = 0; n >> k != 0; ++k)
            if ((n >> k & 1) != 0) z += leap(k) * z;
    }

    // The terms of exp(A s / rate) z for s up to 1, a column each, as many as s = 1 needs.
    [[nodiscard]] Matrix<T> terms_from(const Column<T>& z) const {
        constexpr Eigen::Index first_room = 32;
        Matrix<T> terms(z.size(), first_room);
        terms.col(0) = z;
        Column<T> sum = z;
        Eigen::Index k = 1;
        for (bool grows = true; grows && k <= most_terms; ++k) {
            if (k == terms.cols()) terms.conservativeResize(Eigen::NoChange, 2 * k);
            const T divisor(static_cast<int>(k) * rate_);
            const T* const before = terms.col(k - 1).data();
            T* const term = terms.col(k).data();
            grows = false;
            for (std::size_t i = 0, entry = 0; i < ends_.size(); ++i) {
                T each(0);
                for (; entry < ends_[i]; ++entry) each += entries_[entry].value * before[entries_[entry].column];
                each /= divisor;
                term[i] = each;
                T& known = sum(static_cast<Eigen::Index>(i));
                const T next = known + each;
                grows = grows || next != known;
                known = next;
            }
        }
        terms.conservativeResize(Eigen::NoChange, k);
        return terms;
    }

    static Column<T> sum_of(const Matrix<T>& terms, const T& s) {
        Column<T> sum = terms.col(terms.cols() - 1);
        for (Eigen::Index k = terms.cols() - 2; k >= 0; --k) sum = terms.col(k) + s * sum;
        return sum;
    }

    // The series over the step after n of them: the first few step by step, without the exponentials, which are dear.
    const Matrix<T>& series_after(std::uint64_t n) {
        const auto known = series_.find(n);
        if (known != series_.end()) return known->second;
        if (series_.size() >= most_series) series_.clear();
        if (n == 0 || n > most_single_steps) {
            Column<T> z = state_;
            leap_over(n, z);
            return series_.emplace(n, terms_from(z)).first->second;
        }
        const Column<T> z = sum_of(series_after(n - 1), T(1));
        return series_.emplace(n, terms_from(z)).first->second;
    }

    static constexpr int most_terms = 200;
    static constexpr std::uint64_t most_single_steps = 16;
    static constexpr std::size_t most_series = 64; // kept at a time

    // An entry of a row that is not zero; most are, as half of the rows say that a velocity is one.
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
