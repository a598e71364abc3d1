// A coupling of modes that is left out stays within the bounds of what it makes of the sums, of the motion and of the demand.
#include <random>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/scene/converted.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/mass_in_motion.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/sums/bounded_modes.hpp"
#include "denhartog/sums/coupled_sums.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

// A chain with a damping matrix, and its modes as if each moved by itself, with what is left out.
struct WeaklyCoupled {
    System<double> system;
    ModalBasis<Bounded<double>> modes;
};

// Entries between modes are `coupling` times those that a matrix without negative eigenvalues may have at most, of any sign.
WeaklyCoupled weakly_coupled(std::mt19937_64& generator, int N, double coupling, bool all_damped) {
    const auto between = [&](double a, double b) { return a + (b - a) * static_cast<double>(generator() >> 11) * 0x1p-53; };
    WeaklyCoupled w;
    System<double>& s = w.system;
    for (int k = 0; k < N; ++k) {
        s.mass_ratios.push_back(k == 0 ? 1 : between(0.5, 2));
        s.stiffness_ratios.push_back(k == 0 ? 1 : between(0.5, 2));
        s.damping_ratios.push_back(all_damped || generator() % 3 == 0 ? between(0.4, 2) : between(1e-4, 0.05));
    }
    s.contact = Mass{generator() % static_cast<unsigned>(N)};
    s.load = Mass{generator() % static_cast<unsigned>(N)};
    w.modes = with_errors(s, modal_basis(s));
    const Matrix<double> phi = w.modes.phi.unaryExpr([](const auto& x) { return x.x; });
    Matrix<double> D = Matrix<double>::Zero(N, N), momentum = phi.transpose();
    for (int i = 0; i < N; ++i) {
        D(i, i) = 2 * s.damping_ratios[static_cast<std::size_t>(i)] * w.modes.r_n[static_cast<std::size_t>(i)].x;
        momentum.col(i) *= s.mass_ratios[static_cast<std::size_t>(i)];
    }
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < i; ++k) D(i, k) = D(k, i) = between(-1, 1) * coupling * std::sqrt(D(i, i) * D(k, k));
    s.damping_matrix = momentum.transpose() * D * momentum;
    s.damping_ratios.clear();
    D.diagonal().setZero();
    w.modes.left_out = D.unaryExpr([](const double& x) { return Bounded<double>(std::abs(x)); });
    return w;
}

// How much of the bounds of numbers is used.
struct Used {
    double most = 0;
    int numbers = 0, close = 0; // of which more than a hundredth

    void take(const char* what, const Bounded<double>& apart, const double& bound) {
        const double share = apart.least() / bound;
        INFO(what << ": " << share << " of the bound " << bound);
        CHECK(share <= 1);
        most = std::max(most, share);
        ++numbers;
        close += share > 0.01;
    }
};

} // namespace

TEST_CASE("a coupling of modes that is left out is within its bounds", "[modes][damping][eq:33][eq:40]") {
    std::mt19937_64 generator(57);
    Used used;
    for (int n = 0; n < 60; ++n) {
        const int N = 2 + n % 4;
        const WeaklyCoupled w = weakly_coupled(generator, N, n % 2 == 0 ? 1e-6 : 1e-4, n % 5 == 4);
        // At random, or near a resonance: of the force, or of an odd multiple of its frequency.
        const double apart = 1 + (static_cast<double>(generator() >> 11) * 0x1p-53 - 0.5) * (n % 3 == 0 ? 1 : 1e-3);
        const double r =
            w.modes.r_n[generator() % static_cast<unsigned>(N)].x * apart / static_cast<int>(1 + 2 * (generator() % 3));
        const ModeSums<Bounded<double>> without = bounded_sums(w.system, w.modes, Bounded<double>(r)),
                                        with = coupled_sums(w.system, Bounded<double>(r));
        REQUIRE(without.left_out.size() == static_cast<std::size_t>(N));
        const auto compare = [&](const char* what, const Bounded<double>& a, const Bounded<double>& b) {
            INFO("scene " << n << ", r = " << r);
            used.take(what, Bounded<double>(a.x, 0.0) - b, a.e);
        };
        for (std::size_t k = 0; k < without.V.size(); ++k) {
            compare("Re V", without.V[k].re, with.V[k].re);
            compare("Im V", without.V[k].im, with.V[k].im);
            compare("U", without.U[k], with.U[k]);
            compare("G", without.G[k], with.G[k]);
            for (const double tau : {0.0, 0.3, 1.1, 1.6, 2.5, 3.1}) {
                const auto share = friction_share(without, k, Bounded<double>(tau));
                const evaluation::FrictionMotion<Bounded<double>> true_one = with.coupled->motion(k, Bounded<double>(tau));
                evaluation::FrictionMotion<Bounded<double>> sum = share.of_mass;
                const std::vector<Bounded<double>> weights = friction_weights(without, k);
                for (std::size_t i = 0; i < weights.size(); ++i) {
                    sum.value = sum.value + weights[i] * share.of_modes[i].value;
                    sum.prime = sum.prime + weights[i] * share.of_modes[i].prime;
                    sum.double_prime = sum.double_prime + weights[i] * share.of_modes[i].double_prime;
                }
                compare("x", sum.value, true_one.value);
                compare("x'", sum.prime, true_one.prime);
                compare("x''", sum.double_prime, true_one.double_prime);
            }
        }
        compare("Re Y_jj", without.Y_jj.re, with.Y_jj.re);
        compare("Im Y_jj", without.Y_jj.im, with.Y_jj.im);
        compare("H_j", without.H_j, with.H_j);
        for (const double tau : {0.1, 0.9, 1.7, 2.6, 3.0})
            compare("demand", sliding_demand(without, Bounded<double>(tau)), sliding_demand(with, Bounded<double>(tau)));
    }
    INFO(used.close << " of " << used.numbers << " use a hundredth of their bound, the most " << used.most);
    CHECK(used.most > 0.2);
    CHECK(used.close > used.numbers / 20);
}

TEST_CASE("a coupling below rounding is in the bound of a second damping function next to a pole", "[modes][damping][eq:35]") {
    // An undamped mode next to an eleventh of its frequency beside damped ones: their coupling of 1e-24 makes 1.5e-16 of G_1.
    const char* text = R"({"mass_ratios": [1, 1.706606325004763, 0.4032277098542443],
        "stiffness_ratios": [1, 8.881784197001252e-16, 1], "damping_matrix": [[0, 0, 0],
        [0, 1.2648251221268454e-08, -1.2648251221268454e-08], [0, -1.2648251221268454e-08, 1.2648251221268454e-08]],
        "contact": 2, "load": 1, "r": 0.09090909094014846, "beta": 0.025})";
    const Scene<double> scene = read_scene<double>(text);
    const ModeSums<Bounded<double>> narrow = bounded_sums(scene.system, *modes_with_errors(scene.system), as_input(*scene.r));
    REQUIRE_FALSE(narrow.coupled);
    const Scene<Real50> wide_scene = read_scene<Real50>(text);
    const ModeSums<Bounded<Real50>> wide = coupled_sums(wide_scene.system, Bounded<Real50>(*wide_scene.r));
    CHECK(wide.G[0].x < -1e-16);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(abs(Real50(wide.G[k].x - narrow.G[k].x)) <= narrow.G[k].e);
        CHECK(abs(Real50(wide.U[k].x - narrow.U[k].x)) <= narrow.U[k].e);
    }
}

TEST_CASE("what is left out of the damping of stuck modes is in the error of the damping matrix",
          "[modes][damping][exact-solver]") {
    // Damping in proportion to the masses, but for the last digits of its ratios: these alone couple the stuck modes.
    for (const std::size_t contact : {0, 1, 2, 3}) {
        System<double> s;
        s.mass_ratios = {1, 1.5, 0.7, 2.1};
        s.stiffness_ratios = {1, 0.8, 1.9, 0.6};
        s.damping_ratios = {0.1, 0.1, 0.1, 0.1};
        s.contact = Mass{contact};
        s.load = Mass{0};
        const std::vector<double> r_n = modal_basis(s).r_n;
        for (std::size_t i = 0; i < r_n.size(); ++i) s.damping_ratios[i] = 0.3 / r_n[i];
        const ContactSystem c = contact_system(s);
        REQUIRE(c.stuck.modes_diagonalise_damping);
        const System<Real50> wide = in_type<Real50>(s);
        const ModalBasis<Real50> exact = modal_basis(wide);
        const StuckConfiguration<Real50> stuck = stuck_configuration(wide, exact);
        Matrix<Real50> left_out = stuck.damping;
        left_out.diagonal().setZero();
        Matrix<Real50> others(3, 4);
        for (Eigen::Index n = 0; n < 3; ++n)
            others.row(n) = exact.phi.row(static_cast<Eigen::Index>(stuck.masses[static_cast<std::size_t>(n)].index));
        const Matrix<Real50> shares = transpose_times(stuck.phi, product(stuck.M, others)),
                             in_modes = in_coordinates(shares, left_out);
        INFO("contact " << contact << ", " << static_cast<double>(in_modes.cwiseAbs().maxCoeff()));
        REQUIRE(in_modes.cwiseAbs().maxCoeff() > 1e-20);
        REQUIRE(c.damping_error.rows() == 4);
        for (Eigen::Index i = 0; i < 4; ++i)
            for (Eigen::Index k = 0; k < 4; ++k) CHECK(abs(in_modes(i, k)) <= c.damping_error(i, k));
        CHECK(c.damping_error.maxCoeff() < 1e-12);
    }
}
