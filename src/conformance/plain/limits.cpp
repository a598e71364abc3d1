#include "conformance/plain/closed_form.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "denhartog/answer/held_solution.hpp"
#include "denhartog/evaluation/demand.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "elementary/elementary.hpp"

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

double demand_at_rest(const PlainModes& m) { return paper::static_friction_demand(m.H_j, m.mu, m.sum_of_squares); }

} // namespace

double plain_sticking_limit_by_88(const ProtocolQuestion& q) {
    Scene<double> scene;
    scene.system = paper_system(q);
    scene.mu = q.mu;
    scene.r = q.r;
    const std::optional<Certified> by_88 = sticking_by_88(scene);
    return by_88 ? by_88->value : std::nan("");
}

double plain_sticking_limit_without_damping(const ProtocolQuestion& q) {
    const System<double> system = paper_system(q);
    const StuckConfiguration stuck = stuck_configuration(system, modal_basis(system));
    return paper::sticking_limit(stuck_response(stuck, system.load, q.r).elastic_load, q.mu);
}

double plain_sticking_limit_by_sub_matrices(const ProtocolQuestion& q) {
    const PlainModes m = plain_modes(q, {});
    if (m.j == m.l) return 1 / q.mu;
    const bool before = m.l < m.j; // the masses that the load moves
    const std::size_t first = before ? 0 : m.j + 1, n = before ? m.j : q.mass_ratios.size() - first;
    const auto size = static_cast<Eigen::Index>(n);
    Matrix<double> A = Matrix<double>::Zero(2 * size, 2 * size); // of real and imaginary parts
    const auto add = [&](std::size_t a, std::size_t b, double elastic, double viscous) {
        const auto i = static_cast<Eigen::Index>(a), k = static_cast<Eigen::Index>(b);
        A(i, k) += elastic;
        A(i + size, k + size) += elastic;
        A(i, k + size) -= viscous;
        A(i + size, k) += viscous;
    };
    for (std::size_t a = 0; a < n; ++a) {
        const std::size_t mass = first + a, next = mass + 1;
        add(a, a, q.stiffness_ratios[mass] - q.mass_ratios[mass] * (q.r * q.r), 0);
        if (next < q.mass_ratios.size()) add(a, a, q.stiffness_ratios[next], 0);
        if (a + 1 < n) {
            add(a, a + 1, -q.stiffness_ratios[next], 0);
            add(a + 1, a, -q.stiffness_ratios[next], 0);
        }
        for (std::size_t b = 0; b < n; ++b) { // r C = r^3 M psi diag(2 zeta_i r_ni) psi^T M, with psi of (17)
            double sum = 0;
            for (std::size_t i = 0; i < m.R.size(); ++i) sum += m.psi[mass][i] * m.psi[first + b][i] * 2 * m.zeta[i] * m.r_n[i];
            add(a, b, 0, q.r * (q.r * q.r) * q.mass_ratios[mass] * q.mass_ratios[first + b] * sum);
        }
    }
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * size);
    load(static_cast<Eigen::Index>(m.l - first)) = 1;
    const Eigen::VectorXd X = Eigen::PartialPivLU<Matrix<double>>(A).solve(load);
    const Eigen::Index neighbour = before ? size - 1 : 0;
    const double spring = q.stiffness_ratios[before ? m.j : m.j + 1];
    return spring * elementary::hypot(X(neighbour), X(neighbour + size)) / q.mu;
}

double plain_demand(const PlainModes& m, const Choices& c, bool of_paper) {
    if (c.demand_at_start) return m.H_j + m.sum_of_squares;
    return of_paper || c.maximum_of_each_mode ? sum_of_maxima(m, c) : maximum_of_sum(m, c);
}

double plain_limit_by(const PlainModes& m, double S) { return paper::friction_ratio_limit(m.V[m.j], m.U[m.j], S); }

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
    return c.sticking ? c.sticking(q) : paper::sticking_limit(m.V[m.j], double(m.mu * modulus(m.Y_jj)));
}

} // namespace denhartog::conformance
