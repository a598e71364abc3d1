#include "tests/conformance/generator/cases.hpp"

namespace denhartog::conformance::generator {
namespace {

Case of_group(const char* group, const ProtocolQuestion& scene) {
    Case c{.group = group, .scene = scene};
    return c;
}

void ask_modes(Case& c, Draw& draw) {
    const int N = static_cast<int>(c.scene.mass_ratios.size());
    c.asked = {ask("natural_frequency_ratios"), ask("modal_frequency_ratios"), ask("mode_shape_products", c.scene.contact)};
    if (N > 1) c.asked.push_back(ask("mode_shape_products", c.scene.contact % N + draw.integer(1, N) > N ? 1 : N));
}

void ask_functions(Case& c, int k) {
    c.asked = {ask("complex_response", k), ask("first_damping_function", k), ask("second_damping_function", k), ask("H_j"),
               ask("S_j")};
    const int N = static_cast<int>(c.scene.mass_ratios.size()), other = k % N + 1;
    if (N > 1) {
        c.asked.push_back(ask("first_damping_function", other));
        c.asked.push_back(ask("second_damping_function", other));
    }
}

// One mass: v, u, g over frequency and damping ratios, undamped, slightly damped, critical and overdamped among them.
void add_oscillators(std::vector<Case>& cases) {
    for (const double zeta : {0.0, 0.015625, 0.125, 0.375, 0.75, 1.0, 1.5, 3.0})
        for (const double r : {0.21875, 0.4375, 0.78125, 1.0, 1.375, 2.0, 3.5}) {
            if (zeta == 0 && r == 1.0) continue;
            Case c;
            c.group = "functions";
            c.scene.mass_ratios = c.scene.stiffness_ratios = {1};
            c.scene.damping_ratios = {zeta};
            c.scene.r = r;
            c.asked = {ask("complex_response", 1), ask("first_damping_function", 1), ask("second_damping_function", 1)};
            if (r == 0.4375 || r == 1.375) c.asked.push_back(ask("S_j"));
            if (zeta == 1) c.flags = {"critical"};
            cases.push_back(c);
        }
}

} // namespace

std::vector<Case> cases_of_modes() {
    Draw draw(2022);
    std::vector<Case> cases;
    for (int N = 1; N <= 12; ++N)
        for (int n = 0; n < (N == 1 ? 2 : N <= 4 ? 7 : 5); ++n) {
            Case c = of_group("modes", drawn_scene(draw, N, n % 3));
            ask_modes(c, draw);
            cases.push_back(c);
        }
    add_oscillators(cases);
    for (int N = 2; N <= 12; ++N)
        for (int n = 0; n < (N <= 4 ? 7 : N <= 8 ? 4 : 2); ++n) {
            Case c = of_group("functions", drawn_scene(draw, N, n % 3));
            if (n == 3) c.scene.damping_ratios.assign(static_cast<std::size_t>(N), 0);
            if (n == 1) c.scene.damping_ratios.back() = 1.25;
            if (n == 2) c.scene.damping_ratios.front() = 0;
            ask_functions(c, n % 2 == 0 ? c.scene.contact : draw.integer(1, N));
            cases.push_back(c);
        }
    return cases;
}

} // namespace denhartog::conformance::generator
