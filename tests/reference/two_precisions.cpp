#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/reference/surveyed_scenes.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog::tests;
using namespace denhartog;

// Double, then the reference: what double leaves open is answered, or refused with the reasons of both.

TEST_CASE("a last digit above the boundary the stops are proved, of some 1e-15 of a radian", "[reference][orbit][eq:69]") {
    for (const int digits : {6, 12, 30}) {
        const Solution s = solve(named_source("grazing"), {Asked::motion, digits});
        CHECK(s.regime.regime == Regime::stick_slip);
        CHECK(s.method.proved);
        REQUIRE(s.stops.size() == 2);
        const double lasts = s.stops[0].end.value - s.stops[0].start.value;
        CHECK(lasts > 1e-15);
        CHECK(lasts < 1e-14);
    }
    // A last digit below it the contact slides.
    CHECK(solve(named_source(R"(grazing {"beta": "0.552171582623110"})"), {Asked::motion, 12}).regime.regime ==
          Regime::continuous);
}

TEST_CASE("a motion that no proof reaches is refused with the regime that is certain", "[reference][driver]") {
    CHECK(solve(named_source("nearly held"), {Asked::regime, 12}).regime.regime == Regime::stick_slip);
    CHECK_THROWS_AS(solve(named_source("nearly held"), {Asked::motion, 20}), PrecisionError);
    CHECK_THROWS_WITH(solve(named_source("nearly held"), {Asked::motion, {}}),
                      Catch::Contains("no motion with stops to start from. This much is certain: the closed form does not hold"));
}

TEST_CASE("modes of one frequency have no boundary in double, and with mu above 1 the reference proves what follows from rest",
          "[reference][driver][map]") {
    const std::string system = R"(triangle {"stiffness_matrix": [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]], "damping_ratios": 0.05,
        "load": 2, "mu": 1.2, "r": 1.3, "beta": )";
    const auto answer = [&](const std::string& beta) { return solve(named_source(system + beta + "}"), {Asked::motion, {}}); };
    const Solution slides = answer("0.3"), stops = answer("1");
    CHECK(slides.regime.regime == Regime::continuous);
    CHECK(stops.regime.regime == Regime::stick_slip);
    CHECK(stops.stops.size() == 2);
    CHECK(answer("3").regime.regime == Regime::permanent_sticking);
    for (const Solution* s : {&slides, &stops}) {
        CHECK(s->method.proved);
        CHECK(s->limits.value().exact.value == Approx(0.617707853387));
    }
    for (const MapStart start : {MapStart::rest, MapStart::sliding}) {
        const MapRequest request{{1.3}, {0.3, 1}, {Mass{0}}, start, 1};
        const RegimeMap map = regime_map(named_scene(system + "null}"), request, std::atomic<bool>(false));
        CHECK(map.points[0].status == PointStatus::answered);
        CHECK(map.amplitudes[0] == Approx(slides.masses[0].amplitude.value));
        CHECK(map.points[1].status == (start == MapStart::rest ? PointStatus::answered : PointStatus::failed));
    }
}

TEST_CASE("(56) of a damping matrix next to a modal one is that of the modes, in double and by the reference",
          "[reference][eq:56]") {
    const auto limits = [](const char* entry, bool proved) {
        const std::string scene = R"(coupled {"mass_ratios": [1, 0.8], "stiffness_ratios": [1, 0.9], "r": 0.6, "beta": null,
            "damping_matrix": [[)" +
                                  std::string(entry) + R"(, -0.027], [-0.027, 0.067]]})";
        return sliding_answer(named_source(scene), std::nullopt, proved).limits.value();
    };
    const double modal = limits("0.107", false).paper.value, exact = limits("0.107", false).exact.value;
    CHECK(modal < 0.99 * exact);
    for (const char* entry : {"0.10700000000000108", "0.107000000001", "0.10700000107"}) {
        INFO(entry);
        const Limits few = limits(entry, false), many = limits(entry, true);
        CHECK(std::abs(few.paper.value - many.paper.value) <= few.paper.error + many.paper.error);
        CHECK(many.paper.value == Approx(modal).epsilon(1e-6));
    }
    const SceneSource overdamped = named_source(R"(coupled {"mass_ratios": [1, 1.75], "stiffness_ratios": null, "beta": null,
        "stiffness_matrix": [[2, -1], [-1, 1]], "contact": 1, "r": 4.16, "mu": 1.3,
        "damping_matrix": [[1.6, -0.30000000022448803], [-0.30000000022448803, 2.05]]})");
    const Limits few = sliding_answer(overdamped, std::nullopt, false).limits.value(),
                 many = sliding_answer(overdamped, std::nullopt, true).limits.value();
    CHECK(std::abs(few.paper.value - many.paper.value) <= few.paper.error + many.paper.error);
    const Limits couples = limits("0.1071", false); // no mode moves by itself
    CHECK(couples.paper.value == couples.exact.value);
    CHECK(limits("0.1071", true).paper.value == limits("0.1071", true).exact.value);
    const SceneSource with_friction = named_source(R"(coupled {"mass_ratios": [1, 0.8], "stiffness_ratios": [1, 0.9], "r": 0.6,
        "beta": 0.01, "damping_matrix": [[0.10700000107, -0.027], [-0.027, 0.067]]})");
    for (const Asked asked : {Asked::amplitude, Asked::motion}) { // whatever is asked
        const Solution s = solve(with_friction, {asked, std::nullopt});
        CHECK(s.method.precision == "double");
        CHECK(s.limits.value().paper.value == Approx(modal).epsilon(1e-6));
    }
}

TEST_CASE("a damping matrix counts as modal within its tolerance, to any digits", "[reference][eq:18]") {
    const auto amplitude = [](const std::string& tolerance, int digits) {
        return solve(named_source(R"(coupled {"damping_tolerance": )" + tolerance + "}"), {Asked::motion, digits})
            .masses[1]
            .amplitude.value;
    };
    // The difference of K M^-1 C and C M^-1 K, over the sizes of both, is 0.218.
    CHECK(amplitude("0.5", 6) == Approx(amplitude("0.5", 30)).epsilon(1e-12));
    CHECK(amplitude("0.5", 30) == Approx(amplitude("2", 30)).epsilon(1e-15));
    CHECK(amplitude("0.01", 6) == Approx(amplitude("0.01", 30)).epsilon(1e-12));
    CHECK(amplitude("0.01", 30) == Approx(amplitude("0", 30)).epsilon(1e-15));
    CHECK(std::abs(amplitude("0", 30) - amplitude("2", 30)) > 1e-6);
}

TEST_CASE("far above the resonances an overdamped mode takes the bits that show its demand", "[reference][eq:56][eq:69]") {
    // (56) and (69) of one mode are one number.
    for (const std::string r : {"1e5", "1e20", "1e50", "1e150"}) {
        const SceneSource scene = named_source(R"(undamped {"damping_ratios": 32879.2, "r": )" + r + "}");
        const Limits limits = sliding_answer(scene, 20, true).limits.value();
        CHECK(limits.exact.decimal == limits.paper.decimal);
        CHECK(limits.exact.value > 0);
    }
}

TEST_CASE("an amplitude below all doubles is zero to within the least of them, or text", "[reference][driver]") {
    const SceneSource far = named_source(R"(long period {"damping_ratios": 0.1, "load": 2, "r": 1e120, "beta": 0})");
    const Solution few = solve(far, {Asked::motion, {}}), more = solve(far, {Asked::motion, 20});
    CHECK(few.masses[0].amplitude.value == 0);
    CHECK(few.masses[0].amplitude.error == std::numeric_limits<double>::denorm_min());
    CHECK(more.masses[0].amplitude.decimal.ends_with("e-362"));
}

TEST_CASE("first and third derivative of a friction motion add up to what the equation of motion says, and no other does",
          "[reference][eq:41]") {
    const Bits enough(256);
    for (const auto& [R, zeta] : {std::pair(1.0, 0x1p-20), {1 + 0x1p-20, 0x1p-10}, {0.375, 0.25}, {5.0, 0.5}}) {
        const reference::FrictionMotionOfMode mode{Ball(R), Ball(zeta)}, other{Ball(R), Ball(zeta * (1 + 0x1p-10))};
        for (const double tau : {0.25, 1.5, 3.0}) {
            const reference::Series F = mode.at(Ball(tau)), sum = mode.rate_and_third(F);
            const Ball direct = F.c[1] + 6 * F.c[3];
            INFO("R = " << R << ", zeta = " << zeta << ", tau = " << tau);
            CHECK(arb_overlaps(sum.c[0].a, direct.a) != 0);
            CHECK(arb_overlaps(sum.c[1].a, Ball(2 * F.c[2] + 24 * F.c[4]).a) != 0);
            CHECK(arb_overlaps(other.rate_and_third(F).c[0].a, direct.a) == 0);
        }
    }
}

TEST_CASE("the largest value of a quotient is the same with n'' + n given, and a wrong one is found out", "[reference][eq:69]") {
    const Bits enough(256);
    const reference::FrictionMotionOfMode mode{Ball(0.75), Ball(0.0625)};
    const auto n = [&](const Ball& tau) {
        return reference::Series(mode.u) * cos(reference::Series::time(tau)) + mode.at(tau).derivative();
    };
    const auto Z = [&](const Ball& tau) { return mode.rate_and_third(mode.at(tau)); };
    const Ball largest = reference::largest_over_sine(n).value;
    CHECK(arb_overlaps(reference::largest_over_sine(n, Z).value.a, largest.a) != 0);
    bool agrees = false;
    try {
        const auto wrong = [&](const Ball& tau) { return -Z(tau); };
        agrees = arb_overlaps(reference::largest_over_sine(n, wrong).value.a, largest.a) != 0;
    } catch (const reference::Unproved&) {
    }
    CHECK_FALSE(agrees);
}

// Systems that the reference prepares for the exact solver in double.

namespace {

SceneSource source_of(const std::string& json) { return scene_source(SceneText{json, 1, true}); }

/// Checks that two matrices agree beside the largest entry.
void same(const char* name, const Matrix<double>& one, const Matrix<double>& other) {
    INFO(name);
    REQUIRE(one.rows() == other.rows());
    REQUIRE(one.cols() == other.cols());
    if (one.size() > 0) CHECK((one - other).cwiseAbs().maxCoeff() <= 1e-12 * one.cwiseAbs().maxCoeff());
}

Matrix<double> column(const std::vector<double>& x) {
    return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

Matrix<double> real_parts(const std::vector<Complex<double>>& x) {
    std::vector<double> parts;
    for (const Complex<double>& each : x) parts.push_back(each.re);
    return column(parts);
}

} // namespace

TEST_CASE("a system prepared by the reference is that of double, where double has its digits", "[eq:15][eq:19][stuck]") {
    for (const char* json :
         {R"({"mass_ratios":[1,2,0.5],"stiffness_ratios":[1,3,1],"damping_ratios":[0.1,0.02,0.3],"contact":2,"load":3})",
          R"({"mass_ratios":[1,2,0.5],"stiffness_ratios":[1,3,1],"damping_matrix":[[0.3,-0.1,0],[-0.1,0.2,-0.05],[0,-0.05,0.1]],
                 "contact":[3,1],"load":[1,0.5,0.25]})",
          R"({"mass_ratios":[1,2],"stiffness_ratios":[1,3],"damping_ratios":[0,0],"contact":[1,2],"load":1})",
          R"({"mass_ratios":[1],"stiffness_ratios":[1],"damping_ratios":[0.1],"contact":1,"load":1})"}) {
        INFO(json);
        const SceneSource source = source_of(json);
        const ContactSystem one = contact_system(source->in_double().system);
        const ContactSystem other = moving_by_reference(source, "a test").required();
        CHECK(in_words(other.rounded_because) == "a test");
        same("r_n", column(one.basis.r_n), column(other.basis.r_n));
        same("phi", one.basis.phi, other.basis.phi);
        same("zeta", column(one.basis.zeta), column(other.basis.zeta));
        same("D", one.basis.D, other.basis.D);
        same("momentum", one.momentum, other.momentum);
        same("load", real_parts(one.modal_load), real_parts(other.modal_load));
        same("contact", one.contact_shape, other.contact_shape);
        same("damping matrix", one.stuck.C, other.stuck.C);
        same("r_n held", column(one.stuck.r_n), column(other.stuck.r_n));
        same("phi held", one.stuck.phi.cwiseAbs(), other.stuck.phi.cwiseAbs());
        same("damping held", one.stuck.damping.cwiseAbs(), other.stuck.damping.cwiseAbs());
        CHECK(one.stuck.k_contact == Approx(other.stuck.k_contact).epsilon(1e-12));
        for (const double part : other.detuned) CHECK(part <= 1e-15);
    }
}

TEST_CASE("two masses in contact that a spring ties too stiffly for double are refused", "[eq:6]") {
    const auto cycles = [](const std::string& stiffness) {
        PaperSettings settings;
        settings.cycles = 20;
        return exact_cycles(
            source_of(R"({"contact": [2, 1], "mass_ratios": [1, 1, 2], "damping_ratios": 0.08894, "load": 3, "r": 0.5,
                                          "beta": 0.3, "stiffness_ratios": [1, )" +
                      stiffness + ", 4.979]}"),
            settings);
    };
    CHECK(cycles("1e9").stops.size() == 2);
    CHECK_THROWS_WITH(cycles("1e10"), Catch::Contains("tied so stiffly"));
}

TEST_CASE("beside a stiff spring the exact cycles end in the steady motion, for a contact between two masses too", "[eq:6]") {
    const SceneSource source = source_of(
        R"({"mass_ratios":[1,2,3],"stiffness_matrix":[[2,-1,0],[-1,1.0000000000001e13,-1e13],[0,-1e13,1e13]],
            "damping_ratios":[0.3,0.3,0.3],"contact":[2,1],"load":1,"mu":1,"beta":0.05,"r":0.8})");
    PaperSettings settings;
    settings.cycles = 60;
    const PaperMotion cycles = exact_cycles(source, settings);
    REQUIRE(cycles.status == IntegrationStatus::complete);
    const Solution steady = solve(source, {});
    for (std::size_t k = 0; k < 3; ++k)
        CHECK(cycles.masses[k].amplitude == Approx(steady.masses[k].amplitude.value).epsilon(1e-9));
}

// Seeded scenes of every kind: what `solve` tells of them in double lies within its bounds of the proved numbers. A sample here;
// a hundred thousand of them with the preset `sweeps`, or as many as DENHARTOG_SCENES says, from DENHARTOG_SEED on.

namespace {

// Numbers of three digits, so that a scene that fails can be read.
class RandomScenes {
public:
    explicit RandomScenes(std::uint64_t seed) : bits_(seed) {}

    nlohmann::json scene() {
        const int N = whole(1, 5);
        nlohmann::json s;
        s["mass_ratios"] = ratios(N);
        s["stiffness_ratios"] = ratios(N);
        if (whole(0, 2) == 0)
            s["damping_matrix"] = dashpots(N);
        else
            for (int i = 0; i < N; ++i)
                s["damping_ratios"].push_back(whole(0, 11) == 0 ? 0 : power(-3.5, whole(0, 4) == 0 ? 0.5 : -0.7));
        const int contact = whole(1, N);
        s["contact"] = contact;
        if (N > 1 && whole(0, 3) == 0) s["contact"] = {contact, contact % N + 1};
        s["load"] = whole(1, N);
        if (whole(0, 3) == 0) {
            s["load"] = nlohmann::json::array();
            for (int i = 0; i < N; ++i) s["load"].push_back(rounded(uniform(-1, 1)));
        }
        if (whole(0, 1) == 0) s["mu"] = rounded(uniform(1, 2));
        s["r"] = power(-1.5, whole(0, 2) == 0 ? 2.2 : 0.5);
        s["beta"] = whole(0, 15) == 0 ? 0 : power(-4, 0.2);
        return s;
    }

private:
    double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53; }
    int whole(int low, int high) { return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1)); }
    static double rounded(double x) {
        if (x == 0) return 0;
        const double unit = std::pow(10.0, 2 - std::floor(std::log10(std::abs(x))));
        return std::round(x * unit) / unit;
    }
    double power(double low, double high) { return rounded(std::pow(10.0, uniform(low, high))); }
    nlohmann::json ratios(int N) {
        nlohmann::json all{1};
        for (int i = 1; i < N; ++i) all.push_back(rounded(uniform(0.4, 2.5)));
        return all;
    }
    // Dashpots beside the springs: they couple the modes.
    nlohmann::json dashpots(int N) {
        std::vector<std::vector<double>> C(static_cast<std::size_t>(N), std::vector<double>(static_cast<std::size_t>(N)));
        for (std::size_t i = 0; i < C.size(); ++i) {
            const double c = rounded(uniform(0.01, 0.3));
            C[i][i] += c;
            if (i == 0) continue;
            C[i - 1][i - 1] += c;
            C[i][i - 1] = C[i - 1][i] = -c;
        }
        return C;
    }

    std::mt19937_64 bits_;
};

} // namespace

TEST_CASE("every number of random scenes in double lies within its bound of the proved one", "[scenes][accuracy]") {
    const bool all = std::getenv("DENHARTOG_SWEEPS") != nullptr;
    const char *scenes_asked = std::getenv("DENHARTOG_SCENES"), *seed = std::getenv("DENHARTOG_SEED");
    const int count = scenes_asked != nullptr ? std::stoi(scenes_asked) : all ? 100'000 : 150;
    RandomScenes scenes(seed != nullptr ? std::stoull(seed) : 20261128);
    SurveyOfBounds survey;
    int refused = 0;
    for (int n = 0; n < count; ++n) {
        const std::string text = scenes.scene().dump();
        INFO(text);
        const SceneSource source = scene_source(SceneText{text});
        survey.scene = text;
        try {
            survey_answer("solve", solve(source, {}), proved_answer(source), survey);
        } catch (const PrecisionError&) {
            ++refused; // by double, or for want of a proof
        } catch (const DomainError&) {
            ++refused;
        }
    }
    for (const std::string& difference : survey.differences) {
        INFO(difference);
        CHECK(difference.empty());
    }
    long numbers = 0;
    for (const auto& [kind, held] : survey.kinds) {
        numbers += static_cast<long>(held.size());
        for (const NumberHeld& n : survey.beyond(kind, 1)) {
            INFO(kind << " is off by " << n.off << ": " << n.where);
            CHECK(n.off <= n.bound);
        }
    }
    std::printf("%ld numbers of %d random scenes; %d scenes without an answer or a proof\n", numbers, count, refused);
    CHECK(numbers > 10 * count);
    CHECK(50 * refused < count);
}
