// The steady motion in any regime in C: `dh_solve` and `dh_solve_proved` make a handle, the other functions read masses, stops,
// samples and energies from it. Read `solution_at`, which asks the question.
#include <algorithm>
#include <array>

#include "denhartog/c/handles.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/solve/find.hpp"
#include "denhartog/solve/sampled_solution.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

void hand_out_mass(const SolvedMass& m, dh_mass* result) {
    const double error = error_of_displacements(m);
    const dh_mass all = m.phase ? dh_mass{0, m.amplitude.value, error, m.phase->value, m.phase->error, 1}
                                : dh_mass{0, m.amplitude.value, error, 0, 0, 0};
    need_finite(std::array{all.amplitude, all.error, all.phase, all.phase_error});
    hand_out(all, result);
}

// The instants at which stops begin and end, or the bounds of their errors.
int stops(const dh_solution* solution, size_t count, ValueOrError part, double* start, double* end) noexcept {
    return guarded([&] {
        need(solution, "solution");
        const std::vector<SolvedStop>& all = solution->solution.stops;
        need_count(count, all.size());
        if (count == 0) return;
        need(start, part, "start");
        need(end, part, "end");
        Numbers starts, ends;
        for (const SolvedStop& stop : all) {
            starts.push_back(bounded(stop.start));
            ends.push_back(bounded(stop.end));
        }
        hand_out(part, {{starts, start}, {ends, end}});
    });
}

int solve_at(const dh_system* system, double r, double beta, double mu, int digits, bool proved,
             dh_solution** solution) noexcept {
    return guarded([&] {
        need(system, "system");
        need(solution, "solution");
        *solution = new dh_solution(solution_at(system, r, beta, mu, digits, proved));
    });
}

} // namespace

dh_solution c_interface::solution_at(const dh_system* system, double r, double beta, double mu, int digits, bool proved) {
    check_static_friction(mu);
    Question question;
    question.digits = digits_from(digits);
    question.proved = proved;
    return {at_point(with_static_friction(system->prepared.source, mu), r, beta),
            mu == 1 ? solve(system->prepared, r, beta, question, allowance().effort)
                    : solve(with_static_friction(system->prepared, mu), r, beta, question, allowance().effort)};
}

extern "C" {

int dh_set_effort(double operations, dh_cancelled cancelled, void* context) noexcept {
    return guarded([&] {
        const bool by_default = operations == 0;
        if (!by_default && !(operations >= 1 && operations <= 1e18))
            throw InputError("operations", "must be from 1 to 1e18, or 0", number_to_text(operations));
        allowance() = {by_default ? std::nullopt : std::optional(static_cast<long>(operations)), cancelled, context};
    });
}

int dh_solve(const dh_system* system, double r, double beta, double mu, int digits, dh_solution** solution) noexcept {
    return solve_at(system, r, beta, mu, digits, false, solution);
}

int dh_solve_proved(const dh_system* system, double r, double beta, double mu, int digits, dh_solution** solution) noexcept {
    return solve_at(system, r, beta, mu, digits, true, solution);
}

void dh_solution_destroy(dh_solution* solution) noexcept { delete solution; }

int dh_solution_summary(const dh_solution* solution, dh_summary* summary) noexcept {
    return guarded([&] {
        need(solution, "solution");
        need_struct(summary, "summary");
        const Solution& s = solution->solution;
        dh_summary all{};
        all.regime = static_cast<int>(s.regime.regime);
        all.on_boundary = s.regime.on_boundary;
        all.unique = s.unique;
        all.symmetric = s.symmetric;
        all.periods = s.periods;
        all.relative_error = s.relative_error;
        all.stops = s.stops.size();
        all.rest_interval_exists = s.rest_interval.has_value();
        if (s.rest_interval) {
            all.rest_from = s.rest_interval->from.value;
            all.rest_to = s.rest_interval->to.value;
            all.rest_error = std::max(s.rest_interval->from.error, s.rest_interval->to.error);
        }
        need_finite(std::array{all.rest_from, all.rest_to, all.rest_error, all.relative_error});
        hand_out(all, summary);
    });
}

int dh_solution_is_proved(const dh_solution* solution, int* proved) noexcept {
    return guarded([&] {
        need(solution, "solution");
        need(proved, "proved");
        *proved = solution->solution.method.proved;
    });
}

int dh_solution_is_from_rest(const dh_solution* solution, int* from_rest) noexcept {
    return guarded([&] {
        need(solution, "solution");
        need(from_rest, "from_rest");
        *from_rest = solution->solution.not_from_rest.empty();
    });
}

int dh_solution_warning(const dh_solution* solution, size_t room, char* text) noexcept {
    return guarded([&] {
        need(solution, "solution");
        need(text, "text");
        const std::string warning = warning_of(solution->source, solution->solution);
        if (warning.size() >= room)
            throw CallError(DH_ERROR_SIZE,
                            "room must be at least " + std::to_string(warning.size() + 1) + ", but is " + std::to_string(room));
        std::ranges::copy(std::span(warning.c_str(), warning.size() + 1), text);
    });
}

int dh_solution_mass(const dh_solution* solution, size_t mass, dh_mass* result) noexcept {
    return guarded([&] {
        need(solution, "solution");
        need_struct(result, "result");
        const std::vector<SolvedMass>& masses = solution->solution.masses;
        hand_out_mass(masses[mass_from(mass, masses.size(), "mass").index], result);
    });
}

int dh_solution_from_ground(const dh_solution* solution, size_t mass, dh_mass* result, double* transmissibility,
                            double* transmissibility_error) noexcept {
    return guarded([&] {
        need(solution, "solution");
        need_struct(result, "result");
        const std::vector<MassFromGround>& seen = solution->solution.from_ground;
        const Mass k = mass_from(mass, solution->solution.masses.size(), "mass");
        if (seen.empty()) throw DomainError("neither base nor wall moves: displacements are absolute as they are");
        const MassFromGround& m = seen[k.index];
        need_finite(std::array{m.transmissibility.value, m.transmissibility.error});
        hand_out_mass({m.amplitude, m.phase, std::nullopt}, result);
        if (transmissibility != nullptr) *transmissibility = m.transmissibility.value;
        if (transmissibility_error != nullptr) *transmissibility_error = m.transmissibility.error;
    });
}

int dh_solution_energies(const dh_solution* solution, int digits, dh_energies* found, dh_energies* errors) noexcept {
    return guarded([&] {
        need(solution, "solution");
        need_struct(found, "energies");
        if (errors != nullptr) need_struct(errors, "errors");
        const Energies e = energies(paid(solution->source), solution->solution, digits_from(digits));
        const auto part = [&e](ValueOrError of) {
            dh_energies all{};
            const auto put = [of](const Certified& x, double& to) { to = part_of(x, of); };
            put(e.contact, all.contact);
            put(e.dampers, all.dampers);
            put(e.friction, all.friction);
            put(e.on_base, all.on_base);
            all.contact_moves = e.equivalent.has_value();
            if (!e.equivalent) return all;
            const EquivalentDamping& c = *e.equivalent;
            put(c.coefficient, all.equivalent_damping);
            put(c.ratio, all.equivalent_damping_ratio);
            put(c.textbook_energy, all.textbook_contact);
            put(c.textbook_energy_error, all.textbook_contact_off);
            all.textbook_amplitude_exists = c.textbook_amplitude.has_value();
            if (!c.textbook_amplitude) return all;
            put(*c.textbook_amplitude, all.textbook_amplitude);
            put(*c.textbook_amplitude_error, all.textbook_amplitude_off);
            return all;
        };
        hand_out(part(ValueOrError::value), found);
        if (errors != nullptr) hand_out(part(ValueOrError::error), errors);
    });
}

int dh_solution_contact(const dh_solution* solution, dh_mass* result) noexcept {
    return guarded([&] {
        need(solution, "solution");
        need_struct(result, "result");
        const Solution& s = solution->solution;
        hand_out_mass(s.between ? *s.between : mass_of(s, s.contact), result);
    });
}

int dh_solution_stops(const dh_solution* solution, size_t count, double* start, double* end) noexcept {
    return stops(solution, count, ValueOrError::value, start, end);
}

int dh_solution_stop_errors(const dh_solution* solution, size_t count, double* start_error, double* end_error) noexcept {
    return stops(solution, count, ValueOrError::error, start_error, end_error);
}

int dh_solution_motion(const dh_solution* solution, size_t samples, size_t count, double* x, double* x_prime) noexcept {
    return guarded([&] {
        need(solution, "solution");
        need(x, "x");
        const std::size_t N = number_of_masses(solution->source->in_double().system);
        need_length(samples, most_samples_of(N), "samples");
        need_count(count, samples * N);
        const SampledSolution motion = sampled_solution(paid(solution->source), solution->solution, samples);
        need_finite(motion.x);
        need_finite(motion.x_prime);
        std::ranges::copy(motion.x, x);
        if (x_prime != nullptr) std::ranges::copy(motion.x_prime, x_prime);
    });
}

} // extern "C"
