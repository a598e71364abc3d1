// Displacements and velocities at evenly spaced instants, by a recurrence in place of sines and exponentials, and what that
// costs in digits, `loss_of_samples`.
#include "denhartog/evaluation/even_samples.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/evaluation/friction_motion.hpp"

namespace denhartog::evaluation {
namespace {

constexpr std::size_t lanes = 8, most_steps = 64; // runs that go on side by side, and the longest
using Lanes = Eigen::Array<double, lanes, 1>;

// The affine map that carries the state of a coordinate over a time.
struct CarriedState {
    double d, Rq, rest, d_prime, Rq_prime, rest_prime;
};

CarriedState carried(const FreeCoordinate& c, double time) {
    const FreeMotion<double> free = free_motion(time, c.R, c.zeta, c.w);
    return {free.d,       c.R * free.q,       c.rest * one_minus_d(time / c.R, c.zeta, c.w, free.q),
            free.d_prime, c.R * free.q_prime, -free.d_prime * c.rest};
}

// Steps of a run: as few as leave no run idle.
std::size_t steps_of_run(std::size_t count) {
    const std::size_t rounds = (count + lanes * most_steps - 1) / (lanes * most_steps);
    return rounds == 0 ? 0 : (count + lanes * rounds - 1) / (lanes * rounds);
}

} // namespace

double largest_size(const FreeCoordinate& c, double time) {
    const double s = std::abs(c.s_0), R_s_prime = c.R * std::abs(c.s_prime), rest = std::abs(c.rest), x = time / c.R;
    const double energy = modulus(Complex<double>{c.s_0 - c.rest, R_s_prime}), root_of_2 = 1.41422; // and more
    return std::min(2 * rest + root_of_2 * energy, (s + R_s_prime + rest * x) * (1 + x));
}

std::vector<ErrorOfSamples> loss_of_samples(const LinearSum& m, const EvenInstants& at) {
    constexpr double a_step = 7.1 /* the root of two times 5 */, a_start = 16, eps = std::numeric_limits<double>::epsilon();
    const std::size_t n = m.coordinates.size();
    const double steps = static_cast<double>(std::min(most_steps, at.count / lanes + 1)); // at most
    const double T = std::abs(m.start) + std::abs(at.first) + static_cast<double>(at.count) * at.step;
    const auto loss = [&](double R) {
        return eps * (a_step * steps * (1 + at.step / R) + a_start * (1 + T / R) + static_cast<double>(n));
    };
    std::vector<ErrorOfSamples> all;
    for (std::size_t k = 0; k < m.A.size(); ++k) {
        const double harmonic = loss(1) * m.harmonic[k];
        ErrorOfSamples error{harmonic + loss(1) * std::abs(m.constant[k]), harmonic};
        for (std::size_t i = 0; i < n; ++i) {
            const double R = m.coordinates[i].R;
            const double lost = std::abs(m.shapes[k * n + i]) * loss(R) * largest_size(m.coordinates[i], T);
            error.x += lost;
            error.x_prime += lost / R;
        }
        all.push_back(error);
    }
    return all;
}

void even_samples(const LinearSum& m, const EvenInstants& at, double* x, double* x_prime) {
    const std::size_t n = m.coordinates.size(), N = m.A.size(), length = steps_of_run(at.count);
    const SineCosine<double> turn = sine_cosine(at.step);
    std::vector<CarriedState> steps;
    for (const FreeCoordinate& c : m.coordinates) steps.push_back(carried(c, at.step));
    steps.push_back({turn.c, turn.s, 0, -turn.s, turn.c, 0}); // the harmonic motion, which comes last
    std::vector<Lanes> s(n + 1), s_prime(n + 1);
    for (std::size_t from = 0; from < at.count; from += lanes * length) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double tau = at.first + at.step * static_cast<double>(std::min(from + lane * length, at.count - 1));
            for (std::size_t i = 0; i < n; ++i) {
                const FreeCoordinate& c = m.coordinates[i];
                const CarriedState over = carried(c, std::max(0.0, tau - m.start));
                s[i][lane] = over.d * c.s_0 + over.Rq * c.s_prime + over.rest;
                s_prime[i][lane] = over.d_prime * c.s_0 + over.Rq_prime * c.s_prime + over.rest_prime;
            }
            const SineCosine<double> now = sine_cosine(tau);
            s[n][lane] = now.c;
            s_prime[n][lane] = -now.s;
        }
        for (std::size_t step = 0; step < length && from + step < at.count; ++step) {
            const std::size_t used = std::min(lanes, (at.count - from - step + length - 1) / length);
            for (std::size_t k = 0; k < N; ++k) {
                Lanes sum = m.constant[k] + (m.A[k] * s[n] - m.B[k] * s_prime[n]);
                Lanes sum_prime = m.A[k] * s_prime[n] + m.B[k] * s[n];
                for (std::size_t i = 0; i < n; ++i) {
                    sum += m.shapes[k * n + i] * s[i];
                    sum_prime += m.shapes[k * n + i] * s_prime[i];
                }
                for (std::size_t lane = 0; lane < used; ++lane) {
                    x[(from + lane * length + step) * N + k] = sum[lane];
                    x_prime[(from + lane * length + step) * N + k] = sum_prime[lane];
                }
            }
            for (std::size_t i = 0; i <= n; ++i) {
                const CarriedState& over = steps[i];
                const Lanes now = s[i];
                s[i] = over.d * now + over.Rq * s_prime[i] + over.rest;
                s_prime[i] = over.d_prime * now + over.Rq_prime * s_prime[i] + over.rest_prime;
            }
        }
    }
}

} // namespace denhartog::evaluation
