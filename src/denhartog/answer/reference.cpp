// The answer of the reference. Read `attempt`: the regime by the boundaries first, then the motion of the regime, (38) to
// (53), the stuck response or an orbit, each written by one function.
#include "denhartog/answer/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/reference/orbit.hpp"
#include "denhartog/reference/sliding.hpp"
#include "denhartog/sliding/boundary.hpp"

namespace denhartog {
namespace {

using namespace reference;

// The motion of the frame of the displacements, where absolute ones are wanted beside them; none where they are absolute.
std::optional<Ball> frame_of(const Scene<double>& scene, const ReferenceQuestion& q, const Ball& r) {
    return q.asked != Asked::motion || q.mass ? std::nullopt : amplitude_of_frame(scene.system.base_motion, r);
}

// The regime of a friction ratio, as far as balls tell it.
Regime regime_by(const Ball& beta, const Ball& exact, const std::optional<Ball>& sticking) {
    if (beta < exact) return Regime::continuous;
    if (!(beta >= exact)) throw Unproved({Why::may_be_boundary, 0});
    if (!sticking) throw Unproved(Why::may_resonate_held);
    if (beta >= *sticking) return Regime::permanent_sticking;
    if (!(beta < *sticking)) throw Unproved({Why::may_be_boundary, 1});
    return Regime::stick_slip;
}

// A limit in double, for the sentence about the regime. Rounding must not put it on the wrong side of beta.
double parted(const Ball& limit, double beta, bool above) {
    const auto shown = static_cast<double>(limit);
    if (above) return shown > beta ? shown : std::nextafter(beta, std::numeric_limits<double>::infinity());
    return shown <= beta ? shown : beta;
}

void write_regime(const PointInBalls& p, Solution& s) {
    const Ball& beta = *p.scene.beta;
    const auto shown = static_cast<double>(beta);
    const Regime regime = regime_by(beta, p.boundary->exact, p.sticking);
    Boundary<Bounded<double>> b{};
    b.exact = parted(p.boundary->exact, shown, beta < p.boundary->exact);
    if (p.sticking) b.sticking = parted(*p.sticking, shown, !(beta >= *p.sticking));
    b.binding = p.boundary->binding;
    s.regime = regime_at(b, shown);
    s.regime.regime = regime;
    const bool certain = beta < p.boundary->paper || beta >= p.boundary->paper;
    if (!certain || !p.sticking) return;
    const Regime by_56 = regime_by(beta, p.boundary->paper, p.sticking);
    if (by_56 != regime) s.regime_by_56 = by_56;
}

void write_limits(const PointInBalls& p, bool must, WrittenNumbers& w, Solution& s) {
    const auto number = [&](const Ball& x) { return must ? w.relative(x) : w.shown(x); };
    s.limits = Limits{number(p.boundary->exact), number(p.boundary->paper), number(p.boundary->approximate), std::nullopt,
                      p.boundary->binding};
    if (p.sticking) s.limits->sticking = number(*p.sticking);
}

PeakInBalls peak_of(const Complex<Ball>& X) { return {size_in_balls(X), wrapped_in_balls(-argument(X))}; }

// Writes the masses that are asked about, with a contact that does not move as one mass behind them, by `row`; and by `seen` the
// masses from the ground, if their frame moves: the numbers of these have the bounds that are written beside them.
template <class Row, class Seen>
void write_masses(const Scene<double>& scene, const ReferenceQuestion& q, const Ball& r, const Row& row, const Seen& seen,
                  const WrittenNumbers& w, Solution& s) {
    const std::size_t N = number_of_masses(scene.system), rows = contact_moves_apart(scene.system) ? N + 1 : N;
    for (std::size_t k = 0; k < rows; ++k) s.masses.push_back(!q.mass || q.mass->index == k ? row(k) : SolvedMass{});
    const std::optional<Ball> frame = frame_of(scene, q, r);
    for (std::size_t k = 0; frame && k < N; ++k) {
        const PeakInBalls mass = seen(k, *frame);
        s.from_ground.push_back({w.shown(mass.size), w.shown(mass.size / *frame), std::nullopt});
        if (mass.phase && !mass.size.is_zero()) s.from_ground.back().phase = w.shown(*mass.phase);
    }
}

void write_sliding(const PointInBalls& p, const Scene<double>& scene, const ReferenceQuestion& q, WrittenNumbers& w,
                   Solution& s) {
    const ResponsesInBalls& r = *p.responses;
    const SteadyState<Ball> contact = contact_in_balls(r, *p.scene.beta);
    Ball largest = contact.X_j;
    for (std::size_t k = 0; k < r.contact(); ++k) largest = larger(largest, size_in_balls(r.V[k]));
    const auto row = [&](std::size_t k) {
        const MassResponse<Ball> m = mass_in_balls(r, contact, k, k == contact_row(scene.system).index);
        SolvedMass out = w.mass(m.amplitude, m.phase, q.asked != Asked::amplitude, largest);
        if (q.asked != Asked::motion || !out.phase) return out;
        for (const Ball& x : {m.x0, m.v0, m.amplitude_monoharmonic}) w.beside(x, m.amplitude);
        out.sliding = SlidingOfMass{w.shown(m.x0), w.shown(m.v0), w.shown(m.instant), w.shown(m.amplitude_monoharmonic),
                                    w.absolute(m.phase_monoharmonic)};
        return out;
    };
    ResponsesInBalls absolute = r;
    const auto seen = [&](std::size_t k, const Ball& frame) -> PeakInBalls {
        absolute.V[k] = response_from_ground(r.V[k], scene.system.base_motion, frame);
        const MassResponse<Ball> m = mass_in_balls(absolute, contact, k, false);
        return {m.amplitude, m.phase};
    };
    write_masses(scene, q, p.scene.r, row, seen, w, s);
    s.method.model = "closed form";
}

// False where static friction does not hold the contact.
bool write_stuck(const PointInBalls& p, const Scene<double>& scene, const ReferenceQuestion& q, WrittenNumbers& w, Solution& s) {
    const StuckInBalls& stuck = required_stuck(p);
    if (*p.scene.beta < *p.sticking) return false;
    if (!(*p.scene.beta >= *p.sticking)) throw Unproved({Why::may_be_boundary, 1});
    Ball largest = stuck.compliance * size_in_balls(stuck.load); // no mass moves where the load acts on the contact
    for (const Complex<Ball>& X : stuck.X) largest = larger(largest, size_in_balls(X));
    const auto row = [&](std::size_t k) {
        if (k == contact_row(scene.system).index) return SolvedMass{w.shown(Ball(0)), std::nullopt, std::nullopt};
        const PeakInBalls m = peak_of(stuck.X[k]);
        return w.mass(m.size, m.phase, q.asked != Asked::amplitude, largest);
    };
    const auto seen = [&](std::size_t k, const Ball& frame) { return peak_of({stuck.X[k].re + frame, stuck.X[k].im}); };
    write_masses(scene, q, p.scene.r, row, seen, w, s);
    const Ball to = (p.scene.mu * *p.scene.beta - size_in_balls(stuck.load)) * stuck.compliance;
    s.rest_interval = RestInterval{w.shown(-to), w.shown(to), std::nullopt};
    s.method.model = "stuck response";
    return true;
}

bool is_loaded_contact(const Scene<double>& scene) {
    const System<double>& s = scene.system;
    return !contact_moves_apart(s) && load_row(s) == s.contact;
}

bool has_88(const Scene<double>& scene) {
    const System<double>& s = scene.system;
    return is_chain(s) && !contact_moves_apart(s) && load_row(s).index < number_of_masses(s);
}

void set_regime(const PointInBalls& p, Regime met, Solution& s) {
    if (p.boundary)
        take_regime(met, s.regime);
    else
        s.regime.regime = met;
}

// A stop that double sees next to the boundary may be none.
void set_regime_by_stops(const PointInBalls& p, const OrbitInBalls& o, Solution& s) {
    const bool slides = p.boundary && *p.scene.beta < p.boundary->exact;
    set_regime(p, o.stops.empty() ? Regime::continuous : Regime::stick_slip, s);
    if (o.stops.empty())
        s.regime.reason += slides ? Why::rest_leads_to_sliding : Why::slides_otherwise;
    else if (slides)
        s.regime.reason += Why::rest_leads_to_stops;
}

void write_orbit(const OrbitInBalls& o, const Scene<double>& scene, const Ball& r, const ReferenceQuestion& q, WrittenNumbers& w,
                 Solution& s) {
    Ball largest(0);
    for (const PeakInBalls& each : o.masses) largest = larger(largest, each.size);
    const auto row = [&](std::size_t k) {
        return w.mass(o.masses[k].size, o.masses[k].phase, q.asked != Asked::amplitude, largest);
    };
    const auto seen = [&](std::size_t k, const Ball&) -> const PeakInBalls& { return o.from_ground[k]; };
    write_masses(scene, q, r, row, seen, w, s);
    for (const StopOf<Ball>& stop : o.stops) s.stops.push_back({w.shown(stop.start), w.shown(stop.end), w.shown(stop.x)});
    s.start.emplace();
    for (std::size_t k = 0; k < o.x.size(); ++k) {
        s.start->x.push_back(w.shown(o.x[k]));
        s.start->x_prime.push_back(w.shown(o.x_prime[k]));
    }
    s.periods = o.periods;
    s.symmetric = o.mirrored;
    if (q.asked == Asked::motion) {
        s.stability = Stability{o.stable, {}};
        for (const Ball& each : o.multipliers) s.stability->multipliers.push_back(printed(each, std::min(*q.digits, 15)));
    }
    s.method.model = "exact solver";
}

OrbitInBalls orbit_in_balls(const SceneSource& source, const ReferenceQuestion& q, const Ball& r, slong bits,
                            OrbitGuesses& guesses) {
    std::vector<std::size_t> wanted;
    if (q.mass) wanted = {q.mass->index};
    const auto scene = [&] { return damped_scene_in_balls(source); };
    return guesses.first_proved(source->effort, [&](const OrbitGuess& guess) {
        return proved_orbit(scene, guess, bits, wanted, q.asked == Asked::motion, frame_of(source->in_double(), q, r));
    });
}

// True if the bits are enough for an answer, or to disprove the regime. It has the regime where nothing else can be proved.
bool attempt(const SceneSource& source, const ReferenceQuestion& q, slong bits, bool last, OrbitGuesses& guesses,
             AnswerByReference& answer) {
    const Scene<double>& scene = source->in_double();
    Solution& s = answer.value.emplace();
    const auto disproved = [&](const Reasons& why) {
        answer = {{Outcome::digits_missing, why}, false};
        return true;
    };
    WrittenNumbers w(*q.digits, last);
    const bool needs_boundary = !q.met || q.with_boundary || *q.met == Regime::continuous || !scene.beta;
    const PointInBalls p = point_in_balls(source, needs_boundary);
    s.asked = q.asked;
    s.r = w.shown(p.scene.r);
    s.mu = w.shown(p.scene.mu);
    if (p.scene.beta) s.beta = w.shown(*p.scene.beta);
    s.contact = scene.system.contact;
    if (const std::optional<Ball> base = amplitude_of_base(scene.system.base_motion, p.scene.r))
        s.base_amplitude = w.shown(*base);
    if (p.boundary) write_limits(p, q.asked == Asked::motion || q.asked == Asked::regime || !p.scene.beta, w, s);
    if (p.scene.beta) {
        if (p.boundary) write_regime(p, s);
        Regime regime = q.met.value_or(s.regime.regime);
        // A load on the contact alone never moves it from rest where static friction is not below its largest value.
        if (!q.closed_form_alone && is_loaded_contact(scene) && p.sticking && *p.scene.beta >= *p.sticking)
            regime = Regime::permanent_sticking;
        if (p.boundary && regime != Regime::stick_slip && regime != s.regime.regime &&
            std::ranges::find(s.regime.other, regime) == s.regime.other.end())
            return disproved(Reasons(Why::regime_disproved) + s.regime.reason);
        if (q.met && regime != Regime::stick_slip) set_regime(p, regime, s);
        if (q.asked == Asked::regime || (q.closed_form_alone && regime != Regime::continuous)) {
            s.method.model = q.closed_form_alone ? "boundary of the sliding regime" : "boundaries";
            if (q.met && regime == Regime::stick_slip)
                set_regime_by_stops(p, orbit_in_balls(source, q, p.scene.r, bits, guesses), s);
        } else if (regime == Regime::continuous) {
            write_sliding(p, scene, q, w, s);
        } else if (regime == Regime::permanent_sticking) {
            if (!write_stuck(p, scene, q, w, s)) return disproved(Why::hold_disproved);
        } else {
            const OrbitInBalls orbit = orbit_in_balls(source, q, p.scene.r, bits, guesses);
            write_orbit(orbit, scene, p.scene.r, q, w, s);
            set_regime_by_stops(p, orbit, s);
        }
        if (has_88(scene) && !q.closed_form_alone && (q.asked == Asked::regime || regime == Regime::permanent_sticking))
            s.sticking_by_88 = w.shown(sticking_limit_by_88(p.scene, load_row(scene.system).index));
    } else {
        s.method.model = "boundary of the sliding regime";
    }
    finish_lists(scene.system, q, s);
    s.relative_error = w.largest_error();
    s.method.precision = "reference";
    s.method.why = {Why::proved, bits};
    s.method.proved = true;
    return w.enough();
}

} // namespace

AnswerByReference solution_by_reference(const SceneSource& source, const ReferenceQuestion& question,
                                        const std::function<std::vector<OrbitGuess>()>& made) {
    ReferenceQuestion q = question;
    q.digits = question.digits.value_or(digits_by_default);
    const slong first = bits_for(*q.digits);
    const slong most = std::max<slong>(8192, 4 * first);
    OrbitGuesses guesses(made);
    AnswerByReference answer;
    Refusal none = with_enough_bits(source, first, most, [&](const SceneSource& paid, slong bits, bool last) {
        return attempt(paid, q, bits, last, guesses, answer);
    });
    if (none.is_answered()) return answer;
    const RegimeAtPoint& regime = answer.value->regime;
    const bool told = !q.met && regime.regime == Regime::stick_slip && !regime.reason.empty();
    if (told) none.why += Reasons(Why::certain) + regime.reason;
    return {{std::move(none)}, told ? std::optional(true) : std::nullopt};
}

} // namespace denhartog
