// Modes and sums of the plain closed form: u, g and v of a mode, (28), (29) and (23), their sums over modes U, G and V, (33) to
// (35), and the motion while the contact slides, (46). A choice replaces a formula by a mistaken one. Read `plain_modes` first.
#include "conformance/plain/closed_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

using std::numbers::pi;

double sin(double x) { return elementary::sin(x); }
double cos(double x) { return elementary::cos(x); }
double exp(double x) { return elementary::exp(x); }

double square(double x) { return x * x; }

// Nearer than this to the pole of a mode without damping there is no number: rounding alone would tell it from infinity, on each
// machine in its own way.
constexpr double at_pole = 1e-13;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

// The functions of (A.8) at tau / R = t to all their digits, for any damping ratio.
struct ModeDecay {
    double lost, q; // 1 - d, and q
    double damped;  // 1 - exp(-2 zeta t) - 2 zeta q, the numerator of (29) over the half-period; only where `needs_series`
};

bool needs_series(double t, double zeta) { return t * (1 + 2 * zeta) < 0.5; }

ModeDecay free_decay(double t, double zeta) {
    if (needs_series(t, zeta)) { // by the series of d'' + 2 zeta d' + d = 0, so that no digits are lost
        ModeDecay f{0, 0, 0};
        double d = 1, d_rate = 0, q = 0, q_rate = 1, e = 1, power = 1; // k! times the coefficients k, and those of the next power
        for (int k = 1; k < 30; ++k) {
            d = std::exchange(d_rate, -2 * zeta * d_rate - d);
            q = std::exchange(q_rate, -2 * zeta * q_rate - q);
            e *= -2 * zeta;
            power *= t / k;
            f.lost -= d * power;
            f.q += q * power;
            f.damped -= (e + 2 * zeta * q) * power;
        }
        return f;
    }
    const double s = (1 - zeta) * (1 + zeta), w = std::max(std::sqrt(std::abs(s)), 1e-100), e = exp(-zeta * t);
    double c = e * cos(w * t), q = e * sin(w * t) / w;
    if (s < 0) {
        const double slow = exp(-t / (zeta + w)), fast = exp(-t * (zeta + w));
        c = (slow + fast) / 2;
        q = slow * -elementary::expm1(-2 * w * t) / (2 * w);
    }
    return {1 - c - zeta * q, q, 0};
}

// u of (28) and g of (29), both over the larger exponential.
std::pair<double, double> damping_functions(double R, double zeta) {
    const double t = pi / R, s = (1 - zeta) * (1 + zeta), e = exp(-zeta * t);
    const ModeDecay f = free_decay(t, zeta);
    const double c = 1 - f.lost - zeta * f.q;
    // 1 + e^2 + 2 c, which is small next to a resonance
    const double both =
        s > 0 ? square(elementary::expm1(-zeta * t)) + 4 * e * square(cos(std::sqrt(s) * t / 2)) : 1 + e * e + 2 * c;
    if (zeta == 0 && both < square(2 * at_pole)) return {none, none};
    const double damped = needs_series(t, zeta) ? f.damped : -elementary::expm1(-2 * zeta * t) - 2 * zeta * f.q;
    return {2 * f.q / (R * both), damped / both};
}

// The braces of (40) for friction as a square wave that is cut off after some harmonics; (28) and (29) are their start.
PlainMotion truncated_braces(double tau, int highest, double R, double zeta) {
    PlainMotion f;
    for (int n = 1; n <= highest; n += 2) {
        const Phasor y = response_of_mode(R, zeta, n);
        f.x += 4 / pi / n * (y.real() * sin(n * tau) + y.imag() * cos(n * tau));
        f.v += 4 / pi * times_cosine(y, n * tau);
    }
    return f;
}

PlainMotion printed_braces(double tau, double R, double zeta, double u, double g) {
    const double w = std::sqrt(1 - zeta * zeta), a = w * tau / R, e = exp(-zeta * tau / R);
    const double bracket = sin(a) + zeta / w * cos(a);
    const double rate = w / R * (cos(a) - zeta / w * sin(a)) - zeta / R * bracket;
    const double rate_of_sine = w / R * cos(a) - zeta / R * sin(a);
    return {1 - (1 + g) * e * bracket - u * R / w * e * sin(a), -(1 + g) * e * rate - u * R / w * e * rate_of_sine};
}

// (57).
double printed_demand(double R, double zeta, double u, double g, double tau) {
    const double w = std::sqrt(1 - zeta * zeta), a = w * tau / R, e = exp(-zeta * tau / R);
    return ((1 + g) * e * R / w * sin(a) - u * R * R * e * (sin(a) + zeta / w * cos(a))) / sin(tau);
}

PlainMotion braces(const PlainModes& m, const Choices& c, Index i, double tau) {
    const double R = m.R[i], zeta = m.zeta[i], u = m.u[i], g = m.g[i];
    if (c.harmonics > 0) return truncated_braces(tau, c.harmonics, R, zeta);
    if (c.motion_as_printed) return printed_braces(tau, R, zeta, u, g);
    const ModeDecay f = free_decay(tau / R, zeta);
    return {f.lost - g * (1 - f.lost) - u * R * f.q, (1 + g) * f.q / R - u * (1 - f.lost - 2 * zeta * f.q)};
}

// The friction motion F of a row in (46), without beta.
PlainMotion friction_motion(const PlainModes& m, const Choices& c, Index k, double tau) {
    if (m.friction) return m.friction->at(m.psi.row(k), tau);
    PlainMotion friction;
    for (Index i = 0; i < m.R.size(); ++i) {
        const PlainMotion f = braces(m, c, i, tau);
        const double size = m.psi(k, i) * m.psi(m.j, i) * m.R[i] * m.R[i];
        friction.x += size * f.x;
        friction.v += size * f.v;
    }
    return friction;
}

// Factors of cos(tau) and sin(tau) in (46), which are by (49) those that (41) has from the start of the motion.
PlainMotion harmonic_part(const PlainModes& m, const Choices& c, Index k) {
    const auto [cosine, sine, root, drag] = turn_of(m, k);
    return {root * cosine + (c.initial_displacement_as_printed ? 0 : drag * sine),
            drag * cosine - (c.initial_velocity_as_printed ? 0 : root * sine)};
}

// Sums of amplitudes with real factors.
Phasors times(const PlainMatrix& A, const Phasors& x) {
    Phasors y(A.rows());
    y.real() = A * x.real();
    y.imag() = A * x.imag();
    return y;
}

void sum_modes(PlainModes& m) {
    const PlainVector squares = m.R.cwiseAbs2();
    const PlainVector of_contact = m.psi.row(m.j).transpose().cwiseProduct(squares);
    const auto response = [&](Index l) -> Phasors {
        const PlainMatrix of_load = m.psi * m.psi.row(l).transpose().cwiseProduct(squares).asDiagonal();
        return times(of_load, m.v);
    };
    m.V = response(m.l);
    if (m.l_i != m.l) {
        const Phasors ahead = response(m.l_i);
        m.V.real() -= ahead.imag();
        m.V.imag() += ahead.real();
    }
    m.U = m.psi * of_contact.cwiseProduct(m.u);
    m.G = m.psi * of_contact.cwiseProduct(m.g);
    m.Y_jj = response(m.j)[m.j];
    m.H_j = m.psi.row(m.j).cwiseAbs2().dot(m.g + 2 * m.zeta.cwiseProduct(m.R).cwiseProduct(m.u));
}

// The sums for damping that couples the modes: rows are then those of the masses, without modes.
void sum_without_modes(PlainModes& m) {
    m.friction = std::make_shared<FrictionResponse>(m);
    const Phasors X = plain_response(m, m.p, m.p_i), Y = plain_response(m, m.w, PlainVector::Zero(m.size()));
    m.V = times(m.psi, X);
    m.U = m.G = PlainVector(m.psi.rows());
    for (Index k = 0; k < m.psi.rows(); ++k) {
        const PlainMotion start = m.friction->at(m.psi.row(k), 0);
        m.U[k] = -start.v;
        m.G[k] = -start.x;
    }
    m.Y_jj = times(m.w.transpose(), Y)[0];
    m.H_j = m.friction->acceleration_at_start(m.w) - m.sum_of_squares;
}

// The row of weights of some masses, a mass's own or a new one behind them.
Index row_of(PlainMatrix& rows, const PlainVector& weights) {
    Index k = 0;
    while (k < rows.rows() && rows.row(k) != weights.transpose()) ++k;
    if (k == rows.rows()) {
        rows.conservativeResize(k + 1, Eigen::NoChange);
        rows.row(k) = weights;
    }
    return k;
}

} // namespace

PlainModes plain_modes(const ProtocolQuestion& q, const Choices& c) {
    PlainModes m;
    static_cast<PlainSystem&>(m) = plain_system(q);
    const Index N = m.size();
    m.psi = PlainMatrix::Identity(N, N);
    m.j = row_of(m.psi, m.w);
    m.l = m.l_i = row_of(m.psi, m.p);
    if (!m.p_i.isZero(0)) m.l_i = row_of(m.psi, m.p_i);
    m.sum_of_squares = m.w.dot(solved(m.M, m.w)) / (m.r * m.r);
    m.R = m.r / m.r_n.array();
    if (m.coupled) {
        sum_without_modes(m);
        return m;
    }
    m.psi = m.psi * m.phi / m.r;
    m.u = m.g = PlainVector(N);
    m.v = Phasors(N);
    for (Index i = 0; i < N; ++i) {
        std::tie(m.u[i], m.g[i]) = damping_functions(m.R[i], m.zeta[i]);
        if (c.harmonics > 0) {
            const PlainMotion start = truncated_braces(0, c.harmonics, m.R[i], m.zeta[i]);
            std::tie(m.u[i], m.g[i]) = std::pair(-start.v, -start.x);
        }
        m.v[i] = response_of_mode(m.R[i], m.zeta[i]);
    }
    if (c.change_modes) c.change_modes(m);
    sum_modes(m);
    if (c.change_sums) c.change_sums(m);
    return m;
}

Phasor response_of_mode(double R, double zeta, int n) {
    const double stiffness = (1 - n * R) * (1 + n * R), damping = 2 * zeta * n * R;
    if (zeta == 0 && std::abs(stiffness) < at_pole) return {none, none};
    const double size = stiffness * stiffness + damping * damping;
    return {stiffness / size, -damping / size};
}

double demand_of_mode(const PlainModes& m, Index i, double tau, bool as_printed) {
    if (as_printed) return printed_demand(m.R[i], m.zeta[i], m.u[i], m.g[i], tau);
    if (tau == 0 || tau == pi) return m.g[i] + 2 * m.zeta[i] * m.R[i] * m.u[i] + (tau == 0 ? 1 : -1);
    const ModeDecay f = free_decay(tau / m.R[i], m.zeta[i]);
    const double gained = 2 * square(sin(tau / 2)) - f.lost - 2 * m.zeta[i] * f.q; // R q' - cos(tau)
    return m.R[i] * ((1 + m.g[i]) * f.q - m.u[i] * m.R[i] * gained) / sin(tau);
}

double plain_demand_at(const PlainModes& m, double tau, bool as_printed) {
    if (m.coupled && tau == 0) return m.H_j + m.sum_of_squares;
    if (m.coupled) return (m.friction->rate_gained(m.psi.row(m.j), tau) - 2 * m.U[m.j] * square(sin(tau / 2))) / sin(tau);
    double S = 0;
    for (Index i = 0; i < m.R.size(); ++i) S += square(m.psi(m.j, i)) * demand_of_mode(m, i, tau, as_printed);
    return S;
}

PlainTurn turn_of(const PlainModes& m, Index k) {
    const Phasor &a = m.V[k], &b = m.V[m.j];
    const double size = std::norm(b), drag = m.beta * m.U[m.j];
    return {(a.real() * b.real() + a.imag() * b.imag()) / size, (a.imag() * b.real() - a.real() * b.imag()) / size,
            std::sqrt(size - square(drag)), drag};
}

PlainMotion plain_start(const PlainModes& m, const Choices& c, Index k) {
    const auto [C, S] = harmonic_part(m, c, k);
    return {C - m.beta * m.G[k], S - m.beta * m.U[k]};
}

PlainMotion plain_motion(const PlainModes& m, const Choices& c, Index k, double tau) {
    const double halves = std::floor(tau / pi), t = tau - halves * pi, sign = std::fmod(halves, 2) == 0 ? 1 : -1;
    const PlainMotion friction = friction_motion(m, c, k, t);
    const auto [C, S] = harmonic_part(m, c, k);
    return {sign * (C * cos(t) + S * sin(t) + m.beta * friction.x), sign * (S * cos(t) - C * sin(t) + m.beta * friction.v)};
}

double plain_phase(const PlainModes& m, const Choices& c) {
    const Phasor& V_j = m.V[m.j];
    const double s = m.beta * m.U[m.j] / modulus(V_j);
    return elementary::atan2(-s, std::sqrt(1 - s * s)) -
           (c.argument_in_half_plane ? elementary::atan(V_j.imag() / V_j.real()) : argument(V_j));
}

int plain_steps(const PlainModes& m) {
    const double fastest = m.r_n.maxCoeff() / m.r;
    return static_cast<int>(std::clamp(64 + 24 * std::ceil(fastest), 128.0, 8192.0));
}

} // namespace denhartog::conformance
