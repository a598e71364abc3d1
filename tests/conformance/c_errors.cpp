// The certified vectors that have an answer, through the C interface: numbers, the bounds of their errors, and regimes. Those
// that break a rule are refused by the reader that all interfaces share; `score_adapters.py` asks them from C.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "denhartog/number/errors.hpp"
#include "tests/conformance/c_fixtures.hpp"
#include "tests/conformance/vector_folder.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;
using namespace denhartog::tests;
using conformance::Vector;

namespace {

// Numbers held against what they are, and how many are off by more than a thousandth of their bound: no bound is idle.
struct Held {
    int numbers = 0;
    int near_bound = 0;

    void take(const char* what, double value, double bound, const Real50& truth, double period = 0) {
        Real50 apart = abs(Real50(truth - value));
        if (period > 0 && apart > period / 2) apart = abs(Real50(apart - 2 * pi<Real50>()));
        const auto error = static_cast<double>(apart);
        INFO(what << " " << value << ", bound " << bound << ", off by " << error);
        CHECK(error <= bound + 1e-39 * std::abs(value)); // what the digits of a vector leave open
        ++numbers;
        near_bound += 1000 * error > bound;
    }
};

constexpr std::size_t most_values = 64;

// Numbers, or the bounds of their errors, by the name of a quantity.
std::vector<double> by_name(decltype(&dh_quantity) of, const dh_system* system, const conformance::ProtocolQuestion& q,
                            int mass) {
    std::vector<double> x(q.samples > 0 ? static_cast<std::size_t>(q.samples) : most_values);
    std::size_t count = 0;
    const int status =
        of(system, q.quantity.c_str(), q.r, q.beta, q.mu, static_cast<std::size_t>(mass), q.tau, x.size(), x.data(), &count);
    INFO(dh_last_message());
    REQUIRE(status == DH_OK);
    x.resize(count);
    return x;
}

struct Numbers {
    std::vector<double> values, errors;
};

// What C says to a vector's question. The motion of two masses against each other has no name of its own.
Numbers asked(const conformance::ProtocolQuestion& q) {
    const Handle system = handle_of(conformance::question_json(q)["scene"].dump());
    const auto of_mass = [&](int mass) {
        return Numbers{by_name(dh_quantity, system.get(), q, mass), by_name(dh_quantity_errors, system.get(), q, mass)};
    };
    if (!conformance::quantity(q.quantity).of_mass || q.mass > 0) return of_mass(q.mass);
    if (q.quantity == "amplitude" || q.quantity == "phase") {
        const dh_mass contact = contact_of(solved(system.get(), q.r, q.beta, q.mu, 12).get());
        if (q.quantity == "amplitude") return {{contact.amplitude}, {contact.error}};
        return {{contact.phase}, {contact.phase_error}};
    }
    Numbers between = of_mass(q.contact);
    const Numbers other = of_mass(q.contact_with);
    for (std::size_t n = 0; n < between.values.size(); ++n) {
        between.values[n] -= other.values[n];
        between.errors[n] += other.errors[n];
    }
    return between;
}

constexpr const char* regimes[] = {"continuous", "stick_slip", "permanent_sticking"};

} // namespace

TEST_CASE("every quantity by its name is within the bound of its error of the certified vectors", "[c_interface][vectors]") {
    std::map<std::string, Held> held;
    std::map<std::string, int> answered, passed; // by tier
    int rejected = 0;
    for (const Vector& v : vectors()) {
        INFO(v.question.id << " " << v.question.quantity);
        if (!v.reject.empty()) {
            CHECK_THROWS_AS(conformance::scene_of(v.question), InputError);
            ++rejected;
            continue;
        }
        const auto [values, errors] = asked(v.question);
        REQUIRE(errors.size() == values.size());
        if (!v.word.empty()) { // the regime, certain but on a boundary
            CHECK((errors == std::vector<double>{0} || v.margin.value_or(0) < 1e-9));
            CHECK(regimes[static_cast<int>(values.at(0))] == v.word);
            ++answered[v.word];
            continue;
        }
        REQUIRE(values.size() == v.value.size());
        const double period = conformance::quantity(v.question.quantity).angle ? 2 * std::numbers::pi : 0;
        double worst = 0;
        for (std::size_t n = 0; n < values.size(); ++n) {
            CHECK(errors[n] <= 1e-5 * v.scale);
            held[v.question.quantity].take("a number", values[n], errors[n], Real50(v.value[n]), period);
            const double off = values[n] - v.nearest[n];
            worst = std::max(worst, std::abs(period > 0 ? std::remainder(off, period) : off) / v.scale);
        }
        ++answered[v.tier];
        passed[v.tier] += worst <= v.tolerance.pass;
        INFO("error over scale " << worst << ", passes up to " << v.tolerance.pass);
        CHECK(worst <= (v.tier == "stress" ? v.tolerance.inaccurate : v.tolerance.pass));
    }
    CHECK(held.size() == conformance::quantities().size() - 1); // all but the regime
    for (const auto& [name, of] : held) {
        INFO(name << ": " << of.near_bound << " of " << of.numbers);
        CHECK((of.near_bound > of.numbers / 20 || name == "stops_per_period" || name == "motion_under_force"));
    }
    for (const char* regime : regimes) CHECK(answered[regime] > 20);
    CHECK(rejected >= 30);
    CHECK(answered["must"] + answered["should"] > 1200);
    CHECK(answered["stress"] > 50);
    CHECK(10 * passed["stress"] >= 9 * answered["stress"]);
}

TEST_CASE("the bound of shapes that share one frequency is as large as they are, from C", "[c_interface]") {
    // Equal springs and masses round a ring: two modes have one frequency, and any two shapes of a plane are theirs.
    const std::string ring = R"({"mass_ratios": [1, 1, 1], "stiffness_matrix": [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]],
        "damping_ratios": 0.05, "contact": 1, "load": 1})";
    const Handle system = handle_of(ring);
    std::vector<double> errors(9);
    REQUIRE(dh_mode_shape_errors(system.get(), 1, 9, errors.data()) == DH_OK);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(errors[3 * k] < 1e-12); // all masses move together
        CHECK(errors[3 * k + 1] >= 0.5);
        CHECK(errors[3 * k + 2] >= 0.5);
    }
    REQUIRE(dh_natural_frequency_ratio_errors(system.get(), 3, errors.data(), nullptr) == DH_OK);
    CHECK(errors[2] < 1e-12);
}
