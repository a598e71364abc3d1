#include "conformance/plain/modes.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/evaluation/friction_motion.hpp"
#include "denhartog/evaluation/mode.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/errors.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

// The response of a mode to the n-th harmonic, (23) at n R.
Complex<double> response_to_harmonic(int n, double R, double zeta) { return paper::complex_response(double(n * R), zeta); }

// What (28), (29) and the braces of (40) become where friction is a square wave cut off after some harmonics.
evaluation::DampingFunctions<double> truncated_functions(int highest, double R, double zeta) {
    evaluation::DampingFunctions<double> f{0, 0};
    for (int n = 1; n <= highest; n += 2) {
        const Complex<double> y = response_to_harmonic(n, R, zeta);
        f.u -= 4 / pi<double>() * y.re;
        f.g -= 4 / pi<double>() * y.im / n;
    }
    return f;
}

PlainMotion truncated_braces(double tau, int highest, double R, double zeta) {
    PlainMotion f;
    for (int n = 1; n <= highest; n += 2) {
        const Complex<double> y = response_to_harmonic(n, R, zeta);
        f.x += 4 / pi<double>() / n * times_sine(y, double(n * tau));
        f.v += 4 / pi<double>() * times_cosine(y, double(n * tau));
    }
    return f;
}

PlainMotion printed_braces(double tau, double R, double zeta, double u, double g) {
    const double w = std::sqrt(1 - zeta * zeta), a = w * tau / R, e = elementary::exp(-zeta * tau / R);
    const double bracket = elementary::sin(a) + zeta / w * elementary::cos(a);
    const double rate = w / R * (elementary::cos(a) - zeta / w * elementary::sin(a)) - zeta / R * bracket;
    const double rate_of_sine = w / R * elementary::cos(a) - zeta / R * elementary::sin(a);
    return {as_printed::friction_motion(tau, R, zeta, u, g), -(1 + g) * e * rate - u * R / w * e * rate_of_sine};
}

PlainMotion braces(const PlainModes& m, const Choices& c, std::size_t i, double tau) {
    if (c.harmonics > 0) return truncated_braces(tau, c.harmonics, m.R[i], m.zeta[i]);
    if (c.motion_as_printed) return printed_braces(tau, m.R[i], m.zeta[i], m.u[i], m.g[i]);
    const evaluation::FrictionMotion<double> f =
        evaluation::friction_motion(tau, m.R[i], m.zeta[i], evaluation::w_if_oscillating(m.zeta[i]), m.u[i], m.g[i]);
    return {f.value, f.prime};
}

void sum_modes(PlainModes& m) {
    const std::size_t N = m.R.size();
    for (std::size_t k = 0; k < N; ++k) {
        m.V.push_back(paper::complex_response_of_mass<double>(m.psi[k], m.psi[m.l], m.R, m.v));
        m.U.push_back(paper::damping_function_of_mass<double>(m.psi[k], m.psi[m.j], m.R, m.u));
        m.G.push_back(paper::damping_function_of_mass<double>(m.psi[k], m.psi[m.j], m.R, m.g));
    }
    m.Y_jj = paper::complex_response_of_mass<double>(m.psi[m.j], m.psi[m.j], m.R, m.v);
    m.H_j = paper::H<double>(m.psi[m.j], m.R, m.zeta, m.u, m.g);
}

} // namespace

PlainModes plain_modes(const ProtocolQuestion& q, const Choices& c) {
    const System<double> system = paper_system(q);
    const std::size_t N = q.mass_ratios.size();
    const ModalBasis<double> basis = modal_basis(system);
    PlainModes m;
    m.j = system.contact.index;
    m.l = system.load.index;
    m.r = q.r;
    m.beta = q.beta;
    m.mu = q.mu;
    m.r_n = basis.r_n;
    m.zeta = basis.zeta;
    m.psi.assign(N, std::vector<double>(N));
    for (std::size_t i = 0; i < N; ++i) {
        const Eigen::VectorXd shape = basis.phi.col(static_cast<Eigen::Index>(i));
        for (std::size_t k = 0; k < N; ++k) m.psi[k][i] = shape(static_cast<Eigen::Index>(k)) / q.r;
        const double R = q.r / basis.r_n[i], zeta = m.zeta[i];
        m.R.push_back(R);
        const evaluation::DampingFunctions<double> f =
            c.harmonics > 0 ? truncated_functions(c.harmonics, R, zeta) : evaluation::damping_functions(R, zeta);
        m.u.push_back(f.u);
        m.g.push_back(f.g);
        m.v.push_back(evaluation::complex_response(R, zeta));
    }
    m.sum_of_squares = 1 / (q.mass_ratios[m.j] * (q.r * q.r));
    if (c.change_modes) c.change_modes(m);
    sum_modes(m);
    if (c.change_sums) c.change_sums(m);
    return m;
}

PlainMotion plain_start(const PlainModes& m, const Choices& c, std::size_t k) {
    const Complex<double>&V_k = m.V[k], &V_j = m.V[m.j];
    return {c.initial_displacement_as_printed ? as_printed::initial_displacement(V_k, V_j, m.U[m.j], m.G[k], m.beta)
                                              : paper::initial_displacement(V_k, V_j, m.U[m.j], m.G[k], m.beta),
            c.initial_velocity_as_printed ? as_printed::initial_velocity(V_k, V_j, m.U[m.j], m.U[k], m.beta)
                                          : paper::initial_velocity(V_k, V_j, m.U[m.j], m.U[k], m.beta)};
}

PlainMotion plain_motion(const PlainModes& m, const Choices& c, std::size_t k, double tau) {
    const double halves = std::floor(tau / pi<double>());
    const double t = tau - halves * pi<double>();
    const double sign = std::fmod(halves, 2) == 0 ? 1 : -1;
    PlainMotion friction;
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        const PlainMotion f = braces(m, c, i, t);
        const double size = m.psi[k][i] * m.psi[m.j][i] * m.R[i] * m.R[i];
        friction.x += size * f.x;
        friction.v += size * f.v;
    }
    const PlainMotion start = plain_start(m, c, k);
    const double C = start.x + m.beta * m.G[k], S = start.v + m.beta * m.U[k];
    const double x = c.motion_from_start ? paper::displacement(t, start.x, start.v, m.G[k], m.U[k], m.beta, friction.x)
                                         : paper::steady_displacement(t, m.V[k], m.V[m.j], m.U[m.j], m.beta, friction.x);
    return {sign * x, sign * (S * elementary::cos(t) - C * elementary::sin(t) + m.beta * friction.v)};
}

double plain_phase(const PlainModes& m, const Choices& c) {
    const Complex<double>& V_j = m.V[m.j];
    const double phase = paper::phase_of_contact(V_j, m.U[m.j], m.beta);
    return c.argument_in_half_plane ? phase + argument(V_j) - elementary::atan(V_j.im / V_j.re) : phase;
}

int plain_steps(const PlainModes& m) {
    const double fastest = *std::max_element(m.r_n.begin(), m.r_n.end()) / m.r;
    return static_cast<int>(std::clamp(64 + 24 * std::ceil(fastest), 128.0, 8192.0));
}

} // namespace denhartog::conformance
