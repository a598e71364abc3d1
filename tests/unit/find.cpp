// The inverse question, against roots that the textbook has, and against functions whose places are known.
#include "denhartog/solve/find.hpp"

#include <cmath>
#include <map>

#include "denhartog/solve/detail/amplitude_search.hpp"
#include "tests/catch.hpp"
#include "tests/support/closed_form.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

const std::string one = R"({"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0.1, "contact": 1, "load": 1,)";
const std::string without_friction = one + R"( "r": 1, "beta": 0})";
constexpr double zeta = 0.1;

bool holds(const FoundPlace& p, const Real50& x) { return Real50(p.from) <= x && x <= Real50(p.to); }

std::vector<double> even(double from, double to, int parts) {
    std::vector<double> at;
    for (int n = 0; n <= parts; ++n) at.push_back(from + (to - from) * n / parts);
    return at;
}

// A search for a function that is known to an error.
AmplitudeSearch search_of(const std::function<double(double)>& f, int parts = 10, double error = 1e-13) {
    return {even(0, 1, parts), [=](double x) -> Tried<Certified> {
                const double value = f(x);
                if (std::isnan(value)) return {Outcome::not_converged, Why::not_periodic};
                return {Certified{value, error}};
            }};
}

std::vector<std::string> kinds_of(const FoundPlaces& found) {
    std::vector<std::string> kinds;
    for (const FoundPlace& p : found.places) kinds.emplace_back(name_of(p.is));
    return kinds;
}

using Kinds = std::vector<std::string>;

} // namespace

TEST_CASE("the frequencies at which a mass without friction has an amplitude are the textbook's", "[find][eq:38]") {
    const FoundPlaces found = find_places(without_friction, {"r", 0.05, 3}, wanted_from("amplitude of mass 1 = 2"), 16);
    REQUIRE(kinds_of(found) == Kinds{"crossing", "crossing"});
    // (1 - s)^2 + 4 zeta^2 s = 1 / 4 of s = r^2
    const Real50 z(zeta), half = 1 - 2 * z * z, root = sqrt(Real50(half * half - Real50(3) / 4));
    CHECK(holds(found.places[0], sqrt(Real50(half - root))));
    CHECK(holds(found.places[1], sqrt(Real50(half + root))));
    for (const FoundPlace& p : found.places) {
        CHECK(p.to - p.from < 1e-13);
        CHECK(std::abs(p.amplitude.value - 2) < 1e-13);
    }
}

TEST_CASE("the friction at which a mass has an amplitude is the root of (38)", "[find][eq:38]") {
    const std::string scene = one + R"( "r": 0.7, "beta": 0.1})";
    const Scene<double> s = read_scene<double>(scene);
    const ModeSums<Real50> sums = mode_sums(modal_basis(converted<Real50>(s).system), Mass{0}, Mass{0}, Real50(0.7));
    const Real50 V2 = sums.V[0].re * sums.V[0].re + sums.V[0].im * sums.V[0].im, U = sums.U[0], G = sums.G[0], X(1.625);
    // (X + beta G)^2 = |V|^2 - beta^2 U^2, Eq. (38)
    const Real50 a = G * G + U * U, root = (sqrt(Real50(X * X * G * G - a * (X * X - V2))) - X * G) / a;
    const FoundPlaces found = find_places(scene, {"beta", 0, 0.8}, wanted_from("amplitude of mass 1 = 1.625"), 16);
    REQUIRE(kinds_of(found) == Kinds{"crossing"});
    CHECK(holds(found.places[0], root));
}

TEST_CASE("the largest amplitude over the frequency is the textbook's, and so is the damping that it asks for", "[find]") {
    const FoundPlaces peak = find_places(without_friction, {"r", 0.05, 3}, wanted_from("amplitude of mass 1 is largest"), 16);
    REQUIRE(kinds_of(peak) == Kinds{"extreme"});
    const Real50 z(zeta);
    CHECK(holds(peak.places[0], sqrt(Real50(1 - 2 * z * z))));
    CHECK(std::abs(peak.places[0].amplitude.value - 1 / (2 * zeta * std::sqrt(1 - zeta * zeta))) < 1e-12);
    const FoundPlaces damping = find_places(without_friction, {"damping_ratios", 0.05, 0.6},
                                            wanted_from("largest amplitude of mass 1 over r 0.05:3 = 2"), 16);
    REQUIRE(kinds_of(damping) == Kinds{"crossing"});
    CHECK(std::abs(damping.places[0].at - std::sqrt((1 - std::sqrt(0.75)) / 2)) < 1e-7); // the peak is known to its samples
    const FoundPlaces least = find_places(without_friction, {"r", 0.05, 3}, wanted_from("amplitude of mass 1 is least"), 16);
    REQUIRE(kinds_of(least) == Kinds{"end of the interval"});
    CHECK(least.places[0].at == 3);
}

TEST_CASE("a peak far narrower than the samples is found beside its natural frequency, in radians and in hertz", "[find]") {
    const std::string scene =
        R"({"masses": [10], "stiffnesses": [1000], "damping_ratios": 1e-5, "contact": 1, "load": 1, "force": 1,
        "friction": 0})";
    const Wanted wanted = wanted_from("amplitude of mass 1 is largest");
    for (const auto& [key, natural] : {std::pair("frequency", 10.0), std::pair("frequency_hz", 5 / pi<double>())}) {
        INFO(key);
        const FoundPlaces peak = find_places(scene, {key, 0.3 * natural, 4 * natural}, wanted, 16);
        REQUIRE(kinds_of(peak) == Kinds{"extreme"});
        CHECK(std::abs(peak.places[0].at / natural - 1) < 1e-9);
    }
}

TEST_CASE("a frequency is found for a scene that has none, and whose load depends on it", "[find]") {
    const std::string unbalance = R"({"masses": [10], "stiffnesses": [1000], "damping_ratios": 0.05, "contact": 1, "load": 1,
        "unbalance": 0.1, "friction": 1)";
    const Wanted wanted = wanted_from("amplitude of mass 1 = 0.01");
    const FoundPlaces with = find_places(unbalance + R"(, "frequency": 3})", {"frequency", 3, 8}, wanted, 16);
    REQUIRE(kinds_of(with) == Kinds{"crossing"});
    const FoundPlaces without = find_places(unbalance + "}", {"frequency", 3, 8}, wanted, 16);
    REQUIRE(kinds_of(without) == Kinds{"crossing"});
    CHECK(without.places[0].at == with.places[0].at);
    const FoundPlaces in_hertz = find_places(unbalance + "}", {"frequency_hz", 0.5, 1.25}, wanted, 16);
    REQUIRE(kinds_of(in_hertz) == Kinds{"crossing"});
    CHECK(std::abs(2 * pi<double>() * in_hertz.places[0].at - with.places[0].at) < 1e-12);
    const FoundPlaces ratio =
        find_places(one + R"("beta": 0})", {"r", 0.05, 3}, wanted_from("amplitude of mass 1 is largest"), 16);
    REQUIRE(kinds_of(ratio) == Kinds{"extreme"});
    // Of the friction with the least peak over a frequency that the scene lacks.
    CHECK(find_places(unbalance + "}", {"friction", 0.5, 2},
                      wanted_from("largest amplitude of mass 1 over frequency 8:12 = 0.085"), 8)
              .places.size() == 1);
    REQUIRE_THROWS_WITH(find_places(unbalance + "}", {"friction", 0.5, 2}, wanted, 8),
                        Catch::Matchers::Contains("frequency must be given"));
}

TEST_CASE("an interval that a scene has in part is searched where it has it, the second one as well", "[find]") {
    const std::string scene = one + R"( "r": 0.9, "beta": 0.1})";
    const Wanted whole = wanted_from("largest amplitude of mass 1 over r 0.5:1.5 = 3"),
                 in_part = wanted_from("largest amplitude of mass 1 over r -0.5:1.5 = 3");
    const FoundPlaces expected = find_places(scene, {"beta", 0, 0.5}, whole, 32),
                      found = find_places(scene, {"beta", 0, 0.5}, in_part, 64);
    REQUIRE(kinds_of(expected) == Kinds{"crossing"});
    REQUIRE(kinds_of(found) == Kinds{"crossing"});
    CHECK(found.places[0].at == Approx(expected.places[0].at).epsilon(1e-5)); // the peak is known to its samples
    CHECK(expected.left_out == 0);
    CHECK(found.left_out > 0);
    CHECK(found.left_out < found.questions);
    CHECK_THAT(in_words(found.left_out_why), Catch::Matchers::Contains("r must be positive"));
    CHECK(find_places(scene, {"beta", -0.5, 0.5}, in_part, 64).places.size() == 1);
    REQUIRE_THROWS_WITH(find_places(scene, {"beta", 0, 0.5}, wanted_from("largest amplitude of mass 1 over r -2:-1 = 3"), 8),
                        Catch::Matchers::Contains("r must be positive"));
}

TEST_CASE("a scene in units has its amplitude in them", "[find]") {
    const std::string scene = R"({"masses": [10], "stiffnesses": [4000], "damping_ratios": 0.1, "contact": 1, "load": 1,
        "force": 100, "friction": 0, "frequency": 20})"; // at resonance X = P / (2 zeta k)
    const FoundPlaces found = find_places(scene, {"force", 1, 200}, wanted_from("amplitude of mass 1 = 0.075"), 8);
    REQUIRE(kinds_of(found) == Kinds{"crossing"});
    CHECK(std::abs(found.places[0].at - 0.075 * 0.2 * 4000) < 1e-9);
    const FoundPlaces ratio = find_places(scene, {"masses/1", 5, 20}, wanted_from("amplitude of mass 1 is least"), 8);
    REQUIRE(ratio.places.size() == 1);
    CHECK(ratio.places[0].at == 20);
}

TEST_CASE("a search over a known function finds crossings, jumps, touches, gaps and extremes", "[find]") {
    const auto parabola = [](double x) { return 1 - (x - 0.37) * (x - 0.37); };
    FoundPlaces pair = search_of(parabola, 2).value(0.9999); // both crossings lie within one part
    REQUIRE(kinds_of(pair) == Kinds{"crossing", "crossing"});
    CHECK(std::abs(pair.places[0].at - 0.36) < 1e-10);
    CHECK(std::abs(pair.places[1].at - 0.38) < 1e-10);
    CHECK(kinds_of(search_of(parabola).value(1)) == Kinds{"undecided"});
    CHECK(search_of(parabola).value(1.0001).places.empty());
    const FoundPlaces jump = search_of([](double x) { return x < 0.314 ? 1.0 : 2.0; }).value(1.5);
    REQUIRE(kinds_of(jump) == Kinds{"jump"});
    CHECK(jump.places[0].from < 0.314);
    CHECK(jump.places[0].to >= 0.314);
    CHECK(jump.places[0].to - jump.places[0].from < 1e-14);
    CHECK(kinds_of(search_of([](double x) { return x; }, 10, 1e-3).value(0.5)) == Kinds{"crossing"});
    const AmplitudeAt through_zero = [](double x) -> Tried<Certified> { return {Certified{1 + x, 1e-13}}; };
    CHECK(kinds_of(AmplitudeSearch({-1, 1}, through_zero).value(1)) == Kinds{"crossing"}); // at zero itself
    const auto gap = [](double x) { return std::abs(x - 0.5) < 0.07 ? std::nan("") : x; };
    const FoundPlaces beside = search_of(gap).value(0.5); // no crossing where nothing is known
    CHECK(kinds_of(beside) == Kinds{"undecided"});
    CHECK(beside.unanswered == std::vector<double>{0.5});
    CHECK(in_words(beside.why) == in_words(Why::not_periodic));
    // Three sides of the value, the middle one without an answer about where it changes.
    const FoundPlaces torn = search_of([](double x) {
                                 return std::abs(x - 0.31) < 0.01 ? std::nan("") : x < 0.31 ? 1.0 : 2.0;
                             }).value(1.5);
    REQUIRE(kinds_of(torn) == Kinds{"undecided"});
    CHECK((torn.places[0].from <= torn.places[0].at && torn.places[0].at <= torn.places[0].to));
    const FoundPlaces top = search_of(parabola).extreme(true);
    REQUIRE(kinds_of(top) == Kinds{"extreme"});
    CHECK(top.places[0].from < 0.37);
    CHECK(top.places[0].to > 0.37);
    CHECK(top.places[0].to - top.places[0].from < 2e-6);
    CHECK(kinds_of(search_of(parabola).extreme(false)) == Kinds{"end of the interval"});
    const auto pole = [](double x) { return x == 0.5 ? std::nan("") : 1 / std::abs(x - 0.5); };
    CHECK(kinds_of(search_of(pole).extreme(true)) == Kinds{"undecided"});
    const FoundPlaces flat = search_of([](double x) { return std::max(0.0, 0.45 - x); }).extreme(false); // others are as good
    CHECK(kinds_of(flat) == Kinds{"undecided"});
    CHECK(search_of([](double) { return std::nan(""); }).extreme(true).places.empty());
}

TEST_CASE("beside a pole, where there is no answer, the amplitude is asked for as well", "[find]") {
    const std::string undamped =
        R"({"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0, "contact": 1, "load": 1, "r": 0.5,
        "beta": 0})";
    const FoundPlaces found = find_places(undamped, {"r", 0.3, 1.7}, wanted_from("amplitude of mass 1 = 5"), 4);
    REQUIRE(kinds_of(found) == Kinds{"crossing", "crossing"});
    CHECK(holds(found.places[0], sqrt(Real50(Real50(4) / 5)))); // 1 / |1 - r^2| = 5
    CHECK(holds(found.places[1], sqrt(Real50(Real50(6) / 5))));
    CHECK(found.unanswered == std::vector<double>{1});
}

TEST_CASE("sentences are read", "[find]") {
    const Wanted plain = wanted_from("  amplitude of mass 2=0.075 ");
    CHECK((plain.mass.index == 1 && plain.is == AmplitudeIs::value && plain.value == 0.075 && !plain.over));
    const Wanted nested = wanted_from("largest amplitude of mass 3 over frequency_hz 1:10 is least");
    REQUIRE(nested.over);
    CHECK((nested.mass.index == 2 && nested.is == AmplitudeIs::least && nested.of == AmplitudeIs::largest));
    CHECK((nested.over->key == "frequency_hz" && nested.over->from == 1 && nested.over->to == 10));
    for (const char* wrong :
         {"", "amplitude", "amplitude of mass", "amplitude of mass 0 = 1", "amplitude of mass 1.5 = 1", "amplitude of mass 1 = x",
          "amplitude of mass 1 = -1", "amplitude of mass 1 = 1 2", "amplitude of mass 1 is small", "amplitude of mass 1 is",
          "largest amplitude of mass 1 = 1", "amplitude of mass 1 over r 1:2 = 1", "largest amplitude of mass 1 over r 1-2 = 1",
          "largest amplitude of mass 1 over r", "amplitude of mass 1 = nan", "phase of mass 1 = 1",
          "amplitude of mass 1e300 = 1"}) {
        INFO(wrong);
        CHECK_THROWS_AS(wanted_from(wrong), InputError);
    }
}

TEST_CASE("what cannot be varied is refused by name", "[find][program]") {
    tests::expect(R"(
        2 foo            --between=0:1     < pair ! vary must be a key of the scene that has a number, but is foo
        2 mu             --between=1:2     < pair ! give the scene mu
        2 mass_ratios    --between=1:2     < pair ! mass_ratios/1
        2 mass_ratios/3  --between=1:2     < pair ! a place in it
        2 mass_ratios/0  --between=1:2     < pair ! a place in it
        2 r/1            --between=1:2     < pair ! a list
        2 beta           --between=1:0     < pair ! the lower one first
        2 beta           --between=0       < pair ! must be A:B
        2 beta           --between={.6|:2} < pair ! between must be A:B, two numbers, but is {}
        2 beta           --between=0:inf   < pair ! between must be written as a number, but is inf
        2 beta           --between=.6:2    < pair ! between must be written as a number, but is .6
        2 base_motion    --between=0:1     < pair ! vary must be a key of the scene that has a number, but is base_motion
        2 beta           --between=-2:-1   < pair ! beta must
        2 contact        --between=0.5:1.5 < pair ! contact must
        2 damping_ratios/1 --between=0:1   < pair ! damping_ratios is one number
        2 comment        --between=0:1     < pair {"comment": "a chain"} ! has a number
        2 beta           --between=0:1 --samples {1|1000000} < pair
        0 beta           --between=0:1e300 --samples 4 < pair > 0.503976330244
        0 beta           --between=0:0.9 --json < pair
          = {"places": "# 1", "complete": "not known", "unanswered": "# 0"}
          = {"places": {"0": {"is": "crossing"}}}
        0 beta           --between=-1:0.9 --json < pair
          = {"places": "# 1", "unanswered": {"10": "< 0"}}
    )",
                  "find - --so-that 'amplitude of mass 1 = 1' --vary");
    const tests::Run run = tests::run_program("find - --so-that 'amplitude of mass 1 = 1' --vary beta --between=0:1 --samples 4",
                                              tests::scene_text("pair") + "\n\n{\"r\": tr}");
    CHECK(run.status == 2);
    CHECK_THAT(run.error, Catch::Matchers::Contains("(at line 3, column "));
}

// Condition numbers of amplitudes, against derivatives by hand and against the scaling that units demand.

namespace {

using Conditions = std::map<std::string, std::vector<std::optional<double>>>;

Conditions conditions(const std::string& scene) {
    Conditions found;
    for (const ConditionOfAmplitudes& c : conditions_of(scene)) found.emplace(c.number, c.of_masses);
    return found;
}

std::string linear(const std::string& r) {
    return text_of_scene(R"(one {"damping_ratios": 0.1, "beta": 0, "mu": null, "r": )" + r + "}");
}

} // namespace

TEST_CASE("the condition of a mass without friction is the derivative by hand", "[condition]") {
    for (const double r : {0.5, 0.9, 1.0, 1.5, 3.0}) {
        const double zeta = 0.1, s = r * r, D = (1 - s) * (1 - s) + 4 * zeta * zeta * s;
        const Conditions found = conditions(linear(std::to_string(r)));
        INFO("r = " << r);
        REQUIRE(found.size() == 2); // beta is zero, and the two ratios are 1 by definition
        REQUIRE(found.at("r")[0]);
        CHECK(std::abs(*found.at("r")[0] - s * (2 * (1 - s) - 4 * zeta * zeta) / D) < 1e-5 * (1 + 1 / D));
        REQUIRE(found.at("damping_ratios")[0]);
        CHECK(std::abs(*found.at("damping_ratios")[0] + 4 * zeta * zeta * s / D) < 1e-5);
    }
}

TEST_CASE("conditions add up as the units of a scene ask", "[condition]") {
    for (const char* friction : {"20", "150"}) { // without stops, and with
        const std::string scene = text_of_scene(R"(two in hertz {"friction": )" + std::string(friction) + "}");
        const Conditions found = conditions(scene);
        INFO(scene);
        REQUIRE(found.size() == 9);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto of = [&](const char* number) {
                REQUIRE(found.at(number)[k]);
                return *found.at(number)[k];
            };
            const double forces = of("force") + of("friction"), masses = of("masses/1") + of("masses/2"),
                         springs = of("stiffnesses/1") + of("stiffnesses/2");
            CHECK(std::abs(forces - 1) < 1e-3);                                         // all forces twice as large
            CHECK(std::abs(forces + masses + springs) < 1e-3 * std::abs(masses));       // another unit of mass
            CHECK(std::abs(2 * masses - of("frequency_hz")) < 1e-3 * std::abs(masses)); // another unit of time
        }
    }
}

TEST_CASE("a condition that is not known is left out, and --condition goes with whole answers", "[condition][program]") {
    const std::string stuck = text_of_scene(R"(one {"damping_ratios": 0.1, "r": 0.5, "beta": 2})"); // the mass does not move
    for (const auto& [number, of_masses] : conditions(stuck)) CHECK(!of_masses[0]);
    expect(R"(
        0 solve - --condition --json < one {"damping_ratios": 0.1, "beta": 0, "mu": null, "r": 0.5}
          = {"condition": "# 2"}
          = {"condition": {"r": "# 1"}}
        0 solve - --condition < one {"damping_ratios": 0.1, "beta": 0, "mu": null, "r": 0.5} > for one of r
        2 solve - --condition {--samples 4|--mass 1|--ask regime} < one ! condition must
    )");
}

TEST_CASE("amplitudes that hang on the last digits of a scene come with a warning, others do not",
          "[condition][program][solve]") {
    const auto asked = [](const std::string& r, const std::string& zeta, const std::string& command = "solve --json") {
        return answer_of(command, R"(one {"beta": 0.1, "damping_ratios": )" + zeta + R"(, "r": )" + r + "}");
    };
    // The amplitude at two neighbouring doubles, r of the second a unit in the last place above that of the first.
    const double far = asked("1.0000000000001", "0")["masses"][0]["amplitude"],
                 near = asked("1.0000000000001003", "0")["masses"][0]["amplitude"];
    CHECK(std::abs(far / near - 1) > 1e-3);
    CHECK(asked("1.0000000000001", "0")["warning"].get<std::string>().find("mode 1 has next to no damping") != std::string::npos);
    for (const auto& [r, zeta] : {std::pair("1.0000000001", "0"), {"1.0000000000001", "1e-9"}, {"0.5", "0"}})
        CHECK_FALSE((asked(r, zeta).contains("warning") || asked(r, zeta, "response --json").contains("warning")));
    // Friction that stops the contact bounds a mode, unless the contact is at its node.
    CHECK_FALSE(answer_of("solve --json", R"(undamped {"r": 1.0000000000001, "beta": 0.9})").contains("warning"));
    for (const std::string beta : {"2", "10"})
        CHECK(answer_of("solve --json", R"(node {"r": 1.414213562373, "beta": )" + beta + "}").contains("warning"));
    CHECK(asked("1.0000000000001", "0", "response --json")["warning"] == asked("1.0000000000001", "0")["warning"]);
}
