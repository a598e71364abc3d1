// Scenes on which a search would run on without end: each ends within its budget, counted in operations, and says what is
// certain.
#include <atomic>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "denhartog/answer/reference.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/scene/converted.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/support/paper_systems.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

PeriodicOrbit orbit_from_rest(const System<double>& s, const Excitation& e, Effort* effort = nullptr) {
    const ContactSystem system = contact_system(s);
    ExactSolver solver(system, e);
    OrbitSearch search;
    search.effort = effort;
    return periodic_orbit(solver, at_rest(system.basis.r_n.size()), search);
}

void say(const char* scene, const PeriodicOrbit& orbit) {
    std::printf("%s: %ld operations, %d periods; %s\n", scene, orbit.effort_spent, orbit.periods_propagated,
                in_words(orbit.reason).c_str());
}

} // namespace

TEST_CASE("a force slower than any number of periods has no orbit, and the search says so", "[effort][exact-solver]") {
    for (const double r : {5e-324, 1e-300, 1e-30, 1e-12}) {
        const PeriodicOrbit orbit = orbit_from_rest(chain_of({1, 1}, {1, 1}, 0.05, 2, 1), {r, 0.25, 1});
        say("two masses far below resonance", orbit);
        CHECK(orbit.status == OrbitStatus::not_converged);
        CHECK_FALSE(orbit.reason.empty());
        CHECK(orbit.masses.empty());
        CHECK(orbit.effort_spent <= default_effort(2) + 100);
    }
}

TEST_CASE("friction beyond all measure stops any motion at once", "[effort][exact-solver]") {
    const ContactSystem system = contact_system(chain_of({1}, {1}, 0.138, 1, 1));
    std::mt19937_64 random(5);
    for (const double beta : {1e17, 1e100, 1e200, 1e300}) {
        ExactSolver solver(system, {1.0 / 3, beta, 1.1});
        for (int n = 0; n < 20; ++n) {
            const auto draw = [&] { return std::ldexp(static_cast<double>(random() >> 11), -52) - 1; };
            const PeriodicOrbit orbit = periodic_orbit(solver, State{{draw()}, {draw()}});
            INFO("beta " << beta << ": " << in_words(orbit.reason));
            CHECK(orbit.status == OrbitStatus::permanently_stuck);
            CHECK(orbit.effort_spent <= 1000);
        }
    }
}

TEST_CASE("stuck modes that are heavily damped and coupled cost no more than others", "[effort][exact-solver]") {
    const System<double> s = chain_of({1, 1, 1, 1}, {1, 1.8e-13, 1, 1}, 1e6, 3, 1);
    const PeriodicOrbit orbit = orbit_from_rest(s, {3.99, 0.48, 1.1});
    say("four masses, zeta = 1e6", orbit);
    CHECK(orbit.effort_spent <= default_effort(4) + 1000);
    // The motion itself, over one period: few phases, few evaluations.
    const ContactSystem system = contact_system(s);
    CHECK_FALSE(system.stuck.modes_diagonalise_damping);
    ExactSolver solver(system, {3.99, 0.48, 1.1});
    Effort effort;
    (void)solver.allow(&effort);
    const ExactMotion& motion = solver.run(at_rest(4), 0, 2 * pi<double>());
    std::printf("one period of it: %zu phases, %ld operations\n", motion.phases.size(), effort.spent);
    CHECK(motion.status == MotionStatus::complete);
    CHECK(effort.spent <= 200'000);
}

TEST_CASE("an orbit whose effort is spent says how far it came", "[effort][exact-solver]") {
    Effort effort{600};
    const PeriodicOrbit orbit = orbit_from_rest(two_masses(0.001), {0.3, 0.4, 2.5}, &effort);
    CHECK(orbit.status == OrbitStatus::not_converged);
    CHECK_THAT(in_words(orbit.reason),
               Catch::Contains("the work allowed is spent") && Catch::Contains("comes to no periodic motion within"));
    CHECK(orbit.effort_spent == effort.spent);
    CHECK(orbit.effort_spent <= 700);
}

TEST_CASE("far above resonance, where the functions of (87) cancel, the invariant points are found all the same",
          "[effort][invariant][eq:87]") {
    const SceneSource source = scene_source(scene_of(chain_of({1, 1, 1}, {1, 1, 1}, 0.05, 1, 1), 1));
    for (const char* const r : {"20", "50", "200"}) {
        QuestionEffort enough(3);
        std::size_t points = 0;
        for (const InvariantPointsOfMass<Certified>& mass : invariant_points(with_effort(source, &enough), {"1", r})) {
            points += mass.points.size();
            CHECK(mass.undecided.empty());
        }
        std::printf("invariant points 1:%s: %ld operations, %zu points\n", r, enough.spent, points);
        CHECK(points == 4);
        CHECK(enough.spent <= 200'000);
    }
    QuestionEffort little(3, 1000);
    CHECK_FALSE(invariant_points(with_effort(source, &little), {"1", "50"}).back().undecided.empty());
}

TEST_CASE("finding modes is paid for, and ends where nothing is left to pay or somebody cancels", "[effort][eq:15]") {
    const System<double> chain = chain_of(std::vector<double>(60, 1), std::vector<double>(60, 1), 0.01, 2, 1);
    System<double> general = with_stiffness_matrix(chain), graded = general;
    graded.mass_ratios.back() = 1e-9;
    const auto need_end = [&](const char* what, long most, const System<double>& system) {
        INFO(what);
        QuestionEffort enough(60), little(60, most), cancelled(60, {}, [] { return true; });
        (void)modal_basis(system, &enough);
        CHECK(enough.spent > most);
        std::printf("modes of 60 masses, %s: %ld operations\n", what, enough.spent);
        CHECK_THROWS_AS(modal_basis(system, &little), PrecisionError);
        CHECK_THROWS_WITH(modal_basis(system, &cancelled), Catch::Contains("cancelled"));
        CHECK(cancelled.spent <= enough.spent);
    };
    need_end("a chain", 500, chain);
    need_end("any matrices", 1000, general);
    need_end("masses far apart", 100'000, graded);
}

TEST_CASE("many masses with stops have their digits, or the answer says that the work is spent",
          "[effort][solve][exact-solver]") {
    const auto building = [](std::size_t N) {
        const std::vector<double> same(N, 1);
        return scene_source(scene_of(chain_of(same, same, 0.01, 3, 1), 0.5, 0.3));
    };
    const Solution found = solve(building(40), {.digits = 20});
    CHECK(found.digits_reached);
    CHECK(found.stops.size() == 2);
    int answered = 0;
    for (const long allowed : {6'000'000L, 8'000'000L, 9'200'000L, 10'000'000L, 12'000'000L, 20'000'000L}) {
        QuestionEffort effort(24, allowed);
        try {
            const bool reached = solve(with_effort(building(24), &effort), {.digits = 20}).digits_reached;
            CHECK(reached);
            ++answered;
        } catch (const PrecisionError& e) {
            CHECK_THAT(e.what(), Catch::Contains("the work allowed is spent"));
        }
        CHECK(effort.spent < allowed + 2'000'000);
    }
    CHECK(answered > 0);
}

TEST_CASE("a question has one budget for all its searches, and what is given to it counts", "[effort]") {
    QuestionEffort question(3, 1000);
    {
        SearchEffort first(10, &question);
        CHECK(first.left() == 1000); // the user's choice, all of it
        first.spend(900);
        CHECK_FALSE(question.exhausted()); // not before the search ends
    }
    {
        SearchEffort second(10, &question);
        CHECK(second.left() == 100);
        second.spend(200);
        CHECK(second.exhausted());
    }
    CHECK(question.exhausted());
    CHECK(GivenEffort(&question, 24).get() == &question);
    CHECK(question.allowed == 1000);
    QuestionEffort by_default(3);
    CHECK(SearchEffort(10, &by_default).left() == 10); // its share
    const GivenEffort of_more_modes(&by_default, 24), own(nullptr, 3);
    CHECK(SearchEffort(std::numeric_limits<long>::max(), &by_default).left() == default_effort(24));
    CHECK(own.get()->left() == default_effort(3));
    CHECK_NOTHROW(pay(nullptr, std::numeric_limits<long>::max()));
}

TEST_CASE("solve ends where its work is spent and says what is certain until then", "[effort][solve]") {
    const Scene<double> scene = scene_of(two_masses(0.001), 0.3, 0.4, 2.5);
    const Question question{Asked::motion, std::nullopt, false};
    QuestionEffort little(2, 2000);
    CHECK_THROWS_WITH(solve(with_effort(scene_source(scene), &little), question),
                      Catch::Contains("the work allowed is spent") && Catch::Contains("This much is certain"));
}

TEST_CASE("questions that had no end have one within their budget, counted", "[effort][solve]") {
    struct Hard {
        const char* what;
        std::string scene;
        Question question;
    };
    const auto chain = [](std::size_t N, const char* zeta, const char* rest) {
        std::string ones = "1";
        for (std::size_t i = 1; i < N; ++i) ones += ",1";
        return R"({"mass_ratios":[)" + ones + R"(],"stiffness_ratios":[)" + ones + R"(],"damping_ratios":)" + zeta + "," + rest +
               "}";
    };
    const std::string stiff = R"({"mass_ratios":[1,2,1.5,0.7],"stiffness_ratios":[1,1.8e-13,1.2,0.8],
        "damping_ratios":[1e6,1e6,1e6,1e6],"contact":2,"load":1,"mu":1.1,"r":3.99,"beta":0.48})";
    const std::string nearly_apart = R"({"mass_matrix":[[1,0,0],[0,1,0],[0,0,1]],
        "stiffness_matrix":[[1.0000000001,-1e-10,0],[-1e-10,1.0000000002,-1e-10],[0,-1e-10,1.0000000001]],
        "damping_ratios":[0.007,0.03,0.07],"contact":3,"load":3,"mu":1,"r":1.3,"beta":0.5})";
    const Question motion{Asked::motion, std::nullopt, false}, all{Asked::motion, std::nullopt, true},
        to_30{Asked::motion, 30, false};
    const Hard questions[] = {
        {"far masses", chain(12, "0", R"("contact":7,"load":10,"mu":1,"r":1e6,"beta":1e-37)"), motion},
        {"masses that hardly feel each other", nearly_apart, to_30},
        {"beta of 1e300", R"({"mass_ratios":[1],"stiffness_ratios":[1],"damping_ratios":[0.138],"contact":1,"load":1,"mu":1.1,
                              "r":0.3333333333333333,"beta":1e300})",
         all},
        {"dampers of a million", stiff, to_30},
        {"two masses, slow and hardly damped", R"({"mass_ratios":[1,1],"stiffness_ratios":[1,1],"damping_ratios":[1e-6,1e-6],
                              "contact":1,"load":2,"mu":1.1,"r":1e-5,"beta":0.1})",
         motion},
        {"a chain of 60", chain(60, "0.03", R"("contact":20,"load":1,"mu":1,"r":0.7,"beta":0.4)"), motion}};
    for (const Hard& each : questions) {
        const SceneSource source = scene_source(split_scenes(each.scene).front());
        const std::size_t N = number_of_masses(source->in_double().system);
        QuestionEffort effort(N);
        std::string ending = "answered";
        try {
            (void)solve(with_effort(source, &effort), each.question);
        } catch (const PrecisionError& e) {
            ending = e.what();
        }
        std::printf("%s: %ld operations; %s\n", each.what, effort.spent, ending.c_str());
        INFO(each.what << ": " << ending);
        CHECK(effort.spent > 0);
        CHECK(effort.spent <= default_effort(N) + default_effort(N) / 10);
    }
}

TEST_CASE("everyday questions cost no more operations than they were seen to", "[effort][solve]") {
    struct Everyday {
        const char* what;
        System<double> system;
        std::vector<double> r;
        double beta;
        long operations, phases; // counted when this was written
    };
    Everyday curve{"two masses along r, all masses", two_masses(0.01), {}, 0.3, 36881, 1954};
    for (int n = 10; n <= 250; ++n) curve.r.push_back(n / 100.0);
    const Everyday stiff{"a light mass on a stiff spring, far below resonance",
                         chain_of({1, 1e-4, 1}, {1, 1e6, 1}, 0.05, 1, 3),
                         {0.1},
                         0.2,
                         146914,
                         39};
    for (const Everyday& each : {curve, stiff, Everyday{"five masses, sliding", five_masses<double>(3, 0.01), {0.9}, 0.2, 500, 0},
                                 Everyday{"one mass, stick-slip", single_mass(0.01), {0.1}, 0.2, 245, 41},
                                 Everyday{"one mass, sliding", single_mass(0.01), {0.9}, 0.2, 0, 0}}) {
        QuestionEffort effort(number_of_masses(each.system));
        const long phases = phases_propagated();
        for (const double r : each.r)
            (void)solve(with_effort(scene_source(scene_of(each.system, r, each.beta)), &effort), {Asked::amplitude, {}});
        INFO(each.what << ": " << effort.spent << " operations");
        CHECK(effort.spent <= each.operations);
        CHECK(phases_propagated() - phases <= each.phases);
    }
}

TEST_CASE("a map at mu > 1 follows its motions over no more phases than it was seen to", "[effort][map]") {
    Scene<double> scene;
    scene.system = equal_chain<double>(5, 2, 5, std::vector<double>(5, 0.02));
    scene.mu = 1.15;
    const std::atomic<bool> never{false};
    for (const auto& [start, most] :
         {std::pair(MapStart::sliding, 1223L), std::pair(MapStart::rest, 14098L)}) { // counted, as it is
        MapRequest grid{{0.5, 0.9, 1.7}, {}, {Mass{1}}, start, 1};
        for (int n = 1; n <= 50; ++n) grid.beta.push_back(n / 20.0);
        const long before = phases_propagated();
        const RegimeMap map = regime_map(scene, grid, never);
        const long phases = phases_propagated() - before;
        int met[3] = {0, 0, 0};
        for (const MapPoint& point : map.points)
            if (point.status == PointStatus::answered) ++met[static_cast<int>(point.regime)];
        INFO(phases << " phases; " << met[0] << " slide, " << met[1] << " stop, " << met[2] << " rest");
        CHECK(met[1] > 10);
        CHECK(phases <= most);
    }
}
