#include "denhartog/sliding/regime.hpp"

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

template <class T>
std::string text(const T& x, const T& error = T(0)) {
    return number_in_certain_digits(static_cast<double>(x), static_cast<double>(error));
}

std::string explanation(BindingCondition binding) {
    switch (binding) {
    case BindingCondition::velocity: return "the contact would turn back within the half-period, (54)a";
    case BindingCondition::static_friction: return "static friction would hold the contact at the end of the half-period, (54)b";
    case BindingCondition::both: return "the contact would come to rest at the end of the half-period, (54)a and (54)b";
    }
    return {};
}

template <class T>
std::string why_not_sliding(const Boundary<T>& b, const T& beta, const BoundaryError<T>& error) {
    return "the closed form does not hold: beta = " + text(beta) + " is not below beta_lim = " + text(b.exact, error.exact) +
           ", Eq. (69), where " + explanation(b.binding);
}

template <class T>
bool equal_within(const T& a, const T& b, const T& error) {
    return a - b < error && b - a < error;
}

} // namespace

template <class T>
Regime regime_of(const RegimeBoundary<T>& b, const T& beta) {
    if (beta < b.exact) return Regime::continuous;
    return b.sticking && beta >= *b.sticking ? Regime::permanent_sticking : Regime::stick_slip;
}

template <class T>
bool on_boundary(const RegimeBoundary<T>& b, const T& beta, const BoundaryError<T>& error) {
    return equal_within(beta, b.exact, error.exact) ||
           (b.sticking && beta >= b.exact && equal_within(beta, *b.sticking, error.sticking));
}

template <class T>
RegimeAtPoint regime_at(const Boundary<T>& b, const T& beta, const BoundaryError<T>& error) {
    check_friction_ratio(beta);
    const bool can_rest = b.sticking && beta >= *b.sticking;
    RegimeAtPoint point;
    point.regime = regime_of(b, beta);
    if (point.regime == Regime::continuous) {
        point.reason.reserve(128); // at once: the everyday answer
        point.reason.append("beta = ").append(text(beta)).append(" is below beta_lim = ").append(text(b.exact, error.exact));
        point.reason.append(", Eq. (69): the contact ").append(can_rest ? "can slide" : "slides").append(" throughout");
        if (can_rest) {
            point.other.push_back(Regime::permanent_sticking);
            point.reason += "; it can also rest for ever, because beta is not below " + text(*b.sticking, error.sticking);
        }
    } else if (can_rest) {
        point.reason = why_not_sliding(b, beta, error) + "; from beta = " + text(*b.sticking, error.sticking) +
                       " on static friction outweighs all that the load brings to the contact, which never moves";
    } else {
        point.reason = why_not_sliding(b, beta, error) + "; " +
                       (b.sticking ? "only from beta = " + text(*b.sticking, error.sticking) + " on the contact never moves"
                                   : std::string("no friction can hold the contact, because the system resonates with it held"));
    }
    point.on_boundary = on_boundary(b, beta, error);
    if (point.on_boundary) point.reason += "; beta lies on a boundary to the accuracy computed";
    return point;
}

template <class T>
RegimeAtPoint regime_at(const Boundary<Bounded<T>>& bounded, const T& beta) {
    Boundary<T> b{};
    b.exact = bounded.exact.x;
    if (bounded.sticking) b.sticking = bounded.sticking->x;
    b.binding = bounded.binding;
    return regime_at(b, beta, BoundaryError<T>{bounded.exact.e, bounded.sticking ? bounded.sticking->e : T(0)});
}

template Regime regime_of(const RegimeBoundary<double>&, const double&);
template Regime regime_of(const RegimeBoundary<Bounded<double>>&, const Bounded<double>&);
template bool on_boundary(const RegimeBoundary<double>&, const double&, const BoundaryError<double>&);
template RegimeAtPoint regime_at(const Boundary<double>&, const double&, const BoundaryError<double>&);

template RegimeAtPoint regime_at(const Boundary<Bounded<double>>&, const double&);

} // namespace denhartog
