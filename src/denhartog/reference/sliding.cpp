// The motion if the contact slides throughout, the friction ratio up to which it does, and the one from which it is held for ever.
// (38) and (39) for the contact, `contact_in_balls`; (44) and (45) for the start of the others; (41) at any instant.
// `boundary_in_balls` has (56), (67) and (69) as they stand, `stuck_in_balls` the equation of motion with the force that holds
// the contact.
#include "denhartog/reference/sliding.hpp"

#include <cmath>
#include <utility>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/formulas/superposition.hpp"

namespace denhartog::reference {
SteadyState<Ball> contact_in_balls(const ResponsesInBalls& r, const Ball& beta) {
    const std::size_t j = r.contact();
    return {beta,
            paper::displacement_transmissibility_of_contact(r.V[j], r.U[j], r.G[j], beta),
            wrapped_in_balls(paper::phase_of_contact(r.V[j], r.U[j], beta)),
            {}};
}

MassResponse<Ball> start_of_mass_in_balls(const ResponsesInBalls& r, const SteadyState<Ball>& contact, std::size_t row,
                                          bool is_contact) {
    const std::size_t j = r.contact();
    const Ball& beta = contact.beta;
    MassResponse<Ball> m;
    m.x0 = is_contact ? contact.X_j : paper::initial_displacement(r.V[row], r.V[j], r.U[j], r.G[row], beta);
    m.v0 = is_contact ? Ball(0) : paper::initial_velocity(r.V[row], r.V[j], r.U[j], r.U[row], beta);
    return m;
}

Series displacement_in_balls(const ResponsesInBalls& r, const MassResponse<Ball>& m, const Ball& beta, std::size_t row,
                             const Ball& tau) {
    const Series F = r.friction.at(row, tau);
    return paper::displacement<Series>(Series::time(tau), m.x0, m.v0, r.G[row], r.U[row], beta, F);
}

MassResponse<Ball> mass_in_balls(const ResponsesInBalls& r, const SteadyState<Ball>& contact, std::size_t row, bool is_contact) {
    const std::size_t j = r.contact();
    const Ball& beta = contact.beta;
    if (is_contact) return {contact.X_j, Ball(0), contact.X_j, Ball(0), contact.phi_j, contact.X_j, contact.phi_j};
    MassResponse<Ball> m = start_of_mass_in_balls(r, contact, row, is_contact);
    m.amplitude_monoharmonic = paper::displacement_transmissibility(r.V[row], r.V[j], r.U[j], r.U[row], r.G[row], beta);
    m.phase_monoharmonic = wrapped_in_balls(contact.phi_j + paper::phase_behind_contact(m.x0, m.v0));
    if (beta.is_zero()) { // without friction the motion is harmonic, and lags by minus the angle of V_dk
        m.amplitude = modulus(r.V[row]);
        m.phase = wrapped_in_balls(-argument(r.V[row]));
        m.instant = wrapped_in_balls(m.phase - contact.phi_j);
        if (m.instant < Ball(0)) m.instant = m.instant + pi<Ball>();
        return m;
    }
    const auto x = [&](const Ball& tau) { return displacement_in_balls(r, m, beta, row, tau); };
    // A mass that does not move, as far as the bits decide, has no instant of a largest displacement. By (41) to (43) |x_k| is
    // at most |V_dk| + beta |F_k|.
    const Ball F_throughout = r.friction.at(row, either(Ball(0), pi<Ball>())).rate(0);
    const Ball throughout = size_in_balls(r.V[row]) + beta * abs(F_throughout);
    if (throughout < abs(contact.X_j) * power_of_two(-ball_bits / 2)) {
        m.amplitude = either(Ball(0), throughout);
        m.instant = m.phase = widened(Ball(0), pi<Ball>());
        return m;
    }
    const LargestBothWays largest = largest_size_of(x);
    const auto phase = [&](const LargestInBalls& at, int minimum) {
        return wrapped_in_balls(paper::phase_of_mass(contact.phi_j, at.instant, minimum));
    };
    const bool both = largest.up && largest.down && arb_overlaps(largest.up->value.a, largest.down->value.a) != 0;
    if (!both) {
        const bool minimum = !largest.up || (largest.down && largest.down->value > largest.up->value);
        const LargestInBalls& at = minimum ? *largest.down : *largest.up;
        m.amplitude = at.value;
        m.instant = at.instant;
        m.phase = phase(at, minimum ? 1 : 0);
        return m;
    }
    // Both may be the largest. If they lie at the two ends of the half-period, they are one extremum and its mirror image.
    const Ball one = phase(*largest.up, 0), apart = wrapped_in_balls(phase(*largest.down, 1) - one);
    m.amplitude = larger(largest.up->value, largest.down->value);
    m.instant = either(largest.up->instant, largest.down->instant);
    m.phase = either(one, one + apart);
    return m;
}

BallMatrix harmonic_in_balls(const std::vector<Complex<Ball>>& X, slong N, const Ball& tau) {
    const Complex<Ball> turned{cos(tau), sin(tau)};
    BallMatrix state(2 * N, 1);
    for (slong k = 0; k < N; ++k) {
        const Complex<Ball> x = X[k] * turned;
        state(k) = x.re;
        state(N + k) = -x.im;
    }
    return state;
}

SteadyState<Ball> sliding_motion_in_balls(const ResponsesInBalls& r, const Ball& beta) {
    SteadyState<Ball> motion = contact_in_balls(r, beta);
    for (std::size_t k = 0; k < r.contact(); ++k) motion.masses.push_back(start_of_mass_in_balls(r, motion, k, false));
    return motion;
}

BallMatrix state_in_balls(const ResponsesInBalls& r, const SteadyState<Ball>& motion, const Ball& tau) {
    const auto N = static_cast<slong>(r.contact());
    if (motion.beta.is_zero()) return harmonic_in_balls(r.V, N, tau);
    BallMatrix state(2 * N, 1);
    const Ball pi = PiOf<Ball>::value(), from_maximum = tau - motion.phi_j;
    const double half = std::floor(static_cast<double>(from_maximum) / static_cast<double>(pi));
    bool found = false;
    for (const double halves : {half - 1, half, half + 1}) { // an instant next to a turn may be on either side
        const Ball within = from_maximum - Ball(halves) * pi;
        if (within < Ball(0) || within > pi) continue;
        for (slong k = 0; k < N; ++k) {
            const Series x = displacement_in_balls(r, motion.masses[k], motion.beta, k, within);
            for (const int n : {0, 1}) {
                const Ball rate = std::fmod(halves, 2) == 0 ? x.rate(n) : -x.rate(n); // (25)
                Ball& entry = state(n * N + k);
                entry = found ? either(entry, rate) : rate;
            }
        }
        found = true;
    }
    return state;
}

namespace {

// (54)a: the contact moves down while X_j + beta G_j is above beta (U_dj cos + F_j') / sin. The quotient is (57) before its
// maximum is taken, summed over the modes as in (56).
Series numerator(const Ball& U, const Series& F, const Ball& tau) { return Series(U) * cos(Series::time(tau)) + F.derivative(); }

// Whether n'' + n is a small difference of large terms, as next to a resonance.
bool is_hidden(const FunctionOfTime& Z, const FunctionOfTime& n, const Ball& U) {
    const Ball tau(1.5);
    const auto size = [](const Ball& x) { return upper_bound_of(abs(x)); };
    return 64 * size(Z(tau).rate(0)) < larger(size(U), size(n(tau).rate(0)));
}

LargestInBalls largest_demand(const ResponsesInBalls& r) {
    const Ball U = r.U[r.contact()];
    const auto n = [&](const Ball& tau) { return numerator(U, r.friction.of(r.contact(), (*r.friction.shared)(tau)), tau); };
    const auto Z = [&](const Ball& tau) { return r.friction.rate_and_third(r.contact(), (*r.friction.shared)(tau)); };
    const bool hides = !r.friction.modes.empty() && is_hidden(Z, n, U);
    return largest_over_sine(n, hides ? FunctionOfTime(Z) : FunctionOfTime());
}

// (56): each mode by itself.
Ball sum_of_largest(const ResponsesInBalls& r) {
    const ModesInBalls& m = r.modes;
    std::vector<Ball> largest;
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        const Ball R = m.R[i];
        if (!is_told_from_critical(m.zeta[i])) { // the mode is one mass with r = R
            largest.push_back(R * R * largest_demand(responses_of_one_mass(R, m.zeta[i], m.effort)).value);
            continue;
        }
        const FrictionMotionOfMode mode(R, m.zeta[i]);
        Remembered<Series> F([&](const Ball& tau) {
            pay(m.effort, cost_of_evaluations(1));
            return mode.at(tau);
        });
        const auto numerator_of_mode = [&](const Ball& tau) { return numerator(mode.u, F(tau), tau); };
        const auto Z = [&](const Ball& tau) { return mode.rate_and_third(F(tau)); };
        const bool hides = is_hidden(Z, numerator_of_mode, mode.u);
        largest.push_back(R * R * largest_over_sine(numerator_of_mode, hides ? FunctionOfTime(Z) : FunctionOfTime()).value);
    }
    return paper::sum_over_contact<Ball>(m.at_contact(), largest, m.left_open(m.at_contact(), m.at_contact(), largest));
}

bool same(const BallMatrix& x, const BallMatrix& y) { return arb_mat_eq(x.a, y.a) != 0 && arb_mat_is_exact(x.a) != 0; }

} // namespace

Boundary<Ball> boundary_in_balls(const SceneInBalls& s, const ResponsesInBalls& r) {
    const std::size_t j = r.contact();
    const LargestInBalls found = largest_demand(r);
    Boundary<Ball> b{};
    b.S_exact = found.value;
    b.instant = found.instant;
    const Ball held = paper::static_friction_demand(r.H, s.mu, r.squares);
    b.exact = paper::friction_ratio_limit(r.V[j], r.U[j], larger(b.S_exact, held));
    // With one mode (56) is the maximum that was found; with a damping matrix see `paper_limit_of_modes`.
    b.S_paper = r.modes.R.size() > 1 ? sum_of_largest(r) : b.S_exact;
    b.paper = paper::friction_ratio_limit(r.V[j], r.U[j], larger(b.S_paper, held));
    b.approximate = paper::friction_ratio_limit(r.V[j], r.U[j], held);
    if (b.instant.is_zero())
        b.binding = s.mu == Ball(1) ? BindingCondition::both : BindingCondition::static_friction;
    else // both where the bits do not tell
        b.binding = b.S_exact > held   ? BindingCondition::velocity
                    : b.S_exact < held ? BindingCondition::static_friction
                                       : BindingCondition::both;
    return b;
}

std::optional<StuckInBalls> stuck_in_balls(const SceneInBalls& s) {
    // (K - M + i C) X + w f = p, w^T X = 0 in real parts and imaginary parts: unknown are X and the force f
    const slong N = s.N(), n = N + 1;
    BallMatrix A = dynamic_stiffness(s, n), b(2 * n, 1), x;
    put(b, 0, 0, s.p);
    put(b, n, 0, s.p_i);
    for (const slong half : {slong(0), n}) {
        put(A, half, half + N, s.w);
        put(A, half + N, half, transposed(s.w));
    }
    if (!solved(A, b, x)) return std::nullopt;
    StuckInBalls out;
    for (slong k = 0; k < N; ++k) out.X.push_back({x(k), x(n + k)});
    out.load = {x(N), x(n + N)};
    out.compliance = (transposed(s.w) * solution_of(s.K, s.w, stiffness_is_open))(0);
    return out;
}

Ball sticking_limit_in_balls(const SceneInBalls& s, const StuckInBalls& stuck) {
    return s.p_i.rows() == 0 && same(s.w, s.p) ? paper::sticking_limit_under_load(s.mu) : paper::sticking_limit(stuck.load, s.mu);
}

Ball sticking_limit_by_88(const SceneInBalls& s, std::size_t load) {
    if (load == s.contact) return paper::sticking_limit_under_load(s.mu);
    const bool before = load < s.contact;
    const auto j = static_cast<slong>(s.contact), l = static_cast<slong>(load), first = before ? 0 : j + 1,
               count = before ? j : s.N() - j - 1;
    SceneInBalls moving{part_of(s.M, first, first, count, count), part_of(s.K, first, first, count, count)};
    moving.r = s.r;
    moving.kept = s.kept;
    moving.effort = s.effort;
    moving.w = moving.p = BallMatrix(count, 1);
    moving.w(before ? count - 1 : 0) = Ball(1); // the mass next to the contact
    moving.p(l - first) = Ball(1);
    const ModesInBalls m = modes_in_balls(moving);
    if (!m.clusters.empty())
        throw Unproved("modes beside the contact are not told apart"); // those of a chain are, with more bits
    std::vector<Complex<Ball>> v;
    for (std::size_t i = 0; i < m.R.size(); ++i) { // (18) on the diagonal: 2 zeta omega = phi^T C phi, phi = r psi, omega = r / R
        Ball c(0);
        for (slong k = 0; k < count; ++k)
            for (slong n = 0; n < count; ++n) c += m.psi[k][i] * s.C(first + k, first + n) * m.psi[n][i];
        v.push_back(paper::complex_response(m.R[i], Ball(c * s.r * m.R[i] / 2)));
    }
    const Complex<Ball> X = paper::complex_response_of_mass<Ball>(m.at_contact(), m.at_load(), m.R, v);
    const Ball kappa = -s.K(j, before ? j - 1 : j + 1);
    return paper::sticking_limit_by_spring(kappa, modulus(X), s.mu);
}

} // namespace denhartog::reference
