/// @file
/// @brief The largest displacement of a mass within a phase, guaranteed between samples.
///
/// Over a step the Taylor polynomial of third order is bounded on both sides by its Bernstein coefficients, the rest by the
/// bound of the fourth derivative. A step that cannot beat the largest known is passed over; one over which the velocity is
/// monotone holds one extremum at most, found as a bracketed root; else the step is halved.
#pragma once

#include <algorithm>

#include "denhartog/stick_slip/linear_motion.hpp"

namespace denhartog {

/// @brief A displacement at an instant: derivatives 0 to 3 and a bound of the fourth, which grows ahead.
template <class T>
struct Displacement {
    std::array<T, 4> f; ///< the displacement and three derivatives
    T bound;            ///< |f''''| is at most bound + growth h over [t, t + h]
    T growth;           ///< see `bound`
};

/// @brief Displacement of a mass at an instant of a stretch.
/// @param motion  the stretch
/// @param phi     mode shapes, mass by coordinate
/// @param row     the mass
/// @param t       time from the start of the stretch
/// @return        the displacement with its bounds
template <class T>
[[nodiscard]] Displacement<T> displacement_at(LinearMotion<T>& motion, const Matrix<T>& phi, std::size_t row, const T& t) {
    using std::abs;
    motion.differentiate_at(t);
    Displacement<T> d{{T(0), T(0), T(0), T(0)}, T(0), T(0)};
    T shapes(0), force(0);
    for (std::size_t i = 0; i < motion.size(); ++i) {
        for (int m = 0; m < 4; ++m) d.f[m] += phi(row, i) * motion.q[m][i];
        if (!motion.coupled()) {
            d.bound += abs(phi(row, i)) * motion.energy_norm(3, i);
            d.growth += abs(phi(row, i) * motion.F[i]);
        }
        shapes += phi(row, i) * phi(row, i);
        force += motion.F[i] * motion.F[i];
    }
    if (motion.coupled()) {
        d.bound = sqrt(shapes) * motion.energy_norm(3);
        d.growth = sqrt(T(shapes * force));
    }
    return d;
}

/// @brief Offers every displacement that may be the largest within a stretch.
/// @param motion  the stretch, started
/// @param phi     mode shapes, mass by coordinate
/// @param row     the mass
/// @param length  length of the stretch
/// @param take    takes a displacement and its time
/// @param best    the largest size known
template <class T, class Take, class Best>
void largest_within(LinearMotion<T>& motion, const Matrix<T>& phi, std::size_t row, const T& length, const Take& take,
                    const Best& best) {
    using std::abs;
    const T eps = std::numeric_limits<T>::epsilon();
    const auto at = [&](const T& t) { return displacement_at(motion, phi, row, t); };
    T t(0), h = length;
    Displacement<T> d = at(t);
    while (t < length) {
        h = std::min(h, T(length - t));
        const std::array<T, 4>& f = d.f;
        const T R = d.bound + d.growth * h;
        const T b1 = f[0] + f[1] * h / 3, b2 = b1 + f[1] * h / 3 + f[2] * h * h / 6;
        const T b3 = f[0] + h * (f[1] + h * (f[2] / 2 + f[3] * h / 6));
        const T reach = std::max({T(abs(f[0])), T(abs(b1)), T(abs(b2)), T(abs(b3))}) + R * h * h * h * h / 24;
        const bool passed_over = reach <= best() * (1 + 2 * eps);
        const T a1 = f[2] + f[3] * h, rest = R * h * h / 2;
        const bool monotone = std::min(f[2], a1) > rest || std::max(f[2], a1) < -rest; // the acceleration keeps its sign
        if (!passed_over && !monotone && h > 16 * eps * (1 + length)) {
            h /= 2;
            continue;
        }
        const T next = t + h < length ? T(t + h) : length;
        const Displacement<T> ahead = at(next);
        take(ahead.f[0], next);
        if (!passed_over && monotone && (f[1] > 0) != (ahead.f[1] > 0)) {
            // Near the extremum the displacement is flat: it is offered at the root alone, else rounding would choose the instant.
            T a = t, b = next, s = abs(f[1]) < abs(ahead.f[1]) ? t : next;
            Displacement<T> here = at(s);
            for (int n = 0; n < 200; ++n) {
                ((here.f[1] > 0) == (f[1] > 0) ? a : b) = s;
                T newton = s - here.f[1] / here.f[2];
                if (!(newton > a && newton < b)) newton = a + (b - a) / 2;
                const bool last = abs(newton - s) <= 4 * eps * (1 + length) || newton == a || newton == b;
                s = newton;
                here = at(s);
                if (last) break;
            }
            take(here.f[0], s);
        }
        t = next;
        d = ahead;
        h *= 2;
    }
}

} // namespace denhartog
