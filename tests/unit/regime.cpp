#include <random>

#include "denhartog/sliding/instants_of_maxima.hpp"
#include "tests/speed_accuracy/table.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::tests;
using namespace denhartog;

namespace {

Boundary<Bounded<double>> known_exactly(const Boundary<double>& boundary) {
    Boundary<Bounded<double>> b{};
    b.exact = Bounded<double>(boundary.exact);
    if (boundary.sticking) b.sticking = Bounded<double>(*boundary.sticking);
    b.binding = boundary.binding;
    return b;
}

Response<double> response_of(Scene<double> scene, double beta) {
    scene.beta = beta;
    return response(scene);
}

} // namespace

TEST_CASE("the regimes follow each other as friction grows", "[eq:69][regime]") {
    const Scene<double> scene = three_masses();
    const Boundary<double> b = boundary(sums_of(scene), scene.mu);
    REQUIRE(b.exact < *b.sticking);
    for (const auto& [beta, regime] : {std::pair{0.0, Regime::continuous},
                                       {std::nextafter(b.exact, 0.0), Regime::continuous},
                                       {b.exact, Regime::stick_slip},
                                       {std::nextafter(*b.sticking, 0.0), Regime::stick_slip},
                                       {*b.sticking, Regime::permanent_sticking},
                                       {100.0, Regime::permanent_sticking}})
        CHECK(regime_at(known_exactly(b), beta).regime == regime);
}

TEST_CASE("outside the sliding regime there is a reason and no steady state", "[eq:69][regime]") {
    const Response<double> slipping = response_of(three_masses(), 0.75);
    CHECK(slipping.regime->regime == Regime::stick_slip);
    CHECK_FALSE(slipping.steady_state);
    CHECK(in_words(slipping.regime->reason).find("is not below beta_lim = ") != std::string::npos);
    CHECK(in_words(slipping.regime->reason).find("(54)b") != std::string::npos);
    const Response<double> resting = response_of(three_masses(), 4);
    CHECK(resting.regime->regime == Regime::permanent_sticking);
    CHECK_FALSE(resting.steady_state);
    CHECK(in_words(resting.regime->reason).find("never moves") != std::string::npos);
    const Response<double> sliding = response_of(three_masses(), 0.125);
    CHECK(sliding.regime->regime == Regime::continuous);
    CHECK(sliding.steady_state);
    CHECK(sliding.regime->other.empty());
}

TEST_CASE("with much static friction a contact that slides could also rest", "[eq:69][regime]") {
    // The dynamic load at resonance is far above the load at rest, which alone decides whether a contact at rest stays there.
    const Scene<double> scene = oscillator(0.0078125, 1, 2);
    const Boundary<double> b = boundary(sums_of(scene), scene.mu);
    REQUIRE(*b.sticking == 0.5);
    REQUIRE(b.exact > 0.625);
    const Response<double> both = response_of(scene, 0.5625);
    CHECK(both.regime->regime == Regime::continuous);
    CHECK(both.steady_state);
    CHECK(both.regime->other == std::vector<Regime>{Regime::permanent_sticking});
}

TEST_CASE("a friction ratio within rounding of a boundary is said to be there", "[regime]") {
    const Scene<double> scene = three_masses();
    const Boundary<double> b = boundary(sums_of(scene), scene.mu);
    CHECK(response_of(scene, b.exact).regime->on_boundary);
    CHECK(response_of(scene, b.exact * (1 + 1e-15)).regime->on_boundary);
    CHECK(response_of(scene, *b.sticking).regime->on_boundary);
    CHECK_FALSE(response_of(scene, b.exact * (1 + 1e-12)).regime->on_boundary);
    CHECK_FALSE(response_of(scene, b.exact * (1 - 1e-12)).regime->on_boundary);
}

TEST_CASE("without friction the contact slides if the load reaches it", "[regime]") {
    CHECK(response_of(three_masses(), 0).regime->regime == Regime::continuous);
    const Response<double> unmoved = response_of(chain({1, 1}, {1, 1}, {0, 0}, 1, 1, 1, 1), 0);
    CHECK(unmoved.regime->regime != Regime::continuous);
    CHECK_FALSE(unmoved.steady_state);
}

TEST_CASE("a friction ratio that is none is refused", "[domain]") {
    const Boundary<double> b = boundary(sums_of(three_masses()), 1.375);
    for (const double beta : {-0.125, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_AS(regime_at(known_exactly(b), beta), InputError);
}

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

struct Arrays {
    ContactSums sums;
    ContactLimits limits;
};

Arrays arrays_over(const System<double>& system, const ModalBasis<double>& basis, const std::vector<double>& r, double mu,
                   unsigned threads) {
    Arrays arrays;
    contact_sums(with_errors(system, basis), system.contact, system.load, r, threads, arrays.sums);
    contact_limits(arrays.sums, mu, threads, arrays.limits);
    return arrays;
}

long count_of(const ContactLimits& limits) { return std::ranges::count(limits.certain, 1); }

} // namespace

TEST_CASE("limits over arrays that are certain are those of the boundary, far inside their margin", "[eq:69][eq:67][accuracy]") {
    std::mt19937_64 random(20220117);
    long certain = 0, left = 0, at_zero = 0;
    Worst worst, worst_sticking;
    for (int n = 0; n < 150; ++n) {
        const System<double> system = seeded_system(random);
        const double mu = n % 3 == 0 ? 1.25 : 1;
        const ModalBasis<double> basis = modal_basis(system);
        const std::vector<double> r = seeded_ratios(random, 60);
        const ContactLimits limits = arrays_over(system, basis, r, mu, 2).limits;
        certain += count_of(limits);
        left += static_cast<long>(r.size()) - count_of(limits);
        for (std::size_t m = 0; m < r.size(); ++m) {
            if (limits.certain[m] == 0) continue;
            const ModeSums<double> one = mode_sums(basis, system.contact, system.load, r[m]);
            const Boundary<double> b = boundary(one, mu);
            const std::string at = std::to_string(basis.r_n.size()) + " modes, r = " + hexadecimal(r[m]);
            INFO(at);
            if (largest_at_start(one)) {
                ++at_zero;
                CHECK(b.S_exact <= sliding_demand(one, 0.0) * (1 + 1e-14));
            }
            REQUIRE(b.sticking);
            worst.note(std::abs(limits.exact[m] / b.exact - 1), at);
            worst_sticking.note(std::abs(limits.sticking[m] / *b.sticking - 1), at);
        }
    }
    INFO(certain << " certain, " << left << " left, " << at_zero << " certain to be largest at the start; worst " << worst.error
                 << " at " << worst.where << ", sticking " << worst_sticking.error << " at " << worst_sticking.where);
    CHECK(worst.error <= limit_margin() / 256);
    CHECK(worst_sticking.error <= limit_margin() / 256);
    CHECK(certain > 2000);
    CHECK(left > 2000);
}

TEST_CASE("regimes of a map by arrays are those of the boundary at every point, next to the boundaries too", "[eq:69][map]") {
    std::mt19937_64 random(535);
    const std::atomic<bool> never{false};
    long points = 0, next_to = 0, without = 0, told = 0, settled = 0, kinds[3] = {};
    for (int n = 0; n < 60; ++n) {
        Scene<double> scene;
        scene.system = seeded_system(random);
        scene.mu = n % 3 == 0 ? 1.25 : 1;
        const System<double>& system = scene.system;
        const ModalBasis<double> basis = modal_basis(system);
        const std::vector<double> r = seeded_ratios(random, 24);
        std::vector<double> beta{0, 0.125};
        std::vector<std::optional<Boundary<double>>> boundaries;
        for (const double each : r) {
            try {
                boundaries.push_back(boundary(mode_sums(basis, system.contact, system.load, each), scene.mu));
            } catch (const DomainError&) {
                boundaries.emplace_back();
                continue;
            }
            for (const double factor : {1.0, 1 - 0x1p-53, 1 + 0x1p-52, 1 - 0x1p-48, 1 + 0x1p-48, 1 - 0x1p-34, 1 + 0x1p-34, 1.5}) {
                beta.push_back(boundaries.back()->exact * factor);
                if (boundaries.back()->sticking && factor != 1.5) beta.push_back(*boundaries.back()->sticking * factor);
            }
        }
        std::vector<double> ascending = beta;
        std::ranges::sort(ascending);
        const ContactLimits limits = arrays_over(system, basis, r, scene.mu, 2).limits;
        for (std::size_t m = 0; m < r.size(); ++m) {
            settled += limits.certain[m] != 0 && !limits_tell(limits, m, ascending);
            if (!boundaries[m]) CHECK(limits.certain[m] == 0);
            // without the friction ratios of this column the arrays may tell its regimes
            const auto own = [&](double x) {
                return boundaries[m] && (std::abs(x / boundaries[m]->exact - 1) < 1e-6 ||
                                         (boundaries[m]->sticking && std::abs(x / *boundaries[m]->sticking - 1) < 1e-6));
            };
            std::vector<double> others = ascending;
            std::erase_if(others, own);
            if (!limits_tell(limits, m, others)) continue;
            ++told;
            for (const double x : others) {
                ++points;
                const Regime expected = regime_of(*boundaries[m], x);
                ++kinds[static_cast<int>(expected)];
                CHECK((x < limits.exact[m]) == (expected == Regime::continuous));
                CHECK((x >= limits.exact[m] && x >= limits.sticking[m]) == (expected == Regime::permanent_sticking));
            }
        }
        if (scene.mu > 1) continue;
        std::vector<double> sliding; // no motion is to be followed for these
        for (const double x : beta)
            if (std::ranges::all_of(boundaries,
                                    [&](const auto& b) { return !b || x < b->exact || (b->sticking && x >= *b->sticking); }))
                sliding.push_back(x);
        const RegimeMap map = regime_map(scene, {r, sliding, {system.contact}, MapStart::rest, 2}, never);
        for (std::size_t m = 0; m < r.size(); ++m) {
            std::optional<Boundary<Real50>> sure;
            for (std::size_t k = 0; k < sliding.size(); ++k) {
                const MapPoint& point = map.points[m * sliding.size() + k];
                INFO("r = " << hexadecimal(r[m]) << ", beta = " << hexadecimal(sliding[k]));
                if (!boundaries[m]) {
                    CHECK((point.status == PointStatus::at_a_pole || point.regime != Regime::continuous));
                    continue;
                }
                const auto next = [&](double limit) { return std::abs(sliding[k] - limit) <= 1e-6 * limit; };
                if (next(boundaries[m]->exact) || next(boundaries[m]->sticking.value_or(0))) {
                    ++next_to; // the digits of double do not tell
                    if (!sure) sure = boundary(sums_of(in_50_digits(scene, r[m])), Real50(scene.mu));
                    if (point.status != PointStatus::answered) {
                        CHECK(point.status == PointStatus::on_boundary); // a motion that is a rest but for its last digit
                        ++without;
                    } else {
                        CHECK(point.regime == regime_of(*sure, Real50(sliding[k])));
                    }
                } else {
                    CHECK(point.status == PointStatus::answered);
                    CHECK(point.regime == regime_of(*boundaries[m], sliding[k]));
                }
            }
        }
    }
    INFO(points << " points, " << told << " columns told, " << settled << " settled by search, " << next_to
                << " next to a boundary; " << kinds[0] << ", " << kinds[1] << ", " << kinds[2]);
    CHECK(without < next_to / 10);
    CHECK(told > 300);
    CHECK(settled > 100);
    for (const long each : kinds) CHECK(each > 1000);
}

TEST_CASE("a contact that an absorber holds still is left to the search", "[eq:69]") {
    const System<double> absorber = chain({1, 1}, {1, 1}, {0, 0}, 1, 1, 1, 1).system;
    const ModalBasis<double> basis = modal_basis(absorber);
    const std::vector<double> r{1, 0.999, 1.5};
    const ContactLimits limits = arrays_over(absorber, basis, r, 1, 1).limits;
    CHECK(limits.certain[0] == 0);
    for (std::size_t m = 0; m < r.size(); ++m) {
        INFO("r = " << r[m]);
        const Boundary<double> b = boundary(mode_sums(basis, absorber.contact, absorber.load, r[m]), 1.0);
        if (limits.certain[m] != 0) CHECK(limits.exact[m] == Approx(b.exact).epsilon(1e-12));
    }
}

TEST_CASE("a map by arrays costs no search and no mode by itself where (57) is certain to be largest for tau -> 0", "[counter]") {
    Scene<double> scene;
    scene.system = oscillator(0.0625, 1).system;
    std::vector<double> r;
    for (int n = 0; n < 100; ++n) r.push_back(0.75 + n / 64.0);
    const std::atomic<bool> never{false};
    const auto map_at = [&](std::vector<double> beta) {
        return regime_map(scene, {r, std::move(beta), {scene.system.contact}, MapStart::rest, 1}, never);
    };
    const long searches = demand_searches(), modes = mode_evaluations();
    CHECK(map_at({0.0, 0.125, 1.5}).complete);
    CHECK(demand_searches() == searches);
    CHECK(mode_evaluations() == modes);
    const double limit = boundary(mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, r[7]), 1.0).exact;
    const long before = mode_evaluations();
    CHECK(map_at({0.0, limit}).points[15].status == PointStatus::answered);
    CHECK(mode_evaluations() > before);
    const long with_search = demand_searches();
    const auto boundary_at = [&](double r) {
        (void)boundary(mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, r), 1.0);
    };
    boundary_at(1.0);
    CHECK(demand_searches() == with_search); // a boundary by itself searches no more than a map does
    boundary_at(0.25);
    CHECK(demand_searches() == with_search + 1);
}

TEST_CASE("arguments of limits over arrays are checked", "[domain]") {
    ContactLimits limits;
    CHECK_THROWS_AS(contact_limits({}, 0.5, 1, limits), InputError);
    CHECK_THROWS_WITH(contact_limits({}, 1, 0, limits), "threads must be at least 1, but is 0");
}
