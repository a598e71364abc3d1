/// @file
/// @brief What the mirrored half-period says without a phase: responses to the cosine, the sine and the friction, each by itself.
#pragma once

#include <Eigen/LU>
#include <algorithm>

#include "denhartog/number/number.hpp"
#include "tests/support/half_period.hpp"

namespace denhartog::conformance::generator {

/// @brief Motions of (6) that mirror themselves after half a period, under unit loads.
template <class T>
struct LinearHalfPeriod {
    Matrix<T> A; ///< matrix of z' = Az, z = (x, x', cos, sin, 1), the contact under a friction of 1
    Matrix<T> Y; ///< (x, x') at tau = 0 for the force cos tau, for the force -sin tau, for the friction: 2N x 3
    Matrix<T> f; ///< state z under the friction alone at tau = pi n / steps, (2N + 3) x (steps + 1)
    Vector<T> w; ///< displacement of the contact over the masses

    /// @brief Velocity of the contact. @param z a state @return it
    [[nodiscard]] T velocity_of_contact(const Vector<T>& z) const { return w.dot(z.segment(w.size(), w.size())); }
};

/// @brief Number of steps that show every extremum: 32 a cycle of the fastest mode, at least 96. `fastest` is the largest natural
/// frequency over that of the force.
template <class T>
[[nodiscard]] int steps_for(const T& fastest) {
    return std::clamp(static_cast<int>(16 * fastest), 96, 4096);
}

/// @brief Solves the mirrored half-period. The problem's beta does not matter; [0, pi] is sampled in equal steps.
template <class T>
[[nodiscard]] LinearHalfPeriod<T> linear_half_period(HalfPeriodProblem<T> p, int steps) {
    p.beta = T(1);
    const Eigen::Index N = p.M.rows();
    LinearHalfPeriod<T> h{augmented_system(p), {}, {}, contact_vector(p)};
    const Matrix<T> step = matrix_exponential(Matrix<T>(h.A * T(pi<T>() / steps)));
    const Matrix<T> half = matrix_exponential(Matrix<T>(h.A * pi<T>()));
    const Eigen::FullPivLU<Matrix<T>> mirrored(half.topLeftCorner(2 * N, 2 * N) + Matrix<T>::Identity(2 * N, 2 * N));
    h.Y = mirrored.solve(Matrix<T>(-half.topRightCorner(2 * N, 3)));
    h.f.resize(2 * N + 3, steps + 1);
    h.f.col(0) << h.Y.col(2), T(0), T(0), T(1);
    for (Eigen::Index n = 0; n < steps; ++n) h.f.col(n + 1) = step * h.f.col(n);
    return h;
}

/// @brief State of z' = Az a time later, by Taylor's series in steps of norm 1, or by the matrix exponential where they are many.
/// The time may have any sign.
template <class T>
[[nodiscard]] Vector<T> moved(const Matrix<T>& A, const Vector<T>& z, const T& dt) {
    using std::abs;
    T norm(0);
    for (Eigen::Index i = 0; i < A.rows(); ++i) norm = std::max(norm, T(A.row(i).cwiseAbs().sum()));
    if (norm * abs(dt) > 100) return matrix_exponential(Matrix<T>(A * dt)) * z;
    const int steps = 1 + static_cast<int>(T(norm * abs(dt)));
    const T h = dt / steps;
    Vector<T> now = z;
    for (int n = 0; n < steps; ++n) {
        Vector<T> term = now;
        const T enough = std::numeric_limits<T>::epsilon() / 1024 * now.cwiseAbs().maxCoeff();
        for (int k = 1; term.cwiseAbs().maxCoeff() > enough; ++k) {
            term = Vector<T>(A * term) * T(h / k);
            now += term;
        }
    }
    return now;
}

/// @brief First damping function (34) of a displacement: its velocity at tau = 0 under the friction alone, with the sign turned.
template <class T>
[[nodiscard]] T U_of(const LinearHalfPeriod<T>& h, const Vector<T>& x) {
    return -x.dot(h.Y.col(2).tail(x.size()));
}

/// @brief Second damping function (35) of a displacement: that displacement there, with the sign turned.
template <class T>
[[nodiscard]] T G_of(const LinearHalfPeriod<T>& h, const Vector<T>& x) {
    return -x.dot(h.Y.col(2).head(x.size()));
}

/// @brief Acceleration of the contact next after tau = 0 under the friction alone: H_j + w^T M^-1 w / r^2, Eqs. (64), (65), (71).
template <class T>
[[nodiscard]] T acceleration_at_start(const LinearHalfPeriod<T>& h) {
    return h.velocity_of_contact(Vector<T>(h.A * h.f.col(0)));
}

/// @brief Largest value over (0, pi) of (U_dj cos tau + x_j') / sin tau under the friction alone, its limits included: S_j.
///
/// The velocity of the contact is -sin tau times the root of (38), plus beta times that numerator.
template <class T>
[[nodiscard]] T largest_demand(const LinearHalfPeriod<T>& h) {
    using std::abs;
    const Eigen::Index steps = h.f.cols() - 1;
    const T U = U_of(h, h.w), spacing = pi<T>() / static_cast<int>(steps);
    const auto demand = [&](const T& velocity, const T& tau) { return T((U * cos(tau) + velocity) / sin(tau)); };
    T largest = acceleration_at_start(h);
    Eigen::Index best = 0;
    T largest_inside = largest;
    for (Eigen::Index n = 1; n < steps; ++n) {
        const T value = demand(h.velocity_of_contact(Vector<T>(h.f.col(n))), T(spacing * static_cast<int>(n)));
        if (best > 0 && value <= largest_inside) continue;
        best = n;
        largest_inside = value;
    }
    largest = std::max(largest, T(-h.velocity_of_contact(Vector<T>(h.A * h.f.col(steps)))));
    // Newton's method on the derivative times sin^2: x_j'' sin - x_j' cos - U, whose own derivative is (x_j''' + x_j') sin.
    T tau = spacing * static_cast<int>(best);
    const T start = tau;
    for (int n = 0; n < 200; ++n) {
        const Vector<T> z = moved(h.A, Vector<T>(h.f.col(best)), T(tau - start));
        const Vector<T> rate = h.A * z, second = h.A * rate;
        const T v = h.velocity_of_contact(z);
        largest_inside = demand(v, tau);
        const T w = h.velocity_of_contact(rate) * sin(tau) - v * cos(tau) - U,
                w_prime = (h.velocity_of_contact(second) + v) * sin(tau);
        const T change = std::clamp(T(-w / w_prime), T(-spacing / 4), T(spacing / 4));
        tau += change;
        if (abs(T(tau - start)) > 2 * spacing || !(tau > spacing / 1024)) return largest; // nothing but the start
        if (abs(change) < std::numeric_limits<T>::epsilon() * 1024) break;
    }
    return std::max(largest, largest_inside);
}

/// @brief Where a row over the state is largest in size.
template <class T>
struct FurthestPlace {
    T x{0};       ///< its value there
    T instant{0}; ///< when, from the start of the stretch
};

/// @brief The turning points of a row over the state of z' = Az: where its rate changes its sign between equal samples, by
/// Newton's method, and bisection where that leaves the interval. The ends of the stretch are not among them. Gives the one where
/// the row is largest in size; zero where there is none.
template <class T>
[[nodiscard]] FurthestPlace<T> furthest_turn(const Matrix<T>& A, const Vector<T>& z, const Vector<T>& row, const T& length,
                                             int samples) {
    using std::abs;
    const Vector<T> rates = A.transpose() * row;
    const auto rate = [&](const Vector<T>& at) { return T(rates.dot(at)); };
    const T h = length / samples;
    const Matrix<T> step = matrix_exponential(Matrix<T>(A * h));
    FurthestPlace<T> best;
    Vector<T> now = z;
    for (int s = 0; s < samples; ++s) {
        const Vector<T> next = step * now;
        const bool rises = rate(now) > T(0);
        if (rises != (rate(next) > T(0))) {
            T low(0), high(h), dt = h / 2;
            for (int n = 0; n < 400; ++n) {
                const Vector<T> at = moved(A, now, dt);
                ((rate(at) > T(0)) == rises ? low : high) = dt;
                const T newton = dt - rate(at) / rate(Vector<T>(A * at));
                const T change = (newton > low && newton < high ? newton : T((low + high) / 2)) - dt;
                dt += change;
                if (abs(change) < std::numeric_limits<T>::epsilon() * 16) break;
            }
            const T x = row.dot(moved(A, now, dt));
            if (abs(x) > abs(best.x)) best = {x, T(s * h + dt)};
        }
        now = next;
    }
    return best;
}

} // namespace denhartog::conformance::generator
