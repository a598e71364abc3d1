// The motion of a contact that slides and rests, period after period, until it repeats: the exponential carries the state over a
// stretch, and the stretch ends at the first zero of a polynomial. Read `run` and `stretch`, then `settle`, which ends with
// Newton's method if the periods alone do not come to a steady motion.
#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "conformance/plain/system.hpp"

namespace denhartog::conformance {
namespace {

constexpr double whole_period = 2 * std::numbers::pi;
constexpr double nothing = 1e-9; // a time in which rounding decides what moves

double largest_of(const PlainRow& z, std::size_t count) {
    double size = 0;
    for (std::size_t n = 0; n < count; ++n) size = std::max(size, std::abs(z[n]));
    return size;
}

double distance(PlainRow a, const PlainRow& b, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) a[n] -= b[n];
    return largest_of(a, count);
}

// Weights of a state as a polynomial of the share of dt that has passed, the series of the exponential.
PlainRow series_of(const PlainMatrix& A, PlainRow z, double dt, const PlainRow& weights) {
    constexpr int most_terms = 80;
    PlainRow series{dot(weights, z)};
    double all = largest_of(z, z.size());
    for (int k = 1; k < most_terms && largest_of(z, z.size()) > 1e-18 * all; ++k) {
        z = times(A, z);
        for (double& x : z) x *= dt / k;
        all = std::max(all, largest_of(z, z.size()));
        series.push_back(dot(weights, z));
    }
    return series;
}

double polynomial(const PlainRow& series, double x) {
    double sum = 0;
    for (std::size_t k = series.size(); k-- > 0;) sum = sum * x + series[k];
    return sum;
}

double zero_of(const PlainRow& series) {
    return zero_between([&](double x) { return polynomial(series, x); }, 0, 1);
}

// The first time up to dt at which weights of a state, not negative at first, are below zero; none if they stay above. A state
// falls below zero and rises again at most once in a step.
std::optional<double> first_fall(const PlainMatrix& A, const PlainRow& z, const PlainRow& next, double dt,
                                 const PlainRow& weights, const PlainRow& rates) {
    const bool rises_again = dot(rates, z) < 0 && dot(rates, next) > 0;
    if (dot(weights, next) > 0 && !rises_again) return std::nullopt;
    const PlainRow series = series_of(A, z, dt, weights);
    const auto value = [&](double x) { return polynomial(series, x); };
    double far = 1;
    if (dot(weights, next) > 0) {
        PlainRow rate;
        for (std::size_t k = 1; k < series.size(); ++k) rate.push_back(static_cast<double>(k) * series[k]);
        far = zero_of(rate);
        if (far * dt < nothing || value(far) > 0) return std::nullopt;
    }
    double near = 0;
    if (!(series.front() > 1e-14 * std::sqrt(dot(z, z)) * std::sqrt(dot(weights, weights))))
        for (near = far / 2; value(near) <= 0; near /= 2)
            if (near * dt < nothing) return 0.0;
    return dt * zero_between(value, near, far);
}

} // namespace

PlainMatrix equations_of(const PlainSystem& s, bool held) {
    const std::size_t N = s.size();
    PlainMatrix A = square(2 * N + 3);
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

PlainRow in_state(const PlainRow& row, std::size_t from) {
    PlainRow all(2 * row.size() + 3);
    std::ranges::copy(row, all.begin() + static_cast<long>(from));
    return all;
}

int steps_of(const PlainSystem& s) {
    double fastest = 0;
    for (std::size_t i = 0; i < s.size(); ++i) fastest = std::max(fastest, s.r_n[i] / s.r * (1 + 2 * s.zeta[i] * s.zeta[i]));
    return 2 * static_cast<int>(std::clamp(16 + 6 * std::ceil(fastest), 32.0, 8192.0));
}

FrictionResponse::FrictionResponse(const PlainSystem& s) : A(equations_of(s, false)), step(whole_period / steps_of(s)) {
    const std::size_t n = 2 * s.size();
    const PlainMatrix of_step = propagator(A, step);
    PlainMatrix half = of_step, power = of_step; // over a half-period, by its steps but one
    for (int left = steps_of(s) / 2 - 1; left > 0; left /= 2) {
        if (left % 2 == 1) half = times(power, half);
        power = times(power, power);
    }
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
    return {dot(row, z), dot(in_state(row, row.size()), z)};
}

double FrictionResponse::rate_gained(const PlainRow& row, double tau) const {
    if (tau > step) return at(row, tau).v - at(row, 0).v;
    return dot(in_state(row, row.size()), increment(A, nodes.front(), tau)); // so that no digits are lost next to the start
}

double FrictionResponse::acceleration_at_start(const PlainRow& row) const {
    return dot(in_state(row, row.size()), times(A, nodes.front()));
}

PlainContact::PlainContact(const ProtocolQuestion& q)
    : system(plain_system(q)), slipping(equations_of(system, false)), resting(equations_of(system, true)),
      step(whole_period / steps_of(system)), now(2 * system.size() + 3) {
    const std::size_t N = system.size();
    of_slipping = propagator(slipping, step);
    of_resting = propagator(resting, step);
    for (std::size_t i = 0; i < N; ++i) pull.push_back(-slipping[N + i].back());
    const PlainRow of_rates = in_state(system.w, N);
    load = times(transposed(slipping), of_rates);
    for (double& x : load) x /= dot(system.w, pull);
    load.back() = 0;
    now[2 * N] = 1;
    if (!(q.beta >= 0)) throw NoPlainAnswer();
}

// The contact has no velocity: it rests, or the load moves it.
void PlainContact::start_again(PlainRow& z, bool may_rest) {
    const std::size_t N = system.size();
    const double rate = dot(in_state(system.w, N), z) / dot(system.w, pull), force = dot(load, z);
    for (std::size_t i = 0; i < N; ++i) z[N + i] -= rate * pull[i];
    const bool rests = may_rest && std::abs(force) <= system.mu * system.beta;
    const int pushed = force > 0 ? 1 : -1;
    direction = rests ? 0 : pushed;
}

PlainStretch PlainContact::stretch(double from, PlainRow z) const {
    const std::size_t N = system.size();
    const PlainMatrix &A = equations(direction), &of_step = direction == 0 ? of_resting : of_slipping;
    z.back() = direction == 0 ? system.beta : direction * system.beta;
    std::vector<PlainRow> kept; // what is positive as long as the stretch lasts
    for (const int sign : {1, -1}) {
        if (direction == -sign || system.beta == 0) continue;
        kept.push_back(direction == 0 ? load : in_state(system.w, N));
        for (double& x : kept.back()) x *= direction == 0 ? -sign : sign;
        if (direction == 0) kept.back().back() = system.mu;
    }
    std::vector<PlainRow> rates;
    for (const PlainRow& weights : kept) rates.push_back(times(transposed(A), weights));
    PlainStretch all{direction, {{from, z}}};
    while (from < whole_period) {
        const bool last = whole_period - from <= step * (1 + 1e-12);
        const double dt = last ? whole_period - from : step;
        PlainRow next = last ? moved(A, z, dt) : times(of_step, z);
        std::optional<double> fall;
        for (std::size_t n = 0; n < kept.size(); ++n)
            if (const auto t = first_fall(A, z, next, dt, kept[n], rates[n])) fall = std::min(*t, fall.value_or(dt));
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
    const std::size_t N = system.size();
    PlainRow z = now;
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
std::optional<PlainRow> PlainContact::by_newton() const {
    const std::size_t N = system.size(), n = 2 * N;
    const double reach = system.mu > 1 ? 1e-2 : largest_of(system.zeta, N) == 0 ? 0.5 : INFINITY;
    const auto after = [&](const PlainRow& from) {
        PlainContact other = *this;
        other.now = from;
        other.run();
        return other.now;
    };
    PlainRow z = now;
    PlainMatrix J; // kept as long as it brings the state ten times nearer
    double last = INFINITY;
    for (int steps = 0; steps < 24; ++steps) {
        const PlainRow end = after(z);
        const double size = largest_of(z, n), apart = distance(z, end, n), change = 1e-7 * size;
        const bool found = apart <= (steps < 12 ? 1e-13 : 1e-11) * size;
        if (J.empty() || (!found && apart > 0.1 * last)) {
            J = square(n);
            for (std::size_t k = 0; k < n; ++k) {
                PlainRow other = z;
                other[k] += change;
                if (direction == 0 && k >= N) // a contact at rest stays at rest
                    for (std::size_t i = 0; i < N; ++i) other[N + i] -= change * system.w[k - N] / dot(system.w, pull) * pull[i];
                other = after(other);
                for (std::size_t i = 0; i < n; ++i) J[i][k] = (i == k ? 1 : 0) - (other[i] - end[i]) / change;
            }
        }
        last = apart;
        PlainRow right(n);
        for (std::size_t i = 0; i < n; ++i) right[i] = end[i] - z[i];
        const PlainRow by = solved(J, right);
        for (std::size_t i = 0; i < n; ++i) z[i] += by[i];
        if (found) return z;
        if (!(distance(z, now, n) <= reach * size)) return std::nullopt;
    }
    return std::nullopt;
}

void PlainContact::settle() {
    constexpr int most_periods = 700;
    constexpr std::size_t most_repeating = 16;
    const std::size_t n = 2 * system.size();
    std::deque<PlainRow> before; // ends of periods, the last one first
    int resting_periods = 0;
    for (int periods = 0, more = 12; periods < most_periods; periods += more, more *= 2) {
        for (int left = more; left > 0; --left) {
            before.push_front(now);
            if (before.size() > most_repeating) before.pop_back();
            run();
            resting_periods = rests() ? resting_periods + 1 : 0;
            if (resting_periods == 10) return;
            const double size = largest_of(now, n), apart = distance(before.front(), now, n);
            if (apart <= 1e-14 * size) return;
            for (const PlainRow& one : before) // a motion of several periods
                if (distance(one, now, n) <= 1e-10 * size && apart > 1e-6 * size) throw NoPlainAnswer();
        }
        if (std::optional<PlainRow> found = by_newton()) {
            now = std::move(*found);
            run(); // after which it is known whether the contact rests at the end of a period
            run();
            return;
        }
    }
    throw NoPlainAnswer();
}

PlainRow PlainContact::samples(const PlainRow& row, int count) const {
    PlainRow x;
    for (int n = 0; n < count; ++n) {
        const double tau = whole_period * n / count;
        const auto of = std::ranges::find_if(period, [&](const PlainStretch& s) { return s.end() > tau; });
        auto state = std::ranges::upper_bound(of->states, tau, {}, &std::pair<double, PlainRow>::first);
        if (state != of->states.begin()) --state;
        x.push_back(dot(row, moved(equations(of->direction), state->second, tau - state->first)));
    }
    return x;
}

std::pair<double, double> PlainContact::largest(const PlainRow& row, double frame) const {
    std::pair<double, double> best{0, 0};
    const auto take = [&](double tau, double x) {
        if (std::abs(x) > std::abs(best.second) * (1 + 1e-12)) best = {tau, x};
    };
    const std::size_t N = system.size();
    const bool of_contact = row == system.w && system.beta > 0 && frame == 0; // it is at its largest where it rests or turns
    PlainRow places = in_state(row, 0), rates = in_state(row, N);
    places[2 * N] = frame;
    rates[2 * N + 1] = -frame;
    for (std::size_t m = 0; m < period.size(); ++m) {
        const PlainStretch& s = period[m];
        if (of_contact && m > 0 && period[m - 1].direction != 0) take(s.start(), dot(places, s.states.front().second));
        for (std::size_t n = 1; n < s.states.size() && !of_contact; ++n) {
            const auto& [tau, z] = s.states[n - 1];
            if (dot(rates, z) * dot(rates, s.states[n].second) > 0) continue;
            const PlainMatrix& A = equations(s.direction);
            const double dt = s.states[n].first - tau;
            const double t = dt * zero_of(series_of(A, z, dt, rates));
            take(tau + t, dot(places, moved(A, z, t)));
        }
    }
    for (const auto* end : {&period.front().states.front(), &period.back().states.back()}) // of a motion that is not periodic
        take(end->first, dot(places, end->second));
    return best;
}

PlainRow PlainContact::stops() const {
    PlainRow lengths;
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
