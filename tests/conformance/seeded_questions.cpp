#include "tests/conformance/seeded_questions.hpp"

#include <cmath>
#include <random>

#include "conformance/plain/closed_form.hpp"

namespace denhartog::tests {
namespace {

// A multiple of 1 / parts between two numbers.
double fraction(std::mt19937_64& random, int from, int to, int parts) {
    const auto range = static_cast<std::uint64_t>(to - from + 1);
    return static_cast<double>(from + static_cast<int>(random() % range)) / parts;
}

// A share of the boundary of continuous sliding, in 16 bits.
void set_friction(conformance::ProtocolQuestion& q, double share) {
    q.quantity = "beta_lim_exact";
    const double limit = conformance::plain_answer(q).value().numbers.front();
    q.beta = std::ldexp(std::round(std::ldexp(limit * share, 16)), -16);
    q.quantity = "amplitude";
}

int place(std::mt19937_64& random, int N) { return 1 + static_cast<int>(random() % static_cast<std::uint64_t>(N)); }

} // namespace

std::vector<conformance::ProtocolQuestion> seeded_questions(std::uint64_t seed, int count) {
    std::mt19937_64 random(seed);
    std::vector<conformance::ProtocolQuestion> questions;
    for (int n = 0; n < count; ++n) {
        conformance::ProtocolQuestion q;
        const int N = 1 + n % 5;
        q.mass_ratios = q.stiffness_ratios = {1};
        for (int i = 1; i < N; ++i) {
            q.mass_ratios.push_back(fraction(random, 8, 96, 32));
            q.stiffness_ratios.push_back(fraction(random, 8, 96, 32));
        }
        for (int i = 0; i < N; ++i) q.damping_ratios.push_back(fraction(random, 4, 60, 512));
        q.contact = place(random, N);
        q.load = place(random, N);
        q.mass = place(random, N);
        q.mu = fraction(random, 32, 64, 32);
        q.r = fraction(random, 30, 250, 128);
        q.tau = fraction(random, 0, 100, 16);
        q.samples = 16;
        q.quantity = "amplitude";
        q.id = "seeded-" + std::to_string(n);
        const conformance::PlainModes m = conformance::plain_modes(q, {});
        const double limit = conformance::plain_limit(m, {}, conformance::plain_demand(m, {}, false));
        const double share = n % 3 < 2 ? fraction(random, 16, 60, 64) : fraction(random, 72, 160, 64);
        q.beta = std::ldexp(std::round(std::ldexp(limit * share, 16)), -16);
        questions.push_back(q);
    }
    return questions;
}

std::vector<conformance::ProtocolQuestion> seeded_systems(std::uint64_t seed, int count) {
    std::mt19937_64 random(seed);
    std::vector<conformance::ProtocolQuestion> systems;
    for (conformance::ProtocolQuestion q : seeded_questions(seed, 2 * count)) {
        const auto N = q.mass_ratios.size();
        const auto n = static_cast<int>(systems.size());
        if (N == 1 || n == count) continue;
        q.mu = 1;
        if (n % 4 == 0) {
            q.contact_with = q.contact % static_cast<int>(N) + 1;
            q.mass = n % 8 == 0 ? 0 : q.mass;
        } else if (n % 4 == 1) {
            for (std::size_t k = 0; k < N; ++k) q.loads.push_back(fraction(random, 4, 16, 16));
            q.loads[static_cast<std::size_t>(q.contact - 1)] = 0.125; // the largest elsewhere: alone on the contact it is refused
        } else if (n % 4 == 2) {
            q.base_motion = n % 8 == 2 ? "with_wall" : "alone";
            if (q.base_motion == "alone") q.damping_ratios.assign(N, 0);
        } else {
            q.damping_matrix.assign(N * N, 0);
            for (std::size_t k = 0; k < N; ++k) {
                const double c = fraction(random, 4, 24, 64);
                q.damping_matrix[k * N + k] += c;
                if (k == 0) continue;
                q.damping_matrix[(k - 1) * N + k - 1] += c;
                q.damping_matrix[(k - 1) * N + k] = q.damping_matrix[k * N + k - 1] = -c;
            }
            q.damping_ratios.clear();
        }
        if (n % 4 == 1 || n % 4 == 2) q.load = 0;
        set_friction(q, n % 8 < 4 ? 0.5 : 1.25);
        systems.push_back(q);
    }
    int more = 0;
    for (conformance::ProtocolQuestion q : seeded_questions(seed + 1, 2 * count)) {
        const auto N = q.mass_ratios.size();
        if (N == 1 || more == count) continue;
        static const char* const motions[] = {"", "alone", "wall", "with_wall"};
        q.mu = 1;
        q.load = 0;
        q.base_motion = motions[more % 4];
        for (std::size_t k = 0; k < N && q.base_motion.empty(); ++k) {
            q.loads.push_back(fraction(random, 4, 16, 16));
            q.load_phases.push_back(fraction(random, 4, 20, 8));
        }
        set_friction(q, more % 3 == 2 ? 1.25 : 0.5);
        q.id += "-more";
        systems.push_back(q);
        ++more;
    }
    return systems;
}

} // namespace denhartog::tests
