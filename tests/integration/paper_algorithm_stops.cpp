// The paper's algorithm where the contact stops: event times, permanent sticking, grazing, and that it cannot stall.
#include <Eigen/Dense>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "denhartog/answer/from_a_start.hpp"
#include "tests/integration/orbit_scenes.hpp"
#include "tests/support/paper_systems.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

// Largest difference of two motions: amplitudes, final states, places of stops; and of the instants of stops.
struct Difference {
    double x = 0, tau = 0;
};

Difference difference_of(const PaperMotion& a, const PaperMotion& b) {
    REQUIRE(a.status == IntegrationStatus::complete);
    REQUIRE(b.status == IntegrationStatus::complete);
    REQUIRE(a.stops.size() == b.stops.size());
    CHECK(a.rests == b.rests);
    CHECK(a.phases == b.phases);
    Difference d;
    for (std::size_t k = 0; k < a.masses.size(); ++k) {
        d.x = std::max(d.x, std::abs(a.masses[k].amplitude - b.masses[k].amplitude));
        d.x = std::max(d.x, std::abs(a.end.x[k] - b.end.x[k]));
        CHECK(a.masses[k].phase.has_value() == b.masses[k].phase.has_value());
    }
    for (std::size_t n = 0; n < a.stops.size(); ++n) {
        d.x = std::max(d.x, std::abs(a.stops[n].x - b.stops[n].x));
        d.tau = std::max({d.tau, std::abs(a.stops[n].start - b.stops[n].start), std::abs(a.stops[n].end - b.stops[n].end)});
    }
    return d;
}

// The recipe as one codes it first: a change of sign of x_j' between two steps, or a zero at one of them, ends a sliding phase.
long naive_phases(double r, double beta, double zeta, double end, long most, long& of_no_length) {
    namespace odeint = boost::numeric::odeint;
    using Y = std::array<double, 2>;
    double direction = 1;
    const auto f = [&](const Y& y, Y& y_prime, double tau) {
        y_prime = {y[1], (std::cos(tau) - y[0] - 2 * zeta * r * y[1] - direction * beta) / (r * r)};
    };
    auto stepper = odeint::make_dense_output(1e-6, 1e-6, odeint::runge_kutta_dopri5<Y>());
    Y y{0, 0};
    long phases = 0;
    double tau = 0;
    for (of_no_length = 0; tau < end && phases < most; ++phases) {
        const double start = tau;
        if (std::abs(std::cos(tau) - y[0]) <= beta) { // sticks until the load on it exceeds friction
            while (tau < end && std::abs(std::cos(tau) - y[0]) <= beta) tau += 1e-4;
        } else {
            direction = std::cos(tau) > y[0] ? 1 : -1;
            stepper.initialize(y, tau, 0.01);
            do {
                stepper.do_step(f);
            } while (stepper.current_time() < end && stepper.previous_state()[1] * stepper.current_state()[1] > 0);
            double a = stepper.previous_time(), b = stepper.current_time();
            if (stepper.previous_state()[1] == 0)
                b = a;
            else
                for (int n = 0; n < 60; ++n) {
                    const double middle = (a + b) / 2;
                    stepper.calc_state(middle, y);
                    (y[1] * stepper.previous_state()[1] > 0 ? a : b) = middle;
                }
            stepper.calc_state(b, y);
            y[1] = 0;
            tau = b;
        }
        of_no_length += tau == start;
    }
    return phases;
}

} // namespace

TEST_CASE("a naive recipe makes phases of no length where the paper's algorithm makes none", "[eq:74][paper-algorithm]") {
    long of_no_length = 0;
    const long naive = naive_phases(0.1, 0.2, 0.01, 400 * pi<double>(), 20000, of_no_length);
    CHECK(naive == 20000);        // it was stopped
    CHECK(of_no_length >= 19000); // at the end of the first stop
    const PaperMotion motion = paper_algorithm(with_beta(oscillator(0.01, 0.1), 0.2));
    CHECK(motion.status == IntegrationStatus::complete);
    CHECK(motion.phases <= 8 * 200 + 10); // four stops and four slides a period
    CHECK(motion.stops.size() == 4);
}

TEST_CASE("with stops the error falls with the tolerance", "[eq:74][eq:75][paper-algorithm]") {
    Scene<double> inertial = three_masses(0.3);
    inertial.system.mass_ratios.clear();
    inertial.system.mass_matrix = Matrix<double>{{1, 0.25, 0}, {0.25, 2, 0.5}, {0, 0.5, 1.5}};
    inertial.system.stiffness_ratios.clear();
    inertial.system.stiffness_matrix = Matrix<double>{{2, -1, 0}, {-1, 3, -1}, {0, -1, 2}};
    inertial.mu = 1;
    Scene<double> on_contact = three_masses(0.2);
    on_contact.system.load = on_contact.system.contact;
    struct Point {
        const char* name;
        Scene<double> scene;
    };
    for (const Point& p : {Point{"one mass, r = 0.1", with_beta(oscillator(0.01, 0.1), 0.2)},
                           {"one mass, r = 0.02", with_beta(oscillator(0.01, 0.02), 0.2)},
                           {"two masses", with_beta(chain({1, 1}, {1, 1}, {0.02, 0.03}, 2, 1, 1, 0.1), 0.3)},
                           {"three masses, mu > 1", with_beta(three_masses(0.15), 0.3)},
                           {"three masses, load on the contact", with_beta(on_contact, 0.3)},
                           {"three masses coupled by inertia", with_beta(inertial, 0.3)}}) {
        const PaperMotion exact = exact_cycles(scene_source(p.scene), settings_with(1e-6, 10));
        CHECK(exact.stops.size() >= 2);
        for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
            const Difference d = difference_of(paper_algorithm(p.scene, settings_with(tolerance, 10)), exact);
            INFO(p.name << ", tolerance " << tolerance << ": x " << d.x << ", tau " << d.tau);
            CHECK(d.x <= 10 * tolerance);
            CHECK(d.tau <= 30 * tolerance);
        }
    }
}

TEST_CASE("a contact that never moves stays to the last bit, and the others move as a dense solve has it",
          "[eq:74][paper-algorithm]") {
    const Scene<double> one = with_beta(oscillator(0.05, 0.7), 1.25);
    const PaperMotion still = paper_algorithm(one);
    CHECK(still.rests);
    CHECK(still.phases == 1);
    CHECK(still.end.x[0] == 0);
    CHECK(still.masses[0].amplitude == 0);
    CHECK_FALSE(still.masses[0].phase);
    const Scene<double> three = with_beta(three_masses(1.0), 5);
    const PaperMotion motion = paper_algorithm(three, settings_with(1e-10));
    CHECK(motion.rests);
    CHECK(motion.phases == 1);
    CHECK(motion.masses[1].amplitude == 0);
    const NonDimensionalMatrices m = matrices_of(three);
    Eigen::Matrix2cd D;
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) D(a, b) = {m.K(2 * a, 2 * b) - m.M(2 * a, 2 * b), m.C(2 * a, 2 * b)};
    const Eigen::Vector2cd X = D.partialPivLu().solve(Eigen::Vector2cd(1, 0));
    CHECK(std::abs(motion.masses[0].amplitude - std::abs(X(0))) <= 1e-9);
    CHECK(std::abs(motion.masses[2].amplitude - std::abs(X(1))) <= 1e-9);
    // held away from zero it stays as well
    PaperSettings settings = settings_with(1e-6, 20);
    settings.start = State{{0, 0.1, 0}, {0, 0, 0}};
    CHECK(paper_algorithm(three, settings).end.x[1] == 0.1);
}

TEST_CASE("grazing is decided and passed: at the boundary of sliding and where the load just reaches static friction",
          "[eq:74][paper-algorithm]") {
    for (const double r : {0.3, 0.7, 1.5}) {
        const Scene<double> at = with_beta(oscillator(0.05, r), 0);
        const double beta_lim = response(at).boundary.exact;
        for (const double factor : {1 - 1e-9, 1.0, 1 + 1e-9}) {
            const PaperMotion motion = paper_algorithm(with_beta(at, beta_lim * factor));
            INFO("r = " << r << ", beta over its limit " << factor << ", phases " << motion.phases);
            REQUIRE(motion.status == IntegrationStatus::complete);
            CHECK(motion.phases <= 200 * 8);
            const SteadyState<double> below = *response(with_beta(at, beta_lim * (1 - 1e-9))).steady_state;
            CHECK(std::abs(motion.masses[0].amplitude - below.X_j) <= 5e-6);
        }
        // The load is cos tau: with mu beta = 1 it reaches static friction at every extremum and does not exceed it.
        for (const double mu : {1.0, 2.0}) {
            const PaperMotion motion = paper_algorithm(with_beta(oscillator(0.05, r, mu), 1 / mu));
            CHECK(motion.status == IntegrationStatus::complete);
            CHECK(motion.rests);
            CHECK(motion.masses[0].amplitude == 0);
        }
    }
}

TEST_CASE("a stop that has not ended by the final time is no sliding", "[eq:74][paper-algorithm]") {
    Scene<double> scene;
    scene.system = two_masses(0.001);
    scene.r = 2.8;
    scene.beta = 0.2;
    const PaperMotion motion = paper_algorithm(scene);
    REQUIRE(motion.status == IntegrationStatus::complete);
    CHECK(motion.stops.empty());
    CHECK_FALSE(motion.rests);
    CHECK_FALSE(motion.slides);
    CHECK_FALSE(motion.masses[1].phase);
    CHECK(regime_seen(motion) == Regime::stick_slip);
}
