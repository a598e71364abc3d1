/// @file
/// @brief Errors of several functions at a point, over their condition numbers, and the worst of them so far.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "tests/speed_accuracy/functions_survey.hpp"
#include "tests/speed_accuracy/mode_places.hpp"

namespace denhartog::tests {

template <std::size_t n, class Wide>
std::array<Real100, n> in_100_digits(const std::array<Wide, n>& f) {
    std::array<Real100, n> all;
    for (std::size_t i = 0; i < n; ++i) all[i] = static_cast<Real100>(f[i]);
    return all;
}

/// What a function of a number type gives in enough digits.
template <class Function>
auto in_digits(double needed, const Function& f) {
    if (needed < 100) return f(Real100());
    if (needed < 300) return f(Real300());
    if (needed < 600) return f(Real600());
    return f(Real1100());
}

/// Condition numbers, 1 at least, with respect to any argument of a function, moved by h of itself.
template <std::size_t n, class Wide, std::size_t m, class Function>
std::array<double, n> conditions(const std::array<Wide, m>& arguments, const Function& function,
                                 const Wide& h = ldexp(Wide(1), -5 * std::numeric_limits<Wide>::digits / 8)) {
    const std::array<Wide, n> f = function(arguments);
    std::array<double, n> found;
    found.fill(1);
    for (std::size_t k = 0; k < m; ++k) {
        std::array<Wide, m> other = arguments;
        other[k] *= 1 - h;
        const std::array<Wide, n> there = function(other);
        for (std::size_t i = 0; i < n; ++i)
            if (f[i] != 0) found[i] = std::max(found[i], static_cast<double>(Wide(abs(Wide((there[i] - f[i]) / (h * f[i]))))));
    }
    return found;
}

/// Condition numbers of n functions; with R taken as exact, where that counts.
template <std::size_t n>
struct ConditionNumbers {
    std::array<double, n> all, light{};
};

/// The truth at a point, by which errors are measured, and condition numbers, computed only if they are needed.
template <std::size_t n>
struct Reference {
    std::function<std::array<Real100, n>()> truth;
    std::function<ConditionNumbers<n>()> conditions;
};

/// The values of n functions at a point.
template <std::size_t n, class T>
struct SurveyedPoint {
    std::array<T, n> printed, shipped;
    std::string at;
    bool always;                  ///< compared with the paper's formulas whatever the forms in 50 digits say
    bool light = false;           ///< whether the errors count with R taken as exact too
    std::array<Real100, n> least; ///< sizes below which errors are absolute

    SurveyedPoint(const std::array<T, n>& by_print, const std::array<T, n>& as_shipped, std::string place, bool hard)
        : printed(by_print), shipped(as_shipped), at(std::move(place)), always(hard || std::is_same_v<T, Real50>) {
        least.fill(Real100((std::numeric_limits<T>::min)()));
    }
};

/// Errors of a function at a point over its condition numbers.
struct ErrorsAtPoint {
    double shipped, printed, light;
    /// True if one of them exceeds a share of the worst so far, or is no number.
    [[nodiscard]] bool is_beyond(double share, const FunctionInZone& worst) const {
        return !(shipped <= share * worst.shipped.error) || !(printed <= share * worst.printed.error) ||
               !(light <= share * worst.light.error);
    }
};

/// Hands the errors over the condition numbers of those functions whose errors may be among the worst to `take`, until that says
/// that it has seen enough. A condition number can only lessen an error: it is needed for these alone.
template <std::size_t n, class T, class Take>
void over_conditions(const FunctionInZone* errors, const SurveyedPoint<n, T>& p, const Reference<n>& by, double share,
                     const Take& take) {
    const std::array<Real100, n> truth = by.truth();
    std::optional<ConditionNumbers<n>> condition;
    for (std::size_t i = 0; i < n; ++i) {
        const double error = error_of(p.shipped[i], truth[i], p.least[i]),
                     of_print = error_of(p.printed[i], truth[i], p.least[i]);
        if (!ErrorsAtPoint{error, of_print, p.light ? error : 0}.is_beyond(share, errors[i])) continue;
        if (!condition) condition = by.conditions();
        const double with_exact_R = p.light ? error / condition->light[i] : 0;
        if (take(i, ErrorsAtPoint{error / condition->all[i], of_print / condition->all[i], with_exact_R})) return;
    }
}

/// Notes the errors of n functions at one point. The truth is that of the paper's formulas, which is slow. It is computed at
/// every point marked `always`, at one point in `always_against_the_paper`, and at points where the cheaper reference `near`
/// shows an error of more than half of the worst so far.
template <std::size_t n, class T>
void note(FunctionInZone* errors, const SurveyedPoint<n, T>& p, const Reference<n>& near, const Reference<n>& paper) {
    for (std::size_t i = 0; i < n; ++i) ++errors[i].points;
    bool is_near_worst = p.always || errors[0].points % always_against_the_paper == 0;
    if (!is_near_worst)
        over_conditions(errors, p, near, 0.5, [&](std::size_t i, const ErrorsAtPoint& e) {
            is_near_worst = e.is_beyond(0.5, errors[i]);
            return is_near_worst;
        });
    if (!is_near_worst) return;
    for (std::size_t i = 0; i < n; ++i) ++errors[i].against_the_paper;
    over_conditions(errors, p, paper, 1, [&](std::size_t i, const ErrorsAtPoint& e) {
        errors[i].shipped.note(e.shipped, p.at);
        errors[i].printed.note(e.printed, p.at);
        if (p.light) errors[i].light.note(e.light, p.at);
        return false;
    });
}

} // namespace denhartog::tests
