// A state carried in time by the exponentials of its system, for damping that couples the modes: a power series over a short
// step, doubled to long ones. Read `CoupledMotion::at` and `series_after` first, then `leap`.
#include "denhartog/model/coupled_motion.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/model/detail/product_of_doubles.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog {
namespace {

constexpr int most_terms = 200;
constexpr std::uint64_t most_single_steps = 16; // without the exponentials, which are dear
constexpr int parts_of_a_step = 16;             // for many starts
constexpr std::size_t most_series = 64;         // kept at a time

// So many doublings of a step that is not longer than one over the rate make half a period.
std::size_t doublings_in_half_period(double rate) {
    const double steps = static_cast<double>(pi<double>() * rate);
    return steps > 1 && std::isfinite(steps) ? static_cast<std::size_t>(std::ilogb(steps)) + 1 : 0;
}

} // namespace

CoupledMotion::CoupledMotion(const Matrix<double>& A, double rate, Asked asked, Effort* const* effort)
    : doublings_(doublings_in_half_period(rate)),
      rate_(asked == Asked::many_starts ? parts_of_a_step * rate : ldexp(1.0, static_cast<int>(doublings_)) / pi<double>()),
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

void CoupledMotion::start(const Column& z) {
    state_ = z;
    known_ = 0;
}

Column CoupledMotion::rates(const Column& z) const {
    Column rates(z.size());
    for (std::size_t row = 0, entry = 0; row < ends_.size(); ++row) {
        double sum(0);
        for (; entry < ends_[row]; ++entry) sum += entries_[entry] * z(columns_[entry]);
        rates(static_cast<Eigen::Index>(row)) = sum;
    }
    return rates;
}

const Column& CoupledMotion::at(double t) {
    if (t == 0) return state_;
    if (const std::optional<std::uint64_t> n = steps_in(t))
        sum_up(series_after(*n), part_after(*n, t));
    else
        now_ = state_ * std::numeric_limits<double>::quiet_NaN();
    return now_;
}

Matrix<double> CoupledMotion::carried(double t, Matrix<double> z) {
    const std::optional<std::uint64_t> n = steps_in(t);
    if (!n) return z * std::numeric_limits<double>::quiet_NaN();
    leap_over(*n, z.data(), z.cols());
    const double s = part_after(*n, t) / rate_;
    std::vector<double> scaled = entries_;
    for (double& entry : scaled) entry *= s;
    return z + growth(scaled, z);
}

// So many products of two numbers are to be formed.
void CoupledMotion::spend_products(Eigen::Index count) const {
    if (effort_ != nullptr) pay(*effort_, cost_of_products(static_cast<long>(count)));
}

// Forms a term of a series from the one before, a factor times its product with the matrix that has the given entries in the
// places of A's, and adds it. True if the sum changes.
bool CoupledMotion::add_term(const double* entry, double factor, const double* before, double* term, double* sum) const {
    bool changes = false;
    const Eigen::Index* column = columns_.data();
    const double* const first = entry;
    for (std::size_t row = 0; row < ends_.size(); ++row) {
        double each(0);
        for (const double* const end = first + ends_[row]; entry != end; ++entry, ++column) each += *entry * before[*column];
        term[row] = each * factor;
        const double next = sum[row] + term[row];
        changes |= next != sum[row];
        sum[row] = next;
    }
    return changes;
}

// exp(B) z - z by its series, where B has the given entries in the places of A's. No entry of B is much larger than 1 once its
// rows are scaled.
Matrix<double> CoupledMotion::growth(const std::vector<double>& entries, Matrix<double> z) const {
    Matrix<double> sum = Matrix<double>::Zero(z.rows(), z.cols()), next(z.rows(), z.cols());
    bool grows = true;
    for (int k = 1; grows && k <= most_terms; ++k) {
        spend_products(static_cast<Eigen::Index>(entries_.size()) * z.cols());
        const double inverse = 1.0 / k;
        grows = false;
        for (Eigen::Index column = 0; column < z.cols(); ++column)
            grows |= add_term(entries.data(), inverse, z.col(column).data(), next.col(column).data(), sum.col(column).data());
        z.swap(next);
    }
    return sum;
}

// From exp(B) less the identity the same of 2 B.
Matrix<double> CoupledMotion::doubled(const Matrix<double>& grown) const {
    spend_products(rows() * rows() * rows());
    return product(grown, grown) + 2.0 * grown;
}

// exp(A 2^k / rate) less the identity. The first is that of half a step, whose series has fewer terms, doubled.
const Matrix<double>& CoupledMotion::leap(std::size_t k) {
    if (leaps_.empty()) {
        std::vector<double> half = entries_;
        for (double& entry : half) entry /= 2 * rate_;
        leaps_.push_back(doubled(growth(half, Matrix<double>::Identity(rows(), rows()))));
    }
    while (leaps_.size() <= k) leaps_.push_back(doubled(leaps_.back()));
    return leaps_[k];
}

// Whole steps in a time; none where nothing is left of the time's digits.
std::optional<std::uint64_t> CoupledMotion::steps_in(double t) const {
    const double steps = std::floor(static_cast<double>(t * rate_));
    if (!(steps < 0x1p53)) return std::nullopt;
    return static_cast<std::uint64_t>(steps);
}

// The rest of a time after n steps, as a part of a step.
double CoupledMotion::part_after(std::uint64_t n, double t) const { return (t - static_cast<double>(n) / rate_) * rate_; }

// Carries columns over n steps.
void CoupledMotion::leap_over(std::uint64_t n, double* z, Eigen::Index columns) {
    leapt_.resize(static_cast<std::size_t>(rows() * columns));
    for (std::size_t k = 0; n >> k != 0; ++k) {
        if ((n >> k & 1) == 0) continue;
        product_of_doubles({leap(k).data(), rows(), rows(), rows()}, {z, rows(), columns, rows()}, leapt_.data());
        for (std::size_t i = 0; i < leapt_.size(); ++i) z[i] += leapt_[i];
    }
}

// The state in a part of a step by its series.
void CoupledMotion::sum_up(const PowerSeries& series, double s) {
    now_.resize(rows());
    for (Eigen::Index i = 0; i < rows(); ++i) {
        double sum = series.terms(i, series.count - 1);
        for (Eigen::Index k = series.count - 2; k >= 0; --k) sum = series.terms(i, k) + s * sum;
        now_(i) = sum;
    }
}

// The terms of exp(A s / rate) for s up to 1 and the state now, a column each, as many as s = 1 needs.
void CoupledMotion::form_terms(PowerSeries& series) {
    constexpr Eigen::Index first_room = 32;
    Matrix<double>& terms = series.terms;
    if (terms.size() == 0) terms.resize(rows(), first_room);
    terms.col(0) = now_;
    sum_.assign(now_.begin(), now_.end());
    series.count = 1;
    for (bool grows = true; grows && series.count <= most_terms; ++series.count) {
        const Eigen::Index k = series.count;
        if (k == terms.cols()) terms.conservativeResize(Eigen::NoChange, 2 * k);
        const double inverse = 1 / (static_cast<int>(k) * rate_);
        grows = add_term(entries_.data(), inverse, terms.col(k - 1).data(), terms.col(k).data(), sum_.data());
    }
}

// The series over the step after n of them.
const PowerSeries& CoupledMotion::series_after(std::uint64_t n) {
    for (std::size_t k = known_; k-- > 0;)
        if (series_[k].step == n) return series_[k];
    if (known_ >= most_series) known_ = 0;
    if (n == 0 || n > single_steps_) {
        now_ = state_;
        leap_over(n, now_.data(), 1);
    } else {
        sum_up(series_after(n - 1), 1.0);
    }
    if (known_ == series_.size()) series_.emplace_back();
    PowerSeries& series = series_[known_++];
    series.step = n;
    form_terms(series);
    return series;
}

} // namespace denhartog
