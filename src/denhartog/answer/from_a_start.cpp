// The motion from a start: in double over many periods, `exact_cycles` and `motion_history`, both by `last_part`; and
// proved, after the load is taken away, until the contact rests, `free_decay`.
#include "denhartog/answer/from_a_start.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/paper_algorithm/last_period.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/steady_state.hpp"
#if DENHARTOG_REFERENCE
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/reference/free_decay.hpp"
#endif

namespace denhartog {
namespace {

bool failed(const ExactMotion& run, PaperMotion& motion) {
    motion.phases += static_cast<long>(run.phases.size());
    if (run.status == MotionStatus::complete) return false;
    motion.status = IntegrationStatus::chattering;
    motion.reason = in_words(run.status == MotionStatus::open ? Why::too_fast : Why::chattering);
    return true;
}

// Where the contact moves by a sum of displacements double has to have some digits of it.
void require_digits_of_contact(const ContactSystem& s) {
    if (!s.stuck.contact.has_own_row()) return;
    const double w_a = s.stuck.contact.w_a,
                 compliance_of_one = w_a * w_a * compliance(s.basis, static_cast<Eigen::Index>(s.stuck.contact.a));
    if (unit_of<double>() * compliance_of_one * s.stuck.k_contact > 3e-7) throw PrecisionError(Why::masses_tied);
}

// The modes are those of the reference where double does not have nine digits of their frequencies.
ContactSystem system_of(const SceneSource& source) {
    constexpr double most = 1e-9;
    Tried<ContactSystem> system = tried([&] { return contact_system(source->in_double().system); });
    if (system.is_answered() && std::ranges::all_of(system.value->detuned, [](double part) { return part <= most; }))
        return *std::move(system.value);
    return std::move(moving_by_reference(source, Why::frequency_without_digits).required());
}

// The system that moves, with the constant forces. Nothing bounds the errors of its motion.
ContactSystem moving_system(const SceneSource& source) {
    ContactSystem system = system_of(source);
    require_digits_of_contact(system);
    const std::vector<double>& constant = source->in_double().static_load;
    if (!constant.empty()) add_static_load(system, constant);
    return system;
}

// The last part of a motion, and what its first phase continues.
struct LastPart {
    const ExactMotion* run = nullptr; // null where it was not reached
    int direction = 2;                // of the phase across its start, 2 where there is none
    double rest_from = 0;             // where a rest across its start began
};

LastPart last_part(ExactSolver& solver, State state, double start, double from, double end, PaperMotion& motion) {
    LastPart part{nullptr, 2, from};
    if (from > start) {
        const ExactMotion& before = solver.run(state, start, from);
        if (failed(before, motion)) return part;
        state = before.end;
        part.direction = before.phases.back().direction;
        if (part.direction == 0) part.rest_from = before.phases.back().start;
    }
    const ExactMotion& run = solver.run(state, from, end);
    if (failed(run, motion)) return part;
    if (run.phases.front().direction == part.direction) --motion.phases;
    part.run = &run;
    return part;
}

} // namespace

PaperMotion exact_cycles(const SceneSource& source, const PaperSettings& settings) {
    const Scene<double>& scene = source->in_double();
    check(scene);
    check(settings, number_of_masses(scene.system));
    (void)frequency_ratio_of(scene);
    (void)friction_ratio_of(scene);
    const std::size_t N = number_of_masses(scene.system);
    const ContactSystem system = moving_system(source);
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    const double period = 2 * pi<double>(), last = settings.tau_0 + period * (settings.cycles - 1);
    const double end = settings.tau_0 + period * settings.cycles;
    PaperMotion motion;
    const LastPart part = last_part(solver, settings.start.value_or(at_rest(N)), settings.tau_0, last, end, motion);
    if (part.run == nullptr) return motion;
    const ExactMotion run = *part.run;

    const Contact& contact = system.stuck.contact;
    LastPeriod period_seen(N, last, 0, contact);
    for (std::size_t n = 0; n < run.phases.size(); ++n) {
        const Phase& p = run.phases[n];
        if (p.direction == 0)
            period_seen.take_rest(n == 0 ? part.rest_from : p.start, p.end, contact.of(&run.states[2 * N * n]), p.end == end);
    }
    period_seen.write(motion);
    const std::vector<Extremum> largest = solver.largest_displacements();
    for (std::size_t k = 0; k < largest.size(); ++k) {
        PaperMassMotion& mass = k < N ? motion.masses[k] : *motion.between;
        mass.amplitude = std::abs(largest[k].x);
        if (motion.slides && largest[k].x != 0) mass.phase = wrapped(largest[k].instant + (largest[k].x < 0 ? pi<double>() : 0));
    }
    motion.end = run.end;
    for (int n = 0; n < settings.samples; ++n) {
        motion.sample_times.push_back(period * n / settings.samples);
        const double tau = last + motion.sample_times.back();
        motion.samples.push_back(solver.state_at(tau));
    }
    return motion;
}

MotionHistory motion_history(const SceneSource& source, const HistorySettings& settings) {
    const Scene<double>& scene = source->in_double();
    check(scene);
    const std::size_t N = number_of_masses(scene.system);
    PaperSettings as_cycles;
    as_cycles.cycles = settings.cycles;
    as_cycles.start = settings.start;
    check(as_cycles, N);
    const int periods = settings.last.value_or(settings.cycles);
    if (periods < 1 || periods > settings.cycles)
        throw InputError("history", "must be all, or from 1 to the number of cycles (" + std::to_string(settings.cycles) + ")",
                         std::to_string(periods));
    if (settings.samples < 0) throw InputError("samples", "must not be negative", std::to_string(settings.samples));
    const std::size_t count = static_cast<std::size_t>(periods) * static_cast<std::size_t>(settings.samples);
    if (count > 0) check_samples("samples", count, N);
    ContactSystem system = moving_system(source);
    if (settings.without_load) take_load_away(system);
    ExactSolver solver(system, {frequency_ratio_of(scene), friction_ratio_of(scene), scene.mu});
    const double from = settings.period * (settings.cycles - periods), end = settings.period * settings.cycles;
    MotionHistory history;
    history.periods = periods;
    history.from = from;
    PaperMotion motion;
    const LastPart part = last_part(solver, settings.start, 0, from, end, motion);
    history.status = motion.status;
    history.reason = motion.reason;
    if (part.run == nullptr) return history;
    const ExactMotion run = *part.run;
    for (std::size_t n = 0; n < run.phases.size(); ++n) {
        const Phase& p = run.phases[n];
        if (p.direction != 0 || !(p.end > p.start)) continue;
        HistoryStop stop{n == 0 ? part.rest_from : p.start, p.end, system.stuck.contact.of(&run.states[2 * N * n])};
        if (p.end == end) stop.end.reset();
        history.stops.push_back(stop);
    }
    for (std::size_t n = 0; n < count; ++n) {
        const double tau = from + settings.period * static_cast<double>(n) / settings.samples;
        const std::size_t phase = run.phase_at(tau);
        history.times.push_back(tau);
        history.states.push_back(solver.state_at(phase, tau));
        history.directions.push_back(run.phases[phase].direction);
    }
    return history;
}

#if DENHARTOG_REFERENCE

namespace {

using namespace reference;

constexpr double enough_of_largest = 1e-17; // error of a number before it is rounded, beside the largest of its kind

// K^-1 s, zero without a constant load.
BallMatrix static_displacements(const SceneSource& source, const BallMatrix& K) {
    Scene<Ball> scene;
    source->in_balls(scene);
    BallMatrix s(K.rows(), 1);
    if (scene.static_load.empty()) return s;
    for (slong k = 0; k < K.rows(); ++k) s(k) = scene.static_load[static_cast<std::size_t>(k)];
    return solution_of(K, s, stiffness_is_open);
}

Certified as_number(const Ball& x) { return printed(x, most_digits_of_a_double); }

// True of numbers that have their digits beside the largest of them.
bool are_certain(const std::vector<Ball>& x) {
    Ball largest(0), error(0);
    for (const Ball& each : x) {
        largest = larger(largest, abs(each));
        error = larger(error, radius_of(each));
    }
    return error.is_zero() || error < largest * Ball(enough_of_largest);
}

bool is_certain(const FreeDecayOf<Ball>& motion) {
    std::vector<Ball> instants, displacements{motion.rest_at};
    for (const TurnOf<Ball>& turn : motion.turns) {
        instants.push_back(turn.tau);
        displacements.push_back(turn.x);
    }
    for (const StopOf<Ball>& stop : motion.stops) instants.push_back(stop.end);
    displacements.insert(displacements.end(), motion.masses.begin(), motion.masses.end());
    return are_certain(instants) && are_certain(displacements);
}

} // namespace

std::vector<Certified> place_of_rest(const SceneSource& source) {
    const Scene<double>& scene = source->in_double();
    std::vector<Certified> places;
    if (scene.static_load.empty()) return places;
    require(with_enough_bits(source, first_bits, most_bits, [&](const SceneSource& paid, slong, bool last) {
        const BallMatrix x = static_displacements(paid, scene_as_given(paid).K);
        std::vector<Ball> all;
        for (slong k = 0; k < x.rows(); ++k) all.push_back(x(k));
        places.clear();
        for (const Ball& each : all) places.push_back(as_number(each));
        return last || are_certain(all);
    }));
    return places;
}

FreeDecay free_decay(const SceneSource& source, const State& start, const std::optional<double>& until) {
    const Scene<double>& scene = source->in_double();
    (void)frequency_ratio_of(scene);
    if (!(friction_ratio_of(scene) > 0))
        throw InputError("friction", "must be positive: without it the free motion does not end", number_to_text(*scene.beta));
    PaperSettings as_cycles;
    as_cycles.start = start;
    check(as_cycles, number_of_masses(scene.system));
    FreeDecay out;
    require(with_enough_bits(source, first_bits, most_bits, [&](const SceneSource& paid, slong, bool last) {
        const SceneInBalls s = damped_scene_in_balls(paid);
        const BallMatrix at_rest = static_displacements(paid, s.K);
        BallMatrix y(s.N(), 1), y_prime(s.N(), 1);
        for (slong k = 0; k < s.N(); ++k) {
            y(k) = Ball(start.x[static_cast<std::size_t>(k)]) - at_rest(k);
            y_prime(k) = Ball(start.x_prime[static_cast<std::size_t>(k)]);
        }
        FreeDecayOf<Ball> motion = free_decay_in_balls(s, y, y_prime, until ? std::optional(Ball(*until)) : std::nullopt, last);
        const Ball shift = (transposed(s.w) * at_rest)(0);
        motion.rest_at += shift;
        for (TurnOf<Ball>& turn : motion.turns) turn.x += shift;
        for (StopOf<Ball>& stop : motion.stops) stop.x += shift;
        for (slong k = 0; motion.at_rest && k < s.N(); ++k) motion.masses[static_cast<std::size_t>(k)] += at_rest(k);
        if (!last && !is_certain(motion)) return false;
        out = {motion.at_rest, {}, {}, as_number(motion.rest_from), as_number(motion.rest_at), {}, motion.others_come_to_rest,
               motion.on_limit};
        for (const TurnOf<Ball>& turn : motion.turns) out.turns.push_back({as_number(turn.tau), as_number(turn.x)});
        for (const StopOf<Ball>& stop : motion.stops)
            out.stops.push_back({as_number(stop.start), as_number(stop.end), as_number(stop.x)});
        for (const Ball& x : motion.masses) out.masses.push_back(as_number(x));
        return true;
    }));
    return out;
}

#endif

} // namespace denhartog
