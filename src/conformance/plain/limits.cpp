#include "conformance/plain/closed_form.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

using std::numbers::pi;

// Largest value of a smooth function over [0, pi]: the best of equally spaced samples, refined by Brent's method to half the
// digits of the instant, which are all digits of the value.
double largest_over_half_period(const std::function<double(double)>& f, int steps) {
    const double h = pi / steps;
    const auto less = [&](double tau) { return -f(tau); };
    PlainRow samples;
    for (int n = 0; n < steps; ++n) samples.push_back(f(n * h)); // at pi it is less than at 0
    double best = *std::ranges::max_element(samples);
    const double reach = 1e-2 * std::abs(best);
    for (int n = 0; n < steps; ++n) {
        const auto at = static_cast<std::size_t>(n);
        if (samples[at] < best - reach || (n > 0 && samples[at - 1] > samples[at]) ||
            (n + 1 < steps && samples[at + 1] > samples[at]))
            continue;
        const double from = std::max(0.0, (n - 1) * h), to = (n + 1) * h;
        best = std::max(best,
                        -boost::math::tools::brent_find_minima(less, from, to, std::numeric_limits<double>::digits / 2).second);
    }
    return best;
}

// Largest value over the half-period, or at the instants tried: (57) as printed has none but those.
double largest(const PlainModes& m, const Choices& c, const std::function<double(double)>& f) {
    if (!c.instants) return largest_over_half_period(f, plain_steps(m));
    const double from = c.instants->first, to = pi - c.instants->before_end, last = static_cast<double>(c.instants->count - 1);
    double best = -1e300;
    for (double n = 0; n <= last; ++n) best = std::max(best, f(n == last ? to : from + n * (to - from) / last));
    return best;
}

// (56): the sum of the maxima of the modes.
double sum_of_maxima(const PlainModes& m, const Choices& c) {
    if (m.coupled) throw NoPlainAnswer();
    const auto of_mode = c.demand_as_printed ? printed_demand_of_mode : demand_of_mode;
    double S = 0;
    for (std::size_t i = 0; i < m.R.size(); ++i)
        S += m.psi[m.j][i] * m.psi[m.j][i] * largest(m, c, [&](double tau) { return of_mode(m, i, tau); });
    return S;
}

// The maximum of the sum over the modes.
double maximum_of_sum(const PlainModes& m, const Choices& c) {
    return largest(m, c, [&](double tau) {
        if (!c.demand_as_printed) return plain_demand_at(m, tau);
        double S = 0;
        for (std::size_t i = 0; i < m.R.size(); ++i) S += m.psi[m.j][i] * m.psi[m.j][i] * printed_demand_of_mode(m, i, tau);
        return S;
    });
}

// Whether every mode meets (63) on its own.
bool every_mode_meets_63(const PlainModes& m, double beta) {
    PlainModes other = m;
    other.beta = beta;
    const double phase = plain_phase(other, {});
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        const double psi_j = m.psi[m.j][i], psi_l = m.psi[m.l][i], R = m.R[i];
        const double eta_0 = R * R * (psi_l * times_cosine(m.v[i], phase) - psi_j * m.g[i] * beta);
        const double load = eta_0 - beta * psi_j * ((1 - R * R) * m.g[i] + 2 * m.zeta[i] * R * m.u[i]);
        if (std::abs(load) <= std::abs(psi_j) * m.mu * beta) return false;
    }
    return true;
}

// The first friction ratio up to a limit at which a mode fails (63).
double limit_mode_by_mode(const PlainModes& m, double limit) {
    constexpr int steps = 256;
    for (int n = 1; n <= steps; ++n) {
        if (every_mode_meets_63(m, limit * n / steps)) continue;
        double met = limit * (n - 1) / steps, failed = limit * n / steps;
        for (int halvings = 0; halvings < 50; ++halvings)
            (every_mode_meets_63(m, (met + failed) / 2) ? met : failed) = (met + failed) / 2;
        return failed;
    }
    return limit;
}

double demand_at_rest(const PlainModes& m) { return m.H_j + m.mu * m.sum_of_squares; }

// The chain of the masses on the load's side of the contact, and in it the load and the spring next to the contact.
struct MovingSide {
    PlainPart part;
    std::size_t load, neighbour;
    double spring;
};

MovingSide moving_side(const ProtocolQuestion& q, const PlainSystem& s) {
    const auto j = static_cast<std::size_t>(q.contact - 1), l = static_cast<std::size_t>(q.load - 1);
    if (l < j) return {part_of(q, s, 0, j), l, j - 1, q.stiffness_ratios[j]};
    return {part_of(q, s, j + 1, s.size()), l - j - 1, 0, q.stiffness_ratios[j + 1]};
}

} // namespace

double plain_sticking_limit_by_88(const ProtocolQuestion& q) {
    const PlainSystem s = plain_system(q);
    if (q.contact == q.load) return 1 / q.mu;
    const auto [part, load, neighbour, spring] = moving_side(q, s);
    const PlainShapes modes = shapes_of(part.springs, part.M);
    const PlainMatrix damping = times(transposed(modes.phi), times(part.C, modes.phi));
    Phasor X;
    for (std::size_t i = 0; i < modes.r_n.size(); ++i) {
        const double stiffness = (modes.r_n[i] - q.r) * (modes.r_n[i] + q.r), viscous = q.r * damping[i][i];
        const double over = modes.phi[neighbour][i] * modes.phi[load][i] / (stiffness * stiffness + viscous * viscous);
        X.re += over * stiffness;
        X.im -= over * viscous;
    }
    return spring * modulus(X) / q.mu;
}

double plain_sticking_limit_without_damping(const ProtocolQuestion& q) {
    const PlainSystem s = plain_system(q);
    const std::vector<Phasor> X = held_response(s);
    Phasor load{-dot(s.w, s.p), -dot(s.w, s.p_i)};
    for (std::size_t k = 0; k < s.size(); ++k) {
        const double elastic = dot(s.w, s.K[k]);
        load.re += elastic * X[k].re;
        load.im += elastic * X[k].im;
    }
    return modulus(load) / q.mu;
}

double plain_sticking_limit_by_sub_matrices(const ProtocolQuestion& q) {
    const PlainSystem s = plain_system(q);
    if (q.contact == q.load) return 1 / q.mu;
    auto [part, load, neighbour, spring] = moving_side(q, s);
    PlainRow force(part.M.size());
    force[load] = 1;
    for (std::size_t i = 0; i < force.size(); ++i)
        for (std::size_t k = 0; k < force.size(); ++k) {
            part.K[i][k] -= q.r * q.r * part.M[i][k];
            part.C[i][k] *= q.r;
        }
    return spring * modulus(solved(part.K, part.C, force, PlainRow(force.size()))[neighbour]) / q.mu;
}

double plain_demand(const PlainModes& m, const Choices& c, bool of_paper) {
    if (c.demand_at_start) return m.H_j + m.sum_of_squares;
    return of_paper || c.maximum_of_each_mode ? sum_of_maxima(m, c) : maximum_of_sum(m, c);
}

double plain_limit_by(const PlainModes& m, double S) { return modulus(m.V[m.j]) / elementary::hypot(m.U[m.j], S); }

double plain_approximate_limit(const PlainModes& m, const Choices& c) {
    const double limit = plain_limit_by(m, demand_at_rest(m));
    return c.load_of_each_mode ? limit_mode_by_mode(m, limit) : limit;
}

double plain_limit(const PlainModes& m, const Choices& c, double S) {
    const double by_S = plain_limit_by(m, S);
    if (c.without_load_condition || (c.sliding_beyond_68 && plain_limit_by(m, m.H_j - m.mu * m.sum_of_squares) < by_S))
        return by_S;
    return c.load_of_each_mode ? std::min(by_S, plain_approximate_limit(m, c))
                               : plain_limit_by(m, std::max(S, demand_at_rest(m)));
}

double plain_sticking_limit(const ProtocolQuestion& q, const PlainModes& m, const Choices& c) {
    return c.sticking ? c.sticking(q) : modulus(m.V[m.j]) / (m.mu * modulus(m.Y_jj));
}

} // namespace denhartog::conformance
