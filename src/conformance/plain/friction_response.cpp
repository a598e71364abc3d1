// The steady motion F of (46) without modes, for damping that couples them: half a period of the equations of the first order
// turns the state into its mirror image, which gives linear equations for the state at the start. Read the constructor.
#include "conformance/plain/friction_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace denhartog::conformance {

PlainMatrix equations_of(const PlainSystem& s, bool held) {
    const std::size_t N = s.size();
    PlainMatrix A = square(2 * N + 3);
    const auto accelerations = [&](PlainRow force) {
        for (double& f : force) f /= s.r * s.r;
        return solved(s.M, std::move(force));
    };
    const PlainRow of_contact = accelerations(s.w);
    for (std::size_t k = 0; k < 2 * N + 3; ++k) {
        PlainRow force(N);
        for (std::size_t i = 0; i < N; ++i) {
            if (k < N) force[i] = -s.K[i][k];
            if (k >= N && k < 2 * N) force[i] = -s.r * s.C[i][k - N];
            if (k == 2 * N) force[i] = s.p[i];
            if (k == 2 * N + 1) force[i] = -s.p_i[i];
            if (k == 2 * N + 2) force[i] = -s.w[i];
        }
        PlainRow a = accelerations(std::move(force));
        const double held_back = held ? dot(s.w, a) / dot(s.w, of_contact) : 0;
        for (std::size_t i = 0; i < N; ++i) A[N + i][k] = a[i] - held_back * of_contact[i];
    }
    for (std::size_t i = 0; i < N; ++i) A[i][N + i] = 1;
    A[2 * N][2 * N + 1] = -1;
    A[2 * N + 1][2 * N] = 1;
    return A;
}

PlainRow in_state(const PlainRow& row, std::size_t from) {
    PlainRow all(2 * row.size() + 3);
    std::ranges::copy(row, all.begin() + static_cast<long>(from));
    return all;
}

int steps_of(const PlainSystem& s) {
    double fastest = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
        fastest = std::max(fastest, s.shapes.r_n[i] / s.r * (1 + 2 * s.zeta[i] * s.zeta[i]));
    return 2 * static_cast<int>(std::clamp(16 + 6 * std::ceil(fastest), 32.0, 8192.0));
}

FrictionResponse::FrictionResponse(const PlainSystem& s) : A(equations_of(s, false)), step(2 * std::numbers::pi / steps_of(s)) {
    const std::size_t n = 2 * s.size();
    const PlainMatrix of_step = propagator(A, step);
    PlainMatrix half = of_step, power = of_step; // over a half-period, by its steps but one
    for (int left = steps_of(s) / 2 - 1; left > 0; left /= 2, power = times(power, power))
        if (left % 2 == 1) half = times(power, half);
    PlainRow mirrored(n); // (I + E) y = -E f with the force f = -1 of a contact that moves backwards
    for (std::size_t i = 0; i < n; ++i) {
        mirrored[i] = half[i][n + 2];
        half[i].resize(n);
        half[i][i] += 1;
    }
    half.resize(n);
    PlainRow z = solved(half, mirrored);
    z.insert(z.end(), {0, 0, -1});
    for (int left = steps_of(s) / 2; left > 0; --left, z = times(of_step, z)) nodes.push_back(z);
}

PlainMotion FrictionResponse::at(const PlainRow& row, double tau) const {
    const auto n = std::min(static_cast<std::size_t>(tau / step), nodes.size() - 1);
    const PlainRow z = moved(A, nodes[n], tau - static_cast<double>(n) * step);
    return {dot(row, z), dot(in_state(row, row.size()), z)};
}

double FrictionResponse::rate_gained(const PlainRow& row, double tau) const {
    const double at_start = at(row, 0).v;
    if (tau > step) return at(row, tau).v - at_start;
    // By the rate of the state, so that no digits are lost next to the start.
    return dot(in_state(row, row.size()), increment(A, nodes.front(), tau));
}

double FrictionResponse::acceleration_at_start(const PlainRow& row) const {
    return dot(in_state(row, row.size()), times(A, nodes.front()));
}

} // namespace denhartog::conformance
