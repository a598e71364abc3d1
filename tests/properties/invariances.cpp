#include <cmath>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::tests;
using namespace denhartog;

// Changes of a scene that leave its response as it is, over seeded random systems.

namespace {

constexpr std::uint64_t seed_of_invariances = 117085;

/// Random scenes without equal or nearly equal natural frequencies, by their matrices, with beta inside the boundary.
std::vector<RandomScene<double>> scenes_by_matrices() {
    std::vector<RandomScene<double>> all;
    int n = 0;
    for (RandomScene<double> random : random_scenes<double>(seed_of_invariances)) {
        if (++n % 4 != 0) continue;
        System<double>& s = random.scene.system;
        const Eigen::Index N = static_cast<Eigen::Index>(number_of_masses(s));
        const NonDimensionalMatrices m = matrices_of(random.scene);
        if (s.mass_matrix.size() == 0) s.mass_matrix = Eigen::Map<Eigen::VectorXd>(s.mass_ratios.data(), N).asDiagonal();
        s.mass_ratios.clear();
        s.stiffness_ratios.clear();
        s.stiffness_matrix = m.K;
        random.scene.beta = friction_ratio_at(random.fraction_of_limit, boundary(sums_of(random.scene), random.scene.mu).exact);
        all.push_back(random);
    }
    return all;
}

void check_same(const Response<double>& a, const Response<double>& b, const std::vector<std::size_t>& place, double scale,
                const std::string& name) {
    INFO(name);
    CHECK(a.boundary.exact == Approx(b.boundary.exact).epsilon(1e-8));
    CHECK(a.boundary.paper == Approx(b.boundary.paper).epsilon(1e-8));
    REQUIRE((a.steady_state && b.steady_state));
    for (std::size_t k = 0; k < place.size(); ++k) {
        const MassResponse<double>&p = a.steady_state->masses[k], q = b.steady_state->masses[place[k]];
        INFO("mass " << k + 1 << ": " << hexadecimal(p.amplitude) << " and " << hexadecimal(q.amplitude));
        CHECK(p.amplitude == Approx(scale * q.amplitude).epsilon(1e-8));
        CHECK(std::abs(p.x0 - scale * q.x0) < 1e-8 * p.amplitude);
        CHECK(std::abs(std::remainder(p.phase_monoharmonic - q.phase_monoharmonic, 2 * pi<double>())) < 1e-6);
    }
}

std::vector<std::size_t> in_order(std::size_t N) {
    std::vector<std::size_t> place(N);
    for (std::size_t k = 0; k < N; ++k) place[k] = k;
    return place;
}

} // namespace

TEST_CASE("masses can be numbered in any order", "[eq:1][eq:6]") {
    for (const RandomScene<double>& random : scenes_by_matrices()) {
        const std::size_t N = number_of_masses(random.scene.system);
        std::vector<std::size_t> place; // in reverse order
        for (std::size_t k = 0; k < N; ++k) place.push_back(N - 1 - k);
        Scene<double> other = random.scene;
        System<double>& s = other.system;
        s.mass_matrix = random.scene.system.mass_matrix.reverse().eval();
        s.stiffness_matrix = random.scene.system.stiffness_matrix.reverse().eval();
        if (s.damping_matrix.size() > 0) s.damping_matrix = random.scene.system.damping_matrix.reverse().eval();
        s.contact = Mass{place[s.contact.index]};
        s.load = Mass{place[s.load.index]};
        check_same(response(random.scene), response(other), place, 1, random.name);
    }
}

TEST_CASE("masses four times heavier at half the frequency move the same, springs four times stiffer at twice it a quarter",
          "[eq:5][eq:7][eq:10]") {
    for (const RandomScene<double>& random : scenes_by_matrices()) {
        Scene<double> heavier = random.scene, stiffer = random.scene;
        heavier.system.mass_matrix *= 4;
        *heavier.r /= 2;
        stiffer.system.stiffness_matrix *= 4;
        *stiffer.r *= 2;
        for (Scene<double>* each : {&heavier, &stiffer})
            if (each->system.damping_matrix.size() > 0) each->system.damping_matrix *= 2;
        const std::vector<std::size_t> place = in_order(number_of_masses(heavier.system));
        check_same(response(random.scene), response(heavier), place, 1, random.name);
        check_same(response(random.scene), response(stiffer), place, 4, random.name);
    }
}

TEST_CASE("a mass that hangs on the ground alone changes nothing", "[eq:33][eq:34][eq:35]") {
    for (const RandomScene<double>& random : scenes_by_matrices()) {
        if (random.scene.system.damping_matrix.size() > 0) continue;
        const Eigen::Index N = static_cast<Eigen::Index>(number_of_masses(random.scene.system));
        const ModalBasis<double> basis = modal_basis(random.scene.system);
        Scene<double> other = random.scene;
        System<double>& s = other.system;
        s.mass_matrix.conservativeResizeLike(Eigen::MatrixXd::Zero(N + 1, N + 1));
        s.stiffness_matrix.conservativeResizeLike(Eigen::MatrixXd::Zero(N + 1, N + 1));
        s.mass_matrix(N, N) = 1;
        s.stiffness_matrix(N, N) = 4 * basis.r_n.back() * basis.r_n.back(); // its mode comes last
        s.damping_ratios.push_back(0.125);
        const Response<double> with = response(other);
        check_same(response(random.scene), with, in_order(static_cast<std::size_t>(N)), 1, random.name);
        CHECK(with.steady_state->masses.back().amplitude < 1e-12);
    }
}

TEST_CASE("many oscillations in a half-period do not hide the largest", "[eq:57][eq:47][maximum]") {
    for (const double r : {0.02, 0.0201, 0.0303})
        for (const double zeta : {0.0, 0.0009765625}) {
            Scene<double> scene = chain({1, 2.5, 0.75}, {1, 0.625, 1.875}, {zeta, zeta, zeta}, 2, 1, 1, r);
            const ModeSums<double> s = sums_of(scene);
            const Boundary<double> b = boundary(s, scene.mu);
            double demand = 0;
            for (int n = 1; n < 100000; ++n) demand = std::max(demand, sliding_demand(s, pi<double>() * n / 100000));
            INFO("r = " << hexadecimal(r) << ", zeta = " << hexadecimal(zeta));
            CHECK(demand <= b.S_exact * (1 + 1e-10));
            CHECK(demand >= b.S_exact * (1 - 1e-2));
            const SteadyState<double> state = steady_state(s, b, 0.5 * b.exact);
            for (std::size_t k = 0; k < 3; ++k) {
                const double sampled = largest_sample(s, state, k, 20000);
                CHECK(sampled <= state.masses[k].amplitude * (1 + 1e-12));
                CHECK(sampled >= state.masses[k].amplitude * (1 - 1e-4));
            }
        }
}
