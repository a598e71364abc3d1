#include "denhartog/sliding/mode_sums.hpp"

#include <Eigen/Dense>

#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

TEST_CASE("the complex response functions of the masses solve the equations of harmonic motion", "[eq:22][eq:23][eq:33]") {
    for (const double r : {0.25, 0.875, 1.125, 2.5}) {
        const Scene<double> scene = three_masses(r);
        const ModeSums<double> s = sums_of(scene);
        const Eigen::VectorXcd x = harmonic_response(matrices_of(scene), s.load.index);
        const Eigen::VectorXcd y = harmonic_response(matrices_of(scene), s.contact.index);
        for (Eigen::Index k = 0; k < 3; ++k) {
            INFO("r = " << hexadecimal(r) << ", mass " << k + 1);
            CHECK(std::abs(x(k) - std::complex<double>(s.V[k].re, s.V[k].im)) < 1e-13 * x.norm());
        }
        CHECK(std::abs(y(1) - std::complex<double>(s.Y_jj.re, s.Y_jj.im)) < 1e-13 * y.norm());
    }
}

TEST_CASE("the damping functions are the response to a square wave on the contact", "[eq:28][eq:29][eq:34][eq:35]") {
    // Under the square wave sum 4 sin(n tau) / (pi n), n odd, alone, (26) and (27) give x_k(0) = -G_k and x'_k(0) = -U_k. The
    // velocity's series is summed without its 1/n^2 tail, which the mass matrix gives.
    for (const double r : {0.375, 0.875, 1.125, 2.5}) {
        const Scene<double> scene = three_masses(r);
        const ModeSums<double> s = sums_of(scene);
        const NonDimensionalMatrices m = matrices_of(scene);
        const Eigen::VectorXd tail = m.M.inverse().col(static_cast<Eigen::Index>(s.contact.index));
        Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
        Eigen::VectorXd v = -pi<double>() * pi<double>() / 8 * tail;
        for (int n = 1999; n > 0; n -= 2) {
            const Eigen::VectorXcd H = harmonic_response(m, s.contact.index, n);
            x += H.imag() / n;
            v += H.real() + tail / (double(n) * n);
        }
        for (Eigen::Index k = 0; k < 3; ++k) {
            INFO("r = " << hexadecimal(r) << ", mass " << k + 1);
            CHECK(s.G[k] == Approx(-4 / pi<double>() * x(k)).margin(1e-9));
            CHECK(s.U[k] == Approx(-4 / pi<double>() * v(k)).margin(1e-9));
        }
    }
}

TEST_CASE("the sum of squares at the contact is the inverse of its mass, and H_j is the sum over the modes", "[eq:64][eq:65]") {
    const Scene<double> scene = three_masses();
    const ModeSums<double> s = sums_of(scene);
    CHECK(s.sum_of_squares == Approx(paper::sum_of_squares_at_contact(2.5, 1.125)).epsilon(1e-14));
    double H_j = 0;
    for (std::size_t i = 0; i < 3; ++i)
        H_j += mode_shapes_at(s, s.contact)[i] * mode_shapes_at(s, s.contact)[i] * (s.g[i] + 2 * s.zeta[i] * s.R[i] * s.u[i]);
    CHECK(s.H_j == Approx(H_j).epsilon(1e-14));
}

TEST_CASE("with a mass matrix that is not diagonal the sum of squares is an entry of its inverse", "[eq:65]") {
    Scene<double> scene = three_masses();
    scene.system.mass_ratios.clear();
    scene.system.mass_matrix.resize(3, 3);
    scene.system.mass_matrix << 1, 0.25, 0, 0.25, 2.5, -0.5, 0, -0.5, 0.75;
    const ModeSums<double> s = sums_of(scene);
    CHECK(s.sum_of_squares == Approx(matrices_of(scene).M.inverse()(1, 1)).epsilon(1e-13));
}

TEST_CASE("load and response change places", "[eq:33]") {
    Scene<double> scene = three_masses();
    const ModeSums<double> s = sums_of(scene);
    for (std::size_t k = 0; k < 3; ++k) {
        Scene<double> other = scene;
        other.system.load = Mass{k};
        const ModeSums<double> o = sums_of(other);
        CHECK(o.V[scene.system.load.index].re == Approx(s.V[k].re).epsilon(1e-14));
        CHECK(o.V[scene.system.load.index].im == Approx(s.V[k].im).epsilon(1e-14));
    }
}

TEST_CASE("each mode is evaluated once a frequency ratio, whatever is asked for after", "[counter]") {
    Scene<double> scene = three_masses();
    scene.beta = 0.0625;
    const long modes = mode_evaluations();
    const long solves = eigen_solves();
    (void)response(scene);
    CHECK(mode_evaluations() - modes == 3);
    CHECK(eigen_solves() - solves == 1);
}

TEST_CASE("at the poles of a mode without damping there is an error that names mode and R", "[eq:23][eq:28][domain]") {
    const auto text = [](double r) {
        try {
            (void)sums_of(oscillator(0, r));
        } catch (const DomainError& e) {
            return std::string(e.what());
        }
        return std::string("no error");
    };
    CHECK(text(1).find("mode 1 has no damping and R = 1: its complex response function (23) is infinite") == 0);
    CHECK(text(1.0 / 5).find("mode 1 has no damping and R = 0.2: its first damping function (28) is infinite") == 0);
    CHECK(text(0.5) == "no error");
    CHECK_NOTHROW(sums_of(oscillator(0.015625, 1)));
}

TEST_CASE("arguments of the mode sums are checked", "[domain]") {
    const ModalBasis<double> basis = modal_basis(three_masses().system);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double r : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_AS(mode_sums(basis, Mass{0}, Mass{0}, r), InputError);
    CHECK_THROWS_WITH(mode_sums(basis, Mass{3}, Mass{0}, 1.125), Catch::Contains("contact must be a mass from 1 to 3, but is 4"));
    CHECK_THROWS_WITH(mode_sums(basis, Mass{0}, Mass{3}, 1.125), Catch::Contains("load must be a mass from 1 to 3, but is 4"));
}
