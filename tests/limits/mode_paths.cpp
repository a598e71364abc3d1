// The functions of a mode on 22 paths to the ends of their domain, those of the chart: what they tend to, in 400 digits, and the
// digits that float, double, long double and 50 digits keep on the way.
#include "paper-figures/common/limit_paths.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::figures;

namespace {

/// What the chart shows of a path: which of v, u, g lose more than half of their digits in the paper's forms.
struct Expected {
    std::string words;
    Three<bool> lost;
};

const std::vector<Expected>& expected() {
    static const std::vector<Expected> rows{
        {"ζ = x → 0, R = 3/4", {false, false, false}},     {"ζ = x → 0, R = 1", {false, true, true}},
        {"ζ = x → 0, R = 1/2", {false, true, false}},      {"R = 1 + x → 1, ζ = 0.1", {false, false, false}},
        {"R = 1 − x → 1, ζ = 0.1", {false, false, false}}, {"R = 1 + x⁴, ζ = x", {false, false, false}},
        {"R = 1 + x², ζ = x", {false, true, true}},        {"R = 1 − x², ζ = x", {false, true, true}},
        {"R = 1 + x², ζ = 3x", {false, true, true}},       {"R = 1 + x, ζ = x", {false, true, true}},
        {"R = 1 − x, ζ = x", {false, true, true}},         {"R = 1 + x, ζ = 3x", {false, true, true}},
        {"R = 1 + x, ζ = x²", {false, true, true}},        {"R = 1 + x, ζ = 3x²", {false, true, true}},
        {"R = 1 + x, ζ = x³", {false, true, true}},        {"R = (1+x)/3, ζ = x", {false, true, true}},
        {"R = (1−x)/5, ζ = x", {false, true, true}},       {"R = (1+x)/2, ζ = x", {false, true, false}},
        {"R = (1−x)/4, ζ = x", {false, true, false}},      {"R = 1/x → ∞, ζ = 0.1", {false, false, true}},
        {"ζ = 1 − x → 1, R = 3/4", {false, false, false}}, {"R = x → 0, ζ = 0.1", {false, false, true}}};
    return rows;
}

/// Whether the paper's form of a function loses more than half of its digits, what is larger than every number of the type
/// included: the square of 1 - R^2 for R = 1e100, the hyperbolic cosine of pi zeta / R for R = 1e-8, ten to the power of 14
/// millions.
bool is_lost(std::size_t path, std::size_t f, int largest_power_of_ten) {
    const std::string& words = expected()[path].words;
    if (words == "R = 1/x → ∞, ζ = 0.1" && f == 0) return largest_power_of_ten < 400;
    if (words == "R = x → 0, ζ = 0.1" && f == 2) return largest_power_of_ten < 14000000;
    return expected()[path].lost[f];
}

/// Every path in a number type, in steps of five decades.
template <class T>
void check(const char* type) {
    const std::vector<LimitPath> paths = limit_paths_of_modes();
    REQUIRE(paths.size() == expected().size());
    for (std::size_t n = 0; n < paths.size(); ++n) {
        const KeptAlongPath kept = follow<T>(paths[n], 5);
        REQUIRE(paths[n].words == expected()[n].words);
        for (std::size_t f = 0; f < 3; ++f) {
            INFO(paths[n].words << ", " << names_of_functions[f] << " in " << type << ": printed keeps " << kept.printed[f].digits
                                << " digits, shipped " << kept.shipped[f].digits << ", least at "
                                << tests::hexadecimal(kept.shipped[f].R) << ", " << tests::hexadecimal(kept.shipped[f].zeta));
            CHECK(std::isfinite(kept.shipped[f].digits)); // somewhere in the range of the type
            CHECK(kept.shipped[f].of_attainable > digits_of_type<T>() - 1.5);
            CHECK((kept.printed[f].digits < digits_of_type<T>() / 2) == is_lost(n, f, std::numeric_limits<T>::max_exponent10));
        }
    }
}

} // namespace

TEST_CASE("on every path v, u and g tend to their leading terms, and to no others", "[eq:23][eq:28][eq:29][limit]") {
    for (const LimitPath& path : limit_paths_of_modes()) {
        const Real400 x = pow(Real400(10), Real400(std::max(path.last, -40.0)));
        const Three<Real400> right = path.leading(x);
        const auto altered = [&](const Real400& factor) {
            return Three<Real400>{Real400(factor * right[0]), Real400(factor * right[1]), Real400(factor * right[2])};
        };
        const Three<double> off = off_leading_terms(path, x, right),
                            slightly = off_leading_terms(path, x, altered(1 + Real400(1e-4))),
                            sign = off_leading_terms(path, x, altered(Real400(-1))),
                            power = off_leading_terms(path, x, altered(x));
        INFO(path.words);
        for (std::size_t f = 0; f < 3; ++f) {
            INFO(names_of_functions[f]);
            CHECK(off[f] < 1000 * static_cast<double>(x));
            CHECK(slightly[f] > 5e-5);
            CHECK(sign[f] > 1);
            CHECK(power[f] > 1e6);
        }
    }
}

TEST_CASE("for R -> 0 in proportion to zeta the damping functions have one limit at even harmonics and another at odd ones",
          "[eq:28][eq:29][limit]") {
    const Real400 c = Real400(3) / 8;
    for (const bool odd : {false, true}) {
        const limits::ModeTerms<Real400> right = limits::at_low_frequency_in_proportion(odd, c),
                                         wrong = limits::at_low_frequency_in_proportion(!odd, c);
        const Real400 n = ldexp(Real400(1), 60) + (odd ? 1 : 0), R = 1 / n;
        const Three<Complex<Real400>> f = printed_functions(R, Real400(c * R));
        const auto off = [](const Real400& value, const limits::Term<Real400>& term) {
            return static_cast<double>(Real400(abs(Real400(value / term.coefficient - 1))));
        };
        INFO((odd ? "odd" : "even"));
        CHECK(off(f[1].re, right.u) < 1e-15);
        CHECK(off(f[2].re, right.g) < 1e-15);
        CHECK(off(f[1].re, wrong.u) > 0.1);
        CHECK(off(f[2].re, wrong.g) > 0.1);
        const evaluation::DampingFunctions<Real400> shipped = evaluation::damping_functions(R, Real400(c * R));
        CHECK(off(shipped.u, right.u) < 1e-15);
        CHECK(off(shipped.g, right.g) < 1e-15);
    }
}

TEST_CASE("in float the shipped forms keep their digits on every path, the printed ones none at the resonance",
          "[eq:23][eq:28][eq:29][limit][form]") {
    const std::vector<LimitPath> paths = limit_paths_of_modes();
    for (const LimitPath& path : paths) {
        const KeptAlongPath kept = follow<float>(path, 5);
        for (std::size_t f = 0; f < 3; ++f) {
            INFO(path.words << ", " << names_of_functions[f]);
            CHECK(kept.shipped[f].of_attainable > digits_of_type<float>() - 1.5);
        }
    }
    const KeptAlongPath resonance = follow<float>(paths[1], 2.5); // zeta -> 0 at R = 1
    CHECK(resonance.printed[1].digits == 0);
    CHECK(resonance.printed[2].digits == 0);
}

TEST_CASE("in double the shipped forms keep their digits on every path, the printed ones where the chart says",
          "[eq:23][eq:28][eq:29][limit][form]") {
    check<double>("double");
}

TEST_CASE("in long double the shipped forms keep their digits on every path, the printed ones where the chart says",
          "[eq:23][eq:28][eq:29][limit][form]") {
    check<long double>("long double");
}

TEST_CASE("in 50 digits the shipped forms keep their digits on every path, the printed ones where the chart says",
          "[eq:23][eq:28][eq:29][limit][form]") {
    check<Real50>("50 digits");
}
