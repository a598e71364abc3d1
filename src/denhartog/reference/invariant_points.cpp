// At which frequencies does the amplitude of a mass not depend on friction? At the zeros of (87) without damping. Read
// `add_zeros` first, which divides the range of 1/r; `TransmissibilityInBalls` is the function whose zeros are proved.
#include "denhartog/reference/invariant_points.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/reference/maximum.hpp"
#include "denhartog/reference/series.hpp"
#include "denhartog/search/zeros.hpp"

namespace denhartog::reference {
namespace {

constexpr double margin_of_range = 0x1p-40; // by which the search goes on behind the ends of the range
constexpr double narrowest = 0x1p-46;       // part of x to which a stretch is divided
constexpr double most_poles = 100'000;

void check_range(const UndampedModesInBalls& modes, double r_a, double r_b) {
    if (!(r_a > 0) || !std::isfinite(r_a))
        throw InputError("the least frequency ratio", "must be positive and finite", number_to_text(r_a));
    if (!(r_b > r_a) || !std::isfinite(r_b))
        throw InputError("the largest frequency ratio", "must be above the least one, and finite", number_to_text(r_b));
    double poles = 0;
    for (const Ball& r_n : modes.r_n()) poles += static_cast<double>(r_n) / r_a / 2;
    if (poles > most_poles)
        throw InputError("the least frequency ratio",
                         "must not be so small that there are more than " + number_to_text(most_poles) + " poles above it",
                         number_to_text(r_a));
}

// The four functions of (87), up to factors that it does not notice.
template <class T>
struct ResponsesAtX {
    T V_j, V_k, U_j, U_k;
};

// The function whose zeros are the invariant points of a mass: V_j U_k - 2 V_k U_j, which is V_j U_k times (87), or U_k.
class TransmissibilityInBalls {
public:
    TransmissibilityInBalls(UndampedModesInBalls& modes, std::size_t k, std::size_t N, InvariantPointKind kind, Effort& effort)
        : modes_(modes),
          effort_(effort), w_{modes.weights(N, N + 1), modes.weights(k, N + 1), modes.weights(N, N), modes.weights(k, N)},
          kind_(kind) {}

    [[nodiscard]] PolynomialInBalls of(const TermsOverX& t) const {
        const PolynomialInBalls U_k = sum_over_modes(w_.U_k, t.u);
        if (kind_ == InvariantPointKind::friction_leaves_it_alone) return U_k;
        return sum_over_modes(w_.V_j, t.v) * U_k - Ball(2) * (sum_over_modes(w_.V_k, t.v) * sum_over_modes(w_.U_j, t.u));
    }

    [[nodiscard]] ZerosInStretch look(double a, double b) const {
        if (effort_.exhausted()) return ZerosInStretch::hidden;
        effort_.spend(static_cast<long>(modes_.r_n().size()) * 10);
        const SeenOverX& s = modes_.seen(a, b, effort_);
        PolynomialInBalls f = of(s.middle);
        const Ball in_the_middle = f.c[0];
        f.c.back() = of(s.over).c.back();
        PolynomialInBalls rate(f.terms() - 1);
        for (std::size_t n = 1; n < f.c.size(); ++n) rate.c[n - 1] = static_cast<slong>(n) * f.c[n];
        const Ball value = range_of(f, s.off), slope = range_of(rate, s.off);
        if (!value.may_vanish()) return ZerosInStretch::none;
        if (!slope.may_vanish()) {
            const Ball at_a = of(s.at_a).c[0], at_b = of(s.at_b).c[0];
            if (!at_a.may_vanish() && !at_b.may_vanish())
                return (at_a > Ball(0)) == (at_b > Ball(0)) ? ZerosInStretch::none : ZerosInStretch::one;
        }
        const bool rounding_alone = in_the_middle.may_vanish() && abs(value) <= 4 * radius_of(in_the_middle);
        return rounding_alone && b - a <= b / 1024 ? ZerosInStretch::hidden : ZerosInStretch::unknown;
    }

    [[nodiscard]] Ball at(double x) const { return of(modes_.terms(Ball(x), 1, modes_.nothing())).c[0]; }

    // Its one zero in a stretch.
    [[nodiscard]] Ball zero_in(const StretchOfZeros& s) const {
        const SeenOverX seen = [&] {
            const Bits few(bits_of_search);
            return modes_.seen(s.from, s.to, effort_);
        }();
        const bool falls = of(seen.at_a).c[0] > Ball(0);
        return place_of_zero(Ball::within(s.from, s.to), [&](const Ball& x) {
            const PolynomialInBalls f = of(modes_.terms(x, 2, seen.factors));
            return falls ? ValueAndSlope{f.c[0], f.c[1]} : ValueAndSlope{-f.c[0], -f.c[1]};
        });
    }

    // Whether the one zero in a stretch is the pole of a mode in which mass k rests. V_j and U_j have this pole, and each term is
    // multiplied by both factors: that makes it a zero, although the function is not bounded there.
    [[nodiscard]] bool is_pole(const StretchOfZeros& s, const Ball& zero) const {
        const Ball all = Ball::within(s.from, s.to);
        for (std::size_t i = 0; i < modes_.r_n().size(); ++i) {
            if (!w_.U_k.sum[i].is_zero() || w_.V_j.sum[i].is_zero() || !w_.U_j.open[i].is_zero()) continue;
            const Ball pole = 1 / modes_.r_n()[i];
            if (arb_contains(all.a, pole.a) != 0 && arb_overlaps(pole.a, zero.a) != 0) return true;
        }
        return false;
    }

    [[nodiscard]] ResponsesAtX<Ball> responses(const Ball& x) const {
        const TermsOverX t = modes_.terms(x, 1, modes_.nothing());
        const auto sum = [](const WeightsInBalls& w, const std::vector<PolynomialInBalls>& f) {
            return sum_over_modes(w, f).c[0];
        };
        return {x * x * sum(w_.V_j, t.v), x * x * sum(w_.V_k, t.v), sum(w_.U_j, t.u), sum(w_.U_k, t.u)};
    }

private:
    UndampedModesInBalls& modes_;
    Effort& effort_;
    ResponsesAtX<WeightsInBalls> w_;
    InvariantPointKind kind_;
};

// Displacements of the masses if mass c moves by 1 and no load acts; none of a mass in a part with a load, or near a resonance.
std::vector<std::optional<Ball>> moved_by(const SceneInBalls& s, slong c, const Ball& r) {
    std::vector<std::optional<Ball>> moved(static_cast<std::size_t>(s.N()));
    moved[static_cast<std::size_t>(c)] = Ball(1);
    for (const CoupledMasses& part : coupled_masses(s, c)) {
        const auto n = static_cast<slong>(part.size());
        BallMatrix D(n, n), by_c(n, 1), x(n, 1);
        const auto entry = [&](slong a, slong b) { return s.K(a, b) - r * r * s.M(a, b); };
        bool loaded = false;
        for (slong a = 0; a < n; ++a) {
            const slong k = part[static_cast<std::size_t>(a)];
            loaded = loaded || !s.p(k).is_zero();
            by_c(a) = -entry(k, c);
            for (slong b = 0; b < n; ++b) D(a, b) = entry(k, part[static_cast<std::size_t>(b)]);
        }
        if (loaded || !solved(D, by_c, x)) continue;
        for (slong a = 0; a < n; ++a) moved[static_cast<std::size_t>(part[static_cast<std::size_t>(a)])] = x(a);
    }
    return moved;
}

// Whether V_j = V_c T_j and V_k = V_c T_k with some mass c, and V_j U_k - 2 V_k U_j vanishes for V_c = 0 alone.
bool is_zero_of_common_factor(const SceneInBalls& s, std::size_t k, const ResponsesAtX<Ball>& f, const Ball& r) {
    for (slong c = 0; c < s.N(); ++c) {
        const std::vector<std::optional<Ball>> T = moved_by(s, c, r);
        Ball T_j(0);
        bool known = T[k].has_value();
        for (std::size_t n = 0; known && n < T.size(); ++n) {
            const Ball& w = s.w(static_cast<slong>(n));
            if (w.is_zero()) continue;
            known = T[n].has_value();
            if (known) T_j += w * *T[n];
        }
        if (known && !(T_j * f.U_k - 2 * *T[k] * f.U_j).may_vanish()) return true;
    }
    return false;
}

struct RangeOfR {
    Ball a, b;
};

// 1/x over a stretch, as far as it is in the range.
void add_undecided(const Ball& from, const Ball& to, const RangeOfR& range, InvariantPointsOfMass<Ball>& found) {
    if (to < range.a || from > range.b) return;
    found.undecided.push_back({larger(range.a, from), -larger(-range.b, -to)});
}

void add_point(const SceneInBalls& s, const TransmissibilityInBalls& f, const Ball& x, InvariantPointKind kind,
               const RangeOfR& range, InvariantPointsOfMass<Ball>& found) {
    const Ball r = 1 / x;
    if (r < range.a || r > range.b) return;
    const bool by_87 = kind == InvariantPointKind::two_effects_cancel;
    const ResponsesAtX<Ball> here = f.responses(x);
    // If a function has no bound the zero may be a pole of it, which the factors have made one.
    const bool bounded = here.V_k.finite() && here.U_k.finite() && (!by_87 || (here.V_j.finite() && here.U_j.finite()));
    if (bounded && by_87 && here.V_j.may_vanish() && is_zero_of_common_factor(s, found.mass.index, here, r)) return;
    if (bounded && (!by_87 || !(here.V_j.may_vanish() || here.U_k.may_vanish())))
        found.points.push_back({r, abs(here.V_k), kind});
    else
        add_undecided(r, r, range, found);
}

void sort_by_midpoint(InvariantPointsOfMass<Ball>& found) {
    const auto before = [](const Ball& x, const Ball& y) { return arf_cmp(arb_midref(x.a), arb_midref(y.a)) < 0; };
    std::ranges::sort(found.points, before, [](const auto& p) -> const Ball& { return p.r; });
    std::ranges::sort(found.undecided, before, [](const auto& u) -> const Ball& { return u.from; });
}

// The zeros of one function as points and undecided stretches.
void add_zeros(const SceneInBalls& s, UndampedModesInBalls& modes, InvariantPointKind kind, const RangeOfR& range, Effort& effort,
               InvariantPointsOfMass<Ball>& found) {
    const auto N = static_cast<std::size_t>(s.N());
    const double from = (1 / range.b).low() * (1 - margin_of_range), to = (1 / range.a).high() * (1 + margin_of_range);
    ZerosOnStretches zeros;
    {
        const Bits few(bits_of_search);
        const TransmissibilityInBalls f(modes, found.mass.index, N, kind, effort);
        const FunctionWithZeros searched{[&](double a, double b) { return f.look(a, b); },
                                         [&](double x) { return !f.at(x).may_vanish(); }};
        find_zeros(searched, from, to, narrowest, zeros);
    }
    const TransmissibilityInBalls f(modes, found.mass.index, N, kind, effort);
    for (const StretchOfZeros& each : zeros.single) {
        const Ball x = f.zero_in(each);
        if (kind == InvariantPointKind::friction_leaves_it_alone || !f.is_pole(each, x)) add_point(s, f, x, kind, range, found);
    }
    for (const StretchOfZeros& each : zeros.undecided) add_undecided(1 / Ball(each.to), 1 / Ball(each.from), range, found);
}

} // namespace

std::vector<InvariantPointsOfMass<Ball>> invariant_points_in_balls(const SceneInBalls& s, const Ball& r_a, const Ball& r_b) {
    const auto N = static_cast<std::size_t>(s.N());
    std::vector<CoupledMasses> parts = coupled_masses(s);
    std::erase_if(parts, [&](const CoupledMasses& part) { // friction does not reach them
        return std::ranges::all_of(part, [&](slong k) { return s.w(k).is_zero(); });
    });
    UndampedModesInBalls all(s, parts);
    check_range(all, r_a.low(), r_b.high());
    std::vector<InvariantPointsOfMass<Ball>> found(N);
    for (std::size_t k = 0; k < N; ++k) found[k].mass = Mass{k};
    if (all.weights(N, N + 1).vanish()) return found; // the load does not reach the contact
    SearchEffort effort(default_effort(N), s.effort);
    for (const CoupledMasses& part : parts) {
        std::unique_ptr<UndampedModesInBalls> apart; // of two parts, U_k has the modes of one
        if (parts.size() > 1) apart = std::make_unique<UndampedModesInBalls>(s, std::vector<CoupledMasses>{part});
        for (const slong mass : part) {
            const auto k = static_cast<std::size_t>(mass);
            if (!s.is_the_contact(mass) && !all.weights(k, N + 1).vanish())
                add_zeros(s, all, InvariantPointKind::two_effects_cancel, {r_a, r_b}, effort, found[k]);
            add_zeros(s, apart ? *apart : all, InvariantPointKind::friction_leaves_it_alone, {r_a, r_b}, effort, found[k]);
            sort_by_midpoint(found[k]);
        }
    }
    return found;
}

} // namespace denhartog::reference
