#include "tests/conformance/generator/cases.hpp"

namespace denhartog::conformance::generator {
namespace {

Case sliding(const char* group, const ProtocolQuestion& scene, double part) {
    Case c{.group = group, .scene = scene};
    c.friction = Friction::of_limit;
    c.part = part;
    return c;
}

constexpr double parts[] = {0.5, 0.125, 0.875, 0.3125, 0.75, 0.96875, 0.0625};

void vary_damping(Case& c, int n) {
    if (n % 7 == 4) c.scene.damping_ratios.assign(c.scene.damping_ratios.size(), 0);
    if (n % 7 == 5) c.scene.damping_ratios.back() = 1.75;
    if (n % 7 == 6) c.scene.damping_ratios.front() = 0;
}

int other_mass(const Case& c, Draw& draw) {
    const int N = static_cast<int>(c.scene.mass_ratios.size());
    return (c.scene.contact - 1 + draw.integer(1, N - 1)) % N + 1;
}

void add_oscillators(std::vector<Case>& cases) {
    int n = 0;
    for (const double zeta : {0.0, 0.03125, 0.25, 1.25})
        for (const double r : {0.3125, 0.625, 0.90625, 1.25, 1.75, 3.0}) {
            ProtocolQuestion q;
            q.mass_ratios = q.stiffness_ratios = {1};
            q.damping_ratios = {zeta};
            q.r = r;
            q.mu = n % 3 == 2 ? 1.5 : 1;
            Case c = sliding("contact", q, parts[n++ % 7]);
            c.asked = {ask("amplitude", 1), ask("phase", 1)};
            cases.push_back(c);
        }
}

} // namespace

std::vector<Case> cases_of_sliding() {
    Draw draw(535);
    std::vector<Case> cases;
    add_oscillators(cases);
    for (int N = 2; N <= 12; ++N)
        for (int n = 0; n < (N <= 3 ? 21 : N <= 5 ? 14 : N <= 8 ? 6 : 3); ++n) {
            Case c = sliding("contact", drawn_scene(draw, N, n % 3), parts[n % 7]);
            vary_damping(c, n);
            c.asked = {ask("amplitude", c.scene.contact), ask("phase", c.scene.contact)};
            cases.push_back(c);
        }
    for (int N = 1; N <= 12; ++N)
        for (int n = 0; n < (N <= 5 ? 7 : N <= 8 ? 3 : 2); ++n) {
            Case c = sliding("motion", drawn_scene(draw, N, (n + 1) % 3), parts[(n + N) % 7]);
            vary_damping(c, n);
            const int k = draw.integer(1, N);
            c.asked = {ask("initial_displacement", k), ask("initial_velocity", N > 1 ? other_mass(c, draw) : 1),
                       ask("displacement", k, draw.fraction(0.125, 3, 16)),
                       ask("displacement", c.scene.contact, draw.fraction(3.25, 6.25, 16))};
            cases.push_back(c);
        }
    for (int N = 2; N <= 12; ++N)
        for (int n = 0; n < (N <= 4 ? 14 : N <= 6 ? 7 : N <= 8 ? 3 : 2); ++n) {
            Case c = sliding("masses", drawn_scene(draw, N, (n + 2) % 3), parts[(n + 2 * N) % 7]);
            vary_damping(c, n);
            const int k = other_mass(c, draw);
            c.asked = {ask("amplitude", k), ask("phase", k), ask("amplitude_monoharmonic", k), ask("phase_monoharmonic", k)};
            cases.push_back(c);
        }
    return cases;
}

} // namespace denhartog::conformance::generator
