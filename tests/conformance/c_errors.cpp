// Bounds of errors through the C interface, held against the certified vectors and against 50 digits.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "denhartog/sliding/mode_sums.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/c_fixtures.hpp"
#include "tests/conformance/vector_folder.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;
using namespace denhartog::tests;
using conformance::Vector;

namespace {

// Numbers held against what they are, and how many are off by more than a share of their bound.
struct Held {
    int numbers = 0;
    int close = 0;

    void take(const char* what, double value, double bound, const Real50& truth, double period = 0) {
        Real50 apart = abs(Real50(truth - value));
        if (period > 0 && apart > period / 2) apart = abs(Real50(apart - 2 * pi<Real50>()));
        const auto error = static_cast<double>(apart);
        INFO(what << " " << value << ", bound " << bound << ", off by " << error);
        CHECK(error <= bound + 1e-39 * std::abs(value)); // what the digits of a vector leave open
        ++numbers;
        close += 1000 * error > bound;
    }
};

constexpr std::size_t most_values = 64;

// The numbers of a vector, or the bounds of their errors.
std::vector<double> asked(decltype(&dh_quantity) of, const dh_system* system, const conformance::ProtocolQuestion& q) {
    std::vector<double> x(q.samples > 0 ? static_cast<std::size_t>(q.samples) : most_values);
    std::size_t count = 0;
    const int status =
        of(system, q.quantity.c_str(), q.r, q.beta, q.mu, static_cast<std::size_t>(q.mass), q.tau, x.size(), x.data(), &count);
    INFO(dh_last_message());
    REQUIRE(status == DH_OK);
    x.resize(count);
    return x;
}

// A motion between two masses in contact has no name of its own in C.
bool has_name_in_c(const Vector& v) {
    return v.reject.empty() && !(conformance::quantity(v.question.quantity).of_mass && v.question.mass == 0);
}

} // namespace

TEST_CASE("every quantity by its name is within the bound of its error of the certified vectors", "[c_interface][vectors]") {
    std::map<std::string, Held> held;
    for (const Vector& v : vectors()) {
        if (!has_name_in_c(v)) continue;
        INFO(v.question.id << " " << v.question.quantity);
        const Handle system = handle_of(conformance::question_json(v.question)["scene"].dump());
        const std::vector<double> values = asked(dh_quantity, system.get(), v.question),
                                  errors = asked(dh_quantity_errors, system.get(), v.question);
        REQUIRE(errors.size() == values.size());
        if (v.value.empty()) { // the regime, certain but on a boundary
            CHECK((errors == std::vector<double>{0} || v.margin.value_or(0) < 1e-9));
            continue;
        }
        REQUIRE(values.size() == v.value.size());
        const bool angle = conformance::quantity(v.question.quantity).angle;
        for (std::size_t n = 0; n < values.size(); ++n) {
            CHECK(errors[n] <= 1e-5 * v.scale);
            held[v.question.quantity].take("a number", values[n], errors[n], Real50(v.value[n]),
                                           angle ? 2 * std::numbers::pi : 0);
        }
    }
    CHECK(held.size() == conformance::quantities().size() - 1); // all but the regime
    for (const auto& [name, of] : held) {
        INFO(name << ": " << of.close << " of " << of.numbers);
        CHECK((of.close > of.numbers / 20 || name == "stops_per_period" || name == "motion_under_force"));
    }
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
