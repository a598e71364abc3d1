// The motion of a contact that slides and rests, period after period, until it repeats: the exponential carries the state over a
// stretch, and the stretch ends at the first zero of a polynomial. A state z has the displacements, their rates, cos(tau),
// sin(tau) and the friction force beta sgn(w x'). Read `run` and `stretch`, then `settle`, which ends with Newton's method if the
// periods alone do not come to a steady motion.
#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/rational.hpp>
#include <cmath>
#include <deque>
#include <numbers>

#include "conformance/plain/system.hpp"

namespace denhartog::conformance {
namespace {

constexpr double whole_period = 2 * std::numbers::pi;
constexpr double nothing = 1e-9; // a time in which rounding decides what moves
constexpr int most_terms = 80;   // of a series

template <class T>
double largest_of(const T& z) {
    return z.cwiseAbs().maxCoeff();
}

// Of z' = A z: z(dt) - z(0), by the series of the exponential, where z is a state or a matrix of states; z(dt); and the matrix
// that makes it of z(0).
template <class T>
T increment(const PlainMatrix& A, const T& z, double dt) {
    T sum = T::Zero(z.rows(), z.cols()), term = z;
    for (int k = 1; k < most_terms && (k == 1 || largest_of(term) > 1e-18 * largest_of(sum)); ++k) {
        term = A * term * (dt / k);
        sum += term;
    }
    return sum;
}

PlainVector moved(const PlainMatrix& A, const PlainVector& z, double dt) { return z + increment(A, z, dt); }

PlainMatrix propagator(const PlainMatrix& A, double dt) {
    const PlainMatrix unit = PlainMatrix::Identity(A.rows(), A.rows());
    return unit + increment(A, unit, dt);
}

// A of z' = A z. With the contact held the last entry of z is beta, and no other entry of z depends on it.
PlainMatrix equations_of(const PlainSystem& s, bool held) {
    const Index N = s.size();
    PlainMatrix forces(N, 2 * N + 3);
    forces << -s.K, -s.r * s.C, s.p, -s.p_i, -s.w;
    const Eigen::PartialPivLU<PlainMatrix> inertia(s.r * s.r * s.M);
    const PlainVector of_contact = inertia.solve(s.w);
    PlainMatrix A = PlainMatrix::Zero(2 * N + 3, 2 * N + 3);
    A.block(0, N, N, N).setIdentity();
    auto rates = A.middleRows(N, N);
    rates = inertia.solve(forces);
    if (held) rates -= of_contact * (s.w.transpose() * rates).eval() / s.w.dot(of_contact);
    A(2 * N, 2 * N + 1) = -1;
    A(2 * N + 1, 2 * N) = 1;
    return A;
}

// The weights of a row as weights of a state: of its displacements, from 0 on, or of its rates, from N on.
PlainVector in_state(const PlainVector& row, Index from) {
    PlainVector all = PlainVector::Zero(2 * row.size() + 3);
    all.segment(from, row.size()) = row;
    return all;
}

// Steps in a period that show every oscillation and decay of the modes.
int steps_of(const PlainSystem& s) {
    const double fastest = (s.r_n.array() / s.r * (1 + 2 * s.zeta.array().square())).maxCoeff();
    return 2 * static_cast<int>(std::clamp(16 + 6 * std::ceil(fastest), 32.0, 8192.0));
}

// A weighted sum of the state as a function of the time since z, up to dt: a polynomial, from the series of the exponential.
std::function<double(double)> course_of(const PlainMatrix& A, PlainVector z, double dt, const PlainVector& weights) {
    std::vector<double> series{weights.dot(z)};
    const double size = largest_of(z);
    for (int k = 1; k < most_terms && largest_of(z) > 1e-18 * size; ++k) {
        z = A * z * (dt / k);
        series.push_back(weights.dot(z));
    }
    return [=](double t) { return boost::math::tools::evaluate_polynomial(series.data(), t / dt, series.size()); };
}

// The first time up to dt at which weights of a state, not negative at first, are below zero; none if they stay above. A state
// falls below zero and rises again at most once in a step.
std::optional<double> first_fall(const PlainMatrix& A, const PlainVector& z, const PlainVector& next, double dt,
                                 const PlainVector& weights, const PlainVector& rates) {
    const bool above_after = weights.dot(next) > 0, rises_again = rates.dot(z) < 0 && rates.dot(next) > 0;
    if (above_after && !rises_again) return std::nullopt;
    const auto value = course_of(A, z, dt, weights);
    const double far = above_after ? zero_between(course_of(A, z, dt, rates), 0, dt) : dt;
    if (above_after && (far < nothing || value(far) > 0)) return std::nullopt;
    double near = 0;
    if (!(weights.dot(z) > 1e-14 * z.norm() * weights.norm()))
        for (near = far / 2; value(near) <= 0; near /= 2)
            if (near < nothing) return 0.0;
    return zero_between(value, near, far);
}

} // namespace

FrictionResponse::FrictionResponse(const PlainSystem& s) : A(equations_of(s, false)), step(whole_period / steps_of(s)) {
    const Index n = 2 * s.size();
    const PlainMatrix of_step = propagator(A, step);
    PlainMatrix half = of_step; // over a half-period
    for (int left = steps_of(s) / 2 - 1; left > 0; --left) half = of_step * half;
    // (I + E) y = -E f with the force f = -1 of a contact that moves backwards
    PlainVector z = PlainVector::Zero(n + 3);
    z.head(n) = solved(PlainMatrix::Identity(n, n) + half.topLeftCorner(n, n), half.col(n + 2).head(n));
    z[n + 2] = -1;
    for (int left = steps_of(s) / 2; left > 0; --left, z = of_step * z) nodes.push_back(z);
}

PlainMotion FrictionResponse::at(const PlainVector& row, double tau) const {
    const auto n = std::min(static_cast<std::size_t>(tau / step), nodes.size() - 1);
    const PlainVector z = moved(A, nodes[n], tau - static_cast<double>(n) * step);
    return {row.dot(z.head(row.size())), row.dot(z.segment(row.size(), row.size()))};
}

double FrictionResponse::rate_gained(const PlainVector& row, double tau) const {
    if (tau > step) return at(row, tau).v - at(row, 0).v;
    return in_state(row, row.size()).dot(increment(A, nodes.front(), tau)); // so that no digits are lost next to the start
}

double FrictionResponse::acceleration_at_start(const PlainVector& row) const {
    return in_state(row, row.size()).dot(A * nodes.front());
}

PlainContact::PlainContact(const ProtocolQuestion& q)
    : system(plain_system(q)), slipping(equations_of(system, false)), resting(equations_of(system, true)),
      step(whole_period / steps_of(system)), now(PlainVector::Unit(2 * system.size() + 3, 2 * system.size())) {
    const Index N = system.size();
    of_slipping = propagator(slipping, step);
    of_resting = propagator(resting, step);
    pull = -slipping.col(2 * N + 2).segment(N, N);
    load = slipping.transpose() * in_state(system.w, N) / system.w.dot(pull);
    load[2 * N + 2] = 0;
    if (!(q.beta >= 0)) throw NoPlainAnswer();
}

// The contact has no velocity: it rests, or the load moves it.
void PlainContact::start_again(PlainVector& z, bool may_rest) {
    auto rates = z.segment(system.size(), system.size());
    const double force = load.dot(z);
    rates -= system.w.dot(rates) / system.w.dot(pull) * pull;
    const bool rests = may_rest && std::abs(force) <= system.mu * system.beta;
    const int pushed = force > 0 ? 1 : -1;
    direction = rests ? 0 : pushed;
}

PlainStretch PlainContact::stretch(double from, PlainVector z) const {
    const Index N = system.size(), of_friction = 2 * N + 2;
    const PlainMatrix &A = equations(direction), &of_step = direction == 0 ? of_resting : of_slipping;
    z[of_friction] = direction == 0 ? system.beta : direction * system.beta;
    std::vector<std::pair<PlainVector, PlainVector>> kept; // what is positive as long as the stretch lasts, with its rate
    for (const int sign : {1, -1}) {
        if (direction == -sign || system.beta == 0) continue;
        PlainVector weights = direction == 0 ? PlainVector(-sign * load) : PlainVector(sign * in_state(system.w, N));
        if (direction == 0) weights[of_friction] = system.mu;
        kept.emplace_back(weights, A.transpose() * weights);
    }
    PlainStretch all{direction, {{from, z}}};
    while (from < whole_period) {
        const bool last = whole_period - from <= step * (1 + 1e-12);
        const double dt = last ? whole_period - from : step;
        PlainVector next = last ? moved(A, z, dt) : PlainVector(of_step * z);
        std::optional<double> fall;
        for (const auto& [weights, rates] : kept)
            if (const auto t = first_fall(A, z, next, dt, weights, rates)) fall = std::min(*t, fall.value_or(dt));
        if (fall) next = moved(A, z, *fall);
        from = fall ? from + *fall : last ? whole_period : from + dt;
        z = std::move(next);
        all.states.emplace_back(from, z);
        if (fall) break;
    }
    return all;
}

void PlainContact::run() {
    constexpr std::size_t most_stretches = 2000;
    const Index N = system.size();
    PlainVector z = now;
    z[2 * N] = 1;
    z[2 * N + 1] = 0;
    period.clear();
    if (direction == 0) start_again(z, true);
    for (double from = 0; from < whole_period;) {
        period.push_back(stretch(from, std::move(z)));
        from = period.back().end();
        z = period.back().states.back().second;
        if (from < whole_period) start_again(z, direction != 0); // what ends a rest is the load
        if (period.size() > most_stretches) throw NoPlainAnswer();
    }
    now = std::move(z);
}

// Newton's method for the state that a period leaves as it is, with differences for the derivatives. If static friction is
// larger, or nothing is damped, there may be more than one, and the one reached from rest is near; else there is one.
std::optional<PlainVector> PlainContact::by_newton() const {
    const Index N = system.size(), n = 2 * N;
    const double reach = system.mu > 1 ? 1e-2 : largest_of(system.zeta) == 0 ? 0.5 : INFINITY;
    const auto after = [&](const PlainVector& from) {
        PlainContact other = *this;
        other.now = from;
        other.run();
        return other.now;
    };
    PlainVector z = now;
    PlainMatrix J; // kept as long as it brings the state ten times nearer
    double last = INFINITY;
    for (int steps = 0; steps < 24; ++steps) {
        const PlainVector end = after(z), gained = (end - z).head(n);
        const double size = largest_of(z.head(n)), apart = largest_of(gained), change = 1e-7 * size;
        const bool found = apart <= (steps < 12 ? 1e-13 : 1e-11) * size;
        if (J.size() == 0 || (!found && apart > 0.1 * last)) {
            J.resize(n, n);
            for (Index k = 0; k < n; ++k) {
                PlainVector other = z;
                other[k] += change;
                if (direction == 0 && k >= N) // a contact at rest stays at rest
                    other.segment(N, N) -= change * system.w[k - N] / system.w.dot(pull) * pull;
                J.col(k) = PlainVector::Unit(n, k) - (after(other) - end).head(n) / change;
            }
        }
        last = apart;
        z.head(n) += solved(J, gained);
        if (found) return z;
        if (!(largest_of((z - now).head(n)) <= reach * size)) return std::nullopt;
    }
    return std::nullopt;
}

void PlainContact::settle() {
    constexpr int most_periods = 700;
    constexpr std::size_t most_repeating = 16;
    const Index n = 2 * system.size();
    std::deque<PlainVector> before; // ends of periods, the last one first
    int resting_periods = 0;
    for (int periods = 0, more = 12; periods < most_periods; periods += more, more *= 2) {
        for (int left = more; left > 0; --left) {
            before.push_front(now);
            if (before.size() > most_repeating) before.pop_back();
            run();
            resting_periods = rests() ? resting_periods + 1 : 0;
            if (resting_periods == 10) return;
            const auto distance = [&](const PlainVector& one) { return largest_of((one - now).head(n)); };
            const double size = largest_of(now.head(n)), apart = distance(before.front());
            if (apart <= 1e-14 * size) return;
            for (const PlainVector& one : before) // a motion of several periods
                if (distance(one) <= 1e-10 * size && apart > 1e-6 * size) throw NoPlainAnswer();
        }
        if (std::optional<PlainVector> found = by_newton()) {
            now = std::move(*found);
            run(); // after which it is known whether the contact rests at the end of a period
            run();
            return;
        }
    }
    throw NoPlainAnswer();
}

std::vector<double> PlainContact::samples(const PlainVector& row, int count) const {
    std::vector<double> x;
    for (int n = 0; n < count; ++n) {
        const double tau = whole_period * n / count;
        const auto of = std::ranges::find_if(period, [&](const PlainStretch& s) { return s.end() > tau; });
        auto state = std::ranges::upper_bound(of->states, tau, {}, &std::pair<double, PlainVector>::first);
        if (state != of->states.begin()) --state;
        x.push_back(in_state(row, 0).dot(moved(equations(of->direction), state->second, tau - state->first)));
    }
    return x;
}

std::pair<double, double> PlainContact::largest(const PlainVector& row, double frame) const {
    const Index N = system.size();
    // Of places that rounding alone tells apart, such as those of a contact that rests, the first counts.
    const double rounding = 1e-14 * largest_of(period.front().states.front().second.head(N));
    std::pair<double, double> best{0, 0};
    const auto take = [&](double tau, double x) {
        if (std::abs(x) > std::abs(best.second) * (1 + 1e-12) + rounding) best = {tau, x};
    };
    const bool of_contact = row == system.w && system.beta > 0 && frame == 0; // it is at its largest where it rests or turns
    PlainVector places = in_state(row, 0), rates = in_state(row, N);
    places[2 * N] = frame;
    rates[2 * N + 1] = -frame;
    for (std::size_t m = 0; m < period.size(); ++m) {
        const PlainStretch& s = period[m];
        if (of_contact && m > 0 && period[m - 1].direction != 0) take(s.start(), places.dot(s.states.front().second));
        for (std::size_t n = 1; n < s.states.size() && !of_contact; ++n) {
            const auto& [tau, z] = s.states[n - 1];
            if (rates.dot(z) * rates.dot(s.states[n].second) > 0) continue;
            const PlainMatrix& A = equations(s.direction);
            const double dt = s.states[n].first - tau;
            const double t = zero_between(course_of(A, z, dt, rates), 0, dt);
            take(tau + t, places.dot(moved(A, z, t)));
        }
    }
    for (const auto* end : {&period.front().states.front(), &period.back().states.back()}) // of a motion that is not periodic
        take(end->first, places.dot(end->second));
    return best;
}

std::vector<double> PlainContact::stops() const {
    std::vector<double> lengths;
    for (std::size_t n = 0; n < period.size(); ++n) {
        if (period[n].direction != 0) continue;
        if (n == 0 || period[n - 1].direction != 0) lengths.push_back(0);
        lengths.back() += period[n].end() - period[n].start();
    }
    if (period.front().direction == 0 && period.back().direction == 0 && lengths.size() > 1) { // one stop over two periods
        lengths.front() += lengths.back();
        lengths.pop_back();
    }
    std::ranges::sort(lengths);
    return lengths;
}

} // namespace denhartog::conformance
