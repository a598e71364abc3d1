#include <denhartog.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <thread>
#include <vector>

#include "denhartog/solve/sampled_solution.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/conformance/c_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

// Numbers with their bounds, of which one lot is proved: they have to overlap.
void check_within(const std::vector<double>& proved, const std::vector<double>& proved_errors, const std::vector<double>& plain,
                  const std::vector<double>& plain_errors) {
    REQUIRE(proved.size() == plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
        INFO("number " << i << ": " << hexadecimal(proved[i]) << " proved, and " << hexadecimal(plain[i]));
        CHECK(std::abs(proved[i] - plain[i]) <= proved_errors[i] + plain_errors[i]);
        CHECK(proved_errors[i] <= 1e-15 * std::max(1.0, std::abs(proved[i]))); // of the double, and its rounding alone
    }
}

bool is_proved(const dh_solution* solution) {
    int proved = -1;
    REQUIRE(dh_solution_is_proved(solution, &proved) == DH_OK);
    REQUIRE((proved == 0 || proved == 1));
    return proved == 1;
}

// Amplitudes, phases, instants of stops and the interval of rest, and the bounds of their errors.
std::array<std::vector<double>, 2> numbers_with_bounds(const dh_solution* solution, std::size_t N) {
    std::vector<double> values, errors;
    for (std::size_t k = 0; k <= N; ++k) {
        const dh_mass mass = k == 0 ? contact_of(solution) : mass_of(solution, k);
        values.insert(values.end(), {mass.amplitude, mass.phase});
        errors.insert(errors.end(), {mass.error, mass.phase_error});
    }
    const dh_summary all = summary_of(solution);
    values.insert(values.end(), {all.rest_from, all.rest_to});
    errors.insert(errors.end(), {all.rest_error, all.rest_error});
    std::vector<double> start(all.stops), end = start;
    for (const auto& [of, lot] : {std::pair{&dh_solution_stops, &values}, std::pair{&dh_solution_stop_errors, &errors}}) {
        REQUIRE(of(solution, all.stops, start.data(), end.data()) == DH_OK);
        lot->insert(lot->end(), start.begin(), start.end());
        lot->insert(lot->end(), end.begin(), end.end());
    }
    return {values, errors};
}

} // namespace

TEST_CASE("the load that the C interface tells is a loaded mass, whichever the contact takes the place of",
          "[c_interface][vectors]") {
    for (const std::string contact : {"[1, 2]", "[2, 1]"})
        for (const std::string masses : {"[1, 0.5, 2]", "[1, 2, 2]"})
            for (const std::size_t loaded : {1, 2, 3}) {
                const std::string text = R"({"mass_ratios": )" + masses +
                                         R"(, "stiffness_ratios": [1, 1, 1], "damping_ratios": 0.05, "contact": )" + contact +
                                         R"(, "load": )" + std::to_string(loaded) + "}";
                const Handle system = handle_of(text);
                std::size_t N = 0, first = 0, load = 0;
                REQUIRE(dh_system_masses(system.get(), &N, &first, &load) == DH_OK);
                INFO(text);
                CHECK((N == 3 && first == static_cast<std::size_t>(contact[1] - '0') && load == loaded));
            }
}

TEST_CASE("the modes that the C interface hands out have their digits beside a light mass", "[c_interface][eq:15]") {
    const std::string text = R"({"mass_matrix": [[1, 0, 0], [0, 2.1, 0], [0, 0, 1e-13]],
        "stiffness_matrix": [[1.9, -0.1, -0.8], [-0.1, 1.1, -0.3], [-0.8, -0.3, 2.2]], "damping_ratios": 0.01, "contact": 1,
        "load": 2})";
    const Handle system = handle_of(text);
    System<double> condensed;
    condensed.mass_matrix = Matrix<double>{{1, 0}, {0, 2.1}};
    condensed.stiffness_matrix = Matrix<double>{{1.9 - 0.64 / 2.2, -0.1 - 0.24 / 2.2}, {-0.1 - 0.24 / 2.2, 1.1 - 0.09 / 2.2}};
    condensed.damping_ratios = {0.01, 0.01};
    const ModalBasis<double> basis = modal_basis(condensed);
    std::vector<double> r_n(3), psi(9), R(3), v(6), u(3), g(3);
    REQUIRE(dh_natural_frequency_ratios(system.get(), 3, r_n.data(), nullptr) == DH_OK);
    REQUIRE(dh_mode_shapes(system.get(), 1, 9, psi.data()) == DH_OK);
    REQUIRE(dh_modal_functions(system.get(), 0.5, 3, R.data(), v.data(), u.data(), g.data()) == DH_OK);
    const ModeSums<double> sums = mode_sums(basis, Mass{0}, Mass{1}, 0.5);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(r_n[i] == Approx(basis.r_n[i]).epsilon(1e-6));
        CHECK(u[i] == Approx(sums.u[i]).epsilon(1e-6));
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(psi[3 * k + i] == Approx(basis.phi(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i))).epsilon(1e-6));
    }
}

TEST_CASE("what the C interface solves is what the library solves, in every regime", "[c_interface][solve]") {
    std::array<int, 3> met{};
    for (const Scene<double>& scene : c_scenes()) {
        const Handle system = handle_of(scene.system);
        const Solution expected = solve(scene_source(scene), Question{});
        const Answered solution = solved(system.get(), *scene.r, *scene.beta, scene.mu);
        const dh_summary all = summary_of(solution.get());
        CHECK(all.regime == static_cast<int>(expected.regime.regime));
        CHECK(all.unique == expected.unique);
        CHECK(all.symmetric == expected.symmetric);
        CHECK(all.periods == expected.periods);
        CHECK(all.relative_error == expected.relative_error);
        ++met[static_cast<std::size_t>(all.regime)];
        const std::size_t N = scene.system.mass_ratios.size();
        REQUIRE(all.stops == expected.stops.size());
        REQUIRE(all.rest_interval_exists == expected.rest_interval.has_value());
        if (expected.rest_interval)
            check_same({all.rest_from, all.rest_to}, {expected.rest_interval->from.value, expected.rest_interval->to.value});
        std::vector<double> start(all.stops), end(all.stops), starts, ends, of_starts, of_ends;
        REQUIRE(dh_solution_stops(solution.get(), all.stops, start.data(), end.data()) == DH_OK);
        for (const SolvedStop& stop : expected.stops) {
            starts.push_back(stop.start.value);
            ends.push_back(stop.end.value);
            of_starts.push_back(stop.start.error);
            of_ends.push_back(stop.end.error);
        }
        check_same(start, starts);
        check_same(end, ends);
        REQUIRE(dh_solution_stop_errors(solution.get(), all.stops, start.data(), end.data()) == DH_OK);
        check_same(start, of_starts);
        check_same(end, of_ends);
        for (std::size_t k = 0; k < N; ++k) {
            const SolvedMass& m = expected.masses[k];
            const dh_mass mass = mass_of(solution.get(), k + 1);
            CHECK(mass.moves == m.phase.has_value());
            check_same({mass.amplitude, mass.phase}, {m.amplitude.value, m.phase ? m.phase->value : 0});
            CHECK(mass.error >= m.amplitude.error);
        }
        constexpr std::size_t samples = 16;
        std::vector<double> x(samples * N), v(samples * N), xs, vs;
        REQUIRE(dh_solution_motion(solution.get(), samples, samples * N, x.data(), v.data()) == DH_OK);
        for (const State& state : sampled_solution(scene_source(scene), expected, samples).states()) {
            xs.insert(xs.end(), state.x.begin(), state.x.end());
            vs.insert(vs.end(), state.x_prime.begin(), state.x_prime.end());
        }
        check_same(x, xs);
        check_same(v, vs);
    }
    for (const int each : met) CHECK(each > 0);
}

TEST_CASE("a proved solution from C is the other one within both bounds, in every regime, and says that it is proved",
          "[c_interface][solve][reference]") {
    std::array<int, 3> met{};
    for (const Scene<double>& scene : c_scenes()) {
        const Handle system = handle_of(scene.system);
        const std::size_t N = scene.system.mass_ratios.size();
        const Answered plain = solved(system.get(), *scene.r, *scene.beta, scene.mu);
        CHECK_FALSE(is_proved(plain.get()));
        dh_solution* made = nullptr;
        const int status = dh_solve_proved(system.get(), *scene.r, *scene.beta, scene.mu, 0, &made);
        const Answered proved(made);
        dh_boundary limits{}, errors{}, plain_limits{}, plain_errors{};
        for (dh_boundary* each : {&limits, &errors, &plain_limits, &plain_errors}) each->size = sizeof limits;
        const int of_limits = dh_boundaries_proved(system.get(), *scene.r, scene.mu, &limits, &errors);
        INFO(dh_last_message());
        REQUIRE(status == DH_OK);
        REQUIRE(of_limits == DH_OK);
        CHECK(is_proved(proved.get()));
        const dh_summary all = summary_of(proved.get()), expected = summary_of(plain.get());
        CHECK((all.regime == expected.regime && all.stops == expected.stops && all.periods == expected.periods));
        CHECK((all.symmetric == expected.symmetric && all.unique == expected.unique));
        ++met[static_cast<std::size_t>(all.regime)];
        const auto [values, bounds] = numbers_with_bounds(proved.get(), N);
        const auto [plain_values, plain_bounds] = numbers_with_bounds(plain.get(), N);
        check_within(values, bounds, plain_values, plain_bounds);

        REQUIRE(dh_boundaries(system.get(), *scene.r, scene.mu, &plain_limits) == DH_OK);
        REQUIRE(dh_boundary_errors(system.get(), *scene.r, scene.mu, &plain_errors) == DH_OK);
        CHECK(limits.sticking_exists == plain_limits.sticking_exists);
        const auto numbers = [](const dh_boundary& b) {
            return std::vector<double>{b.exact, b.paper, b.approximate, b.sticking};
        };
        check_within(numbers(limits), numbers(errors), numbers(plain_limits), numbers(plain_errors));

        std::vector<double> x(8 * N), expected_x(8 * N); // the samples of a proved solution are there as well
        REQUIRE(dh_solution_motion(proved.get(), 8, x.size(), x.data(), nullptr) == DH_OK);
        REQUIRE(dh_solution_motion(plain.get(), 8, x.size(), expected_x.data(), nullptr) == DH_OK);
        for (std::size_t n = 0; n < x.size(); ++n) CHECK(x[n] == Approx(expected_x[n]).epsilon(1e-6).margin(1e-6));
    }
    for (const int each : met) CHECK(each > 0);
}

TEST_CASE("the sampled motion starts at the maximum of the force, the closed form at the maximum of the contact",
          "[c_interface][eq:39]") {
    const Scene<double> scene = c_scenes().front();
    const Handle system = handle_of(scene.system);
    const Answered solution = solved(system.get(), *scene.r, *scene.beta, scene.mu);
    const std::size_t N = scene.system.mass_ratios.size(), j = scene.system.contact.index + 1, samples = 8;
    const dh_mass contact = mass_of(solution.get(), j);
    std::vector<double> x(samples * N), tau(samples), closed(samples);
    REQUIRE(dh_solution_motion(solution.get(), samples, samples * N, x.data(), nullptr) == DH_OK);
    for (std::size_t n = 0; n < samples; ++n) tau[n] = 2 * std::numbers::pi * static_cast<double>(n) / 8 - contact.phase;
    REQUIRE(dh_displacement(system.get(), *scene.r, *scene.beta, scene.mu, j, samples, tau.data(), closed.data()) == DH_OK);
    for (std::size_t n = 0; n < samples; ++n) CHECK(x[n * N + j - 1] == Approx(closed[n]).margin(1e-12));
}

TEST_CASE("a system from JSON is the system from its ratios, whatever point the text has", "[c_interface][scene]") {
    const std::string text = R"({"mass_ratios":[1,2.5],"stiffness_ratios":[1,0.625],"damping_ratios":[0.0625,0.125],)"
                             R"("contact":2,"load":1,"mu":1.25,"r":1.125,"beta":0.125})";
    const Handle from_text = handle_of(text), from_ratios = handle_of(chain_of({1, 2.5}, {1, 0.625}, {0.0625, 0.125}, 2, 1));
    std::size_t N = 0, contact = 0, load = 0;
    REQUIRE(dh_system_masses(from_text.get(), &N, &contact, &load) == DH_OK);
    CHECK((N == 2 && contact == 2 && load == 1));
    CHECK(amplitudes(from_text.get(), 1.125, 0.125, 1.0) == amplitudes(from_ratios.get(), 1.125, 0.125, 1.0));
    CHECK(amplitudes(from_text.get(), 1.125, 0.125, 1.25) == amplitudes(from_ratios.get(), 1.125, 0.125, 1.25));
}

TEST_CASE("threads that share a system and threads with one each find what one thread finds", "[c_interface][threads]") {
    const std::vector<Scene<double>> scenes = c_scenes();
    std::vector<std::vector<double>> expected;
    std::vector<Handle> shared;
    for (const Scene<double>& scene : scenes) {
        shared.push_back(handle_of(scene.system));
        expected.push_back(amplitudes(shared.back().get(), *scene.r, *scene.beta, scene.mu));
    }
    constexpr std::size_t threads = 16;
    std::vector<std::size_t> agreed(threads), kept(threads);
    std::vector<std::thread> running;
    for (std::size_t t = 0; t < threads; ++t)
        running.emplace_back([&, t] {
            const std::string fault = std::to_string(100 + t);
            double limit = 0;
            for (std::size_t i = 0; i < scenes.size(); ++i) {
                const Scene<double>& scene = scenes[(i + t) % scenes.size()];
                if (dh_high_frequency_limit(shared[0].get(), -100.0 - static_cast<double>(t), &limit) != DH_ERROR_INPUT) return;
                const Handle own = t % 2 == 0 ? nullptr : handle_of(scene.system);
                const dh_system* system = own ? own.get() : shared[(i + t) % scenes.size()].get();
                agreed[t] += amplitudes(system, *scene.r, *scene.beta, scene.mu) == expected[(i + t) % scenes.size()];
                kept[t] += std::string(dh_last_message()).find("-" + fault) != std::string::npos;
            }
        });
    for (std::thread& thread : running) thread.join();
    for (std::size_t t = 0; t < threads; ++t) {
        CHECK(agreed[t] == scenes.size());
        CHECK(kept[t] == scenes.size()); // each thread has its own message
    }
}
