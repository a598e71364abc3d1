// Regimes and amplitudes at one frequency ratio, for all friction ratios of a map. Read `MapColumn::answer` first.
// It asks the models in the order of their cost: the closed form (38), a contact that is stuck, the motion with stops, started
// from the orbits of earlier points, and at last the decision that `solve` takes for a single question.
#include "denhartog/map/map_column.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/evaluation/contact.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/sliding/contact_alone.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/solve/decision.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {
namespace {

constexpr double least_accuracy = 1e-6; // relative to an amplitude: what has less is left to `solve`

// A periodic orbit by its state at tau = 0.
struct OrbitAt {
    State start;
    double beta;
};

// The state near which the next orbit of a column is looked for, on the line through two orbits; none far from both.
std::optional<State> on_line_through(const std::optional<OrbitAt>& a, const std::optional<OrbitAt>& b, double beta) {
    if (!a || !b) return std::nullopt;
    const double part = (beta - b->beta) / (b->beta - a->beta);
    if (!(std::abs(part) <= 2)) return std::nullopt;
    State z = b->start;
    for (std::size_t k = 0; k < z.x.size(); ++k) {
        z.x[k] += part * (b->start.x[k] - a->start.x[k]);
        z.x_prime[k] += part * (b->start.x_prime[k] - a->start.x_prime[k]);
    }
    return z;
}

// The status that a computation in double gives a point; `answer` leaves all but an answer to `decide`.
template <class Compute>
PointStatus status_of(const Compute& compute) {
    const Tried<bool> made = tried(compute);
    if (made.outcome == Outcome::at_a_pole) return PointStatus::at_a_pole;
    return made.value.value_or(false) ? PointStatus::answered : PointStatus::failed;
}

class MapColumn {
public:
    MapColumn(const PreparedSystem& prepared_, const MapRequest& request_, double r_, const std::optional<ContactColumn>& arrays,
              std::span<MapPoint> points_, std::span<double> amplitudes_, Effort& effort_)
        : prepared(prepared_), request(request_), r(r_), effort(effort_), by_arrays(arrays.has_value()),
          column(arrays ? *arrays : evaluated()), points(points_), amplitudes(amplitudes_),
          contact_alone(std::ranges::all_of(request.masses, [&](Mass k) { return k == system.contact; })),
          damped(every_motion_is_damped(system.basis)) {}

    // The point in double; as `solve` answers it, where the bounds do not tell the regime or leave an amplitude too few digits.
    // If that finds no more, the point is next to a boundary and has the numbers that double has.
    PointStatus answer(std::size_t n) {
        is_near = false;
        if (status_of([&] { return answer_in_double(n); }) == PointStatus::answered) return points[n].status;
        const Tried<Solution> answer = decided(n);
        const PointStatus status = write(n, answer);
        if (status != PointStatus::failed || is_told(n) || !std::isfinite(column.boundary.exact.e)) return status;
        is_near = true;
        if (const PointStatus again = status_of([&] { return answer_in_double(n); }); again != PointStatus::answered)
            return again;
        return points[n].status == PointStatus::answered ? PointStatus::on_boundary : points[n].status;
    }

    // As many points from n on as the closed form or the rest answer without a motion to follow; the contact's amplitude alone.
    std::size_t answer_together(std::size_t n) {
        if (!answers_together(prepared, request)) return 0;
        is_near = false;
        const std::size_t first = n;
        while (n < points.size() && slides(request.beta[n]) && is_told(n)) ++n;
        contact_amplitudes({column.V_dj.re.x, column.V_dj.im.x}, column.U_dj.x, column.G_j.x,
                           std::span(request.beta).subspan(first, n - first), amplitudes.subspan(first, n - first));
        for (std::size_t m = first; m < n; ++m) {
            if (is_accurate(contact_amplitude(m)))
                points[m] = {PointStatus::answered, Regime::continuous, 0, 1};
            else
                n = m;
        }
        if (n > first) sliding = n - 1;
        for (; n < points.size() && mu == 1 && rests(request.beta[n]) && is_told(n); ++n) {
            amplitudes[n] = 0;
            points[n] = {PointStatus::answered, Regime::permanent_sticking, 0, 1};
        }
        if (n > first) last.reset();
        return n - first;
    }

private:
    static bool is_accurate(const Bounded<double>& amplitude) { return amplitude.e <= least_accuracy * amplitude.x; }

    SearchedSums& at() {
        if (!at_) at_.emplace(bounded_sums(prepared.scene().system, *prepared.bounded, as_input(r), &effort), &effort);
        return *at_;
    }

    ContactColumn evaluated() {
        const std::size_t j = system.contact.index;
        const ModeSums<Bounded<double>>& sums = at().sums();
        return {sums.V[j], sums.U[j], sums.G[j], regime_boundary(sums, as_input(mu))};
    }

    bool slides(double beta) const { return beta < column.boundary.exact.x; }
    bool rests(double beta) const { return !slides(beta) && column.boundary.sticking && beta >= column.boundary.sticking->x; }

    // True if the errors of the limits leave the regime as it is.
    bool is_told(std::size_t n) const {
        if (is_near) return true;
        const auto apart = [beta = request.beta[n]](const Bounded<double>& limit) { return std::abs(beta - limit.x) >= limit.e; };
        return apart(column.boundary.exact) && (!column.boundary.sticking || apart(*column.boundary.sticking));
    }

    // The amplitude of the contact with its bound; what the arrays tell is far inside of what is asked.
    Bounded<double> contact_amplitude(std::size_t n) const {
        if (by_arrays) return Bounded<double>(amplitudes[n]);
        return evaluation::displacement_transmissibility_of_contact(column.V_dj, column.U_dj, column.G_j,
                                                                    as_input(request.beta[n]));
    }

    bool answer_in_double(std::size_t n) {
        const double beta = request.beta[n];
        const bool may_differ = mu > 1 && beta > 0;
        if (may_differ && request.start == MapStart::rest) return follow_rest(n);
        if (slides(beta)) return is_told(n) && slide(n);
        if (rests(beta) && (!may_differ || !last)) return is_told(n) && stick(n);
        return is_told(n) && sweep(n);
    }

    // Writes the amplitudes, of which `number` gives each; false where one has too few digits.
    bool write(std::size_t n, const std::function<Bounded<double>(std::size_t k)>& number) {
        for (std::size_t m = 0; m < request.masses.size(); ++m) {
            const Bounded<double> amplitude = number(request.masses[m].index);
            if (!std::isfinite(amplitude.x) || !(is_near || is_accurate(amplitude))) return false;
            amplitudes[n * request.masses.size() + m] = amplitude.x;
        }
        return true;
    }

    bool slide(std::size_t n) {
        const std::optional<Mass> only = request.masses.size() == 1 ? std::optional(request.masses.front()) : std::nullopt;
        const SteadyState<Bounded<double>> state = at().steady_state(as_input(request.beta[n]), only, false);
        if (!write(n, [&](std::size_t k) { return state.masses[k].amplitude; })) return false;
        points[n] = {PointStatus::answered, Regime::continuous, 0, 1};
        sliding = n;
        last.reset();
        return true;
    }

    bool stick(std::size_t n) {
        if (!contact_alone && !held) {
            Scene<double> scene = prepared.scene();
            scene.r = r;
            scene.beta = request.beta[n];
            held = held_solution(scene, system.stuck, *prepared.bounded);
        }
        const auto number = [&](std::size_t k) {
            if (k == system.contact.index) return Bounded<double>(0);
            return Bounded<double>(held->masses[k].amplitude.value, held->masses[k].amplitude.error);
        };
        if (!write(n, number)) return false;
        points[n] = {PointStatus::answered, Regime::permanent_sticking, 0, 1};
        last.reset();
        return true;
    }

    // From the motion at the friction ratio before, else from rest. Newton's method starts on the line through the two before.
    bool sweep(std::size_t n) {
        if (!last && sliding) {
            last = {sliding_at_maximum_of_force(at().values(), request.beta[*sliding]), request.beta[*sliding]};
            before_last.reset();
        }
        const std::optional<State> near = on_line_through(before_last, last, request.beta[n]);
        if (last && follow(n, last->start, near) && points[n].status == PointStatus::answered) return true;
        return follow_rest(n);
    }

    // The motion from rest, which mostly leads to the sliding motion, or to the neighbour of the orbits before.
    bool follow_rest(std::size_t n) {
        std::optional<State> near;
        if (mu > 1)
            near = slides(request.beta[n]) ? sliding_at_maximum_of_force(at().values(), request.beta[n])
                                           : on_line_through(before_last, last, request.beta[n]);
        return follow(n, at_rest(system.basis.r_n.size()), near);
    }

    bool follow(std::size_t n, const State& start, const std::optional<State>& guess) {
        const bool as_solve_does = !is_near && (mu == 1 || request.start == MapStart::rest);
        if (as_solve_does && !system.rounded_because.empty()) return false;
        const Excitation excitation{r, request.beta[n], mu};
        if (!solver) solver.emplace(system, excitation);
        solver->set(excitation);
        OrbitSearch search;
        search.follow_start = mu > 1 && request.start == MapStart::rest;
        search.converging_only = true;
        search.contact_only = contact_alone;
        search.with_stability = false;
        search.effort = &effort;
        search.guess = guess ? &*guess : nullptr;
        const PeriodicOrbit orbit = periodic_orbit(*solver, start, search);
        if (orbit.status == OrbitStatus::permanently_stuck && mu > 1) return is_told(n) && stick(n);
        points[n].status = PointStatus::not_converged;
        if (orbit.status != OrbitStatus::periodic) return true;
        const auto number = [&](std::size_t k) {
            return Bounded<double>(contact_alone ? orbit.contact.amplitude : orbit.masses[k].amplitude, orbit.error_bound);
        };
        const bool beyond = !slides(request.beta[n]), must_stop = beyond && (mu == 1 || damped);
        const bool open = as_solve_does &&
                          stops_are_open(orbit, beyond, must_stop, !beyond && is_sliding_motion(orbit, contact_amplitude(n).x));
        const bool by_closed_form = !beyond && must_be_sliding_motion(orbit, damped);
        const std::optional<OrbitAt> before = last; // slide() forgets it
        if (open || !is_told(n) || !(by_closed_form ? slide(n) : write(n, number))) return false;
        points[n] = {PointStatus::answered, orbit.stops.empty() && !must_stop ? Regime::continuous : Regime::stick_slip,
                     static_cast<std::int32_t>(orbit.stops.size()), orbit.periods};
        before_last = before;
        last = OrbitAt{orbit.start, request.beta[n]};
        return true;
    }

    // As users ask: where there is more than one motion, the one from the start of the map.
    Tried<Solution> decided(std::size_t n) {
        Question question;
        question.asked = Asked::amplitude;
        if (request.masses.size() == 1) question.mass = request.masses.front();
        if (mu == 1 || request.start == MapStart::rest || request.beta[n] == 0)
            return decide(prepared, {r, request.beta[n], nullptr, &effort}, question);
        return decide_sliding(with_effort(at_point(prepared.source, r, request.beta[n]), &effort), question, prepared.bounded);
    }

    // Writes an answer; one without the amplitude of a mass, or 6 certain digits of it, is none.
    PointStatus write(std::size_t n, const Tried<Solution>& answer) {
        points[n] = map_point(answer);
        if (!answer.is_answered()) return points[n].status;
        const Solution& s = *answer.value;
        if (s.masses.empty() || !s.digits_reached) points[n].status = PointStatus::failed;
        for (std::size_t m = 0; m < request.masses.size() && has_numbers(points[n].status); ++m) {
            const Certified& X = s.amplitude(request.masses[m]); // within its error of zero, if the mass does not move
            amplitudes[n * request.masses.size() + m] = X.error < X.value ? X.value : 0;
        }
        return points[n].status;
    }

    const PreparedSystem& prepared;
    const MapRequest& request;
    const ContactSystem& system = *prepared.moving; // sliding and stuck
    const double mu = prepared.scene().mu;
    double r;
    Effort& effort;                  // of the point
    std::optional<SearchedSums> at_; // evaluated when it is first needed
    bool by_arrays;                  // whether `column` comes from the arrays
    ContactColumn column;
    std::span<MapPoint> points;
    std::span<double> amplitudes;
    bool contact_alone;
    bool damped;                              // every motion
    bool is_near = false;                     // whether the point is taken as double has it
    std::optional<std::size_t> sliding;       // the last point where the closed form answered
    std::optional<OrbitAt> last, before_last; // the last periodic orbits, that of sliding among them
    std::optional<HeldSolution> held;         // found when it is first needed
    std::optional<ExactSolver> solver;        // set up when it is first needed
};

} // namespace

MapPoint map_point(const Tried<Solution>& answer) {
    if (answer.outcome == Outcome::at_a_pole) return {PointStatus::at_a_pole};
    if (!answer.is_answered()) return {PointStatus::failed};
    const Solution& s = *answer.value;
    const bool may_choose = s.mu.value > 1 && s.beta && s.beta->value > 0 && !s.rest_interval;
    const bool is_another_motion = !s.not_from_rest.empty() && (may_choose || s.start);
    if (is_another_motion) return {PointStatus::failed};
    return {s.regime.on_boundary ? PointStatus::on_boundary : PointStatus::answered, s.regime.regime,
            static_cast<std::int32_t>(s.stops.size()), s.periods};
}

bool answers_together(const PreparedSystem& system, const MapRequest& request) {
    if (!system.scene().system.load_phases.empty()) return false; // the arrays have one row of the load
    return !system.moving->basis.coupled() && request.masses.size() == 1 && request.masses.front() == system.moving->contact &&
           (system.scene().mu == 1 || request.start == MapStart::sliding);
}

void compute_column(const PreparedSystem& system, const MapRequest& request, double r, const std::optional<ContactColumn>& arrays,
                    const std::atomic<bool>& stop, std::span<MapPoint> points, std::span<double> amplitudes) {
    const std::size_t masses = request.masses.size(), modes = system.moving->basis.r_n.size();
    const auto stopped = [&stop] { return stop.load(std::memory_order_relaxed); };
    std::optional<MapColumn> column;
    QuestionEffort effort(modes, request.effort, stopped);
    const PointStatus prepared = status_of([&] {
        column.emplace(system, request, r, arrays, points, amplitudes, effort);
        return true;
    });
    for (std::size_t n = 0; n < points.size() && !stop; ++n) {
        if (const std::size_t together = column ? column->answer_together(n) : 0; together > 0) {
            n += together - 1;
            continue;
        }
        effort.spent = 0;
        points[n].status = column ? column->answer(n) : prepared;
        if (has_numbers(points[n].status)) continue;
        points[n] = {points[n].status};
        std::ranges::fill(amplitudes.subspan(n * masses, masses), std::nan(""));
    }
}

} // namespace denhartog
