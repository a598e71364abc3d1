#include "denhartog/solve/solve.hpp"
#include "denhartog/solve/sampled_solution.hpp"

#include <random>

#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

Solution asking(const Scene<double>& scene, Asked asked, std::optional<int> digits = std::nullopt) {
    return solve(scene_source(scene), {asked, digits, false});
}

Solution asking(const std::string& scene, Asked asked, std::optional<int> digits = std::nullopt) {
    return asking(named_scene(scene), asked, digits);
}

// The work of an answer: never more for fewer digits.
long total(const Work& w) { return w.eigen_solves + w.mode_evaluations + w.phases_propagated; }

} // namespace

TEST_CASE("fewer digits never cost more work", "[solve]") {
    std::vector<double> ones(40, 1), zeta;
    for (int i = 0; i < 40; ++i) zeta.push_back(0.125 + i / 64.0);
    for (const Scene<double>& scene :
         {chain(ones, ones, zeta, 5, 1, 1, 0.02, 0x1p-15), oscillator(0.0625, 1.5, 1, 0.25), oscillator(0.0625, 0.25, 1, 0.5)}) {
        std::vector<Work> works;
        for (const int digits : {2, 4, 6, 12}) works.push_back(asking(scene, Asked::amplitude, digits).work);
        for (std::size_t n = 1; n < works.size(); ++n) {
            INFO("N = " << number_of_masses(scene.system) << ", step " << n);
            CHECK(works[n - 1].eigen_solves <= works[n].eigen_solves);
            CHECK(works[n - 1].mode_evaluations <= works[n].mode_evaluations);
            CHECK(works[n - 1].phases_propagated <= works[n].phases_propagated);
        }
    }
    const Work of_chain = asking(chain(ones, ones, zeta, 5, 1, 1, 0.02, 0x1p-15), Asked::amplitude, 6).work;
    CHECK(of_chain.mode_evaluations == 40);
    CHECK(of_chain.eigen_solves == 1);
    const Scene<double> slides = oscillator(0.0625, 1.5, 1, 0.25), stops = oscillator(0.0625, 0.25, 1, 0.5);
    CHECK(total(asking(slides, Asked::amplitude, 6).work) == 1);
    CHECK(asking(slides, Asked::regime, 6).work.phases_propagated == 0);
    CHECK(asking(stops, Asked::regime, 6).work.phases_propagated <= asking(stops, Asked::amplitude, 6).work.phases_propagated);
}

TEST_CASE("between the boundaries the exact solver answers, to 30 digits as well as to 6", "[solve][eq:74][eq:75]") {
    const Scene<double> scene = equal_pair(0.5, 0.5);
    const Solution low = asking(scene, Asked::motion, 6), high = asking(scene, Asked::motion, 30);
    REQUIRE(low.regime.regime == Regime::stick_slip);
    CHECK(low.method.model == "exact solver");
    CHECK(low.method.precision == "double");
    CHECK(high.method.precision == "reference");
    REQUIRE(low.stability);
    CHECK(low.stability->stable);
    REQUIRE(low.stops.size() == high.stops.size());
    CHECK_FALSE(low.stops.empty());
    for (std::size_t n = 0; n < low.stops.size(); ++n) {
        CHECK(std::abs(low.stops[n].start.value - high.stops[n].start.value) < 1e-10);
        CHECK(std::abs(low.stops[n].end.value - high.stops[n].end.value) < 1e-10);
        CHECK(low.stops[n].end.value > low.stops[n].start.value);
    }
    check_masses_within(low, high);
    for (const SolvedMass& mass : high.masses)
        CHECK(mass.amplitude.error < 1e-29 * mass.amplitude.value); // the rounding of 30 decimals is in it
    const Solution proved = asking(scene, Asked::motion, 60);
    CHECK(proved.method.proved);
    for (std::size_t k = 0; k < 2; ++k) check_agree(proved.masses[k].amplitude, high.masses[k].amplitude);
}

TEST_CASE("instants at which stops begin and end keep their bounds, and these are of use", "[solve][accuracy][eq:74][eq:75]") {
    std::mt19937_64 random(20221117);
    const auto between = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    std::vector<double> over; // the bounds over the errors
    double largest = 0;
    while (over.size() < 200) {
        std::vector<double> masses{1}, stiffnesses{1}, zeta{between(0.01, 0.2)};
        const std::size_t N = 1 + random() % 3;
        while (masses.size() < N) {
            masses.push_back(between(0.3, 3));
            stiffnesses.push_back(between(0.3, 3));
            zeta.push_back(between(0.01, 0.2));
        }
        const int contact = static_cast<int>(1 + random() % N), load = static_cast<int>(1 + random() % N);
        Scene<double> scene = chain(masses, stiffnesses, zeta, contact, load, random() % 3 == 0 ? between(1, 1.5) : 1.0,
                                    std::exp(between(-2.5, 1)));
        scene.beta = std::exp(between(-3, 0));
        const Solution low = asking(scene, Asked::motion, 6);
        if (low.stops.empty()) continue;
        const Solution high = asking(scene, Asked::motion, 25);
        REQUIRE(low.stops.size() == high.stops.size());
        for (std::size_t n = 0; n < low.stops.size(); ++n)
            for (const auto instant : {&SolvedStop::start, &SolvedStop::end}) {
                const Certified &found = low.stops[n].*instant, &exact = high.stops[n].*instant;
                const double error = std::abs(std::remainder(found.value - exact.value, 2 * pi<double>() * low.periods));
                INFO(scene.beta.value() << ", stop " << n + 1 << ": " << found.value << " +- " << found.error << ", exactly "
                                        << exact.value);
                CHECK(error <= found.error + exact.error);
                largest = std::max(largest, found.error);
                over.push_back(found.error / std::max(error, 1e-18));
            }
    }
    std::ranges::sort(over);
    CHECK(over.front() < 100); // a bound as much smaller would be broken
    CHECK(largest < 1e-7);
}

TEST_CASE("where the contact only just stops, the bound says that the instant is not known, and the reference knows it",
          "[solve][accuracy][grazing]") {
    Scene<double> scene = oscillator(0.01, 0.2, 1, 0.4337367682256968); // some last digits higher two of the four stops are gone
    const ContactSystem system = contact_system(scene.system);
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    Solution found;
    set_motion_of_orbit(scene, {}, solver, periodic_orbit(solver, at_rest(1), {}), found);
    const std::vector<SolvedStop>& in_double = found.stops;
    REQUIRE(in_double.size() == 4);
    CHECK(in_double[0].start.error == Approx(pi<double>()));
    CHECK(in_double[1].end.error == Approx(pi<double>()));
    CHECK(in_double[1].start.error < 1e-12);
    const Solution proved = asking(scene, Asked::motion, 6);
    CHECK(proved.method.precision == "reference");
    REQUIRE(proved.stops.size() == 4);
    CHECK(in_double[1].start.value == Approx(proved.stops[1].start.value).epsilon(1e-13));
    for (const SolvedStop& stop : proved.stops) CHECK(std::max(stop.start.error, stop.end.error) < 1e-15);
    scene.beta = 0.43373676822569696;
    CHECK(asking(scene, Asked::motion, 6).stops.size() == 2);
    CHECK(asking(scene, Asked::motion, 20).stops.size() == 2);
}

TEST_CASE("a contact that rests gives the stuck response and the interval of rest", "[solve][eq:88]") {
    const Scene<double> scene = equal_pair(0.75, 3);
    const Solution s = asking(scene, Asked::motion);
    REQUIRE(s.regime.regime == Regime::permanent_sticking);
    // The first mass between two springs of 1, its damping the diagonal entry of (19).
    const NonDimensionalMatrices m = matrices_of(scene);
    const std::complex<double> X = 1.0 / std::complex<double>(m.K(0, 0) - m.M(0, 0), m.C(0, 0));
    CHECK(s.masses[0].amplitude.value == Approx(std::abs(X)).epsilon(1e-13));
    CHECK(s.masses[0].phase->value == Approx(-std::arg(X)).epsilon(1e-13));
    CHECK(s.masses[1].amplitude.value == 0);
    CHECK_FALSE(s.masses[1].phase);
    // At the end of the interval static friction carries the load and the contact's springs in series, 1 over 2.
    const double load = std::abs((m.K(1, 0) + std::complex<double>(0, m.C(1, 0))) * X);
    REQUIRE(s.rest_interval);
    CHECK(s.rest_interval->to.value == Approx((3 - load) * 2).epsilon(1e-12));
    CHECK(s.rest_interval->from.value == -s.rest_interval->to.value);
    CHECK(s.work.phases_propagated == 0);
    const Solution more = asking(scene, Asked::amplitude, 20);
    CHECK(more.method.precision == "reference");
    CHECK(more.masses[0].amplitude.value == Approx(std::abs(X)).epsilon(1e-13));
}

TEST_CASE("masses behind a contact that rests do not move, in any number of digits", "[solve][eq:88]") {
    for (const std::optional<int> digits : {std::optional<int>(), std::optional(18), std::optional(40)}) {
        const Solution held = asking("eight", Asked::motion, digits);
        CHECK(held.regime.regime == Regime::permanent_sticking);
        CHECK(held.digits_reached);
        CHECK(held.method.precision == (digits ? "reference" : "double"));
        for (std::size_t k = 2; k < 8; ++k) {
            CHECK(held.masses[k].amplitude.value <= held.masses[k].amplitude.error);
            CHECK(held.masses[k].amplitude.error < 1e-44);
            CHECK_FALSE(held.masses[k].phase);
        }
        CHECK(held.masses[0].amplitude.value > 0.1);
    }
}

TEST_CASE("where double loses the springs that hold the contact, 50 digits bound the interval of rest", "[solve][eq:88]") {
    // Beside the spring of 2^40 the contact's own, 2^-40, is lost: the matrix of double is singular.
    const double stiff = 0x1p40, soft = 0x1p-40, mu = 1.25;
    Scene<double> scene = chain({1, stiff, 1, 1}, {1, soft, soft, stiff}, {0.5, 0.5, 0.5, 0.5}, 3, 3, mu, 2.1, 64);
    const double half = (64 * mu - 1) * (1 + 2 * stiff); // the springs to the wall in series
    for (const Asked asked : {Asked::motion, Asked::amplitude}) {
        const Solution s = asking(scene, asked);
        REQUIRE(s.rest_interval);
        CHECK(s.method.precision == "reference");
        CHECK(std::abs(s.rest_interval->to.value - half) <= s.rest_interval->to.error + 1e-16 * half);
        CHECK(s.rest_interval->to.error <= 1e-6 * half);
    }
}

TEST_CASE("damping made from modes far apart keeps its bound at a contact that rests", "[solve][eq:19][eq:88][accuracy]") {
    // Mass 4 moves by what damping alone brings to it, through entries of (19) that rounding makes 1e11 times as large.
    Scene<double> scene = chain({1, 86732.13364453071, 471299635721.2514, 6.012947084168863e-09}, {1, 0x1p-40, 0x1p-40, 0x1p40},
                                {1.0000000000000004, 1.0000744419158798, 0.9999999988688767, 1.000000002590393}, 3, 2, 1,
                                15.403547107133631, 0.5404485080277784);
    const Solution truth = solve(scene_source(scene), {.digits = 60});
    CHECK(truth.method.proved);
    Solution held;
    set_stuck_response(scene, stuck_configuration(scene.system, modal_basis(scene.system)),
                       with_errors(scene.system, modal_basis(scene.system)), std::nullopt, held);
    for (const std::size_t k : {0u, 1u, 3u}) {
        const Certified &found = held.masses[k].amplitude, &true_value = truth.masses[k].amplitude;
        INFO("mass " << k + 1 << ": " << found.value << " +- " << found.error);
        CHECK(std::abs(found.value - true_value.value) <= found.error + 1e-16 * true_value.value);
    }
}

TEST_CASE("where double does not tell whether a motion is stable, the reference does", "[solve][orbit]") {
    const Solution s = asking("stable or not", Asked::motion);
    CHECK(s.method.precision == "reference");
    CHECK_THAT(in_words(s.method.why), Catch::Contains("double does not tell whether the motion is stable"));
    REQUIRE(s.stability);
    CHECK(s.stability->stable);
    CHECK(s.stability->multipliers.front().value + s.stability->multipliers.front().error < 1);
    CHECK(asking("stable or not", Asked::phase).method.precision == "double");
}

TEST_CASE("a list with one unit load has the (88) of that load", "[solve][eq:88]") {
    for (const auto& [contact, load, list] : {std::tuple{1, 2, "[0, 1, 0, 0]"}, std::tuple{4, 3, "[0, 0, 1, 0]"}}) {
        const auto by_88 = [contact = contact](const std::string& text) {
            return *asking(read_scene<double>(R"({"mass_ratios": [1, 1, 2, 1], "stiffness_ratios": [1, 1, 1, 3], "r": 0.5,
                "damping_ratios": 0.05, "beta": 50, "contact": )" +
                                              std::to_string(contact) + R"(, "load": )" + text + "}"),
                           Asked::regime)
                        .sticking_by_88;
        };
        CHECK(by_88(list).value == by_88(std::to_string(load)).value);
        CHECK(by_88(list).error == by_88(std::to_string(load)).error);
    }
}

TEST_CASE("a motion without stops is the sliding motion where a mode hardly moves, and where double sees it not mirror itself",
          "[solve][eq:38]") {
    const Scene<double> fast = oscillator(0, 45, 1.71, 0.000764);
    for (const Scene<double>& scene : {named_scene("hardly moving mode"), fast}) {
        const Solution s = asking(scene, Asked::motion);
        CHECK(s.regime.regime == Regime::continuous);
        CHECK(s.method.model == "closed form");
    }
    const Solution s = asking(fast, Asked::motion), exact = asking(fast, Asked::motion, 20);
    CHECK(s.symmetric);
    check_within(s.masses[0].amplitude, exact.masses[0].amplitude);
    CHECK(in_words(exact.regime.reason).find("not that of the closed form") == std::string::npos);
}

TEST_CASE("with mu above 1 the answer is that of the start from rest and is not called unique", "[solve]") {
    const Scene<double> scene = oscillator(0.05, 1, 2, 0.55);
    const Solution s = asking(scene, Asked::motion);
    CHECK(s.regime.regime == Regime::permanent_sticking);
    CHECK(std::ranges::find(s.regime.other, Regime::continuous) != s.regime.other.end());
    CHECK_FALSE(s.unique);
    CHECK(s.rest_interval->rests_at->value == 0);
    CHECK(asking(scene, Asked::regime).regime.regime == Regime::permanent_sticking);
    // Below the boundary of sticking the start from rest slides into the closed form.
    const Scene<double> below = oscillator(0.05, 1, 2, 0.25);
    const Solution t = asking(below, Asked::motion);
    CHECK(t.regime.regime == Regime::continuous);
    CHECK(t.method.model == "closed form");
    CHECK(t.work.phases_propagated > 0);
    REQUIRE(t.stability);
    CHECK(t.stability->stable);
    CHECK(t.masses[0].amplitude.value == Approx(response(below).steady_state->X_j).epsilon(1e-14));
}

TEST_CASE("a steady motion that is certain is the answer where that from rest is not known, and says so",
          "[solve][eq:69][eq:88]") {
    struct Case {
        Scene<double> scene;
        Regime regime;
        const char* model;
    };
    const std::vector<Case> cases{
        {chain({1, 0.631}, {1, 1.56}, {0, 0}, 1, 2, 3, 1.41, 0.2401), Regime::continuous, "closed form"},
        {chain({1, 1.434}, {1, 0.374}, {1e-6, 1e-6}, 2, 1, 1.7, 1 / 3.0, 0.2718), Regime::permanent_sticking, "stuck response"},
        {oscillator(0.001, 0.328, 3, 0.0866), Regime::stick_slip, "exact solver"},
        {named_scene("node"), Regime::stick_slip, "exact solver"}};
    for (const Case& c : cases) {
        INFO(c.model << ", mu = " << c.scene.mu);
        const Solution s = asking(c.scene, Asked::motion);
        CHECK(s.regime.regime == c.regime);
        CHECK(s.method.model == c.model);
        CHECK_FALSE(s.unique);
        CHECK_THAT(in_words(s.not_from_rest), Catch::Contains("the motion comes to no periodic motion within"));
        CHECK_THAT(in_words(s.unique_because), Catch::Contains("the one from rest is not known to lead here"));
        CHECK(asking(c.scene, Asked::regime).not_from_rest == s.not_from_rest);
        CHECK(asking(c.scene, Asked::regime).regime.regime == c.regime);
        Question question;
        question.proved = true;
        const Solution proved = solve(scene_source(c.scene), question);
        CHECK(proved.method.proved);
        CHECK_FALSE(proved.not_from_rest.empty());
        for (std::size_t k = 0; k < s.masses.size(); ++k) check_agree(s.masses[k].amplitude, proved.masses[k].amplitude);
        // The state repeats itself.
        if (!s.start) continue;
        State start;
        for (const Certified& x : s.start->x) start.x.push_back(x.value);
        for (const Certified& v : s.start->x_prime) start.x_prime.push_back(v.value);
        const ContactSystem system = contact_system(c.scene.system);
        ExactSolver solver(system, {*c.scene.r, *c.scene.beta, c.scene.mu});
        const State end = solver.run(start, 0.0, 2 * pi<double>() * s.periods).end;
        CHECK(std::abs(end.x[0] - start.x[0]) <= 1e-9);
    }
    // A map shows the motion from its start. Where that is not known, it has a contact that rests for ever, and else no numbers.
    for (const bool phases : {false, true}) {
        CHECK(map_of_point(cases[2].scene, {Mass{0}}, MapStart::rest, phases).points.front().status ==
              PointStatus::not_converged);
        const MapPoint rest = map_of_point(cases[1].scene, {Mass{0}}, MapStart::rest, phases).points.front();
        CHECK(rest.status == PointStatus::answered);
        CHECK(rest.regime == Regime::permanent_sticking);
    }
    // The motion from rest takes the work of the point; `solve` may spend as much again.
    const Scene<double> undamped = chain({1, 1.316, 1.931200566712639, 2.787334761745207}, {1, 1.289, 0.7837296426201019, 0.82},
                                         {0, 0, 0, 0}, 2, 3, 2.898272851114194, 0.133012, 0.4548993751361975);
    CHECK(map_of_point(undamped).points.front().regime == Regime::permanent_sticking);
}

TEST_CASE("where the motion from rest has come to the sliding motion, the closed form has its numbers", "[solve][eq:38]") {
    // A slow mode loses only a small part of itself in a period, so that its residual is far less than its error.
    const Scene<double> scene = oscillator(0.01, 250, 1.5, 2e-5);
    const Solution digits = asking(scene, Asked::motion, 30);
    for (const std::optional<int> fewer : {std::optional<int>(), std::optional<int>(12)}) {
        const Solution found = asking(scene, Asked::motion, fewer);
        CHECK(found.method.model == "closed form");
        CHECK(found.regime.regime == Regime::continuous);
        check_agree(found.masses[0].amplitude, digits.masses[0].amplitude);
    }
    const RegimeMap map = map_of_point(scene);
    CHECK(std::abs(map.amplitudes.front() - digits.masses[0].amplitude.value) <= 1e-15 * map.amplitudes.front());
}

TEST_CASE("all motions: rest from rest and sliding from a displacement of five", "[solve]") {
    const Scene<double> scene = oscillator(0.05, 1, 2, 0.55);
    const Solution s = solve(scene_source(scene), {Asked::motion, std::nullopt, true});
    REQUIRE(s.motions.size() >= 2);
    CHECK(s.motions[0].regime == Regime::permanent_sticking);
    CHECK(s.motions[0].from.x[0] == 0);
    const auto slides = std::ranges::find(s.motions, Regime::continuous, &OtherMotion::regime);
    REQUIRE(slides != s.motions.end());
    CHECK(slides->stability.stable);
    CHECK(slides->from.x[0] == Approx(5).epsilon(1e-12));
    CHECK(slides->from.x_prime[0] == 0);
    CHECK(slides->masses[0].amplitude.value == Approx(response(scene).steady_state->X_j).epsilon(1e-12));
    // Every start that is named leads where it is said to lead.
    const ContactSystem system = contact_system(scene.system);
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    for (const OtherMotion& motion : s.motions) {
        const PeriodicOrbit orbit = periodic_orbit(solver, motion.from);
        CHECK((orbit.status == OrbitStatus::permanently_stuck) == (motion.regime == Regime::permanent_sticking));
    }
}

TEST_CASE("all motions: a subharmonic one, its mirror image and the unstable symmetric one beside them", "[solve][eq:25]") {
    const Scene<double> scene = chain({1, 1}, {1, 1}, {0.03125, 0.03125}, 2, 1, 1.5, 1.125, 0.859375);
    const Solution s = solve(scene_source(scene), {Asked::motion, std::nullopt, true});
    CHECK(s.periods == 2);
    CHECK_FALSE(s.symmetric);
    const auto count = [&](int periods, bool symmetric, bool stable) {
        return std::ranges::count_if(s.motions, [&](const OtherMotion& m) {
            return m.periods == periods && m.symmetric == symmetric && m.stability.stable == stable;
        });
    };
    CHECK(count(2, false, true) == 2);
    CHECK(count(1, true, false) == 1);
    // A motion and its mirror image share their amplitudes; the paper's symmetric motion has others.
    std::vector<double> amplitudes;
    for (const OtherMotion& m : s.motions)
        if (m.periods == 2) amplitudes.push_back(m.masses[0].amplitude.value);
    REQUIRE(amplitudes.size() == 2);
    CHECK(amplitudes[0] == Approx(amplitudes[1]).epsilon(1e-10));
    for (const OtherMotion& m : s.motions) {
        if (m.periods != 1) continue;
        CHECK(m.stability.multipliers.front().value > 1);
        CHECK(std::abs(m.masses[0].amplitude.value - amplitudes[0]) > 0.01);
    }
}

TEST_CASE("all motions of a scene whose motion is unique are one", "[solve]") {
    const Solution s = solve(scene_source(equal_pair(0.5, 0.5)), {Asked::motion, std::nullopt, true});
    REQUIRE(s.motions.size() == 1);
    CHECK(s.motions[0].masses[1].amplitude.value == Approx(s.masses[1].amplitude.value).epsilon(1e-12));
}

TEST_CASE("where the paper's condition and the exact one disagree both regimes are shown", "[solve][eq:56][eq:69]") {
    Scene<double> scene = chain({1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}, {0.01, 0.01, 0.01, 0.01, 0.01}, 3, 1, 1, 0.9);
    const Boundary<double> b = boundary(sums_of(scene), 1.0);
    REQUIRE(b.paper < b.exact);
    scene.beta = (b.paper + b.exact) / 2;
    const Solution s = asking(scene, Asked::regime);
    CHECK(s.regime.regime == Regime::continuous);
    REQUIRE(s.regime_by_56);
    CHECK(*s.regime_by_56 == Regime::stick_slip);
    CHECK(solve(scene_source(scene), {Asked::regime, 30}).regime_by_56 == Regime::stick_slip); // by the reference
    scene.beta = b.paper / 2;
    CHECK_FALSE(asking(scene, Asked::regime).regime_by_56);
    CHECK_FALSE(solve(scene_source(scene), {Asked::regime, 30}).regime_by_56);
}

TEST_CASE("a pole of the closed form leaves the exact solver, or an error", "[solve][domain]") {
    // Without damping and friction below pi / 4 the motion at resonance grows without end.
    CHECK_THROWS_AS(asking(oscillator(0, 1, 1, 0.125), Asked::motion), DomainError);
    CHECK_THROWS_AS(asking(oscillator(0.1, 1, 1, -1), Asked::motion), InputError);
    CHECK_THROWS_AS(asking(oscillator(0.1, 1), Asked::motion), InputError);
    CHECK_THROWS_AS(asking(oscillator(0.1, 1, 1, 0.5), Asked::motion, 0), InputError);
}

TEST_CASE("an interval of rest beyond the range of a double is refused", "[solve][eq:88]") {
    for (const std::optional<int> digits : {std::optional<int>(), std::optional<int>(10)})
        CHECK_THROWS_WITH(asking("held far out", Asked::motion, digits), Catch::Contains("the interval of rest"));
}

TEST_CASE("amplitudes of a contact that rests of which a double has not the square", "[solve][eq:88]") {
    const Certified in_double = asking("no square", Asked::motion, 10).masses.at(0).amplitude;
    check_agree(in_double, asking("no square", Asked::motion, 30).masses.at(0).amplitude);
    CHECK(in_double.value > 1e-184);
}

TEST_CASE("two soft modes that a dashpot couples beside a light mass far more damped are coupled in double", "[solve][eq:69]") {
    const SceneSource scene = scene_source(named_scene("soft modes coupled"));
    for (const Asked asked : {Asked::amplitude, Asked::phase}) {
        const SolvedMass in_double = solve(scene, {asked, std::nullopt, false, Mass{1}}).masses.at(0);
        const SolvedMass more = solve(scene, {asked, 30, false, Mass{1}}).masses.at(0);
        check_agree(in_double.amplitude, more.amplitude);
        REQUIRE(in_double.phase);
        check_agree(*in_double.phase, *more.phase);
    }
    CHECK(solve(scene, {Asked::regime, {}}).limits.value().exact.value < 1e-16);
}

TEST_CASE("samples of a motion that double does not repeat do not leave its amplitudes, and mirror themselves",
          "[solve][eq:25]") {
    const SceneSource source = scene_source(named_scene("not repeated"));
    const Solution s = solve(source, {});
    CHECK(s.stops.size() == 2);
    const SampledSolution motion = sampled_solution(source, s, 64);
    for (std::size_t n = 0; n < 64; ++n)
        for (std::size_t k = 0; k < s.masses.size(); ++k) {
            const Certified& amplitude = s.masses[k].amplitude;
            const double allowed = amplitude.error + 1e-6 * amplitude.value;
            INFO("mass " << k + 1 << " at instant " << n);
            REQUIRE(std::abs(motion.at(n).x[k]) <= amplitude.value + allowed);
            REQUIRE(std::abs(motion.at(n).x[k] + motion.at((n + 32) % 64).x[k]) <= allowed);
        }
}

TEST_CASE("a frame on a base that moves has samples of a motion from the reference", "[solve]") {
    for (const int friction : {3, 4, 5, 6, 8}) {
        const SceneSource scene = named_source(R"(rubbing frame {"friction": )" + std::to_string(friction) + "}");
        const Solution found = solve(scene, {Asked::motion, 13});
        REQUIRE(found.regime.regime == Regime::stick_slip);
        REQUIRE(found.method.precision == "reference");
        CHECK_NOTHROW(sampled_solution(scene, found, 16));
    }
}

TEST_CASE("beta_lim by (56) is that of the modes only where their coupling makes no difference to the exact one",
          "[solve][eq:56]") {
    for (const std::optional<int> digits : {std::optional<int>(), std::optional<int>(30)}) {
        const Limits limits = asking("moved by coupling", Asked::regime, digits).limits.value();
        CHECK(limits.paper.value <= limits.exact.value);
        CHECK(limits.exact.value == Approx(5.83883071769e-15));
    }
}

TEST_CASE("where rounding keeps a motion from settling in double it is refused in words", "[solve][eq:74]") {
    const SceneSource light = named_source("light, both loaded");
    CHECK_THROWS_WITH(solve(light, {Asked::motion, {}}),
                      Catch::Contains("rounding keeps the motion from settling") && Catch::Contains("This much is certain"));
    CHECK(solve(light, {Asked::regime, {}}).regime.regime == Regime::stick_slip);
}

TEST_CASE("a light mass of which double only sees phases without length moves by the reference", "[solve][eq:74]") {
    const SceneSource scene = named_source("light on the contact");
    const Solution found = solve(scene, {Asked::motion, {}});
    CHECK(found.regime.regime == Regime::stick_slip);
    CHECK(found.digits_reached);
    check_agree(found.masses[0].amplitude, solve(scene, {Asked::motion, 20}).masses[0].amplitude);
}

TEST_CASE("a scene of which double has no modes is answered by the reference, but for motions with stops", "[solve][eq:69]") {
    for (const std::string beta : {"0.3", "0.7", "1.1"}) {
        const SceneSource scene = named_source(R"(rigid {"beta": )" + beta + "}");
        REQUIRE_THROWS_AS(modal_basis(scene->in_double().system), PrecisionError);
        const Solution of_one = solve(named_source(R"(rigid as one {"friction": )" + beta + "}"), {Asked::motion, {}});
        if (of_one.regime.regime == Regime::stick_slip) {
            CHECK_THROWS_WITH(solve(scene, {Asked::motion, {}}), Catch::Contains("no motion with stops to start from"));
            CHECK(solve(scene, {Asked::regime, {}}).regime.regime == Regime::stick_slip);
            continue;
        }
        for (const Asked asked : {Asked::amplitude, Asked::motion}) {
            const Solution found = solve(scene, {asked, {}});
            CHECK(found.regime.regime == of_one.regime.regime);
            CHECK(found.digits_reached);
            CHECK(found.masses[0].amplitude.value == Approx(of_one.masses[0].amplitude.value).epsilon(1e-9));
        }
    }
}

TEST_CASE("a light mass on a base that moves costs a motion no digits", "[solve][eq:74]") {
    for (const std::string beta : {"0.3", "0.9", "1.1"}) {
        const Solution found = asking(R"(light on a base {"beta": )" + beta + "}", Asked::motion, 14);
        CHECK(found.digits_reached);
        CHECK((found.regime.regime == Regime::stick_slip) == (beta == "0.9"));
    }
}

TEST_CASE("a chain on a base that moves keeps the digits of a chain", "[solve][eq:14]") {
    const SceneSource source = scene_source(named_scene("stiff on a base"));
    const System<double>& own = source->in_double().system;
    CHECK(is_chain(own));
    const ModalBasis<double> basis = modal_basis(own);
    CHECK(basis.r_n[0] == Approx(std::sqrt(5e-15)).epsilon(1e-14));
    REQUIRE(basis.phi.rows() == 4);
    for (Eigen::Index i = 0; i < 3; ++i) CHECK(basis.phi(3, i) == Approx(basis.phi.col(i).head(3).sum()).margin(1e-14));
}

TEST_CASE("a contact between two masses takes the place of the lighter one", "[solve][vectors]") {
    for (const std::string contact : {"[1, 2]", "[2, 1]"}) {
        const SceneSource source = scene_source(SceneText{R"({"mass_ratios": [1, 1e-17], "stiffness_ratios": [1, 1],
            "damping_ratios": 0.05, "load": 2, "contact": )" +
                                                          contact + "}"});
        const System<double>& system = source->in_double().system;
        const Contact held = contact_of(contact_vector(system), mass_matrix(system));
        CHECK(held.a == 1);
        const Matrix<double> M = held_matrices(system, held, Matrix<double>(Matrix<double>::Zero(2, 2))).M;
        CHECK(M(0, 0) == 1); // the heavier has both, which rounds to 1; the contact keeps the lighter
        CHECK(M(1, 1) == 1e-17);
    }
}

TEST_CASE("two masses that are pressed apart and together slide below the same friction", "[solve][vectors]") {
    for (const std::string contact : {"[1, 2]", "[2, 1]"})
        for (const double mu : {1.0, 1.3}) {
            const auto limits = [&](const std::string& load) {
                const SceneSource source = scene_source(SceneText{
                    R"({"mass_ratios": [1, 0.75], "stiffness_ratios": [1, 2], "damping_ratios": 0.02, "r": 0.7, "beta": 0.01, "mu": )" +
                    std::to_string(mu) + R"(, "contact": )" + contact + R"(, "load": )" + load + "}"});
                return *solve(source, {Asked::regime, {}}).limits;
            };
            const Limits apart = limits("[1, -1]"), together = limits("[-1, 1]");
            CHECK(apart.exact.value == Approx(together.exact.value).epsilon(1e-10));
            CHECK(apart.sticking->value == Approx(together.sticking->value).epsilon(1e-10));
        }
}

TEST_CASE("a load on nothing but the contact may have any size and sign", "[solve]") {
    const std::string of_both = R"("damping_ratios": 0, "contact": 1, "base_motion": "alone", "base_displacement": 0.001,
        "frequency": 20, "friction": 0.1})";
    const Solution by_matrices =
        solve(scene_source(SceneText{R"({"masses": [[2, 0], [0, 3]], "stiffnesses": [[1500, -800], [-800, 800]], )" + of_both}),
              {Asked::motion, 12});
    const Solution chain =
        solve(scene_source(SceneText{R"({"masses": [2, 3], "stiffnesses": [700, 800], )" + of_both}), {Asked::motion, 12});
    CHECK(by_matrices.regime.regime == Regime::continuous);
    for (const std::size_t k : {0, 1}) // in units of P / k_1, where P = k_1 X of the base
        CHECK(by_matrices.masses[k].amplitude.value == Approx(chain.masses[k].amplitude.value).epsilon(1e-11));
    // A force of -2 P at the contact, between two masses as well, under twice the friction, is the motion half a period later.
    for (const std::string contact : {"2", "[2, 1]"})
        for (const std::string damping : {R"("damping_ratios": [0.02, 0.04])", R"("damping_matrix": [[0.2, -0.1], [-0.1, 0.1]])"})
            for (const double beta : {0.1, 0.9, 5.0}) {
                const auto at = [&](double c, const std::string& load) {
                    return solve(scene_source(SceneText{R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 1], )" + damping +
                                                        R"(, "contact": )" + contact + R"(, "load": )" + load +
                                                        R"(, "r": 0.8, "beta": )" + std::to_string(c * beta) + "}"}),
                                 {Asked::motion, 12});
                };
                INFO(contact << " " << damping << " " << beta);
                const Solution one = at(1, contact == "2" ? "2" : "[-1, 1]"),
                               other = at(2, contact == "2" ? "[0, -2]" : "[2, -2]");
                CHECK(one.regime.regime == other.regime.regime);
                CHECK(one.stops.size() == other.stops.size());
                for (std::size_t k = 0; k < 2; ++k) {
                    CHECK(other.masses[k].amplitude.value == Approx(2 * one.masses[k].amplitude.value).epsilon(1e-11));
                    if (one.masses[k].phase)
                        CHECK(std::abs(std::abs(one.masses[k].phase->value - other.masses[k].phase->value) - std::acos(-1)) <
                              1e-9);
                }
            }
}

TEST_CASE("a search that spends its work in exponentials says what is certain", "[solve][effort]") {
    const SceneSource scene = named_source("many exponentials");
    for (long effort = 60'000; effort <= 100'000; effort += 1000) { // at 79 000, for instance, an exponential spends the last
        QuestionEffort allowed(5, effort);
        CHECK_THROWS_WITH(solve(with_effort(scene, &allowed), {Asked::motion, {}}), Catch::Contains("This much is certain"));
    }
}

TEST_CASE("a contact of any direction that rests for ever is seen to rest, from its start on", "[solve][eq:74]") {
    int rests = 0;
    for (const std::vector<double>& w : {std::vector<double>{1.3, -0.3}, {1.3, -0.7}, {3, 1}, {-0.7, 1.9}})
        for (const double mu : {1.0, 1.5})
            for (const double r : {0.4, 0.9, 1.3, 2.4}) {
                Scene<double> scene = chain({1, 1}, {1, 1}, {0.1, 0.1}, 1, 1, mu, r);
                scene.system.contact_direction = w;
                scene.system.contact = Mass{std::abs(w[0]) > std::abs(w[1]) ? 0U : 1U};
                scene.beta = 2;
                const Solution found = solve(scene_source(scene), {Asked::motion, {}, true});
                if (found.regime.regime != Regime::permanent_sticking) continue;
                INFO("mu = " << mu << ", r = " << r << ", w = " << w[0] << ", " << w[1]);
                ++rests;
                CHECK(found.not_from_rest.empty());
                REQUIRE_FALSE(found.motions.empty());
                CHECK(found.motions[0].regime == Regime::permanent_sticking);
            }
    CHECK(rests > 20);
}

TEST_CASE("a mode too fast to be followed is named with its frequency", "[solve][effort]") {
    Scene<double> scene = chain({1, 1e-8}, {1, 1}, {0.02, 0.03}, 1, 2, 1, 0.3, 0.5);
    const auto within_little = [&] {
        QuestionEffort allowed(2, 500);
        return solve(with_effort(scene_source(scene), &allowed), {Asked::motion, {}});
    };
    CHECK_THROWS_WITH(within_little(), Catch::Contains("The fastest mode has 3.3e+04 times the frequency of the force"));
    scene.system.mass_ratios[1] = 1e-4;
    CHECK_THROWS_WITH(within_little(), !Catch::Contains("The fastest mode"));
}

TEST_CASE("a mass that hardly moves has a bound, whatever rounding leaves of its acceleration", "[solve][accuracy]") {
    const Solution found = solve(named_source("hardly moving mass"), {Asked::motion, {}});
    REQUIRE(found.regime.regime == Regime::continuous);
    for (const SolvedMass& mass : found.masses) CHECK(std::isfinite(mass.amplitude.error));
    CHECK(found.masses[7].amplitude.error < 1e-9 * found.masses[1].amplitude.value);
}

TEST_CASE("a phase of the contact that is not certain enough for samples is found to more digits", "[solve][eq:47]") {
    const Scene<double> scene = chain({1, 1, 1.25}, {1, 0.5, 2}, {0.02, 0.02, 0.02}, 3, 1, 1, 0.4, 0.05);
    const Solution found = solve(scene_source(scene), {});
    REQUIRE(found.regime.regime == Regime::continuous);
    const SampledSolution samples = sampled_solution(scene_source(scene), found, 16);
    Solution vague = found; // as certain as it has to be for 5 digits, and off by almost all of its bound
    Certified& phase = *vague.masses[2].phase;
    phase = {phase.value + 0.9e-5, 1e-5, {}};
    const SampledSolution others = sampled_solution(scene_source(scene), vague, 16);
    for (std::size_t n = 0; n < samples.tau.size(); ++n)
        for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(samples.at(n).x[k] - others.at(n).x[k]) < 1e-9);
    phase = {phase.value, 1e-7, {}}; // such a bound would do, so that the phase is taken as it is
    const SampledSolution moved = sampled_solution(scene_source(scene), vague, 16);
    CHECK(std::abs(samples.at(4).x[2] - moved.at(4).x[2]) > 1e-7);
}

TEST_CASE("permanent sticking by (88) and the interval of rest are numbers or are not given", "[solve][eq:88]") {
    // Double loses (88) at so high a frequency, and the amplitudes are below its range.
    Scene<double> scene = chain({1, 0x1p-50, 0x1p-50}, {1, 2.279534880961692e-12, 77480419260.19966}, {32879.2, 0.0182, 3.36e-7},
                                3, 2, 1, 5.9e152, 0);
    CHECK(solve(scene_source(scene), {}).masses[0].amplitude.error == std::numeric_limits<double>::denorm_min());
    CHECK(solve(scene_source(scene), {.digits = 20}).masses[0].amplitude.decimal.ends_with("e-454"));
    const Solution regime = asking(scene, Asked::regime);
    REQUIRE(regime.sticking_by_88);
    CHECK(regime.sticking_by_88->value > 0);
    // Friction of 1e310 holds the contact wherever it is.
    const Scene<double> held = oscillator(0.01, 0.5, 1e10, 1e300);
    CHECK_THROWS_WITH(solve(scene_source(held), {}), Catch::Contains("the interval of rest is beyond the range of a double"));
    CHECK(solve(scene_source(held), {.digits = 20}).rest_interval->to.decimal.find("e+310") != std::string::npos);
}

TEST_CASE("the reference is not asked about a long chain unless digits are asked for", "[solve][effort]") {
    const auto long_chain = [](std::size_t N) { return scene_source(equal_masses(N, 0.02, 0.9, 0.7)); };
    QuestionEffort effort(150);
    const Solution found = solve(with_effort(long_chain(150), &effort), {});
    CHECK(found.method.precision == "double");
    CHECK_THAT(in_words(found.method.why), Catch::Contains("the reference is asked about no more than 100 masses"));
    CHECK(found.stability->stable);
    CHECK(effort.spent < default_effort(150) / 10);
    CHECK(solve(long_chain(30), {.digits = 12}).method.precision == "reference");
}

TEST_CASE("a scene that is kept and one that is copied have the same answer, in every number type", "[solve]") {
    Scene<double> between = equal_pair(0.875, 0.0625);
    between.system.contact_with = Mass{0};
    for (const Scene<double>& scene : {equal_pair(0.875, 0.0625), between})
        for (const int digits : {6, 30}) {
            const Question question{Asked::motion, digits};
            const Solution kept = solve(source_of_kept(scene), question), copied = solve(scene_source(scene), question);
            REQUIRE(kept.masses.size() == 2);
            for (std::size_t k = 0; k < 2; ++k) {
                CHECK(kept.masses[k].amplitude.value == copied.masses[k].amplitude.value);
                CHECK(kept.masses[k].amplitude.error == copied.masses[k].amplitude.error);
                CHECK(kept.masses[k].amplitude.decimal == copied.masses[k].amplitude.decimal);
            }
        }
}
