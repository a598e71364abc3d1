// Arrays of points from C: the bytes of `map` and `solve`, wherever the caller wants them.
#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "denhartog/c/denhartog.h"
#include "denhartog/denhartog.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

using SystemHandle = std::unique_ptr<dh_system, decltype(&dh_system_destroy)>;

const std::string chain = R"({"mass_ratios": [1, 2.5, 0.75], "stiffness_ratios": [1, 0.625, 1.875],
    "damping_ratios": [0.03, 0.06, 0.09], "contact": 2, "load": 1})";

SystemHandle system_of(const std::string& text) {
    dh_system* made = nullptr;
    REQUIRE(dh_system_from_json(text.data(), text.size(), &made) == DH_OK);
    return {made, dh_system_destroy};
}

bool same_bytes(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

dh_map_request request_of(const std::vector<double>& r, const std::vector<double>& beta, double mu) {
    dh_map_request request{};
    request.size = sizeof request;
    request.r_count = r.size();
    request.r = r.data();
    request.beta_count = beta.size();
    request.beta = beta.data();
    request.mu = mu;
    return request;
}

int stop_at_once(size_t, size_t, void* calls) {
    ++*static_cast<int*>(calls);
    return 1;
}

} // namespace

TEST_CASE("dh_map writes the bytes of the map, with any steps and on any number of threads", "[c_interface]") {
    const SystemHandle system = system_of(chain);
    const std::vector<double> r{0.25, 0.5, 1.125, 2.5}, beta{0, 0.15625, 0.5, 0.75, 40};
    for (const double mu : {1.0, 1.25}) {
        Scene<double> at = scene(chain);
        at.mu = mu;
        const RegimeMap map = denhartog::map(at, r, beta);
        for (const unsigned threads : {1U, 3U}) {
            dh_map_request request = request_of(r, beta, mu);
            request.threads = threads;
            std::vector<signed char> status(20, 9), regime(40, 9);
            std::vector<int> stops(20, 9), periods(20, 9);
            std::vector<double> amplitude(60, -1);
            dh_map_result result{};
            result.size = sizeof result;
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
    const SystemHandle system = system_of(chain);
    const std::vector<double> r{0.5, 1.125, 1.125, 0.3}, beta{0.75, 0.15625, 0.6, 40};
    const size_t masses[] = {3, 2};
    std::vector<signed char> regime(4);
    std::vector<int> stops(4);
    std::vector<double> amplitude(8), error(8), phase(8), phase_error(8);
    dh_points_request request{};
    request.size = sizeof request;
    request.count = 4;
    request.r = r.data();
    request.beta = beta.data();
    request.r_step = request.beta_step = 1;
    request.mu = 1;
    request.digits = 9;
    request.mass_count = 2;
    request.masses = masses;
    request.threads = 2;
    dh_points points{};
    points.size = sizeof points;
    points.step = 1;
    points.regime = regime.data();
    points.stops = stops.data();
    points.masses_step = 2;
    points.mass_step = 1;
    points.amplitude = amplitude.data();
    points.error = error.data();
    points.phase = phase.data();
    points.phase_error = phase_error.data();
    REQUIRE(dh_solve_points(system.get(), &request, &points) == DH_OK);
    for (std::size_t n = 0; n < 4; ++n) {
        Scene<double> at = scene(chain);
        at.r = r[n];
        at.beta = beta[n];
        const Solution s = solve(at, {Asked::phase, 9});
        CHECK(regime[n] == static_cast<signed char>(s.regime.regime));
        CHECK(stops[n] == static_cast<int>(s.stops.size()));
        for (std::size_t m = 0; m < 2; ++m) {
            const SolvedMass& mass = s.masses[masses[m] - 1];
            CHECK(std::abs(amplitude[2 * n + m] - mass.amplitude.value) <= error[2 * n + m] + mass.amplitude.error);
            CHECK(std::isnan(phase[2 * n + m]) == !mass.phase);
            if (mass.phase) CHECK(std::abs(phase[2 * n + m] - mass.phase->value) <= phase_error[2 * n + m] + mass.phase->error);
        }
    }
    request.r_step = request.beta_step = 0; // one point four times
    REQUIRE(dh_solve_points(system.get(), &request, &points) == DH_OK);
    for (std::size_t n = 2; n < 8; ++n) CHECK(same_bytes(amplitude[n], amplitude[n % 2]));
}

TEST_CASE("the contact of two masses that rub against each other has its own amplitude in C", "[c_interface]") {
    for (const std::string contact : {"[1, 3]", "2"}) {
        const std::string text = chain.substr(0, chain.find("\"contact\"")) + "\"contact\": " + contact + ", \"load\": 1}";
        const SystemHandle system = system_of(text);
        dh_solution* made = nullptr;
        REQUIRE(dh_solve(system.get(), 1.125, 0.0625, 1, 0, &made) == DH_OK);
        const std::unique_ptr<dh_solution, decltype(&dh_solution_destroy)> solution(made, dh_solution_destroy);
        dh_mass found{};
        found.size = sizeof found;
        REQUIRE(dh_solution_contact(made, &found) == DH_OK);
        Scene<double> at = scene(text);
        at.r = 1.125;
        at.beta = 0.0625;
        const Solution s = solve(at);
        const SolvedMass& expected = s.between ? *s.between : s.masses[1];
        CHECK(s.between.has_value() == (contact != "2"));
        CHECK(same_bytes(found.amplitude, expected.amplitude.value));
        CHECK(same_bytes(found.phase, expected.phase.value().value));
    }
}

TEST_CASE("a report of progress ends a call, and nothing is written", "[c_interface]") {
    const SystemHandle system = system_of(chain);
    const std::vector<double> r(100, 0.5), beta{0.75};
    int calls = 0;
    dh_map_request request = request_of(r, beta, 1);
    request.progress = stop_at_once;
    request.context = &calls;
    request.threads = 1;
    std::vector<int> stops(100, 9);
    dh_map_result result{};
    result.size = sizeof result;
    result.r_step = 1;
    result.stops = stops.data();
    CHECK(dh_map(system.get(), &request, &result) == DH_ERROR_PRECISION);
    CHECK_THAT(dh_last_message(), Catch::Contains("cancelled"));
    CHECK(calls == 1);
    CHECK(stops == std::vector<int>(100, 9));
    dh_points_request at{};
    at.size = sizeof at;
    at.count = 100;
    at.r = r.data();
    at.r_step = 1;
    at.beta = beta.data();
    at.mu = 1;
    at.progress = stop_at_once;
    at.context = &calls;
    dh_points points{};
    points.size = sizeof points;
    points.step = 1;
    points.stops = stops.data();
    CHECK(dh_solve_points(system.get(), &at, &points) == DH_ERROR_PRECISION);
    CHECK(stops == std::vector<int>(100, 9));
}

TEST_CASE("what is wrong with arrays of points is told by name", "[c_interface][bad-input]") {
    const SystemHandle system = system_of(chain);
    const std::vector<double> r{0.5, -1}, beta{0.75};
    dh_map_result result{};
    result.size = sizeof result;
    const auto fault = [&](const dh_map_request& request) {
        const int status = dh_map(system.get(), &request, &result);
        CHECK(status != DH_OK);
        return std::to_string(status) + " " + dh_last_message();
    };
    CHECK_THAT(fault(request_of(r, beta, 1)), Catch::Contains("3 ") && Catch::Contains("-1"));
    CHECK_THAT(fault(request_of({}, beta, 1)), Catch::Contains("2 request->r_count"));
    CHECK_THAT(fault(request_of({0.5}, beta, 0.5)), Catch::Contains("3 mu"));
    dh_map_request request = request_of(beta, beta, 1);
    const size_t masses[] = {4};
    request.masses = masses;
    request.mass_count = 1;
    CHECK_THAT(fault(request), Catch::Contains("3 masses") && Catch::Contains("from 1 to 3"));
    request.beta = nullptr;
    CHECK_THAT(fault(request), Catch::Contains("1 request->beta"));
    request.size = 8;
    CHECK_THAT(fault(request), Catch::Contains("2 request->size"));
}
