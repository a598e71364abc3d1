// Many points in C: a regime map, `dh_map`, points of one system, `dh_solve_points`, and points of many systems,
// `dh_solve_systems`. The last two share `check_points` and the loop over threads behind them.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <thread>

#include "denhartog/c/denhartog.h"
#include "denhartog/c/handles.hpp"
#include "denhartog/map/map_column.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/solve/solve.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

constexpr std::size_t points_at_a_time = 16; // between two reports
constexpr std::size_t most_points_of_a_call = std::size_t(1) << 40;

unsigned threads_of(unsigned asked) { return asked != 0 ? asked : std::max(1U, std::thread::hardware_concurrency()); }

// Report of progress to the caller's function: once it asks for the end, it is not called again.
class Report {
public:
    Report(dh_progress report, void* context, std::size_t all) : report_(report), context_(context), all_(all) {}

    void operator()(std::size_t done) {
        if (report_ != nullptr && !stop && report_(done, all_, context_) != 0) stop = true;
    }

    std::atomic<bool> stop{false};

private:
    dh_progress report_;
    void* context_;
    std::size_t all_;
};

void need_complete(bool complete) {
    if (!complete) throw PrecisionError("cancelled: no output is written", Outcome::budget_spent);
}

std::vector<Mass> masses_from(std::size_t count, const size_t* masses, std::size_t N) {
    std::vector<Mass> list;
    for (std::size_t n = 0; masses != nullptr && n < count; ++n) list.push_back(mass_from(masses[n], N, "masses"));
    for (std::size_t k = 0; masses == nullptr && k < N; ++k) list.push_back(Mass{k});
    return list;
}

// Arrays that a map and points by themselves both have; those that were not asked for are null.
void write_point(const MapPoint& p, std::ptrdiff_t at, signed char* status, signed char* regime, int* stops, int* periods) {
    const bool known = has_numbers(p.status);
    if (status != nullptr) status[at] = static_cast<signed char>(p.status);
    if (regime != nullptr) regime[at] = static_cast<signed char>(known ? static_cast<int>(p.regime) : -1);
    if (stops != nullptr) stops[at] = known ? p.stops : -1;
    if (periods != nullptr) periods[at] = known ? p.periods : -1;
}

// One point by itself, with its numbers for every mass that is listed; absolute ones where `from_ground` asks for the whole motion.
struct PointAnswer {
    MapPoint point;
    std::vector<SolvedMass> masses;
};

PointAnswer answer_at(const PreparedSystem& prepared, double r, double beta, const Question& question,
                      const std::vector<Mass>& masses, const Allowance& allowed) {
    QuestionEffort effort(0, allowed.operations); // where nobody chose it, `decide` raises it to that of the system
    const Tried<Solution> found = decide(prepared, {r, beta, nullptr, &effort}, question);
    PointAnswer answer{map_point(found), {}};
    if (!found.is_answered()) return answer;
    const std::vector<MassFromGround>& seen = found.value->from_ground;
    for (const Mass k : masses) {
        if (k.index >= number_of_masses(prepared.scene().system)) break; // others of many systems have it
        if (question.asked != Asked::motion)
            answer.masses.push_back(mass_of(*found.value, k));
        else if (k.index < seen.size())
            answer.masses.push_back({seen[k.index].amplitude, seen[k.index].phase, std::nullopt});
    }
    return answer;
}

void write_masses(const PointAnswer& answer, std::size_t masses, std::ptrdiff_t at, const dh_points& out) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t m = 0; m < masses; ++m) {
        const std::ptrdiff_t place = at + static_cast<std::ptrdiff_t>(m) * out.mass_step;
        const SolvedMass* mass = m < answer.masses.size() ? &answer.masses[m] : nullptr;
        const bool moves = mass != nullptr && mass->phase;
        if (out.amplitude != nullptr) out.amplitude[place] = mass != nullptr ? mass->amplitude.value : none;
        if (out.error != nullptr) out.error[place] = mass != nullptr ? error_of_displacements(*mass) : none;
        if (out.phase != nullptr) out.phase[place] = moves ? mass->phase->value : none;
        if (out.phase_error != nullptr) out.phase_error[place] = moves ? mass->phase->error : none;
    }
}

// Place of a point in an array with a step.
template <class Each>
const Each& element(const Each* numbers, std::ptrdiff_t step, std::size_t n) {
    return numbers[static_cast<std::ptrdiff_t>(n) * step];
}

// Rules of a request for points by themselves, whatever systems they are of.
template <class Request>
void check_points(const Request& request) {
    need_length(request.count, most_points_of_a_call, "request->count");
    need(request.r, "request->r");
    need(request.beta, "request->beta");
    for (std::size_t n = 0; n < request.count; ++n) {
        check_frequency_ratio(element(request.r, request.r_step, n));
        check_friction_ratio(element(request.beta, request.beta_step, n));
    }
}

Question question_of(const dh_points& points, int digits, int from_ground, const std::vector<Mass>& masses) {
    if (from_ground != 0) return {Asked::motion, digits_from(digits)};
    Question question{points.phase != nullptr || points.phase_error != nullptr ? Asked::phase : Asked::amplitude,
                      digits_from(digits)};
    if (masses.size() == 1) question.mass = masses.front();
    return question;
}

// Answers point after point, on threads, and writes all of them at the end; `system_at` gives the system of a point, prepared.
template <class Request, class SystemAt>
void solve_all(const Request& request, const dh_points& points, const Question& question, const std::vector<Mass>& masses,
               const SystemAt& system_at) {
    const Allowance allowed = allowance();
    Report report(request.progress, request.context, request.count);
    Progress progress(std::ref(report));
    std::vector<PointAnswer> answers(request.count);
    const std::size_t pieces = (request.count + points_at_a_time - 1) / points_at_a_time;
    parallel_for(pieces, threads_of(request.threads), [&](std::size_t piece) {
        const std::size_t from = piece * points_at_a_time, to = std::min(from + points_at_a_time, request.count);
        for (std::size_t n = from; n < to && !report.stop; ++n)
            answers[n] = answer_at(system_at(n), element(request.r, request.r_step, n),
                                   element(request.beta, request.beta_step, n), question, masses, allowed);
        progress.add(to - from);
        return !report.stop;
    });
    need_complete(!report.stop);
    for (std::size_t n = 0; n < request.count; ++n) {
        const auto at = static_cast<std::ptrdiff_t>(n);
        write_point(answers[n].point, at * points.step, points.status, points.regime, points.stops, points.periods);
        write_masses(answers[n], masses.size(), at * points.masses_step, points);
    }
}

void check_base(const dh_system* system, int from_ground) {
    if (from_ground != 0 && system->prepared.scene().system.base_motion == BaseMotion::none)
        throw InputError("from_ground", "must be 0 where neither base nor wall moves", std::to_string(from_ground));
}

// Least and largest number of masses of the systems of a request, which are there.
std::pair<std::size_t, std::size_t> numbers_of_masses(const dh_systems_request& request) {
    std::size_t least = most_masses, largest = 0;
    for (std::size_t n = 0; n < request.count; ++n) {
        const dh_system* system = element(request.systems, request.system_step, n);
        if (system == nullptr) throw CallError(DH_ERROR_NULL, "request->systems[" + std::to_string(n) + "] must not be null");
        const std::size_t N = number_of_masses(system->prepared.scene().system);
        least = std::min(least, N);
        largest = std::max(largest, N);
    }
    return {least, largest};
}

} // namespace

extern "C" {

int dh_map(const dh_system* system, const dh_map_request* given, const dh_map_result* result) noexcept {
    return guarded_without_effort([&] {
        need(system, "system");
        const dh_map_request all = grown(given, offsetof(dh_map_request, from_ground), "request"), *request = &all;
        const dh_map_result to = grown(result, offsetof(dh_map_result, phase), "result");
        need_length(request->r_count, most_points_of_a_call, "request->r_count");
        need_length(request->beta_count, most_points_of_a_call, "request->beta_count");
        need(request->r, "request->r");
        need(request->beta, "request->beta");
        check_static_friction(request->mu);
        Scene<double> scene = system->prepared.scene();
        scene.mu = request->mu;
        MapRequest map_request;
        map_request.r.assign(request->r, request->r + request->r_count);
        map_request.beta.assign(request->beta, request->beta + request->beta_count);
        map_request.masses = masses_from(request->mass_count, request->masses, number_of_masses(scene.system));
        map_request.start = request->from_sliding != 0 ? MapStart::sliding : MapStart::rest;
        map_request.threads = threads_of(request->threads);
        map_request.effort = allowance().operations;
        map_request.from_ground = request->from_ground != 0;
        map_request.phases = to.phase != nullptr;
        Report report(request->progress, request->context, request->r_count);
        const RegimeMap map = regime_map(scene, map_request, report.stop, std::ref(report));
        need_complete(map.complete);
        const std::size_t masses = map_request.masses.size();
        for (std::size_t m = 0, point = 0; m < request->r_count; ++m)
            for (std::size_t n = 0; n < request->beta_count; ++n, ++point) {
                const auto column = static_cast<std::ptrdiff_t>(m), row = static_cast<std::ptrdiff_t>(n);
                write_point(map.points[point], column * to.r_step + row * to.beta_step, to.status, to.regime, to.stops,
                            to.periods);
                for (std::size_t k = 0; k < masses; ++k) {
                    const std::ptrdiff_t place = column * to.amplitude_r_step + row * to.amplitude_beta_step +
                                                 static_cast<std::ptrdiff_t>(k) * to.mass_step;
                    if (to.amplitude != nullptr) to.amplitude[place] = map.amplitudes[point * masses + k];
                    if (to.phase != nullptr) to.phase[place] = map.phases[point * masses + k];
                }
            }
    });
}

int dh_solve_points(const dh_system* system, const dh_points_request* given, const dh_points* points) noexcept {
    return guarded_without_effort([&] {
        need(system, "system");
        const dh_points_request all = grown(given, offsetof(dh_points_request, from_ground), "request"), *request = &all;
        check_base(system, request->from_ground);
        need_struct(points, "points");
        check_static_friction(request->mu);
        check_points(*request);
        const std::vector<Mass> masses =
            masses_from(request->mass_count, request->masses, number_of_masses(system->prepared.scene().system));
        const Question question = question_of(*points, request->digits, request->from_ground, masses);
        const PreparedSystem prepared =
            prepare(with_static_friction(system->prepared.source, request->mu), question, Prepared::every_regime);
        solve_all(*request, *points, question, masses, [&](std::size_t) -> const PreparedSystem& { return prepared; });
    });
}

int dh_solve_systems(const dh_systems_request* given, const dh_points* points) noexcept {
    return guarded_without_effort([&] {
        const dh_systems_request all = grown(given, offsetof(dh_systems_request, from_ground), "request"), *request = &all;
        need_struct(points, "points");
        need(request->systems, "request->systems");
        need(request->mu, "request->mu");
        check_points(*request);
        for (std::size_t n = 0; n < request->count; ++n) check_static_friction(element(request->mu, request->mu_step, n));
        const auto [least, largest] = numbers_of_masses(*request);
        for (std::size_t n = 0; n < request->count; ++n)
            check_base(element(request->systems, request->system_step, n), request->from_ground);
        const std::vector<Mass> masses =
            masses_from(request->mass_count, request->masses, request->masses != nullptr ? least : largest);
        const Question question = question_of(*points, request->digits, request->from_ground,
                                              request->masses != nullptr ? masses : std::vector<Mass>());
        solve_all(*request, *points, question, masses, [&](std::size_t n) {
            const PreparedSystem& prepared = element(request->systems, request->system_step, n)->prepared;
            const double mu = element(request->mu, request->mu_step, n);
            return mu == 1 ? prepared : with_static_friction(prepared, mu);
        });
    });
}

} // extern "C"
