#include "denhartog/map/contact_amplitudes.hpp"

#include <random>

#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/map/regime_map.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/table.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

std::vector<double> frequency_ratios(std::size_t n) {
    std::vector<double> r{1e-3, 0.5, 1, 2, 50};
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    while (r.size() < n) r.push_back(std::exp2(7 * unit(random) - 4));
    return r;
}

std::vector<System<double>> systems() {
    System<double> undamped = three_masses().system;
    undamped.damping_ratios = {0, 0.0625, 0};
    return {oscillator(0, 1).system, oscillator(0.015625, 1).system, oscillator(0.75, 1).system, three_masses().system, undamped};
}

/// The sizes of the terms of the sums at the mass in contact, which rounding errors are relative to, with the terms' own
/// condition: a change of R by eps moves v, u and g by that much.
struct Sizes {
    double V = 0, U = 0, G = 0, H = 0;
};

Sizes sizes_of(const ModalBasis<double>& basis, const System<double>& system, double r) {
    const ModeSums<double> s = mode_sums(basis, system.contact, system.load, r);
    const ModeSums<double> next = mode_sums(basis, system.contact, system.load, r * (1 + 0x1p-26));
    const auto psi_j = mode_shapes_at(s, s.contact), psi_l = mode_shapes_at(s, s.load);
    Sizes sizes;
    for (std::size_t i = 0; i < s.R.size(); ++i) {
        const double square = s.R[i] * s.R[i];
        const auto with_condition = [](double x, double y) { return std::abs(x) + std::abs(y - x) * 0x1p26; };
        const double v = with_condition(s.v[i].re, next.v[i].re) + with_condition(s.v[i].im, next.v[i].im);
        const double u = with_condition(s.u[i], next.u[i]), g = with_condition(s.g[i], next.g[i]);
        sizes.V += std::abs(psi_j[i] * psi_l[i]) * square * v;
        sizes.U += psi_j[i] * psi_j[i] * square * u;
        sizes.G += psi_j[i] * psi_j[i] * square * g;
        sizes.H += psi_j[i] * psi_j[i] * (g + 2 * s.zeta[i] * s.R[i] * u);
    }
    return sizes;
}

/// The same limits at every frequency ratio.
ContactLimits limits_of(std::size_t columns, double exact, double sticking) {
    return {std::vector<double>(columns, exact), std::vector<double>(columns, sticking),
            std::vector<LimitSource>(columns, LimitSource::search)};
}

double difference(double a, double b, double size) { return a == b ? 0 : std::abs(a - b) / (eps * size); }

} // namespace

TEST_CASE("sums over arrays of r are those at each r", "[eq:33][eq:34][eq:35][eq:64][eq:65]") {
    for (const System<double>& system : systems()) {
        const ModalBasis<double> basis = modal_basis(system);
        const std::vector<double> r = frequency_ratios(2500);
        const ContactSums sums = contact_sums(basis, system.contact, system.load, r, 2);
        const std::size_t j = system.contact.index;
        double worst = 0;
        std::string where;
        for (std::size_t n = 0; n < r.size(); ++n) {
            if (sums.at_pole[n] != 0) {
                CHECK_THROWS_AS(mode_sums(basis, system.contact, system.load, r[n]), DomainError);
                continue;
            }
            const ModeSums<double> one = mode_sums(basis, system.contact, system.load, r[n]);
            const Sizes size = sizes_of(basis, system, r[n]);
            for (const double each : {difference(sums.V_re[n], one.V[j].re, size.V),
                                      difference(sums.V_im[n], one.V[j].im, size.V), difference(sums.U[n], one.U[j], size.U),
                                      difference(sums.G[n], one.G[j], size.G), difference(sums.H[n], one.H_j, size.H),
                                      difference(sums.sum_of_squares[n], one.sum_of_squares, one.sum_of_squares)})
                if (!(each <= worst)) {
                    worst = each;
                    where = hexadecimal(r[n]);
                }
        }
        INFO(basis.r_n.size() << " modes, zeta_1 = " << basis.zeta[0] << ": " << worst << " eps at r = " << where);
        CHECK(worst <= 16);
    }
}

TEST_CASE("over a grid X_j and phi_j are those of (38) and (39) where the contact slides, and there are none elsewhere",
          "[eq:38][eq:39][eq:67][eq:69]") {
    std::size_t counts[4] = {};
    for (const System<double>& system : systems()) {
        Scene<double> scene;
        scene.system = system;
        const ModalBasis<double> basis = modal_basis(system);
        const std::vector<double> r = frequency_ratios(100);
        const ContactSums sums = contact_sums(basis, system.contact, system.load, r, 1);
        const std::vector<BoundaryPoint> curves = boundary_curves(scene, r);
        const std::vector<double> approximate = approximate_limits(sums, scene.mu);
        std::vector<double> beta{0};
        for (int n = 1; n < 100; ++n) beta.push_back(n / 80.0);
        const ContactMap map = contact_map(basis, system.contact, system.load, 1, r, beta, 2);
        std::vector<double> phases;
        contact_phases(sums, map, beta, 2, phases);
        Worst worst, worst_phase;
        for (std::size_t m = 0; m < r.size(); ++m) {
            if (curves[m].status != PointStatus::answered) {
                for (std::size_t n = 0; n < beta.size(); ++n)
                    CHECK(map.points[m * beta.size() + n] == BatchPoint::without_numbers);
                counts[3] += beta.size();
                continue;
            }
            INFO("r = " << hexadecimal(r[m]));
            const Sizes size = sizes_of(basis, system, r[m]);
            CHECK(approximate[m] <= curves[m].approximate * (1 + 64 * eps * size.V / std::hypot(sums.V_re[m], sums.V_im[m])) +
                                        64 * eps * (size.U + size.H));
            const Complex<double> V{sums.V_re[m], sums.V_im[m]};
            const long double of_V = std::hypot(static_cast<long double>(V.re), static_cast<long double>(V.im));
            for (std::size_t n = 0; n < beta.size(); ++n) {
                const BatchPoint point = map.points[m * beta.size() + n];
                const bool slides = beta[n] < curves[m].exact;
                const bool rests = !slides && curves[m].sticking && beta[n] >= *curves[m].sticking;
                ++counts[static_cast<int>(point)];
                CHECK(point == (slides  ? BatchPoint::continuous
                                : rests ? BatchPoint::permanent_sticking
                                        : BatchPoint::stick_slip));
                CHECK(amplitude_at(map, m, n).has_value() == slides);
                const double phase = phases[m * beta.size() + n];
                if (!slides) {
                    CHECK(map.X_j[m * beta.size() + n] == 0);
                    CHECK(phase == 0);
                    continue;
                }
                const std::string at = "r = " + hexadecimal(r[m]) + ", beta = " + hexadecimal(beta[n]);
                // the errors of |V| and beta U, an eps each, pass the root magnified by what it cancels
                const long double lag = static_cast<long double>(beta[n]) * sums.U[m];
                const long double root = std::sqrt((of_V - lag) * (of_V + lag));
                const double exact = static_cast<double>(root - static_cast<long double>(beta[n]) * sums.G[m]);
                const double of_root = static_cast<double>((of_V * of_V + lag * lag) / root);
                worst.note(difference(*amplitude_at(map, m, n), exact, of_root + beta[n] * std::abs(sums.G[m])), at);
                const long double phi =
                    -std::asin(lag / of_V) - std::atan2(static_cast<long double>(V.im), static_cast<long double>(V.re));
                const auto turns = static_cast<double>(std::remainder(phi - phase, 2 * pi<long double>()));
                worst_phase.note(std::abs(turns) / (eps * (pi<double>() + static_cast<double>(std::abs(lag) / root))), at);
                CHECK(std::abs(phase) <= pi<double>());
            }
        }
        INFO(worst.error << " eps at " << worst.where << ", phase " << worst_phase.error << " eps at " << worst_phase.where);
        CHECK(worst.error <= 2);
        CHECK(worst_phase.error <= 2);
    }
    INFO(counts[0] << " sliding, " << counts[1] << " stick-slip, " << counts[2] << " sticking, " << counts[3] << " at poles");
    for (const std::size_t count : counts) CHECK(count > 0);
}

TEST_CASE("over arrays each mode is evaluated once an r, whatever the number of friction ratios", "[counter]") {
    const System<double> system = three_masses().system;
    const std::vector<double> r = frequency_ratios(1000), beta(500, 0.0625);
    const long before = evaluation::array_mode_evaluations();
    const long scalar = mode_evaluations();
    const ContactSums sums = contact_sums(modal_basis(system), system.contact, system.load, r, 2);
    const ContactLimits limits = limits_of(r.size(), 0.125, 1);
    (void)approximate_limits(sums, 1);
    ContactMap map;
    contact_map(sums, limits, beta, 2, map);
    std::vector<double> phases;
    contact_phases(sums, map, beta, 2, phases);
    CHECK(evaluation::array_mode_evaluations() - before == 3 * 1000);
    CHECK(mode_evaluations() == scalar);
}

TEST_CASE("the number of threads changes nothing in sums and maps over arrays", "[eq:33][eq:38]") {
    const System<double> system = three_masses().system;
    const ModalBasis<double> basis = modal_basis(system);
    const std::vector<double> r = frequency_ratios(3000);
    const ContactSums one = contact_sums(basis, system.contact, system.load, r, 1);
    const ContactSums three = contact_sums(basis, system.contact, system.load, r, 3);
    CHECK(one.V_re == three.V_re);
    CHECK(one.U == three.U);
    CHECK(one.H == three.H);
}

TEST_CASE("a map that is written over keeps nothing of what it was", "[eq:38]") {
    const System<double> system = three_masses().system;
    const ContactSums sums = contact_sums(modal_basis(system), system.contact, system.load, {0.5, 1.5}, 1);
    const ContactLimits all = limits_of(2, 0.5, 1);
    ContactMap map;
    contact_map(sums, all, {0.0625, 0.125, 0.75}, 1, map);
    CHECK(amplitude_at(map, 1, 1).has_value());
    ContactLimits second = all;
    second.source[1] = LimitSource::none;
    contact_map(sums, second, {0.0625, 0.125}, 1, map);
    CHECK(map.points.size() == 4);
    CHECK(amplitude_at(map, 0, 1).has_value());
    CHECK(map.points[3] == BatchPoint::without_numbers);
    CHECK(map.X_j[3] == 0);
}

TEST_CASE("arguments of batches are checked", "[domain]") {
    const System<double> system = three_masses().system;
    const ModalBasis<double> basis = modal_basis(system);
    CHECK_THROWS_AS(contact_sums(basis, Mass{0}, Mass{0}, {1, -1}, 1), InputError);
    CHECK_THROWS_WITH(contact_sums(basis, Mass{3}, Mass{0}, {1}, 1), "contact must be a mass from 1 to 3, but is 4");
    CHECK_THROWS_WITH(contact_sums(basis, Mass{0}, Mass{0}, {1}, 0), "threads must be at least 1, but is 0");
    CHECK_THROWS_AS(contact_sums(basis, Mass{0}, Mass{0}, {1e-200}, 1), PrecisionError);
    const ContactSums sums = contact_sums(basis, Mass{0}, Mass{0}, {1}, 1);
    ContactMap map;
    CHECK_THROWS_WITH(contact_map(sums, {}, {0.5}, 1, map),
                      "limits must have an entry for each of the 1 frequency ratios, but is 0");
    ContactLimits limits = limits_of(1, 0.5, 1);
    CHECK_THROWS_AS(contact_map(sums, limits, {-0.5}, 1, map), InputError);
    limits.source[0] = LimitSource::none;
    contact_map(sums, limits, {0.5}, 1, map);
    CHECK(map.points[0] == BatchPoint::without_numbers);
    std::vector<double> phases;
    CHECK_THROWS_AS(contact_phases(sums, map, {0.5, 0.25}, 1, phases), InputError);
    CHECK_THROWS_AS(contact_limits(basis, Mass{0}, Mass{0}, 1, {1, 2}, sums, 1), InputError);
    CHECK_THROWS_AS(approximate_limits(sums, 0.5), InputError);
}
