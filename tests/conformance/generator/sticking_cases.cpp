#include "tests/conformance/generator/cases.hpp"

namespace denhartog::conformance::generator {
namespace {

Case drawn_case(Draw& draw, const char* group, int N, int place, Friction friction, double part) {
    Case c;
    c.group = group;
    c.tier = "should";
    c.scene = drawn_scene(draw, N, place);
    c.scene.r = draw.fraction(0.25, 1.5, 32);
    c.friction = friction;
    c.part = part;
    c.bits = 8;
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
        c.tier = "must";
        c.scene.mu = 1;
        c.asked = {ask("stops_per_period")};
        cases.push_back(c);
    }
    for (int n = 0; n < 48; ++n) {
        const int N = n < 12 ? 2 : n < 24 ? 3 : n < 32 ? 4 : 5 + (n - 32) % 8;
        Case c = drawn_case(draw, "stuck", N, n % 3, Friction::of_sticking, draw.fraction(1.0625, 3, 16));
        c.tier = "must";
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
        if (friction != Friction::between) c.tier = "must"; // the closed form gives it
        const bool other = friction == Friction::of_sticking || n % 2 == 1;
        c.asked = {ask("motion_under_force", other && N > 1 ? other_mass(c) : c.scene.contact, 0, 32)};
        cases.push_back(c);
    }
    return cases;
}

} // namespace denhartog::conformance::generator
