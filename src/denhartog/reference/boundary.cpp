// Up to which friction ratio does the contact slide throughout, proved? Read `boundary_in_balls` first, which has (56), (67) and
// (69) as they stand; `largest_demand` proves where the sum of (57) over the modes is largest.
#include "denhartog/reference/sliding.hpp"

#include <algorithm>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/reference/maximum.hpp"

namespace denhartog::reference {
namespace {

// (54)a: the contact moves down while X_j + beta G_j is above beta (U_dj cos + F_j') / sin. The quotient is (57) before its
// maximum is taken, summed over the modes as in (56).
Series numerator(const Ball& U, const Series& F, const Ball& tau) { return Series(U) * cos(Series::time(tau)) + F.derivative(); }

// Whether n'' + n is a small difference of large terms, as next to a resonance.
bool is_hidden(const FunctionOfTime& Z, const FunctionOfTime& n, const Ball& U) {
    const Ball tau(1.5);
    const auto size = [](const Ball& x) { return upper_bound_of(abs(x)); };
    return 64 * size(Z(tau).rate(0)) < larger(size(U), size(n(tau).rate(0)));
}

Ball largest_demand(const ResponsesInBalls& r, LargestInBalls& found) {
    const Ball U = r.U[r.contact()];
    const auto n = [&](const Ball& tau) { return numerator(U, r.friction.of(r.contact(), (*r.friction.shared)(tau)), tau); };
    const auto Z = [&](const Ball& tau) { return r.friction.rate_and_third(r.contact(), (*r.friction.shared)(tau)); };
    const bool hides = !r.friction.modes.empty() && is_hidden(Z, n, U);
    found = largest_over_sine(n, hides ? FunctionOfTime(Z) : FunctionOfTime());
    return found.value;
}

// The largest value of (57) of a mode that may be damped critically: R^2 times the demand of one mass with r = R.
Ball largest_about_critical(const Ball& R, const Ball& zeta, Effort* effort) {
    LargestInBalls found;
    return R * R * largest_demand(responses_of_one_mass(R, zeta, effort), found);
}

// (56): each mode by itself.
Ball sum_of_largest(const ResponsesInBalls& r) {
    const ModesInBalls& m = r.modes;
    std::vector<Ball> largest;
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        if (!is_told_from_critical(m.zeta[i])) {
            largest.push_back(largest_about_critical(m.R[i], m.zeta[i], m.effort));
            continue;
        }
        const Ball R = m.R[i];
        const FrictionMotionOfMode mode(R, m.zeta[i]);
        Remembered<Series> F(
            [&](const Ball& tau) {
                pay(m.effort, cost_of_evaluations(1));
                return mode.at(tau);
            },
            [&](const Series& in_the_middle, const Ball& tau) { return mode.over(in_the_middle, tau); });
        const auto numerator_of_mode = [&](const Ball& tau) { return numerator(mode.u, F(tau), tau); };
        const auto Z = [&](const Ball& tau) { return mode.rate_and_third(F(tau)); };
        const bool hides = is_hidden(Z, numerator_of_mode, mode.u);
        largest.push_back(R * R * largest_over_sine(numerator_of_mode, hides ? FunctionOfTime(Z) : FunctionOfTime()).value);
    }
    return paper::sum_over_contact<Ball>(m.at_contact(), largest, m.left_open(m.at_contact(), m.at_contact(), largest));
}

} // namespace

BoundaryInBalls boundary_in_balls(const SceneInBalls& s, const ResponsesInBalls& r) {
    const std::size_t j = r.contact();
    LargestInBalls found;
    BoundaryInBalls b;
    b.S = largest_demand(r, found);
    const Ball held = paper::static_friction_demand(r.H, s.mu, r.squares);
    b.exact = paper::friction_ratio_limit(r.V[j], r.U[j], larger(b.S, held));
    // With one mode (56) is the maximum that was found; with a damping matrix see `paper_limit_of_modes`.
    const Ball S_paper = r.modes.R.size() > 1 ? sum_of_largest(r) : b.S;
    b.paper = paper::friction_ratio_limit(r.V[j], r.U[j], larger(S_paper, held));
    b.approximate = paper::friction_ratio_limit(r.V[j], r.U[j], held);
    if (found.instant.is_zero())
        b.binding = s.mu == Ball(1) ? BindingCondition::both : BindingCondition::static_friction;
    else if (b.S > held)
        b.binding = BindingCondition::velocity;
    else if (b.S < held)
        b.binding = BindingCondition::static_friction;
    return b;
}

} // namespace denhartog::reference
