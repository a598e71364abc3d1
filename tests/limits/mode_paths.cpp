#include <cmath>

#include "denhartog/formulas/high_frequency.hpp"
#include "paper-figures/common/limit_paths.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::figures;
using namespace denhartog::tests;
using namespace denhartog;

// The functions of a mode on 22 paths to the ends of their domain, those of the chart: what they tend to, in 400 digits, and the
// digits that float, double, long double and 50 digits keep on the way.

namespace {

/// Expected findings of the chart on a path: which of v, u, g lose more than half of their digits in the paper's forms.
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

/// True if the paper's form of a function loses more than half of its digits, or if a part of it exceeds every number of the
/// type. Examples: (1 - R^2)^2 at R = 1e100 is 1e400; cosh(pi zeta / R) at R = 1e-8 is about ten to the power of 14 million.
bool is_lost(std::size_t path, std::size_t f, int largest_power_of_ten) {
    const std::string& words = expected()[path].words;
    if (words == "R = 1/x → ∞, ζ = 0.1" && f == 0) return largest_power_of_ten < 400;
    if (words == "R = x → 0, ζ = 0.1" && f == 2) return largest_power_of_ten < 14000000;
    return expected()[path].lost[f];
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

TEMPLATE_TEST_CASE("the shipped forms keep their digits on every path, the printed ones where the chart says",
                   "[eq:23][eq:28][eq:29][limit][form]", float, double, long double, Real50) {
    const std::vector<LimitPath> paths = limit_paths_of_modes();
    REQUIRE(paths.size() == expected().size());
    for (std::size_t n = 0; n < paths.size(); ++n) {
        const KeptAlongPath kept = follow<TestType>(paths[n], 5); // in steps of five decades
        REQUIRE(paths[n].words == expected()[n].words);
        for (std::size_t f = 0; f < 3; ++f) {
            INFO(paths[n].words << ", " << names_of_functions[f] << ": printed keeps " << kept.printed[f].digits
                                << " digits, shipped " << kept.shipped[f].digits << ", least at "
                                << tests::hexadecimal(kept.shipped[f].R) << ", " << tests::hexadecimal(kept.shipped[f].zeta));
            CHECK(kept.shipped[f].of_attainable > digits_of_type<TestType>() - 1.5);
            if (std::same_as<TestType, float>) continue; // some paths leave its range
            CHECK(std::isfinite(kept.shipped[f].digits));
            CHECK((kept.printed[f].digits < digits_of_type<TestType>() / 2) ==
                  is_lost(n, f, std::numeric_limits<TestType>::max_exponent10));
        }
    }
    if (!std::same_as<TestType, float>) return;
    const KeptAlongPath resonance = follow<TestType>(paths[1], 2.5); // zeta -> 0 at R = 1
    CHECK(resonance.printed[1].digits == 0);
    CHECK(resonance.printed[2].digits == 0);
}

TEST_CASE("a mode without damping has no second damping function", "[eq:29][limit]") {
    for (const double R : {0.3, 0.6, 0.875, 1.25, 2.5, 40.0}) CHECK(evaluation::mode_functions(R, 0.0).g == 0);
}

// The boundary for r -> infinity and r -> 0: limits and rates, in 50 digits.

namespace {

/// A chain of four unequal masses, the load on the first.
System<Real50> four_masses(std::size_t j, const std::vector<Real50>& zeta) {
    System<Real50> system = chain<Real50>({1, 2.5, 0.75, 1.25}, {1, 0.625, 1.875, 0.875}, {0, 0, 0, 0}, j, 1, 1, 1).system;
    system.damping_ratios = zeta;
    return system;
}

Real50 approximate_limit(const System<Real50>& system, const Real50& r, const Real50& mu) {
    return boundary(mode_sums(modal_basis(system), system.contact, system.load, r), mu).approximate;
}

/// The power with which (67) falls at high frequency ratios.
double rate(const System<Real50>& system) {
    const Real50 r = ldexp(Real50(1), 12), mu(1.375);
    return static_cast<double>(log2(Real50(approximate_limit(system, r, mu) / approximate_limit(system, Real50(2 * r), mu))));
}

} // namespace

TEST_CASE("with the load on the contact the boundary approaches its limit at high frequencies like 1/r",
          "[eq:69][eq:86][limit]") {
    for (const double m : {1.0, 1.375, 3.0}) {
        const Real50 mu(m), limit = paper::friction_ratio_limit_at_high_frequency(mu);
        const System<Real50> system = four_masses(1, {Real50(1) / 8, Real50(1) / 4, Real50(1) / 16, Real50(3) / 8});
        const auto error = [&](const Real50& r) { return Real50(approximate_limit(system, r, mu) - limit); };
        const Real50 r = ldexp(Real50(1), 16);
        CHECK(std::abs(static_cast<double>(error(r))) < 1e-4);
        CHECK(static_cast<double>(error(r) / error(Real50(2 * r))) == Approx(2).epsilon(1e-3));
    }
}

TEST_CASE("with the load elsewhere the boundary falls to zero at a rate that depends on the damping", "[eq:69][eq:86][limit]") {
    for (const std::size_t j : {2, 3, 4}) {
        const double distance = static_cast<double>(j - 1);
        INFO("j = " << j);
        const System<Real50> undamped = four_masses(j, std::vector<Real50>(4, Real50(0)));
        CHECK(rate(undamped) == Approx(2 * distance).epsilon(1e-5));
        CHECK(rate(four_masses(j, std::vector<Real50>(4, Real50(1) / 16))) == Approx(1).epsilon(1e-2));
        const ModalBasis<Real50> basis = modal_basis(undamped);
        std::vector<Real50> by_mass, by_stiffness; // damping in proportion to the mass, and to the stiffness
        for (const Real50& r_n : basis.r_n) by_mass.push_back(1 / (16 * r_n)), by_stiffness.push_back(r_n / 16);
        CHECK(rate(four_masses(j, by_mass)) == Approx(2 * distance).epsilon(1e-5));
        CHECK(rate(four_masses(j, by_stiffness)) == Approx(distance).epsilon(1e-2));
    }
}

TEST_CASE("with the load elsewhere and damping the boundary falls with the factor that the derivation has",
          "[eq:69][eq:86][limit]") {
    const Real50 mu(1.375), r = ldexp(Real50(1), 20);
    for (const std::size_t j : {2, 3, 4}) {
        INFO("j = " << j);
        const System<Real50> system = four_masses(j, {Real50(1) / 8, Real50(1) / 4, Real50(1) / 16, Real50(3) / 8});
        const ModalBasis<Real50> basis = modal_basis(system);
        Real50 coupling(0), squares(0);
        for (Eigen::Index i = 0; i < 4; ++i) {
            const std::size_t mode = static_cast<std::size_t>(i);
            const Real50 phi_ji = basis.phi(static_cast<Eigen::Index>(j - 1), i), phi_li = basis.phi(0, i);
            coupling += phi_ji * phi_li * basis.zeta[mode] * basis.r_n[mode], squares += phi_ji * phi_ji;
        }
        const Real50 limit = 4 * abs(coupling) / (sqrt(Real50(4 * mu * mu + pi<Real50>() * pi<Real50>())) * squares * r);
        CHECK(static_cast<double>(approximate_limit(system, r, mu) / limit) == Approx(1).epsilon(1e-4));
    }
}

TEST_CASE("with damping the boundary of a single mass tends to r^2 / (1 + mu) for r -> 0", "[eq:69][limit]") {
    for (const double mu : {1.0, 1.375, 3.0})
        for (const double zeta : {0.05, 0.1, 0.5}) {
            const double r = 0.01;
            INFO("mu = " << mu << ", zeta = " << zeta);
            CHECK(boundary(sums_of(oscillator(zeta, r, mu)), mu).exact / (r * r) == Approx(1 / (1 + mu)).epsilon(1e-3));
        }
}

TEST_CASE("with damping the boundary of a chain tends to the formula for low frequency ratios", "[eq:69][limit]") {
    const Real50 mu(1.375), r = ldexp(Real50(1), -8);
    for (const std::size_t j : {1, 2, 3, 4}) {
        INFO("j = " << j);
        const System<Real50> system = four_masses(j, {Real50(1) / 8, Real50(1) / 4, Real50(1) / 16, Real50(3) / 8});
        const Real50 stretch(1); // a static load on mass 1 stretches the first spring, k_1, and moves all masses alike
        const Real50 limit = paper::friction_ratio_limit_at_low_frequency(stretch, system.mass_ratios[j - 1], r, mu);
        const ModeSums<Real50> sums = mode_sums(modal_basis(system), system.contact, system.load, r);
        CHECK(static_cast<double>(boundary(sums, mu).exact / limit) == Approx(1).epsilon(1e-3));
    }
}

TEST_CASE("without damping the boundary of a single mass over r^2 has no limit for r -> 0", "[eq:69][limit]") {
    for (const double mu : {1.0, 1.375, 3.0})
        for (int n = 1; n <= 40; n += 3) {
            const double between = 1.0 / (2 * n), pole = 1.0 / (2 * n + 1) * (1 + 1e-9);
            INFO("mu = " << mu << ", n = " << n);
            CHECK(boundary(sums_of(oscillator(0, between, mu)), mu).exact ==
                  Approx(between * between / (mu * (1 - between * between))).epsilon(1e-9));
            CHECK(boundary(sums_of(oscillator(0, pole, mu)), mu).exact / (pole * pole) < 1e-6);
        }
}
