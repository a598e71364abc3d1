// Section 3.2.1: what the text says of the time responses of Figs. 4 and 5 and of the phases of their masses.
#include <cmath>

#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

namespace {

/// The point of Figs. 4 and 5.
constexpr double r_of_figures_4_and_5 = 0.9, beta_of_figures_4_and_5 = 0.2;

struct FiveMasses {
    ObservedSystem system;
    ModeSums<double> sums;
    SteadyState<double> state;
};

FiveMasses five(std::size_t j, double zeta) {
    ObservedSystem s = observed_system("5DOF j=" + std::to_string(j) + " l=1", zeta, five_masses(j, zeta));
    ModeSums<double> m = sums_at(s, r_of_figures_4_and_5);
    SteadyState<double> state = steady_state(m, boundary(m, 1.0), beta_of_figures_4_and_5);
    return {std::move(s), std::move(m), std::move(state)};
}

/// Largest difference of the displacements over a period, over the amplitude of the mass.
Outcome time_responses_agree() {
    Outcome outcome;
    Worst worst;
    for (const std::size_t j : {1, 3})
        for (const double zeta : {0.01, 0.1}) {
            const FiveMasses f = five(j, zeta);
            Scene<double> scene;
            scene.system = f.system.system;
            scene.r = r_of_figures_4_and_5;
            scene.beta = beta_of_figures_4_and_5;
            PaperSettings settings;
            settings.samples = 256;
            const PaperMotion numerical = paper_algorithm(scene, settings);
            Worst here;
            for (std::size_t n = 0; n < numerical.samples.size(); ++n) {
                const Motion<double> analytical = motion(f.sums, f.state, numerical.sample_times[n] - f.state.phi_j);
                for (std::size_t k = 0; k < analytical.x.size(); ++k)
                    here.take(std::abs(numerical.samples[n].x[k] - analytical.x[k]) / f.state.masses[k].amplitude, [&] {
                        return Witness{
                            {"system", f.system.name}, {"mass", std::to_string(k + 1)}, {"tau", text(numerical.sample_times[n])}};
                    });
            }
            outcome.steps.push_back({f.system.name + ": " + rounded(here.error) + ", mass " + here.place[1].second, ""});
            worst.take(here.error, [&] { return here.place; });
        }
    refute_above(outcome, worst.error, {.what = "difference over the amplitude", .taken = 0.01, .empty = 1});
    outcome.witness = with(worst.place, {{"difference over the amplitude", text(worst.error)}});
    return outcome;
}

double degrees(double radians) { return radians * 180 / pi<double>(); }

/// Distance of a phase difference from the nearest multiple of pi, in degrees.
double from_multiple_of_pi(double difference) { return degrees(std::abs(wrapped(2 * difference)) / 2); }

std::string phases_behind_contact(const FiveMasses& f) {
    std::string line = f.system.name + ", degrees behind the contact:";
    for (const MassResponse<double>& mass : f.state.masses) line += " " + rounded(degrees(wrapped(mass.phase - f.state.phi_j)));
    return line;
}

/// Masses from the contact on, away from the load: in phase or in phase-opposition.
Outcome in_phase(std::size_t j, const std::vector<double>& damping_ratios) {
    Outcome outcome;
    Worst worst;
    for (const double zeta : damping_ratios) {
        const FiveMasses f = five(j, zeta);
        outcome.steps.push_back({phases_behind_contact(f), ""});
        for (std::size_t k = j - 1; k < 5; ++k)
            worst.take(from_multiple_of_pi(f.state.masses[k].phase - f.state.phi_j), [&] {
                return Witness{{"system", f.system.name}, {"mass", std::to_string(k + 1)}};
            });
    }
    refute_above(outcome, worst.error, {.what = "degrees from a multiple of 180", .taken = 15, .empty = 90});
    outcome.witness = with(worst.place, {{"degrees from a multiple of 180", text(worst.error)}});
    return outcome;
}

/// Masses before the contact, on the load's side: the one that is nearest to the phase of the contact or its opposite.
Outcome other_phases_before_contact() {
    Outcome outcome;
    const FiveMasses f = five(3, 0.01);
    outcome.steps.push_back({phases_behind_contact(f), ""});
    double least = 180;
    for (std::size_t k = 0; k < 2; ++k) {
        const double angle = from_multiple_of_pi(f.state.masses[k].phase - f.state.phi_j);
        if (angle >= least) continue;
        least = angle;
        outcome.witness = {
            {"system", f.system.name}, {"mass", std::to_string(k + 1)}, {"degrees from a multiple of 180", text(angle)}};
    }
    refute_below(outcome, least, {.what = "degrees from a multiple of 180", .taken = 15, .empty = 0});
    return outcome;
}

/// The two masses that are nearest in phase, and the two that are nearest to phase-opposition.
Outcome all_phases_differ() {
    Outcome outcome;
    double in_phase = 180, opposed = 180;
    Witness nearest, most_opposed;
    for (const std::size_t j : {1, 3}) {
        const FiveMasses f = five(j, 0.1);
        outcome.steps.push_back({phases_behind_contact(f), ""});
        for (std::size_t a = 0; a < 5; ++a)
            for (std::size_t b = a + 1; b < 5; ++b) {
                const double angle = degrees(std::abs(wrapped(f.state.masses[a].phase - f.state.masses[b].phase)));
                const std::string pair = f.system.name + ", masses " + std::to_string(a + 1) + " and " + std::to_string(b + 1);
                if (angle < in_phase) in_phase = angle, nearest = {{"nearest in phase", pair}, {"degrees apart", text(angle)}};
                if (180 - angle < opposed)
                    opposed = 180 - angle,
                    most_opposed = {{"nearest to phase-opposition", pair}, {"degrees from it", text(180 - angle)}};
            }
    }
    refute_below(outcome, in_phase, {.what = "degrees between two phases", .taken = 15, .empty = 0});
    outcome.witness = nearest;
    outcome.witness.insert(outcome.witness.end(), most_opposed.begin(), most_opposed.end());
    return outcome;
}

const Register claims_of_time_response_observations([] {
    const std::vector<std::string> figures{"5DOF", "r = 0.9", "beta = 0.2", "mu = 1"};
    return std::vector<Claim>{
        observation("46/time-response/text", {"46"},
                    "Observation in the text: numerical and analytical time responses of Figs. 4 and 5 agree excellently; here: "
                    "to 1 percent of the amplitude, (46) as corrected",
                    figures, time_responses_agree),
        observation("53/in-phase/text", {"53"},
                    "Observation in the text: without damping and with the load on the contact all masses are in phase or in "
                    "phase-opposition; here: to 15 degrees",
                    {"zeta = 1e-6", "5DOF j=l=1"}, [] { return in_phase(1, {1e-6}); }),
        observation("53/in-phase-lightly-damped/text", {"53"},
                    "Observation in the text: the same still holds for zeta_i = 0.01, load on the contact; here: to 15 degrees",
                    figures, [] { return in_phase(1, {0.01}); }),
        observation(
            "53/in-phase-beyond-contact/text", {"53"},
            "Observation in the text: the same holds for zeta_i = 0.01 from the contact on, load before it; here: to 15 degrees",
            figures,
            [] {
                return in_phase(3, {1e-6, 0.01});
            }),
        observation(
            "53/other-phases-before-contact/text", {"53"},
            "Observation in the text: the masses before the contact, on the load's side, have other phases than the contact; "
            "here: by more than 15 degrees at zeta_i = 0.01",
            figures, other_phases_before_contact),
        observation("53/different-phases/text", {"53"},
                    "Observation in the text: for zeta_i = 0.1 each mass has another phase; here: no two are within 15 degrees",
                    figures, all_phases_differ),
    };
});

} // namespace
} // namespace denhartog::derivation
