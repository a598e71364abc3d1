// Section 2.6: where the approximate boundary (67) departs most from (69), over the damping ratio.
#include <cmath>

#include "derivation/observations/boundary_maxima.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

namespace {

/// The largest departure of (67) from (69) over the frequency ratio, at damping ratios from zero on.
Outcome largest_without_damping() {
    Outcome outcome;
    Witness witness;
    double excess = -INFINITY;
    for (const std::string name : {"SDOF", "2DOF j=2 l=1"}) {
        double without = 0;
        std::string line = name + ", largest departure of (67) over r = 0.1 to 3:";
        for (const double zeta : {0.0, 1e-6, 1e-4, 0.001, 0.01, 0.1}) {
            const ObservedSystem s = observed_system(name, zeta, name == "SDOF" ? single_mass(zeta) : two_masses(zeta));
            const LargestOverRange most = largest_over_frequency(s, 0.1, 3, departure_of_67);
            line += (zeta > 0 ? "; " : " ") + rounded(most.value) + " at zeta = " + rounded(zeta) + ", r = " + rounded(most.x);
            if (zeta == 0) without = most.value;
            if (zeta == 0 || most.value / without - 1 <= excess) continue;
            excess = most.value / without - 1;
            witness = {{"system", name},
                       {"zeta", text(zeta)},
                       {"r", text(most.x)},
                       {"departure", text(most.value)},
                       {"largest without damping", text(without)}};
        }
        outcome.steps.push_back({line, ""});
    }
    if (excess > 1e-3) outcome.verdict = Verdict::refuted;
    outcome.witness = with(witness, {{"over that without damping, less 1", text(excess)}});
    return outcome;
}

const Register claims_of_boundary_error_observations([] {
    return std::vector<Claim>{
        observation("67/largest-without-damping/text", {"67", "69"},
                    "Observation in the text: (67) departs most from (69) where there is no damping; here: its largest departure "
                    "over r",
                    {"SDOF and 2DOF j=2 l=1", "r = 0.1 to 3", "zeta = 0, 1e-6, 1e-4, 0.001, 0.01, 0.1", "mu = 1"},
                    largest_without_damping),
    };
});

} // namespace
} // namespace denhartog::derivation
