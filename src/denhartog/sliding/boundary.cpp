// The friction ratios below which the contact slides throughout, and from which on it never moves. `regime_boundary_at` is
// (69) and (88) with the largest demand (57) known, `boundary_at` adds the limits by (56) and (67), and `boundary` finds
// the largest demands first, by `instants_of_maxima.cpp`, where `regime_at` stands too.
#include "denhartog/sliding/boundary.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <utility>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"

namespace denhartog {
namespace {

template <class T>
T static_demand(const ModeSums<T>& s, const T& mu) {
    return paper::static_friction_demand(s.H_j, mu, s.sum_of_squares);
}

// V_dj; zero if the load does not reach the contact beyond rounding.
template <class T>
Complex<T> response_or_zero(const ModeSums<T>& s) {
    const Complex<T>& V_dj = s.V[s.contact.index];
    return contact_is_unmoved(s) ? Complex<T>{zero_for(V_dj.re), zero_for(V_dj.im)} : V_dj;
}

// The demands of the modes, summed over the contact.
template <class T, class Demand>
T sum_of_demands(const ModeSums<T>& s, const Demand& demand) {
    boost::container::small_vector<T, 8> demands;
    for (std::size_t i = 0; i < s.R.size(); ++i) demands.push_back(demand(i));
    return paper::sum_over_contact(mode_shapes_at(s, s.contact), std::span<const T>(demands.data(), demands.size()));
}

} // namespace

template <class T>
T sliding_demand(const ModeSums<T>& s, const T& tau) {
    if (s.coupled) return coupled_demand(*s.coupled, s.contact, tau);
    return sum_of_demands(s, [&](std::size_t i) { return s_d_of_mode(s, i, tau); });
}

template <class T>
RegimeBoundary<T> regime_boundary_at(const ModeSums<T>& s, const T& mu, const T& S) {
    check_static_friction(mu);
    const Complex<T> V_dj = response_or_zero(s);
    RegimeBoundary<T> b{};
    b.exact = paper::friction_ratio_limit(V_dj, s.U[s.contact.index], larger(S, static_demand(s, mu)));
    if (s.load == s.contact)
        b.sticking = mu == 1 ? T(1) : paper::sticking_limit_under_load(mu);
    else if (!stuck_system_resonates(s))
        b.sticking = evaluation::sticking_limit_by_responses(V_dj, s.Y_jj, mu);
    return b;
}

template <class T>
Boundary<T> boundary_at(const ModeSums<T>& s, const T& mu, const T& instant, std::vector<T> instants) {
    Boundary<T> b{};
    b.S_exact = found_by_search(sliding_demand(s, instant));
    static_cast<RegimeBoundary<T>&>(b) = regime_boundary_at(s, mu, b.S_exact);
    b.S_paper =
        s.coupled ? b.S_exact : sum_of_demands(s, [&](std::size_t i) { return found_by_search(s_d_of_mode(s, i, instants[i])); });
    b.instant = instant;
    b.instants = std::move(instants);
    const T held = static_demand(s, mu), &U_dj = s.U[s.contact.index];
    const Complex<T> V_dj = response_or_zero(s);
    b.paper = paper::friction_ratio_limit(V_dj, U_dj, larger(b.S_paper, held));
    b.approximate = paper::friction_ratio_limit(V_dj, U_dj, held);
    if (instant == 0)
        b.binding = mu > 1 ? BindingCondition::static_friction : BindingCondition::both;
    else
        b.binding = b.S_exact > held ? BindingCondition::velocity : BindingCondition::static_friction;
    return b;
}

Boundary<double> boundary(const ModeSums<double>& s, double mu) {
    check_static_friction(mu);
    FrictionMotions y(s);
    const std::vector<double> instants = instants_of_demands(y);
    return boundary_at(s, mu, instants.front(), std::vector<double>(instants.begin() + 1, instants.end()));
}

template RegimeBoundary<double> regime_boundary_at(const ModeSums<double>&, const double&, const double&);
template RegimeBoundary<Bounded<double>> regime_boundary_at(const ModeSums<Bounded<double>>&, const Bounded<double>&,
                                                            const Bounded<double>&);
template double sliding_demand(const ModeSums<double>&, const double&);
template Bounded<double> sliding_demand(const ModeSums<Bounded<double>>&, const Bounded<double>&);
template Boundary<double> boundary_at(const ModeSums<double>&, const double&, const double&, std::vector<double>);
template Boundary<Bounded<double>> boundary_at(const ModeSums<Bounded<double>>&, const Bounded<double>&, const Bounded<double>&,
                                               std::vector<Bounded<double>>);

} // namespace denhartog
