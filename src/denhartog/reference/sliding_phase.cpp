// What is the state at the end of a sliding phase, if each mode moves by itself? (21) for each mode. Read `after` first.
#include "denhartog/reference/sliding_phase.hpp"

#include <algorithm>
#include <utility>

#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/sparse_balls.hpp"
#include "denhartog/reference/orbit_equations.hpp"

namespace denhartog::reference {
namespace {

BallMatrix rows_of(const BallMatrix& Z, slong first, slong count) {
    BallMatrix part(count, Z.columns());
    for (slong k = 0; k < count; ++k)
        for (slong c = 0; c < Z.columns(); ++c) part(k, c) = Z(first + k, c);
    return part;
}

// The harmonic part of a modal coordinate, and its rate, where the force has this cosine and sine.
struct ForcedCoordinate {
    Ball x, v;

    ForcedCoordinate(const Complex<Ball>& f, const Ball& cosine, const Ball& sine)
        : x(f.re * cosine - f.im * sine), v(-(f.re * sine + f.im * cosine)) {}
};

} // namespace

SlidingPhases::SlidingPhases(const SceneInBalls& s, ModesInBalls modes, const Ball& sigma)
    : m_(std::move(modes)), shapes_(shapes_of(m_)), from_state_(transposed(shapes_) * s.M * (s.r * s.r)), sigma_(sigma),
      beta_(*s.beta) {}

BallMatrix SlidingPhases::after(const BallMatrix& Z, const Ball& length, int direction) const {
    const slong N = m_.N, columns = Z.columns();
    pay(m_.effort, cost_of_ball_products(static_cast<double>(4 * N * (N + 5) * columns)));
    const Ball cosine = cos(length), sine = sin(length);
    BallMatrix x = from_state_ * rows_of(Z, 0, N), v = from_state_ * rows_of(Z, N, N) * sigma_, later = Z;
    for (slong c = 0; c < columns; ++c) {
        later(2 * N, c) = Z(2 * N, c) * cosine - Z(2 * N + 1, c) * sine;
        later(2 * N + 1, c) = Z(2 * N, c) * sine + Z(2 * N + 1, c) * cosine;
    }
    for (slong i = 0; i < N; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const Ball R = m_.R[n], zeta = m_.zeta[n], square = R * R;
        const Complex<Ball> response = paper::complex_response(R, zeta), // (23)
            load{m_.at_load()[n], m_.at_load_i() != nullptr ? (*m_.at_load_i())[n] : Ball(0)};
        const Complex<Ball> forced{square * (response.re * load.re - response.im * load.im),
                                   square * (response.re * load.im + response.im * load.re)};
        const Ball held = Ball(-direction) * beta_ * m_.at_contact()[n] * square;
        const Ball d = paper::d(length, R, zeta), q = R * paper::q(length, R, zeta), // (A.8), (A.9)
            d_prime = paper::d_prime(length, R, zeta), q_prime = R * paper::q_prime(length, R, zeta);
        for (slong c = 0; c < columns; ++c) { // (21): what is not forced moves freely
            const ForcedCoordinate before(forced, Z(2 * N, c), Z(2 * N + 1, c)),
                then(forced, later(2 * N, c), later(2 * N + 1, c));
            const Ball rest = held * Z(2 * N + 2, c), from = x(i, c) - before.x - rest, rate = v(i, c) - before.v;
            x(i, c) = then.x + rest + d * from + q * rate;
            v(i, c) = then.v + d_prime * from + q_prime * rate;
        }
    }
    const BallMatrix places = shapes_ * x, speeds = shapes_ * v * (1 / sigma_);
    for (slong c = 0; c < columns; ++c)
        for (slong k = 0; k < N; ++k) {
            later(k, c) = places(k, c);
            later(N + k, c) = speeds(k, c);
        }
    return later;
}

std::optional<SlidingPhases> sliding_phases(const SceneInBalls& s, const Ball& sigma) {
    if (s.zeta.empty() || !s.beta || !std::ranges::all_of(s.zeta, [](const Ball& zeta) { return zeta < Ball(1); })) return {};
    ModesInBalls modes = modes_in_balls(s);
    const auto responds = [&](std::size_t i) { return paper::complex_response(modes.R[i], modes.zeta[i]).re.finite(); };
    for (std::size_t i = 0; i < modes.R.size(); ++i)
        if (!responds(i)) return {}; // a pole
    if (!modes.clusters.empty()) return {};
    return SlidingPhases(s, std::move(modes), sigma);
}

BallMatrix ContactMechanics::propagator(int direction, const Ball& h) const {
    if (sliding && direction != 0) return sliding->after(unit_matrix(n()), h, direction);
    pay(effort, cost_of_ball_products(20 * static_cast<double>(n() * n() * n())));
    return exp_of_sparse(rounded(phase(direction)) * h);
}

} // namespace denhartog::reference
