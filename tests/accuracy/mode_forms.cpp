// Modes at damping ratios of 1 and more, and 1 - d and the braces of (40) for R up to 1e8: against the formulas as they stand in
// up to 1100 digits, with the running bounds of their errors. Overdamped modes also against the half-period as a matrix
// exponential, and across zeta = 1.
#include <cmath>
#include <string>
#include <vector>

#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/number/bounded.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/function_errors.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

using Real250 = Multiprecision<250>;

/// R, zeta, and tau or x = tau / R.
template <class T>
using Point = std::array<T, 3>;

template <class Wide, class T>
Point<Wide> in(const Point<T>& p) {
    return {Wide(p[0]), Wide(p[1]), Wide(p[2])};
}

/// The paper's (23), (28), (29) as they stand, with cosh and sinh for the cosine and the sine; where these would leave the range
/// of every type the fast exponential is nothing beside the slow one, and is left out. The free motions by two exponentials.
template <class Wide>
std::array<Wide, 8> by_hyperbolic_functions(const Point<Wide>& p) {
    using std::cosh;
    using std::exp;
    using std::sinh;
    const auto& [R, zeta, x] = p;
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

/// Modes that do not vibrate, at R, zeta and x.
struct OverdampedModes {
    static inline const std::array<std::string, 8> names{"Re v", "Im v", "u", "g", "d", "q", "rate of q", "acceleration of q"};

    template <class T>
    static std::array<T, 8> shipped(const Point<T>& p) {
        const auto& [R, zeta, x] = p;
        const evaluation::ModeFunctions<T> f = evaluation::mode_functions(R, zeta);
        const evaluation::FreeMotion<T> m = evaluation::free_motion(x, T(1), zeta, evaluation::w_if_oscillating(zeta));
        return {f.v.re, f.v.im, f.u, f.g, m.d, m.q, m.q_prime, m.q_double_prime};
    }
    template <class T>
    static std::array<T, 8> plain(const Point<T>& p) {
        return by_hyperbolic_functions(p);
    }
    /// Cancellations: zeta - w_1 takes twice the digits of zeta; (29) at large R, twice those of R. If both are large, (29) is
    /// below every range.
    template <class T>
    static std::array<Real100, 8> truth(const Point<T>& p) {
        const double zeta = std::log10(static_cast<double>(p[1])), R = std::abs(std::log10(static_cast<double>(p[0])));
        return in_digits(2 * zeta + 2 * R + 150, [&]<class Wide>(Wide) { return in_100_digits(plain(in<Wide>(p))); });
    }
    static std::array<Real100, 8> of_condition(const Point<Real100>& p) { return shipped(p); }
};

/// 1 - d, and the braces of (40), where the difference loses twice the digits of R.
struct FrictionMotions {
    static inline const std::array<std::string, 2> names{"1 - d", "braces of (40)"};

    template <class T>
    static std::array<T, 2> differences(const T& R, const T& u, const T& g, const T& d, const T& q) {
        return {1 - d, 1 - (1 + g) * d - u * R * q};
    }
    template <class T>
    static std::array<T, 2> shipped(const Point<T>& p) {
        const auto& [R, zeta, tau] = p;
        const evaluation::DampingFunctions<T> f = evaluation::damping_functions(R, zeta);
        const T w = evaluation::w_if_oscillating(zeta);
        return {evaluation::one_minus_d(T(tau / R), zeta, w, evaluation::free_motion(tau, R, zeta, w).q),
                evaluation::friction_motion(tau, R, zeta, w, f.u, f.g).value};
    }
    template <class T>
    static std::array<T, 2> plain(const Point<T>& p) {
        const auto& [R, zeta, tau] = p;
        const evaluation::DampingFunctions<T> f = evaluation::damping_functions(R, zeta);
        const evaluation::FreeMotion<T> free = evaluation::free_motion(tau, R, zeta, evaluation::w_if_oscillating(zeta));
        return differences(R, f.u, f.g, free.d, free.q);
    }
    static std::array<Real100, 2> of_condition(const Point<Real100>& p) { return as_they_stand(p); }
    template <class T>
    static std::array<Real100, 2> truth(const Point<T>& p) {
        return in_100_digits(as_they_stand(in<Real300>(p)));
    }

private:
    template <class T>
    static std::array<T, 2> as_they_stand(const Point<T>& p) {
        const auto& [R, zeta, tau] = p;
        if (zeta < 1)
            return differences(R, paper::first_damping_function(R, zeta), paper::second_damping_function(R, zeta),
                               paper::d(tau, R, zeta), paper::q(tau, R, zeta));
        const std::array<T, 8> f = by_hyperbolic_functions<T>({R, zeta, tau / R});
        return differences(R, f[2], f[3], f[4], f[5]);
    }
};

/// Condition numbers of a function at a point: what it changes with R, zeta or the instant.
template <class Forms>
auto condition_at(const Point<Real100>& p) {
    return conditions<Forms::names.size()>(p, Forms::of_condition, Real100(-ldexp(Real100(1), -110)));
}

template <class T>
std::string text(const Point<T>& p) {
    return "R = " + hexadecimal(p[0]) + ", zeta = " + hexadecimal(p[1]) + ", then " + hexadecimal(p[2]);
}

/// The worst errors of shipped and plain forms over the condition number; from the function with the number `first` on the plain
/// ones are off by more than `least`.
template <class Forms, class T>
void check(const std::string& type, const std::vector<Point<T>>& points, double allowed, double least, std::size_t first = 0) {
    constexpr std::size_t n = std::tuple_size_v<std::remove_cvref_t<decltype(Forms::names)>>;
    std::vector<FunctionInZone> all;
    for (const std::string& name : Forms::names) all.push_back({"all", name});
    for (const Point<T>& p : points)
        note(all.data(), SurveyedPoint<n, T>(Forms::plain(p), Forms::shipped(p), text(p), true), {},
             {[&] { return Forms::truth(p); }, [&] { return ConditionNumbers<n>{condition_at<Forms>(in<Real100>(p))}; }});
    std::printf("%s", markdown(table_of(type, all)).c_str());
    for (std::size_t i = 0; i < n; ++i) {
        INFO(type << " " << all[i].function << " " << all[i].shipped.error << " at " << all[i].shipped.where);
        CHECK(all[i].shipped.error <= allowed);
        CHECK(all[i].shipped.error > 0.25);                  // one rounding leaves more than this: else nothing is compared
        if (i >= first) CHECK(all[i].printed.error > least); // the formulas as they stand fail on the same points
    }
}

/// The running bounds hold, and one that is ten times smaller would not.
template <class Forms>
void check_bounds(const std::vector<Point<double>>& points) {
    std::vector<double> over;
    for (const Point<double>& p : points) {
        const auto f = Forms::shipped(in<Bounded<double>>(p));
        const auto truth = Forms::truth(p);
        for (std::size_t i = 0; i < f.size(); ++i) {
            const double error = static_cast<double>(Real100(abs(Real100(Real100(f[i].x) - truth[i]))));
            INFO(Forms::names[i] << " at " << text(p) << ": error " << error << ", bound " << f[i].e);
            const double of_truth = static_cast<double>(Real100(4 * std::numeric_limits<Real100>::epsilon() * abs(truth[i])));
            REQUIRE(error <= f[i].e + of_truth); // a g of 1 less 1e-97 shows the last place of the reference
            if (error > 0) over.push_back(f[i].e / error);
        }
    }
    std::ranges::sort(over);
    const double median = over[over.size() / 2], smallest = over.front();
    std::printf("running bounds: %zu numbers, least over-estimate %.2f, median %.1f\n", over.size(), smallest, median);
    CHECK(over.size() > 3000);
    CHECK(smallest < 10);
    CHECK(median < 30);
}

/// Seeded places: moderate; everything; next to zeta = 1; delta of order 1; slow rate of order R; next to resonance.
template <class T>
Point<T> overdamped_point(int zone, Source<T>& s) {
    const auto not_below_1 = [](const T& zeta) { return zeta < 1 ? T(1) : zeta; };
    const int digits = std::numeric_limits<T>::digits;
    switch (zone) {
    case 0: return {s.spread(-1.3, 1.3), not_below_1(s.spread(0, 1.3))};
    case 1: return {s.spread(-300, 300), not_below_1(s.spread(0, 300))};
    case 2: return {s.spread(-2, 3), 1 + ldexp(s.mantissa(), -s.whole(1, digits))};
    case 3:
    case 4: {
        const T zeta = not_below_1(s.spread(0, s.whole(0, 1) == 1 ? 2 : 290));
        return {zone == 3 ? T(zeta * s.spread(-1, 2)) : T(s.spread(-2, 2) / zeta), zeta};
    }
    default: return {1 + ldexp(s.mantissa(), -s.whole(2, digits)), not_below_1(s.spread(0, 4))};
    }
}

template <class T>
std::vector<Point<T>> overdamped_points(int number) {
    Source<T> source(20220118);
    std::vector<Point<T>> all;
    for (int n = 0; n < number; ++n) {
        all.push_back(overdamped_point(n % 6, source));
        all.back()[2] = (source.whole(0, 1) == 1 ? T(source.uniform(0.01, 3.14)) : source.spread(-3, 0)) / all.back()[0];
    }
    const T eps = std::numeric_limits<T>::epsilon();
    for (const T& R : {T(1e-300), T(1) / 1000, T(1) / 3, T(1), 1 + eps, T(2), T(7), T(1e150), T(1e300)})
        for (const T& zeta : {T(1), 1 + eps, 1 + 64 * eps, T(5) / 4, T(3), T(1e8), T(1e16), T(1.4e154), T(1e300)})
            for (const int tenths : {1, 31}) all.push_back({R, zeta, T(tenths) / 10 / R});
    return all;
}

template <class T>
T damping_ratio(int zone, const T& x, Source<T>& s) {
    const int digits = std::numeric_limits<T>::digits;
    switch (zone) {
    case 0: return below_one(s.spread(-4, 0));
    case 1: return below_one(s.spread(-12, 0));
    case 2: return T(0);
    case 3: return T(1 - ldexp(s.mantissa(), -s.whole(2, digits)));
    case 4: return T(1 + ldexp(s.mantissa(), -s.whole(1, digits)));
    case 5: return s.spread(0, 3) + 1;
    default: return x * s.spread(-1, 1); // next to x = 2 zeta, where one form takes over from the other
    }
}

/// Anywhere, and next to both ends.
template <class T>
T instant(int kind, Source<T>& s) {
    switch (kind) {
    case 0: return s.spread(-8, 0);
    case 1: return std::min(T(pi<T>() - s.spread(-8, 0)), T(pi<T>()));
    case 2: return pi<T>();
    default: return T(s.uniform(0.01, 3.14));
    }
}

/// R up to 1e8, some next to the zero of the braces that lies before the end at large R.
template <class T>
std::vector<Point<T>> points_of_motion(int number) {
    Source<T> source(20220719);
    std::vector<Point<T>> all;
    for (int n = 0; n < number; ++n) {
        const int zone = n % 7;
        Point<T> p{zone == 0 ? source.spread(-1.3, 1.3) : source.spread(-0.5, 8), T(0), instant(source.whole(0, 5), source)};
        auto& [R, zeta, tau] = p;
        zeta = damping_ratio(zone, T(tau / R), source);
        if (n % 8 == 0 && R > 10) {
            const evaluation::DampingFunctions<T> f = evaluation::damping_functions(R, zeta);
            tau = pi<T>() - f.g / f.u * (1 + (source.mantissa() - T(1)) / 64);
        }
        if (tau > 0 && !(zeta == 0 && evaluation::at_undamped_pole(R))) all.push_back(p);
    }
    for (const T& R : {T(1) / 4, T(3) / 2, T(100), T(10000), T(1000000), T(100000000)})
        for (const T& zeta : {T(0), T(1) / 1024, T(1) / 20, T(1) / 2, T(1), T(2), T(50)})
            for (const T& tau : {T(1) / 1048576, T(1), T(3), T(pi<T>())}) all.push_back({R, zeta, tau});
    return all;
}

/// The expression of (57) at tau, R, zeta, from the functions above.
template <class Wide>
Wide plain_s_d(const std::array<Wide, 3>& a) {
    const auto& [tau, R, zeta] = a;
    const std::array<Wide, 8> f = by_hyperbolic_functions<Wide>({R, zeta, tau / R});
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

TEST_CASE(
    "critical and overdamped modes keep their digits in every number type, in double with zeta from 1 and R from 1e-300 to 1e300",
    "[eq:23][eq:28][eq:29][eq:A.8][eq:A.9][accuracy][form][overdamped]") {
    check<OverdampedModes>("zeta >= 1, double", overdamped_points<double>(10000), 4, 1e6, 2);
    check<OverdampedModes>("zeta >= 1, long double", overdamped_points<long double>(1000), 4, 1e6, 2);
    check<OverdampedModes>("zeta >= 1, 50 digits", overdamped_points<Real50>(300), 16, 1e6, 2);
}

TEST_CASE("1 - d and the braces of (40) keep their digits up to R = 1e8 in every number type",
          "[eq:40][eq:A.8][eq:46][accuracy][form][motion]") {
    check<FrictionMotions>("(40), float", points_of_motion<float>(4000), 4, 1e5);
    check<FrictionMotions>("(40), double", points_of_motion<double>(10000), 8, 1e5);
    check<FrictionMotions>("(40), long double", points_of_motion<long double>(2000), 8, 1e5);
    check<FrictionMotions>("(40), 50 digits", points_of_motion<Real50>(300), 8, 1e5);
}

TEST_CASE("the running error bound holds for overdamped modes, and for the braces of (40) up to R = 1e8",
          "[eq:40][error_bound][motion][overdamped]") {
    std::vector<Point<double>> points = overdamped_points<double>(3000);
    // where results leave the range of double bounds are of no use
    std::erase_if(points, [](const Point<double>& p) { return p[1] > 1e6 || p[0] > 1e6 || p[0] < 1e-6; });
    CHECK(points.size() > 1000);
    check_bounds<OverdampedModes>(points);
    check_bounds<FrictionMotions>(points_of_motion<double>(3000));
}

TEST_CASE("from zeta = 1 on the expression of (57) keeps its digits up to both ends of the half-period",
          "[eq:57][accuracy][form][overdamped]") {
    Source<double> source(20220157);
    double worst = 0, worst_plain = 0, widest_early = 0;
    for (int n = 0; n < 1500; ++n) {
        const double zeta = std::max(n % 3 == 0 ? 1 + source.spread(-15, 0) : source.spread(0, 3), 1.0), R = source.spread(-1, 3);
        const bool early = n % 2 == 0;
        const double from_end = source.spread(early ? -30 : -15.9, 0.19);
        const std::array<double, 3> at{early ? from_end : pi<double>() - from_end, R, zeta};
        INFO("tau = " << at[0] << " = pi - " << pi<double>() - at[0] << ", R = " << R << ", zeta = " << zeta);
        const double error = error_of_s_d(s_d_rounded_once(at[0], R, zeta), at);
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
                const auto of = [&](const T& zeta) { return OverdampedModes::shipped<T>({R, zeta, x}); };
                const std::array<T, 8> below = of(1 - eps / 2), at = of(one), above = of(1 + eps);
                const std::array<double, 8> condition = condition_at<OverdampedModes>(in<Real100>(Point<T>{R, one, x}));
                for (std::size_t i = 0; i < at.size(); ++i) {
                    if (at[i] == 0) continue; // Re v at R = 1, the rate of q at x = 1
                    for (const T& other : {below[i], above[i]}) {
                        const double step = static_cast<double>(T((other > at[i] ? T(other - at[i]) : T(at[i] - other)) / eps)) /
                                            (condition[i] * static_cast<double>(at[i] < 0 ? T(-at[i]) : at[i]));
                        INFO(OverdampedModes::names[i] << " R = " << static_cast<double>(R) << ", x = " << static_cast<double>(x)
                                                       << ": " << step);
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
