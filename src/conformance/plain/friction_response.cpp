#include "conformance/plain/friction_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace denhartog::conformance {

PlainMatrix equations_of(const PlainSystem& s, bool held) {
    const std::size_t N = s.size();
    PlainMatrix A = square(2 * N + 3);
    PlainRow pull(N); // acceleration by a unit force on the contact
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
    PlainMotion motion;
    for (std::size_t k = 0; k < row.size(); ++k) {
        motion.x += row[k] * z[k];
        motion.v += row[k] * z[row.size() + k];
    }
    return motion;
}

double FrictionResponse::rate_gained(const PlainRow& row, double tau) const {
    const double at_start = at(row, 0).v;
    if (tau > step) return at(row, tau).v - at_start;
    double gained = 0; // by the rate of the state, so that no digits are lost next to the start
    const PlainRow gain = increment(A, nodes.front(), tau);
    for (std::size_t k = 0; k < row.size(); ++k) gained += row[k] * gain[row.size() + k];
    return gained;
}

double FrictionResponse::acceleration_at_start(const PlainRow& row) const {
    const PlainRow rate = times(A, nodes.front());
    double sum = 0;
    for (std::size_t k = 0; k < row.size(); ++k) sum += row[k] * rate[row.size() + k];
    return sum;
}

} // namespace denhartog::conformance
