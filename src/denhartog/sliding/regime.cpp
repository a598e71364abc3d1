// Which regime has a friction ratio: continuous below (69), permanent sticking from (88) on, stick-slip between them? A ratio
// that differs from a boundary by less than the error of that is said to be on it.
#include "denhartog/sliding/regime.hpp"

#include "denhartog/number/why.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

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
    const double sticking = b.sticking.value_or(0);
    if (point.regime == Regime::continuous) {
        point.reason = {Why::slides, beta, b.exact, error.exact, can_rest};
        if (can_rest) point.reason += {Why::can_rest, sticking, error.sticking};
        if (can_rest) point.other.push_back(Regime::permanent_sticking);
    } else {
        point.reason = {Why::no_closed_form, beta, b.exact, error.exact, static_cast<int>(b.binding)};
        if (b.sticking)
            point.reason += {can_rest ? Why::never_moves : Why::rests_only_from, sticking, error.sticking};
        else
            point.reason += Why::nothing_holds;
    }
    point.on_boundary = on_boundary(b, beta, error);
    if (point.on_boundary) point.reason += Why::near_boundary;
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
