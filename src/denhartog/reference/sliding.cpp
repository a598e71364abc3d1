// What is the sliding motion, proved? (38) and (39) for the contact, `contact_in_balls`; (44) and (45) for the start of the
// others; (46) at any instant. The largest displacement of a mass comes from maximum.cpp.
#include "denhartog/reference/sliding.hpp"

#include <cmath>
#include <utility>

#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/reference/maximum.hpp"

namespace denhartog::reference {

SlidingContactInBalls contact_in_balls(const ResponsesInBalls& r, const Ball& beta) {
    const std::size_t j = r.contact();
    return {paper::displacement_transmissibility_of_contact(r.V[j], r.U[j], r.G[j], beta),
            wrapped_in_balls(paper::phase_of_contact(r.V[j], r.U[j], beta))};
}

SlidingMassInBalls start_of_mass_in_balls(const ResponsesInBalls& r, const SlidingContactInBalls& contact, const Ball& beta,
                                          std::size_t row, bool is_contact) {
    const std::size_t j = r.contact();
    SlidingMassInBalls m;
    m.x0 = is_contact ? contact.X_j : paper::initial_displacement(r.V[row], r.V[j], r.U[j], r.G[row], beta);
    m.v0 = is_contact ? Ball(0) : paper::initial_velocity(r.V[row], r.V[j], r.U[j], r.U[row], beta);
    return m;
}

Series displacement_in_balls(const ResponsesInBalls& r, const SlidingMassInBalls& m, const Ball& beta, std::size_t row,
                             const Ball& tau) {
    const Series F = r.friction.at(row, tau);
    return paper::displacement<Series>(Series::time(tau), m.x0, m.v0, r.G[row], r.U[row], beta, F);
}

SlidingMassInBalls mass_in_balls(const ResponsesInBalls& r, const SlidingContactInBalls& contact, const Ball& beta,
                                 std::size_t row, bool is_contact) {
    const std::size_t j = r.contact();
    if (is_contact) return {contact.X_j, contact.phi_j, contact.X_j, Ball(0), Ball(0), contact.X_j, contact.phi_j};
    SlidingMassInBalls m = start_of_mass_in_balls(r, contact, beta, row, is_contact);
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
    const Ball throughout = root_of_positive(squared_modulus(r.V[row])) + beta * abs(F_throughout);
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
    const Ball c = cos(tau), s = sin(tau);
    BallMatrix state(2 * N, 1);
    for (slong k = 0; k < N; ++k) {
        const Complex<Ball>& X_k = X[static_cast<std::size_t>(k)];
        state(k) = X_k.re * c - X_k.im * s;
        state(N + k) = -(X_k.re * s + X_k.im * c);
    }
    return state;
}

SlidingMotionInBalls::SlidingMotionInBalls(ResponsesInBalls r, const Ball& beta)
    : r_(std::move(r)), beta_(beta), contact_(contact_in_balls(r_, beta)) {
    for (std::size_t k = 0; k < r_.contact() && !beta_.is_zero(); ++k)
        start_.push_back(start_of_mass_in_balls(r_, contact_, beta_, k, false));
}

BallMatrix SlidingMotionInBalls::at(const Ball& tau) const {
    const auto N = static_cast<slong>(r_.contact());
    if (beta_.is_zero()) return harmonic_in_balls(r_.V, N, tau);
    BallMatrix state(2 * N, 1);
    const Ball pi = PiOf<Ball>::value(), from_maximum = tau - contact_.phi_j;
    const double half = std::floor(static_cast<double>(from_maximum) / static_cast<double>(pi));
    bool found = false;
    for (const double halves : {half - 1, half, half + 1}) { // an instant next to a turn may be on either side
        const Ball within = from_maximum - Ball(halves) * pi;
        if (within < Ball(0) || within > pi) continue;
        for (slong k = 0; k < N; ++k) {
            const auto row = static_cast<std::size_t>(k);
            const Series x = displacement_in_balls(r_, start_[row], beta_, row, within);
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

} // namespace denhartog::reference
