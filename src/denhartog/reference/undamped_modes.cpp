// The terms of (87) as polynomials in x = 1/r: without damping each mode has a pole, and all poles next to a stretch are
// multiplied out, so that a function stays finite there. Read `terms` first.
#include "denhartog/reference/invariant_points.hpp"

#include <algorithm>

namespace denhartog::reference {
namespace {

constexpr slong taylor_order = 8;       // of the Taylor polynomials
constexpr std::size_t most_seen = 8192; // modes that are remembered, over all stretches

// The masses of one part, and what acts on them, at r = 1: R is 1 over the natural frequency ratio then, and psi is phi.
SceneInBalls part_of(const SceneInBalls& s, const CoupledMasses& masses) {
    const auto n = static_cast<slong>(masses.size());
    SceneInBalls part{BallMatrix(n, n), BallMatrix(n, n)};
    part.w = part.p = BallMatrix(n, 1);
    part.r = Ball(1);
    part.effort = s.effort;
    for (slong a = 0; a < n; ++a) {
        const slong k = masses[static_cast<std::size_t>(a)];
        part.w(a) = s.w(k);
        part.p(a) = s.p(k);
        for (slong b = 0; b < n; ++b) {
            part.M(a, b) = s.M(k, masses[static_cast<std::size_t>(b)]);
            part.K(a, b) = s.K(k, masses[static_cast<std::size_t>(b)]);
        }
    }
    return part;
}

bool acts_on_none(const BallMatrix& column) {
    for (slong k = 0; k < column.rows(); ++k)
        if (!column(k).is_zero()) return false;
    return true;
}

// Whether a factor may vanish over a stretch, or nearly so beside what it is in the middle.
bool nearly_vanishes(const Ball& factor) { return !(abs(middle(factor)) > 2 * radius_of(factor)); }

// A term of each mode over its own factor, times all factors that are multiplied out.
std::vector<PolynomialInBalls> multiplied_out(std::vector<PolynomialInBalls> numerators,
                                              const std::vector<PolynomialInBalls>& factors, const std::vector<bool>& out) {
    for (std::size_t i = 0; i < numerators.size(); ++i) {
        if (!out[i]) numerators[i] = numerators[i] / factors[i];
        for (std::size_t n = 0; n < factors.size(); ++n)
            if (out[n] && n != i) numerators[i] = numerators[i] * factors[n];
    }
    return numerators;
}

} // namespace

std::vector<CoupledMasses> coupled_masses(const SceneInBalls& s, slong held) {
    std::vector<CoupledMasses> parts;
    std::vector<bool> taken(static_cast<std::size_t>(s.N()), false);
    if (held >= 0) taken[static_cast<std::size_t>(held)] = true;
    for (slong first = 0; first < s.N(); ++first) {
        CoupledMasses part;
        const auto take = [&](slong k) {
            if (taken[static_cast<std::size_t>(k)]) return;
            taken[static_cast<std::size_t>(k)] = true;
            part.push_back(k);
        };
        take(first);
        for (std::size_t n = 0; n < part.size(); ++n)
            for (slong k = 0; k < s.N(); ++k)
                if (!s.M(part[n], k).is_zero() || !s.K(part[n], k).is_zero()) take(k);
        if (!part.empty()) parts.push_back(std::move(part));
    }
    return parts;
}

bool WeightsInBalls::vanish() const {
    const auto zero = [](const Ball& x) { return x.is_zero(); };
    return std::ranges::all_of(sum, zero) && std::ranges::all_of(open, zero);
}

PolynomialInBalls sum_over_modes(const WeightsInBalls& w, const std::vector<PolynomialInBalls>& f) {
    PolynomialInBalls total(f.empty() ? 1 : f.front().terms());
    for (std::size_t i = 0; i < f.size(); ++i) {
        for (std::size_t n = 0; n < f[i].c.size() && !w.sum[i].is_zero(); ++n)
            arb_addmul(total.c[n].a, w.sum[i].a, f[i].c[n].a, ball_bits);
        for (std::size_t n = 0; n < f[i].c.size() && !w.open[i].is_zero(); ++n)
            total.c[n] = widened(total.c[n], upper_bound_of(w.open[i] * radius_of(f[i].c[n])));
    }
    return total;
}

UndampedModesInBalls::UndampedModesInBalls(const SceneInBalls& s, const std::vector<CoupledMasses>& parts)
    : psi_(static_cast<std::size_t>(s.N()) + 2) {
    const auto N = static_cast<std::size_t>(s.N());
    for (const CoupledMasses& masses : parts) {
        const SceneInBalls part = part_of(s, masses);
        const ModesInBalls m = modes_in_balls(part);
        const std::size_t before = psi_[N].size();
        for (std::vector<Ball>& row : psi_) row.resize(before + m.R.size());
        for (std::size_t row = 0; row < m.psi.size(); ++row) {
            const std::size_t row_of_all = row < masses.size() ? static_cast<std::size_t>(masses[row]) : N + row - masses.size();
            if (row < masses.size() || !acts_on_none(row == masses.size() ? part.w : part.p))
                std::ranges::copy(m.psi[row], psi_[row_of_all].begin() + static_cast<std::ptrdiff_t>(before));
        }
        for (std::size_t first = 0, last = 0; first < m.R.size(); first = last) {
            last = first + 1;
            for (const ModeCluster& c : m.clusters)
                if (c.first == first) last = c.last;
            r_n_.push_back(1 / m.R[first]);
            loaded_.push_back(!acts_on_none(part.p));
            clusters_.push_back({before + first, before + last});
        }
    }
}

WeightsInBalls UndampedModesInBalls::weights(std::size_t a, std::size_t b) const {
    WeightsInBalls w;
    for (const ModeCluster& c : clusters_) {
        Ball& sum = w.sum.emplace_back(0);
        for (std::size_t i = c.first; i < c.last; ++i) sum += psi_[a][i] * psi_[b][i];
        w.open.push_back(c.last > c.first + 1 ? ModesInBalls::lengths_in(c, psi_[a], psi_[b]) : Ball(0));
    }
    return w;
}

TermsOverX UndampedModesInBalls::terms(const Ball& x, slong terms, const FactorsOverX& factors) const {
    std::vector<PolynomialInBalls> one, sines, cosines, q;
    for (const Ball& r : r_n_) {
        const Ball rate = pi<Ball>() * r / 2;
        auto [s, c] = sine_and_cosine(PolynomialInBalls(terms, rate * x, rate));
        sines.push_back((1 / r) * std::move(s));
        cosines.push_back(std::move(c));
        q.push_back(PolynomialInBalls(terms, r * x - 1, r) * PolynomialInBalls(terms, r * x + 1, r));
        one.emplace_back(terms, Ball(1), Ball(0));
    }
    return {multiplied_out(std::move(one), q, factors.of_V), multiplied_out(std::move(sines), cosines, factors.of_U)};
}

FactorsOverX UndampedModesInBalls::nothing() const {
    return {std::vector<bool>(r_n_.size(), false), std::vector<bool>(r_n_.size(), false)};
}

FactorsOverX UndampedModesInBalls::poles_in(const Ball& x) const {
    FactorsOverX poles = nothing();
    for (std::size_t i = 0; i < r_n_.size(); ++i) {
        poles.of_V[i] = loaded_[i] && nearly_vanishes((r_n_[i] * x - 1) * (r_n_[i] * x + 1));
        poles.of_U[i] = nearly_vanishes(cos(pi<Ball>() * r_n_[i] * x / 2));
    }
    return poles;
}

const SeenOverX& UndampedModesInBalls::seen(double a, double b, Effort& effort) {
    const auto found = all_.find({a, b});
    if (found != all_.end()) return found->second;
    effort.spend(static_cast<long>(r_n_.size()) * 50);
    if (all_.size() * r_n_.size() > most_seen) all_.clear();
    const Ball X = Ball::within(a, b), m = middle(X);
    const FactorsOverX factors = poles_in(X);
    return all_
        .insert_or_assign({a, b},
                          SeenOverX{factors, X - m, terms(m, taylor_order + 1, factors), terms(X, taylor_order + 1, factors),
                                    terms(Ball(a), 1, factors), terms(Ball(b), 1, factors)})
        .first->second;
}

} // namespace denhartog::reference
