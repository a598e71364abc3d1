#include "denhartog/answer/exact_cycles.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/paper_algorithm/last_period.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/steady_state.hpp"

namespace denhartog {
namespace {

bool failed(const ExactMotion& run, PaperMotion& motion) {
    motion.phases += static_cast<long>(run.phases.size());
    if (run.status == MotionStatus::complete) return false;
    motion.status = IntegrationStatus::chattering;
    motion.reason = in_words(run.status == MotionStatus::open ? Why::too_fast : Why::chattering);
    return true;
}

// Between two masses the contact moves by the difference of their displacements, of which double has to have some digits.
void require_digits_of_contact(const ContactSystem& s) {
    if (!s.stuck.contact.b) return;
    const double of_one = compliance(s.basis, static_cast<Eigen::Index>(s.stuck.contact.a));
    if (unit_of<double>() * of_one * s.stuck.k_contact > 3e-7) throw PrecisionError(Why::masses_tied);
}

// Nothing bounds the errors of the motion: its modes are those of the reference where double does not have nine digits of their
// frequencies.
ContactSystem system_of(const SceneSource& source) {
    constexpr double most = 1e-9;
    Tried<ContactSystem> system = tried([&] { return contact_system(source->in_double().system); });
    if (system.value && std::ranges::all_of(system.value->detuned, [](double part) { return part <= most; }))
        return *std::move(system.value);
    return moving_by_reference(source, Why::frequency_without_digits);
}

} // namespace

PaperMotion exact_cycles(const SceneSource& source, const PaperSettings& settings) {
    const Scene<double>& scene = source->in_double();
    check(scene);
    check(settings, number_of_masses(scene.system));
    (void)frequency_ratio_of(scene);
    (void)friction_ratio_of(scene);
    const std::size_t N = number_of_masses(scene.system);
    const ContactSystem system = system_of(source);
    require_digits_of_contact(system);
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    const double period = 2 * pi<double>(), last = settings.tau_0 + period * (settings.cycles - 1);
    State state = settings.start.value_or(at_rest(N));
    PaperMotion motion;
    int direction = 2;       // of the phase across the start of the last period, 2 where there is none
    double rest_from = last; // where a rest across the start of the last period began
    if (last > settings.tau_0) {
        const ExactMotion& before = solver.run(state, settings.tau_0, last);
        if (failed(before, motion)) return motion;
        state = before.end;
        direction = before.phases.back().direction;
        if (direction == 0) rest_from = before.phases.back().start;
    }
    const double end = settings.tau_0 + period * settings.cycles;
    const ExactMotion run = solver.run(state, last, end);
    if (failed(run, motion)) return motion;
    if (run.phases.front().direction == direction) --motion.phases;

    const Contact& contact = system.stuck.contact;
    LastPeriod period_seen(N, last, 0, contact);
    for (std::size_t n = 0; n < run.phases.size(); ++n) {
        const Phase& p = run.phases[n];
        if (p.direction == 0)
            period_seen.take_rest(n == 0 ? rest_from : p.start, p.end, contact.of(&run.states[2 * N * n]), p.end == end);
    }
    period_seen.write(motion);
    const std::vector<Extremum> largest = solver.largest_displacements();
    for (std::size_t k = 0; k < largest.size(); ++k) {
        PaperMassMotion& mass = k < N ? motion.masses[k] : *motion.between;
        mass.amplitude = std::abs(largest[k].x);
        if (motion.slides && largest[k].x != 0) mass.phase = wrapped(largest[k].instant + (largest[k].x < 0 ? pi<double>() : 0));
    }
    motion.end = run.end;
    std::size_t phase = 0;
    for (int n = 0; n < settings.samples; ++n) {
        motion.sample_times.push_back(period * n / settings.samples);
        const double tau = last + motion.sample_times.back();
        while (phase + 1 < run.phases.size() && run.phases[phase].end < tau) ++phase;
        motion.samples.push_back(solver.state_at(phase, tau));
    }
    return motion;
}

} // namespace denhartog
