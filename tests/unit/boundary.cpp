#include "denhartog/sliding/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

std::vector<Scene<double>> scenes() {
    std::vector<Scene<double>> all;
    for (const double r : {0.1875, 0.375, 0.8125, 1.125, 2.5})
        for (const std::size_t j : {1, 2, 3})
            for (const double factor : {1.0, 1.0 / 64, 0.0}) {
                Scene<double> scene = three_masses(r);
                scene.system.contact = Mass{j - 1};
                for (double& zeta : scene.system.damping_ratios) zeta *= factor;
                all.push_back(scene);
            }
    for (const double zeta : {0.0, 0.0078125, 0.25})
        for (const double r : {0.021, 0.11, 0.3, 0.5, 1.5}) all.push_back(oscillator(zeta, r));
    return all;
}

/// The same, and seeded ones of one to ten masses.
std::vector<Scene<double>> scenes_and_seeded_ones() {
    std::vector<Scene<double>> all = scenes();
    for (const RandomScene<double>& random : random_scenes<double>(20220614)) all.push_back(random.scene);
    return all;
}

/// Where the modes' parts of the demand are large and cancel, so that its curvature is bounded by more than their sizes.
std::vector<Scene<double>> scenes_next_to_resonance() {
    std::vector<Scene<double>> all;
    const std::vector<double> resonances = modal_basis(three_masses().system).r_n;
    for (const double distance : {-0x1p-8, 0x1p-8, -0x1p-14, 0x1p-14}) {
        for (const double r_n : resonances) all.push_back(three_masses(r_n * (1 + distance)));
        for (const double zeta : {0.0, 0x1p-20, 0x1p-10}) all.push_back(oscillator(zeta, 1 + distance));
    }
    return all;
}

std::string at(const Scene<double>& scene) {
    const std::vector<double>& zeta = scene.system.damping_ratios;
    return "N = " + std::to_string(number_of_masses(scene.system)) + ", r = " + hexadecimal(*scene.r) + ", contact " +
           std::to_string(scene.system.contact.index + 1) + (zeta.empty() ? "" : ", zeta_1 = " + hexadecimal(zeta[0]));
}

} // namespace

TEST_CASE("the demand of a mode is the sum's where there is one mode", "[eq:56][eq:57]") {
    for (const double zeta : {0.0, 0.0078125, 0.25})
        for (const double r : {0.021, 0.11, 0.3, 0.5, 1.5}) {
            const Boundary<double> b = boundary(sums_of(oscillator(zeta, r)), 1.0);
            CHECK(b.S_exact == b.S_paper);
            CHECK(b.exact == b.paper);
        }
}

TEST_CASE("the velocity of the contact over the sine is what the demand is made for", "[eq:54][eq:55]") {
    for (Scene<double> scene : scenes()) {
        const ModeSums<double> s = sums_of(scene);
        const Boundary<double> b = boundary(s, scene.mu);
        const double beta = 0.875 * b.exact;
        const SteadyState<double> state = steady_state(s, b, beta);
        for (const double tau : {0.5, 1.25, 2.0, 2.75}) {
            const double velocity = motion(s, state, tau).x_prime[s.contact.index];
            INFO(at(scene) << ", tau = " << tau);
            CHECK(-velocity / std::sin(tau) == Approx(margin(s, beta, tau)).epsilon(1e-8).margin(1e-11 * state.X_j));
        }
    }
}

TEST_CASE("the contact moves down throughout below the velocity boundary and turns back beyond it",
          "[eq:54][eq:55][eq:56][eq:57][eq:58][maximum]") {
    int velocity_binds = 0;
    std::vector<Scene<double>> all = scenes_next_to_resonance();
    const std::size_t next_to_resonance = all.size(), closely = next_to_resonance + scenes().size();
    for (const Scene<double>& scene : scenes_and_seeded_ones()) all.push_back(scene);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Scene<double>& scene = all[k];
        const ModeSums<double> s = sums_of(scene);
        const Boundary<double> b = boundary(s, 1.0);
        double least_inside = 1e300;
        const int samples = k < closely ? 20000 : 200;
        for (int n = 1; n < samples; ++n)
            least_inside = std::min(least_inside, margin(s, b.exact * (1 - 1e-6), pi<double>() * n / samples));
        INFO(at(scene));
        CHECK(least_inside > 0);
        const double limit = paper::friction_ratio_limit(s.V[s.contact.index], s.U[s.contact.index], b.S_exact);
        const double there = b.instant > 0 ? b.instant : std::min(1e-7, 1e-9 * *s.R.begin());
        const double beyond = margin(s, limit * (1 + 1e-5), there);
        CHECK((beyond < 0 || (k < next_to_resonance && std::isnan(beyond)))); // (38) may have no root there, and no motion
        if (b.binding == BindingCondition::velocity) ++velocity_binds;
    }
    CHECK(velocity_binds >= 5); // else the interior maximum was never tried
}

TEST_CASE("at the static boundary the load on the contact equals static friction", "[eq:54][eq:59][eq:63][eq:66][eq:67]") {
    for (const Scene<double>& scene : scenes()) {
        const ModeSums<double> s = sums_of(scene);
        const double mu = 8; // static friction binds everywhere
        const Boundary<double> b = boundary(s, mu);
        CHECK(b.binding == BindingCondition::static_friction);
        CHECK(b.exact == b.approximate);
        const double beta = b.exact * (1 - 1e-12);
        const SteadyState<double> state = steady_state(s, b, beta);
        const std::size_t j = s.contact.index, N = s.R.size();
        const NonDimensionalMatrices m = matrices_of(scene);
        std::vector<double> C_j, K_j, x, v;
        for (std::size_t k = 0; k < N; ++k) {
            C_j.push_back(m.C(j, k));
            K_j.push_back(m.K(j, k));
            x.push_back(state.masses[k].x0);
            v.push_back(state.masses[k].v0);
        }
        double size = 1;
        for (std::size_t k = 0; k < N; ++k) size += std::abs(K_j[k] * x[k]) + std::abs(C_j[k] * v[k]);
        const double load =
            paper::contact_load(std::span<const double>(C_j), std::span<const double>(K_j), std::span<const double>(x),
                                std::span<const double>(v), s.load == s.contact ? 1 : 0, 0.0, state.phi_j);
        INFO(at(scene));
        CHECK(std::abs(load - mu * beta) < 1e-10 * size);
        // The boundary from the modes, (59) and (63), and from the sums, (66).
        double by_modes = 0, by_functions = 0;
        for (std::size_t i = 0; i < N; ++i) {
            const double psi_ji = mode_shapes_at(s, s.contact)[i], psi_li = mode_shapes_at(s, s.load)[i];
            const ModeInScene<double> mode{s.R[i], s.zeta[i], psi_ji, psi_li};
            const double eta_0 =
                psi_li * s.R[i] * s.R[i] * times_cosine(s.v[i], state.phi_j) - psi_ji * s.R[i] * s.R[i] * s.g[i] * beta;
            const double rate =
                -psi_li * s.R[i] * s.R[i] * times_sine(s.v[i], state.phi_j) - psi_ji * s.R[i] * s.R[i] * s.u[i] * beta;
            by_modes += psi_ji * paper::modal_contact_load(mode, InitialValues<double>{eta_0, rate}, std::cos(state.phi_j));
            by_functions += psi_ji * paper::modal_contact_load_by_functions(mode, eta_0, s.u[i], s.g[i], beta);
        }
        const double by_sums = paper::contact_load_at_start(state.X_j, s.G[j], s.H_j, beta);
        CHECK(std::abs(by_modes - load * s.sum_of_squares) < 1e-10 * size * s.sum_of_squares);
        CHECK(std::abs(by_functions - load * s.sum_of_squares) < 1e-10 * size * s.sum_of_squares);
        CHECK(std::abs(by_sums - load * s.sum_of_squares) < 1e-10 * size * s.sum_of_squares);
    }
}

TEST_CASE("every mode sees the same phase of the contact", "[eq:20][eq:26][eq:27][eq:60][eq:61][eq:62]") {
    for (const Scene<double>& scene : scenes()) {
        const ModeSums<double> s = sums_of(scene);
        const Boundary<double> b = boundary(s, scene.mu);
        const double beta = 0.75 * b.exact, h = 1e-4;
        const SteadyState<double> state = steady_state(s, b, beta);
        const NonDimensionalMatrices m = matrices_of(scene);
        for (std::size_t i = 0; i < s.R.size(); ++i) {
            const auto psi = [&](std::size_t k) { return mode_shapes_at(s, Mass{k})[i]; };
            const ModeInScene<double> mode{s.R[i], s.zeta[i], psi(s.contact.index), psi(s.load.index)};
            // The modal coordinate from the motion of the masses: (17) makes it psi^T M x.
            const auto modal = [&](const std::vector<double>& x) {
                double eta = 0;
                for (std::size_t k = 0; k < x.size(); ++k) eta += psi(k) * m.M(k, k) * x[k];
                return eta;
            };
            const auto at_tau = [&](double tau) { return motion(s, state, tau); };
            const InitialValues<double> start{modal(at_tau(0).x), modal(at_tau(0).x_prime)};
            const double size = 1 + std::abs(start.eta_0) + std::abs(start.eta_prime_0);
            const double v_cosine = paper::v_cosine(mode, start, s.g[i], beta), v_sine = paper::v_sine(mode, start, s.u[i], beta);
            const double tolerance = 1e-9 * (1 + modulus(s.v[i])) * size / std::abs(mode.psi_li * mode.R * mode.R);
            INFO(at(scene) << ", mode " << i + 1);
            CHECK(std::abs(v_cosine - times_cosine(s.v[i], state.phi_j)) < tolerance);
            CHECK(std::abs(v_sine - times_sine(s.v[i], state.phi_j)) < tolerance);
            CHECK(std::abs(paper::cosine_of_phase(mode, start, s.u[i], s.g[i], beta) - std::cos(state.phi_j)) <
                  tolerance * (1 + mode.R * mode.R));
            CHECK(std::cos(argument(s.v[i])) == Approx(paper::cosine_of_response_argument(s.v[i], mode.R)).margin(1e-14));
            CHECK(std::sin(argument(s.v[i])) ==
                  Approx(paper::sine_of_response_argument(s.v[i], mode.R, mode.zeta)).margin(1e-14));
            // (20) at an inner instant, the acceleration by differences of fourth order.
            const double tau = 1.25;
            const auto rate = [&](double t) { return modal(at_tau(t).x_prime); };
            const double acceleration =
                (8 * (rate(tau + h) - rate(tau - h)) - (rate(tau + 2 * h) - rate(tau - 2 * h))) / (12 * h);
            const double residual =
                paper::modal_equation_residual(modal(at_tau(tau).x), rate(tau), acceleration, tau, mode, beta, state.phi_j);
            CHECK(std::abs(residual) < 1e-6 * size / (mode.R * mode.R));
        }
    }
}

TEST_CASE("the demand tends to H_j with the friction jump added at the start and taken off at the end",
          "[eq:64][eq:65][eq:71][eq:72][limit]") {
    for (const Scene<double>& scene : scenes()) {
        const ModeSums<double> s = sums_of(scene);
        const double jump = s.sum_of_squares, size = std::abs(s.H_j) + jump;
        INFO(at(scene));
        CHECK(sliding_demand(s, 0.0) == Approx(paper::static_friction_demand(s.H_j, 1.0, jump)).epsilon(1e-13));
        CHECK(std::abs(sliding_demand(s, pi<double>()) - (s.H_j - jump)) < 1e-11 * size);
        const double h = 1e-5 * *s.R.begin();
        CHECK(std::abs(sliding_demand(s, std::min(h, 1e-5)) - sliding_demand(s, 0.0)) < 1e-2 * size);
    }
}

TEST_CASE("the three forms of the boundary keep their order", "[eq:56][eq:58][eq:67][eq:68][eq:69][eq:72]") {
    int strictly_below = 0, excluding = 0;
    for (const Scene<double>& scene : scenes_and_seeded_ones()) {
        const ModeSums<double> s = sums_of(scene);
        const Boundary<double> with_one = boundary(s, 1.0);
        if (with_one.paper < with_one.exact * (1 - 1e-9)) ++strictly_below;
        for (const double mu : {1.0, 1.375, 4.0, scene.mu}) {
            const Boundary<double> b = boundary(s, mu);
            const std::size_t j = s.contact.index;
            INFO(at(scene) << ", mu = " << mu);
            CHECK(b.S_exact <= b.S_paper * (1 + 1e-14));
            CHECK(b.paper <= b.exact * (1 + 1e-14));
            CHECK(b.exact <= b.approximate);
            CHECK(b.exact <= with_one.approximate);
            CHECK(b.S_exact == with_one.S_exact);
            CHECK(b.approximate == paper::friction_ratio_limit(s.V[j], s.U[j], s.H_j + mu * s.sum_of_squares));
            // (68), where it excludes anything, starts beyond (58): the two conditions are never met together.
            const double beyond = s.H_j - mu * s.sum_of_squares;
            if (beyond <= 0) continue;
            ++excluding;
            CHECK(paper::friction_ratio_limit(s.V[j], s.U[j], beyond) > paper::friction_ratio_limit(s.V[j], s.U[j], b.S_exact));
        }
    }
    CHECK(strictly_below > 0); // (56) as an equality would pass every check above
    CHECK(excluding > 0);
}

TEST_CASE("the condition that binds is named", "[eq:54]") {
    CHECK(boundary(sums_of(oscillator(0.125, 0.75)), 1.0).binding == BindingCondition::both);
    CHECK(boundary(sums_of(oscillator(0.125, 0.75)), 1.25).binding == BindingCondition::static_friction);
    CHECK(boundary(sums_of(oscillator(0, 0.3)), 1.0).binding == BindingCondition::velocity);
    CHECK(boundary(sums_of(oscillator(0, 0.3)), 4.0).binding == BindingCondition::static_friction);
}

TEST_CASE("no friction holds a contact with which the undamped rest of the system resonates", "[sticking][domain]") {
    // With mass 2 held, mass 1 between springs 1 and 3 has r = 2.
    const Scene<double> scene = chain({1, 1}, {1, 3}, {0, 0}, 2, 1, 1, 2);
    CHECK(stuck_system_resonates(sums_of(scene)));
    CHECK_FALSE(boundary(sums_of(scene), 1.0).sticking);
    CHECK(boundary(sums_of(chain({1, 1}, {1, 3}, {0, 0}, 2, 1, 1, 2.0625)), 1.0).sticking);
}

TEST_CASE("a contact that the load does not reach never slides", "[sticking][domain]") {
    // Load on mass 2, contact on mass 1: V = 0 nowhere; load on 1 and contact on 1 at the antiresonance of mass 2 alone.
    const Scene<double> scene = chain({1, 1}, {1, 1}, {0, 0}, 1, 1, 1, 1);
    CHECK(contact_is_unmoved(sums_of(scene)));
    const Boundary<double> b = boundary(sums_of(scene), 1.0);
    CHECK(b.exact == 0);
    CHECK(b.paper == 0);
    CHECK(b.approximate == 0);
}

TEST_CASE("next to a resonance without damping the demand is largest at the start, whatever the rounding next to it", "[eq:57]") {
    for (const double r : {0x1.fffffeefd9c0ep-1, 1 - 0x1p-30, 1 - 0x1p-40}) {
        const Boundary<double> b = boundary(sums_of(oscillator(0, r)), 1.0);
        INFO("r = " << hexadecimal(r) << ", S = " << hexadecimal(b.S_exact) << " at tau = " << hexadecimal(b.instant));
        CHECK(b.instant == 0);
        CHECK(std::abs(b.S_exact * r * r - 1) <= 4 * std::numeric_limits<double>::epsilon());
    }
}

TEST_CASE("next to a resonance without damping the largest demand is not lost in the rounding of the terms that it is left of",
          "[eq:57]") {
    // The worst scene of the survey of bounds: R of mode 2 is 1 - 2.7e-12, and the demand rises by 2.6e-4 up to tau = 0.025.
    const std::vector<double> gamma{1, 0x1.91e6248cdd26cp-3, 0x1.9f3a8f19fc0dp-2, 0x1.050acd13e4ee7p+0};
    const std::vector<double> kappa{1, 0x1.6b48fb0b08e5p-3, 0x1.31f33ebb7d2e3p-1, 0x1.128c467fc439ap+0};
    const Scene<double> scene = chain(gamma, kappa, {0, 0, 0, 0}, 2, 1, 1, 0x1.0ec2cbb675dd2p+0);
    const ModeSums<Bounded<double>> s = bounded_sums_of(scene);
    const ModeSums<double> values = values_of(s);
    const Bounded<double> found = found_by_search(sliding_demand(s, Bounded<double>(instant_of_largest_demand(values))));
    for (int n = 0; n <= 1000; ++n) {
        const double tau = n * 0x1p-14;
        INFO("tau = " << hexadecimal(tau));
        const Bounded<double> demand = sliding_demand(s, Bounded<double>(tau));
        CHECK(found.x + found.e >= demand.x - demand.e);
    }
    const Scene<Real50> wide = converted<Real50>(scene);
    const Real50 largest = boundary(sums_of(wide), Real50(1)).S_exact;
    CHECK(largest > (1 + 2e-4) * sliding_demand(sums_of(wide), Real50(0)));
    CHECK(abs(Real50(largest - found.x)) <= found.e);
}

TEST_CASE("a demand that turns next to its start is largest there, and one that rounding hides at the start", "[eq:57]") {
    const std::vector<double> none{0, 0, 0};
    for (const Scene<double>& scene :
         {chain({1, 2.2372964191745242}, {1, 2.3772894933895841}, {0, 0}, 1, 1, 1, 0.50382351684994353),  // tau = 0.0035
          chain({1, 2.205416712777112}, {1, 2.4116562963193604}, {0, 0}, 1, 1, 1, 0.50738028582494965),   // tau = 0.0034
          chain({1, 0.59136708639244551}, {1, 1.0120802713573855}, {0, 0}, 2, 1, 1, 0.73484381335256266), // tau = 0.0032
          chain({1, 0.543815680794136, 0.83530533756936487}, {1, 1.885695847766184, 0.47500823407857501}, none, 3, 1, 1,
                0.50734580465336165)}) { // tau = 0
        const ModeSums<double> s = sums_of(scene);
        const double found = sliding_demand(s, instant_of_largest_demand(s));
        double sampled = sliding_demand(s, 0.0);
        for (int n = 1; n <= 20'000; ++n) sampled = std::max(sampled, sliding_demand(s, n * 0x1p-21));
        for (int n = 1; n < 200; ++n) sampled = std::max(sampled, sliding_demand(s, n * 0x1p-6));
        INFO(at(scene) << ": " << hexadecimal(found) << ", sampled " << hexadecimal(sampled));
        CHECK(sampled <= found * (1 + 1e-12));
    }
}

TEST_CASE("the ratio of static to kinetic friction is checked", "[domain]") {
    const ModeSums<double> s = sums_of(three_masses());
    for (const double mu : {0.875, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_AS(boundary(s, mu), InputError);
}
