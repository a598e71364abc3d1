/// @file
/// @brief One linear stretch of motion in modal coordinates:
/// \f$ q_i'' + \sum_m D_{im} q_m' + \omega_i^2 q_i = F_i\cos\tau + G_i \f$.
///
/// Where D is diagonal each coordinate has its closed form, overdamped ones that of `evaluation/overdamped.hpp`. Where it is
/// not, which happens only while the contact sticks, the Taylor series of the coordinates is summed to rounding from nodes that
/// are one over the largest rate apart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "denhartog/evaluation/overdamped.hpp"
#include "denhartog/formulas/complex.hpp"
#include "denhartog/model/scene.hpp"

namespace denhartog {

/// @brief A linear stretch of motion; the time t counts from its start.
template <class T>
struct LinearMotion {
    static constexpr int orders = 6; ///< derivatives kept: 0 to 5

    std::vector<T> omega_0;               ///< natural frequencies over the frequency of the force
    std::vector<T> gap;                   ///< 1 - omega_0^2
    std::vector<T> decay;                 ///< half the diagonal of D
    Matrix<T> D;                          ///< damping matrix where it is not diagonal, else empty
    std::vector<T> F;                     ///< amplitudes of the harmonic force
    std::vector<T> G;                     ///< constant force
    std::array<std::vector<T>, orders> q; ///< coordinates and derivatives at the instant last evaluated

    /// @brief Sets the number of coordinates. @param n their number
    void resize(std::size_t n) {
        for (std::vector<T>* v : {&omega_0, &gap, &decay, &F, &G, &frequency_, &at_rest_}) v->resize(n);
        for (std::vector<T>* v : {&free_q_, &free_p_, &forced_cos_, &forced_sin_}) v->resize(n);
        for (std::vector<char>* v : {&resonant_, &overdamped_}) v->resize(n);
        for (std::vector<T>& v : q) v.resize(n);
    }

    /// @brief Number of coordinates. @return their number
    [[nodiscard]] std::size_t size() const { return omega_0.size(); }
    /// @brief Whether D couples the coordinates. @return true where it is not diagonal
    [[nodiscard]] bool coupled() const { return D.size() > 0; }

    /// @brief To be called when omega_0, gap, decay, D or F have changed.
    void prepare() {
        using std::abs;
        rate_ = T(1);
        for (std::size_t i = 0; i < size(); ++i) {
            overdamped_[i] = decay[i] >= omega_0[i];
            frequency_[i] = overdamped_[i] ? T(0) : T(sqrt(T((omega_0[i] - decay[i]) * (omega_0[i] + decay[i]))));
            const T distance = gap[i] * gap[i] + 4 * decay[i] * decay[i];
            resonant_[i] = 64 * distance < 1;
            forced_cos_[i] = resonant_[i] ? T(0) : T(-F[i] * gap[i] / distance);
            forced_sin_[i] = resonant_[i] ? T(0) : T(2 * F[i] * decay[i] / distance);
            if (omega_0[i] > rate_) rate_ = omega_0[i];
        }
        if (coupled()) rate_ += D.cwiseAbs().rowwise().sum().maxCoeff();
    }

    /// @brief Starts the stretch from the coordinates and velocities in q[0], q[1].
    /// @param tau  the instant
    void start(const T& tau) {
        tau_0_ = tau;
        cos_0_ = cos(tau);
        sin_0_ = sin(tau);
        differentiated_ = false;
        if (coupled()) {
            nodes_ = 1;
            terms_.clear();
            node_.assign(q[0].begin(), q[0].end());
            node_.insert(node_.end(), q[1].begin(), q[1].end());
            return;
        }
        for (std::size_t i = 0; i < size(); ++i) {
            at_rest_[i] = G[i] / (omega_0[i] * omega_0[i]);
            free_q_[i] = q[0][i] - at_rest_[i] - forced_cos_[i] * cos_0_ - forced_sin_[i] * sin_0_;
            free_p_[i] = q[1][i] + forced_cos_[i] * sin_0_ - forced_sin_[i] * cos_0_;
        }
    }

    /// @brief Coordinates and velocities at an instant, into q[0], q[1]. @param t the time from the start
    void move_to(const T& t) {
        differentiated_ = false;
        const T tau = tau_0_ + t;
        const T c = cos(tau), s = sin(tau);
        cos_tau_ = c;
        sin_tau_ = s;
        if (coupled()) {
            sum_series(t);
            return;
        }
        for (std::size_t i = 0; i < size(); ++i) {
            if (overdamped_[i]) {
                const evaluation::FreeMotion<T> free = free_motion(i, t);
                q[0][i] = at_rest_[i] + forced_cos_[i] * c + forced_sin_[i] * s + free_q_[i] * free.d +
                          free_p_[i] * (free.q / omega_0[i]);
                q[1][i] = forced_sin_[i] * c - forced_cos_[i] * s + free_p_[i] * free.q_prime - omega_0[i] * free_q_[i] * free.q;
                continue;
            }
            const T e = decay[i] > 0 ? T(exp(-decay[i] * t)) : T(1);
            const T angle = frequency_[i] * t;
            const T cosine = cos(angle), sine = sin(angle);
            const T C = e * cosine, S = e * sine / frequency_[i];
            const T w2 = omega_0[i] * omega_0[i];
            q[0][i] =
                at_rest_[i] + forced_cos_[i] * c + forced_sin_[i] * s + free_q_[i] * C + (free_p_[i] + decay[i] * free_q_[i]) * S;
            q[1][i] = forced_sin_[i] * c - forced_cos_[i] * s + free_p_[i] * C - (w2 * free_q_[i] + decay[i] * free_p_[i]) * S;
            if (resonant_[i]) add_resonant_force(i, t, C, S);
        }
    }

    /// @brief All derivatives at an instant. @param t the time from the start
    void differentiate_at(const T& t) {
        if (differentiated_ && t == at_) return;
        move_to(t);
        differentiated_ = true;
        at_ = t;
        const std::array<T, 4> wave{cos_tau_, T(-sin_tau_), T(-cos_tau_), sin_tau_};
        for (int m = 0; m + 2 < orders; ++m) {
            for (std::size_t i = 0; i < size(); ++i) {
                T damping(0);
                if (coupled())
                    for (std::size_t n = 0; n < size(); ++n) damping += D(i, n) * q[m + 1][n];
                else
                    damping = 2 * decay[i] * q[m + 1][i];
                q[m + 2][i] = F[i] * wave[m] + (m == 0 ? G[i] : T(0)) - damping - omega_0[i] * omega_0[i] * q[m][i];
            }
        }
    }

    /// @brief Cosine of tau at the instant last evaluated. @return cos tau
    [[nodiscard]] const T& cos_tau() const { return cos_tau_; }
    /// @brief Sine of tau at the instant last evaluated. @return sin tau
    [[nodiscard]] const T& sin_tau() const { return sin_tau_; }

    /// @brief Energy norm of derivative m and its velocity at the instant last evaluated: it grows by |F| a unit of time at most.
    /// @param m  order, at most 4
    /// @return   sqrt(sum q^(m+1)^2 + omega_0^2 q^(m)^2)
    [[nodiscard]] T energy_norm(int m) const {
        T sum(0);
        for (std::size_t i = 0; i < size(); ++i) sum += energy(m, i);
        return sqrt(sum);
    }

    /// @brief The same of one coordinate where D is diagonal. @param m order, at most 4 @param i coordinate @return the norm
    [[nodiscard]] T energy_norm(int m, std::size_t i) const { return sqrt(energy(m, i)); }

    /// @brief Carries deviations over a time: columns of dq and dp, free of force.
    /// @param t   the time
    /// @param dq  deviations of the coordinates, coordinate by column
    /// @param dp  deviations of the velocities
    void carry(const T& t, Matrix<T>& dq, Matrix<T>& dp) {
        if (coupled()) {
            carry_coupled(t, dq, dp);
            return;
        }
        for (std::size_t i = 0; i < size(); ++i) {
            if (overdamped_[i]) {
                const evaluation::FreeMotion<T> free = free_motion(i, t);
                for (Eigen::Index c = 0; c < dq.cols(); ++c) {
                    const T x = dq(i, c), v = dp(i, c);
                    dq(i, c) = x * free.d + v * (free.q / omega_0[i]);
                    dp(i, c) = v * free.q_prime - omega_0[i] * x * free.q;
                }
                continue;
            }
            const T e = exp(-decay[i] * t);
            const T C = e * cos(T(frequency_[i] * t)), S = e * sin(T(frequency_[i] * t)) / frequency_[i];
            for (Eigen::Index c = 0; c < dq.cols(); ++c) {
                const T x = dq(i, c), v = dp(i, c);
                dq(i, c) = x * C + (v + decay[i] * x) * S;
                dp(i, c) = v * C - (omega_0[i] * omega_0[i] * x + decay[i] * v) * S;
            }
        }
    }

private:
    [[nodiscard]] T energy(int m, std::size_t i) const {
        const T y = omega_0[i] * q[m][i];
        return q[m + 1][i] * q[m + 1][i] + y * y;
    }

    // Of an overdamped coordinate, in its own time.
    [[nodiscard]] evaluation::FreeMotion<T> free_motion(std::size_t i, const T& t) const {
        return evaluation::overdamped_free_motion(T(omega_0[i] * t), T(decay[i] / omega_0[i]));
    }

    // Near resonance the harmonic and the free part are large and cancel. Their sum, the response from rest, does not: with
    // lambda = -decay + i frequency it is Re e^{i tau_0} (E_1 - E_2) / (2 i frequency), where
    // E_1 = (e^{it} - e^{lambda t}) / (i - lambda) = e^{lambda t} (e^{(i - lambda) t} - 1) / (i - lambda), and E_2 is the same
    // with the conjugate of lambda.
    void add_resonant_force(std::size_t i, const T& t, const T& C, const T& S) {
        using std::expm1;
        const T& a = decay[i];
        const T& b = frequency_[i];
        const T detuning = (gap[i] + a * a) / (1 + b); // 1 - b
        const T x = a * t, y = detuning * t;
        const T sin_half = sin(T(y / 2));
        const T e = expm1(x);
        const Complex<T> grown{e * cos(y) - 2 * sin_half * sin_half, (e + 1) * sin(y)};
        const Complex<T> free{C, S * b}; // e^{lambda t}
        const T nothing = std::numeric_limits<T>::epsilon() / 4;
        Complex<T> E_1 = x * x + y * y < nothing * nothing ? Complex<T>{t, T(0)} : quotient(grown, Complex<T>{a, detuning});
        E_1 = product(free, E_1);
        const T cos_t = cos_tau_ * cos_0_ + sin_tau_ * sin_0_, sin_t = sin_tau_ * cos_0_ - cos_tau_ * sin_0_;
        const Complex<T> E_2 = quotient(Complex<T>{cos_t - free.re, sin_t + free.im}, Complex<T>{a, 1 + b});
        const Complex<T> start{cos_0_, sin_0_};
        const Complex<T> h{E_1.re - E_2.re, E_1.im - E_2.im};
        const Complex<T> h_prime{-a * h.re - b * (E_1.im + E_2.im), -a * h.im + b * (E_1.re + E_2.re)};
        // Re of z / (2 i b) is Im z / (2 b).
        q[0][i] += F[i] * product(start, h).im / (2 * b);
        q[1][i] += F[i] * product(start, h_prime).im / (2 * b);
    }

    static Complex<T> product(const Complex<T>& a, const Complex<T>& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    static Complex<T> quotient(const Complex<T>& a, const Complex<T>& b) {
        const T size = squared_modulus(b);
        return {(a.re * b.re + a.im * b.im) / size, (a.im * b.re - a.re * b.im) / size};
    }

    void sum_series(const T& t) {
        const T width = 1 / rate_;
        const std::size_t n = static_cast<std::size_t>(static_cast<double>(T(t / width)));
        for (; nodes_ <= n; ++nodes_) {
            expand(nodes_ - 1, width);
            sum_terms(nodes_ - 1, T(1), width);
            node_.insert(node_.end(), q[0].begin(), q[0].end());
            node_.insert(node_.end(), q[1].begin(), q[1].end());
        }
        expand(n, width);
        sum_terms(n, T((t - static_cast<int>(n) * width) / width), width);
    }

    // Terms u_k = q^(k) width^k / k! from the node at t = index / rate, until two in a row are nothing beside the sum.
    void expand(std::size_t index, const T& width) {
        using std::abs;
        if (terms_.size() > index) return;
        const std::size_t n = size();
        const T tau = tau_0_ + static_cast<int>(index) / rate_;
        const T c = cos(tau), w = sin(tau);
        const std::array<T, 4> wave{c, T(-w), T(-c), w};
        std::vector<T>& u = terms_.emplace_back(2 * n);
        T reference(0);
        for (std::size_t i = 0; i < n; ++i) {
            u[i] = node_[2 * n * index + i];
            u[n + i] = node_[2 * n * index + n + i] * width;
            reference = std::max({reference, T(abs(u[i])), T(abs(u[n + i])), T(abs(F[i] * width * width))});
        }
        T power(1); // width^k / k!
        bool small_before = false;
        for (int k = 0; k < most_terms; ++k) {
            const std::size_t at = static_cast<std::size_t>(k) * n;
            T largest(0);
            for (std::size_t i = 0; i < n; ++i) {
                T damping(0);
                for (std::size_t m = 0; m < n; ++m) damping += D(i, m) * u[at + n + m];
                const T force = power * (F[i] * wave[k % 4] + (k == 0 ? G[i] : T(0)));
                const T w2 = omega_0[i] * omega_0[i];
                const T next = (width * width * (force - w2 * u[at + i]) / (k + 1) - width * damping) / (k + 2);
                u.push_back(next);
                largest = std::max(largest, T(abs(next)));
            }
            power *= width / (k + 1);
            const bool small = (k + 2) * largest <= std::numeric_limits<T>::epsilon() * reference / 8;
            if (small && small_before) return;
            small_before = small;
        }
    }

    // The series from a node at a fraction of the way to the next, by Horner's rule.
    void sum_terms(std::size_t index, const T& fraction, const T& width) {
        const std::vector<T>& u = terms_[index];
        const std::size_t n = size(), last = u.size() / n - 1;
        for (std::size_t i = 0; i < n; ++i) {
            T x = u[last * n + i], v = static_cast<int>(last) * u[last * n + i];
            for (std::size_t k = last - 1; k >= 1; --k) {
                x = x * fraction + u[k * n + i];
                v = v * fraction + static_cast<int>(k) * u[k * n + i];
            }
            q[0][i] = x * fraction + u[i];
            q[1][i] = v / width;
        }
    }

    // The propagator of a part short enough for the series, squared until it spans the time; velocities over the largest rate.
    void carry_coupled(const T& t, Matrix<T>& dq, Matrix<T>& dp) {
        const auto n = static_cast<Eigen::Index>(size());
        int squarings = 0;
        T part = t;
        for (; part * rate_ > 1; part /= 2) ++squarings;
        Matrix<T> q_part = Matrix<T>::Zero(n, 2 * n), p_part = Matrix<T>::Zero(n, 2 * n);
        for (Eigen::Index i = 0; i < n; ++i) {
            q_part(i, i) = T(1);
            p_part(i, n + i) = rate_;
        }
        if (part > 0) carry_by_series(part, q_part, p_part);
        Matrix<T> propagator(2 * n, 2 * n), deviations(2 * n, dq.cols());
        propagator << q_part, p_part / rate_;
        for (; squarings > 0; --squarings) propagator = propagator * propagator;
        deviations << dq, dp / rate_;
        deviations = propagator * deviations;
        dq = deviations.topRows(n);
        dp = deviations.bottomRows(n) * rate_;
    }

    void carry_by_series(const T& s, Matrix<T>& dq, Matrix<T>& dp) {
        Matrix<T> u = dq, v = dp * s;
        Matrix<T> square(size(), size());
        square.setZero();
        for (std::size_t i = 0; i < size(); ++i) square(i, i) = omega_0[i] * omega_0[i];
        dq += v;
        bool small_before = false;
        for (int k = 0; k < 200; ++k) {
            const Matrix<T> next = (-(s * s / (k + 1)) * (square * u) - s * (D * v)) / T(k + 2);
            dq += next;
            dp += next * (T(k + 2) / s);
            u = v;
            v = next;
            const T reference = dq.cwiseAbs().maxCoeff() + s * dp.cwiseAbs().maxCoeff();
            const bool small = v.cwiseAbs().maxCoeff() * (k + 2) <= std::numeric_limits<T>::epsilon() * reference / 8;
            if (small && small_before) return;
            small_before = small;
        }
    }

    T tau_0_, cos_0_, sin_0_, cos_tau_, sin_tau_;
    bool differentiated_ = false; // whether q holds all derivatives, at the instant at_
    T at_;
    T rate_ = T(1);                          // no rate of the motion is faster
    std::vector<T> frequency_, at_rest_;     // damped frequencies; where the constant force would hold them
    std::vector<T> free_q_, free_p_;         // the free part at the start
    std::vector<T> forced_cos_, forced_sin_; // the harmonic part
    std::vector<char> resonant_;             // harmonic and free part are taken together
    std::vector<char> overdamped_;           // no oscillation: decay is omega_0 or more
    std::size_t nodes_ = 0;                  // nodes known so far
    std::vector<T> node_;                    // their coordinates and velocities
    std::vector<std::vector<T>> terms_;      // the terms of the series from each node, term by coordinate
    static constexpr int most_terms = 200;
};

} // namespace denhartog
