// Modes and sums of the plain closed form: u, g and v of a mode, (28), (29) and (23), their sums over modes U, G and V, (33) to
// (35), and the motion while the contact slides, (46). A choice replaces a formula by a mistaken one. Read `plain_modes` first.
#include "conformance/plain/closed_form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

using std::numbers::pi;

double sin(double x) { return elementary::sin(x); }
double cos(double x) { return elementary::cos(x); }
double exp(double x) { return elementary::exp(x); }

double square(double x) { return x * x; }

// 1 - d and q of (A.8) with tau / R = t, for any damping ratio.
struct ModeDecay {
    double lost, q;
};

ModeDecay free_decay(double t, double zeta) {
    if (t * (1 + 2 * zeta) < 0.5) { // by the series of d'' + 2 zeta d' + d = 0, so that no digits are lost
        ModeDecay f{0, 0};
        double d = 1, d_rate = 0, q = 0, q_rate = 1, power = 1; // k! times the coefficients k, and those of the next power
        for (int k = 1; k < 30; ++k) {
            const double d_next = -2 * zeta * d_rate - d, q_next = -2 * zeta * q_rate - q;
            d = d_rate;
            q = q_rate;
            d_rate = d_next;
            q_rate = q_next;
            power *= t / k;
            f.lost -= d * power;
            f.q += q * power;
        }
        return f;
    }
    const double s = (1 - zeta) * (1 + zeta), w = std::sqrt(std::abs(s)), e = exp(-zeta * t);
    double c = 0, q = 0;
    if (std::abs(s) * t * t < 1e-2) {
        const double y = s * t * t;
        c = e * (1 - y / 2 * (1 - y / 12 * (1 - y / 30 * (1 - y / 56 * (1 - y / 90)))));
        q = e * t * (1 - y / 6 * (1 - y / 20 * (1 - y / 42 * (1 - y / 72 * (1 - y / 110)))));
    } else if (s > 0) {
        c = e * cos(w * t);
        q = e * sin(w * t) / w;
    } else {
        const double slow = exp(-t / (zeta + w)), fast = exp(-t * (zeta + w));
        c = (slow + fast) / 2;
        q = (slow - fast) / (2 * w);
    }
    return {1 - c - zeta * q, q};
}

struct DampingFunctionsOfMode {
    double u, g;
};

// (28) and (29), both over the larger exponential.
DampingFunctionsOfMode damping_functions(double R, double zeta) {
    const double t = pi / R, s = (1 - zeta) * (1 + zeta), e = exp(-zeta * t);
    const ModeDecay f = free_decay(t, zeta);
    const double c = 1 - f.lost - zeta * f.q;
    // 1 + e^2 + 2 c, which is small next to a resonance
    const double both =
        s > 0 ? square(elementary::expm1(-zeta * t)) + 4 * e * square(cos(std::sqrt(s) * t / 2)) : 1 + e * e + 2 * c;
    double difference = -elementary::expm1(-2 * zeta * t) - 2 * zeta * f.q;
    if (t * (1 + 2 * zeta) < 1) { // sinh(zeta t) - zeta / w sin(w t), by its series
        double power = zeta * t, of_sinh = 1, of_sine = 1, sum = 0;
        for (int k = 1; k < 12; ++k) {
            power /= (2 * k) * (2 * k + 1);
            of_sinh *= square(zeta * t);
            of_sine *= -s * t * t;
            sum += power * (of_sinh - of_sine);
        }
        difference = 2 * e * sum;
    }
    return {2 * f.q / (R * both), difference / both};
}

// (28), (29) and the braces of (40) for friction as a square wave that is cut off after some harmonics.
DampingFunctionsOfMode truncated_functions(int highest, double R, double zeta) {
    DampingFunctionsOfMode f{0, 0};
    for (int n = 1; n <= highest; n += 2) {
        const Phasor y = response_of_mode(R, zeta, n);
        f.u -= 4 / pi * y.re;
        f.g -= 4 / pi * y.im / n;
    }
    return f;
}

PlainMotion truncated_braces(double tau, int highest, double R, double zeta) {
    PlainMotion f;
    for (int n = 1; n <= highest; n += 2) {
        const Phasor y = response_of_mode(R, zeta, n);
        f.x += 4 / pi / n * (y.re * sin(n * tau) + y.im * cos(n * tau));
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

PlainMotion braces(const PlainModes& m, const Choices& c, std::size_t i, double tau) {
    const double R = m.R[i], zeta = m.zeta[i], u = m.u[i], g = m.g[i];
    if (c.harmonics > 0) return truncated_braces(tau, c.harmonics, R, zeta);
    if (c.motion_as_printed) return printed_braces(tau, R, zeta, u, g);
    const ModeDecay f = free_decay(tau / R, zeta);
    return {f.lost - g * (1 - f.lost) - u * R * f.q, (1 + g) * f.q / R - u * (1 - f.lost - 2 * zeta * f.q)};
}

// The friction motion F of a row in (46), without beta.
PlainMotion friction_motion(const PlainModes& m, const Choices& c, std::size_t k, double tau) {
    if (m.friction) return m.friction->at(m.psi[k], tau);
    PlainMotion friction;
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        const PlainMotion f = braces(m, c, i, tau);
        const double size = m.psi[k][i] * m.psi[m.j][i] * m.R[i] * m.R[i];
        friction.x += size * f.x;
        friction.v += size * f.v;
    }
    return friction;
}

void sum_modes(PlainModes& m) {
    const auto sum = [&](std::size_t a, std::size_t b, const auto& of_mode) {
        double S = 0;
        for (std::size_t i = 0; i < m.R.size(); ++i) S += m.psi[a][i] * m.psi[b][i] * m.R[i] * m.R[i] * of_mode(i);
        return S;
    };
    const auto response = [&](std::size_t a, std::size_t b) {
        return Phasor{sum(a, b, [&](std::size_t i) { return m.v[i].re; }), sum(a, b, [&](std::size_t i) { return m.v[i].im; })};
    };
    for (std::size_t k = 0; k < m.psi.size(); ++k) {
        m.V.push_back(response(k, m.l));
        if (m.l_i != m.l) {
            const Phasor ahead = response(k, m.l_i);
            m.V.back() = {m.V.back().re - ahead.im, m.V.back().im + ahead.re};
        }
        m.U.push_back(sum(k, m.j, [&](std::size_t i) { return m.u[i]; }));
        m.G.push_back(sum(k, m.j, [&](std::size_t i) { return m.g[i]; }));
    }
    m.Y_jj = response(m.j, m.j);
    m.H_j = sum(m.j, m.j, [&](std::size_t i) { return (m.g[i] + 2 * m.zeta[i] * m.R[i] * m.u[i]) / (m.R[i] * m.R[i]); });
}

// The sums for damping that couples the modes: rows are then those of the masses, without modes.
void sum_without_modes(PlainModes& m) {
    m.friction = std::make_shared<FrictionResponse>(m);
    const std::vector<Phasor> X = plain_response(m, m.p, m.p_i), Y = plain_response(m, m.w, PlainRow(m.size()));
    for (const PlainRow& row : m.psi) {
        const PlainMotion start = m.friction->at(row, 0);
        m.V.push_back(dot(row, X));
        m.U.push_back(-start.v);
        m.G.push_back(-start.x);
    }
    m.Y_jj = dot(m.w, Y);
    m.H_j = m.friction->acceleration_at_start(m.w) - m.sum_of_squares;
}

// The row of weights of some masses, a mass's own or a new one behind them.
std::size_t row_of(PlainMatrix& rows, const PlainRow& weights) {
    const auto own = std::ranges::find(rows, weights);
    const auto place = static_cast<std::size_t>(own - rows.begin());
    if (own == rows.end()) rows.push_back(weights);
    return place;
}

} // namespace

PlainModes plain_modes(const ProtocolQuestion& q, const Choices& c) {
    PlainModes m;
    static_cast<PlainSystem&>(m) = plain_system(q);
    m.psi = square(m.size());
    for (std::size_t k = 0; k < m.size(); ++k) m.psi[k][k] = 1;
    m.j = row_of(m.psi, m.w);
    m.l = m.l_i = row_of(m.psi, m.p);
    if (std::ranges::any_of(m.p_i, [](double x) { return x != 0; })) m.l_i = row_of(m.psi, m.p_i);
    m.sum_of_squares = dot(m.w, solved(m.M, m.w)) / (m.r * m.r);
    for (const double r_n : m.r_n) m.R.push_back(m.r / r_n);
    if (m.coupled) {
        sum_without_modes(m);
        return m;
    }
    m.psi = times(m.psi, m.phi);
    for (PlainRow& row : m.psi)
        for (double& x : row) x /= m.r;
    for (std::size_t i = 0; i < m.size(); ++i) {
        const DampingFunctionsOfMode f =
            c.harmonics > 0 ? truncated_functions(c.harmonics, m.R[i], m.zeta[i]) : damping_functions(m.R[i], m.zeta[i]);
        m.u.push_back(f.u);
        m.g.push_back(f.g);
        m.v.push_back(response_of_mode(m.R[i], m.zeta[i]));
    }
    if (c.change_modes) c.change_modes(m);
    sum_modes(m);
    if (c.change_sums) c.change_sums(m);
    return m;
}

std::size_t add_row_in_frame(PlainModes& m, std::size_t k, const Phasor& V) {
    m.psi.push_back(m.psi[k]);
    m.V.push_back(V);
    m.U.push_back(m.U[k]);
    m.G.push_back(m.G[k]);
    return m.V.size() - 1;
}

Phasor response_of_mode(double R, double zeta, int n) {
    const double stiffness = (1 - n * R) * (1 + n * R), damping = 2 * zeta * n * R;
    const double size = stiffness * stiffness + damping * damping;
    return {stiffness / size, -damping / size};
}

double demand_of_mode(const PlainModes& m, std::size_t i, double tau, bool as_printed) {
    if (as_printed) return printed_demand(m.R[i], m.zeta[i], m.u[i], m.g[i], tau);
    if (tau == 0 || tau == pi) return m.g[i] + 2 * m.zeta[i] * m.R[i] * m.u[i] + (tau == 0 ? 1 : -1);
    const ModeDecay f = free_decay(tau / m.R[i], m.zeta[i]);
    const double gained = 2 * square(sin(tau / 2)) - f.lost - 2 * m.zeta[i] * f.q; // R q' - cos(tau)
    return m.R[i] * ((1 + m.g[i]) * f.q - m.u[i] * m.R[i] * gained) / sin(tau);
}

double plain_demand_at(const PlainModes& m, double tau, bool as_printed) {
    if (m.coupled && tau == 0) return m.H_j + m.sum_of_squares;
    if (m.coupled) return (m.friction->rate_gained(m.psi[m.j], tau) - 2 * m.U[m.j] * square(sin(tau / 2))) / sin(tau);
    double S = 0;
    for (std::size_t i = 0; i < m.R.size(); ++i) S += square(m.psi[m.j][i]) * demand_of_mode(m, i, tau, as_printed);
    return S;
}

PlainTurn turn_of(const PlainModes& m, std::size_t k) {
    const Phasor &a = m.V[k], &b = m.V[m.j];
    const double size = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / size, (a.im * b.re - a.re * b.im) / size, std::sqrt(size - square(m.beta * m.U[m.j])),
            m.beta * m.U[m.j]};
}

PlainMotion plain_start(const PlainModes& m, const Choices& c, std::size_t k) {
    const auto [cosine, sine, root, drag] = turn_of(m, k);
    return {root * cosine + (c.initial_displacement_as_printed ? 0 : drag * sine) - m.beta * m.G[k],
            drag * cosine - (c.initial_velocity_as_printed ? 0 : root * sine) - m.beta * m.U[k]};
}

PlainMotion plain_motion(const PlainModes& m, const Choices& c, std::size_t k, double tau) {
    const double halves = std::floor(tau / pi), t = tau - halves * pi, sign = std::fmod(halves, 2) == 0 ? 1 : -1;
    const PlainMotion friction = friction_motion(m, c, k, t);
    const auto [cosine, sine, root, drag] = turn_of(m, k);
    double C = root * cosine + drag * sine, S = drag * cosine - root * sine; // of cos(tau) and sin(tau), (46)
    if (c.motion_from_start) {                                               // (41)
        const PlainMotion start = plain_start(m, c, k);
        C = start.x + m.beta * m.G[k];
        S = start.v + m.beta * m.U[k];
    }
    return {sign * (C * cos(t) + S * sin(t) + m.beta * friction.x), sign * (S * cos(t) - C * sin(t) + m.beta * friction.v)};
}

double plain_phase(const PlainModes& m, const Choices& c) {
    const Phasor& V_j = m.V[m.j];
    const double s = m.beta * m.U[m.j] / modulus(V_j);
    return elementary::atan2(-s, std::sqrt(1 - s * s)) -
           (c.argument_in_half_plane ? elementary::atan(V_j.im / V_j.re) : argument(V_j));
}

int plain_steps(const PlainModes& m) {
    const double fastest = *std::ranges::max_element(m.r_n) / m.r;
    return static_cast<int>(std::clamp(64 + 24 * std::ceil(fastest), 128.0, 8192.0));
}

} // namespace denhartog::conformance
