// The guesses that a proof starts from, of a motion that double found: `guess_of` names its phases, `with_other_stops` those that
// rounding may have invented or hidden.
#include "denhartog/solve/solve.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog {
namespace {

constexpr double nearly_at_rest = 1e-4; // of the largest speed of the contact
constexpr double flickering = 1e-9;     // stops of this length come and go by rounding
constexpr int looks_a_phase = 48;
constexpr double hidden_stop = 1e-10; // length of a stop that may hide where the contact turns
constexpr double hidden_rest = 1e-5;  // half of that where it is slow: a dip of the speed by d lasts as the root of d

// A phase of a motion that goes on from stretch to stretch, each the first one again or its mirror image.
struct PhaseSeen {
    std::size_t index; // in the stretch
    int stretch;       // which one
    int direction;
    double start, end;
};

// Leaves out what is shorter, and makes one of neighbours of one kind.
std::vector<PhaseSeen> joined_phases(const std::vector<PhaseSeen>& phases, double shortest) {
    std::vector<PhaseSeen> joined;
    for (const PhaseSeen& p : phases) {
        if (!(p.end > p.start) || p.end - p.start < shortest) continue;
        if (!joined.empty() && joined.back().direction == p.direction)
            joined.back().end = p.end;
        else
            joined.push_back(p);
    }
    return joined;
}

// Three stretches, put together of one: to follow more of them would gather rounding.
std::vector<PhaseSeen> phases_seen(const ExactMotion& motion, double T, int sign, double shortest) {
    std::vector<PhaseSeen> seen;
    for (int stretch = 0, direction = 1; stretch < 3; ++stretch, direction *= sign)
        for (std::size_t k = 0; k < motion.phases.size(); ++k) {
            const Phase& p = motion.phases[k];
            seen.push_back({k, stretch, direction * p.direction, p.start + stretch * T, p.end + stretch * T});
        }
    return joined_phases(joined_phases(seen, 0), shortest);
}

// Where the contact is slowest within a phase of sliding, if it nearly comes to rest there.
void add_slow_instants(ExactSolver& solver, const State& start, const PhaseSeen& phase, std::vector<double>& slow) {
    solver.run(start, phase.start, phase.end);
    const auto speed = [&](double tau) {
        return phase.direction * solver.system().stuck.contact.of(solver.state_at(tau).x_prime);
    };
    std::vector<double> speeds;
    double fastest = 0;
    const double step = (phase.end - phase.start) / looks_a_phase;
    for (int n = 0; n <= looks_a_phase; ++n) {
        speeds.push_back(speed(phase.start + n * step));
        fastest = std::max(fastest, speeds.back());
    }
    for (std::size_t n = 1; n + 1 < speeds.size(); ++n) {
        if (!(speeds[n] <= speeds[n - 1] && speeds[n] < speeds[n + 1])) continue;
        double from = phase.start + static_cast<double>(n - 1) * step, to = from + 2 * step;
        while (to - from > 1e-9) { // a third less at each look
            const double a = from + (to - from) / 3, b = to - (to - from) / 3;
            if (speed(a) < speed(b))
                to = b;
            else
                from = a;
        }
        if (speed(from) < nearly_at_rest * fastest) slow.push_back(from);
    }
}

double stretch_of(bool mirrored, int periods) { return (mirrored ? 1 : 2) * periods * pi<double>(); }

// An iterator of a list, by number.
auto place(auto& list, std::size_t n) { return list.begin() + static_cast<std::ptrdiff_t>(n); }

// Leaves out phase n, 1 to m. If its neighbours are of one kind they become one phase, else they meet where it started.
// Event 0 stays where it is. No events if no phase is left.
OrbitGuess without_phase(const OrbitGuess& g, std::size_t n) {
    const std::size_t m = g.events.size();
    const int after = n < m ? g.directions[n + 1] : (g.mirrored ? -1 : 1) * g.directions[1];
    const bool merge = g.directions[n - 1] == after;
    if (m < 2 || (merge && (n == 1 || n == m))) return {};
    OrbitGuess out = g;
    if (n < m) { // events n - 1 and n become one, or none
        out.directions.erase(place(out.directions, n), place(out.directions, merge ? n + 2 : n + 1));
        out.events.erase(place(out.events, merge ? n - 1 : n), place(out.events, n + 1));
    } else { // event m is event 0, which stays
        out.directions.pop_back();
        out.events.pop_back();
        out.directions.front() = (g.mirrored ? -1 : 1) * out.directions.back();
    }
    return out;
}

// The shortest phase of a kind, 1 to m; 0 where there is none.
std::size_t shortest_phase(const OrbitGuess& g, bool stop) {
    std::vector<double> at = g.events; // where phases start and end, m + 1 values
    at.push_back(g.events.front() + stretch_of(g.mirrored, g.periods));
    std::size_t found = 0;
    for (std::size_t n = 1; n < at.size(); ++n)
        if ((g.directions[n] == 0) == stop && (found == 0 || at[n] - at[n - 1] < at[found] - at[found - 1])) found = n;
    return found;
}

OrbitGuess guess_with_phases(ExactSolver& solver, const PeriodicOrbit& orbit, double shortest) {
    const double T = stretch_of(orbit.symmetric, orbit.periods);
    const ExactMotion& motion = solver.run(orbit.start, 0.0, T);
    if (motion.status != MotionStatus::complete) return {};
    const int sign = orbit.symmetric ? -1 : 1;
    const std::vector<PhaseSeen> seen = phases_seen(motion, T, sign, shortest);
    // Event k is the start of phase k + 1 of those seen. A stretch later all is again as it was.
    std::size_t m = 1;
    while (m + 1 < seen.size() && !(seen[m + 1].index == seen[1].index && seen[m + 1].stretch == seen[1].stretch + 1)) ++m;
    if (seen.size() < 2 * m + 1) return {};
    // Event 0 lies between phases that are certainly there: neither is short. Of two events as good it is one where the contact
    // comes to rest, whatever rounding makes of them: a proof from there takes fewer bits.
    std::size_t first = 1;
    double longest = 0;
    for (std::size_t k = 1; k <= m; ++k) {
        const double least = std::min(seen[k].end - seen[k].start, seen[k + m].start - seen[k + m - 1].start);
        if (least > longest * (1 + (seen[k].direction == 0 ? -1e-9 : 1e-9))) {
            longest = least;
            first = k;
        }
    }
    OrbitGuess guess{{}, orbit.symmetric, orbit.periods, {}, {}, {}, {}};
    guess.directions.push_back(sign * seen[first + m - 1].direction); // the phase before event 0
    for (std::size_t k = 0; k < m; ++k) guess.directions.push_back(seen[first + k].direction);
    for (std::size_t k = 0; k < m; ++k) guess.events.push_back(seen[first + k].start);
    std::vector<State> starts; // of the phases
    for (std::size_t k = first; k < first + m; ++k) {
        starts.push_back(motion.start_of(seen[k].index));
        for (std::vector<double>* part : {&starts.back().x, &starts.back().x_prime})
            for (double& each : *part) each *= seen[k].stretch % 2 != 0 ? sign : 1;
    }
    guess.x = starts.front().x;
    guess.x_prime = starts.front().x_prime;
    for (std::size_t k = 0; k < m; ++k)
        if (seen[first + k].direction != 0) add_slow_instants(solver, starts[k], seen[first + k], guess.slow);
    return guess;
}

} // namespace

OrbitGuess guess_of(ExactSolver& solver, const PeriodicOrbit& orbit, double shortest) {
    OrbitGuess guess = guess_with_phases(solver, orbit, shortest);
    // Phases that rounding lets appear at one end of the stretch and not at the other are left out.
    const auto fits = [&] {
        return !guess.directions.empty() && std::ranges::adjacent_find(guess.directions) == guess.directions.end();
    };
    if (!fits() && shortest < flickering) guess = guess_with_phases(solver, orbit, flickering);
    return fits() ? guess : OrbitGuess{};
}

std::vector<OrbitGuess> with_other_stops(const OrbitGuess& guess) {
    std::vector<OrbitGuess> others;
    for (std::size_t i = 0; i < guess.events.size(); ++i) { // a stop where it turns
        if (guess.directions[i] == 0 || guess.directions[i + 1] == 0) continue;
        OrbitGuess& other = others.emplace_back(guess);
        other.directions.insert(place(other.directions, i + 1), 0);
        other.events.insert(place(other.events, i + 1), guess.events[i] + hidden_stop);
    }
    for (const double tau : guess.slow) { // a stop where it is slow
        const auto n = static_cast<std::size_t>(std::ranges::upper_bound(guess.events, tau) - guess.events.begin());
        OrbitGuess& other = others.emplace_back(guess);
        other.directions.insert(place(other.directions, n + 1), {0, guess.directions[n]});
        other.events.insert(place(other.events, n), {tau - hidden_rest, tau + hidden_rest});
    }
    for (const bool stop : {true, false}) { // a stop, or a slip, that is none
        const std::size_t n = shortest_phase(guess, stop);
        if (n == 0) continue;
        OrbitGuess other = without_phase(guess, n);
        if (!other.directions.empty()) others.push_back(std::move(other));
    }
    return others;
}

std::vector<OrbitGuess> guesses_at(const PreparedSystem& p, const SceneSource& source, std::optional<PeriodicOrbit>& followed) {
    const Scene<double>& scene = source->in_double();
    std::vector<OrbitGuess> all;
    // Rounding of modes that double does not have itself would keep it from any motion that repeats itself.
    const ModesInDouble modes = p.bounded ? ModesInDouble{p.bounded} : modes_in_double(source);
    if (!modes.rounded_because.empty()) return all;
    const std::shared_ptr<const ContactSystem> moving = p.moving ? p.moving : moving_in_double(source, modes);
    if (!moving->rounded_because.empty()) return all;
    ExactSolver solver(*moving, {*scene.r, *scene.beta, scene.mu});
    OrbitSearch how;
    how.with_stability = false;
    how.effort = source->effort;
    if (!followed) followed = periodic_orbit(solver, at_rest(moving->basis.r_n.size()), how);
    PeriodicOrbit orbit = *followed;
    if (orbit.status == OrbitStatus::permanently_stuck) return all;
    if (orbit.status == OrbitStatus::not_converged)
        orbit.symmetric = true; // rounding may be why; where the motion was last is near
    SearchEffort effort_of_guesses(default_effort(moving->basis.r_n.size()), source->effort);
    (void)solver.allow(&effort_of_guesses);
    const auto add = [&](const OrbitGuess& guess) {
        if (guess.directions.empty()) return;
        const auto same = [&](const OrbitGuess& other) {
            constexpr double near = 1e-3;
            return other.directions == guess.directions && other.mirrored == guess.mirrored && other.periods == guess.periods &&
                   std::ranges::equal(other.events, guess.events, [](double a, double b) { return std::abs(a - b) < near; });
        };
        if (std::ranges::none_of(all, same)) all.push_back(guess);
    };
    for (const double shortest : {0.0, 1e-9, 1e-6}) add(guess_of(solver, orbit, shortest));
    for (const OrbitGuess& guess : std::vector<OrbitGuess>(all))
        for (const OrbitGuess& other : with_other_stops(guess)) add(other);
    return all;
}

} // namespace denhartog
