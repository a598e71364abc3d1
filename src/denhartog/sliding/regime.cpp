#include "denhartog/sliding/regime.hpp"

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

std::string text(double x, double error = 0.0) {
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

std::string why_not_sliding(const Boundary<double>& b, double beta, const BoundaryError& error) {
    return "the closed form does not hold: beta = " + text(beta) + " is not below beta_lim = " + text(b.exact, error.exact) +
           ", Eq. (69), where " + explanation(b.binding);
}

bool equal_within(double a, double b, double error) { return a - b < error && b - a < error; }

} // namespace

bool on_boundary(const RegimeBoundary<double>& b, double beta, const BoundaryError& error) {
    return equal_within(beta, b.exact, error.exact) ||
           (b.sticking && beta >= b.exact && equal_within(beta, *b.sticking, error.sticking));
}

RegimeAtPoint regime_at(const Boundary<double>& b, double beta, const BoundaryError& error) {
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

RegimeAtPoint regime_at(const Boundary<Bounded<double>>& bounded, double beta) {
    Boundary<double> b{};
    b.exact = bounded.exact.x;
    if (bounded.sticking) b.sticking = bounded.sticking->x;
    b.binding = bounded.binding;
    return regime_at(b, beta, BoundaryError{bounded.exact.e, bounded.sticking ? bounded.sticking->e : 0.0});
}

} // namespace denhartog
