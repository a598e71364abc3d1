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
#include "denhartog/solve/solve.hpp"
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

// Phases and absolute numbers come point by point from `decide`.
bool is_answered_by_solve(const MapRequest& request) { return request.phases || request.from_ground; }

class MapColumn {
public:
    MapColumn(const PreparedSystem& prepared_, const MapRequest& request_, double r_, std::span<const double> beta_,
              const std::optional<ContactColumn>& arrays, std::span<MapPoint> points_, std::span<double> amplitudes_,
              std::span<double> phases_, Effort& effort_)
        : prepared(prepared_), request(request_), r(r_), beta(beta_), effort(effort_), by_arrays(arrays.has_value()),
          points(points_), amplitudes(amplitudes_), phases(phases_),
          contact_alone(std::ranges::all_of(request.masses, [&](Mass k) { return k == system.contact; })),
          damped(every_motion_is_damped(system.basis)) {
        if (arrays)
            column = *arrays;
        else if (!is_answered_by_solve(request))
            column = tried([&] { return evaluated(); });
    }

    // The point by the column's numbers in double. If these do not decide the regime, or leave an amplitude fewer than 6 digits,
    // `solve` is asked. If it has no answer, and beta is within the error of a boundary, the point has the numbers of double and
    // the status `on_boundary`.
    PointStatus answer(std::size_t n) {
        is_near = false;
        const bool by_column = column.is_answered() && !is_answered_by_solve(request);
        if (by_column && is_in_double(n)) return points[n].status;
        const PointStatus status = write(n, decided(n));
        const bool is_final = has_numbers(status) || status == PointStatus::at_a_pole;
        if (is_final || !by_column || is_told(n) || !std::isfinite(limits().exact.e)) return status;
        is_near = true;
        if (!is_in_double(n)) return status;
        return points[n].status == PointStatus::answered ? PointStatus::on_boundary : points[n].status;
    }

    // As many points from n on as the closed form or a contact at rest answer without a motion to follow; the contact's amplitude
    // alone.
    std::size_t answer_together(std::size_t n) {
        if (!column.is_answered() || !answers_together(prepared, request)) return 0;
        is_near = false;
        const std::size_t first = n;
        while (n < points.size() && slides(beta[n]) && is_told(n)) ++n;
        const ContactColumn& c = *column.value;
        contact_amplitudes({c.V_dj.re.x, c.V_dj.im.x}, c.U_dj.x, c.G_j.x, beta.subspan(first, n - first),
                           amplitudes.subspan(first, n - first));
        for (std::size_t m = first; m < n; ++m) {
            if (is_accurate(contact_amplitude(m)))
                points[m] = {PointStatus::answered, Regime::continuous, 0, 1};
            else
                n = m;
        }
        if (n > first) sliding = n - 1;
        for (; n < points.size() && mu == 1 && rests(beta[n]) && is_told(n); ++n) {
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

    const RegimeBoundary<Bounded<double>>& limits() const { return column.value->boundary; }
    bool slides(double b) const { return b < limits().exact.x; }
    bool rests(double b) const { return !slides(b) && limits().sticking && b >= limits().sticking->x; }

    // True if the errors of the limits leave the regime as it is.
    bool is_told(std::size_t n) const {
        if (is_near) return true;
        const auto apart = [b = beta[n]](const Bounded<double>& limit) { return std::abs(b - limit.x) >= limit.e; };
        return apart(limits().exact) && (!limits().sticking || apart(*limits().sticking));
    }

    // The amplitude of the contact with its bound; what the arrays tell is far inside of what is asked.
    Bounded<double> contact_amplitude(std::size_t n) const {
        if (by_arrays) return Bounded<double>(amplitudes[n]);
        const ContactColumn& c = *column.value;
        return evaluation::displacement_transmissibility_of_contact(c.V_dj, c.U_dj, c.G_j, as_input(beta[n]));
    }

    // True if double has the point; `answer` leaves all else to `decide`.
    bool is_in_double(std::size_t n) {
        return tried([&] { return answer_in_double(n); }).value.value_or(false);
    }

    bool answer_in_double(std::size_t n) {
        const bool may_differ = mu > 1 && beta[n] > 0;
        if (may_differ && request.start == MapStart::rest) return follow_rest(n);
        if (slides(beta[n])) return is_told(n) && slide(n);
        if (rests(beta[n]) && (!may_differ || !last)) return is_told(n) && stick(n);
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
        const SteadyState<Bounded<double>> state = at().steady_state(as_input(beta[n]), only, false);
        if (!write(n, [&](std::size_t k) { return state.masses[k].amplitude; })) return false;
        points[n] = {PointStatus::answered, Regime::continuous, 0, 1};
        sliding = n;
        last.reset();
        return true;
    }

    bool stick(std::size_t n) {
        if (!contact_alone && held.empty()) {
            Scene<double> scene = prepared.scene();
            scene.r = r;
            scene.beta = beta[n];
            Solution s;
            set_stuck_response(scene, system.stuck, *prepared.bounded, std::nullopt, s);
            held = std::move(s.masses);
        }
        const auto number = [&](std::size_t k) {
            if (k == system.contact.index) return Bounded<double>(0);
            return Bounded<double>(held[k].amplitude.value, held[k].amplitude.error);
        };
        if (!write(n, number)) return false;
        points[n] = {PointStatus::answered, Regime::permanent_sticking, 0, 1};
        last.reset();
        return true;
    }

    // From the motion at the friction ratio before, else from rest. Newton's method starts on the line through the two before.
    bool sweep(std::size_t n) {
        if (!last && sliding) {
            last = {sliding_at_maximum_of_force(at().values(), beta[*sliding]), beta[*sliding]};
            before_last.reset();
        }
        const std::optional<State> near = on_line_through(before_last, last, beta[n]);
        if (last && follow(n, last->start, near) && points[n].status == PointStatus::answered) return true;
        return follow_rest(n);
    }

    // The motion from rest, which mostly leads to the sliding motion, or to the neighbour of the orbits before.
    bool follow_rest(std::size_t n) {
        std::optional<State> near;
        if (mu > 1)
            near = slides(beta[n]) ? sliding_at_maximum_of_force(at().values(), beta[n])
                                   : on_line_through(before_last, last, beta[n]);
        return follow(n, at_rest(system.basis.r_n.size()), near);
    }

    bool follow(std::size_t n, const State& start, const std::optional<State>& guess) {
        const bool as_solve_does = !is_near && (mu == 1 || request.start == MapStart::rest);
        if (as_solve_does && !system.rounded_because.empty()) return false;
        const Excitation excitation{r, beta[n], mu};
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
        if (orbit.status != OrbitStatus::periodic) {
            if (as_solve_does && rests(beta[n])) {
                effort.spent = 0; // `solve` may spend what it may on a question of its own
                if (!has_numbers(write(n, decided(n)))) points[n] = {PointStatus::not_converged};
            }
            return true;
        }
        const auto number = [&](std::size_t k) {
            return Bounded<double>(contact_alone ? orbit.contact.amplitude : orbit.masses[k].amplitude, orbit.error_bound);
        };
        const bool beyond = !slides(beta[n]), must_stop = beyond && (mu == 1 || damped);
        const bool open = as_solve_does &&
                          stops_are_open(orbit, beyond, must_stop, !beyond && is_sliding_motion(orbit, contact_amplitude(n).x));
        const bool by_closed_form = !beyond && must_be_sliding_motion(orbit, damped);
        const std::optional<OrbitAt> before = last; // slide() forgets it
        if (open || !is_told(n) || !(by_closed_form ? slide(n) : write(n, number))) return false;
        points[n] = {PointStatus::answered, orbit.stops.empty() && !must_stop ? Regime::continuous : Regime::stick_slip,
                     static_cast<std::int32_t>(orbit.stops.size()), orbit.periods};
        before_last = before;
        last = OrbitAt{orbit.start, beta[n]};
        return true;
    }

    // The answer of `solve`; with mu > 1 and the start `sliding` that of the sliding motion alone.
    Tried<Solution> decided(std::size_t n) {
        Question question{request.from_ground ? Asked::motion : request.phases ? Asked::phase : Asked::amplitude, std::nullopt};
        if (question.asked == Asked::amplitude && request.masses.size() == 1) question.mass = request.masses.front();
        if (mu == 1 || request.start == MapStart::rest || beta[n] == 0)
            return decide(prepared, {r, beta[n], nullptr, &effort}, question);
        const SceneSource source = with_effort(at_point(prepared.source, r, beta[n]), &effort);
        Tried<Solution> slides = decide_sliding(source, question, prepared.bounded);
        if (last || (slides.is_answered() && !slides.value->masses.empty())) return slides;
        // At a pole there may be no sliding motion; next to it rounding decides how large it is.
        const Tried<Solution> regime = decide_sliding(source, {Asked::regime, {}}, prepared.bounded);
        if (regime.is_answered() && regime.value->regime.regime == Regime::continuous) return slides;
        Tried<Solution> rests = decide(prepared, {r, beta[n], nullptr, &effort}, question);
        const bool for_ever = rests.is_answered() && rests.value->regime.regime == Regime::permanent_sticking;
        return for_ever ? rests : slides;
    }

    // Writes an answer; one without the amplitude of a mass, or 6 certain digits of it, is none.
    PointStatus write(std::size_t n, const Tried<Solution>& answer) {
        PointStatus& status = (points[n] = map_point(answer)).status;
        if (!has_numbers(status)) return status;
        const Solution& s = *answer.value;
        const bool absolute = request.from_ground;
        if ((absolute ? s.from_ground.empty() : s.masses.empty()) || !s.digits_reached) return status = PointStatus::failed;
        for (std::size_t m = 0, at = n * request.masses.size(); m < request.masses.size(); ++m, ++at) {
            const Mass k = request.masses[m];
            const Certified& X = absolute ? s.from_ground[k.index].amplitude : s.amplitude(k);
            const std::optional<Certified>& phase = absolute ? s.from_ground[k.index].phase : s.phase(k);
            const bool moves = X.error < X.value || is_answered_by_solve(request);
            amplitudes[at] = moves ? X.value : 0; // else it is within its error of zero
            if (request.phases && phase) phases[at] = phase->value;
        }
        return status;
    }

    const PreparedSystem& prepared;
    const MapRequest& request;
    const ContactSystem& system = *prepared.moving; // sliding and stuck
    const double mu = prepared.scene().mu;
    double r;
    std::span<const double> beta;
    Effort& effort;                  // of the point
    std::optional<SearchedSums> at_; // evaluated when it is first needed
    bool by_arrays;                  // whether `column` comes from the arrays
    Tried<ContactColumn> column{};   // unused where `decide` answers every point
    std::span<MapPoint> points;
    std::span<double> amplitudes, phases;
    bool contact_alone;
    bool damped;                              // every motion
    bool is_near = false;                     // whether the point is taken as double has it
    std::optional<std::size_t> sliding;       // the last point where the closed form answered
    std::optional<OrbitAt> last, before_last; // the last periodic orbits, that of sliding among them
    std::vector<SolvedMass> held;             // masses where it rests; found when they are first needed
    std::optional<ExactSolver> solver;        // set up when it is first needed
};

} // namespace

MapPoint map_point(const Tried<Solution>& answer) {
    if (answer.outcome == Outcome::at_a_pole) return {PointStatus::at_a_pole};
    if (answer.outcome == Outcome::not_converged) return {PointStatus::not_converged};
    if (!answer.is_answered()) return {PointStatus::failed};
    const Solution& s = *answer.value;
    const bool may_choose = s.mu.value > 1 && s.beta && s.beta->value > 0 && !s.rest_interval;
    const bool is_another_motion = !s.not_from_rest.empty() && (may_choose || s.start);
    if (is_another_motion) return {PointStatus::not_converged};
    return {s.regime.on_boundary ? PointStatus::on_boundary : PointStatus::answered, s.regime.regime,
            static_cast<std::int32_t>(s.stops.size()), s.periods};
}

bool answers_together(const PreparedSystem& system, const MapRequest& request) {
    if (is_answered_by_solve(request) || !system.scene().system.load_phases.empty()) return false; // one row of the load
    return !system.moving->basis.coupled() && request.masses.size() == 1 && request.masses.front() == system.moving->contact &&
           (system.scene().mu == 1 || request.start == MapStart::sliding);
}

void compute_column(const PreparedSystem& system, const MapRequest& request, std::size_t m, std::span<const double> beta,
                    const std::optional<ContactColumn>& arrays, const std::atomic<bool>& stop, RegimeMap& map) {
    const std::size_t rows = beta.size(), masses = request.masses.size(), modes = system.moving->basis.r_n.size();
    const auto points = std::span(map.points).subspan(m * rows, rows);
    const auto amplitudes = std::span(map.amplitudes).subspan(m * rows * masses, rows * masses);
    const auto phases = request.phases ? std::span(map.phases).subspan(m * rows * masses, rows * masses) : std::span<double>();
    QuestionEffort effort(modes, request.effort, [&stop] { return stop.load(std::memory_order_relaxed); });
    MapColumn column(system, request, request.r[m], beta, arrays, points, amplitudes, phases, effort);
    for (std::size_t n = 0; n < rows && !stop; ++n) {
        if (const std::size_t together = column.answer_together(n); together > 0) {
            n += together - 1;
            continue;
        }
        effort.spent = 0;
        points[n].status = column.answer(n);
        if (has_numbers(points[n].status)) continue;
        points[n] = {points[n].status};
        std::ranges::fill(amplitudes.subspan(n * masses, masses), std::nan(""));
    }
}

} // namespace denhartog
