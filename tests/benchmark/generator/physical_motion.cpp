#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "tests/benchmark/generator/motion.hpp"
#include "tests/support/contact_phase.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::benchmark {
namespace {

using Index = Eigen::Index;
using T = Real50;
using std::abs;

// Unknowns: the state (x, x') at the maximum of the force, then the instants of the events. Equations: at each event its
// condition, and after a period the same state again.
class PhysicalMotion {
public:
    PhysicalMotion(const Scene<double>& scene, const Motion& seen)
        : p_(half_period_problem(scene)), N_(p_.M.rows()), j_(static_cast<Index>(p_.contact.index)),
          mu_beta_(T(scene.mu) * p_.beta),
          rests_(seen.rests), directions_{seen.at_start}, A_{system_of_phase(p_, -1), system_of_phase(p_, 0),
                                                             system_of_phase(p_, 1)},
          z_0_(2 * N_ + 3) {
        for (Index k = 0; k < N_; ++k) {
            const auto n = static_cast<std::size_t>(k);
            z_0_(k) = static_cast<double>(seen.samples[0].x[n]);
            z_0_(N_ + k) = static_cast<double>(seen.samples[0].x_prime[n]);
        }
        z_0_.tail(3) << T(1), T(0), T(1);
        for (const Event& e : seen.events) {
            directions_.push_back(e.after);
            ends_.push_back(T(static_cast<double>(e.tau)));
        }
        ends_.push_back(2 * pi<T>());
        const T rest = z_0_(j_);
        for (int n = 0; correct(rest) > std::numeric_limits<T>::epsilon() * 65536; ++n)
            if (n == 30) throw DomainError("Newton's method on the physical coordinates does not converge");
    }

    Motion motion() {
        Motion found;
        found.rests = rests_;
        found.at_start = directions_.front();
        for (Index k = 0; k < N_; ++k) furthest_.push_back({T(0), T(0)});
        Vector<T> z = z_0_;
        T tau(0);
        int sample = 0;
        for (std::size_t n = 0; n < directions_.size(); ++n) {
            if (!(ends_[n] > tau)) throw DomainError("a phase has no length");
            moves_as_said(n, Vector<T>(moved(n, z, T((ends_[n] - tau) / 2))));
            while (sample < instants && T(2 * pi<T>() * sample / instants) < ends_[n]) {
                const T next = 2 * pi<T>() * sample / instants;
                z = follow(n, z, tau, next);
                tau = next;
                Sample state;
                for (Index k = 0; k < N_; ++k) {
                    state.x.push_back(z(k));
                    state.x_prime.push_back(directions_[n] == 0 && k == j_ ? T(0) : z(N_ + k));
                }
                found.samples.push_back(state);
                ++sample;
            }
            z = follow(n, z, tau, ends_[n]);
            tau = ends_[n];
            if (n + 1 == directions_.size()) break;
            if (directions_[n] != 0) note(j_, z(j_), tau);
            found.events.push_back({tau, directions_[n], directions_[n + 1], z(j_)});
        }
        if (rests_) furthest_[static_cast<std::size_t>(j_)] = {z(j_), T(0)};
        for (const Furthest& e : furthest_) {
            found.amplitude.push_back(abs(e.x));
            const T turned = e.instant + (e.x < 0 ? pi<T>() : T(0));
            found.phase.emplace_back(atan2(T(sin(turned)), T(cos(turned))));
            if (found.amplitude.back() < T(no_motion)) found.phase.back().reset();
        }
        return found;
    }

private:
    struct Furthest {
        T x, instant;
    };

    HalfPeriodProblem<T> p_;
    Index N_, j_;
    T mu_beta_;
    bool rests_;
    std::vector<int> directions_; ///< of the phases, the last one that of the first
    std::vector<T> ends_;         ///< of the phases
    std::array<Matrix<T>, 3> A_;  ///< of z' = A z, z = (x, x', cos tau, sin tau, 1): sliding down, at rest, sliding up
    Vector<T> z_0_;
    std::vector<Furthest> furthest_;

    const Matrix<T>& of(std::size_t n) const { return A_[static_cast<std::size_t>(directions_[n] + 1)]; }
    Vector<T> moved(std::size_t n, const Vector<T>& z, const T& dt) const {
        return matrix_exponential(Matrix<T>(of(n) * dt)) * z;
    }

    StateRow<T> event(std::size_t n) const {
        return end_of_phase(p_, mu_beta_, directions_[n], n + 1 < directions_.size() ? directions_[n + 1] : 0);
    }

    // A step of Newton's method; how long it was. A contact that rests for ever may do so anywhere: it stays where it is.
    T correct(const T& rest) {
        const auto events = static_cast<Index>(ends_.size() - 1);
        const Index unknowns = 2 * N_ + events;
        Vector<T> z = z_0_, F(unknowns);
        Matrix<T> slope = Matrix<T>::Zero(2 * N_ + 3, unknowns), J = Matrix<T>::Zero(unknowns, unknowns);
        slope.topLeftCorner(2 * N_, 2 * N_).setIdentity();
        for (Index n = 0; n <= events; ++n) {
            const auto m = static_cast<std::size_t>(n);
            const Matrix<T> E = matrix_exponential(Matrix<T>(of(m) * T(ends_[m] - (m > 0 ? ends_[m - 1] : T(0)))));
            if (n > 0) slope.col(2 * N_ + n - 1) -= of(m) * z;
            z = Vector<T>(E * z);
            slope = Matrix<T>(E * slope);
            if (n == events) break;
            slope.col(2 * N_ + n) += of(m) * z;
            F(n) = event(m).dot(z);
            J.row(n) = event(m) * slope;
        }
        F.tail(2 * N_) = z.head(2 * N_) - z_0_.head(2 * N_);
        J.bottomRows(2 * N_) = slope.topRows(2 * N_);
        for (Index k = 0; k < 2 * N_; ++k) J(events + k, k) -= T(1);
        if (rests_)
            for (const Index k : {j_, N_ + j_}) {
                J.row(k).setZero();
                J(k, k) = T(1);
                F(k) = k == j_ ? T(z_0_(k) - rest) : z_0_(k);
            }
        const Vector<T> change = Eigen::FullPivLU<Matrix<T>>(J).solve(Vector<T>(-F));
        z_0_.head(2 * N_) += change.head(2 * N_);
        for (Index n = 0; n < events; ++n) ends_[static_cast<std::size_t>(n)] += change(2 * N_ + n);
        return T(change.cwiseAbs().maxCoeff());
    }

    void moves_as_said(std::size_t n, const Vector<T>& middle) const {
        const int direction = directions_[n];
        StateRow<T> row = event(n);
        row(2 * N_ + 2) = T(0);
        if (direction != 0 && !(middle(N_ + j_) * direction > T(0))) throw DomainError("the contact slides back");
        if (direction == 0 && !(abs(T(row.dot(middle))) < mu_beta_)) throw DomainError("friction does not hold the contact");
    }

    void note(Index k, const T& x, const T& tau) {
        Furthest& e = furthest_[static_cast<std::size_t>(k)];
        if (abs(x) > abs(e.x) * (1 + T(1) / 1000000000)) e = {x, tau};
    }

    // The state at a later instant of a phase; on the way the turning points of the masses that are not in contact.
    Vector<T> follow(std::size_t n, const Vector<T>& from, const T& tau, const T& until) {
        const Vector<T> to = moved(n, from, T(until - tau));
        for (Index k = 0; k < N_; ++k) {
            if (k == j_ || (from(N_ + k) > 0) == (to(N_ + k) > 0)) continue;
            T low(0), high = until - tau, dt = high * from(N_ + k) / (from(N_ + k) - to(N_ + k)), step = high;
            Vector<T> z = moved(n, from, dt);
            for (int i = 0; i < 60 && abs(step) > std::numeric_limits<T>::epsilon() * 64; ++i) {
                ((z(N_ + k) > 0) == (from(N_ + k) > 0) ? low : high) = dt;
                step = z(N_ + k) / (of(n) * z)(N_ + k);
                const T next = dt - step;
                dt = next > low && next < high ? next : T((low + high) / 2);
                z = moved(n, from, dt);
            }
            note(k, z(k), T(tau + dt));
        }
        return to;
    }
};

} // namespace

Motion physical_motion(const Scene<double>& scene, const Motion& seen) { return PhysicalMotion(scene, seen).motion(); }

int agreement(const Motion& a, const Motion& b) {
    if (a.rests != b.rests || a.at_start != b.at_start || a.events.size() != b.events.size()) return -1;
    T largest(0), apart(0);
    const auto compare = [&](const T& x, const T& y) { apart = std::max(apart, T(abs(T(x - y)))); };
    for (std::size_t n = 0; n < a.samples.size(); ++n)
        for (std::size_t k = 0; k < a.amplitude.size(); ++k) {
            largest = std::max({largest, T(abs(a.samples[n].x[k])), T(abs(a.samples[n].x_prime[k]))});
            compare(a.samples[n].x[k], b.samples[n].x[k]);
            compare(a.samples[n].x_prime[k], b.samples[n].x_prime[k]);
        }
    for (std::size_t k = 0; k < a.amplitude.size(); ++k) compare(a.amplitude[k], b.amplitude[k]);
    apart /= largest == T(0) ? T(1) : largest;
    for (std::size_t n = 0; n < a.events.size(); ++n) {
        if (a.events[n].before != b.events[n].before || a.events[n].after != b.events[n].after) return -1;
        compare(a.events[n].tau, b.events[n].tau);
    }
    for (std::size_t k = 0; k < a.phase.size(); ++k) {
        if (a.phase[k].has_value() != b.phase[k].has_value()) return -1;
        if (a.phase[k]) compare(T(0), T(atan2(T(sin(T(*a.phase[k] - *b.phase[k]))), T(cos(T(*a.phase[k] - *b.phase[k]))))));
    }
    return apart == T(0) ? 40 : std::clamp(static_cast<int>(floor(-log10(apart))), 0, 40);
}

} // namespace denhartog::benchmark
