#include <Eigen/Dense>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/sliding/mode_sums.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::tests;
using namespace denhartog;

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

using evaluation::ModeFunctions;
using evaluation::Vectors;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Results of a mode over an array.
struct Functions {
    std::vector<double> v_re, v_im, u, g;
    std::vector<std::uint8_t> at_pole;
    std::size_t scalar;

    Functions(const std::vector<double>& R, double zeta, Vectors vectors)
        : v_re(R.size()), v_im(R.size()), u(R.size()), g(R.size()), at_pole(R.size(), 0),
          scalar(evaluation::mode_functions(R, zeta, {v_re, v_im, u, g, at_pole}, vectors)) {}
};

const std::vector<double>& damping_ratios() {
    static const std::vector<double> all{0,    0x1p-1074, 1e-300, 1e-13, 1e-9,    1e-6,        1e-3,       0.0625,
                                         0.25, 0.5,       0.51,   0.75,  0.96875, 1 - 0x1p-20, 1 - 0x1p-53};
    return all;
}

/// Seeded over 2^-45 to 2^45, most of them near 1, with the edges: poles and their neighbours, R = 2, ends of the vectors' range.
std::vector<double> frequency_ratios(std::size_t n, std::uint64_t seed) {
    std::vector<double> R{1e-300, 1e-20, 0x1p-27, 0x1p-26, 4e-4, 0x1p-10, 0.5, 0.25, 1.25, std::nextafter(1.25, 0),
                          1e5,    1e20,  1e70};
    for (int k = 1; k < 60; k += 2)
        for (const double pole : {1.0 / k, std::nextafter(1.0 / k, 0), std::nextafter(1.0 / k, 2)}) R.push_back(pole);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    while (R.size() < n) R.push_back(std::exp2(R.size() % 4 == 0 ? 90 * unit(random) - 45 : 8 * unit(random) - 5));
    return R;
}

/// Error in units of eps of the value and of what a relative change of R by eps, or of zeta, does to it; where the value is below
/// the normal numbers, in units of their spacing over R, by which (28) magnifies what is left of its exponential.
double error_in_eps(double found, const Real100& exact, const Real100& by_R, const Real100& by_zeta, double R) {
    using boost::multiprecision::abs;
    const Real100 scale = abs(exact) + abs(by_R) + abs(by_zeta) + std::numeric_limits<double>::min() * (1 + 1 / R);
    return static_cast<double>(abs(Real100(found) - exact) / scale) / eps;
}

/// Changes by a relative change of an argument by one, from differences over 1e-30 of it.
ModeFunctions<Real100> rates(const Real100& R, const Real100& zeta, bool of_R) {
    const Real100 h("1e-30");
    const ModeFunctions<Real100> a = evaluation::mode_functions(R, zeta);
    const ModeFunctions<Real100> b =
        of_R ? evaluation::mode_functions(Real100(R * (1 + h)), zeta) : evaluation::mode_functions(R, Real100(zeta * (1 - h)));
    return {{(b.v.re - a.v.re) / h, (b.v.im - a.v.im) / h}, (b.u - a.u) / h, (b.g - a.g) / h};
}

} // namespace

TEST_CASE("over arrays a mode has the digits of the scalar forms, against 100 digits", "[eq:23][eq:28][eq:29][accuracy]") {
    double worst_array = 0, worst_scalar = 0;
    std::string where;
    std::size_t compared = 0;
    for (std::size_t n = 0; n < damping_ratios().size(); ++n) {
        const double zeta = damping_ratios()[n];
        const std::vector<double> R = frequency_ratios(900, 40 + n);
        const Functions f(R, zeta, evaluation::supported_vectors().back());
        for (std::size_t i = 0; i < R.size(); ++i) {
            // Outside the vectors' range the scalar forms answer; at zeta below eps a change of R by eps is as wide as a peak.
            const bool in_range = R[i] >= evaluation::least_vector_ratio() && R[i] <= evaluation::largest_vector_ratio();
            if (f.at_pole[i] != 0 || !in_range || (zeta > 0 && zeta < 1e-14)) continue;
            const ModeFunctions<double> scalar = evaluation::mode_functions(R[i], zeta);
            const ModeFunctions<Real100> exact = evaluation::mode_functions(Real100(R[i]), Real100(zeta));
            const ModeFunctions<Real100> by_R = rates(Real100(R[i]), Real100(zeta), true);
            const ModeFunctions<Real100> by_zeta = rates(Real100(R[i]), Real100(zeta), false);
            const auto compare = [&](double array, double one, const Real100& x, const Real100& d, const Real100& e) {
                const double error = error_in_eps(array, x, d, e, R[i]);
                if (!(error <= worst_array)) {
                    worst_array = error;
                    where = "R = " + tests::hexadecimal(R[i]) + ", zeta = " + tests::hexadecimal(zeta);
                }
                worst_scalar = std::max(worst_scalar, error_in_eps(one, x, d, e, R[i]));
                ++compared;
            };
            compare(f.v_re[i], scalar.v.re, exact.v.re, by_R.v.re, by_zeta.v.re);
            compare(f.v_im[i], scalar.v.im, exact.v.im, by_R.v.im, by_zeta.v.im);
            compare(f.u[i], scalar.u, exact.u, by_R.u, by_zeta.u);
            compare(f.g[i], scalar.g, exact.g, by_R.g, by_zeta.g);
        }
    }
    INFO("worst over arrays " << worst_array << " eps at " << where << "; worst of the scalar forms " << worst_scalar << " eps");
    CHECK(compared > 4 * 10000);
    CHECK(worst_array <= 3);
}

TEST_CASE("vectors of any width give the same digits", "[eq:23][eq:28][eq:29]") {
    const std::vector<double> R = frequency_ratios(1000, 7);
    for (const double zeta : damping_ratios()) {
        const Functions narrow(R, zeta, Vectors::baseline);
        for (const Vectors vectors : evaluation::supported_vectors()) {
            INFO("zeta = " << tests::hexadecimal(zeta) << ", " << evaluation::name(vectors));
            const Functions wide(R, zeta, vectors);
            CHECK(wide.v_re == narrow.v_re);
            CHECK(wide.v_im == narrow.v_im);
            CHECK(wide.u == narrow.u);
            CHECK(wide.g == narrow.g);
            CHECK(wide.at_pole == narrow.at_pole);
        }
    }
}

TEST_CASE("over arrays only poles are marked, and nothing that is no number comes out", "[eq:23][eq:28][domain]") {
    const std::vector<double> R = frequency_ratios(1000, 9);
    for (const double zeta : damping_ratios()) {
        const Functions f(R, zeta, evaluation::supported_vectors().back());
        for (std::size_t i = 0; i < R.size(); ++i) {
            INFO("R = " << tests::hexadecimal(R[i]) << ", zeta = " << tests::hexadecimal(zeta));
            const ModeFunctions<double> one = evaluation::mode_functions(R[i], zeta);
            const bool finite =
                std::isfinite(one.v.re) && std::isfinite(one.v.im) && std::isfinite(one.u) && std::isfinite(one.g);
            CHECK((f.at_pole[i] != 0) <= !finite);
            CHECK(std::isfinite(f.v_re[i] + f.v_im[i] + f.u[i] + f.g[i]));
        }
    }
    const Functions undamped({1, 0.2, 0.5}, 0, evaluation::supported_vectors().back());
    CHECK(undamped.at_pole == std::vector<std::uint8_t>{1, 1, 0});
    CHECK(undamped.u[0] == 0);
}

TEST_CASE(
    "frequency ratios beyond the vectors' range and modes with zeta of 1 and more are left to the scalar forms, and counted",
    "[counter][overdamped]") {
    const std::vector<double> R{0x1p-27, 0x1p-26, 1, 0x1p200, 0x1p201};
    const long before = evaluation::array_mode_evaluations(), left = evaluation::array_modes_left_to_scalar_forms();
    const Functions f(R, 0.125, evaluation::supported_vectors().back());
    CHECK(f.scalar == 2);
    CHECK(evaluation::array_modes_left_to_scalar_forms() - left == 2);
    CHECK(evaluation::array_mode_evaluations() - before == 5);
    CHECK(Functions(R, 0x1p-501, evaluation::supported_vectors().back()).scalar == 5);
    CHECK(Functions(R, 0x1p-500, evaluation::supported_vectors().back()).scalar == 2);
    CHECK(f.g[4] == evaluation::mode_functions(0x1p201, 0.125).g);
    for (const double zeta : {1.0, 1.5, 40.0}) {
        const Functions overdamped({0.125, 1, 3}, zeta, evaluation::supported_vectors().back());
        CHECK(overdamped.scalar == 3);
        const ModeFunctions<double> one = evaluation::mode_functions(0.125, zeta);
        CHECK(overdamped.v_re[0] == one.v.re);
        CHECK(overdamped.u[0] == one.u);
        CHECK(overdamped.g[0] == one.g);
    }
}

TEST_CASE("arguments of arrays of modes are checked", "[domain]") {
    std::vector<double> a(2);
    std::vector<std::uint8_t> marks(2);
    const auto run = [&](const std::vector<double>& R, double zeta) { evaluation::mode_functions(R, zeta, {a, a, a, a, marks}); };
    CHECK_THROWS_WITH(run({1, 2}, -0.5), "zeta must be finite and at least 0, but is -0.5");
    CHECK_THROWS_WITH(run({1, 2, 3}, 0.5), "an array of results must have the length of R, 3, but is 2");
    for (const double R : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_AS(run({1, R}, 0.5), InputError);
}

// One modal coordinate over the half-period, against a Runge-Kutta integration of (20) that knows none of the formulas.

namespace {

using ModalState = std::array<double, 2>;

/// Displacement and velocity at tau from the initial values, by integration of (20).
ModalState integrated(const ModeInScene<double>& m, const InitialValues<double>& start, double beta, double phi_j, double tau) {
    ModalState state{start.eta_0, start.eta_prime_0};
    if (tau == 0) return state;
    const auto rate = [&](const ModalState& s, ModalState& ds, double t) {
        ds[0] = s[1];
        ds[1] = -2 * m.zeta / m.R * s[1] - s[0] / (m.R * m.R) + m.psi_ji * beta + m.psi_li * std::cos(t + phi_j);
    };
    namespace odeint = boost::numeric::odeint;
    const int steps = 8000;
    odeint::integrate_n_steps(odeint::runge_kutta4<ModalState>(), rate, state, 0.0, tau / steps, steps);
    return state;
}

struct Case {
    ModeInScene<double> m;
    InitialValues<double> start;
    double beta, phi_j;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> list{{{0.875, 0.03125, 0.75, -0.5}, {0.25, -0.375}, 0.3125, 0.625},
                                        {{2.5, 0.25, -1.25, 0.875}, {-0.5, 0.125}, 0.75, -1.5},
                                        {{0.3125, 0.5, 0.5, 1.5}, {0.0625, 1.25}, 0.1875, 2.75},
                                        {{1.125, 0.8125, 1.0, 1.0}, {1.0, 0.0}, 1.5, 0.25}};
    return list;
}

const std::vector<double> instants{0.0, 0.375, 1.0, 1.625, 2.5, 3.0};

constexpr double tolerance = 2e-11; // of the integration, absolute: steps of at most 4e-4 with an error of fourth order

} // namespace

TEST_CASE("over the half-period the formulas of a mode are the integrated motion, its velocity and its mirror image",
          "[eq:20][eq:21][eq:25][eq:A.1][eq:A.2][eq:A.3][eq:A.4][eq:A.5][eq:A.6][eq:A.7][eq:A.10][eq:A.11]") {
    for (const auto& [m, start, beta, phi_j] : cases()) {
        const IntegrationConstants<double> constants = paper::integration_constants(m, start, beta, phi_j);
        for (const double tau : instants) {
            const ModalState now = integrated(m, start, beta, phi_j, tau);
            CHECK(paper::general_solution(tau, m, constants, beta, phi_j) == Approx(now[0]).margin(tolerance));
            CHECK(paper::modal_displacement_from_start(tau, m, start, beta, phi_j) == Approx(now[0]).margin(tolerance));
            CHECK(paper::modal_velocity_from_start(tau, m, start, beta, phi_j) ==
                  Approx(now[1]).margin(tolerance)); // as corrected
        }
        // (A.10) measures how far the motion at pi is from the mirror image of its start.
        const Complex<double> v = paper::complex_response(m.R, m.zeta);
        const double v_cos = times_cosine(v, phi_j), v_sin = times_sine(v, phi_j);
        const PhaseSystem<double> p = paper::phase_system(m, start, beta);
        const ModalState end = integrated(m, start, beta, phi_j, pi<double>());
        CHECK(paper::final_displacement_residual(p, v_cos, v_sin) == Approx(end[0] + start.eta_0).margin(tolerance));
        CHECK(paper::final_velocity_residual(p, v_cos, v_sin) == Approx(end[1] + start.eta_prime_0).margin(tolerance));
    }
}

TEST_CASE("d and R q are the free motions from unit displacement and unit velocity", "[eq:A.8][eq:A.9]") {
    for (Case c : cases()) {
        c.m.psi_li = 0;
        for (const double tau : instants) {
            const ModalState from_displacement = integrated(c.m, {1, 0}, 0, 0, tau),
                             from_velocity = integrated(c.m, {0, 1}, 0, 0, tau);
            CHECK(paper::d(tau, c.m.R, c.m.zeta) == Approx(from_displacement[0]).margin(tolerance));
            CHECK(paper::d_prime(tau, c.m.R, c.m.zeta) == Approx(from_displacement[1]).margin(tolerance));
            CHECK(c.m.R * paper::q(tau, c.m.R, c.m.zeta) == Approx(from_velocity[0]).margin(tolerance));
            CHECK(c.m.R * paper::q_prime(tau, c.m.R, c.m.zeta) == Approx(from_velocity[1]).margin(tolerance));
        }
    }
}

TEST_CASE("started by (26) and (27), a mode ends the half-period in its mirror image",
          "[eq:26][eq:27][eq:28][eq:29][eq:40][eq:60][eq:62][eq:A.4][eq:A.12][eq:A.13][eq:A.14][eq:A.15]") {
    for (const Case& c : cases()) {
        const auto& [R, zeta, psi_ji, psi_li] = c.m;
        const Complex<double> v = paper::complex_response(R, zeta);
        const double u = paper::first_damping_function(R, zeta), g = paper::second_damping_function(R, zeta);
        const InitialValues<double> start{psi_li * R * R * times_cosine(v, c.phi_j) - psi_ji * R * R * g * c.beta,
                                          -psi_li * R * R * times_sine(v, c.phi_j) - psi_ji * R * R * u * c.beta};
        const ModalState end = integrated(c.m, start, c.beta, c.phi_j, pi<double>());
        CHECK(end[0] == Approx(-start.eta_0).margin(tolerance));
        CHECK(end[1] == Approx(-start.eta_prime_0).margin(tolerance));

        const PhaseSystem<double> p = paper::phase_system(c.m, start, c.beta);
        CHECK(paper::v_cosine_from_system(p) == Approx(times_cosine(v, c.phi_j)).margin(tolerance));
        CHECK(paper::v_sine_from_system(p) == Approx(times_sine(v, c.phi_j)).margin(tolerance));
        CHECK(paper::v_cosine(c.m, start, g, c.beta) / modulus(v) == Approx(std::cos(c.phi_j + argument(v))).margin(tolerance));
        CHECK(paper::v_sine(c.m, start, u, c.beta) / modulus(v) == Approx(std::sin(c.phi_j + argument(v))).margin(tolerance));
        CHECK(paper::cosine_of_phase(c.m, start, u, g, c.beta) == Approx(std::cos(c.phi_j)).margin(tolerance));
        for (const double tau : instants)
            CHECK(paper::modal_displacement(tau, c.m, start, u, g, c.beta) ==
                  Approx(integrated(c.m, start, c.beta, c.phi_j, tau)[0]).margin(tolerance));
    }
}
