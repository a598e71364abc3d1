// Section 2.5: what the text says of the monoharmonic approximation (48), for the masses not in contact and for the one that is.
#include <algorithm>
#include <cmath>

#include "derivation/observations/scene_search.hpp"

namespace denhartog::derivation {

namespace {

/// Largest relative error of the monoharmonic amplitude of a mass not in contact; NaN where there is none or nothing slides.
double monoharmonic_error(const ModeSums<double>& sums, double mu, double beta) {
    const Boundary<double> limit = boundary(sums, mu);
    if (!(beta < limit.exact)) return std::nan("");
    const SteadyState<double> state = steady_state(sums, limit, beta);
    double worst = std::nan("");
    for (std::size_t k = 0; k < state.masses.size(); ++k)
        if (k != sums.contact.index)
            worst = std::fmax(worst, std::abs(state.masses[k].amplitude_monoharmonic / state.masses[k].amplitude - 1));
    return worst;
}

/// The error in a scene with every damping ratio halved.
double error_with_half_the_damping(const SlidingScene& s) {
    ModalBasis<double> basis = s.basis;
    for (double& zeta : basis.zeta) {
        if (zeta == 0) return std::nan("");
        zeta /= 2;
    }
    return monoharmonic_error(mode_sums(basis, s.sums.contact, s.sums.load, s.sums.r), s.mu, s.state.beta);
}

/// The part of the motion of each mass that (48) leaves out: its largest value over the half-period, over the amplitude of the mass.
std::vector<double> left_out(const SlidingScene& s) {
    constexpr int instants = 64;
    std::vector<double> largest(s.state.masses.size(), 0.0);
    for (int n = 0; n <= instants; ++n) {
        const double tau = pi<double>() * n / instants;
        const Motion<double> m = motion(s.sums, s.state, tau);
        for (std::size_t k = 0; k < largest.size(); ++k) {
            const MassResponse<double>& mass = s.state.masses[k];
            const double rest = m.x[k] - mass.x0 * std::cos(tau) - mass.v0 * std::sin(tau);
            largest[k] = std::max(largest[k], std::abs(rest) / mass.amplitude);
        }
    }
    return largest;
}

Outcome mostly_negligible() {
    Outcome outcome;
    std::vector<double> all;
    for (const SlidingScene& s : sliding_scenes()) {
        const std::vector<double> rest = left_out(s);
        for (std::size_t k = 0; k < rest.size(); ++k)
            if (k != s.sums.contact.index && std::isfinite(rest[k])) all.push_back(rest[k]);
    }
    std::ranges::sort(all);
    const double median = all[all.size() / 2];
    const auto within = std::ranges::count_if(all, [](double e) { return e < 0.01; });
    refute_above(outcome, median, {.what = "what (48) leaves out, median over scenes and masses", .taken = 0.01, .empty = 1});
    outcome.steps.push_back({"The motion (46) less (48), at 65 instants of the half-period, over the amplitude of the mass", ""});
    outcome.witness = {{"masses not in contact", std::to_string(all.size())},
                       {"of them less than 1 percent", std::to_string(within)},
                       {"median", text(median)},
                       {"largest", text(all.back())}};
    return outcome;
}

Outcome significant_for_the_contact() {
    Outcome outcome;
    Worst largest;
    for (const SlidingScene& s : sliding_scenes()) largest.take(left_out(s)[s.sums.contact.index], [&] { return place_of(s); });
    refute_below(outcome, largest.error, {.what = "largest that (48) leaves out, of the contact", .taken = 0.1, .empty = 0});
    outcome.steps.push_back(
        {"The motion (46) less (48), at 65 instants of the half-period, over the amplitude of the contact", ""});
    outcome.witness = with(largest.place, {{"what (48) leaves out over the amplitude", text(largest.error)}});
    return outcome;
}

const Register claims_of_monoharmonic_observations([] {
    const std::vector<std::string> sliding{"sliding regime"};
    return std::vector<Claim>{
        {.id = "48/very-good/text",
         .equations = {"48", "52"},
         .role = Role::observation,
         .title =
             "Observation in the text: (48) is very good for the masses not in contact; here: within 1 percent of the amplitude",
         .assumptions = sliding,
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) { return monoharmonic_error(s.sums, s.mu, s.state.beta); },
                     {.what = "relative error of the amplitude by (48)", .taken = 0.01, .empty = 1}, place_of,
                     "The monoharmonic amplitude of a mass not in contact departs from the largest displacement");
             }},
        {.id = "48/mostly-negligible/text",
         .equations = {"48"},
         .role = Role::observation,
         .title = "Observation in the text: what (48) leaves out is mostly negligible for the masses not in contact; here: less "
                  "than 1 percent of the amplitude in more than half of the cases",
         .assumptions = sliding,
         .check = mostly_negligible},
        {.id = "48/contact/text",
         .equations = {"48"},
         .role = Role::observation,
         .title = "Observation in the text: what (48) leaves out can be significant for the mass in contact; here: more than a "
                  "tenth of the amplitude somewhere",
         .assumptions = sliding,
         .check = significant_for_the_contact},
        {.id = "48/damping/text",
         .equations = {"48"},
         .role = Role::observation,
         .title = "Observation in the text: modal damping further reduces what (48) leaves out; here: twice the damping ratios, "
                  "same beta, "
                  "no larger relative error",
         .assumptions = {"sliding with both"},
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) {
                         return monoharmonic_error(s.sums, s.mu, s.state.beta) - error_with_half_the_damping(s);
                     },
                     1e-3,
                     [](const SlidingScene& s) {
                         return with(place_of(s), {{"error with half the damping ratios", text(error_with_half_the_damping(s))},
                                                   {"error", text(monoharmonic_error(s.sums, s.mu, s.state.beta))}});
                     },
                     "The monoharmonic error grows with damping");
             }},
    };
});

} // namespace
} // namespace denhartog::derivation
