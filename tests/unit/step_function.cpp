// Numbers over a step: values, zeros found in order, none lost, those at the start left out.
#include "denhartog/paper_algorithm/detail/step_function.hpp"

#include <array>
#include <cmath>

#include "denhartog/number/number.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

template <class F, class Derivative>
StepFunction through(const F& f, const Derivative& derivative) {
    return quintic({f(0.0), derivative(0.0), f(1.0), derivative(1.0), f(1.0 / 3), f(2.0 / 3)});
}

// Product of (theta - zero) over the zeros times a sign.
StepFunction with_zeros(const std::vector<double>& zeros, double factor) {
    const auto f = [&](double theta) {
        double product = factor;
        for (const double zero : zeros) product *= theta - zero;
        return product;
    };
    const auto derivative = [&](double theta) {
        double sum = 0;
        for (std::size_t i = 0; i < zeros.size(); ++i) {
            double product = factor;
            for (std::size_t n = 0; n < zeros.size(); ++n)
                if (n != i) product *= theta - zeros[n];
            sum += product;
        }
        return sum;
    };
    return through(f, derivative);
}

} // namespace

TEST_CASE("a polynomial of fifth degree is found from its dense output", "[unit][paper-algorithm]") {
    const auto f = [](double t) { return 3 + t * (-2 + t * (0.5 + t * (7 + t * (-4 + t * 1.25)))); };
    const auto derivative = [](double t) { return -2 + t * (1 + t * (21 + t * (-16 + t * 6.25))); };
    const StepFunction p = through(f, derivative);
    for (int n = 0; n <= 16; ++n) {
        const double t = n / 16.0;
        const Jet jet = p(t);
        CHECK(std::abs(jet.f[0] - f(t)) <= 2e-14);
        CHECK(std::abs(jet.f[1] - derivative(t)) <= 2e-13);
        CHECK(std::abs(jet.f[2] - (1 + t * (42 + t * (-48 + t * 25)))) <= 2e-12);
        CHECK(std::abs(jet.f[3] - (42 + t * (-96 + t * 75))) <= 1e-11);
        CHECK(std::abs(jet.f[4] - (-96 + t * 150)) <= 1e-10);
        CHECK(std::abs(jet.f[5] - 150) <= 1e-10);
        CHECK(jet.bound + jet.growth == 0);
    }
}

TEST_CASE("a cosine over a step comes with its derivatives and what bounds the sixth", "[unit][paper-algorithm]") {
    for (const double tau : {0.0, 1.0, 2.5, 4.0, 1256.0})
        for (const double h : {0.001, 0.1, pi<double>() / 4}) {
            const StepFunction f{{}, 2 * std::cos(tau), -2 * std::sin(tau), h};
            for (int n = 0; n <= 64; ++n) {
                const double theta = n / 64.0, at = tau + h * theta;
                const Jet jet = f(theta);
                const std::array<double, 4> turn = {std::cos(at), -std::sin(at), -std::cos(at), std::sin(at)};
                double power = 2;
                for (std::size_t k = 0; k < 6; ++k, power *= h)
                    CHECK(std::abs(jet.f[k] - power * turn[k % 4]) <= 2 * 1256 * 2.3e-16);
                CHECK(jet.bound >= (1 - 1e-12) * power * std::abs(std::cos(at)));
            }
        }
}

TEST_CASE("changes of sign are found in order, two close together included", "[unit][paper-algorithm]") {
    std::vector<double> found;
    for (const std::vector<double>& zeros :
         {std::vector<double>{0.25}, {0.5, 0.5 + 1e-6}, {0.125, 0.5, 0.75}, {0.2, 0.2 + 1e-4, 0.6, 0.9, 0.9 + 1e-5}}) {
        sign_changes(with_zeros(zeros, 3), found);
        REQUIRE(found.size() == zeros.size());
        for (std::size_t n = 0; n < zeros.size(); ++n) CHECK(std::abs(found[n] - zeros[n]) <= 1e-9);
    }
    sign_changes(with_zeros({0.3, 0.3, 0.7}, 1), found); // the first two touch, to rounding: none, one or a pair
    REQUIRE_FALSE(found.empty());
    CHECK(found.size() <= 3);
    CHECK(std::abs(found.back() - 0.7) <= 1e-9);
    for (std::size_t n = 0; n + 1 < found.size(); ++n) CHECK(std::abs(found[n] - 0.3) <= 1e-6);
    sign_changes({{-0.1875, 1, -1.75, 1, 0, 0}}, found); // (theta - 1/2)^2 (theta - 3/4), exactly
    REQUIRE_FALSE(found.empty());
    CHECK(found.size() <= 3);
    CHECK(std::abs(found.back() - 0.75) <= 1e-12);
    sign_changes(with_zeros({0, 0.25, 0.5}, 1), found); // it starts from zero
    REQUIRE(found.size() == 2);
    CHECK(std::abs(found[0] - 0.25) <= 1e-12);
    sign_changes(with_zeros({-0.1, 1.1}, 1), found);
    CHECK(found.empty());
}

TEST_CASE("the first fall is found to rounding, however narrow the dip", "[unit][paper-algorithm]") {
    for (const double zero : {1e-9, 0.1, 0.7, 0.999}) {
        const StepFunction p = with_zeros({zero}, -1);
        const std::optional<double> found = first_fall(p, 0);
        REQUIRE(found);
        CHECK(std::abs(*found - zero) <= 1e-15);
        CHECK(std::abs(p(*found).f[0]) <= 1e-15);
    }
    CHECK_FALSE(first_fall(with_zeros({1.5}, -1), 0));
    CHECK(first_fall(with_zeros({-0.5}, -1), 0) == 0.0);
    // it falls and rises again within the step
    const std::optional<double> dip = first_fall(with_zeros({0.5, 0.5001}, 1), 0);
    REQUIRE(dip);
    CHECK(std::abs(*dip - 0.5) <= 1e-9);
}

TEST_CASE("a zero at the start of a phase does not end it, of first order or of second", "[unit][paper-algorithm]") {
    CHECK_FALSE(first_fall(with_zeros({0}, 1), 0));
    CHECK_FALSE(first_fall(with_zeros({0, 0}, 1), 1e-15));
    CHECK(first_fall(with_zeros({0}, -1), 0) == 0.0);
    CHECK(first_fall(with_zeros({0, 0}, -1), 1e-15) == 0.0);
    for (const std::vector<double>& zeros : {std::vector<double>{0, 0.625}, {0, 0, 0.625}}) {
        const std::optional<double> found = first_fall(with_zeros(zeros, -1), 1e-15);
        REQUIRE(found);
        CHECK(std::abs(*found - 0.625) <= 1e-14);
    }
    // what rounding leaves of the zero, of either sign, does not count
    for (const double rest : {1e-17, -1e-17}) {
        const auto f = [rest](double t) { return rest + rest * t + t * t * (0.5 - t); };
        const auto derivative = [rest](double t) { return rest + t * (1 - 3 * t); };
        const std::optional<double> found = first_fall(through(f, derivative), 1e-15);
        REQUIRE(found);
        CHECK(std::abs(*found - 0.5) <= 1e-14);
    }
    CHECK_FALSE(first_fall(through([](double) { return 0.0; }, [](double) { return 0.0; }), 0));
}
