#include "denhartog/model/coupled_motion.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog {
namespace {

constexpr int most_terms = 200;
constexpr std::uint64_t most_single_steps = 16; // without the exponentials, which are dear
constexpr int parts_of_a_step = 16;             // for many starts
constexpr std::size_t most_series = 64;         // kept at a time

// So many doublings of a step that is not longer than one over the rate make half a period.
template <class T>
std::size_t doublings_in_half_period(const T& rate) {
    const double steps = static_cast<double>(T(pi<T>() * rate));
    return steps > 1 && std::isfinite(steps) ? static_cast<std::size_t>(std::ilogb(steps)) + 1 : 0;
}

template <class T>
Column<T> sum_of(const PowerSeries<T>& series, const T& s) {
    Column<T> sum = series.terms.col(series.count - 1);
    for (Eigen::Index k = series.count - 2; k >= 0; --k) {
        const T* const term = series.terms.col(k).data();
        for (Eigen::Index i = 0; i < sum.size(); ++i) sum(i) = term[i] + s * sum(i);
    }
    return sum;
}

} // namespace

template <class T>
CoupledMotion<T>::CoupledMotion(const Matrix<T>& A, const T& rate, Asked asked, Effort* const* effort)
    : doublings_(doublings_in_half_period(rate)),
      rate_(asked == Asked::many_starts ? T(parts_of_a_step * rate) : T(ldexp(T(1), static_cast<int>(doublings_)) / pi<T>())),
      single_steps_(asked == Asked::many_starts ? 0 : most_single_steps), effort_(effort) {
    for (Eigen::Index row = 0; row < A.rows(); ++row) {
        for (Eigen::Index column = 0; column < A.cols(); ++column)
            if (A(row, column) != 0) {
                entries_.push_back(A(row, column));
                columns_.push_back(column);
            }
        ends_.push_back(entries_.size());
    }
}

template <class T>
void CoupledMotion<T>::start(Column<T> z) {
    state_ = std::move(z);
    series_.clear();
}

template <class T>
Column<T> CoupledMotion<T>::rates(const Column<T>& z) const {
    Column<T> rates(z.size());
    for (std::size_t row = 0, entry = 0; row < ends_.size(); ++row) {
        T sum(0);
        for (; entry < ends_[row]; ++entry) sum += entries_[entry] * z(columns_[entry]);
        rates(static_cast<Eigen::Index>(row)) = sum;
    }
    return rates;
}

template <class T>
Column<T> CoupledMotion<T>::at(const T& t) {
    const std::optional<std::uint64_t> n = steps_in(t);
    if (!n) return state_ * std::numeric_limits<T>::quiet_NaN();
    return sum_of(series_after(*n), part_after(*n, t));
}

template <class T>
Matrix<T> CoupledMotion<T>::carried(const T& t, Matrix<T> z) {
    const std::optional<std::uint64_t> n = steps_in(t);
    if (!n) return z * std::numeric_limits<T>::quiet_NaN();
    leap_over(*n, z);
    const T s = part_after(*n, t) / rate_;
    std::vector<T> scaled = entries_;
    for (T& entry : scaled) entry *= s;
    return z + growth(scaled, z);
}

// So many products of two numbers are to be formed.
template <class T>
void CoupledMotion<T>::spend_products(Eigen::Index count) const {
    if (effort_ == nullptr) return QuestionEffort::pay_for_products(static_cast<long>(count));
    (*effort_)->spend(cost_of_products(static_cast<long>(count)));
    if ((*effort_)->exhausted()) throw PrecisionError((*effort_)->ending());
}

// Forms a term of a series from the one before, a factor times its product with the matrix that has the given entries in the
// places of A's, and adds it. Whether the sum changes.
template <class T>
bool CoupledMotion<T>::add_term(const std::vector<T>& entries, const T& factor, const T* before, T* term, T* sum) const {
    bool changes = false;
    for (std::size_t row = 0, entry = 0; row < ends_.size(); ++row) {
        T each(0);
        for (; entry < ends_[row]; ++entry) each += entries[entry] * before[columns_[entry]];
        term[row] = each * factor;
        const T next = sum[row] + term[row];
        changes = changes || next != sum[row];
        sum[row] = next;
    }
    return changes;
}

// exp(B) z - z by its series, where B has the given entries in the places of A's. No entry of B is much larger than 1 once its
// rows are scaled.
template <class T>
Matrix<T> CoupledMotion<T>::growth(const std::vector<T>& entries, Matrix<T> z) const {
    Matrix<T> sum = Matrix<T>::Zero(z.rows(), z.cols()), next(z.rows(), z.cols());
    bool grows = true;
    for (int k = 1; grows && k <= most_terms; ++k) {
        spend_products(static_cast<Eigen::Index>(entries_.size()) * z.cols());
        const T inverse = 1 / T(k);
        grows = false;
        for (Eigen::Index column = 0; column < z.cols(); ++column)
            grows |= add_term(entries, inverse, z.col(column).data(), next.col(column).data(), sum.col(column).data());
        z.swap(next);
    }
    return sum;
}

// From exp(B) less the identity the same of 2 B.
template <class T>
Matrix<T> CoupledMotion<T>::doubled(const Matrix<T>& grown) const {
    spend_products(rows() * rows() * rows());
    return product(grown, grown) + T(2) * grown;
}

// exp(A 2^k / rate) less the identity. The first is doubled up from a part of the step, whose series has fewer terms.
template <class T>
const Matrix<T>& CoupledMotion<T>::leap(std::size_t k) {
    constexpr int doublings = std::numeric_limits<T>::digits / 32;
    if (leaps_.empty()) {
        std::vector<T> part = entries_;
        for (T& entry : part) entry /= T(rate_ * (1 << doublings));
        Matrix<T> grown = growth(part, Matrix<T>::Identity(rows(), rows()));
        for (int n = 0; n < doublings; ++n) grown = doubled(grown);
        leaps_.push_back(std::move(grown));
    }
    while (leaps_.size() <= k) leaps_.push_back(doubled(leaps_.back()));
    return leaps_[k];
}

// Whole steps in a time; none where nothing is left of the time's digits.
template <class T>
std::optional<std::uint64_t> CoupledMotion<T>::steps_in(const T& t) const {
    const double steps = std::floor(static_cast<double>(T(t * rate_)));
    if (!(steps < 0x1p53)) return std::nullopt;
    return static_cast<std::uint64_t>(steps);
}

// What is left of a time after n steps, as a part of a step.
template <class T>
T CoupledMotion<T>::part_after(std::uint64_t n, const T& t) const {
    return (t - T(static_cast<double>(n)) / rate_) * rate_;
}

template <class T>
template <class Numbers>
void CoupledMotion<T>::leap_over(std::uint64_t n, Numbers& z) {
    for (std::size_t k = 0; n >> k != 0; ++k)
        if ((n >> k & 1) != 0) z += product(leap(k), z);
}

// The terms of exp(A s / rate) z for s up to 1, a column each, as many as s = 1 needs.
template <class T>
PowerSeries<T> CoupledMotion<T>::terms_from(const Column<T>& z) const {
    constexpr Eigen::Index first_room = 32;
    Matrix<T> terms(z.size(), first_room);
    terms.col(0) = z;
    Column<T> sum = z;
    Eigen::Index k = 1;
    for (bool grows = true; grows && k <= most_terms; ++k) {
        if (k == terms.cols()) terms.conservativeResize(Eigen::NoChange, 2 * k);
        const T inverse = 1 / (static_cast<int>(k) * rate_);
        grows = add_term(entries_, inverse, terms.col(k - 1).data(), terms.col(k).data(), sum.data());
    }
    return {std::move(terms), k};
}

// The series over the step after n of them.
template <class T>
const PowerSeries<T>& CoupledMotion<T>::series_after(std::uint64_t n) {
    const auto known = series_.find(n);
    if (known != series_.end()) return known->second;
    if (series_.size() >= most_series) series_.clear();
    if (n == 0 || n > single_steps_) {
        Column<T> z = state_;
        leap_over(n, z);
        return series_.emplace(n, terms_from(z)).first->second;
    }
    const Column<T> z = sum_of(series_after(n - 1), T(1));
    return series_.emplace(n, terms_from(z)).first->second;
}

template class CoupledMotion<double>;

} // namespace denhartog
