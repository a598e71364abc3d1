// The motion from rest on the physical coordinates, phase by phase: matrix exponentials in 50 digits, and no modes.
#include <algorithm>
#include <array>

#include "denhartog/number/errors.hpp"
#include "tests/benchmark/generator/motion.hpp"
#include "tests/support/contact_phase.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::benchmark {
namespace {

using Index = Eigen::Index;
using Number = Real50;
using std::abs;

constexpr int most_periods = 20000;
constexpr int steps = 128; // a period: no phase of the scenes that ends in one and starts another is shorter

class FollowedFromRest {
public:
    explicit FollowedFromRest(const Scene<double>& scene)
        : p_(half_period_problem(scene)), N_(p_.M.rows()), j_(static_cast<Index>(p_.contact.index)),
          holds_(Number(scene.mu) * p_.beta), load_(end_of_phase(p_, Number(0), 0, 0)), z_(Vector<Number>::Zero(2 * N_ + 3)) {
        for (const int direction : {-1, 0, 1}) {
            Kind& kind = kinds_[static_cast<std::size_t>(direction + 1)];
            kind.A = system_of_phase(p_, direction);
            kind.step = matrix_exponential(Matrix<Number>(kind.A * h_));
        }
        z_(2 * N_) = z_(2 * N_ + 2) = Number(1);
        start_from_rest();
    }

    // Follows a period of the force; displacements, then velocities.
    Vector<Number> next_period() {
        for (int n = 0; n < steps; ++n) follow_step();
        z_.tail(3) << Number(1), Number(0), Number(1); // where the force is largest again
        return z_.head(2 * N_);
    }

private:
    struct Kind {
        Matrix<Number> A, step;
    };

    [[nodiscard]] const Kind& kind() const { return kinds_[static_cast<std::size_t>(direction_ + 1)]; }
    [[nodiscard]] Number speed(const Vector<Number>& z) const { return direction_ * z(N_ + j_); }
    [[nodiscard]] Number load(const Vector<Number>& z) const { return -load_.dot(z); } // on the contact, but for friction

    // A number that is positive as long as the phase lasts, and its rate.
    [[nodiscard]] Number left(const Vector<Number>& z) const {
        return direction_ != 0 ? speed(z) : Number(holds_ - abs(load(z)));
    }
    [[nodiscard]] Number rate(const Vector<Number>& z) const {
        const Vector<Number> z_prime = kind().A * z;
        return direction_ != 0 ? speed(z_prime) : Number(load(z) > 0 ? -load(z_prime) : load(z_prime));
    }

    void start_from_rest() {
        z_(N_ + j_) = Number(0);
        const Number pull = load(z_);
        direction_ = pull > holds_ ? 1 : pull < -holds_ ? -1 : 0;
    }

    // Over a step of the grid, with all events in it.
    void follow_step() {
        Number done(0);
        for (int events = 0;; ++events) {
            if (events == 16) throw DomainError("phases of no length follow each other");
            const Number length = h_ - done;
            const Vector<Number> end = done == 0 ? Vector<Number>(kind().step * z_) : moved(z_, length);
            if (left(end) > 0) {
                z_ = end;
                return;
            }
            const Number t = end_within(end, length);
            z_ = moved(z_, t);
            done += t;
            if (direction_ == 0)
                direction_ = load(z_) > 0 ? 1 : -1;
            else
                start_from_rest();
        }
    }

    // Newton's method on what is left, bisection where it leaves the interval.
    [[nodiscard]] Number end_within(const Vector<Number>& end, const Number& length) const {
        Number low(0), high(length), t = length, step = length;
        Vector<Number> z = end;
        for (int n = 0; n < 400 && abs(step) > std::numeric_limits<Number>::epsilon() * 64; ++n) {
            (left(z) > 0 ? low : high) = t;
            const Number next = t - left(z) / rate(z);
            step = (next > low && next < high ? next : Number((low + high) / 2)) - t;
            t += step;
            z = moved(z_, t);
        }
        return t;
    }

    [[nodiscard]] Vector<Number> moved(const Vector<Number>& z, const Number& t) const {
        return matrix_exponential(Matrix<Number>(kind().A * t)) * z;
    }

    HalfPeriodProblem<Number> p_;
    Index N_, j_;
    Number holds_; // mu beta
    Number h_ = 2 * pi<Number>() / steps;
    StateRow<Number> load_;
    std::array<Kind, 3> kinds_; // sliding down, at rest, sliding up
    int direction_ = 0;
    Vector<Number> z_; // x, x', cos tau, sin tau, 1
};

} // namespace

std::vector<int> periods_to_settle(const Scene<double>& scene, const Motion& settled, const std::vector<double>& tolerances) {
    const Sample& end = settled.samples.front();
    const std::size_t N = end.x.size();
    Number largest(0);
    for (std::size_t k = 0; k < N; ++k) largest = std::max({largest, Number(abs(end.x[k])), Number(abs(end.x_prime[k]))});
    if (largest == 0) largest = 1;
    std::vector<int> periods(tolerances.size(), 0);
    std::size_t next = 0;
    FollowedFromRest motion(scene);
    for (int n = 1; n <= most_periods && next < tolerances.size(); ++n) {
        const Vector<Number> z = motion.next_period();
        Number apart(0);
        for (std::size_t k = 0; k < N; ++k)
            apart = std::max({apart, Number(abs(z(static_cast<Index>(k)) - end.x[k])),
                              Number(abs(z(static_cast<Index>(N + k)) - end.x_prime[k]))});
        while (next < tolerances.size() && apart <= tolerances[next] * largest) periods[next++] = n;
    }
    return periods;
}

} // namespace denhartog::benchmark
