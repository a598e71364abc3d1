#include "tests/conformance/generator/cases.hpp"

namespace denhartog::conformance::generator {
namespace {

// Chains of two masses whose natural frequency ratios a and b are exact.
struct ExactPair {
    double gamma, kappa, a, b;
};
constexpr ExactPair exact_pairs[] = {
    {2.25, 2.25, 0.5, 2}, {14.0625, 14.0625, 0.25, 4}, {2.8125, 11.25, 0.5, 4}, {11.25, 2.8125, 0.25, 2}};

ProtocolQuestion pair_scene(const ExactPair& p, int place, double zeta_1, double zeta_2) {
    ProtocolQuestion q;
    q.mass_ratios = {1, p.gamma};
    q.stiffness_ratios = {1, p.kappa};
    q.damping_ratios = {zeta_1, zeta_2};
    q.contact = place == 0 ? 1 : 2;
    q.load = place == 2 ? 1 : place == 0 ? 2 : q.contact;
    return q;
}

ProtocolQuestion oscillator(double zeta, double r, double mu = 1) {
    ProtocolQuestion q;
    q.mass_ratios = q.stiffness_ratios = {1};
    q.damping_ratios = {zeta};
    q.r = r;
    q.mu = mu;
    return q;
}

Case limit(const ProtocolQuestion& scene, const std::string& flag) {
    Case c{.group = "limits", .scene = scene};
    c.flags = {flag};
    c.friction = Friction::of_limit;
    c.part = 0.4375;
    const int k = scene.contact;
    c.asked = {ask("complex_response", k),
               ask("first_damping_function", k),
               ask("second_damping_function", k),
               ask("amplitude", k),
               ask("phase", k),
               ask("beta_lim_exact")};
    return c;
}

void add_resonances(std::vector<Case>& cases) {
    int n = 0;
    for (const ExactPair& p : exact_pairs)
        for (const double r : {p.a, p.b}) {
            ProtocolQuestion q = pair_scene(p, n % 3, 0.03125, 0.0625);
            q.r = r;
            q.mu = n++ % 2 == 0 ? 1 : 1.25;
            cases.push_back(limit(q, "at-resonance"));
        }
    for (const double zeta : {0.25, 0.0078125, 0.0009765625}) {
        cases.push_back(limit(oscillator(zeta, 1), "at-resonance"));
        cases.push_back(limit(oscillator(zeta, 0.9990234375, 1.5), "near-resonance"));
        cases.push_back(limit(oscillator(zeta, 1.001953125), "near-resonance"));
    }
}

void add_far_frequencies(std::vector<Case>& cases, Draw& draw) {
    for (int N = 1; N <= 4; ++N)
        for (const double r : {0.09375, 12.5, 40.0, 1000.0}) {
            ProtocolQuestion q = drawn_scene(draw, N, N % 3);
            q.r = r;
            cases.push_back(limit(q, r < 1 ? "low-frequency" : "high-frequency"));
        }
    for (const double mu : {1.0, 1.125, 1.5, 2.0, 3.5, 10.0})
        for (const int N : {1, 2, 4}) {
            Case c{.group = "limits", .scene = drawn_scene(draw, N, 1)};
            c.scene.mu = mu;
            c.flags = {"high-frequency"};
            c.asked = {ask("beta_lim_high_frequency")};
            cases.push_back(c);
        }
}

// On both sides of both boundaries, nearer and nearer.
void add_regimes(std::vector<Case>& cases, Draw& draw) {
    struct Place {
        Friction friction;
        double part;
        int bits;
    };
    constexpr Place places[] = {{Friction::of_limit, 0.5, 10},
                                {Friction::of_limit, 0.984375, 14},
                                {Friction::of_limit, 1.015625, 14},
                                {Friction::of_limit, 0.9998779296875, 20},
                                {Friction::of_limit, 1.0001220703125, 20},
                                {Friction::between, 0.5, 10},
                                {Friction::of_sticking, 0.984375, 14},
                                {Friction::of_sticking, 1.015625, 14},
                                {Friction::of_sticking, 1.0001220703125, 20},
                                {Friction::of_sticking, 2, 10}};
    for (int n = 0; n < 9; ++n) {
        const ProtocolQuestion scene = drawn_scene(draw, n == 0 ? 1 : 1 + n % 5, n % 3);
        for (const Place& p : places) {
            Case c{.group = "boundary", .scene = scene};
            c.friction = p.friction;
            c.part = p.part;
            c.bits = p.bits;
            c.asked = {ask("regime")};
            cases.push_back(c);
        }
    }
}

/// Slow motions of few masses, where what sliding asks for is largest inside the half-period: there (56) as printed shows.
void add_slow_boundaries(std::vector<Case>& cases, Draw& draw) {
    for (int n = 0; n < 16; ++n) {
        Case c{.group = "boundary", .scene = drawn_scene(draw, 2 + n % 4, n % 2 == 0 ? 0 : 2)};
        c.scene.mu = 1;
        c.scene.r = draw.fraction(0.125, 0.375, 64);
        c.asked = {ask("S_j"), ask("beta_lim_exact")};
        cases.push_back(c);
    }
}

} // namespace

std::vector<Case> cases_of_limits() {
    Draw draw(117085);
    std::vector<Case> cases;
    for (int N = 1; N <= 12; ++N)
        for (int n = 0; n < (N == 1 ? 14 : N <= 4 ? 9 : N <= 8 ? 4 : 2); ++n) {
            Case c{.group = "boundary", .scene = drawn_scene(draw, N, n % 3)};
            if (n % 5 == 4) c.scene.r = draw.fraction(0.125, 0.5, 64);
            if (n % 5 == 3) c.scene.damping_ratios.front() = 0;
            if (n % 5 == 2) c.scene.damping_ratios.back() = 2;
            c.asked = {ask("beta_lim_exact"), ask("beta_lim_paper"), ask("beta_lim_approximate"), ask("beta_lim_sticking")};
            cases.push_back(c);
        }
    add_regimes(cases, draw);
    add_resonances(cases);
    add_far_frequencies(cases, draw);
    add_slow_boundaries(cases, draw);
    return cases;
}

} // namespace denhartog::conformance::generator
