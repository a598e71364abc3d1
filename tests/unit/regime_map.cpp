#include "denhartog/map/regime_map.hpp"

#include <random>

#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/sampled_solution.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

const std::atomic<bool> never{false};

std::vector<double> values(double from, double to, int count) {
    std::vector<double> all;
    for (int n = 0; n < count; ++n) all.push_back(from + (to - from) * n / (count - 1));
    return all;
}

constexpr const char* proved_stops =
    "double precision does not tell whether the contact stops, and the reference proves that it does";

MapRequest request(int columns, int rows) {
    return {values(0.25, 2.25, columns), values(0, 1.125, rows), {Mass{1}, Mass{0}}, MapStart::rest, 1};
}

bool equal(const MapPoint& a, const MapPoint& b) {
    return a.status == b.status && a.regime == b.regime && a.stops == b.stops && a.periods == b.periods;
}

} // namespace

TEST_CASE("every point of a map is what solve answers there", "[map]") {
    for (const double mu : {1.0, 1.5}) {
        Scene<double> scene = equal_pair(1, {}, mu);
        const MapRequest grid = request(7, 7);
        const RegimeMap map = regime_map(scene, grid, never);
        REQUIRE(map.complete);
        int met[3] = {0, 0, 0};
        for (std::size_t point = 0; point < map.points.size(); ++point) {
            scene.r = grid.r[point / grid.beta.size()];
            scene.beta = grid.beta[point % grid.beta.size()];
            INFO("mu = " << mu << ", r = " << hexadecimal(*scene.r) << ", beta = " << hexadecimal(*scene.beta));
            const Solution s = solve(scene_source(scene), {Asked::amplitude, std::nullopt, false});
            REQUIRE(map.points[point].status == PointStatus::answered);
            CHECK(map.points[point].regime == s.regime.regime);
            ++met[static_cast<int>(s.regime.regime)];
            CHECK(map.points[point].stops == static_cast<int>(s.stops.size()));
            for (const std::size_t k : {0, 1})
                CHECK(map.amplitudes[2 * point + k] == Approx(s.masses[1 - k].amplitude.value).epsilon(1e-6).margin(1e-15));
        }
        CHECK(met[0] > 3);
        CHECK(met[1] > 3);
        CHECK(met[2] > 3);
    }
}

TEST_CASE("a map has the amplitude of any mass where solve answers a point, on a base that moves as well", "[map]") {
    const Scene<double> scene = named_scene("heavy on a base");
    const std::vector<double> r{0.0277}, beta{60, 91};
    for (const std::vector<Mass>& masses : {std::vector{Mass{0}}, std::vector{Mass{1}}, std::vector{Mass{1}, Mass{0}}}) {
        const RegimeMap map = regime_map(scene, {r, beta, masses, MapStart::rest, 1}, never);
        for (std::size_t n = 0; n < beta.size(); ++n) {
            REQUIRE(map.points[n].status == PointStatus::answered);
            const Solution s = solve(at_point(scene_source(scene), r[0], beta[n]), {Asked::amplitude, {}});
            for (std::size_t m = 0; m < masses.size(); ++m)
                CHECK(map.amplitudes[n * masses.size() + m] == Approx(s.amplitude(masses[m]).value).epsilon(1e-6));
        }
    }
}

TEST_CASE("a map of a system of which double has no modes is what solve answers, and has no motion with stops", "[map]") {
    const Scene<double> scene = named_scene("rigid");
    const MapRequest grid{{0.3, 0.9}, {0.3, 0.7, 1.1}, {Mass{0}, Mass{1}}, MapStart::rest, 1};
    const RegimeMap map = regime_map(scene, grid, never);
    std::size_t met[3] = {0, 0, 0};
    for (std::size_t point = 0; point < map.points.size(); ++point) {
        const SceneSource at = at_point(scene_source(scene), grid.r[point / 3], grid.beta[point % 3]);
        const Regime regime = solve(at, {Asked::regime, {}}).regime.regime;
        ++met[static_cast<std::size_t>(regime)];
        if (regime == Regime::stick_slip) {
            CHECK(map.points[point].status == PointStatus::failed);
            CHECK_THROWS_WITH(solve(at, {Asked::amplitude, {}}), Catch::Contains("no motion with stops to start from"));
            continue;
        }
        const Solution s = solve(at, {Asked::amplitude, {}});
        REQUIRE(map.points[point].status == PointStatus::answered);
        CHECK(map.points[point].regime == regime);
        for (const std::size_t k : {0, 1})
            CHECK(map.amplitudes[2 * point + k] == Approx(s.masses[k].amplitude.value).epsilon(1e-6));
    }
    CHECK(std::ranges::count(met, std::size_t(0)) == 0);
}

TEST_CASE("a little above the boundary, where no stop can be seen, solve, response and map have one word",
          "[map][solve][eq:69]") {
    Scene<double> scene =
        chain({1, 2.0946804396078478}, {1, 0.7414127923646818}, {0, 0}, 1, 2, 1, 0.143491911752667, 1.2404035292865214e-06);
    const Solution solved = solve(scene_source(scene), {}), responded = sliding_answer(scene_source(scene), Question{});
    CHECK(responded.regime.regime == Regime::stick_slip);
    CHECK(solved.regime.regime == Regime::stick_slip);
    CHECK_THAT(in_words(solved.regime.reason), Catch::Contains("is not below beta_lim"));
    // The reference proves the two stops, of 1.3e-7 of a radian, and the words say so.
    CHECK(solved.stops.size() == 2);
    CHECK_THAT(in_words(solved.regime.reason), Catch::Contains(proved_stops));
    CHECK_THAT(in_words(solved.method.why), Catch::Contains("double does not tell whether the contact stops"));
    const RegimeMap map = map_of_point(scene, {Mass{0}, Mass{1}});
    CHECK(map.points.front().regime == Regime::stick_slip);
    CHECK(map.points.front().stops == 2);
    CHECK(solve(scene_source(scene), {.digits = 30}).stops.size() == 2);
}

TEST_CASE("where static friction is hardly larger, stops too short for double are proved, or told as not seen",
          "[solve][eq:69]") {
    Scene<double> scene = chain({1, 2.0946804396078478}, {1, 0.7414127923646818}, {0.01, 0.02}, 1, 2, 1.0000001, 1.3,
                                0.20606163917974477); // 1e-14 above the boundary
    const Solution found = solve(scene_source(scene), {.digits = 10});
    CHECK(found.regime.regime == Regime::stick_slip);
    CHECK(found.stops.size() == 2);
    CHECK(found.regime.other.empty()); // whether double sees the stops is rounding
    CHECK(solve(scene_source(scene), {.digits = 20}).stops.size() == 2);
    scene.mu = 1.000000000001;
    scene.r = 0.1434919;
    scene.beta = 0.006821971779371876; // a last digit above the boundary
    const Solution shorter = solve(scene_source(scene), {.digits = 10});
    CHECK(shorter.regime.regime == Regime::stick_slip);
    CHECK(shorter.stops.size() == 2);
    CHECK_THAT(in_words(shorter.regime.reason), Catch::Contains(proved_stops));
    const RegimeMap map = map_of_point(scene, {Mass{0}, Mass{1}}, MapStart::sliding);
    CHECK(map.points.front().regime == Regime::stick_slip);
    // A millionth part above the boundary double sees the stops.
    scene.beta = 0.006821971779371876 * (1 + 1e-6);
    CHECK(solve(scene_source(scene), {.digits = 10}).stops.size() == 2);
    // More than 100 masses stay in double, if no digits are asked for.
    for (const std::size_t N : {81u, 201u}) {
        const bool seen = N == 81;
        const std::string words = seen ? "the reference proves that it does" : "the motion shows no stop";
        Scene<double> long_chain = equal_masses(N, 0.02, 1.7);
        long_chain.beta = boundary(sums_of(long_chain), 1.0).exact * (1 + 4e-15);
        const Solution next_to_boundary = solve(scene_source(long_chain), {});
        CHECK(next_to_boundary.regime.regime == Regime::stick_slip);
        CHECK(next_to_boundary.stops.size() == (seen ? 2 : 0));
        CHECK_THAT(in_words(next_to_boundary.regime.reason), Catch::Contains(words));
        long_chain.mu = 1 + 1e-12;
        long_chain.beta = boundary(sums_of(long_chain), long_chain.mu).exact * (1 + 4e-15);
        CHECK_THAT(in_words(solve(scene_source(long_chain), {Asked::regime, {}}).regime.reason), Catch::Contains(words));
        if (!seen) continue;
        CHECK_THAT(in_words(solve(scene_source(long_chain), {Asked::regime, 10}).regime.reason), Catch::Contains(words));
    }
}

TEST_CASE("of undamped masses too, every question and the map give the stops that double does not see", "[map][solve][eq:69]") {
    // The numbers next above the boundary. How double ends at a grazing motion is decided by last digits.
    Scene<double> two = chain({1, 1.3}, {1, 2}, {0, 0}, 1, 1, 1.0000004, 1.68, 0.7466884619918636);
    Scene<double> three = chain({1, 1.2, 0.9}, {1, 1, 0.125}, {0, 0, 0}, 3, 1, 1.0000004, 0.805, 0.1425443786621412);
    for (Scene<double> scene : {two, three}) {
        int unseen = 0;
        for (int n = 0; n < 6; ++n, scene.beta = std::nextafter(*scene.beta, 1.0)) {
            for (const Asked asked : {Asked::motion, Asked::amplitude, Asked::regime}) {
                const Solution found = solve(scene_source(scene), {asked, {}});
                CHECK(found.regime.regime == Regime::stick_slip);
                unseen += in_words(found.regime.reason).find(proved_stops) != std::string::npos;
            }
            const RegimeMap map = map_of_point(scene);
            CHECK(map.points.front().regime == Regime::stick_slip);
            CHECK(map.points.front().stops == 2);
        }
        CHECK(unseen >= 6);
    }
}

TEST_CASE("a question whose work is spent before the reference tells whether the contact stops is not answered by double",
          "[solve][effort][eq:69]") {
    // A last digit above the boundary: there are two stops, and double finds none.
    Scene<double> two = chain({1, 1.3}, {1, 2}, {0, 0}, 1, 1, 1.0000004, 1.68, 0.7466884619918636);
    for (const Asked asked : {Asked::motion, Asked::amplitude, Asked::regime}) {
        int spent = 0;
        for (const long allowed : {3'000L, 4'000L, 6'000L, 9'000L, 100'000L}) {
            INFO("allowed: " << allowed);
            QuestionEffort effort(2, allowed);
            try {
                const Regime found = solve(with_effort(scene_source(two), &effort), {asked, {}}).regime.regime;
                CHECK(found == Regime::stick_slip);
            } catch (const PrecisionError& e) {
                const std::string message = e.what();
                CHECK(message.find("double does not tell whether the contact stops") != std::string::npos);
                CHECK(message.find("the work allowed is spent") != std::string::npos);
                const bool is_told = message.find("This much is certain: the closed form does not hold") != std::string::npos;
                CHECK((is_told || message.find("As double sees it: the closed form does not hold") != std::string::npos));
                ++spent;
            }
        }
        CHECK(spent == 4);
    }
    // With mu = 1 or damping the boundaries tell that there are stops, and double may answer.
    Scene<double> damped =
        chain({1, 2.0946804396078478}, {1, 0.7414127923646818}, {0.01, 0.02}, 1, 2, 1.0000001, 1.3, 0.20606163917974474);
    QuestionEffort effort(2, 12'000);
    CHECK(solve(with_effort(scene_source(damped), &effort), {}).regime.regime == Regime::stick_slip);
}

TEST_CASE("next to the boundary the reference tells stops from rounding, to 6 digits as well as to 30, and in a map",
          "[map][solve][eq:69]") {
    // Below the boundary by its last digits: double finds two stops of 3e-14, or none to its error.
    Scene<double> scene = chain({1, 1, 1}, {1, 1, 1}, {0.05285095336413415, 0.0028521717634969056, 0.10552083675953965}, 2, 3,
                                1.0000000594993457, 0.11229068033770095, 0.014796804026255744);
    for (const std::optional<int> digits : std::vector<std::optional<int>>{{}, 10, 30})
        for (const Asked asked : {Asked::motion, Asked::amplitude, Asked::regime}) {
            const Solution s = solve(scene_source(scene), {asked, digits});
            INFO(in_words(s.regime.reason));
            CHECK(s.regime.regime == Regime::continuous);
            CHECK(s.stops.empty());
            CHECK(s.regime.other.empty());
            CHECK_THAT(in_words(s.regime.reason), Catch::Contains("the motion from rest is the sliding motion"));
        }
    for (const auto& [factor, regime, stops] : {std::tuple{1.0, Regime::continuous, 0}, {1 + 1e-6, Regime::stick_slip, 2}}) {
        const MapPoint at = map_of_point(with_beta(scene, *scene.beta * factor)).points.front();
        CHECK(at.regime == regime);
        CHECK(at.stops == stops);
    }
}

TEST_CASE("a last digit below permanent sticking no rest is taken for the motion", "[map][solve][eq:88]") {
    Scene<double> scene = chain({1, 0.75446287041036153, 0.90910697215540848, 0.56008440847893404},
                                {1, 0.73985774937320514, 0.98323358945340977, 0.50054355969969855},
                                {0.00020898467548437081, 0.010192329563089624, 0.39273080301693275, 6.4521664879332649e-05}, 1, 2,
                                1, 0.46925342893654237, 14.109761636448946);
    const Boundary<Real50> sure = boundary(sums_of(in_50_digits(scene, *scene.r)), Real50(1));
    CHECK(*sure.sticking > Real50(*scene.beta));
    CHECK(*sure.sticking < Real50(*scene.beta) * Real50(1 + 0x1p-48));
    CHECK(solve(scene_source(scene), {Asked::regime, {}}).regime.regime == Regime::stick_slip);
    CHECK_THROWS_AS(solve(scene_source(scene), {}), PrecisionError);
    const RegimeMap map = map_of_point(scene, {Mass{0}, Mass{1}});
    CHECK(map.points.front().status == PointStatus::on_boundary);
    CHECK(map.amplitudes[0] == 0);
    CHECK(map.amplitudes[1] > 0);
}

TEST_CASE("a map is the same to the last bit for any number of threads", "[map][threads]") {
    MapRequest grid = request(9, 12);
    const RegimeMap one = regime_map(equal_pair(1, {}, 1), grid, never);
    for (const unsigned threads : {2U, 5U}) {
        grid.threads = threads;
        const RegimeMap many = regime_map(equal_pair(1, {}, 1), grid, never);
        CHECK(std::ranges::equal(one.points, many.points, equal));
        CHECK(one.amplitudes == many.amplitudes);
    }
}

TEST_CASE("columns of a long map, which are prepared in parts, have the numbers of a map of their own", "[map]") {
    MapRequest grid{values(0.5, 2, 4100), {0.125}, {Mass{0}}, MapStart::rest, 1};
    const Scene<double> scene = named_scene(R"(one {"r": null, "beta": null})");
    const RegimeMap long_map = regime_map(scene, grid, never);
    CHECK(long_map.complete);
    for (const std::size_t first : {0UL, 4090UL}) {
        MapRequest part = grid;
        part.r = {grid.r.begin() + static_cast<std::ptrdiff_t>(first), grid.r.begin() + static_cast<std::ptrdiff_t>(first + 10)};
        const RegimeMap map = regime_map(scene, part, never);
        for (std::size_t n = 0; n < 10; ++n) {
            CHECK(equal(map.points[n], long_map.points[first + n]));
            CHECK(map.amplitudes[n] == long_map.amplitudes[first + n]);
        }
    }
}

TEST_CASE("a map costs one evaluation of the modes a column and one eigenproblem each for sliding and sticking", "[map]") {
    const long modes = mode_evaluations(), solves = eigen_solves();
    (void)regime_map(equal_pair(1, {}, 1), request(5, 40), never);
    CHECK(mode_evaluations() - modes == 5 * 2);
    CHECK(eigen_solves() - solves == 1);
}

TEST_CASE("a map that is stopped is not complete", "[map]") {
    const std::atomic<bool> stop{true};
    CHECK_FALSE(regime_map(equal_pair(1, {}, 1), request(5, 5), stop).complete);
}

TEST_CASE("from the sliding motion on the map shows the other branch where there are two", "[map]") {
    MapRequest grid{{1}, values(0, 0.75, 7), {Mass{0}}, MapStart::rest, 1};
    const Scene<double> scene = oscillator(0.05, 1, 2);
    const RegimeMap rest = regime_map(scene, grid, never);
    grid.start = MapStart::sliding;
    const RegimeMap sliding = regime_map(scene, grid, never);
    // Sticking is possible from 1/2 on, sliding up to 0.677.
    CHECK(rest.points[5].regime == Regime::permanent_sticking);
    CHECK(rest.amplitudes[5] == 0);
    CHECK(sliding.points[5].regime == Regime::continuous);
    CHECK(sliding.amplitudes[5] > 1);
    CHECK(sliding.points[1].regime == rest.points[1].regime);
}

TEST_CASE("at a pole and next to it a map has numbers where solve has: where the contact stops or rests",
          "[map][domain][solve]") {
    const double next = 1 + 3 * 0x1p-52; // 1 to the last digits
    const MapRequest grid{{0.75, 1, next}, {0.25, 0.875, 1.25}, {Mass{0}}, MapStart::rest, 1};
    const RegimeMap map = regime_map(oscillator(0, 1), grid, never);
    CHECK(map.points[0].status == PointStatus::answered);
    for (const std::size_t column : {1U, 2U}) {
        const auto point = [&](std::size_t row) { return map.points[3 * column + row]; };
        CHECK(point(0).status == PointStatus::at_a_pole);
        CHECK(std::isnan(map.amplitudes[3 * column]));
        for (const std::size_t row : {1U, 2U}) {
            REQUIRE(point(row).status == PointStatus::answered);
            CHECK(point(row).regime == (row == 1 ? Regime::stick_slip : Regime::permanent_sticking));
            const Scene<double> scene = oscillator(0, grid.r[column], 1, grid.beta[row]);
            const Solution proved = solve(scene_source(scene), {Asked::motion, {}, false, {}, true});
            CHECK(std::abs(map.amplitudes[3 * column + row] - proved.masses[0].amplitude.value) <= 1e-12);
            const Solution regime = solve(scene_source(scene), {Asked::regime, {}});
            CHECK_FALSE(in_words(regime.regime.reason).empty());
            CHECK_FALSE(regime.method.precision.empty());
        }
    }
    const auto curves = boundary_curves(oscillator(0, 1), {1, next});
    CHECK(curves[0].status == PointStatus::at_a_pole);
    REQUIRE(curves[1].status == PointStatus::answered);
    CHECK(std::abs(curves[1].exact - pi<double>() / 4) < 1e-12); // (69) for r = 1
    CHECK(solve(scene_source(oscillator(0, next, 1, 0.25)), {Asked::regime, {}}).regime.regime == Regime::continuous);
    CHECK_THROWS_AS(solve(scene_source(oscillator(0, next, 1, 0.25)), {Asked::amplitude, {}}), DomainError);
    const double below = 0x1.921fb54442d17p-1; // a last digit below pi / 4 the motion from rest comes to the sliding one
    CHECK_THROWS_AS(solve(scene_source(oscillator(0, 1 + 0x1p-52, 1, below)), {Asked::amplitude, {}}), DomainError);
}

TEST_CASE("at a pole and next to it a map from the sliding motion has numbers where the contact rests, if no motion slides",
          "[map][domain]") {
    const double next = 1 + 3 * 0x1p-52;
    const MapRequest grid{{1, next}, {0.25, 0.625, 0.875, 1.25}, {Mass{0}}, MapStart::sliding, 1};
    const RegimeMap map = regime_map(oscillator(0, 1, 2), grid, never);
    const auto status = [&](std::size_t column, std::size_t row) { return map.points[4 * column + row].status; };
    for (const std::size_t column : {0U, 1U}) {
        CHECK(status(column, 0) == PointStatus::at_a_pole);
        for (const std::size_t row : {2U, 3U}) { // beyond pi / 4
            CHECK(status(column, row) == PointStatus::answered);
            CHECK(map.points[4 * column + row].regime == Regime::permanent_sticking);
        }
    }
    CHECK(status(0, 1) == PointStatus::answered); // what slides grows for ever
    CHECK(status(1, 1) == PointStatus::at_a_pole);
}

TEST_CASE("next to a pole a motion that is refused is followed no oftener if all are asked for", "[solve][domain]") {
    const SceneSource scene = scene_source(oscillator(0, 1 + 3 * 0x1p-52, 1, 0.25));
    const auto phases_for = [&](bool all) {
        const long before = phases_propagated();
        CHECK_THROWS_AS(solve(scene, {Asked::motion, {}, all}), DomainError);
        return phases_propagated() - before;
    };
    CHECK(phases_for(true) == phases_for(false));
}

TEST_CASE("at a pole double is certain of stops that last longer than its rounding makes them", "[solve][domain]") {
    for (const auto& [above, certain] : {std::pair{1.3e-14, false}, {1e-12, true}}) { // pi / 4; stops of 5e-5 and of 2e-4
        const Scene<double> scene = oscillator(0, 1, 1, pi<double>() / 4 * (1 + above));
        const PreparedSystem prepared = prepare(scene_source(scene), {});
        const AnswerInDouble seen = answer_in_double(prepared, {1, *scene.beta, nullptr}, {});
        REQUIRE(seen.is_answered());
        CHECK(seen.value->stops.size() == 2);
        CHECK(seen.regime_is_certain == certain);
    }
}

TEST_CASE("at a pole stops that may be rounding are those of no motion: just below pi / 4 of the load it grows for ever",
          "[solve][domain]") {
    for (const double beta : {0x1.921fb54442d18p-1, 0x1.921fb54442d17p-1}) // next to pi / 4, from below
        for (const Asked asked : {Asked::regime, Asked::amplitude, Asked::motion})
            CHECK_THROWS_AS(solve(scene_source(oscillator(0, 1, 1, beta)), {asked, {}}), std::runtime_error);
    const Solution above = solve(scene_source(oscillator(0, 1, 1, 0x1.921fb54442d19p-1)), Question{});
    CHECK(above.method.proved);
    CHECK(above.stops.size() == 2);
}

TEST_CASE("boundary curves are the boundaries", "[map][eq:69]") {
    const std::vector<double> r = values(0.25, 2.25, 5);
    const std::vector<BoundaryPoint> curves = boundary_curves(equal_pair(1, {}, 1.5), r);
    for (std::size_t n = 0; n < r.size(); ++n) {
        Scene<double> scene = equal_pair(1, {}, 1.5);
        scene.r = r[n];
        const Boundary<double> b = boundary(sums_of(scene), 1.5);
        for (const auto& [found, expected] : {std::pair{curves[n].exact, b.exact},
                                              {curves[n].paper, b.paper},
                                              {curves[n].approximate, b.approximate},
                                              {curves[n].sticking.value(), *b.sticking}})
            CHECK(found == Approx(expected).epsilon(1e-14));
    }
}

TEST_CASE("boundary curves have the digits of the boundary where double loses them in the coordinates of the contact",
          "[map][eq:69]") {
    // Beside a spring of 1.8e13 the coordinates of the contact round one of 0.12.
    Scene<double> scene =
        chain({1, 1.0000000000108313, 1.000000000706512, 0.9999999531384343},
              {1, 177389.19778595105, 0.11988248417876002, 18121340966206.242},
              {4.8523357956642794e-17, 56299.81855532438, 2.3329965499772993, 75097.36041282877}, 2, 4, 1, 2.636037861397377);
    scene.system.contact_with = Mass{0};
    const BoundaryPoint at = boundary_curves(scene, {*scene.r}).front();
    REQUIRE(at.status == PointStatus::answered);
    const Solution s = sliding_answer(scene_source(scene), Question{Asked::regime, 15});
    CHECK(at.exact == Approx(s.limits->exact.value).epsilon(1e-6));
    CHECK(at.paper == Approx(s.limits->paper.value).epsilon(1e-6));
    // So have samples of the motion.
    scene.beta = s.limits->exact.value / 2;
    const Solution solved = solve(scene_source(scene), {});
    REQUIRE(solved.between);
    const std::vector<double> tau{-solved.between->phase->value};
    const Quantities<Bounded<double>> q = quantities(scene_source(scene), tau, 15, PointNumbers::motion).numbers;
    const State first = sampled_solution(scene_source(scene), solved, 1).at(0);
    for (std::size_t k = 0; k < 4; ++k) CHECK(first.x[k] == Approx(q.x[k].x).epsilon(1e-6));
}

TEST_CASE("a grid that breaks a rule is refused", "[map]") {
    const auto with = [](std::vector<double> r, std::vector<double> beta, std::vector<Mass> masses, unsigned threads) {
        return regime_map(equal_pair(1, {}, 1), {r, beta, masses, MapStart::rest, threads}, never);
    };
    for (const auto& [r, beta] :
         std::vector<std::pair<std::vector<double>, std::vector<double>>>{{{0}, {0.5}}, {{}, {0.5}}, {{1}, {-0.5}}, {{1}, {}}})
        CHECK_THROWS_AS(with(r, beta, {Mass{0}}, 1), InputError);
    CHECK_THROWS_AS(with({1}, {0.5}, {}, 1), InputError);
    CHECK_THROWS_AS(with({1}, {0.5}, {Mass{2}}, 1), InputError);
    CHECK_THROWS_AS(with({1}, {0.5}, {Mass{0}}, 0), InputError);
}

TEST_CASE("stretches that a column answers together have the numbers and the regimes of the boundary at every point",
          "[eq:38][eq:69][map]") {
    std::mt19937_64 random(38);
    std::uniform_real_distribution<double> unit(0, 1);
    long points = 0, near = 0, without = 0, untold = 0, regimes[3] = {};
    for (int n = 0; n < 12; ++n) {
        const double zeta = n % 4 == 0 ? 0.001 : std::exp2(-8 * unit(random) - 1);
        Scene<double> scene = n % 2 == 0 ? chain({1, 1 + unit(random)}, {1, 1 + unit(random)}, {zeta, zeta}, 2, 1, 1, 1)
                                         : chain({1}, {1}, {zeta}, 1, 1, 1, 1);
        const ModalBasis<double> basis = modal_basis(scene.system);
        MapRequest grid{{}, {}, {scene.system.contact}, MapStart::rest, 2};
        std::vector<Boundary<double>> boundaries;
        for (int m = 0; m < 8; ++m) {
            grid.r.push_back(0.4 + 2.2 * unit(random));
            boundaries.push_back(boundary(mode_sums(basis, scene.system.contact, scene.system.load, grid.r.back()), 1.0));
            for (const double factor : {0.5, 1 - 0x1p-36, 1 - 0x1p-50, 1 - 0x1p-53, 1.0, 1 + 0x1p-52, 1 + 0x1p-50, 1 + 0x1p-36})
                grid.beta.push_back(boundaries.back().exact * factor);
        }
        grid.beta.insert(grid.beta.end(), {0, 0.125, 0.75, std::nextafter(1, 0), 1, 1.5});
        std::ranges::sort(grid.beta);
        const RegimeMap map = regime_map(scene, grid, never);
        for (std::size_t m = 0; m < grid.r.size(); ++m) {
            const Boundary<Real50> sure = boundary(sums_of(in_50_digits(scene, grid.r[m])), Real50(1));
            for (std::size_t k = 0; k < grid.beta.size(); ++k) {
                const std::size_t point = m * grid.beta.size() + k;
                const double beta = grid.beta[k];
                INFO("r = " << hexadecimal(grid.r[m]) << ", beta = " << hexadecimal(beta) << ", zeta = " << hexadecimal(zeta));
                const Regime expected = regime_of(sure, Real50(beta));
                near += regime_at(with_rounding(boundaries[m]), beta).on_boundary; // the digits of double do not tell
                ++points;
                ++regimes[static_cast<int>(expected)];
                if (map.points[point].status == PointStatus::not_converged) {
                    CHECK(expected == Regime::stick_slip); // a motion that is a rest but for the last digit of beta
                    CHECK(beta == std::nextafter(1, 0));
                    ++without;
                    continue;
                }
                if (map.points[point].status == PointStatus::on_boundary) { // neither double nor a proof tells the motion
                    ++untold;
                    continue;
                }
                CHECK(map.points[point].status == PointStatus::answered);
                CHECK(map.points[point].regime == expected);
                if (expected == Regime::continuous) {
                    const ModeSums<double> sums = mode_sums(basis, scene.system.contact, scene.system.load, grid.r[m]);
                    const std::size_t j = sums.contact.index;
                    const double X_j =
                        evaluation::displacement_transmissibility_of_contact(sums.V[j], sums.U[j], sums.G[j], beta);
                    CHECK(map.amplitudes[point] == Approx(X_j).epsilon(1e-11).margin(1e-14 * modulus(sums.V[j])));
                }
            }
        }
    }
    INFO(points << " points, " << near << " on a boundary, " << without << " without a motion; " << regimes[0] << ", "
                << regimes[1] << ", " << regimes[2]);
    CHECK(near > 300);
    CHECK(untold < near / 100);
    for (const long each : regimes) CHECK(each > 500);
}
