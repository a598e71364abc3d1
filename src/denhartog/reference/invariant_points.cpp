// The frequencies at which the amplitude of a mass does not depend on friction: the zeros of (87) without damping. Read `add_zeros` first, which
// divides the range of 1/r; `TransmissibilityInBalls` is the function whose zeros are proved. V and U have a pole for each mode: those
// next to a stretch of x = 1/r are multiplied out, see `terms`, so that both are sums over modes of power series.
#include "denhartog/reference/invariant_points.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "denhartog/number/number_text.hpp"
#include "denhartog/reference/series.hpp"
#include "denhartog/search/zeros.hpp"

namespace denhartog::reference {
namespace {

constexpr std::size_t most_seen = 8192;     // modes that are remembered, over all stretches
constexpr double margin_of_range = 0x1p-40; // by which the search goes on behind the ends of the range
constexpr double narrowest = 0x1p-46;       // part of x to which a stretch is divided
constexpr double most_poles = 100'000;

// Masses that hang together: no other mass is coupled to them.
using CoupledMasses = std::vector<slong>;

// The masses of a scene, part by part. One may be left out, which couples no others then.
std::vector<CoupledMasses> coupled_masses(const SceneInBalls& s, slong held = -1) {
    std::vector<CoupledMasses> parts;
    std::vector<bool> taken(s.N(), false);
    if (held >= 0) taken[held] = true;
    for (slong first = 0; first < s.N(); ++first) {
        CoupledMasses part;
        const auto take = [&](slong k) {
            if (!taken[k]) part.push_back(k);
            taken[k] = true;
        };
        take(first);
        for (std::size_t n = 0; n < part.size(); ++n)
            for (slong k = 0; k < s.N(); ++k)
                if (!s.M(part[n], k).is_zero() || !s.K(part[n], k).is_zero()) take(k);
        if (!part.empty()) parts.push_back(std::move(part));
    }
    return parts;
}

// The masses of one part, and what acts on them, at r = 1: R is 1 over the natural frequency ratio then, and psi is phi.
SceneInBalls part_of(const SceneInBalls& s, const CoupledMasses& masses) {
    const auto n = static_cast<slong>(masses.size());
    SceneInBalls part{BallMatrix(n, n), BallMatrix(n, n)};
    part.w = part.p = BallMatrix(n, 1);
    part.r = Ball(1);
    part.effort = s.effort;
    for (slong a = 0; a < n; ++a) {
        const slong k = masses[a];
        part.w(a) = s.w(k);
        part.p(a) = s.p(k);
        for (slong b = 0; b < n; ++b) {
            part.M(a, b) = s.M(k, masses[b]);
            part.K(a, b) = s.K(k, masses[b]);
        }
    }
    return part;
}

// A term of each mode over its own factor, times all factors that are multiplied out.
template <int terms>
std::vector<SeriesOf<terms>> multiplied_out(std::vector<SeriesOf<terms>> numerators, const std::vector<SeriesOf<terms>>& factors,
                                            const std::vector<bool>& out) {
    for (std::size_t i = 0; i < numerators.size(); ++i) {
        if (!out[i]) numerators[i] = numerators[i] / factors[i];
        for (std::size_t n = 0; n < factors.size(); ++n)
            if (out[n] && n != i) numerators[i] = numerators[i] * factors[n];
    }
    return numerators;
}

// Products of the shapes of the modes at two rows.
struct WeightsInBalls {
    std::vector<Ball> sum{};  // of each mode, or of each cluster as a whole
    std::vector<Ball> open{}; // factor by which the radius of a cluster's function leaves its term open; zero of one mode

    // Whether they are zero and nothing else: the rows have no mode in common.
    [[nodiscard]] bool vanish() const {
        return std::ranges::all_of(sum, &Ball::is_zero) && std::ranges::all_of(open, &Ball::is_zero);
    }
};

// The sum over modes of weights times functions.
template <int terms>
SeriesOf<terms> sum_over_modes(const WeightsInBalls& w, const std::vector<SeriesOf<terms>>& f) {
    SeriesOf<terms> total = weighted_sum(w.sum, f, SeriesOf<terms>());
    for (std::size_t i = 0; i < f.size(); ++i)
        for (std::size_t n = 0; n < f[i].c.size() && !w.open[i].is_zero(); ++n)
            total.c[n] = widened(total.c[n], upper_bound_of(w.open[i] * radius_of(f[i].c[n])));
    return total;
}

// v and u of each mode or cluster over x. Up to a common factor, V = x^2 sum w_i v_i and U = sum w_i u_i.
template <int terms>
struct TermsOverX {
    std::vector<SeriesOf<terms>> v{}, u{}; // 1 / (r_n^2 x^2 - 1) and tan(pi r_n x / 2) / r_n, times what is multiplied out
};

// The modes or clusters whose poles are multiplied out: r_n^2 x^2 - 1 of V, cos(pi r_n x / 2) of U.
struct FactorsOverX {
    std::vector<bool> V{}, U{};
};

// A stretch of x as it was seen: less its middle, and the functions of the modes in its middle, over it, and at its ends.
struct SeenOverX {
    FactorsOverX factors{};
    Ball off{};
    TermsOverX<9> middle{}, over{};
    TermsOverX<1> at_a{}, at_b{};
};

// The modes of parts of a system, proved as those of `modes_in_balls`. A row is a mass, N for the contact, N + 1 for the load.
class UndampedModesInBalls {
public:
    UndampedModesInBalls(const SceneInBalls& s, const std::vector<CoupledMasses>& parts) : psi_(s.N() + 2) {
        const auto N = static_cast<std::size_t>(s.N());
        for (const CoupledMasses& masses : parts) {
            const SceneInBalls part = part_of(s, masses);
            const ModesInBalls m = modes_in_balls(part);
            const std::size_t before = psi_[N].size(); // modes of the parts before
            const bool loaded = arb_mat_is_zero(part.p.a) == 0, rubs = arb_mat_is_zero(part.w.a) == 0;
            const auto copy = [&](const std::vector<Ball>& row, std::vector<Ball>& all) {
                all.insert(all.end(), row.begin(), row.end());
            };
            for (std::size_t k = 0; k < masses.size(); ++k) copy(m.psi[k], psi_[masses[k]]);
            if (rubs) copy(m.at_contact(), psi_[N]);
            if (loaded) copy(m.at_load(), psi_[N + 1]);
            for (std::vector<Ball>& row : psi_) row.resize(before + m.R.size());
            for (std::size_t first = 0, last = 0; first < m.R.size(); first = last) {
                last = first + 1;
                for (const ModeCluster& c : m.clusters)
                    if (c.first == first) last = c.last;
                r_n_.push_back(1 / m.R[first]);
                loaded_.push_back(loaded);
                clusters_.push_back({before + first, before + last});
            }
        }
        nothing_ = {std::vector<bool>(r_n_.size(), false), std::vector<bool>(r_n_.size(), false)};
    }

    [[nodiscard]] const std::vector<Ball>& r_n() const { return r_n_; } // one of each mode or cluster

    [[nodiscard]] WeightsInBalls weights(std::size_t a, std::size_t b) const {
        WeightsInBalls w;
        for (const ModeCluster& c : clusters_) {
            Ball& sum = w.sum.emplace_back(0);
            for (std::size_t i = c.first; i < c.last; ++i) sum += psi_[a][i] * psi_[b][i];
            w.open.push_back(c.last > c.first + 1 ? ModesInBalls::lengths_in(c, psi_[a], psi_[b]) : Ball(0));
        }
        return w;
    }

    // The functions of the modes at x = 1/r or over a stretch of it.
    template <int count>
    [[nodiscard]] TermsOverX<count> terms(const Ball& x, const FactorsOverX& factors) const {
        using Series = SeriesOf<count>;
        const Series time = Series::time(x);
        std::vector<Series> one, sines, cosines, q;
        for (const Ball& r : r_n_) {
            const auto [sine, cosine] = sine_cosine(Series(pi<Ball>() * r / 2) * time);
            sines.push_back(Series(1 / r) * sine);
            cosines.push_back(cosine);
            q.push_back((Series(r) * time - 1) * (Series(r) * time + 1));
            one.emplace_back(1);
        }
        return {multiplied_out(std::move(one), q, factors.V), multiplied_out(std::move(sines), cosines, factors.U)};
    }
    // Their values, with nothing multiplied out.
    [[nodiscard]] TermsOverX<1> values(const Ball& x) const { return terms<1>(x, nothing_); }

    // A stretch, remembered for searches of other masses; it lasts until the next call.
    const SeenOverX& seen(double a, double b, Effort& effort) {
        const auto found = all_.find({a, b});
        if (found != all_.end()) return found->second;
        effort.spend(static_cast<long>(r_n_.size()) * 50);
        if (all_.size() * r_n_.size() > most_seen) all_.clear();
        const Ball X = Ball::within(a, b), m = middle(X);
        const auto nearly_vanishes = [](const Ball& factor) { return !(abs(middle(factor)) > 2 * radius_of(factor)); };
        FactorsOverX poles = nothing_;
        for (std::size_t i = 0; i < r_n_.size(); ++i) {
            poles.V[i] = loaded_[i] && nearly_vanishes((r_n_[i] * X - 1) * (r_n_[i] * X + 1));
            poles.U[i] = nearly_vanishes(cos(pi<Ball>() * r_n_[i] * X / 2));
        }
        return all_
            .insert_or_assign({a, b}, SeenOverX{poles, X - m, terms<9>(m, poles), terms<9>(X, poles), terms<1>(Ball(a), poles),
                                                terms<1>(Ball(b), poles)})
            .first->second;
    }

private:
    std::vector<Ball> r_n_{};
    std::vector<bool> loaded_{};
    std::vector<ModeCluster> clusters_{};  // modes by themselves too
    std::vector<std::vector<Ball>> psi_{}; // of each row all modes
    FactorsOverX nothing_{};
    std::map<std::pair<double, double>, SeenOverX> all_{};
};

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

    template <int terms>
    [[nodiscard]] SeriesOf<terms> value(const TermsOverX<terms>& t) const {
        const SeriesOf<terms> U_k = sum_over_modes(w_.U_k, t.u);
        if (kind_ == InvariantPointKind::friction_leaves_it_alone) return U_k;
        return sum_over_modes(w_.V_j, t.v) * U_k - 2 * (sum_over_modes(w_.V_k, t.v) * sum_over_modes(w_.U_j, t.u));
    }

    [[nodiscard]] ZerosInStretch look(double a, double b) const {
        if (effort_.exhausted()) return ZerosInStretch::hidden;
        effort_.spend(static_cast<long>(modes_.r_n().size()) * 10);
        const SeenOverX& s = modes_.seen(a, b, effort_);
        SeriesOf<9> f = value(s.middle);
        const Ball in_the_middle = f.c[0];
        f.c.back() = value(s.over).c.back();
        const Ball range = f.at(s.off), slope = f.derivative().at(s.off);
        if (!range.may_vanish()) return ZerosInStretch::none;
        if (!slope.may_vanish()) {
            const Ball at_a = value(s.at_a).c[0], at_b = value(s.at_b).c[0];
            if (!at_a.may_vanish() && !at_b.may_vanish())
                return (at_a > Ball(0)) == (at_b > Ball(0)) ? ZerosInStretch::none : ZerosInStretch::one;
        }
        const bool rounding_alone = in_the_middle.may_vanish() && abs(range) <= 4 * radius_of(in_the_middle);
        return rounding_alone && b - a <= b / 1024 ? ZerosInStretch::hidden : ZerosInStretch::unknown;
    }

    // Its one zero in a stretch.
    [[nodiscard]] Ball zero_in(const StretchOfZeros& s) const {
        const SeenOverX seen = [&] {
            const Bits few(bits_of_search);
            return modes_.seen(s.from, s.to, effort_);
        }();
        const bool falls = value(seen.at_a).c[0] > Ball(0);
        return place_of_zero(Ball::within(s.from, s.to), [&](const Ball& x) {
            const SeriesOf<2> f = value(modes_.terms<2>(x, seen.factors));
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
        const TermsOverX<1> t = modes_.values(x);
        const auto sum = [](const WeightsInBalls& w, const std::vector<SeriesOf<1>>& f) { return sum_over_modes(w, f).c[0]; };
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
    std::vector<std::optional<Ball>> moved(s.N());
    moved[c] = Ball(1);
    for (const CoupledMasses& part : coupled_masses(s, c)) {
        const auto n = static_cast<slong>(part.size());
        const SceneInBalls apart = part_of(s, part);
        BallMatrix by_c(n, 1), x;
        for (slong a = 0; a < n; ++a) by_c(a) = -(s.K(part[a], c) - r * r * s.M(part[a], c));
        if (arb_mat_is_zero(apart.p.a) == 0 || !solved(apart.K - apart.M * (r * r), by_c, x)) continue;
        for (slong a = 0; a < n; ++a) moved[part[static_cast<std::size_t>(a)]] = x(a);
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

using RangeOfR = std::pair<Ball, Ball>;

// 1/x over a stretch, as far as it is in the range.
void add_undecided(const Ball& from, const Ball& to, const RangeOfR& range, InvariantPointsOfMass<Ball>& found) {
    if (to < range.first || from > range.second) return;
    found.undecided.push_back({larger(range.first, from), -larger(-range.second, -to)});
}

void add_point(const SceneInBalls& s, const TransmissibilityInBalls& f, const Ball& x, InvariantPointKind kind,
               const RangeOfR& range, InvariantPointsOfMass<Ball>& found) {
    const Ball r = 1 / x;
    if (r < range.first || r > range.second) return;
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
    const double from = (1 / range.second).low() * (1 - margin_of_range), to = (1 / range.first).high() * (1 + margin_of_range);
    ZerosOnStretches zeros;
    {
        const Bits few(bits_of_search);
        const TransmissibilityInBalls f(modes, found.mass.index, s.N(), kind, effort);
        const auto has_sign = [&](double x) { return !f.value(modes.values(Ball(x))).c[0].may_vanish(); };
        find_zeros({[&](double a, double b) { return f.look(a, b); }, has_sign}, from, to, narrowest, zeros);
    }
    const TransmissibilityInBalls f(modes, found.mass.index, s.N(), kind, effort);
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
