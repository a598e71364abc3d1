#include "denhartog/map/contact_limits.hpp"

#include <random>

#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/map/contact_amplitudes.hpp"
#include "denhartog/map/regime_map.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/table.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// Chains of 1 to 6 masses, damping from none to nearly critical, any contact and load.
System<double> seeded_system(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const std::size_t N = 1 + random() % 6;
    System<double> s;
    for (std::size_t i = 0; i < N; ++i) {
        s.mass_ratios.push_back(i == 0 ? 1 : std::exp2(2 * unit(random) - 1));
        s.stiffness_ratios.push_back(i == 0 ? 1 : std::exp2(2 * unit(random) - 1));
        const double kind = unit(random);
        s.damping_ratios.push_back(kind < 0.1   ? 0
                                   : kind < 0.2 ? 0.5 * (1 + unit(random)) * 0.999
                                                : std::exp2(-14 * unit(random)));
    }
    s.contact = Mass{random() % N};
    s.load = Mass{random() % N};
    return s;
}

std::vector<double> seeded_ratios(std::mt19937_64& random, std::size_t n) {
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> r;
    while (r.size() < n) r.push_back(std::exp2(7 * unit(random) - 4));
    return r;
}

/// The regime that the scalar route has.
BatchPoint regime_by_search(const Boundary<double>& b, double beta) { return static_cast<BatchPoint>(regime_of(b, beta)); }

} // namespace

TEST_CASE("limits over arrays are those of the boundary, far inside their margin; where it is not certain it is searched",
          "[eq:69][eq:67][accuracy]") {
    std::mt19937_64 random(20220117);
    long from_arrays = 0, from_search = 0, at_zero = 0;
    Worst worst, worst_sticking;
    for (int n = 0; n < 150; ++n) {
        const System<double> system = seeded_system(random);
        const double mu = n % 3 == 0 ? 1.25 : 1;
        const ModalBasis<double> basis = modal_basis(system);
        const std::vector<double> r = seeded_ratios(random, 60);
        const ContactSums sums = contact_sums(basis, system.contact, system.load, r, 1);
        const long before = limits_left_to_search();
        const ContactLimits limits = contact_limits(basis, system.contact, system.load, mu, r, sums, 2);
        long searched = 0;
        for (std::size_t m = 0; m < r.size(); ++m) {
            searched += limits.source[m] != LimitSource::arrays;
            if (limits.source[m] == LimitSource::none) continue;
            const ModeSums<double> one = mode_sums(basis, system.contact, system.load, r[m]);
            const Boundary<double> b = boundary(one, mu);
            const std::string at = std::to_string(basis.r_n.size()) + " modes, r = " + hexadecimal(r[m]);
            INFO(at);
            if (largest_at_start(one)) {
                ++at_zero;
                CHECK(b.S_exact <= sliding_demand(one, 0.0) * (1 + 1e-14));
            }
            if (limits.source[m] == LimitSource::search) {
                ++from_search;
                CHECK(limits.exact[m] == Approx(b.exact).epsilon(1e-14));
                CHECK(limits.sticking[m] == b.sticking.value_or(std::numeric_limits<double>::infinity()));
                continue;
            }
            ++from_arrays;
            REQUIRE(b.sticking);
            worst.note(std::abs(limits.exact[m] / b.exact - 1), at);
            worst_sticking.note(std::abs(limits.sticking[m] / *b.sticking - 1), at);
        }
        CHECK(limits_left_to_search() - before == searched);
    }
    INFO(from_arrays << " by arrays, " << from_search << " by search, " << at_zero
                     << " certain to be largest at the start; worst " << worst.error << " at " << worst.where << ", sticking "
                     << worst_sticking.error << " at " << worst_sticking.where);
    CHECK(worst.error <= limit_margin() / 256);
    CHECK(worst_sticking.error <= limit_margin() / 256);
    CHECK(from_arrays > 2000);
    CHECK(from_search > 2000);
}

TEST_CASE("regimes over arrays are those of the boundary at every point, next to the boundaries too", "[eq:69][map]") {
    std::mt19937_64 random(535);
    long points = 0, next_to = 0, settled = 0, kinds[4] = {};
    for (int n = 0; n < 60; ++n) {
        const System<double> system = seeded_system(random);
        const ModalBasis<double> basis = modal_basis(system);
        const double mu = n % 3 == 0 ? 1.25 : 1;
        const std::vector<double> r = seeded_ratios(random, 24);
        std::vector<double> beta{0, 0.125, 0.75, 1 / mu, std::nextafter(1 / mu, 0), 2};
        std::vector<std::optional<Boundary<double>>> boundaries;
        for (const double each : r) {
            try {
                boundaries.push_back(boundary(mode_sums(basis, system.contact, system.load, each), mu));
            } catch (const DomainError&) {
                boundaries.emplace_back();
                continue;
            }
            const double exact = boundaries.back()->exact;
            for (const double factor : {1.0, 1 - 0x1p-53, 1 + 0x1p-52, 1 - 0x1p-48, 1 + 0x1p-48, 1 - 0x1p-34, 1 + 0x1p-34, 1.5})
                beta.push_back(exact * factor);
        }
        ContactLimits limits =
            contact_limits(basis, system.contact, system.load, mu, r, contact_sums(basis, system.contact, system.load, r, 1), 1);
        settled += static_cast<long>(settle_limits(basis, system.contact, system.load, mu, r, beta, limits));
        const ContactMap map = contact_map(basis, system.contact, system.load, mu, r, beta, 2);
        for (std::size_t m = 0; m < r.size(); ++m)
            for (std::size_t k = 0; k < beta.size(); ++k) {
                const BatchPoint point = map.points[m * beta.size() + k];
                ++kinds[static_cast<int>(point)];
                ++points;
                INFO("r = " << hexadecimal(r[m]) << ", beta = " << hexadecimal(beta[k]));
                if (!boundaries[m]) {
                    CHECK(point == BatchPoint::without_numbers);
                    continue;
                }
                next_to += std::abs(beta[k] - boundaries[m]->exact) <= 1e-13 * beta[k] ? 1 : 0;
                CHECK(point == regime_by_search(*boundaries[m], beta[k]));
            }
    }
    INFO(points << " points, " << next_to << " next to a boundary, " << settled << " frequency ratios settled by search; "
                << kinds[0] << ", " << kinds[1] << ", " << kinds[2] << ", " << kinds[3]);
    CHECK(next_to > 5000);
    CHECK(settled > 300);
    for (int kind = 0; kind < 3; ++kind) CHECK(kinds[kind] > 1000);
}

TEST_CASE("a contact that an absorber holds still is left to the search", "[eq:69]") {
    const System<double> absorber = chain({1, 1}, {1, 1}, {0, 0}, 1, 1, 1, 1).system;
    const ModalBasis<double> basis = modal_basis(absorber);
    const std::vector<double> r{1, 0.999, 1.5};
    const ContactSums sums = contact_sums(basis, absorber.contact, absorber.load, r, 1);
    const ContactLimits limits = contact_limits(basis, absorber.contact, absorber.load, 1, r, sums, 1);
    for (std::size_t m = 0; m < r.size(); ++m) {
        INFO("r = " << r[m]);
        const Boundary<double> b = boundary(mode_sums(basis, absorber.contact, absorber.load, r[m]), 1.0);
        CHECK(limits.exact[m] == Approx(b.exact).epsilon(1e-12));
        CHECK(std::isinf(limits.sticking[m]) == !b.sticking);
    }
    CHECK(limits.source[0] == LimitSource::search);
}

TEST_CASE("a map costs no search where (57) is certain to be largest for tau -> 0", "[counter]") {
    const System<double> system = oscillator(0.0625, 1).system;
    std::vector<double> r;
    for (int n = 0; n < 100; ++n) r.push_back(0.75 + n / 64.0);
    const long before = demand_searches(), left = limits_left_to_search();
    (void)contact_map(modal_basis(system), system.contact, system.load, 1, r, {0.0, 0.3, 0.6}, 1);
    CHECK(demand_searches() == before);
    CHECK(limits_left_to_search() == left);
    Scene<double> scene;
    scene.system = system;
    MapRequest request{r, {0.0, 0.125, 1.5}, {system.contact}, MapStart::rest, 1};
    const std::atomic<bool> never{false};
    CHECK(regime_map(scene, request, never).complete);
    CHECK(demand_searches() == before);
    (void)boundary(mode_sums(modal_basis(system), system.contact, system.load, 1.0), 1.0);
    CHECK(demand_searches() == before + 1);
}
