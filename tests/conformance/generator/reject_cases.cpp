#include "tests/conformance/generator/cases.hpp"

namespace denhartog::conformance::generator {
namespace {

class Breaker {
public:
    std::vector<Case> cases;

    // A scene of three masses that keeps every rule, until `breaks` has been at it.
    template <class F>
    void add(const std::string& rule, F breaks) {
        static const char* const quantities[] = {"amplitude", "phase", "beta_lim_exact", "natural_frequency_ratios", "regime"};
        Case c{.group = "reject", .reject = rule};
        ProtocolQuestion& q = c.scene;
        q.mass_ratios = {1, 1.5, 0.75};
        q.stiffness_ratios = {1, 0.625, 2};
        q.damping_ratios = {0.03125, 0.0625, 0.125};
        q.contact = 2;
        q.load = 1;
        q.r = 0.75;
        q.beta = 0.125;
        ProtocolQuestion asked = ask(quantities[cases.size() % 5], cases.size() % 5 < 2 ? 1 : 0);
        breaks(q, asked);
        c.asked = {asked};
        cases.push_back(c);
    }
};

void break_lists(Breaker& b) {
    b.add("a mass ratio is negative", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mass_ratios[1] = -1.5; });
    b.add("a mass ratio is negative", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mass_ratios[2] = -0.0009765625; });
    b.add("a mass ratio is zero", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mass_ratios[2] = 0; });
    b.add("the first mass ratio is not 1", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mass_ratios[0] = 2; });
    b.add("the first mass ratio is not 1", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mass_ratios[0] = -1; });
    b.add("a mass ratio too few", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mass_ratios.pop_back(); });
    b.add("a mass ratio too many", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mass_ratios.push_back(2); });
    b.add("no mass ratio", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mass_ratios.clear(); });
    b.add("a stiffness ratio is negative", [](ProtocolQuestion& q, ProtocolQuestion&) { q.stiffness_ratios[1] = -0.625; });
    b.add("a stiffness ratio is negative", [](ProtocolQuestion& q, ProtocolQuestion&) { q.stiffness_ratios[2] = -1000000; });
    b.add("a stiffness ratio is zero", [](ProtocolQuestion& q, ProtocolQuestion&) { q.stiffness_ratios[2] = 0; });
    b.add("the first stiffness ratio is not 1", [](ProtocolQuestion& q, ProtocolQuestion&) { q.stiffness_ratios[0] = 0.5; });
    b.add("a stiffness ratio too few", [](ProtocolQuestion& q, ProtocolQuestion&) { q.stiffness_ratios.pop_back(); });
    b.add("a stiffness ratio too many", [](ProtocolQuestion& q, ProtocolQuestion&) { q.stiffness_ratios.push_back(1); });
    b.add("no stiffness ratio", [](ProtocolQuestion& q, ProtocolQuestion&) { q.stiffness_ratios.clear(); });
    b.add("a damping ratio is negative", [](ProtocolQuestion& q, ProtocolQuestion&) { q.damping_ratios[0] = -0.03125; });
    b.add("a damping ratio is negative", [](ProtocolQuestion& q, ProtocolQuestion&) { q.damping_ratios[2] = -2; });
    b.add("a damping ratio too few", [](ProtocolQuestion& q, ProtocolQuestion&) { q.damping_ratios.pop_back(); });
    b.add("a damping ratio too many", [](ProtocolQuestion& q, ProtocolQuestion&) { q.damping_ratios.push_back(0.5); });
    b.add("no damping ratio", [](ProtocolQuestion& q, ProtocolQuestion&) { q.damping_ratios.clear(); });
}

void break_numbers(Breaker& b) {
    b.add("the contact is before the first mass", [](ProtocolQuestion& q, ProtocolQuestion&) { q.contact = 0; });
    b.add("the contact is before the first mass", [](ProtocolQuestion& q, ProtocolQuestion&) { q.contact = -1; });
    b.add("the contact is behind the last mass", [](ProtocolQuestion& q, ProtocolQuestion&) { q.contact = 4; });
    b.add("the load is before the first mass", [](ProtocolQuestion& q, ProtocolQuestion&) { q.load = 0; });
    b.add("the load is behind the last mass", [](ProtocolQuestion& q, ProtocolQuestion&) { q.load = 4; });
    b.add("mu is below 1", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mu = 0.9990234375; });
    b.add("mu is below 1", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mu = 0.5; });
    b.add("mu is below 1", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mu = 0; });
    b.add("mu is below 1", [](ProtocolQuestion& q, ProtocolQuestion&) { q.mu = -1.5; });
    b.add("r is zero", [](ProtocolQuestion& q, ProtocolQuestion&) { q.r = 0; });
    b.add("r is negative", [](ProtocolQuestion& q, ProtocolQuestion&) { q.r = -0.75; });
    b.add("beta is negative", [](ProtocolQuestion& q, ProtocolQuestion&) { q.beta = -0.125; });
    b.add("beta is negative", [](ProtocolQuestion& q, ProtocolQuestion&) { q.beta = -1000; });
    for (const int k : {5, 4, -2, 12})
        b.add("the mass asked about is not there",
              [k](ProtocolQuestion&, ProtocolQuestion& asked) { asked = ask("amplitude", k); });
}

} // namespace

std::vector<Case> cases_of_rejection() {
    Breaker b;
    break_lists(b);
    break_numbers(b);
    return b.cases;
}

} // namespace denhartog::conformance::generator
