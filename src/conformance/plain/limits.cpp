#include "conformance/plain/closed_form.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"

namespace denhartog::conformance {
namespace {

// Largest value of a smooth function over [0, pi]: the best of equally spaced samples, refined by Brent's method to half the
// digits of the instant, which are all digits of the value.
double largest_over_half_period(const std::function<double(double)>& f, int steps) {
    const double h = pi<double>() / steps;
    const auto less = [&](double tau) { return -f(tau); };
    std::vector<double> samples;
    for (int n = 0; n <= steps; ++n) samples.push_back(f(n == steps ? pi<double>() : n * h));
    double best = *std::max_element(samples.begin(), samples.end());
    const double reach = 1e-2 * std::abs(best);
    for (int n = 0; n <= steps; ++n) {
        const auto at = static_cast<std::size_t>(n);
        if (samples[at] < best - reach || (n > 0 && samples[at - 1] > samples[at]) ||
            (n < steps && samples[at + 1] > samples[at]))
            continue;
        const double from = std::max(0.0, (n - 1) * h), to = std::min(pi<double>(), (n + 1) * h);
        best = std::max(best,
                        -boost::math::tools::brent_find_minima(less, from, to, std::numeric_limits<double>::digits / 2).second);
    }
    return best;
}

// The largest value at some instants.
double largest_at(const Instants& at, const std::function<double(double)>& f) {
    const double from = at.first, to = pi<double>() - at.before_end;
    double best = -1e300;
    for (std::size_t n = 0; n < at.count; ++n)
        best = std::max(
            best, f(n + 1 == at.count ? to : from + static_cast<double>(n) * (to - from) / static_cast<double>(at.count - 1)));
    return best;
}

double demand_of_mode(const PlainModes& m, std::size_t i, double tau) {
    return evaluation::s_d_integrand_of(tau, m.R[i], m.zeta[i], evaluation::DampingFunctions<double>{m.u[i], m.g[i]});
}

double printed_demand_of_mode(const PlainModes& m, std::size_t i, double tau) {
    return as_printed::s_d_integrand(tau, m.R[i], m.zeta[i], m.u[i], m.g[i]);
}

// Largest value over the half-period, or at the instants tried: (57) as printed has none but those.
double largest(const PlainModes& m, const Choices& c, const std::function<double(double)>& f) {
    return c.instants ? largest_at(*c.instants, f) : largest_over_half_period(f, plain_steps(m));
}

// (56): the sum of the maxima of the modes.
double sum_of_maxima(const PlainModes& m, const Choices& c) {
    const auto of_mode = c.demand_as_printed ? printed_demand_of_mode : demand_of_mode;
    std::vector<double> s;
    for (std::size_t i = 0; i < m.R.size(); ++i) s.push_back(largest(m, c, [&](double tau) { return of_mode(m, i, tau); }));
    return paper::sum_over_contact<double>(m.psi[m.j], s);
}

// The maximum of the sum over the modes.
double maximum_of_sum(const PlainModes& m, const Choices& c) {
    const auto of_mode = c.demand_as_printed ? printed_demand_of_mode : demand_of_mode;
    return largest(m, c, [&](double tau) {
        double S = 0;
        for (std::size_t i = 0; i < m.R.size(); ++i) S += m.psi[m.j][i] * m.psi[m.j][i] * of_mode(m, i, tau);
        return S;
    });
}

// Whether every mode meets (63) on its own.
bool every_mode_meets_63(const PlainModes& m, double beta) {
    const double phase = paper::phase_of_contact(m.V[m.j], m.U[m.j], beta);
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        const double psi_j = m.psi[m.j][i], psi_l = m.psi[m.l][i], R = m.R[i];
        const double eta_0 = R * R * (psi_l * times_cosine(m.v[i], phase) - psi_j * m.g[i] * beta);
        const double load = paper::modal_contact_load_by_functions({R, m.zeta[i], psi_j, psi_l}, eta_0, m.u[i], m.g[i], beta);
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

double sticking_limit(const ProtocolQuestion& q, const PlainModes& m, const Choices& c) {
    if (c.sticking == StickingForm::exact) return paper::sticking_limit(m.V[m.j], double(m.mu * modulus(m.Y_jj)));
    System<double> system;
    system.mass_ratios = q.mass_ratios;
    system.stiffness_ratios = q.stiffness_ratios;
    system.damping_ratios = q.damping_ratios;
    system.contact = Mass{m.j};
    system.load = Mass{m.l};
    const StuckConfiguration<double> stuck = stuck_configuration(system, modal_basis(system));
    const StuckResponse response = stuck_response(stuck, system.load, q.r);
    const StickingBoundary boundary = sticking_boundary(response, stuck_chain(system, stuck), m.mu);
    return c.sticking == StickingForm::as_printed ? boundary.paper.value_or(std::nan("")) : boundary.without_damping_load;
}

} // namespace

Needed needed_for(std::string_view quantity) {
    const bool regime = quantity == "regime";
    return {regime || quantity == "S_j" || quantity == "beta_lim_exact", quantity == "beta_lim_paper",
            regime || quantity == "beta_lim_sticking"};
}

PlainLimits plain_limits(const ProtocolQuestion& q, const PlainModes& m, const Choices& c, const Needed& needed) {
    const Complex<double>& V_j = m.V[m.j];
    const double U_j = m.U[m.j];
    const double at_rest = paper::static_friction_demand(m.H_j, double(c.sign_of_mu * m.mu), m.sum_of_squares);
    const auto limit = [&](double S) { return paper::friction_ratio_limit(V_j, U_j, S); };
    PlainLimits limits;
    const bool is_paper = c.maximum_of_each_mode || c.demand_at_start;
    double S_paper = 0;
    if (c.demand_at_start)
        S_paper = m.H_j + m.sum_of_squares;
    else if (needed.paper || (needed.S && is_paper))
        S_paper = sum_of_maxima(m, c);
    limits.S_paper = S_paper;
    if (needed.S) limits.S = is_paper ? S_paper : maximum_of_sum(m, c);
    limits.approximate = limit(at_rest);
    if (c.load_of_each_mode) limits.approximate = limit_mode_by_mode(m, limits.approximate);
    const double by_68 = limit(m.H_j - m.mu * m.sum_of_squares);
    const auto ends = [&](double S) {
        if (c.sliding_beyond_68 && by_68 < limit(S)) return limit(S);
        if (c.without_load_condition) return limit(S);
        return c.load_of_each_mode ? std::min(limit(S), limits.approximate) : limit(std::max(S, at_rest));
    };
    if (needed.S) limits.exact = ends(limits.S);
    if (needed.paper) limits.paper = ends(S_paper);
    if (needed.sticking) limits.sticking = sticking_limit(q, m, c);
    return limits;
}

} // namespace denhartog::conformance
