// Arrays of points from C: the bytes of `map` and `solve`, wherever the caller wants them.
#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include "denhartog/c/denhartog.h"
#include "denhartog/denhartog.hpp"
#include "tests/conformance/c_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

const std::string chain = R"({"mass_ratios": [1, 2.5, 0.75], "stiffness_ratios": [1, 0.625, 1.875],
    "damping_ratios": [0.03, 0.06, 0.09], "contact": 2, "load": 1})";

bool same_bytes(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

Scene<double> at_point(const std::string& text, double r, double beta, double mu) {
    Scene<double> at = scene(text);
    at.r = r;
    at.beta = beta;
    at.mu = mu;
    return at;
}

// Points of a system with mu = 1; r and beta must outlive the request.
dh_points_request points_request(const std::vector<double>& r, const std::vector<double>& beta, std::ptrdiff_t beta_step) {
    auto request = sized<dh_points_request>();
    request.count = r.size();
    request.r = r.data();
    request.r_step = 1;
    request.beta = beta.data();
    request.beta_step = beta_step;
    request.mu = 1;
    return request;
}

// Points of so many systems.
dh_systems_request systems_request(std::size_t count, const dh_system* const* systems, const double* r, const double* beta,
                                   const double* mu) {
    auto request = sized<dh_systems_request>();
    request.count = count;
    request.systems = systems;
    request.r = r;
    request.beta = beta;
    request.mu = mu;
    request.system_step = request.r_step = request.beta_step = request.mu_step = 1;
    return request;
}

// Room for all numbers of so many points with so many masses each.
struct Points {
    std::vector<signed char> status, regime;
    std::vector<int> stops, periods;
    std::vector<double> amplitude, error, phase, phase_error;
    dh_points out;

    Points(std::size_t count, std::size_t masses, std::ptrdiff_t masses_step, std::ptrdiff_t mass_step)
        : status(count, 9), regime(status), stops(count, 9), periods(stops), amplitude(count * masses, 9), error(amplitude),
          phase(amplitude),
          phase_error(amplitude), out{sizeof out,  1,         status.data(),    regime.data(), stops.data(), periods.data(),
                                      masses_step, mass_step, amplitude.data(), error.data(),  phase.data(), phase_error.data()} {
    }

    // The numbers of a point are those of `solve`; where the system does not have a mass they are none.
    void check(std::size_t n, const Scene<double>& at, const std::vector<std::size_t>& masses) const {
        const Solution s = solve(at, {Asked::phase, 9});
        CHECK(status[n] == DH_POINT_ANSWERED);
        CHECK(regime[n] == static_cast<signed char>(s.regime.regime));
        CHECK(stops[n] == static_cast<int>(s.stops.size()));
        CHECK(periods[n] == s.periods);
        for (std::size_t m = 0; m < masses.size(); ++m) {
            const std::size_t place = n * static_cast<std::size_t>(out.masses_step) + m * static_cast<std::size_t>(out.mass_step);
            const bool exists = masses[m] <= s.masses.size();
            CHECK(std::isnan(amplitude[place]) == !exists);
            CHECK(std::isnan(error[place]) == !exists);
            if (!exists) continue;
            const SolvedMass& mass = s.masses[masses[m] - 1];
            CHECK(std::abs(amplitude[place] - mass.amplitude.value) <= error[place] + mass.amplitude.error);
            CHECK(std::isnan(phase[place]) == !mass.phase);
            if (mass.phase) CHECK(std::abs(phase[place] - mass.phase->value) <= phase_error[place] + mass.phase->error);
        }
    }
};

int stop_at_once(size_t, size_t, void* calls) {
    ++*static_cast<int*>(calls);
    return 1;
}

} // namespace

TEST_CASE("dh_map writes the bytes of the map, with any steps and on any number of threads", "[c_interface]") {
    const Handle system = handle_of(chain);
    const std::vector<double> r{0.25, 0.5, 1.125, 2.5}, beta{0, 0.15625, 0.5, 0.75, 40};
    for (const double mu : {1.0, 1.25}) {
        Scene<double> at = scene(chain);
        at.mu = mu;
        const RegimeMap map = denhartog::map(at, r, beta);
        for (const unsigned threads : {1U, 3U}) {
            dh_map_request request = map_request(r, beta, mu);
            request.threads = threads;
            std::vector<signed char> status(20, 9), regime(40, 9);
            std::vector<int> stops(20, 9), periods(20, 9);
            std::vector<double> amplitude(60, -1);
            auto result = sized<dh_map_result>();
            result.r_step = 1; // beta runs slowest here
            result.beta_step = 4;
            result.status = status.data();
            result.stops = stops.data();
            result.periods = periods.data();
            result.amplitude_r_step = 5;
            result.amplitude_beta_step = 1;
            result.mass_step = 20;
            result.amplitude = amplitude.data();
            REQUIRE(dh_map(system.get(), &request, &result) == DH_OK);
            for (std::size_t m = 0; m < 4; ++m)
                for (std::size_t n = 0; n < 5; ++n) {
                    const MapPoint& point = map.points[m * 5 + n];
                    CHECK(status[n * 4 + m] == static_cast<signed char>(point.status));
                    CHECK(stops[n * 4 + m] == point.stops);
                    CHECK(periods[n * 4 + m] == point.periods);
                    for (std::size_t k = 0; k < 3; ++k)
                        CHECK(same_bytes(amplitude[m * 5 + n + k * 20], map.amplitudes[(m * 5 + n) * 3 + k]));
                }
            dh_map_result regimes{}; // alone, every other element
            regimes.size = sizeof regimes;
            regimes.r_step = 10;
            regimes.beta_step = 2;
            regimes.regime = regime.data();
            REQUIRE(dh_map(system.get(), &request, &regimes) == DH_OK);
            for (std::size_t n = 0; n < 20; ++n) {
                CHECK(regime[2 * n] == static_cast<signed char>(map.points[n].regime));
                CHECK(regime[2 * n + 1] == 9);
            }
        }
    }
}

TEST_CASE("dh_solve_points has the numbers of dh_solve", "[c_interface]") {
    const Handle system = handle_of(chain);
    const std::vector<double> r{0.5, 1.125, 1.125, 0.3}, beta{0.75, 0.15625, 0.6, 40};
    const size_t masses[] = {3, 2};
    dh_points_request request = points_request(r, beta, 1);
    request.digits = 9;
    request.mass_count = 2;
    request.masses = masses;
    request.threads = 2;
    const Points found(4, 2, 2, 1);
    REQUIRE(dh_solve_points(system.get(), &request, &found.out) == DH_OK);
    for (std::size_t n = 0; n < 4; ++n) found.check(n, at_point(chain, r[n], beta[n], 1), {3, 2});
    request.r_step = request.beta_step = 0; // one point four times
    REQUIRE(dh_solve_points(system.get(), &request, &found.out) == DH_OK);
    for (std::size_t n = 2; n < 8; ++n) CHECK(same_bytes(found.amplitude[n], found.amplitude[n % 2]));
}

TEST_CASE("dh_solve_systems has the numbers of dh_solve for the system of each point", "[c_interface]") {
    const std::string two =
        R"({"mass_ratios": [1, 1], "stiffness_ratios": [1, 1], "damping_ratios": 0.05, "contact": 2, "load": 1})";
    const std::string one = R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.25, "contact": 1, "load": 1})";
    const Handle handles[] = {handle_of(chain), handle_of(two), handle_of(one)};
    const dh_system* const systems[] = {handles[0].get(), handles[1].get(), handles[2].get(), handles[1].get(), handles[0].get()};
    const double r[] = {1.125, -1, 0.75, -1, 0.5, -1, 0.75, -1, 1.125}, beta[] = {0.15625, 0.5, 0.25, 40, 0.6};
    const double mu[] = {1, 1.25, 1, 1, 1.375};
    dh_systems_request request = systems_request(5, systems, r, beta, mu);
    request.r_step = 2;
    request.digits = 9;
    const Points found(5, 3, 1, 5); // mass after mass
    std::vector<double> of_one_thread;
    for (const unsigned threads : {1U, 3U}) {
        request.threads = threads;
        REQUIRE(dh_solve_systems(&request, &found.out) == DH_OK);
        if (threads == 1) of_one_thread = found.amplitude;
    }
    for (std::size_t n = 0; n < 15; ++n) CHECK(same_bytes(found.amplitude[n], of_one_thread[n]));
    for (std::size_t n = 0; n < 5; ++n) {
        const std::string& text = systems[n] == handles[0].get() ? chain : systems[n] == handles[1].get() ? two : one;
        found.check(n, at_point(text, r[2 * n], beta[n], mu[n]), {1, 2, 3});
    }
    CHECK(std::set<int>(found.regime.begin(), found.regime.end()).size() == 3); // they are all met
    const size_t first = 1;
    request.masses = &first;
    request.mass_count = 1;
    std::vector<double> of_first(5, 9);
    const dh_points points{sizeof points,   0,       nullptr, nullptr, nullptr, nullptr, 1, 0,
                           of_first.data(), nullptr, nullptr, nullptr};
    REQUIRE(dh_solve_systems(&request, &points) == DH_OK);
    for (std::size_t n = 0; n < 5; ++n) CHECK(of_first[n] == Approx(found.amplitude[n]).epsilon(1e-9));
}

TEST_CASE("what is wrong with the points of many systems is told by name, and nothing is written", "[c_interface][bad-input]") {
    const Handle system = handle_of(chain);
    const dh_system* const systems[] = {system.get(), system.get(), nullptr};
    const double r[] = {0.5, 0.5, 0.5}, beta[] = {0.75, -1, 0.75}, mu[] = {1, 1, 0.5};
    const size_t masses[] = {4};
    std::vector<int> stops(200, 9);
    auto points = sized<dh_points>();
    points.step = 1;
    points.stops = stops.data();
    const dh_systems_request request = systems_request(1, systems, r, beta, mu);
    const auto fault = [&](const dh_systems_request& asked) {
        const int status = dh_solve_systems(&asked, &points);
        CHECK(status != DH_OK);
        return std::to_string(status) + " " + dh_last_message();
    };
    const auto changed = [&](const auto& change) {
        dh_systems_request other = request;
        change(other);
        return fault(other);
    };
    CHECK_THAT(changed([](auto& q) { q.size = 8; }), Catch::Contains("2 request->size"));
    CHECK_THAT(changed([](auto& q) { q.count = 0; }), Catch::Contains("2 request->count"));
    CHECK_THAT(changed([](auto& q) { q.systems = nullptr; }), Catch::Contains("1 request->systems"));
    CHECK_THAT(changed([](auto& q) { q.mu = nullptr; }), Catch::Contains("1 request->mu"));
    CHECK_THAT(changed([](auto& q) { q.count = 2; }), Catch::Contains("3 beta") && Catch::Contains("-1"));
    CHECK_THAT(changed([](auto& q) { q.count = 3, q.beta_step = 0; }), Catch::Contains("3 mu") && Catch::Contains("0.5"));
    CHECK_THAT(changed([](auto& q) { q.count = 3, q.beta_step = q.mu_step = 0; }), Catch::Contains("1 request->systems[2]"));
    CHECK_THAT(changed([&](auto& q) { q.masses = masses, q.mass_count = 1; }),
               Catch::Contains("3 masses") && Catch::Contains("from 1 to 3"));
    CHECK_THAT(changed([](auto& q) { q.digits = 16; }), Catch::Contains("3 digits"));
    int calls = 0;
    CHECK_THAT(changed([&](auto& q) {
                   q.count = 200, q.system_step = q.r_step = q.beta_step = q.mu_step = 0;
                   q.progress = stop_at_once, q.context = &calls;
               }),
               Catch::Contains("5 cancelled"));
    CHECK(calls == 1);
    CHECK(stops == std::vector<int>(200, 9));
    REQUIRE(dh_solve_systems(&request, &points) == DH_OK);
    CHECK(stops[0] >= 0);
}

TEST_CASE("the contact of two masses that rub against each other has its own amplitude in C", "[c_interface]") {
    for (const std::string contact : {"[1, 3]", "2"}) {
        const std::string text = chain.substr(0, chain.find("\"contact\"")) + "\"contact\": " + contact + ", \"load\": 1}";
        const Handle system = handle_of(text);
        const Answered solution = solved(system.get(), 1.125, 0.0625, 1);
        const dh_mass found = contact_of(solution.get());
        const Solution s = solve(at_point(text, 1.125, 0.0625, 1));
        const SolvedMass& expected = s.between ? *s.between : s.masses[1];
        CHECK(s.between.has_value() == (contact != "2"));
        CHECK(same_bytes(found.amplitude, expected.amplitude.value));
        CHECK(same_bytes(found.phase, expected.phase.value().value));
    }
}

TEST_CASE("a report of progress ends a call, and nothing is written", "[c_interface]") {
    const Handle system = handle_of(chain);
    const std::vector<double> r(100, 0.5), beta{0.75};
    int calls = 0;
    dh_map_request request = map_request(r, beta, 1);
    request.progress = stop_at_once;
    request.context = &calls;
    request.threads = 1;
    std::vector<int> stops(100, 9);
    auto result = sized<dh_map_result>();
    result.r_step = 1;
    result.stops = stops.data();
    CHECK(dh_map(system.get(), &request, &result) == DH_ERROR_PRECISION);
    CHECK_THAT(dh_last_message(), Catch::Contains("cancelled"));
    CHECK(calls == 1);
    CHECK(stops == std::vector<int>(100, 9));
    dh_points_request at = points_request(r, beta, 0);
    at.progress = stop_at_once;
    at.context = &calls;
    auto points = sized<dh_points>();
    points.step = 1;
    points.stops = stops.data();
    CHECK(dh_solve_points(system.get(), &at, &points) == DH_ERROR_PRECISION);
    CHECK(stops == std::vector<int>(100, 9));
}

TEST_CASE("what is wrong with arrays of points is told by name", "[c_interface][bad-input]") {
    const Handle system = handle_of(chain);
    const std::vector<double> r{0.5, -1}, beta{0.75};
    auto result = sized<dh_map_result>();
    const auto fault = [&](const dh_map_request& request) {
        const int status = dh_map(system.get(), &request, &result);
        CHECK(status != DH_OK);
        return std::to_string(status) + " " + dh_last_message();
    };
    CHECK_THAT(fault(map_request(r, beta, 1)), Catch::Contains("3 ") && Catch::Contains("-1"));
    CHECK_THAT(fault(map_request({}, beta, 1)), Catch::Contains("2 request->r_count"));
    CHECK_THAT(fault(map_request({0.5}, beta, 0.5)), Catch::Contains("3 mu"));
    dh_map_request request = map_request(beta, beta, 1);
    const size_t masses[] = {4};
    request.masses = masses;
    request.mass_count = 1;
    CHECK_THAT(fault(request), Catch::Contains("3 masses") && Catch::Contains("from 1 to 3"));
    request.beta = nullptr;
    CHECK_THAT(fault(request), Catch::Contains("1 request->beta"));
    request.size = 8;
    CHECK_THAT(fault(request), Catch::Contains("2 request->size"));
}
