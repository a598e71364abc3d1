#include <cmath>
#include <limits>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/evaluation/resonance.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/solve/quantities.hpp"
#include "tests/support/rotations.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::tests;
using namespace denhartog;

// Far above the natural frequencies of a chain double has no digit of what a far mass does, and the reference answers.

namespace {

Scene<double> undamped_chain(std::size_t N, double r) {
    const std::vector<double> ones(N, 1), zeros(N, 0);
    return chain(ones, ones, zeros, N, 1, 1, r);
}

// The two chains whose sums over modes have no digit in double.
std::vector<Scene<double>> lost_chains() { return {undamped_chain(5, 100), undamped_chain(12, 30)}; }

double error_over(const Real100& truth, const Real100& value) {
    return static_cast<double>(Real100(abs(Real100((value - truth) / truth))));
}

} // namespace

TEST_CASE("at high r the sums over modes in double have no digit of V and U of a far mass, and their bounds say so",
          "[eq:33][eq:34][accuracy]") {
    for (const Scene<double>& scene : lost_chains()) {
        const std::size_t N = scene.system.mass_ratios.size();
        const ModeSums<Real100> truth = sums_of(converted<Real100>(scene));
        const ModeSums<Bounded<double>> sums = bounded_sums_of(scene);
        CHECK(error_over(truth.V[N - 1].re, sums.V[N - 1].re.x) > 0.1);
        CHECK(error_over(truth.U[0], sums.U[0].x) > 0.1);
        for (std::size_t k = 0; k < N; ++k) {
            INFO("N = " << N << ", mass " << k + 1);
            CHECK(abs(Real100(truth.V[k].re - Real100(sums.V[k].re.x))) <= Real100(sums.V[k].re.e));
            CHECK(abs(Real100(truth.U[k] - Real100(sums.U[k].x))) <= Real100(sums.U[k].e));
        }
    }
}

TEST_CASE("both chains are answered to 14 digits by the reference, and right", "[eq:38][accuracy]") {
    for (Scene<double> scene : lost_chains()) {
        const std::size_t N = scene.system.mass_ratios.size();
        const Boundary<Real100> limit = boundary(sums_of(converted<Real100>(scene)), Real100(1));
        scene.beta = static_cast<double>(limit.exact) / 2;
        const Response<Real100> truth = response(converted<Real100>(scene));
        REQUIRE(truth.steady_state);
        const Real100 X_j = truth.steady_state->X_j;
        const long before = precision_steps();
        const Solution measured = sliding_answer(scene_source(scene), Question{Asked::motion, 14});
        CHECK(precision_steps() > before);
        CHECK(measured.digits_reached);
        CHECK(measured.method.precision == "reference");
        CHECK(in_words(measured.method.why).find("in double: the error bound does not guarantee the 14 digits") == 0);
        CHECK(error_over(X_j, Real100(measured.masses[N - 1].amplitude.value)) < 1e-14);
        for (const int digits : {12, 14}) {
            const Solution solved = solve(scene_source(scene), {Asked::motion, digits});
            INFO("N = " << N << ", " << digits << " digits: " << in_words(solved.method.why));
            CHECK(solved.method.precision == "reference");
            CHECK(solved.regime.regime == Regime::continuous);
            CHECK(solved.relative_error <= std::pow(10.0, -digits));
            CHECK(error_over(X_j, Real100(solved.masses[N - 1].amplitude.value)) < std::pow(10.0, -digits));
        }
        const QuantitiesAnswer all = quantities(scene_source(scene), std::array{0.5}, 12);
        INFO(all.method.precision << ", " << in_words(all.method.why));
        CHECK(error_over(X_j, Real100(all.numbers.X_j->x)) < 1e-12);
        CHECK(all.relative <= 1e-12);
    }
}

// A coupling of modes that double does not tell from rounding counts, or is within the bounds of what it makes.

TEST_CASE("a coupling below rounding is in the bound of a second damping function next to a pole", "[modes][damping][eq:35]") {
    const std::string name = "next to an eleventh"; // the coupling of 1e-24 makes 1.5e-16 of G_1
    const Scene<double> scene = named_scene(name);
    const Quantities<Bounded<double>> narrow = quantities(scene_source(scene), {}, 6, PointNumbers::sums).numbers;
    const QuantitiesAnswer by_reference = quantities(named_source(name), {}, 15, PointNumbers::sums);
    CHECK(by_reference.method.precision == "reference");
    const Quantities<Bounded<double>>& truth = by_reference.numbers;
    CHECK(truth.G[0].x < -1e-16);
    CHECK(std::abs(truth.G[0].x / narrow.G[0].x - 1) < 1e-6);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(truth.G[k].x - narrow.G[k].x) <= narrow.G[k].e + truth.G[k].e);
        CHECK(std::abs(truth.U[k].x - narrow.U[k].x) <= narrow.U[k].e + truth.U[k].e);
    }
}

TEST_CASE("what is left out of the damping of stuck modes is in the error of the damping matrix",
          "[modes][damping][exact-solver]") {
    // Damping in proportion to the masses, but for the last digits of its ratios: these alone couple the stuck modes.
    for (const std::size_t contact : {0, 1, 2, 3}) {
        System<double> s = chain_of({1, 1.5, 0.7, 2.1}, {1, 0.8, 1.9, 0.6}, 0.1, contact + 1);
        const std::vector<double> r_n = modal_basis(s).r_n;
        for (std::size_t i = 0; i < r_n.size(); ++i) s.damping_ratios[i] = 0.3 / r_n[i];
        const ContactSystem c = contact_system(s);
        REQUIRE(c.stuck.modes_diagonalise_damping);
        const Matrix<Real50> M = mass_of<Real50>(s), K = stiffness_of<Real50>(s), C = damping_of<Real50>(s, M, K);
        std::vector<Eigen::Index> others;
        for (const Mass& each : c.stuck.masses) others.push_back(static_cast<Eigen::Index>(each.index));
        const Matrix<Real50> M_held = M(others, others), K_held = K(others, others), C_held = C(others, others),
                             phi = modes_by_rotations(M, K).phi, phi_held = modes_by_rotations(M_held, K_held).phi;
        Matrix<Real50> left_out = phi_held.transpose() * C_held * phi_held;
        left_out.diagonal().setZero();
        const Matrix<Real50> shares = phi_held.transpose() * M_held * phi(others, Eigen::all),
                             in_modes = shares.transpose() * left_out * shares;
        INFO("contact " << contact << ", " << static_cast<double>(in_modes.cwiseAbs().maxCoeff()));
        REQUIRE(in_modes.cwiseAbs().maxCoeff() > 1e-20);
        REQUIRE(c.damping_error.rows() == 4);
        for (Eigen::Index i = 0; i < 4; ++i)
            for (Eigen::Index k = 0; k < 4; ++k) CHECK(abs(in_modes(i, k)) <= c.damping_error(i, k));
        CHECK(c.damping_error.maxCoeff() < 1e-12);
    }
}

// (86) and the boundary at high frequency ratios.

TEST_CASE("the limit at high frequencies is 0.537 for mu = 1 and falls with mu", "[eq:86][high-frequency]") {
    CHECK(paper::friction_ratio_limit_at_high_frequency(1.0) == Approx(0.537).epsilon(1e-3));
    // a free mass comes to rest after half a period where sin(phi) = pi beta / 2, and starts again where |cos(phi)| = mu beta
    for (const double mu : {1.0, 1.375, 2.0, 3.0}) {
        const double beta = paper::friction_ratio_limit_at_high_frequency(mu);
        CHECK(std::hypot(pi<double>() * beta / 2, mu * beta) == Approx(1).epsilon(1e-14));
    }
}

TEST_CASE("with the load on the contact the boundary tends to it, whatever the damping and the number of masses",
          "[eq:69][eq:86][high-frequency]") {
    for (const double mu : {1.0, 1.375, 3.0}) {
        const double limit = paper::friction_ratio_limit_at_high_frequency(mu);
        for (const double zeta : {0.0, 0.001, 0.1, 0.5}) {
            CHECK(boundary(sums_of(oscillator(zeta, 1e5, mu)), mu).exact == Approx(limit).epsilon(1e-4));
            CHECK(boundary(sums_of(chain({1, 2.5, 0.75}, {1, 0.625, 1.875}, {zeta, zeta, zeta}, 2, 2, mu, 1e5)), mu).exact ==
                  Approx(limit).epsilon(1e-4));
        }
    }
}

TEST_CASE("with the load elsewhere the boundary tends to zero", "[eq:69][eq:86][high-frequency]") {
    double last = 1;
    for (const double r : {10.0, 100.0, 1000.0, 10000.0}) {
        const double limit = boundary(sums_of(three_masses(r)), 1.375).exact;
        CHECK(limit < last / 5);
        last = limit;
    }
}

// (76)-(85): what each formula says, and its stable form.

TEST_CASE("the response at resonance is the term of the mode at R = 1", "[eq:76][eq:77][resonance]") {
    for (const auto& [psi_k, psi_l] : {std::pair(0.75, 0.5), {-0.75, 0.5}, {0.75, -0.5}})
        for (const double zeta : {0.001, 0.01, 0.1}) {
            const Complex<double> v = paper::complex_response(1.0, zeta);
            const Complex<double> V = paper::complex_response_at_resonance(psi_k, psi_l, zeta);
            CHECK(V.re == 0);
            CHECK(V.im == Approx(psi_k * psi_l * v.im).epsilon(1e-15));
            CHECK(paper::complex_response_amplitude_at_resonance(psi_k, psi_l, zeta) == Approx(modulus(V)).epsilon(1e-15));
            CHECK(argument(V) == Approx(psi_k * psi_l > 0 ? -pi<double>() / 2 : pi<double>() / 2));
        }
}

TEST_CASE("the peak of a single mass is positive exactly below the boundary at resonance", "[eq:84][eq:85][resonance]") {
    for (const double zeta : {1e-12, 1e-6, 0.001, 0.01, 0.03125, 0.1}) {
        const double limit = evaluation::friction_ratio_limit_at_resonance(1.0, 1.0, zeta);
        CHECK(evaluation::resonant_peak_of_single_mass(zeta, limit) == 0);
        CHECK(evaluation::resonant_peak_of_single_mass(zeta, std::nextafter(limit, 0.0)) > 0);
        CHECK(evaluation::resonant_peak_of_single_mass(zeta, std::nextafter(limit, 1.0)) < 0);
        CHECK(paper::friction_ratio_limit_at_resonance(1.0, 1.0, std::max(zeta, 1e-4)) ==
              Approx(evaluation::friction_ratio_limit_at_resonance(1.0, 1.0, std::max(zeta, 1e-4))).epsilon(1e-7));
    }
}

TEST_CASE("a peak that is a double is one, however little damping there is", "[eq:83][resonance]") {
    // The cotangent is all but out of range; 64 times it is, and what is left of the load brings the peak back.
    const double zeta = 0x1p-1022, psi_ki = 64;
    const double beta = pi<double>() / 4 - 0x1p-10;
    const double peak = evaluation::resonant_peak(psi_ki, 1.0, 1.0, zeta, beta);
    CHECK(evaluation::second_damping_function_at_resonance(zeta) > std::numeric_limits<double>::max() / psi_ki);
    CHECK(std::isfinite(peak));
    CHECK(peak == Approx(0x1p-3 / pi<double>() * 0x1p1022).epsilon(1e-12));
}

// Modes that only friction damps, mu = 1: what they keep of a start, and what they do not.

namespace {

// The sliding motion with a part of the largest share of a mode, at the maximum of the force.
State with_share(const Scene<double>& scene, const Solution& s, double part) {
    const auto basis = modes_with_errors(scene.system);
    const ModeSums<double> sums = values_of(bounded_sums(scene.system, *basis, as_input(*scene.r)));
    State z = sliding_at_maximum_of_force(sums, *scene.beta);
    const auto i = static_cast<Eigen::Index>(s.kept_mode->mode), j = static_cast<Eigen::Index>(scene.system.contact.index);
    const double n = std::round(basis->r_n[s.kept_mode->mode].x / *scene.r), phase = s.phase(scene.system.contact)->value;
    const double share =
        part * (s.kept_mode->contact_at_most.value - s.amplitude(scene.system.contact).value) / basis->phi(j, i).x;
    for (std::size_t k = 0; k < z.x.size(); ++k) {
        const double of_mass = share * basis->phi(static_cast<Eigen::Index>(k), i).x;
        z.x[k] += of_mass * std::cos(n * phase);
        z.x_prime[k] += of_mass * n * std::sin(n * phase);
    }
    return z;
}

Scene<double> undamped(double r, double beta) { return oscillator(0, r, 1, beta); }

} // namespace

TEST_CASE("a mode without damping and an even number of periods in one of the force keeps any share up to the largest",
          "[solve][eq:38]") {
    // One mass: x = 4/3 cos tau + beta + A cos 2 tau while it falls is steady for every A from -1/3 to 1/3 - 2 beta.
    const Solution one = solve(scene_source(undamped(0.5, 0.2)), {});
    CHECK(one.amplitude(Mass{0}).value == Approx(4 / 3.0).epsilon(1e-14));
    REQUIRE(one.kept_mode);
    CHECK(std::abs(one.kept_mode->contact_at_most.value - 22 / 15.0) <= one.kept_mode->contact_at_most.error);
    // A chain, of which the second mode is damped otherwise.
    Scene<double> chain_of_two = chain({1, 0.5}, {1, 0.75}, {0, 0.125}, 2, 1, 1, 1, 0.02);
    chain_of_two.r = modal_basis(chain_of_two.system).r_n[0] / 2;
    // A chain whose least share is that at the start; next to the end velocity and rate vanish together, and rounding is their
    // quotient.
    Scene<double> chain_of_three = chain({1, 1.096, 0.98}, {1, 2.44, 1.504}, {0.7963, 0.0027, 0}, 1, 1, 1, 1, 0.197);
    chain_of_three.r = 1.2350169962702975; // half of the third natural frequency
    for (const Scene<double>& scene : {undamped(0.5, 0.2), undamped(0.25, 0.05), chain_of_two, chain_of_three}) {
        const Solution s = solve(scene_source(scene), {});
        REQUIRE(s.kept_mode);
        CHECK_FALSE(s.unique);
        CHECK(in_words(s.unique_because).substr(0, 3) == "no:");
        CHECK_FALSE(s.not_from_rest.empty());
        const ContactSystem system = contact_system(scene.system);
        ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
        for (const double part : {0.5, 0.99, -0.99}) {
            const State start = with_share(scene, s, part);
            const ExactMotion& motion = solver.run(start, 0.0, 2 * pi<double>());
            CHECK(distance(motion.end, start) < 1e-12);
            for (const Phase& p : motion.phases) CHECK((p.direction != 0 || p.end == p.start));
        }
        const State beyond = with_share(scene, s, 1.02);
        CHECK(distance(solver.run(beyond, 0.0, 2 * pi<double>()).end, beyond) > 1e-6);
    }
}

TEST_CASE("what friction damps is told at each point of a system that is prepared once", "[solve][eq:38]") {
    const Question question{Asked::amplitude, {}, false, Mass{0}};
    const PreparedSystem prepared = prepare(scene_source(undamped(0.7, 0.05)), question);
    REQUIRE(prepared.contact); // the contact alone, whose modes know no point
    const Solution kept = solve(prepared, 0.5, 0.2, question);
    REQUIRE(kept.kept_mode);
    CHECK(std::abs(kept.kept_mode->contact_at_most.value - 22 / 15.0) <= kept.kept_mode->contact_at_most.error);
    CHECK(solve(prepared, 0.7, 0.05, question).unique);
    CHECK_FALSE(solve(prepared, 0.7, 0, question).unique);
}

TEST_CASE("friction damps modes without damping elsewhere, and the answer is unique", "[solve][eq:38]") {
    const Scene<double> two = chain({1, 0.5}, {1, 0.75}, {0, 0}, 1, 2, 1, 0.625, 0.02);
    for (const Scene<double>& scene : {undamped(0.7, 0.05), undamped(0.3, 0.05), undamped(0.4, 0.9), undamped(0.4, 1.25), two}) {
        const Solution s = solve(scene_source(scene), {});
        INFO("r = " << *scene.r << ", beta = " << *scene.beta);
        CHECK(s.unique);
        CHECK(in_words(s.unique_because).find("friction damps every mode") != std::string::npos);
        const ContactSystem system = contact_system(scene.system);
        ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
        State a = at_rest(scene.system.mass_ratios.size()), b = a;
        b.x[0] = 0.1;
        b.x_prime[0] = 0.2;
        const double cycles = 4000 * pi<double>();
        a = State(solver.run(a, 0.0, cycles).end);
        b = State(solver.run(b, 0.0, cycles).end);
        for (std::size_t k = 0; k < a.x.size(); ++k) CHECK(std::abs(a.x_prime[k] - b.x_prime[k]) < 1e-6);
    }
    // Without friction nothing damps it; at a node of the contact, and with two modes that turn alike, friction does not.
    const auto is_open = [](const Scene<double>& scene) {
        const Solution s = solve(scene_source(scene), {});
        return !s.unique && in_words(s.not_from_rest).find("nothing is known to damp") != std::string::npos;
    };
    CHECK(is_open(undamped(0.7, 0)));
    Scene<double> held = chain({1, 0.5}, {1, 0.75}, {0, 0}, 1, 2, 1, 0.3, 3); // what is not held goes on
    CHECK(is_open(held));
    held.mu = 2;
    CHECK(is_open(held));
    const Scene<double> node = with_beta(named_scene("node"), 0.01);
    CHECK(is_open(node));
    Scene<double> alike = two;
    const std::vector<double> r_n = modal_basis(two.system).r_n;
    alike.r = (r_n[0] + r_n[1]) / 4; // both turn by angles over pi whose sum is four times pi
    CHECK(is_open(alike));
    CHECK(is_open(undamped(0x1p-12, 0x1p-40))); // 4096 periods in one of the force
    // Without friction a damped motion is unique whatever mu is.
    CHECK(solve(scene_source(with_beta(oscillator(0.05, 0.7, 2.5), 0)), {}).unique);
}
