/// @file
/// @brief Invariant points, proved: the zeros of (87) without damping, and those of a factor that (87) divides out. Without
/// damping V and U are functions of x = 1/r; multiplied by the factors of their poles they are sums over modes of power series.
#pragma once

#include <arb_poly.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "denhartog/number/effort.hpp"
#include "denhartog/reference/modes.hpp"
#include "denhartog/sliding/invariant_points.hpp"

namespace denhartog::reference {

/// @brief \f$ c_0 + c_1\theta + \dots \f$, as many terms as are wanted. Operands have equally many.
struct PolynomialInBalls {
    std::vector<Ball> c{}; ///< the coefficients

    /// @brief Zero, with so many terms.
    explicit PolynomialInBalls(slong terms = 0) : c(static_cast<std::size_t>(terms)) {}
    /// @brief A linear function.
    PolynomialInBalls(slong terms, const Ball& value, const Ball& slope) : PolynomialInBalls(terms) {
        c[0] = value;
        if (terms > 1) c[1] = slope;
    }
    /// @brief The number of terms.
    [[nodiscard]] slong terms() const { return static_cast<slong>(c.size()); }
    /// @brief Coefficients as Arb has them.
    [[nodiscard]] arb_ptr a() { return reinterpret_cast<arb_ptr>(c.data()); }
    /// @brief The coefficients as Arb has them.
    [[nodiscard]] arb_srcptr a() const { return reinterpret_cast<arb_srcptr>(c.data()); }

    /// @brief Difference.
    friend PolynomialInBalls operator-(PolynomialInBalls x, const PolynomialInBalls& y) {
        for (std::size_t n = 0; n < x.c.size(); ++n) x.c[n] -= y.c[n];
        return x;
    }
    /// @brief A multiple.
    friend PolynomialInBalls operator*(const Ball& s, PolynomialInBalls x) {
        for (Ball& each : x.c) each *= s;
        return x;
    }
    /// @brief Product.
    friend PolynomialInBalls operator*(const PolynomialInBalls& x, const PolynomialInBalls& y) {
        PolynomialInBalls r(x.terms());
        _arb_poly_mullow(r.a(), x.a(), x.terms(), y.a(), x.terms(), x.terms(), ball_bits);
        return r;
    }
    /// @brief Quotient.
    friend PolynomialInBalls operator/(const PolynomialInBalls& x, const PolynomialInBalls& y) {
        PolynomialInBalls r(x.terms());
        _arb_poly_div_series(r.a(), x.a(), x.terms(), y.a(), x.terms(), x.terms(), ball_bits);
        return r;
    }
};

/// @brief Sine and cosine of a polynomial.
[[nodiscard]] inline std::pair<PolynomialInBalls, PolynomialInBalls> sine_and_cosine(const PolynomialInBalls& x) {
    std::pair both(PolynomialInBalls(x.terms()), PolynomialInBalls(x.terms()));
    _arb_poly_sin_cos_series(both.first.a(), both.second.a(), x.a(), std::min<slong>(x.terms(), 2), x.terms(), ball_bits);
    return both;
}

/// @brief The range of a function over a stretch, from its terms in the middle, the last one over the whole stretch.
[[nodiscard]] inline Ball range_of(const PolynomialInBalls& f, const Ball& off) {
    Ball value = f.c.back();
    for (std::size_t n = f.c.size() - 1; n-- > 0;) value = value * off + f.c[n];
    return value;
}

/// @brief Masses that hang together: no other mass is coupled to them.
using CoupledMasses = std::vector<slong>;

/// @brief The masses of a scene, part by part. One may be left out, which couples no others then.
[[nodiscard]] std::vector<CoupledMasses> coupled_masses(const SceneInBalls& s, slong held = -1);

/// @brief Products of the shapes of the modes at two rows.
struct WeightsInBalls {
    std::vector<Ball> sum{};  ///< of each mode, or of each cluster as a whole
    std::vector<Ball> open{}; ///< factor by which the radius of a cluster's function leaves its term open; zero of one mode

    /// @brief Whether they are zero and nothing else: the rows have no mode in common.
    [[nodiscard]] bool vanish() const;
};

/// @brief v and u of each mode or cluster over x. Up to a common factor, \f$ V = x^2\sum w_iv_i \f$ and \f$ U = \sum w_iu_i \f$.
struct TermsOverX {
    std::vector<PolynomialInBalls> v{}; ///< \f$ 1/(r_{n,i}^2x^2-1) \f$, times what is multiplied out of V
    std::vector<PolynomialInBalls> u{}; ///< \f$ \tan(\pi r_{n,i}x/2)/r_{n,i} \f$, times what is multiplied out of U
};

/// @brief Which modes have their poles multiplied out: \f$ r_{n,i}^2x^2-1 \f$ of V, \f$ \cos(\pi r_{n,i}x/2) \f$ of U.
struct FactorsOverX {
    std::vector<bool> of_V{}; ///< of each mode or cluster
    std::vector<bool> of_U{}; ///< of each mode or cluster
};

/// @brief A stretch of x as it was seen: the functions of the modes in its middle, over it, and at its ends.
struct SeenOverX {
    FactorsOverX factors{}; ///< what is multiplied out
    Ball off{};             ///< the stretch less its middle
    TermsOverX middle{};    ///< series about the middle
    TermsOverX over{};      ///< coefficients over the whole stretch
    TermsOverX at_a{};      ///< values at its lower end
    TermsOverX at_b{};      ///< values at its upper end
};

/// @brief The modes of parts of a system.
class UndampedModesInBalls {
public:
    /// @throws Unproved as `modes_in_balls`
    UndampedModesInBalls(const SceneInBalls& s, const std::vector<CoupledMasses>& parts);

    /// @brief Natural frequency ratios, one of each mode or cluster.
    [[nodiscard]] const std::vector<Ball>& r_n() const { return r_n_; }
    /// @brief Weights between two rows: a mass, N for the contact, N + 1 for the load.
    [[nodiscard]] WeightsInBalls weights(std::size_t a, std::size_t b) const;
    /// @brief The functions of the modes at x = 1/r or over a stretch of it.
    [[nodiscard]] TermsOverX terms(const Ball& x, slong terms, const FactorsOverX& factors) const;
    /// @brief Nothing multiplied out.
    [[nodiscard]] FactorsOverX nothing() const;
    /// @brief A stretch, remembered for searches of other masses; it lasts until the next call.
    const SeenOverX& seen(double a, double b, Effort& effort);

private:
    [[nodiscard]] FactorsOverX poles_in(const Ball& x) const;

    std::vector<Ball> r_n_{};
    std::vector<bool> loaded_{};
    std::vector<ModeCluster> clusters_{};  // modes by themselves too
    std::vector<std::vector<Ball>> psi_{}; // of each row all modes
    std::map<std::pair<double, double>, SeenOverX> all_{};
};

/// @brief The sum over modes of weights times functions.
[[nodiscard]] PolynomialInBalls sum_over_modes(const WeightsInBalls& w, const std::vector<PolynomialInBalls>& f);

/// @brief All invariant points of every mass within a range of frequency ratios, damping left out.
///
/// Over x = 1/r, \f$ V_jU_k - 2V_kU_j \f$ and \f$ U_k \f$ are analytic once their poles are multiplied out. A stretch of x is
/// divided until the Taylor polynomial about its middle, with the last coefficient over the whole stretch, proves that the
/// function does not vanish there, or that it is monotone, so that its signs at the ends decide whether it vanishes once.
/// Newton's method then proves the place in all current bits. If V_j vanishes too, the point is no root of (87) if the response
/// of some mass is a factor of V_j and of V_k, and (87) does not vanish without that factor. Undecided are a zero that may be a
/// pole, one at which (87) may divide by zero, and what is left when the effort is spent.
/// Points that may lie on an end of the range are among those that are found. The scene's r is not used.
/// @eq{33,34,87}
/// @throws InputError if r_a is not positive, r_b not above it, or there are more than 100000 poles above r_a; Unproved if
///         the modes are not proved; PrecisionError if the budget of work is spent before the modes are known
[[nodiscard]] std::vector<InvariantPointsOfMass<Ball>> invariant_points_in_balls(const SceneInBalls& scene, const Ball& r_a,
                                                                                 const Ball& r_b);

} // namespace denhartog::reference
