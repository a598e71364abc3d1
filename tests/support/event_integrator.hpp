/// @file
/// @brief The motion of (6) with stops by Taylor's series of its state: no modes, no closed form, no search of the library.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "tests/support/contact_phase.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::tests {

/// @brief A motion over some periods of the force.
template <class T>
struct FollowedMotion {
    Vector<T> x;                         ///< displacements at the end
    Vector<T> x_prime;                   ///< velocities at the end
    Vector<T> amplitude;                 ///< largest displacement of each mass, where it is asked for
    std::vector<std::array<T, 2>> stops; ///< start and end of each rest that ends within the motion
};

/// @brief Follows a motion from tau = 0.
///
/// The step in which the contact comes to rest, or the load on it leaves what static friction can hold, is cut short by bisection;
/// so is that in which a velocity changes its sign, for the largest displacement.
template <class T>
class EventIntegrator {
public:
    /// @brief Of a problem. @param problem (6) @param holds mu beta @param steps_a_period equal steps
    EventIntegrator(const HalfPeriodProblem<T>& problem, const T& holds, int steps_a_period)
        : p_(problem), holds_(holds), h_(2 * pi<T>() / steps_a_period), N_(p_.M.rows()), w_(contact_vector(p_)),
          load_(-end_of_phase(p_, holds_, 0, 0)) {
        for (const int direction : {-1, 0, 1}) {
            kinds_[index(direction)] = system_of_phase(p_, direction);
            step_[index(direction)] = matrix_exponential(Matrix<T>(kinds_[index(direction)] * h_));
        }
    }

    /// @brief The motion over so many steps from a state. @param x displacements @param x_prime velocities @param steps how many
    FollowedMotion<T> follow(const Vector<T>& x, const Vector<T>& x_prime, int steps) {
        start(x, x_prime);
        motion_.amplitude = x.cwiseAbs();
        return go_on(steps);
    }

    /// @brief Starts a motion whose amplitudes are not asked for. @param x displacements @param x_prime velocities
    void start(const Vector<T>& x, const Vector<T>& x_prime) {
        z_.resize(2 * N_ + 3);
        z_ << x, x_prime, T(1), T(0), T(1);
        motion_ = {};
        tau_ = rest_from_ = T(0);
        const T v = w_.dot(x_prime);
        direction_ = v > tiny() ? 1 : v < -tiny() ? -1 : beyond(z_);
    }

    /// @brief The motion from its start on, so many steps later than before. @param steps how many
    const FollowedMotion<T>& go_on(int steps) {
        for (int n = 0; n < steps; ++n)
            for (T left = h_; left > T(0);) left -= advance(left, left == h_);
        motion_.x = z_.head(N_);
        motion_.x_prime = z_.segment(N_, N_);
        return motion_;
    }

private:
    static T tiny() { return Eigen::NumTraits<T>::epsilon() * 1024; }
    static std::size_t index(int direction) { return static_cast<std::size_t>(direction + 1); }

    // The side to which the load on a contact at rest is beyond what friction holds, or 0.
    int beyond(const Vector<T>& z) const {
        const T load = load_.dot(z); // of all forces but friction
        return load > holds_ ? 1 : load < -holds_ ? -1 : 0;
    }

    bool is_over(const Vector<T>& z) const {
        if (direction_ != 0) return w_.dot(z.segment(N_, N_)) * direction_ < T(0);
        return beyond(z) != 0;
    }

    Vector<T> after(const Vector<T>& z, const T& t) const {
        using std::abs;
        const Matrix<T>& A = kinds_[index(direction_)];
        Vector<T> term = z, sum = z;
        for (int k = 1; term.cwiseAbs().maxCoeff() > tiny() / 1048576 && k < 200; ++k) {
            term = Vector<T>(A * term) * T(t / k);
            sum += term;
        }
        return sum;
    }

    // The last instant of a stretch, by bisection, before a condition holds; the condition holds at its end.
    template <class Condition>
    T last_before(const Vector<T>& from, const T& length, int halvings, const Condition& holds) const {
        T low(0), high = length;
        for (int n = 0; n < halvings; ++n) {
            const T middle = (low + high) / 2;
            (holds(after(from, middle)) ? high : low) = middle;
        }
        return low;
    }

    void take_extrema(const Vector<T>& from, const Vector<T>& to, const T& length) {
        using std::abs;
        for (Eigen::Index k = 0; k < motion_.amplitude.size(); ++k) {
            motion_.amplitude(k) = std::max<T>(motion_.amplitude(k), abs(to(k)));
            const T v = from(N_ + k);
            if (!(v * to(N_ + k) < T(0))) continue;
            const T turn = last_before(from, length, 40, [&](const Vector<T>& z) { return z(N_ + k) * v < T(0); });
            motion_.amplitude(k) = std::max<T>(motion_.amplitude(k), abs(after(from, turn)(k)));
        }
    }

    // Goes on by the stretch, or as far as the phase lasts; returns how far.
    T advance(T length, bool whole) {
        const Vector<T> from = z_;
        z_ = whole ? Vector<T>(step_[index(direction_)] * from) : after(from, length);
        const bool over = is_over(z_);
        if (over) {
            length = last_before(from, length, 110, [&](const Vector<T>& z) { return is_over(z); });
            z_ = after(from, length);
        }
        take_extrema(from, z_, length);
        tau_ += length;
        if (!over) return length;
        if (direction_ != 0) {
            direction_ = beyond(z_);
            if (direction_ == 0) rest_from_ = tau_;
        } else {
            motion_.stops.push_back({rest_from_, tau_});
            direction_ = load_.dot(z_) > T(0) ? 1 : -1;
        }
        return std::max<T>(length, h_ * tiny());
    }

    HalfPeriodProblem<T> p_;
    T holds_, h_;
    Eigen::Index N_;
    Vector<T> w_;
    StateRow<T> load_;
    std::array<Matrix<T>, 3> kinds_, step_;
    Vector<T> z_;
    T tau_{}, rest_from_{};
    int direction_ = 0;
    FollowedMotion<T> motion_;
};

} // namespace denhartog::tests
