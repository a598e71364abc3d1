#include "tests/speed_accuracy/peers/peers.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "denhartog/number/number.hpp"
#include "tests/speed_accuracy/peers/contact_receptance.hpp"

namespace denhartog::tests {
namespace {

using Complex = std::complex<double>;
using Vector = Eigen::VectorXd; // harmonics: H real parts, then H imaginary parts
using Signal = Eigen::ArrayXd;  // at equal instants of half a period, from 0

/// Between odd harmonics and instants. The signal is the real part of the sum of X_n e^(i n tau).
struct Transform {
    Eigen::Index H;
    Vector n;                     // the odd harmonics
    Eigen::MatrixXd odd;          // instants by 2H: cosines, minus sines
    Eigen::MatrixXd cosine, sine; // instants by even harmonics 0, 2, ... 2 highest

    Transform(int highest, int samples)
        : H((highest + 1) / 2), n(H), odd(samples, 2 * H), cosine(samples, highest + 1), sine(samples, highest + 1) {
        for (Eigen::Index k = 0; k < H; ++k) n(k) = static_cast<double>(2 * k + 1);
        for (int s = 0; s < samples; ++s) {
            const double tau = pi<double>() * s / samples;
            for (Eigen::Index k = 0; k < H; ++k) {
                odd(s, k) = std::cos(n(k) * tau);
                odd(s, H + k) = -std::sin(n(k) * tau);
            }
            for (int k = 0; k <= highest; ++k) {
                cosine(s, k) = std::cos(2 * k * tau);
                sine(s, k) = std::sin(2 * k * tau);
            }
        }
    }
    [[nodiscard]] Signal in_time(const Vector& X) const { return (odd * X).array(); }
    [[nodiscard]] Vector harmonics(const Signal& x) const {
        return 2 / static_cast<double>(x.size()) * (odd.transpose() * x.matrix());
    }
    /// Harmonics of d(tau) times a signal, as a matrix on those of the signal: d has even harmonics alone.
    [[nodiscard]] Eigen::MatrixXd product(const Signal& d) const {
        const double scale = 1 / static_cast<double>(d.size());
        const Vector c = scale * (cosine.transpose() * d.matrix()), s = scale * (sine.transpose() * d.matrix());
        Eigen::MatrixXd P(2 * H, 2 * H);
        for (Eigen::Index a = 0; a < H; ++a)
            for (Eigen::Index b = 0; b < H; ++b) {
                const Eigen::Index m = std::abs(a - b), p = a + b + 1;
                const double s_m = a >= b ? s(m) : -s(m);
                P(a, b) = c(m) + c(p);
                P(a, H + b) = s_m - s(p);
                P(H + a, b) = -s_m - s(p);
                P(H + a, H + b) = c(m) - c(p);
            }
        return P;
    }
};

/// One point: receptances, the law, and Newton's method on the harmonics of friction.
class Balance {
public:
    Balance(const ContactReceptance& system, const Transform& transform, FrictionLaw law, const ChartPoint& at)
        : transform_(transform), law_(law), beta_(at.beta), h_(transform.H), load_(system.of_load(at.r)),
          compliance_(system.compliance(at.r)) {
        for (Eigen::Index k = 0; k < transform.H; ++k) h_(k) = system.of_friction(2 * static_cast<int>(k) + 1, at.r);
    }

    /// Velocity of the contact without friction.
    [[nodiscard]] double free_velocity() const { return std::abs(load_); }

    /// Unit of the width of the law: the velocity of the first harmonic, or a small one if friction holds the contact.
    [[nodiscard]] double velocity_of_width() const {
        const double least = law_ == FrictionLaw::regularised ? 1e-3 : 1e-1; // creep falls with it; exact friction has none
        return std::max(std::abs(displacement(lambda_)(0)), least * free_velocity());
    }

    /// True if the receptances are finite: without damping they are not if a harmonic of the force is a natural frequency.
    [[nodiscard]] bool finite() const { return h_.allFinite() && std::isfinite(free_velocity()); }

    /// Back to no friction.
    void start() { lambda_.setZero(); }

    /// Newton's method with halved steps at a width of the law; whether it converged.
    bool solve(double width, double tolerance) {
        Law f = friction(lambda_, width);
        for (int step = 0; step < most_steps; ++step) {
            const double size = f.residual.norm();
            if (!std::isfinite(size)) return false;
            if (size <= tolerance * beta_) return true;
            ++steps_;
            const Vector move = jacobian(f).partialPivLu().solve(f.residual);
            const Vector from = lambda_;
            double part = 1;
            do {
                lambda_ = from - part * move;
                f = friction(lambda_, width);
                part /= 2;
            } while (!(f.residual.norm() < size) && part > 1e-4);
        }
        return false;
    }

    /// X_j: the largest displacement at the instants, then where its velocity is zero.
    [[nodiscard]] double largest_displacement() const {
        const Signal x = transform_.in_time(pack(displacement(lambda_)));
        Eigen::Index s = 0;
        double largest = x.abs().maxCoeff(&s);
        const double spacing = pi<double>() / static_cast<double>(x.size());
        const double from = static_cast<double>(s - 1) * spacing, to = static_cast<double>(s + 1) * spacing;
        const Eigen::VectorXcd X = displacement(lambda_);
        double tau = static_cast<double>(s) * spacing;
        for (int step = 0; step < 8; ++step) {
            Complex x0 = 0, x1 = 0, x2 = 0;
            for (Eigen::Index k = 0; k < X.size(); ++k) {
                const Complex each = X(k) * std::polar(1.0, transform_.n(k) * tau);
                x0 += each;
                x1 += Complex(0, transform_.n(k)) * each;
                x2 -= transform_.n(k) * transform_.n(k) * each;
            }
            largest = std::max(largest, std::abs(x0.real()));
            if (x2.real() != 0) tau = std::clamp(tau - x1.real() / x2.real(), from, to);
        }
        return largest;
    }

    /// x_j at an instant.
    [[nodiscard]] std::function<double(double)> motion() const {
        return [X = displacement(lambda_), n = transform_.n](double tau) {
            double x = 0;
            for (Eigen::Index k = 0; k < X.size(); ++k) x += (X(k) * std::polar(1.0, n(k) * tau)).real();
            return x;
        };
    }

    /// True if the contact rests: when its velocity is zero, the force on it without friction is less than the largest friction.
    [[nodiscard]] bool rests() const {
        const Eigen::VectorXcd X = displacement(lambda_);
        if (X.norm() <= at_rest * free_velocity()) return true;
        const Signal v = transform_.in_time(velocity(lambda_));
        const Signal a = transform_.in_time(compliance_ * lambda_ + pack(-transform_.n.cwiseAbs2().cwiseProduct(X)));
        for (Eigen::Index s = 0; s < v.size(); ++s) {
            const bool last = s + 1 == v.size();
            const double v_next = last ? -v(0) : v(s + 1), a_next = last ? -a(0) : a(s + 1);
            if (v(s) * v_next > 0) continue;
            if (std::abs(a(s) + (a_next - a(s)) * v(s) / (v(s) - v_next)) < compliance_ * beta_) return true;
        }
        return false;
    }

    [[nodiscard]] long steps() const { return steps_; }

private:
    static constexpr int most_steps = 100;
    static constexpr double at_rest = 1e-9;

    struct Law {
        Signal by_lambda, by_v; // derivatives of friction in time
        Vector residual;        // lambda minus the harmonics of friction
    };

    static Vector pack(const Eigen::VectorXcd& X) {
        Vector packed(2 * X.size());
        packed << X.real(), X.imag();
        return packed;
    }
    [[nodiscard]] Eigen::VectorXcd displacement(const Vector& lambda) const {
        Eigen::VectorXcd X(h_.size());
        for (Eigen::Index k = 0; k < h_.size(); ++k) X(k) = -h_(k) * Complex(lambda(k), lambda(h_.size() + k));
        X(0) += load_;
        return X;
    }
    [[nodiscard]] Vector velocity(const Vector& lambda) const {
        return pack(Complex(0, 1) * transform_.n.cwiseProduct(displacement(lambda)));
    }
    [[nodiscard]] Law friction(const Vector& lambda, double width) const {
        const Signal v = transform_.in_time(velocity(lambda));
        const double slope = beta_ / width;
        if (law_ == FrictionLaw::regularised) {
            const Signal t = (v / width).tanh();
            return {Signal::Zero(v.size()), slope * (1 - t.square()), lambda - transform_.harmonics(beta_ * t)};
        }
        const Signal trial = transform_.in_time(lambda) + slope * v;
        const Signal rests = (trial.abs() < beta_).cast<double>();
        return {rests, slope * rests, lambda - transform_.harmonics(trial.max(-beta_).min(beta_))};
    }
    [[nodiscard]] Eigen::MatrixXd jacobian(const Law& f) const {
        const Eigen::Index H = h_.size();
        Eigen::MatrixXd J = Eigen::MatrixXd::Identity(2 * H, 2 * H);
        if (law_ == FrictionLaw::augmented_lagrangian) J -= transform_.product(f.by_lambda);
        const Eigen::MatrixXd P = transform_.product(f.by_v);
        for (Eigen::Index k = 0; k < H; ++k) {
            const Complex by_lambda = Complex(0, -transform_.n(k)) * h_(k); // velocity by friction
            J.col(k) -= P.col(k) * by_lambda.real() + P.col(H + k) * by_lambda.imag();
            J.col(H + k) -= P.col(H + k) * by_lambda.real() - P.col(k) * by_lambda.imag();
        }
        return J;
    }

    const Transform& transform_;
    FrictionLaw law_;
    double beta_;
    Eigen::VectorXcd h_;
    Complex load_;
    double compliance_;
    Vector lambda_ = Vector::Zero(2 * h_.size());
    long steps_ = 0;
};

/// From a law so wide that the problem is almost linear to the width asked for; again by smaller steps where that fails.
PeerAnswer answer(const ContactReceptance& system, const Transform& transform, const HarmonicBalanceSetting& setting,
                  const ChartPoint& at) {
    constexpr double on_the_way = 1e-2, at_the_end = 1e-8;
    Balance balance(system, transform, setting.law, at);
    PeerAnswer found;
    if (!balance.finite()) {
        found.ending = Ending::not_a_number;
        return found;
    }
    const auto narrowest = [&] { return balance.velocity_of_width() / (setting.highest * setting.sharpness); };
    bool converged = false;
    for (const double narrowing : {4.0, 1.5}) {
        if (converged) break;
        balance.start();
        for (double width = balance.free_velocity() / narrowing; width > narrowest(); width /= narrowing)
            (void)balance.solve(width, on_the_way);
        converged = balance.solve(narrowest(), at_the_end);
    }
    found.evaluations = balance.steps();
    if (!converged) {
        found.ending = Ending::did_not_finish;
        return found;
    }
    found.amplitude = balance.largest_displacement();
    found.sticks = balance.rests();
    found.motion = balance.motion();
    return found;
}

} // namespace

Peer harmonic_balance(const HarmonicBalanceSetting& setting) {
    // In half a period: so many that the width of the law is resolved, and what aliases is below what the harmonics leave out.
    constexpr double samples_a_width = 1.6, fewest_samples = 128;
    const int samples = static_cast<int>(std::max(fewest_samples, samples_a_width * setting.highest * setting.sharpness));
    return {setting.law == FrictionLaw::regularised ? "harmonic balance, regularised" : "harmonic balance, augmented Lagrangian",
            std::to_string(setting.highest) + (setting.highest == 1 ? " harmonic" : " harmonics"), 0,
            [setting, samples](const System<double>& s) {
                return [system = ContactReceptance(s), transform = Transform(setting.highest, samples),
                        setting](const ChartPoint& at) { return answer(system, transform, setting, at); };
            }};
}

std::vector<Peer> harmonic_balance_peers() {
    std::vector<Peer> peers;
    for (const FrictionLaw law : {FrictionLaw::regularised, FrictionLaw::augmented_lagrangian})
        for (const int highest : {1, 3, 5, 11, 21, 51, 101}) peers.push_back(harmonic_balance({law, highest}));
    return peers;
}

} // namespace denhartog::tests
