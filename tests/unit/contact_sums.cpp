#include "denhartog/sliding/contact_alone.hpp"

#include <random>

#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/number/errors.hpp"
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

double difference(double a, double b, double size) { return a == b ? 0 : std::abs(a - b) / (eps * size); }

ContactSums sums_over(const System<double>& system, const std::vector<double>& r, unsigned threads) {
    ContactSums sums;
    contact_sums(with_errors(system, modal_basis(system)), system.contact, system.load, r, threads, sums);
    return sums;
}

} // namespace

TEST_CASE("sums over arrays of r are those at each r", "[eq:33][eq:34][eq:35][eq:64][eq:65]") {
    for (const System<double>& system : systems()) {
        const ModalBasis<double> basis = modal_basis(system);
        const std::vector<double> r = frequency_ratios(2500);
        const ContactSums sums = sums_over(system, r, 2);
        const std::size_t j = system.contact.index;
        double worst = 0;
        std::string where;
        for (std::size_t n = 0; n < r.size(); ++n) {
            if (sums.without_numbers[n] != 0) {
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

TEST_CASE("over arrays each mode is evaluated once an r", "[counter]") {
    const std::vector<double> r = frequency_ratios(1000);
    const long before = evaluation::array_mode_evaluations(), scalar = mode_evaluations();
    CHECK(sums_over(three_masses().system, r, 2).modes == 3);
    CHECK(evaluation::array_mode_evaluations() - before == 3 * 1000);
    CHECK(mode_evaluations() == scalar);
}

TEST_CASE("the number of threads changes nothing in sums over arrays", "[threads][eq:33][eq:34][eq:64]") {
    const std::vector<double> r = frequency_ratios(3000);
    const ContactSums one = sums_over(three_masses().system, r, 1), three = sums_over(three_masses().system, r, 3);
    CHECK(one.V_re == three.V_re);
    CHECK(one.U == three.U);
    CHECK(one.H == three.H);
}

TEST_CASE("sums that are written over keep nothing of what they were", "[eq:33]") {
    const System<double> system = three_masses().system;
    const ModalBasis<Bounded<double>> basis = with_errors(system, modal_basis(system));
    ContactSums sums;
    contact_sums(basis, system.contact, system.load, std::vector<double>{1e-200, 0.5, 1.5}, 1, sums);
    CHECK(sums.without_numbers == std::vector<std::uint8_t>{1, 0, 0});
    contact_sums(basis, system.contact, system.load, std::vector<double>{0.5, 1.5}, 1, sums);
    CHECK(sums.without_numbers == std::vector<std::uint8_t>{0, 0});
    CHECK(sums.V_re == sums_over(system, {0.5, 1.5}, 1).V_re);
}

TEST_CASE("a sum beyond the range of a double is none", "[domain]") {
    const ContactSums sums = sums_over(three_masses().system, {1, 1e-200}, 1);
    CHECK(sums.without_numbers == std::vector<std::uint8_t>{0, 1});
    CHECK(sums.H[1] == 0);
    CHECK_FALSE(sums.certainty[1] > 0);
}

TEST_CASE("arguments of sums over arrays are checked", "[domain]") {
    const System<double> system = three_masses().system;
    const ModalBasis<Bounded<double>> basis = with_errors(system, modal_basis(system));
    const auto over = [&](Mass contact, const std::vector<double>& r, unsigned threads) {
        ContactSums sums;
        contact_sums(basis, contact, Mass{0}, r, threads, sums);
    };
    CHECK_THROWS_AS(over(Mass{0}, {1, -1}, 1), InputError);
    CHECK_THROWS_WITH(over(Mass{3}, {1}, 1), "contact must be a mass from 1 to 3, but is 4");
    CHECK_THROWS_WITH(over(Mass{0}, {1}, 0), "threads must be at least 1, but is 0");
}
