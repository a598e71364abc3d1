// Quantities of the protocol by their names through the C interface: what its other functions say, and what it refuses.
#include <algorithm>
#include <limits>

#include "conformance/question.hpp"
#include "tests/catch.hpp"
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

TEST_CASE("a quantity by its name is what the function for it says", "[c_interface][conformance]") {
    for (const Scene<double>& s : c_scenes()) {
        const Handle system = handle_of(s.system);
        const std::size_t N = s.system.mass_ratios.size(), j = s.system.contact.index;
        const Answered solution = solved(system.get(), *s.r, *s.beta, s.mu, 12);
        const dh_summary all = summary_of(solution.get());
        std::vector<double> V(2 * N), U(N), G(N), psi(N * N), motion(8 * N), start(all.stops), end(all.stops);
        double H_j = 0, S_j = 0, lengths = 0, durations = 0;
        REQUIRE(dh_sums(system.get(), *s.r, N, V.data(), U.data(), G.data(), &H_j, &S_j) == DH_OK);
        REQUIRE(dh_mode_shapes(system.get(), *s.r, N * N, psi.data()) == DH_OK);
        REQUIRE(dh_solution_motion(solution.get(), 8, 8 * N, motion.data(), nullptr) == DH_OK);
        REQUIRE(dh_solution_stops(solution.get(), all.stops, start.data(), end.data()) == DH_OK);
        for (std::size_t k = 1; k <= N; ++k) {
            const dh_mass mass = mass_of(solution.get(), k);
            std::vector<double> of_mass, products;
            for (std::size_t n = 0; n < 8; ++n) of_mass.push_back(motion[n * N + k - 1]);
            for (std::size_t i = 0; i < N; ++i) products.push_back(psi[(k - 1) * N + i] * psi[j * N + i]);
            CHECK(asked(system.get(), "motion_under_force", s, k).x == of_mass);
            CHECK(asked(system.get(), "mode_shape_products", s, k).x == products);
            CHECK(asked(system.get(), "complex_response", s, k).x == std::vector<double>{V[2 * k - 2], V[2 * k - 1]});
            CHECK(asked(system.get(), "first_damping_function", s, k).x == std::vector<double>{U[k - 1]});
            CHECK(asked(system.get(), "second_damping_function", s, k).x == std::vector<double>{G[k - 1]});
            CHECK(asked(system.get(), "amplitude", s, k).x == std::vector<double>{mass.amplitude});
            if (all.regime != DH_CONTINUOUS) continue;
            auto m = sized<dh_sliding_mass>();
            REQUIRE(dh_sliding_motion(system.get(), *s.r, *s.beta, s.mu, k, &m) == DH_OK);
            CHECK(asked(system.get(), "initial_displacement", s, k).x == std::vector<double>{m.initial_displacement});
            CHECK(asked(system.get(), "initial_velocity", s, k).x == std::vector<double>{m.initial_velocity});
            CHECK(asked(system.get(), "amplitude_monoharmonic", s, k).x == std::vector<double>{m.amplitude_monoharmonic});
            CHECK(asked(system.get(), "phase_monoharmonic", s, k).x == std::vector<double>{m.phase_monoharmonic});
        }
        auto b = sized<dh_boundary>();
        REQUIRE(dh_boundaries(system.get(), *s.r, s.mu, &b) == DH_OK);
        CHECK(asked(system.get(), "H_j", s, 0).x == std::vector<double>{H_j});
        CHECK(asked(system.get(), "S_j", s, 0).x == std::vector<double>{S_j});
        CHECK(asked(system.get(), "beta_lim_exact", s, 0).x == std::vector<double>{b.exact});
        CHECK(asked(system.get(), "beta_lim_paper", s, 0).x == std::vector<double>{b.paper});
        CHECK(asked(system.get(), "beta_lim_approximate", s, 0).x == std::vector<double>{b.approximate});
        CHECK(asked(system.get(), "beta_lim_sticking", s, 0).x == std::vector<double>{b.sticking});
        CHECK(asked(system.get(), "regime", s, 0).x == std::vector<double>{static_cast<double>(all.regime)});
        for (std::size_t i = 0; i < all.stops; ++i) lengths += end[i] - start[i];
        for (const double length : asked(system.get(), "stop_durations", s, 0).x) durations += length;
        CHECK(durations == Approx(lengths).margin(1e-15));
    }
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
