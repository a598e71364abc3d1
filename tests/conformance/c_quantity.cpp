// Quantities of the protocol by their names through the C interface: how many numbers each has, where it does not exist, and what
// is refused. `c_errors.cpp` compares the numbers with the certified vectors.
#include <algorithm>
#include <limits>

#include "conformance/question.hpp"
#include "tests/conformance/c_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr double untouched = -7.25;

struct Numbers {
    int status;
    std::vector<double> x;
};

Numbers asked(const dh_system* system, const std::string& name, const Scene<double>& s, std::size_t mass, std::size_t size = 8,
              double tau = 0.5) {
    std::vector<double> x(std::max<std::size_t>(size, 1), untouched);
    std::size_t count = 0;
    const int status = dh_quantity(system, name.c_str(), *s.r, *s.beta, s.mu, mass, tau, size, x.data(), &count);
    if (status == DH_OK) x.resize(count);
    return {status, x};
}

std::size_t expected_count(conformance::Shape shape, std::size_t N, std::size_t stops) {
    switch (shape) {
    case conformance::Shape::complex: return 2;
    case conformance::Shape::modes: return N;
    case conformance::Shape::durations: return stops;
    case conformance::Shape::samples: return 8;
    default: return 1;
    }
}

// Where a quantity of the protocol does not exist.
bool exists(const std::string& name, const Scene<double>& s, const dh_summary& all, const dh_mass& mass) {
    if (name == "rest_interval") return all.regime == DH_PERMANENT_STICKING;
    if (name == "beta_lim_high_frequency") return s.system.contact == s.system.load;
    if (name == "phase") return mass.moves != 0;
    for (const char* sliding : {"initial_displacement", "initial_velocity", "amplitude_monoharmonic", "phase_monoharmonic"})
        if (name == sliding) return all.regime == DH_CONTINUOUS;
    return name != "displacement" || all.regime == DH_CONTINUOUS;
}

} // namespace

TEST_CASE("every quantity of the protocol has its numbers by its name, where it exists", "[c_interface][conformance]") {
    int missing = 0;
    for (const Scene<double>& s : c_scenes()) {
        const Handle system = handle_of(s.system);
        const Answered solution = solved(system.get(), *s.r, *s.beta, s.mu, 12);
        const std::size_t N = s.system.mass_ratios.size();
        const dh_summary all = summary_of(solution.get());
        for (std::size_t k = 1; k <= N; ++k) {
            const dh_mass mass = mass_of(solution.get(), k);
            for (const conformance::Quantity& quantity : conformance::quantities()) {
                if (quantity.absolute) continue; // of a moving base, which these scenes do not have
                const std::string name(quantity.name);
                INFO(name << " of mass " << k << " of " << N);
                const Numbers found = asked(system.get(), name, s, quantity.of_mass ? k : 0);
                if (exists(name, s, all, mass)) {
                    CHECK(found.status == DH_OK);
                    CHECK(found.x.size() == expected_count(quantity.shape, N, all.stops));
                } else {
                    ++missing;
                    CHECK(found.status == DH_ERROR_DOMAIN);
                    CHECK(found.x == std::vector<double>(8, untouched));
                }
            }
        }
    }
    CHECK(missing > 0);
}

TEST_CASE("a quantity by its name is refused where the question breaks a rule, whatever is asked", "[c_interface][faults]") {
    const Scene<double> good = c_scenes().front();
    const Handle system = handle_of(good.system);
    std::vector<Scene<double>> bad(6, good);
    bad[0].mu = 0.5;
    bad[1].r = 0;
    bad[2].beta = -1;
    bad[3].mu = std::numeric_limits<double>::quiet_NaN();
    bad[4].r = std::numeric_limits<double>::infinity();
    bad[5].beta = std::numeric_limits<double>::infinity();
    const std::vector<double> nothing(8, untouched);
    const auto check = [&](const Numbers& found, int status) {
        INFO(dh_last_message());
        CHECK(found.status == status);
        CHECK(std::vector<double>(nothing.begin(), nothing.begin() + static_cast<std::ptrdiff_t>(found.x.size())) == found.x);
    };
    for (const Scene<double>& s : bad) check(asked(system.get(), "natural_frequency_ratios", s, 0), DH_ERROR_INPUT);
    for (const std::size_t mass : {0, 3}) check(asked(system.get(), "amplitude", good, mass), DH_ERROR_INPUT);
    check(asked(system.get(), "natural_frequency_ratios", good, 0, 1), DH_ERROR_SIZE);
    check(asked(system.get(), "motion_under_force", good, 1, 0), DH_ERROR_SIZE);
    check(asked(system.get(), "no_such_quantity", good, 1), DH_ERROR_DOMAIN);
    check(asked(system.get(), "displacement", good, 1, 8, std::numeric_limits<double>::quiet_NaN()), DH_ERROR_INPUT);
    check(asked(nullptr, "amplitude", good, 1), DH_ERROR_NULL);
    double x = untouched;
    std::size_t count = 7;
    CHECK(dh_quantity(system.get(), nullptr, 1, 0, 1, 1, 0, 1, &x, &count) == DH_ERROR_NULL);
    CHECK(dh_quantity(system.get(), "H_j", 1, 0, 1, 1, 0, 1, nullptr, &count) == DH_ERROR_NULL);
    CHECK(dh_quantity(system.get(), "H_j", 1, 0, 1, 1, 0, 1, &x, nullptr) == DH_ERROR_NULL);
    CHECK((x == untouched && count == 7));
}
