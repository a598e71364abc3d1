#include <cmath>

#include "tests/conformance/generator/cases.hpp"

namespace denhartog::conformance::generator {
namespace {

Case stress(const std::vector<double>& gamma, const std::vector<double>& kappa, const std::vector<double>& zeta, double r,
            const std::string& flag) {
    Case c;
    c.group = c.tier = "stress";
    c.scene.mass_ratios = gamma;
    c.scene.stiffness_ratios = kappa;
    c.scene.damping_ratios = zeta;
    c.scene.contact = static_cast<int>(gamma.size());
    c.scene.r = r;
    c.friction = Friction::of_limit;
    c.part = 0.5;
    c.flags = {flag};
    const int k = c.scene.contact;
    c.asked = {ask("first_damping_function", k),
               ask("second_damping_function", k),
               ask("S_j"),
               ask("beta_lim_exact"),
               ask("amplitude", k),
               ask("phase", k)};
    return c;
}

// A small mass tuned to the rest: two natural frequencies that merge, root of the mass ratio apart.
void add_merging(std::vector<Case>& cases) {
    for (const int k : {4, 8, 12, 16}) {
        const double small = std::ldexp(1.0, -k);
        for (const double r : {0.625, 1.0625}) {
            Case c = stress({1, small}, {1, small}, {0.03125, 0.0625}, r, "merging");
            c.scene.contact = 1;
            c.scene.load = 2;
            for (ProtocolQuestion& q : c.asked)
                if (q.mass > 0) q.mass = 1;
            c.asked.push_back(ask("natural_frequency_ratios"));
            c.asked.push_back(ask("mode_shape_products", 1));
            c.asked.push_back(ask("mode_shape_products", 2));
            cases.push_back(c);
        }
    }
}

void add_mass_ratios(std::vector<Case>& cases) {
    for (const double heavy : {1024.0, 1000000.0}) {
        Case c = stress({1, heavy, 2}, {1, 1.5, 0.75}, {0.0625, 0.03125, 0.125}, 0.75, "mass-ratio");
        c.asked.push_back(ask("natural_frequency_ratios"));
        c.asked.push_back(ask("mode_shape_products", 2));
        cases.push_back(c);
        c = stress({1, 1 / 1024.0, 2}, {1, heavy, 0.75}, {0.0625, 0.03125, 0.125}, 0.75, "stiffness-ratio");
        c.asked.push_back(ask("natural_frequency_ratios"));
        c.asked.push_back(ask("amplitude", 1));
        cases.push_back(c);
    }
}

// Next to the poles of (28) at R = 1/n, n odd, nearly without damping.
void add_poles(std::vector<Case>& cases) {
    for (const double r : {0.3330078125, 0.33331298828125, 0.199951171875, 0.142822265625, 1.0009765625, 0.99993896484375})
        for (const int k : {8, 12, 16}) cases.push_back(stress({1}, {1}, {std::ldexp(1.0, -k)}, r, "odd-fraction"));
    for (const int k : {8, 14}) {
        Case c = stress({1, 2.25}, {1, 2.25}, {std::ldexp(1.0, -k), std::ldexp(1.0, -k)}, 0.16668701171875, "odd-fraction");
        c.asked.push_back(ask("amplitude", 1));
        cases.push_back(c);
    }
}

// Where products in the printed forms overflow, or differences of nearly equal numbers are left.
void add_extremes(std::vector<Case>& cases) {
    for (const double r : {0.03125, 0.0078125, 0.0009765625})
        for (const double zeta : {0.015625, 0.25, 0.75}) cases.push_back(stress({1}, {1}, {zeta}, r, "low-frequency"));
    for (const double r : {64.0, 1024.0, 32768.0})
        for (const double zeta : {0.0, 0.0625, 0.5}) cases.push_back(stress({1}, {1}, {zeta}, r, "high-frequency"));
    for (const int k : {10, 20, 40})
        for (const double side : {-1.0, 1.0})
            for (const double r : {0.4375, 1.5})
                cases.push_back(stress({1}, {1}, {1 + side * std::ldexp(1.0, -k)}, r, "nearly-critical"));
    for (const double zeta : {16.0, 1024.0, 1000000.0})
        for (const double r : {0.4375, 1.5}) cases.push_back(stress({1}, {1}, {zeta}, r, "overdamped"));
}

// Just below the boundary, where the amplitude is a difference and the root of (38) nearly vanishes.
void add_edges(std::vector<Case>& cases) {
    Draw draw(57);
    for (int N = 1; N <= 12; ++N) {
        Case c = stress({1}, {1}, {0.0625}, 0.4375, "near-boundary");
        c.scene = drawn_scene(draw, N, N % 3);
        c.scene.r = draw.fraction(0.125, 0.75, 64);
        c.part = 1 - std::ldexp(1.0, -20);
        c.bits = 40;
        const int k = c.scene.contact;
        c.asked = {ask("amplitude", k), ask("phase", k), ask("regime")};
        if (N > 1) c.asked.push_back(ask("amplitude", k % N + 1));
        cases.push_back(c);
        c.part = 1 + std::ldexp(1.0, -20);
        c.asked = {ask("regime")};
        cases.push_back(c);
    }
}

} // namespace

std::vector<Case> cases_of_stress() {
    std::vector<Case> cases;
    add_merging(cases);
    add_mass_ratios(cases);
    add_poles(cases);
    add_extremes(cases);
    add_edges(cases);
    return cases;
}

} // namespace denhartog::conformance::generator
