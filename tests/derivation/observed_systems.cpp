// The functions with which the observations are measured, checked by other routes.
#include "derivation/observations/observed_systems.hpp"

#include <cmath>

#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "derivation/observations/contact_motions.hpp"
#include "tests/catch.hpp"
#include "tests/support/paper_systems.hpp"

using namespace denhartog;
using namespace denhartog::derivation;

TEST_CASE("without friction the peak of a single mass is that of the linear oscillator", "[eq:52][peak]") {
    for (const double zeta : damping_ratios_of_figures()) {
        const ObservedSystem s = observed_system("SDOF", zeta, single_mass(zeta));
        const std::optional<Peak> peak = peak_near(s, 0, 0, 0);
        REQUIRE(peak);
        CHECK(peak->X == Approx(1 / (2 * zeta * std::sqrt(1 - zeta * zeta))).epsilon(1e-12));
        CHECK(peak->r == Approx(std::sqrt(1 - 2 * zeta * zeta)).epsilon(1e-7));
    }
}

TEST_CASE("no amplitude of a dense scan is above the peak that was found", "[eq:52][peak]") {
    const ObservedSystem s = observed_system("2DOF", 0.01, two_masses(0.01));
    for (std::size_t i = 0; i < 2; ++i) {
        const std::optional<Peak> peak = peak_near(s, 1, i, 0.375);
        REQUIRE(peak);
        double largest = 0;
        for (int n = -2000; n <= 2000; ++n) {
            const ModeSums<double> m = sums_at(s, s.basis.r_n[i] * (1 + n / 10000.0));
            if (0.375 < boundary(m, 1.0).exact) largest = std::fmax(largest, monoharmonic_amplitude(m, 1, 0.375));
        }
        CHECK(largest <= peak->X * (1 + 1e-12));
        CHECK(largest == Approx(peak->X).epsilon(1e-3)); // next to the peak the scan can be half of its step off
    }
}

TEST_CASE("where the contact does not slide there is no peak", "[eq:52][peak]") {
    const ObservedSystem s = observed_system("SDOF", 0.1, single_mass(0.1));
    CHECK(limit_at(s, 0) < 1);
    CHECK_FALSE(peak_near(s, 0, 0, 1.5));
}

TEST_CASE("the steady motion of the contact is the one that the paper's algorithm tends to", "[eq:74][stick-slip]") {
    struct Point {
        double zeta, r, beta;
    };
    for (const Point& p : {Point{0.01, 0.1, 0.2}, Point{0.1, 0.1, 0.2}, Point{0.1, 0.3, 0.4}, Point{0.1, 5, 0.8}}) {
        const ContactSystem system = contact_system(single_mass(p.zeta));
        ExactSolver solver(system, {1, 1, 1});
        const ContactMotion motion = motion_of_contact(solver, p.r, p.beta);
        Scene<double> scene;
        scene.system = single_mass(p.zeta);
        scene.r = p.r;
        scene.beta = p.beta;
        PaperSettings settings;
        settings.absolute_tolerance = 1e-9;
        const PaperMotion numerical = paper_algorithm(scene, settings);
        INFO("zeta " << p.zeta << ", r " << p.r << ", beta " << p.beta);
        CHECK(motion.X == Approx(numerical.masses[0].amplitude).epsilon(1e-6));
        CHECK(motion.stops == numerical.stops.size());
    }
}
