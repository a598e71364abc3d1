#include "tests/conformance/generator/cases.hpp"

#include <map>

namespace denhartog::conformance::generator {

int Draw::integer(int from, int to) {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    return from + static_cast<int>(z % static_cast<std::uint64_t>(to - from + 1));
}

double Draw::fraction(double from, double to, int parts) {
    return static_cast<double>(integer(static_cast<int>(from * parts), static_cast<int>(to * parts))) / parts;
}

ProtocolQuestion drawn_scene(Draw& draw, int N, int place) {
    ProtocolQuestion q;
    for (int i = 0; i < N; ++i) {
        q.mass_ratios.push_back(i == 0 ? 1 : draw.fraction(0.375, 3.5, 8));
        q.stiffness_ratios.push_back(i == 0 ? 1 : draw.fraction(0.375, 3.5, 8));
        q.damping_ratios.push_back(draw.fraction(0.015625, 0.25, 64));
    }
    if (N > 1) {
        const int low = draw.integer(1, N - 1), high = draw.integer(low + 1, N);
        q.contact = place == 0 ? low : high;
        q.load = place == 2 ? low : high;
    }
    if (draw.integer(0, 2) == 0) q.mu = 1 + draw.fraction(0.125, 1.5, 8);
    q.r = draw.fraction(0.25, 3, 32);
    return q;
}

ProtocolQuestion ask(const std::string& quantity, int mass, double tau, int samples) {
    ProtocolQuestion q;
    q.quantity = quantity;
    q.mass = mass;
    q.tau = tau;
    q.samples = samples;
    return q;
}

std::vector<Case> all_cases() {
    std::vector<Case> all;
    for (const auto& list : {cases_of_modes(), cases_of_sliding(), cases_of_limits(), cases_of_sticking(), cases_of_stress(),
                             cases_of_rejection(), cases_of_systems()})
        all.insert(all.end(), list.begin(), list.end());
    std::map<std::string, int> numbers;
    for (Case& c : all) {
        c.first_number = numbers[c.group] + 1;
        numbers[c.group] += static_cast<int>(c.asked.size());
    }
    std::erase_if(all, [](const Case& c) { return c.withdrawn; });
    return all;
}

} // namespace denhartog::conformance::generator
