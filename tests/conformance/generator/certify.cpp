#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/conformance/generator/number_digits.hpp"
#include "tests/conformance/generator/scene_routes.hpp"
#include "tests/conformance/generator/vector_files.hpp"

namespace denhartog::conformance::generator {
namespace {

// Factor by which a mistaken answer has to exceed the bound of inaccurate ones: mistakes compute in double, whose last digits
// must not decide a verdict.
constexpr double clear_by = 4;

// Least distance of a sample to the true curve within a step on either side: no way to judge a curve is more lenient.
double distance_to_curve(double x, const std::vector<double>& curve, std::size_t n) {
    const std::size_t count = curve.size();
    const auto [low, high] = std::minmax({curve[(n + count - 1) % count], curve[n], curve[(n + 1) % count]});
    return std::max({0.0, low - x, x - high});
}

bool is_wrong(const Vector& v, const Value& given) {
    if (!v.word.empty()) return given.word != v.word;
    if (given.numbers.size() != v.nearest.size()) return true;
    const Quantity& asked = quantity(v.question.quantity);
    double largest = 0;
    for (std::size_t n = 0; n < given.numbers.size(); ++n) {
        double error = std::abs(given.numbers[n] - v.nearest[n]);
        if (asked.angle) error = std::abs(std::remainder(error, 2 * std::acos(-1.0)));
        if (asked.shape == Shape::samples) error = distance_to_curve(given.numbers[n], v.nearest, n);
        largest = std::max(largest, error);
    }
    return largest > clear_by * v.tolerance.inaccurate * v.scale;
}

} // namespace

std::vector<std::string> catches_of(const Vector& v) {
    std::vector<std::string> names;
    for (const Mistake& mistake : mistakes()) {
        const std::optional<Value> given = answer_with_mistake(mistake.name, v.question);
        if (given && is_wrong(v, *given)) names.push_back(mistake.name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

namespace {

// Digits are counted so far: beyond, a count would depend on the last digits.
constexpr std::array<int, 2> counted{40, 80};

struct Undecided : std::runtime_error {
    using std::runtime_error::runtime_error;
};

Regime regime_of_scene(const Regimes& b, const Real50& beta) {
    if (beta < b.sliding) return Regime::continuous;
    return b.sticking && beta >= *b.sticking ? Regime::permanent_sticking : Regime::stick_slip;
}

double margin_of(const Regimes& b, const Real50& beta) {
    using std::abs;
    Real50 least = abs(Real50(beta / b.sliding - 1));
    if (b.sticking) least = std::min(least, Real50(abs(Real50(beta / *b.sticking - 1))));
    return two_digits(least);
}

std::vector<std::string> sorted(std::vector<std::string> flags) {
    std::sort(flags.begin(), flags.end());
    flags.erase(std::unique(flags.begin(), flags.end()), flags.end());
    return flags;
}

std::vector<std::string> flags_of(const Vector& asked) {
    const ProtocolQuestion& q = asked.question;
    std::vector<std::string> flags = beyond_the_paper(q);
    flags.insert(flags.end(), asked.flags.begin(), asked.flags.end());
    const auto unequal = [](const std::vector<double>& x) {
        return std::any_of(x.begin(), x.end(), [&](double y) { return y != x[0]; });
    };
    if (unequal(q.mass_ratios)) flags.emplace_back("unequal-masses");
    if (unequal(q.stiffness_ratios)) flags.emplace_back("unequal-springs");
    if (unequal(q.damping_ratios)) flags.emplace_back("unequal-damping");
    if (q.mu > 1) flags.emplace_back("mu");
    if (std::count(q.damping_ratios.begin(), q.damping_ratios.end(), 0.0) > 0) flags.emplace_back("undamped");
    if (std::any_of(q.damping_ratios.begin(), q.damping_ratios.end(), [](double z) { return z > 1; }))
        flags.emplace_back("overdamped");
    if (masses_of(q) > 1 && q.contact_with == 0 && q.load != 0)
        flags.emplace_back(q.contact < q.load    ? "contact-before-load"
                           : q.contact == q.load ? "contact-at-load"
                                                 : "contact-behind-load");
    return sorted(flags);
}

std::string harder(const std::string& a, const std::string& b) {
    const auto rank = [](const std::string& t) { return t == "must" ? 0 : t == "should" ? 1 : 2; };
    return rank(a) >= rank(b) ? a : b;
}

std::string tier_of(const Vector& v, double condition) {
    std::string tier = masses_of(v.question) <= 5 && condition <= 512 ? "must" : condition <= 1e6 ? "should" : "stress";
    if (v.margin && *v.margin < 1e-3) tier = harder(tier, *v.margin < 1e-9 ? "stress" : "should");
    return harder(tier, v.tier);
}

Tolerance tolerance_of(const ProtocolQuestion& q, double condition) {
    if (q.quantity == "stops_per_period") return {0, 0, 0};
    if (q.quantity == "motion_under_force") return {1e-6, 1e-3, 3e-2};
    const auto at_least = [](double least, double power, double condition_) {
        return two_digits(std::max(Real50(least), Real50(Real50(power) * Real50(condition_))));
    };
    Tolerance t{at_least(1e-11, 0x1p-44, condition), at_least(1e-7, 0x1p-38, condition), 0};
    t.inaccurate = std::min(3e-2, at_least(1e-3, 0x1p-18, condition));
    t.loose = std::min(t.loose, t.inaccurate);
    t.pass = std::min(t.pass, t.loose);
    return t;
}

void agree(Vector& v, Certified& all, std::size_t place, std::optional<int> digits) {
    if (!digits) throw Undecided("a route gives no numbers");
    if (place == 1 && *digits < least_digits)
        throw Undecided("in 100 digits the routes agree on " + std::to_string(*digits) + " only");
    all.least[place] = std::min(all.least[place], *digits);
    v.digits[place] = std::min(*digits, counted[place]);
}

void certify_regime(Vector& v, SceneRoutes& routes, Certified& all) {
    for (const char* name : {"beta_lim_exact", "beta_lim_sticking"}) {
        const ProtocolQuestion q = [&] {
            ProtocolQuestion other = v.question;
            other.quantity = name;
            return other;
        }();
        const std::array<int, 2> before = v.digits;
        agree(v, all, 0, agreement(routes.first<Real50>(q), routes.second<Real50>(q), false));
        agree(v, all, 1, agreement(routes.first<Real100>(q), routes.second<Real100>(q), false));
        if (before[1] > 0) v.digits = {std::min(before[0], v.digits[0]), std::min(before[1], v.digits[1])};
    }
    v.word = v.regime;
}

void certify_numbers(Vector& v, SceneRoutes& routes, Certified& all) {
    using std::abs;
    const ProtocolQuestion& q = v.question;
    const bool angle = quantity(q.quantity).angle;
    const std::vector<Real50> in_50 = routes.first<Real50>(q);
    agree(v, all, 0, agreement(in_50, routes.second<Real50>(q), angle));
    const std::vector<Real100> in_100 = routes.first<Real100>(q);
    agree(v, all, 1, agreement(in_100, routes.second<Real100>(q), angle));
    const Real100 zero = (angle ? Real100(1) : scale_of(in_100)) * Real100("1e-85");
    for (const Real100& x : in_100) {
        const Real100 counts = abs(x) < zero ? Real100(0) : x;
        if (counts != 0 && abs(counts) < Real100("1e-290")) throw Undecided("a number is below the range of double");
        v.value.push_back(text_of_digits(counts, 40));
        v.nearest.push_back(std::strtod(v.value.back().c_str(), nullptr));
        v.scale = std::max(v.scale, std::abs(v.nearest.back()));
    }
    if (angle || v.scale == 0) v.scale = 1;
    double largest = 0;
    if (q.quantity != "stops_per_period")
        for (const auto& [input, number] : routes.condition(q, in_50, Real50(v.scale))) {
            v.condition.emplace_back(input, two_digits(number));
            largest = std::max(largest, v.condition.back().second);
        }
    std::sort(v.condition.begin(), v.condition.end()); // by name, as JSON objects are read
    if (largest > 1e9) throw Undecided("a condition number is above 1e9");
    v.tolerance = tolerance_of(q, largest);
    v.tier = tier_of(v, largest);
    // So small a number is left by modes that cancel each other: double loses digits, whatever the condition numbers.
    if (is_of_systems(v) && v.scale < 0x1p-16) v.tier = "stress";
}

Vector plain_vector(const Vector& asked) {
    Vector v;
    v.question = asked.question;
    v.group = asked.group;
    v.equation = quantity(v.question.quantity).equation;
    v.tier = asked.tier;
    v.flags = flags_of(asked);
    return v;
}

// True if a motion from rest stays in the regime. With mu > 1 it may not, and the answer would depend on the start.
bool comes_from_rest(const ProtocolQuestion& q, Regime regime) {
    if (q.mu == 1) return true;
    try {
        return solve(scene_source(scene_of(q)), {Asked::regime, 12, false}).regime.regime == regime;
    } catch (const std::exception&) {
        return false;
    }
}

// A motion with stops: what is asked about must not depend on the start. Where it does not mirror itself, its mirror image is a
// steady motion too; and what is said of a period must hold in each.
void look_at_motion(Vector& v, const OrbitSeen& seen) {
    const std::string& asked = v.question.quantity;
    const bool mirrored = seen.halves % 2 == 1, several = seen.halves > 2;
    if (is_of_systems(v) && (!mirrored || several)) throw Undecided("the motion does not mirror itself in one period");
    if (several && asked != "amplitude") throw Undecided("the motion repeats after several periods");
    if (!mirrored && asks_for(v.question, {"phase", "motion_under_force"})) throw Undecided("the motion does not mirror itself");
    if (!mirrored) v.flags.emplace_back("unsymmetric");
    if (several) v.flags.emplace_back("several-periods");
    v.flags = sorted(v.flags);
    if (several) v.tier = "should"; // who looks for one period of the force does not find it
}

// A question that has to be rejected: the rules of the library have to find it.
Vector rejected(const Vector& asked) {
    Vector v = plain_vector(asked);
    v.reject = asked.reject;
    if (is_of_the_paper(v.question)) v.flags = asked.flags;
    try {
        static_cast<void>(scene_of(v.question));
    } catch (const InputError&) {
        return v;
    }
    throw Undecided("it breaks no rule");
}

Certified certified(const Case& c, const std::set<std::string>& only) {
    Certified all;
    ProtocolQuestion scene = c.front().question; // the routes of a scene are asked with other questions
    scene.quantity = "regime";
    scene.mass = scene.samples = 0;
    scene.tau = 0;
    const bool breaks_a_rule = !c.front().reject.empty();
    const std::optional<Regimes> regimes = breaks_a_rule ? std::nullopt : regimes_of(scene);
    const Real50 beta(scene.beta);
    const Regime regime = regimes ? regime_of_scene(*regimes, beta) : Regime::continuous;
    std::optional<SceneRoutes> routes;
    if (!breaks_a_rule) routes.emplace(scene, regime);
    std::optional<bool> from_rest;
    for (const Vector& asked : c) {
        if (!only.empty() && only.count(asked.question.id) == 0) continue;
        const std::array<int, 2> least = all.least;
        try {
            if (breaks_a_rule) {
                all.vectors.push_back(rejected(asked));
                continue;
            }
            static_cast<void>(scene_of(asked.question)); // a question that breaks a rule says so
            Vector v = plain_vector(asked);
            const bool with_friction = depends_on_friction(v.question.quantity);
            if (with_friction && !regimes) throw Undecided("an undamped mode resonates");
            if (with_friction && beta < regimes->sliding && regimes->sticking && beta >= *regimes->sticking)
                throw Undecided("the contact may slide or rest");
            if (with_friction && !from_rest) from_rest = comes_from_rest(scene, regime);
            if (with_friction && !*from_rest) throw Undecided("the motion from rest is another");
            if (regimes) v.regime = name(regime);
            if (with_friction) v.margin = margin_of(*regimes, beta);
            if (with_friction && regime == Regime::stick_slip && v.question.quantity != "regime")
                look_at_motion(v, routes->seen());
            v.routes = routes->names(v.question);
            if (v.question.quantity == "regime") {
                certify_regime(v, *routes, all);
                v.tier = tier_of(v, 0);
            } else {
                certify_numbers(v, *routes, all);
            }
            v.catches = catches_of(v);
            all.vectors.push_back(std::move(v));
        } catch (const std::exception& e) {
            all.least = least;
            all.refusals.push_back({asked.question.id, e.what()});
        }
    }
    return all;
}

} // namespace

Certified certify(const Case& c, const std::set<std::string>& only) {
    try {
        return certified(c, only);
    } catch (const std::exception& e) { // the scene itself has no boundaries, or breaks a rule that its line does not name
        Certified none;
        for (const Vector& asked : c) none.refusals.push_back({asked.question.id, e.what()});
        return none;
    }
}

} // namespace denhartog::conformance::generator
