// Mode functions at damping ratios of 1 and more: against the paper's formulas with w = i w_1 in up to 750 digits; against the
// half-period as a matrix exponential; and across zeta = 1, in 50 digits.
#include <array>
#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/evaluation/mode.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/number/bounded.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/mode_places.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;

namespace {

using Real250 = Multiprecision<250>;
using Real750 = Multiprecision<750>;

constexpr std::size_t count = 8;
const std::array<std::string, count> names{"Re v", "Im v", "u", "g", "d", "q", "rate of q", "acceleration of q"};

template <class T>
using All = std::array<T, count>;

/// A mode, and an instant x = tau / R.
template <class T>
struct Place {
    T R, zeta, x;
};

template <class T>
All<T> shipped(const Place<T>& p) {
    const evaluation::ModeFunctions<T> f = evaluation::mode_functions(p.R, p.zeta);
    const evaluation::FreeMotion<T> m = evaluation::free_motion(p.x, T(1), p.zeta, evaluation::w_if_oscillating(p.zeta));
    return {f.v.re, f.v.im, f.u, f.g, m.d, m.q, m.q_prime, m.q_double_prime};
}

/// The paper's (23), (28), (29) as they stand, with cosh and sinh for the cosine and the sine; where these would leave the range
/// of every type the fast exponential is nothing beside the slow one, and is left out. The free motions by two exponentials.
template <class Wide>
All<Wide> plain(const Wide& R, const Wide& zeta, const Wide& x) {
    using std::cosh;
    using std::exp;
    using std::sinh;
    const int too_large = std::is_floating_point_v<Wide> ? std::numeric_limits<int>::max() : 1400000000;
    const Complex<Wide> v = paper::complex_response(R, zeta);
    const Wide w = sqrt(Wide(zeta * zeta - 1)), y = pi<Wide>() / R, a = zeta - w, b = zeta + w;
    Wide u(0), g(1);
    if (zeta * y < too_large) {
        const Wide sum = cosh(Wide(zeta * y)) + cosh(Wide(w * y)), S = w == 0 ? y : Wide(sinh(Wide(w * y)) / w);
        u = S / (R * sum);
        g = (sinh(Wide(zeta * y)) - zeta * S) / sum;
    } else if (w > 0) {
        const Wide slow = exp(Wide(-a * y));
        u = slow / (w * R * (1 + slow));
        g = (1 - zeta / w * slow) / (1 + slow);
    }
    const Wide slow = exp(Wide(-a * x)), fast = exp(Wide(-b * x));
    if (w == 0) return {v.re, v.im, u, g, (1 + x) * slow, x * slow, (1 - x) * slow, (x - 2) * slow};
    const auto over = [&w](const Wide& difference) { return Wide(difference / (2 * w)); };
    return {v.re,
            v.im,
            u,
            g,
            over(b * slow - a * fast),
            over(slow - fast),
            over(b * fast - a * slow),
            over(a * a * slow - b * b * fast)};
}

template <class Wide, class T>
All<Real100> truth_in(const Place<T>& p) {
    const All<Wide> f = plain(Wide(p.R), Wide(p.zeta), Wide(p.x));
    All<Real100> truth;
    for (std::size_t i = 0; i < count; ++i) truth[i] = static_cast<Real100>(f[i]);
    return truth;
}

/// Cancellations: zeta - w_1 takes twice the digits of zeta; (29) at large R, twice those of R. If both are large, (29) is below
/// every range.
template <class T>
All<Real100> truth_of(const Place<T>& p) {
    const double zeta = std::log10(static_cast<double>(p.zeta)), R = std::abs(std::log10(static_cast<double>(p.R)));
    return 2 * zeta + 2 * R < 100 ? truth_in<Real250>(p) : truth_in<Real750>(p);
}

/// Relative change of each function for a relative change of R or x, or of zeta; 1 at least.
template <class T>
std::array<double, count> conditions(const Place<T>& p) {
    const Real100 h = ldexp(Real100(1), -110);
    const Place<Real100> at{Real100(p.R), Real100(p.zeta), Real100(p.x)};
    const All<Real100> f = shipped(at), by_R = shipped(Place<Real100>{at.R * (1 + h), at.zeta, at.x * (1 + h)}),
                       by_zeta = shipped(Place<Real100>{at.R, at.zeta * (1 + h), at.x});
    std::array<double, count> found{};
    for (std::size_t i = 0; i < count; ++i) {
        const auto change = [&](const Real100& other) {
            return f[i] == 0 ? 1 : static_cast<double>(Real100(abs(Real100((other - f[i]) / (h * f[i])))));
        };
        found[i] = std::max({1.0, change(by_R[i]), change(by_zeta[i])});
    }
    return found;
}

/// Seeded places: moderate; everything; next to zeta = 1; delta of order 1; slow rate of order R; next to resonance.
template <class T>
Place<T> overdamped_place(std::size_t zone, tests::Source<T>& s) {
    const auto not_below_1 = [](const T& zeta) { return zeta < 1 ? T(1) : zeta; };
    const int digits = std::numeric_limits<T>::digits;
    switch (zone) {
    case 0: return {s.spread(-1.3, 1.3), not_below_1(s.spread(0, 1.3)), T(0)};
    case 1: return {s.spread(-300, 300), not_below_1(s.spread(0, 300)), T(0)};
    case 2: return {s.spread(-2, 3), 1 + ldexp(s.mantissa(), -s.whole(1, digits)), T(0)};
    case 3: {
        const T zeta = not_below_1(s.spread(0, s.whole(0, 1) == 1 ? 2 : 290));
        return {T(zeta * s.spread(-1, 2)), zeta, T(0)};
    }
    case 4: {
        const T zeta = not_below_1(s.spread(0, s.whole(0, 1) == 1 ? 2 : 290));
        return {T(s.spread(-2, 2) / zeta), zeta, T(0)};
    }
    default: return {1 + ldexp(s.mantissa(), -s.whole(2, digits)), not_below_1(s.spread(0, 4)), T(0)};
    }
}

template <class T>
std::vector<Place<T>> places(int points) {
    tests::Source<T> source(20220118);
    std::vector<Place<T>> all;
    for (int n = 0; n < points; ++n) {
        all.push_back(overdamped_place(static_cast<std::size_t>(n % 6), source));
        all.back().x = (source.whole(0, 1) == 1 ? T(source.uniform(0.01, 3.14)) : source.spread(-3, 0)) / all.back().R;
    }
    const T eps = std::numeric_limits<T>::epsilon();
    for (const T& R : {T(1e-300), T(1) / 1000, T(1) / 3, T(1), 1 + eps, T(2), T(7), T(1e150), T(1e300)})
        for (const T& zeta : {T(1), 1 + eps, 1 + 64 * eps, T(5) / 4, T(3), T(1e8), T(1e16), T(1.4e154), T(1e300)})
            for (const int tenths : {1, 31}) all.push_back({R, zeta, T(tenths) / 10 / R});
    return all;
}

template <class T>
std::string text(const Place<T>& p) {
    char line[160];
    std::snprintf(line, sizeof line, "R = %a, zeta = 1 + %a, x = %a", static_cast<double>(p.R),
                  static_cast<double>(T(p.zeta - 1)), static_cast<double>(p.x));
    return line;
}

/// The worst of shipped and plain forms over the condition number.
template <class T>
void check(const std::string& type, int points, double allowed) {
    std::array<double, count> worst{}, worst_plain{};
    std::array<std::string, count> where;
    for (const Place<T>& p : places<T>(points)) {
        const All<T> value = shipped(p), by_hand = plain(p.R, p.zeta, p.x);
        const All<Real100> truth = truth_of(p);
        std::array<double, count> condition{};
        for (std::size_t i = 0; i < count; ++i) {
            const double error = tests::error_of(value[i], truth[i]), error_by_hand = tests::error_of(by_hand[i], truth[i]);
            if (error <= worst[i] && error_by_hand <= worst_plain[i]) continue;
            if (condition[0] == 0) condition = conditions(p);
            worst_plain[i] = std::max(worst_plain[i], error_by_hand / condition[i]);
            if (!(error / condition[i] > worst[i])) continue;
            worst[i] = error / condition[i];
            where[i] = text(p);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::printf("zeta >= 1, %s, %s: worst error %.2f eps over the condition number at %s; by hyperbolic functions %.1e\n",
                    type.c_str(), names[i].c_str(), worst[i], where[i].c_str(), worst_plain[i]);
        INFO(type << " " << names[i] << " " << worst[i] << " at " << where[i]);
        CHECK(worst[i] <= allowed);
        CHECK(worst[i] > 0.25);                  // one rounding leaves more than this: the comparison would not see
        if (i >= 2) CHECK(worst_plain[i] > 1e6); // the formulas as they stand fail on the same points
    }
}

/// The expression of (57) at tau, R, zeta, from the functions above.
template <class Wide>
Wide plain_s_d(const std::array<Wide, 3>& a) {
    const auto& [tau, R, zeta] = a;
    const All<Wide> f = plain(R, zeta, Wide(tau / R));
    return R * ((1 + f[3]) * f[5] - f[2] * R * (f[6] - cos(tau))) / sin(tau);
}

std::array<Real250, 3> in_250_digits(const std::array<double, 3>& at) { return {Real250(at[0]), Real250(at[1]), Real250(at[2])}; }

/// The error of a value of the expression of (57) over eps and over its size and what it changes with its arguments.
double error_of_s_d(double value, const std::array<double, 3>& at) {
    const Real250 h = ldexp(Real250(1), -200);
    const std::array<Real250, 3> a = in_250_digits(at);
    const Real250 truth = plain_s_d(a);
    Real250 size = abs(truth);
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<Real250, 3> other = a;
        other[k] *= 1 + h;
        size += abs(Real250((plain_s_d(other) - truth) / h));
    }
    return static_cast<double>(Real250(abs(Real250(Real250(value) - truth)) / size)) / std::numeric_limits<double>::epsilon();
}

/// u and g of a mode from the exponential of its system over the half-period: with unit friction and no load the state at the
/// start is -(I + Phi)^-1 (I - Phi) (R^2, 0), which is -R^2 (g, u).
std::array<Real100, 2> by_matrix_exponential(const Real100& R, const Real100& zeta) {
    using Square = std::array<Real100, 4>;
    const auto product = [](const Square& a, const Square& b) {
        return Square{a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
    };
    const Real100 part = ldexp(pi<Real100>(), -40);
    const Square A{Real100(0), part, -part / (R * R), -2 * zeta * part / R};
    Square Phi{Real100(1), Real100(0), Real100(0), Real100(1)}, term = Phi;
    for (int n = 1; n <= 14; ++n) {
        term = product(term, A);
        for (std::size_t i = 0; i < 4; ++i) {
            term[i] /= n;
            Phi[i] += term[i];
        }
    }
    for (int n = 0; n < 40; ++n) Phi = product(Phi, Phi);
    const Real100 b_0 = -R * R * (1 - Phi[0]), b_1 = R * R * Phi[2];
    const Real100 determinant = (1 + Phi[0]) * (1 + Phi[3]) - Phi[1] * Phi[2];
    const Real100 eta = ((1 + Phi[3]) * b_0 - Phi[1] * b_1) / determinant,
                  rate = ((1 + Phi[0]) * b_1 - Phi[2] * b_0) / determinant;
    return {-rate / (R * R), -eta / (R * R)};
}

} // namespace

TEST_CASE("critical and overdamped modes keep their digits in double, zeta from 1 and R from 1e-300 to 1e300",
          "[eq:23][eq:28][eq:29][eq:A.8][eq:A.9][accuracy][form][overdamped]") {
    check<double>("double", 10000, 4);
}

TEST_CASE("critical and overdamped modes keep their digits in long double",
          "[eq:23][eq:28][eq:29][eq:A.8][eq:A.9][accuracy][form][overdamped]") {
    check<long double>("long double", 1000, 4);
}

TEST_CASE("critical and overdamped modes keep their digits in 50 digits",
          "[eq:23][eq:28][eq:29][eq:A.8][eq:A.9][accuracy][form][overdamped]") {
    check<Real50>("50 digits", 300, 16);
}

TEST_CASE("from zeta = 1 on the expression of (57) keeps its digits up to both ends of the half-period",
          "[eq:57][accuracy][form][overdamped]") {
    tests::Source<double> source(20220157);
    double worst = 0, worst_plain = 0, widest_early = 0;
    for (int n = 0; n < 1500; ++n) {
        const double zeta = std::max(n % 3 == 0 ? 1 + source.spread(-15, 0) : source.spread(0, 3), 1.0), R = source.spread(-1, 3);
        const bool early = n % 2 == 0;
        const double from_end = source.spread(early ? -30 : -15.9, 0.19);
        const std::array<double, 3> at{early ? from_end : pi<double>() - from_end, R, zeta};
        INFO("tau = " << at[0] << " = pi - " << pi<double>() - at[0] << ", R = " << R << ", zeta = " << zeta);
        const double error = error_of_s_d(tests::s_d_rounded_once(at[0], R, zeta), at);
        CHECK(error <= 0.75);
        worst = std::max(worst, error);
        worst_plain = std::max(worst_plain, error_of_s_d(plain_s_d(at), at));
        if (at[0] == pi<double>()) continue; // it stands for pi, and is given the limit
        // In double, as the search for the boundary asks for it: digits are lost next to pi, and the bound says so.
        using Number = Bounded<double>;
        const Number wide_R(R), wide_zeta(zeta);
        const Number s_d = evaluation::s_d_integrand_of(Number(at[0]), wide_R, wide_zeta,
                                                        evaluation::selected_damping_functions(wide_R, wide_zeta));
        CHECK(abs(Real250(Real250(s_d.x) - plain_s_d(in_250_digits(at)))) <= s_d.e);
        if (early) widest_early = std::max(widest_early, s_d.e / std::abs(s_d.x));
    }
    std::printf("(57) at zeta >= 1: worst error %.2f eps over the condition number; as it stands %.1e; bounds of double up to "
                "the middle %.1e\n",
                worst, worst_plain, widest_early);
    CHECK(widest_early < 1e-11);
    CHECK(worst > 0.25);
    CHECK(worst_plain > 1e6);
}

TEST_CASE("u and g of an overdamped mode are those of the exponential of its system over the half-period",
          "[eq:28][eq:29][second-witness][overdamped]") {
    for (const char* R : {"0.07", "0.4", "1", "1.7", "12", "300"})
        for (const char* zeta : {"1", "1.000000001", "1.3", "4", "50"}) {
            const Real100 R_i(R), zeta_i(zeta);
            const auto [u, g] = by_matrix_exponential(R_i, zeta_i);
            const evaluation::DampingFunctions<Real100> f = evaluation::damping_functions(R_i, zeta_i);
            const Real100 other = evaluation::damping_functions(R_i, Real100(zeta_i * Real100("1.001"))).g;
            INFO("R = " << R << ", zeta = " << zeta);
            CHECK(abs(Real100(f.u - u)) < Real100("1e-70") * u);
            CHECK(abs(Real100(f.g - g)) < Real100("1e-70") * g);
            CHECK((abs(Real100(other - g)) > Real100("1e-30") * g)); // another damping ratio is told from it
        }
}

TEST_CASE("across zeta = 1 the mode functions go on: the last number below 1, 1, the first above", "[limit][overdamped]") {
    const auto check_steps = [](auto one, double allowed) {
        using T = decltype(one);
        const T eps = std::numeric_limits<T>::epsilon();
        double worst = 0;
        for (const int n : {1, 3, 7, 10, 13, 30, 200}) {
            const T R = T(n) / 10;
            for (const T& x : {T(T(1) / 4), T(1), T(3)}) {
                const All<T> below = shipped(Place<T>{R, 1 - eps / 2, x}), at = shipped(Place<T>{R, one, x}),
                             above = shipped(Place<T>{R, 1 + eps, x});
                const std::array<double, count> condition = conditions(Place<T>{R, one, x});
                for (std::size_t i = 0; i < count; ++i) {
                    if (at[i] == 0) continue; // Re v at R = 1, the rate of q at x = 1
                    for (const T& other : {below[i], above[i]}) {
                        const double step = static_cast<double>(T((other > at[i] ? T(other - at[i]) : T(at[i] - other)) / eps)) /
                                            (condition[i] * static_cast<double>(at[i] < 0 ? T(-at[i]) : at[i]));
                        INFO(names[i] << " R = " << static_cast<double>(R) << ", x = " << static_cast<double>(x) << ": " << step);
                        CHECK(step <= allowed);
                        worst = std::max(worst, step);
                    }
                }
            }
        }
        std::printf("across zeta = 1: steps of at most %.2f eps over the condition number\n", worst);
        CHECK(worst > 0.2); // a change of eps in zeta is seen
    };
    check_steps(1.0, 9);
    check_steps(Real50(1), 33);
}

TEST_CASE("the running error bound holds for overdamped modes", "[error_bound][overdamped]") {
    std::vector<double> over;
    int points = 0;
    for (const Place<double>& p : places<double>(3000)) {
        if (p.zeta > 1e6 || p.R > 1e6 || p.R < 1e-6) continue; // where results leave the range of double bounds are of no use
        ++points;
        const All<Bounded<double>> f =
            shipped(Place<Bounded<double>>{Bounded<double>(p.R), Bounded<double>(p.zeta), Bounded<double>(p.x)});
        const All<Real100> truth = truth_of(p);
        for (std::size_t i = 0; i < count; ++i) {
            const double error = static_cast<double>(Real100(abs(Real100(Real100(f[i].x) - truth[i]))));
            INFO(names[i] << " at " << text(p) << ": error " << error << ", bound " << f[i].e);
            const double of_truth = static_cast<double>(Real100(4 * std::numeric_limits<Real100>::epsilon() * abs(truth[i])));
            REQUIRE(error <= f[i].e + of_truth); // a g of 1 less 1e-97 shows the last place of the reference
            if (error > 0) over.push_back(f[i].e / error);
        }
    }
    std::sort(over.begin(), over.end());
    const double median = over[over.size() / 2], smallest = over.front();
    std::printf("running bounds of overdamped modes: %d points, least over-estimate %.2f, median %.1f\n", points, smallest,
                median);
    CHECK(points > 1000);
    CHECK(smallest < 10); // a bound ten times smaller would be broken
    CHECK(median < 30);
}
