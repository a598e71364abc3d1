// The stand-ins of the proofs: the list is closed, and the shipped bodies compute what the theorems say.
#include "derivation/selections/stand_ins.hpp"

#include <cmath>

#include "denhartog/evaluation/driven_motion.hpp"
#include "tests/catch.hpp"

namespace denhartog::derivation {
/// @brief Declared next to the claims, as `contact_root` once was. @param x a number @return a number
Symbolic not_on_the_list(const Symbolic& x);
} // namespace denhartog::derivation

// As in a shipped template: a function of that name is in sight, and what is found besides is found by the arguments.
namespace shipped_elsewhere {
/// @brief In sight, and of no argument.
void sinc();
/// @brief In sight, and of no argument.
void not_on_the_list();
/// @brief Whether a sinc is found by the argument. @tparam T a number type
template <class T>
concept HasSinc = requires(const T& x) {
    sinc(x);
};
/// @brief Whether what is not on the list is found by the argument. @tparam T a number type
template <class T>
concept HasUnlisted = requires(const T& x) {
    not_on_the_list(x);
};
} // namespace shipped_elsewhere

using namespace denhartog::derivation;
using denhartog::Complex;
using GiNaC::numeric;

namespace {

template <class T>
concept Ordered = requires(const T& x) {
    x < x;
};
template <class T>
concept Compared = requires(const T& x) {
    x == x;
};
double value(const Symbolic& s) {
    const GiNaC::ex v = s.expression().evalf();
    return GiNaC::ex_to<numeric>(v).to_double();
}

Symbolic symbolic(double x) { return Symbolic(GiNaC::ex(numeric(x))); }

/// The worst relative difference of a shipped body and its theorem, next to zero excepted, where the theorem cancels in double.
template <class Body, class Theorem>
double apart(const std::vector<double>& places, const Body& body, const Theorem& theorem) {
    double worst = 0;
    for (const double x : places) {
        const double shipped = body(x), meant = value(theorem(symbolic(x)));
        worst = std::max(worst, std::abs(shipped - meant) / std::max(std::abs(meant), 1e-3));
    }
    return worst;
}

} // namespace

// Code that compares numbers does not compile for the proofs, and an overload that is not on the list is not found.
static_assert(!Ordered<Symbolic> && !Compared<Symbolic>);
static_assert(shipped_elsewhere::HasSinc<Symbolic> && !shipped_elsewhere::HasUnlisted<Symbolic>);

TEST_CASE("the shipped bodies compute what the stand-ins of the proofs say", "[stand_in]") {
    namespace shipped = denhartog::evaluation;
    namespace theorem = denhartog::derivation::scalar;
    const std::vector<double> signed_places{-7.25, -1.5, -1, -0.3125, 0.125, 0.5, 1, 1.0625, 2.75, 6.5};
    const std::vector<double> places{0.125, 0.5, 1, 1.0625, 2.75, 3.5}, damping{0.03125, 0.25, 0.5, 0.75, 0.96875},
        heavy{1.03125, 1.25, 2.5};
    const double unit = 1e-14;
    CHECK(apart(signed_places, shipped::sin_pi<double>, [](const Symbolic& x) { return theorem::sin_pi(x); }) < unit);
    CHECK(apart(signed_places, shipped::cos_pi<double>, [](const Symbolic& x) { return theorem::cos_pi(x); }) < unit);
    CHECK(apart(signed_places, shipped::sinc<double>, [](const Symbolic& x) { return theorem::sinc(x); }) < unit);
    CHECK(apart(signed_places, shipped::sinhc_minus_one<double>, [](const Symbolic& x) { return theorem::sinhc_minus_one(x); }) <
          unit);
    CHECK(apart(places, shipped::one_minus_exp_over<double>, [](const Symbolic& x) { return theorem::one_minus_exp_over(x); }) <
          unit);
    CHECK(apart({0.125, 0.5, 1}, shipped::odd_series_without_leading_term<double>,
                [](const Symbolic& s) { return theorem::odd_series_without_leading_term(s); }) < unit);
    for (const double zeta : damping)
        CHECK(apart(
                  places, [=](double q) { return shipped::sinhc_less_sinc_over_square(q, zeta); },
                  [=](const Symbolic& q) { return theorem::sinhc_less_sinc_over_square(q, symbolic(zeta)); }) < 1e-12);
    for (const double zeta : heavy)
        CHECK(apart(
                  places, [=](double q) { return shipped::sinhc_less_sinhc_over_square(q, zeta); },
                  [=](const Symbolic& q) { return theorem::sinhc_less_sinhc_over_square(q, symbolic(zeta)); }) < 1e-12);
    for (const double K : {0.25, 4.0})
        CHECK(apart(
                  places, [=](double R) { return shipped::product_over(0.75, K, R); },
                  [=](const Symbolic& R) { return theorem::product_over(symbolic(0.75), symbolic(K), R); }) < unit);
    for (const double y : {0.0, 0.03125, 0.25}) {
        CHECK(apart(
                  places, [=](double R) { return denhartog::sine_cosine_of_half_period(R, y).s; },
                  [=](const Symbolic& R) { return theorem::sine_cosine_of_half_period(R, symbolic(y)).s; }) < 1e-12);
        CHECK(apart(
                  places, [=](double R) { return denhartog::sine_cosine_of_half_period(R, y).c; },
                  [=](const Symbolic& R) { return theorem::sine_cosine_of_half_period(R, symbolic(y)).c; }) < 1e-12);
    }
    for (const double im : {-1.5, 0.25, 3.0}) {
        const auto z = [=](const auto& re, const auto& part) { return Complex<std::decay_t<decltype(re)>>{re, part}; };
        CHECK(apart(
                  places, [=](double re) { return shipped::exp_minus_one_over(z(re, im)).re; },
                  [=](const Symbolic& re) { return theorem::exp_minus_one_over(z(re, symbolic(im))).re; }) < unit);
        CHECK(apart(
                  places, [=](double re) { return shipped::exp_minus_one_over(z(re, im)).im; },
                  [=](const Symbolic& re) { return theorem::exp_minus_one_over(z(re, symbolic(im))).im; }) < unit);
    }
}

TEST_CASE("at zero the stand-ins have the values that the shipped bodies have", "[stand_in]") {
    namespace shipped = denhartog::evaluation;
    namespace theorem = denhartog::derivation::scalar;
    const Symbolic zero(0);
    CHECK(value(theorem::sinc(zero)) == shipped::sinc(0.0));
    CHECK(value(theorem::sinhc_minus_one(zero)) == shipped::sinhc_minus_one(0.0));
    CHECK(value(theorem::one_minus_exp_over(zero)) == shipped::one_minus_exp_over(0.0));
    CHECK(value(theorem::odd_series_without_leading_term(zero)) == shipped::odd_series_without_leading_term(0.0));
    CHECK(value(theorem::sinhc_less_sinc_over_square(Symbolic(1), zero)) ==
          Approx(shipped::sinhc_less_sinc_over_square(1.0, 0.0)).epsilon(1e-15));
    CHECK(value(theorem::sinhc_less_sinhc_over_square(Symbolic(1), Symbolic(1))) ==
          Approx(shipped::sinhc_less_sinhc_over_square(1.0, 1.0)).epsilon(1e-15));
}

TEST_CASE("every stand-in is on the list with its theorem", "[stand_in]") {
    const std::vector<StandIn> list = stand_ins();
    CHECK(list.size() == 12);
    for (const StandIn& s : list) {
        CHECK(s.theorem.find("\\mapsto") != std::string::npos);
        CHECK(s.header.ends_with(".hpp"));
    }
}
