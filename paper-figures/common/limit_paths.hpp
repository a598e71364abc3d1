/// @file
/// @brief Paths to the ends of the domain of (23), (28), (29), with what the derivation has for the limits along them, and the
/// digits that the paper's forms and those that callers get keep on the way.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "denhartog/formulas/mode_limits.hpp"
#include "kept_digits.hpp"

namespace denhartog::figures {

/// @brief R and zeta.
struct PathPoint {
    Real400 R;    ///< modal frequency ratio
    Real400 zeta; ///< modal damping ratio
};

/// @brief A path to an end of the domain: x falls to zero.
struct LimitPath {
    std::string words;                                       ///< the path
    Three<std::string> limits;                               ///< what |v|, u, g tend to, for the reader
    std::function<PathPoint(const Real400& x)> at;           ///< where it is at x
    std::function<Three<Real400>(const Real400& x)> leading; ///< leading terms of |v|, u, g at x
    double last = -100;                                      ///< power of ten of x where it ends
};

namespace limit_paths {

/// @brief Values of leading terms. @param terms the terms @param x small quantity @return |v|, u, g
[[nodiscard]] inline Three<Real400> values(const limits::ModeTerms<Real400>& terms, const Real400& x) {
    const auto value = [&x](const limits::Term<Real400>& t) { return Real400(t.coefficient * pow(x, t.power)); };
    return {Real400(sqrt(value(terms.squared_v))), value(terms.u), value(terms.g)};
}

/// @brief A path with leading terms that do not depend on x.
[[nodiscard]] inline LimitPath path(std::string words, Three<std::string> to, std::function<PathPoint(const Real400&)> at,
                                    const limits::ModeTerms<Real400>& terms) {
    return {std::move(words), std::move(to), std::move(at), [terms](const Real400& x) { return values(terms, x); }};
}

/// @brief zeta = c |R - 1|^(b/a).
[[nodiscard]] inline LimitPath to_resonance(std::string words, Three<std::string> to, int a, int b, int side, int c) {
    return path(
        std::move(words), std::move(to),
        [=](const Real400& x) {
            return PathPoint{Real400(1 + side * pow(x, a)), Real400(c * pow(x, b))};
        },
        limits::to_resonance(a, b, side, Real400(c)));
}

} // namespace limit_paths

/// @brief The paths of the chart. @return in the order of its rows
[[nodiscard]] inline std::vector<LimitPath> limit_paths_of_modes() {
    using limit_paths::path, limit_paths::to_resonance;
    const Real400 three_quarters = Real400(3) / 4, tenth = Real400(1) / 10, one(1);
    const auto harmonic = [](int n, int side) {
        return [=](const Real400& x) { return PathPoint{Real400((1 + side * x) / n), x}; };
    };
    std::vector<LimitPath> paths{
        path(
            "ζ = x → 0, R = 3/4", {"1/(1−R²)", "tan(π/2R)/R", "(θ−sin θ)x/(1+cos θ)"},
            [=](const Real400& x) {
                return PathPoint{three_quarters, x};
            },
            limits::without_damping(three_quarters)),
        path(
            "ζ = x → 0, R = 1", {"1/(2x)", "1/π", "2/(πx)"},
            [](const Real400& x) {
                return PathPoint{1, x};
            },
            limits::at_harmonic<Real400>(1)),
        path(
            "ζ = x → 0, R = 1/2", {"4/3", "−πx²", "πx"},
            [](const Real400& x) {
                return PathPoint{Real400(1) / 2, x};
            },
            limits::at_harmonic<Real400>(2)),
        path(
            "R = 1 + x → 1, ζ = 0.1", {"1/(2ζ)", "(28) at 1", "(29) at 1"},
            [=](const Real400& x) {
                return PathPoint{Real400(1 + x), tenth};
            },
            limits::at_resonance(tenth)),
        path(
            "R = 1 − x → 1, ζ = 0.1", {"1/(2ζ)", "(28) at 1", "(29) at 1"},
            [=](const Real400& x) {
                return PathPoint{Real400(1 - x), tenth};
            },
            limits::at_resonance(tenth)),
        to_resonance("R = 1 + x⁴, ζ = x", {"1/(2x)", "1/π", "2/(πx)"}, 4, 1, 1, 1),
        to_resonance("R = 1 + x², ζ = x", {"1/(2x)", "3/π", "2/(πx)"}, 2, 1, 1, 1),
        to_resonance("R = 1 − x², ζ = x", {"1/(2x)", "−1/π", "2/(πx)"}, 2, 1, -1, 1),
        to_resonance("R = 1 + x², ζ = 3x", {"1/(6x)", "11/(9π)", "2/(3πx)"}, 2, 1, 1, 3),
        to_resonance("R = 1 + x, ζ = x", {"1/(√8x)", "1/(πx)", "1/(πx)"}, 1, 1, 1, 1),
        to_resonance("R = 1 − x, ζ = x", {"1/(√8x)", "−1/(πx)", "1/(πx)"}, 1, 1, -1, 1),
        to_resonance("R = 1 + x, ζ = 3x", {"1/(√40x)", "1/(5πx)", "3/(5πx)"}, 1, 1, 1, 3),
        to_resonance("R = 1 + x, ζ = x²", {"1/(2x)", "2/(πx)", "2/π"}, 1, 2, 1, 1),
        to_resonance("R = 1 + x, ζ = 3x²", {"1/(2x)", "2/(πx)", "6/π"}, 1, 2, 1, 3),
        to_resonance("R = 1 + x, ζ = x³", {"1/(2x)", "2/(πx)", "2x/π"}, 1, 3, 1, 1),
        path("R = (1+x)/3, ζ = x", {"9/8", "1/(πx)", "1/(3πx)"}, harmonic(3, 1), limits::to_harmonic(3, 1, one)),
        path("R = (1−x)/5, ζ = x", {"25/24", "−1/(πx)", "1/(5πx)"}, harmonic(5, -1), limits::to_harmonic(5, -1, one)),
        path("R = (1+x)/2, ζ = x", {"4/3", "−2πx", "πx"}, harmonic(2, 1), limits::to_harmonic(2, 1, one)),
        path("R = (1−x)/4, ζ = x", {"16/15", "8πx", "2πx"}, harmonic(4, -1), limits::to_harmonic(4, -1, one)),
        path(
            "R = 1/x → ∞, ζ = 0.1", {"x²", "πx²/2", "π³ζx³/12"},
            [=](const Real400& x) {
                return PathPoint{1 / x, tenth};
            },
            limits::at_high_frequency(tenth)),
        path(
            "ζ = 1 − x → 1, R = 3/4", {"1/(1+R²)", "q/[R(cosh q+1)]", "(sinh q−q)/(cosh q+1)"},
            [=](const Real400& x) {
                return PathPoint{three_quarters, Real400(1 - x)};
            },
            limits::at_critical_damping(three_quarters))};
    paths.push_back({"R = x → 0, ζ = 0.1",
                     {"1", "2exp(−δ)sin θ/(Rw)", "1"},
                     [=](const Real400& x) {
                         return PathPoint{x, tenth};
                     },
                     [=](const Real400& x) {
                         return Three<Real400>{Real400(1), limits::first_function_at_low_frequency(x, tenth), Real400(1)};
                     },
                     -8});
    return paths;
}

/// @brief Fewest digits along a path.
struct Kept {
    double digits = INFINITY;        ///< infinite where the function is nowhere in the range of the number type
    double of_attainable = INFINITY; ///< the same, with those given back that the condition number in zeta costs
    double R = 0, zeta = 0;          ///< where the latter is least
};

/// @brief Relative changes of v, u, g for a relative change of zeta, 1 at least.
[[nodiscard]] inline Three<double> conditions_in_zeta(const Real400& R, const Real400& zeta) {
    const Real400 h = ldexp(Real400(1), -500);
    const Three<Complex<Real400>> here = printed_functions(R, zeta), beside = printed_functions(R, Real400(zeta * (1 - h)));
    Three<double> found{};
    for (std::size_t n = 0; n < found.size(); ++n)
        found[n] =
            std::max(1.0, static_cast<double>(Real400(modulus(beside[n] + Real400(-1) * here[n]) / (h * modulus(here[n])))));
    return found;
}

/// @brief What is left along a path in a number type.
struct KeptAlongPath {
    Three<Kept> printed, shipped; ///< of v, u, g
};

/// @brief Digits in a number type along a path, from x = 0.1 down to where the point rounds to the end of the path.
///
/// R and zeta are rounded to the type, and the truth is the paper's form in 400 digits there; values beyond the range of the
/// type are left out.
/// @param path  the path
/// @param step  decades from point to point
/// @return      the fewest digits
template <class T>
[[nodiscard]] KeptAlongPath follow(const LimitPath& path, double step) {
    const PathPoint end = path.at(Real400(0));
    KeptAlongPath kept;
    for (double exponent = -1; exponent > path.last - 0.01; exponent -= step) {
        const Real400 x = pow(Real400(10), Real400(exponent));
        const PathPoint p = path.at(x);
        const T R = static_cast<T>(p.R), zeta = static_cast<T>(p.zeta);
        if ((p.R != end.R && R == static_cast<T>(end.R)) || (p.zeta != end.zeta && zeta == static_cast<T>(end.zeta))) break;
        const Three<Complex<Real400>> truth = printed_functions(Real400(R), Real400(zeta));
        const Three<Complex<T>> printed = printed_functions(R, zeta), shipped = shipped_functions(R, zeta);
        for (std::size_t n = 0; n < truth.size(); ++n) {
            const Real400 size = modulus(truth[n]);
            if (size < Real400((std::numeric_limits<T>::min)()) || size > Real400((std::numeric_limits<T>::max)())) continue;
            kept.printed[n].digits = std::min(kept.printed[n].digits, digits_kept(printed[n], truth[n]));
            const double digits = digits_kept(shipped[n], truth[n]);
            kept.shipped[n].digits = std::min(kept.shipped[n].digits, digits);
            const bool few = digits < digits_of_type<T>() - 1;
            const double cost = few ? std::log10(conditions_in_zeta(Real400(R), Real400(zeta))[n]) : 0;
            if (digits + cost < kept.shipped[n].of_attainable) {
                kept.shipped[n].of_attainable = digits + cost;
                kept.shipped[n].R = static_cast<double>(R), kept.shipped[n].zeta = static_cast<double>(zeta);
            }
        }
    }
    return kept;
}

/// @brief How far the paper's forms in 400 digits are from the leading terms at x, relative.
/// @param path  the path
/// @param x     the small quantity
/// @param term  the leading terms of |v|, u, g there
/// @return      of |v|, u, g
[[nodiscard]] inline Three<double> off_leading_terms(const LimitPath& path, const Real400& x, const Three<Real400>& term) {
    const PathPoint p = path.at(x);
    const Three<Complex<Real400>> truth = printed_functions(p.R, p.zeta);
    Three<double> off{};
    for (std::size_t n = 0; n < off.size(); ++n) {
        const Real400 value = n == 0 ? modulus(truth[n]) : truth[n].re;
        off[n] = static_cast<double>(Real400(abs(Real400(value / term[n] - 1))));
    }
    return off;
}

} // namespace denhartog::figures
