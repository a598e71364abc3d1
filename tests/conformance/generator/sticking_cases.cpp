#include "tests/conformance/generator/cases.hpp"

namespace denhartog::conformance::generator {
namespace {

// A motion with stops that a search from rest has found.
struct FoundMotion {
    std::vector<double> masses, springs, damping;
    int contact, load;
    double mu, r, beta;
};

const FoundMotion found_motions[] = {
    // mirrored, one period, 4 stops
    {{1}, {1}, {0.015625}, 1, 1, 1, 0.09375, 0.2734375},
    {{1, 2}, {1, 0.5}, {0.015625, 0.078125}, 1, 2, 1, 0.0625, 0.140625},
    {{1}, {1}, {0.03125}, 1, 1, 1, 0.09375, 0.5078125},
    {{1, 3}, {1, 2.375}, {0.09375, 0.015625}, 2, 1, 1, 0.046875, 0.34375},
    {{1}, {1}, {0.046875}, 1, 1, 1, 0.078125, 0.453125},
    // mirrored, one period, 6 stops
    {{1}, {1}, {0.015625}, 1, 1, 1, 0.078125, 0.5625},
    {{1, 3}, {1, 2.625}, {0.046875, 0.015625}, 1, 1, 1, 0.109375, 0.3203125},
    {{1}, {1}, {0.015625}, 1, 1, 1, 0.0625, 0.53125},
    {{1, 0.375}, {1, 2.25}, {0.015625, 0.125}, 2, 2, 1, 0.046875, 0.578125},
    // mirrored, one period, 8 stops
    {{1}, {1}, {0.015625}, 1, 1, 1, 0.0625, 0.59375},
    {{1, 0.875}, {1, 2.5}, {0.015625, 0.09375}, 2, 1, 1, 0.046875, 0.25},
    // mirrored, one period, 4 stops
    {{1}, {1}, {0.015625}, 1, 1, 1.5, 0.140625, 0.46875},
    {{1, 0.375}, {1, 3}, {0.03125, 0.0625}, 2, 1, 1.375, 0.109375, 0.328125},
    {{1}, {1}, {0.046875}, 1, 1, 1.375, 0.109375, 0.375},
    // mirrored, one period, 6 stops
    {{1}, {1}, {0.046875}, 1, 1, 1.375, 0.0625, 0.3046875},
    // mirrored, one period, 8 stops
    {{1}, {1}, {0.0625}, 1, 1, 1.375, 0.046875, 0.359375},
    // unsymmetric, one period, 1 stop
    {{1}, {1}, {0.03125}, 1, 1, 3.625, 0.609375, 0.203125},
    {{1, 1.75}, {1, 2.5}, {0.015625, 0.0625}, 1, 2, 3.25, 1.15625, 0.21875},
    {{1}, {1}, {0.046875}, 1, 1, 3.375, 0.703125, 0.2734375},
    {{1, 1.5}, {1, 2.75}, {0.0625, 0.03125}, 1, 2, 2.0, 1.34375, 0.328125},
    // unsymmetric, one period, 2 stops
    {{1}, {1}, {0.03125}, 1, 1, 3.75, 0.359375, 0.1640625},
    {{1, 2.25}, {1, 3}, {0.078125, 0.046875}, 2, 1, 2.75, 0.1875, 0.1796875},
    {{1}, {1}, {0.03125}, 1, 1, 2.5, 0.609375, 0.328125},
    {{1, 0.75}, {1, 2.875}, {0.03125, 0.046875}, 2, 1, 3.375, 0.125, 0.28125},
    // unsymmetric, one period, 3 stops
    {{1}, {1}, {0.046875}, 1, 1, 2.5, 0.15625, 0.109375},
    {{1, 1.75}, {1, 2.25}, {0.015625, 0.09375}, 1, 2, 1.25, 0.125, 0.1171875},
    {{1}, {1}, {0.015625}, 1, 1, 1.375, 0.09375, 0.1328125},
    {{1, 0.625}, {1, 1.625}, {0.03125, 0.015625}, 1, 1, 1.125, 0.109375, 0.375},
    // mirrored, 3 periods, 2 stops
    {{1, 2.625}, {1, 2.5}, {0.109375, 0.109375}, 1, 1, 1.5, 1.03125, 0.453125},
    {{1, 1.875}, {1, 1.625}, {0.046875, 0.078125}, 1, 1, 2.75, 0.890625, 0.1953125},
    // mirrored, 3 periods, 4 stops
    {{1}, {1}, {0.015625}, 1, 1, 3.5, 0.40625, 0.078125},
    // unsymmetric, 2 periods, 1 stop
    {{1, 1}, {1, 2.25}, {0.03125, 0.015625}, 1, 2, 4.0, 1.4375, 0.546875},
    {{1, 3}, {1, 1.75}, {0.015625, 0.015625}, 2, 2, 3.25, 1.265625, 0.28125},
    // unsymmetric, 2 periods, 2 stops
    {{1, 2}, {1, 1}, {0.109375, 0.015625}, 2, 1, 1.75, 1.03125, 0.4921875},
    {{1, 3}, {1, 1}, {0.046875, 0.109375}, 1, 2, 2.375, 0.703125, 0.5625},
    // mirrored, 5 periods, 2 stops
    {{1, 3}, {1, 1.375}, {0.03125, 0.03125}, 1, 1, 2.5, 0.671875, 0.171875},
    // unsymmetric, 3 periods, 1 stop
    {{1, 0.5}, {1, 0.625}, {0.0625, 0.03125}, 2, 1, 3.875, 1.140625, 0.265625}};

Case drawn_case(Draw& draw, const char* group, int N, int place, Friction friction, double part) {
    Case c{.group = group, .scene = drawn_scene(draw, N, place)};
    c.scene.r = draw.fraction(0.25, 1.5, 32);
    c.friction = friction;
    c.part = part;
    c.bits = 8;
    return c;
}

Case case_of(const FoundMotion& found) {
    Case c;
    c.group = "stick-slip";
    c.scene.mass_ratios = found.masses;
    c.scene.stiffness_ratios = found.springs;
    c.scene.damping_ratios = found.damping;
    c.scene.contact = found.contact;
    c.scene.load = found.load;
    c.scene.mu = found.mu;
    c.scene.r = found.r;
    c.scene.beta = found.beta;
    c.asked = {ask("amplitude", found.contact), ask("stops_per_period"), ask("stop_durations"), ask("phase", found.contact)};
    return c;
}

int other_mass(const Case& c) { return c.scene.contact == 1 ? 2 : 1; }

} // namespace

std::vector<Case> cases_of_sticking() {
    Draw draw(88);
    std::vector<Case> cases;
    for (int n = 0; n < 60; ++n) {
        const int N = n < 16 ? 1 : n < 36 ? 2 : n < 50 ? 3 : n < 56 ? 4 : 5 + n % 2;
        Case c = drawn_case(draw, "stick-slip", N, n % 3, Friction::between, draw.fraction(0.125, 0.875, 16));
        if (n % 2 == 0) c.scene.mu = 1;
        if (n % 5 == 4) c.scene.r = draw.fraction(0.09375, 0.3125, 64);
        c.asked = {ask("amplitude", c.scene.contact), ask("phase", c.scene.contact), ask("stops_per_period"),
                   ask("stop_durations")};
        if (N > 1) {
            c.asked.push_back(ask("amplitude", other_mass(c)));
            c.asked.push_back(ask("phase", other_mass(c)));
        }
        cases.push_back(c);
    }
    for (int n = 0; n < 12; ++n) { // who has a motion with stops has to count them
        Case c = drawn_case(draw, "stick-slip", 1 + n % 2, n % 3, Friction::between, draw.fraction(0.25, 0.75, 16));
        c.scene.mu = 1;
        c.asked = {ask("stops_per_period")};
        cases.push_back(c);
    }
    for (const FoundMotion& found : found_motions) cases.push_back(case_of(found));
    Draw barely(74);
    for (int n = 0; n < 8; ++n) { // the contact only just stops, or hardly moves
        Case c = drawn_case(barely, "stick-slip", 1 + n % 2, n % 3, Friction::between, n % 4 < 2 ? 0.015625 : 0.96875);
        c.scene.mu = 1;
        c.bits = 12;
        c.asked = {ask("amplitude", c.scene.contact), ask("stops_per_period"), ask("stop_durations")};
        cases.push_back(c);
    }
    for (int n = 0; n < 48; ++n) {
        const int N = n < 12 ? 2 : n < 24 ? 3 : n < 32 ? 4 : 5 + (n - 32) % 8;
        Case c = drawn_case(draw, "stuck", N, n % 3, Friction::of_sticking, draw.fraction(1.0625, 3, 16));
        if (n % 4 == 3) c.scene.damping_ratios.assign(static_cast<std::size_t>(N), 0);
        c.asked = {ask("amplitude", c.scene.load == c.scene.contact ? other_mass(c) : c.scene.load),
                   ask("amplitude", c.scene.contact), ask("rest_interval"), ask("regime"), ask("beta_lim_sticking")};
        if (c.scene.load != c.scene.contact) c.asked.push_back(ask("phase", c.scene.load));
        cases.push_back(c);
    }
    for (int n = 0; n < 48; ++n) {
        const int N = 1 + n % 4;
        const Friction friction = n % 3 == 0 ? Friction::of_limit : n % 3 == 1 ? Friction::between : Friction::of_sticking;
        Case c = drawn_case(draw, "solver", N, (n / 3) % 3, friction, 0.5);
        c.scene.mu = n % 8 == 7 && friction == Friction::between ? 1.25 : 1;
        for (double& zeta : c.scene.damping_ratios) zeta += 0.03125;
        if (friction == Friction::of_limit) c.part = draw.fraction(0.25, 0.875, 16);
        if (friction == Friction::between) c.part = draw.fraction(0.25, 0.75, 16);
        if (friction == Friction::of_sticking) c.part = draw.fraction(3, 5, 4);
        const bool other = friction == Friction::of_sticking || n % 2 == 1;
        c.asked = {ask("motion_under_force", other && N > 1 ? other_mass(c) : c.scene.contact, 0, 32)};
        cases.push_back(c);
    }
    return cases;
}

} // namespace denhartog::conformance::generator
