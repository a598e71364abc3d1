#include "tests/conformance/generator/linear_half_period.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "tests/support/multiprecision.hpp"

namespace denhartog::conformance::generator {

using Index = Eigen::Index;

namespace {

template <class T>
T velocity_of_contact(const LinearHalfPeriod<T>& h, const Vector<T>& z) {
    return h.w.dot(z.segment(h.w.size(), h.w.size()));
}

} // namespace

template <class T>
int steps_for(const T& fastest) {
    return std::clamp(static_cast<int>(16 * fastest), 96, 4096);
}

template <class T>
LinearHalfPeriod<T> linear_half_period(HalfPeriodProblem<T> p, int steps) {
    p.beta = T(1);
    const Index N = p.M.rows();
    LinearHalfPeriod<T> h{augmented_system(p), {}, {}, contact_vector(p)};
    const Matrix<T> step = matrix_exponential(Matrix<T>(h.A * T(pi<T>() / steps)));
    const Matrix<T> half = matrix_exponential(Matrix<T>(h.A * pi<T>()));
    const Eigen::FullPivLU<Matrix<T>> mirrored(half.topLeftCorner(2 * N, 2 * N) + Matrix<T>::Identity(2 * N, 2 * N));
    h.Y = mirrored.solve(Matrix<T>(-half.topRightCorner(2 * N, 3)));
    h.f.resize(2 * N + 3, steps + 1);
    h.f.col(0) << h.Y.col(2), T(0), T(0), T(1);
    for (Index n = 0; n < steps; ++n) h.f.col(n + 1) = step * h.f.col(n);
    return h;
}

template <class T>
Vector<T> moved(const Matrix<T>& A, const Vector<T>& z, const T& dt) {
    using std::abs;
    T norm(0);
    for (Index i = 0; i < A.rows(); ++i) norm = std::max(norm, T(A.row(i).cwiseAbs().sum()));
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

template <class T>
T U_of(const LinearHalfPeriod<T>& h, const Vector<T>& x) {
    return -x.dot(h.Y.col(2).tail(x.size()));
}

template <class T>
T G_of(const LinearHalfPeriod<T>& h, const Vector<T>& x) {
    return -x.dot(h.Y.col(2).head(x.size()));
}

template <class T>
T acceleration_at_start(const LinearHalfPeriod<T>& h) {
    return velocity_of_contact(h, Vector<T>(h.A * h.f.col(0)));
}

template <class T>
T largest_demand(const LinearHalfPeriod<T>& h) {
    using std::abs;
    const Index steps = h.f.cols() - 1;
    const T U = U_of(h, h.w), spacing = pi<T>() / static_cast<int>(steps);
    const auto demand = [&](const T& velocity, const T& tau) { return T((U * cos(tau) + velocity) / sin(tau)); };
    T largest = acceleration_at_start(h);
    Index best = 0;
    T largest_inside = largest;
    for (Index n = 1; n < steps; ++n) {
        const T value = demand(velocity_of_contact(h, Vector<T>(h.f.col(n))), T(spacing * static_cast<int>(n)));
        if (best > 0 && value <= largest_inside) continue;
        best = n;
        largest_inside = value;
    }
    largest = std::max(largest, T(-velocity_of_contact(h, Vector<T>(h.A * h.f.col(steps)))));
    // Newton's method on the derivative times sin^2: x_j'' sin - x_j' cos - U, whose own derivative is (x_j''' + x_j') sin.
    T tau = spacing * static_cast<int>(best);
    const T start = tau;
    for (int n = 0; n < 200; ++n) {
        const Vector<T> z = moved(h.A, Vector<T>(h.f.col(best)), T(tau - start));
        const Vector<T> rate = h.A * z, second = h.A * rate;
        const T v = velocity_of_contact(h, z);
        largest_inside = demand(v, tau);
        const T w = velocity_of_contact(h, rate) * sin(tau) - v * cos(tau) - U,
                w_prime = (velocity_of_contact(h, second) + v) * sin(tau);
        const T change = std::clamp(T(-w / w_prime), T(-spacing / 4), T(spacing / 4));
        tau += change;
        if (abs(T(tau - start)) > 2 * spacing || !(tau > spacing / 1024)) return largest; // nothing but the start
        if (abs(change) < std::numeric_limits<T>::epsilon() * 1024) break;
    }
    return std::max(largest, largest_inside);
}

template <class T>
FurthestPlace<T> furthest_turn(const Matrix<T>& A, const Vector<T>& z, const Vector<T>& row, const T& length, int samples) {
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

template int steps_for(const Real50&);
template int steps_for(const Real100&);
template LinearHalfPeriod<Real50> linear_half_period(HalfPeriodProblem<Real50>, int);
template LinearHalfPeriod<Real100> linear_half_period(HalfPeriodProblem<Real100>, int);
template Vector<Real50> moved(const Matrix<Real50>&, const Vector<Real50>&, const Real50&);
template Vector<Real100> moved(const Matrix<Real100>&, const Vector<Real100>&, const Real100&);
template Real50 U_of(const LinearHalfPeriod<Real50>&, const Vector<Real50>&);
template Real100 U_of(const LinearHalfPeriod<Real100>&, const Vector<Real100>&);
template Real50 G_of(const LinearHalfPeriod<Real50>&, const Vector<Real50>&);
template Real100 G_of(const LinearHalfPeriod<Real100>&, const Vector<Real100>&);
template Real50 acceleration_at_start(const LinearHalfPeriod<Real50>&);
template Real100 acceleration_at_start(const LinearHalfPeriod<Real100>&);
template Real50 largest_demand(const LinearHalfPeriod<Real50>&);
template Real100 largest_demand(const LinearHalfPeriod<Real100>&);
template FurthestPlace<Real50> furthest_turn(const Matrix<Real50>&, const Vector<Real50>&, const Vector<Real50>&, const Real50&,
                                             int);
template FurthestPlace<Real100> furthest_turn(const Matrix<Real100>&, const Vector<Real100>&, const Vector<Real100>&,
                                              const Real100&, int);

} // namespace denhartog::conformance::generator
