/// @file
/// @brief The first terms of a power series with balls for coefficients, by Arb.
#pragma once

#include <arb_poly.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "denhartog/number/ball_matrix.hpp"

namespace denhartog::reference {

/// @brief \f$ c_0 + c_1\theta + \dots \f$, as many terms as are wanted. Operands have equally many.
struct PolynomialInBalls {
    std::vector<Ball> c{}; ///< the coefficients

    /// @brief Zero. @param terms number of terms
    explicit PolynomialInBalls(slong terms = 0) : c(static_cast<std::size_t>(terms)) {}
    /// @brief A linear function. @param terms number of terms @param value at zero @param slope its slope
    PolynomialInBalls(slong terms, const Ball& value, const Ball& slope) : PolynomialInBalls(terms) {
        c[0] = value;
        if (terms > 1) c[1] = slope;
    }
    /// @brief Number of terms. @return it
    [[nodiscard]] slong terms() const { return static_cast<slong>(c.size()); }
    /// @brief Coefficients as Arb has them. @return the first one
    [[nodiscard]] arb_ptr a() { return reinterpret_cast<arb_ptr>(c.data()); }
    /// @brief Coefficients as Arb has them. @return the first one
    [[nodiscard]] arb_srcptr a() const { return reinterpret_cast<arb_srcptr>(c.data()); }

    /// @brief Difference. @param x a function @param y what is taken from it @return x - y
    friend PolynomialInBalls operator-(PolynomialInBalls x, const PolynomialInBalls& y) {
        for (std::size_t n = 0; n < x.c.size(); ++n) x.c[n] -= y.c[n];
        return x;
    }
    /// @brief Multiple. @param s a factor @param x a function @return s x
    friend PolynomialInBalls operator*(const Ball& s, PolynomialInBalls x) {
        for (Ball& each : x.c) each *= s;
        return x;
    }
    /// @brief Product. @param x a factor @param y a factor @return the first terms of x y
    friend PolynomialInBalls operator*(const PolynomialInBalls& x, const PolynomialInBalls& y) {
        PolynomialInBalls r(x.terms());
        _arb_poly_mullow(r.a(), x.a(), x.terms(), y.a(), x.terms(), x.terms(), ball_bits);
        return r;
    }
    /// @brief Quotient. @param x a function @param y a function @return the first terms of x / y
    friend PolynomialInBalls operator/(const PolynomialInBalls& x, const PolynomialInBalls& y) {
        PolynomialInBalls r(x.terms());
        _arb_poly_div_series(r.a(), x.a(), x.terms(), y.a(), x.terms(), x.terms(), ball_bits);
        return r;
    }
};

/// @brief Sine and cosine. @param x radians @return the first terms of both
[[nodiscard]] inline std::pair<PolynomialInBalls, PolynomialInBalls> sine_and_cosine(const PolynomialInBalls& x) {
    std::pair both(PolynomialInBalls(x.terms()), PolynomialInBalls(x.terms()));
    _arb_poly_sin_cos_series(both.first.a(), both.second.a(), x.a(), std::min<slong>(x.terms(), 2), x.terms(), ball_bits);
    return both;
}

/// @brief The range of a function over a stretch. @param f its terms in the middle, the last one over the whole stretch
/// @param off  the stretch less its middle
/// @return     its values
[[nodiscard]] inline Ball range_of(const PolynomialInBalls& f, const Ball& off) {
    Ball value = f.c.back();
    for (std::size_t n = f.c.size() - 1; n-- > 0;) value = value * off + f.c[n];
    return value;
}

} // namespace denhartog::reference
