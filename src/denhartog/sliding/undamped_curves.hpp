/// @file
/// @brief The undamped response functions V and U of a mass between their poles, with bounds. Included by source files only.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "denhartog/evaluation/special.hpp"
#include "denhartog/sliding/invariant_points.hpp"
#include "denhartog/sliding/range_series.hpp"

namespace denhartog {

/// @brief Undamped response functions over x = 1/r, as weights of the modes: V of (33), U of (34).
template <class T>
struct Weights {
    std::vector<T> V_j; ///< of V of the mass in contact
    std::vector<T> V_k; ///< of V of the mass
    std::vector<T> U_j; ///< of U of the mass in contact
    std::vector<T> U_k; ///< of U of the mass
};

/// @brief A pole of a mode.
template <class T>
struct Pole {
    T x;               ///< 1/r there
    std::size_t mode;  ///< the mode
    bool of_V;         ///< whether V has it, as at the resonance
    bool of_U;         ///< whether U has it
    bool alone = true; ///< whether no other mode has one there
};

/// @brief A part of the stretch between two poles.
template <class T>
struct Part {
    T a;                   ///< its left end
    T b;                   ///< its right end
    const Pole<T>* pole_a; ///< the pole at a; null where there is none
    const Pole<T>* pole_b; ///< the pole at b; null where there is none
};

/// @brief The factor that takes a pole away: 1 / v and 1 / u of one mode, 1 where there is no pole.
struct Factor {
    std::size_t mode = 0; ///< the mode
    bool of_V = false;    ///< whether 1 / v is in it
    bool of_U = false;    ///< whether 1 / u is in it
};

/// @brief The function whose zeros are the invariant points of a mass: V_j U_k - 2 V_k U_j, or U_k, over x = 1/r.
template <class T>
class TransmissibilityFunction {
public:
    /// @param r_n      natural frequency ratios; must outlive the function
    /// @param weights  weights of the modes; must outlive the function
    /// @param kind     which function
    TransmissibilityFunction(const std::vector<T>& r_n, const Weights<T>& weights, InvariantPointKind kind)
        : r_n_(r_n), w_(weights), kind_(kind) {}

    /// @brief Bounds over [a, b] times the factor. @param a lower end @param b upper end @param factor the factor @return bounds
    [[nodiscard]] RangeWithRate<T> over(const T& a, const T& b, const Factor& factor) const {
        const T half = (b - a) / 2, middle = a + half;
        return over_interval(series(middle, middle, factor), series(a, b, factor), half, rounding());
    }

    /// @return what sums may be off by, as a part of the sizes of their terms
    [[nodiscard]] T rounding() const { return 16 * static_cast<int>(r_n_.size()) * std::numeric_limits<T>::epsilon(); }

    /// @return operations that bounds over an interval cost, with the signs at its ends
    [[nodiscard]] long cost() const { return 32 * static_cast<long>(r_n_.size()); }

    /// @brief The value at x times the factor. @param x 1/r @param factor the factor @return the value
    [[nodiscard]] T at(const T& x, const Factor& factor) const { return series(x, x, factor).coefficient[0].low; }

    /// @brief The sign at x. @param x 1/r @param factor the factor @return 1 or -1, 0 where rounding hides it
    [[nodiscard]] int sign(const T& x, const Factor& factor) const {
        const RangeSeries<T> f = series(x, x, factor);
        return certain_sign(f.coefficient[0], T(rounding() * f.size[0]));
    }

    /// @brief Whether V_j or U_k vanishes: (87) divides by them. @param x 1/r @return true where one has no digit
    [[nodiscard]] bool divides_by_zero(const T& x) const {
        for (const auto& [weights, term] :
             {std::pair(&w_.V_j, &TransmissibilityFunction::v), std::pair(&w_.U_k, &TransmissibilityFunction::u)}) {
            const RangeSeries<T> f = sum(*weights, x, x, {}, term);
            if (certain_sign(f.coefficient[0], T(64 * rounding() * f.size[0])) == 0) return true;
        }
        return false;
    }

    /// @brief Poles between two values of x. @param from least x @param to largest x @return the poles, ascending
    [[nodiscard]] std::vector<Pole<T>> poles(const T& from, const T& to) const {
        const bool both = kind_ == InvariantPointKind::two_effects_cancel;
        std::vector<Pole<T>> found;
        for (std::size_t i = 0; i < r_n_.size(); ++i) {
            const bool of_V = both && (w_.V_j[i] != 0 || w_.V_k[i] != 0), of_U = both ? w_.U_j[i] != 0 : w_.U_k[i] != 0;
            for (int n = 1; n / r_n_[i] <= to; n += 2) {
                const T x = n / r_n_[i];
                if (x >= from && ((n == 1 && of_V) || of_U)) found.push_back({x, i, n == 1 && of_V, of_U});
            }
        }
        std::sort(found.begin(), found.end(), [](const Pole<T>& p, const Pole<T>& q) { return p.x < q.x; });
        for (std::size_t n = 1; n < found.size(); ++n)
            if (found[n].x - found[n - 1].x <= 64 * rounding() * found[n].x) found[n].alone = found[n - 1].alone = false;
        return found;
    }

    /// @brief The factor that makes the function bounded over a part. @param part the part @return the factor, where there is one
    [[nodiscard]] std::optional<Factor> factor(const Part<T>& part) const {
        const Pole<T>* pole = part.pole_a != nullptr ? part.pole_a : part.pole_b;
        if (pole == nullptr) return Factor{};
        if ((part.pole_a != nullptr && part.pole_b != nullptr) || !pole->alone) return std::nullopt;
        const T& r_n = r_n_[pole->mode];
        using std::floor;
        if (pole->of_U && floor(T(r_n * part.a / 2)) != floor(T(r_n * part.b / 2))) return std::nullopt; // u has a zero inside
        return Factor{pole->mode, pole->of_V, pole->of_U};
    }

private:
    using Term = RangeSeries<T> (TransmissibilityFunction::*)(std::size_t, const T&, const T&, const Factor&) const;

    [[nodiscard]] RangeSeries<T> series(const T& a, const T& b, const Factor& factor) const {
        const RangeSeries<T> U_k = sum(w_.U_k, a, b, factor, &TransmissibilityFunction::u);
        if (kind_ == InvariantPointKind::friction_leaves_it_alone) return U_k;
        const RangeSeries<T> V_j = sum(w_.V_j, a, b, factor, &TransmissibilityFunction::v);
        const RangeSeries<T> V_k = sum(w_.V_k, a, b, factor, &TransmissibilityFunction::v);
        const RangeSeries<T> U_j = sum(w_.U_j, a, b, factor, &TransmissibilityFunction::u);
        return V_j * U_k + T(-2) * (V_k * U_j);
    }

    [[nodiscard]] RangeSeries<T> sum(const std::vector<T>& weights, const T& a, const T& b, const Factor& factor,
                                     Term term) const {
        RangeSeries<T> total = constant_series(T(0));
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (weights[i] != 0) total = total + weights[i] * (this->*term)(i, a, b, factor);
        return total;
    }

    static Range<T> between(const T& a, const T& b) { return {std::min(a, b), std::max(a, b)}; }

    /// v_i = 1 / (r_n^2 - 1/x^2) falls between its poles; its n-th Taylor coefficient is
    /// (-r_n)^n / (2 r_n^2) [(r_n x - 1)^(-n - 1) - (r_n x + 1)^(-n - 1)]. The factor is r_n^2 - 1/x^2.
    [[nodiscard]] RangeSeries<T> v(std::size_t i, const T& a, const T& b, const Factor& factor) const {
        const auto inverse = [](const T& r_n, const T& x) { return T((r_n - 1 / x) * (r_n + 1 / x)); };
        if (factor.of_V && factor.mode == i) return constant_series(T(1));
        const T& r_n = r_n_[i];
        RangeSeries<T> term;
        T near_a = 1 / (r_n * a - 1), near_b = 1 / (r_n * b - 1), far_a = 1 / (r_n * a + 1), far_b = 1 / (r_n * b + 1);
        T near_a_n = near_a, near_b_n = near_b, far_a_n = far_a, far_b_n = far_b, power = 1 / (2 * r_n * r_n);
        for (std::size_t n = 0; n <= term.order; ++n) {
            const Range<T> near = between(near_a_n, near_b_n), far = between(far_a_n, far_b_n);
            term.coefficient[n] = Range<T>{power, power} * Range<T>{near.low - far.high, near.high - far.low};
            term.size[n] = size_of(Range<T>{power, power}) * (size_of(near) + size_of(far));
            near_a_n *= near_a;
            near_b_n *= near_b;
            far_a_n *= far_a;
            far_b_n *= far_b;
            power *= -r_n;
        }
        term.coefficient[0] = {1 / inverse(r_n, b), 1 / inverse(r_n, a)};
        term.size[0] = size_of(term.coefficient[0]);
        if (!factor.of_V) return term;
        const T& r_p = r_n_[factor.mode];
        T power_a = 1 / (a * a), power_b = 1 / (b * b); // x^(-n - 2)
        return term * range_series<T>([&](std::size_t n) {
                   if (n == 0) return Range<T>{inverse(r_p, a), inverse(r_p, b)};
                   power_a /= -a;
                   power_b /= -b;
                   const int count = -static_cast<int>(n + 1);
                   return between(T(count * power_a), T(count * power_b));
               });
    }

    /// u_i = tan(pi r_n x / 2) / r_n rises between its poles. The factor is r_n cot(pi r_n x / 2).
    [[nodiscard]] RangeSeries<T> u(std::size_t i, const T& a, const T& b, const Factor& factor) const {
        const auto tangent = [](const T& y) { return T(evaluation::sin_pi(y) / evaluation::cos_pi(y)); };
        const auto cotangent = [](const T& y) { return T(evaluation::cos_pi(y) / evaluation::sin_pi(y)); };
        if (factor.of_U && factor.mode == i) return constant_series(T(1));
        const T& r_n = r_n_[i];
        const RangeSeries<T> term =
            T(1 / r_n) * tangent_series(Range<T>{tangent(T(r_n * a / 2)), tangent(T(r_n * b / 2))}, T(pi<T>() * r_n / 2));
        if (!factor.of_U) return term;
        const T& r_p = r_n_[factor.mode];
        const Range<T> cot{cotangent(T(r_p * b / 2)), cotangent(T(r_p * a / 2))};
        return term * (r_p * tangent_series(cot, T(-pi<T>() * r_p / 2)));
    }

    const std::vector<T>& r_n_;
    const Weights<T>& w_;
    InvariantPointKind kind_;
};

} // namespace denhartog
