// Invariant points, proved: against the paper's own formulas, and known ones; and twins that are noticed.
#include "denhartog/reference/invariant_points.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "denhartog/answer/reference.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/search/zeros.hpp"
#include "tests/reference/surveyed_scenes.hpp"
#include "tests/support/named_scenes.hpp"
#include "tests/support/sample_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

using Points = std::vector<InvariantPointsOfMass<Certified>>;

// A contact between two masses, loads on several, masses that only friction couples, and modes of one frequency but for a part.
const std::string further_systems[] = {"parted", "loaded apart", "joined by mass", "joined by friction"};

Points proved_points(const SceneSource& source, const char* from, const char* to, int digits) {
    return invariant_points(source, {from, to}, digits);
}

// V and U of a mass and of the contact.
struct PaperFunctions {
    Ball V_k{}, V_j{}, U_k{}, U_j{};
};

// The modes at r = 1, damping left out.
reference::ModesInBalls undamped_modes(const SceneSource& source) {
    Scene<Ball> scene;
    source->in_balls(scene);
    scene.r = Ball(1);
    reference::SceneInBalls s = reference::in_matrices(scene);
    s.zeta.clear();
    return reference::modes_in_balls(s);
}

// By the paper's own formulas (23), (28), (33), (34) at zeta = 0.
PaperFunctions paper_functions(const reference::ModesInBalls& m, const Ball& r, std::size_t k) {
    std::vector<Ball> R, u;
    std::vector<Complex<Ball>> v;
    for (const Ball& at_one : m.R) {
        R.push_back(r * at_one);
        v.push_back(paper::complex_response(R.back(), Ball(0)));
        u.push_back(paper::first_damping_function(R.back(), Ball(0)));
    }
    const auto V = [&](const std::vector<Ball>& phi) { return paper::complex_response_of_mass<Ball>(phi, m.at_load(), R, v).re; };
    const auto U = [&](const std::vector<Ball>& phi) { return paper::damping_function_of_mass<Ball>(phi, m.at_contact(), R, u); };
    const Ball scale = 1 / (r * r); // psi = phi / r
    return {scale * V(m.psi[k]), scale * V(m.at_contact()), scale * U(m.psi[k]), scale * U(m.at_contact())};
}

// The signs of V_j U_k - 2 V_k U_j and of U_k on a grid, against the points that were found: between two places of the grid
// without a pole the sign changes where the number of points is odd, and nowhere else.
struct SignsCompared {
    int stretches = 0, changes = 0;
    std::vector<std::string> amiss{};
};

bool changes(const Ball& x, const Ball& y) { return (x > Ball(0)) != (y > Ball(0)); }

void compare(const std::string& name, const SceneSource& source, double shift, SignsCompared& all) {
    constexpr double from = 0.4, to = 2.5;
    constexpr int steps = 250;
    const Points found = proved_points(source, "0.4", "2.5", 15);
    const Bits few(96);
    const reference::ModesInBalls m = undamped_modes(source);
    if (!m.clusters.empty()) return;
    const auto has_pole = [&](double a, double b) {
        return std::ranges::any_of(m.R, [&](const Ball& R) {
            const double r_n = static_cast<double>(1 / R);
            for (double n = 1; r_n / n > a * (1 - 1e-9); n += 2)
                if (r_n / n < b * (1 + 1e-9)) return true;
            return false;
        });
    };
    for (const InvariantPointsOfMass<Certified>& mass : found) {
        if (!mass.undecided.empty()) continue;
        const std::size_t k = mass.mass.index;
        const bool is_the_contact = std::ranges::equal(m.psi[k], m.at_contact(), [](const Ball& x, const Ball& y) { // no (87)
            return arb_overlaps(x.a, y.a) != 0;
        });
        double a{};
        std::optional<PaperFunctions> at_a;
        for (int n = 1; n <= steps; ++n) {
            const double b = from + (to - from) * (n + 0.25) / (steps + 1);
            const PaperFunctions at_b = paper_functions(m, Ball(b), k);
            const double before = std::exchange(a, b);
            const std::optional<PaperFunctions> left = std::exchange(at_a, at_b);
            if (!left || has_pole(before, b)) continue;
            const bool by_common_factor = changes(left->V_j, at_b.V_j) && changes(left->V_k, at_b.V_k); // that is no root of (87)
            for (const auto kind : {InvariantPointKind::two_effects_cancel, InvariantPointKind::friction_leaves_it_alone}) {
                const auto value = [&](const PaperFunctions& f) {
                    return kind == InvariantPointKind::friction_leaves_it_alone ? f.U_k : f.V_j * f.U_k - 2 * f.V_k * f.U_j;
                };
                const Ball x = value(*left), y = value(at_b);
                if (kind == InvariantPointKind::two_effects_cancel && (is_the_contact || by_common_factor)) continue;
                if (x.may_vanish() || y.may_vanish()) continue;
                const auto points = std::ranges::count_if(mass.points, [&](const InvariantPoint<Certified>& p) {
                    return p.kind == kind && p.r.value + shift > before && p.r.value + shift < b;
                });
                ++all.stretches;
                all.changes += changes(x, y);
                if (changes(x, y) != (points % 2 == 1))
                    all.amiss.push_back(name + ", mass " + std::to_string(k + 1) + " next to r = " + number_to_text(b));
            }
        }
    }
}

// Of the points of 40 digits, those at which a function may vanish, and is known well.
struct PointsChecked {
    int vanish = 0, all = 0, by_87 = 0;
};

template <class Function>
PointsChecked checked(const SceneSource& source, const Function& of_87) {
    PointsChecked c;
    const Bits enough(256);
    const reference::ModesInBalls m = undamped_modes(source);
    REQUIRE(m.clusters.empty());
    for (const InvariantPointsOfMass<Certified>& mass : proved_points(source, "0.4", "2.5", 40))
        for (const InvariantPoint<Certified>& p : mass.points) {
            const PaperFunctions f = paper_functions(m, ball_of(p.r), mass.mass.index);
            const bool by_87 = p.kind == InvariantPointKind::two_effects_cancel;
            const Ball value = by_87 ? of_87(f) : f.U_k;
            ++c.all;
            c.by_87 += by_87;
            c.vanish += value.may_vanish() && value.radius() < 1e-20;
            CHECK(apart(abs(f.V_k), ball_of(p.amplitude)) == 0);
        }
    return c;
}

Ball function_87(const PaperFunctions& f) { return paper::invariant_point_function(f.V_k, f.V_j, f.U_k, f.U_j); }

std::size_t undecided_in(const Points& points) {
    std::size_t count = 0;
    for (const auto& mass : points) count += mass.undecided.size();
    return count;
}

// sin(pi x) as a search sees it, from its values and slopes at the ends of stretches.
FunctionWithZeros sine_of_turns() {
    const auto f = [](const Ball& x) { return sin(pi<Ball>() * x); };
    return {[f](double a, double b) {
                const Ball X = Ball::within(a, b);
                if (!f(X).may_vanish()) return ZerosInStretch::none;
                if (cos(pi<Ball>() * X).may_vanish()) return ZerosInStretch::unknown;
                const Ball at_a = f(Ball(a)), at_b = f(Ball(b));
                if (at_a.may_vanish() || at_b.may_vanish()) return ZerosInStretch::unknown;
                return (at_a > Ball(0)) == (at_b > Ball(0)) ? ZerosInStretch::none : ZerosInStretch::one;
            },
            [f](double x) { return !f(Ball(x)).may_vanish(); }};
}

ZerosOnStretches zeros_of(const FunctionWithZeros& f, double a, double b) {
    ZerosOnStretches found;
    find_zeros(f, a, b, 1e-9, found);
    return found;
}

} // namespace

TEST_CASE("a search finds every zero of a function once, and says where it has no answer", "[zeros]") {
    const FunctionWithZeros f = sine_of_turns();
    const ZerosOnStretches found = zeros_of(f, 0.5, 8.5);
    CHECK(found.undecided.empty());
    REQUIRE(found.single.size() == 8);
    for (std::size_t n = 0; n < 8; ++n) {
        CHECK(found.single[n].from < static_cast<double>(n + 1));
        CHECK(found.single[n].to > static_cast<double>(n + 1));
    }
    const ZerosOnStretches in_the_middle = zeros_of(f, 0.5, 1.5);
    CHECK(in_the_middle.single.size() == 1);
    CHECK(in_the_middle.undecided.empty());
    const ZerosOnStretches at_end = zeros_of(f, 1, 2.5); // a zero at the end of the interval
    CHECK(at_end.single.size() == 1);
    REQUIRE(at_end.undecided.size() == 1);
    CHECK(at_end.undecided[0].from == 1);
    CHECK(at_end.undecided[0].to < 1 + 1e-8);
    FunctionWithZeros given_up = f;
    given_up.look = [](double, double) { return ZerosInStretch::hidden; };
    CHECK(zeros_of(given_up, 0.5, 8.5).undecided.size() == 1);
    given_up.look = [](double a, double b) { return b - a < 0.3 ? ZerosInStretch::hidden : ZerosInStretch::unknown; };
    const ZerosOnStretches whole = zeros_of(given_up, 0.5, 8.5);
    REQUIRE(whole.undecided.size() == 1);
    CHECK(whole.undecided[0].from == 0.5);
    CHECK(whole.undecided[0].to == 8.5);
    FunctionWithZeros wrong = f; // a function that excludes zeros too soon
    wrong.look = [look = f.look](double a, double b) { return b - a < 0.4 ? ZerosInStretch::none : look(a, b); };
    CHECK(zeros_of(wrong, 0.5, 8.5).single.size() < 8);
}

TEST_CASE("between two frequency ratios the paper's functions change their sign where there is a proved point, and nowhere else",
          "[invariant][eq:87][eq:33][eq:34]") {
    SignsCompared all, shifted;
    std::vector<std::string> systems;
    const auto add = [&](const std::string& name, const SceneSource& source) {
        compare(name, source, 0, all);
        if (shifted.changes < 100) compare(name, source, 0.01, shifted);
    };
    for (const SurveyedScene& each : surveyed_scenes()) {
        nlohmann::json system = each.json;
        for (const char* key : {"comment", "r", "beta", "mu"}) system.erase(key);
        const std::string text = system.dump();
        const System<double>& s = each.source->in_double().system;
        if (!s.load_phases.empty() || load_depends_on_frequency(s)) continue; // which has no such points
        if (number_of_masses(s) > 5 || std::ranges::count(systems, text) > 0) continue;
        systems.push_back(text);
        add(each.text, each.source);
    }
    const std::vector<RandomScene<double>> some = random_scenes<double>(87);
    for (std::size_t n = 0; n < some.size(); n += 3)
        if (number_of_masses(some[n].scene.system) < 5) add(some[n].name, scene_source(some[n].scene));
    for (const std::string& text : further_systems) add(text, named_source(text));
    for (const std::string& what : all.amiss) UNSCOPED_INFO(what);
    CHECK(all.amiss.empty());
    CHECK(all.changes > 1000);
    INFO(all.changes << " changes of sign in " << all.stretches << " stretches");
    CHECK(shifted.amiss.size() > static_cast<std::size_t>(shifted.changes));
}

TEST_CASE("at a proved point the paper's own formulas vanish, and a twin with a wrong sign or factor does not",
          "[invariant][eq:87][eq:33][eq:34]") {
    PointsChecked right, wrong_sign, wrong_factor;
    const auto add = [](PointsChecked& to, const PointsChecked& c) {
        to = {to.vanish + c.vanish, to.all + c.all, to.by_87 + c.by_87};
    };
    std::vector<SceneSource> sources;
    for (const std::string& text : further_systems) sources.push_back(named_source(text));
    for (const NamedScene<double>& each : paper_scenes<double>())
        if (number_of_masses(each.scene.system) == 5) sources.push_back(scene_source(each.scene));
    for (const SceneSource& source : sources) {
        add(right, checked(source, function_87));
        add(wrong_sign, checked(source, [](const PaperFunctions& f) { return 2 - function_87(f); }));
        add(wrong_factor, checked(source, [](const PaperFunctions& f) { return 1 + function_87(f); }));
    }
    CHECK(right.by_87 > 30);
    CHECK(right.vanish == right.all);
    CHECK(wrong_sign.vanish == wrong_sign.all - wrong_sign.by_87);
    CHECK(wrong_factor.vanish == wrong_factor.all - wrong_factor.by_87);
}

TEST_CASE("60 and 200 digits of invariant points agree to 60", "[invariant][eq:87]") {
    int points = 0;
    for (const std::string& text : further_systems) {
        const Points a = proved_points(named_source(text), "0.4", "2.5", 60);
        const Points b = proved_points(named_source(text), "0.4", "2.5", 200);
        const Bits enough(800);
        REQUIRE(a.size() == b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            REQUIRE(a[k].points.size() == b[k].points.size());
            for (std::size_t n = 0; n < a[k].points.size(); ++n, ++points)
                for (const auto& [x, y] : {std::pair(&a[k].points[n].r, &b[k].points[n].r),
                                           std::pair(&a[k].points[n].amplitude, &b[k].points[n].amplitude)}) {
                    CHECK(apart(ball_of(*x), ball_of(*y)) == 0);
                    CHECK(x->error <= 1e-59 * x->value);
                    CHECK(y->error <= 1e-199 * y->value);
                    CHECK((x->proved && y->proved));
                }
        }
    }
    CHECK(points > 20);
}

TEST_CASE("the points of one mass are r = 1/2, 1/4, 1/6 and so on, the ends of the range included, to all digits",
          "[invariant][eq:87]") {
    const SceneSource source = named_source(R"(undamped {"r": 1})");
    const Points found = proved_points(source, "0.125", "0.5", 95);
    const Bits enough(400);
    REQUIRE(found.size() == 1);
    CHECK(found[0].undecided.empty());
    REQUIRE(found[0].points.size() == 4);
    for (int n = 0; n < 4; ++n) {
        const Ball r = 1 / Ball(8 - 2 * n);
        const InvariantPoint<Certified>& p = found[0].points[static_cast<std::size_t>(n)];
        CHECK(apart(ball_of(p.r), r) == 0);
        CHECK(apart(ball_of(p.amplitude), 1 / (1 - r * r)) == 0);
        CHECK(p.kind == InvariantPointKind::friction_leaves_it_alone);
    }
}

TEST_CASE("masses that friction does not reach have no proved points, and a contact that the load does not reach leaves none",
          "[invariant][eq:87]") {
    const std::string system = R"(unloaded contact {"stiffness_matrix": [[2, 0], [0, 1]], "r": 1, "contact": 2, "load": )";
    const Points apart_from_it = proved_points(named_source(system + "2}"), "0.2", "2.5", 30);
    CHECK(apart_from_it[0].points.empty());
    CHECK(apart_from_it[1].points.size() == 2); // r = 1/2, 1/4
    CHECK(undecided_in(apart_from_it) == 0);
    const Points unloaded = proved_points(named_source(system + "1}"), "0.2", "2.5", 30);
    CHECK((unloaded[0].points.empty() && unloaded[1].points.empty() && undecided_in(unloaded) == 0));
}

TEST_CASE("where a mass beside the contact absorbs the load, V_j and V_k vanish and (87) has no root", "[invariant][eq:87]") {
    // Mass 1 is at resonance between its springs, r = sqrt(2), so the loaded mass 2 and all behind it are at rest.
    const SceneSource source =
        named_source(R"(undamped {"mass_ratios": [1, 1, 1], "stiffness_ratios": [1, 1, 1], "contact": 3, "load": 2, "r": 1})");
    const Points found = proved_points(source, "0.4", "2.5", 30);
    CHECK(undecided_in(found) == 0);
    CHECK(found[1].points.size() > 4);
    for (const InvariantPointsOfMass<Certified>& mass : found)
        for (const InvariantPoint<Certified>& p : mass.points) CHECK(std::abs(p.r.value - std::sqrt(2.0)) > 1e-6);
}

TEST_CASE("a pole of a mode whose node may be the contact is an undecided stretch", "[invariant][eq:87]") {
    // In a chain of four equal masses mass 3 does not move in the mode of r = 1.
    const SceneSource source = named_source(
        R"(undamped {"mass_ratios": [1, 1, 1, 1], "stiffness_ratios": [1, 1, 1, 1], "contact": 3, "load": 2, "r": 1.5})");
    const Points found = proved_points(source, "0.5", "2.5", 30);
    CHECK(undecided_in(found) > 0);
    CHECK(undecided_in(found) < 10);
    for (const InvariantPointsOfMass<Certified>& mass : found)
        for (const UndecidedStretch<Certified>& u : mass.undecided) {
            CHECK(std::abs(u.from.value - 1) < 1e-12);
            CHECK(std::abs(u.to.value - 1) < 1e-12);
        }
}

TEST_CASE(
    "invariant points are proved, to more digits than double has too, and refused where the work is spent or a rule is broken",
    "[invariant][eq:87]") {
    const SceneSource source = named_source(further_systems[1]);
    for (const int digits : {6, 15, 95, 1000}) {
        const Points found = invariant_points(source, {"0.5", "2"}, digits);
        for (const InvariantPointsOfMass<Certified>& mass : found)
            for (const InvariantPoint<Certified>& p : mass.points) CHECK((p.r.proved && p.amplitude.proved));
        CHECK(found[0].points.size() > 1);
    }
    {
        QuestionEffort little(3, 100);
        CHECK_THROWS_AS(invariant_points(with_effort(source, &little), {"0.5", "2"}, 30), PrecisionError);
    }
    for (const auto& [from, to] : {std::pair("0", "1"), std::pair("2", "1"), std::pair("1e-9", "1"), std::pair("a", "1")})
        CHECK_THROWS_AS(invariant_points(source, {from, to}, 30), InputError);
}
