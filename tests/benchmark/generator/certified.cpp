// The boundaries of the scenes of the pack, their motions by both routes, and how long these take to settle.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <thread>

#include "denhartog/answer/reference.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/parallel.hpp"
#include "tests/benchmark/generator/motion.hpp"
#include "tests/benchmark/generator/pack.hpp"
#include "tests/conformance/generator/linear_half_period.hpp"
#include "tests/support/event_integrator.hpp"
#include "tests/support/held_contact.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::benchmark {

Onsets onsets_of(const PackScene& s) {
    ReferenceQuestion question;
    question.asked = Asked::regime;
    question.digits = 48;
    const SceneSource scene = without_friction_ratio(scene_source(scene_of(s)));
    Tried<Solution> answer = solution_by_reference(scene, question, [] { return std::vector<OrbitGuess>(); });
    const Limits limits = *answer.required().limits;
    if (!limits.sticking) throw DomainError("no friction holds the contact of " + s.id);
    return {Real50(limits.exact.decimal), Real50(limits.sticking->decimal)};
}

Onsets onsets_of_half_period(const PackScene& s) {
    using namespace conformance::generator;
    const HalfPeriodProblem<Real50> p = half_period_problem(scene_of(s));
    const Eigen::Index N = p.M.rows(), j = static_cast<Eigen::Index>(p.contact.index);
    const Real50 mu = Real50(s.F_static) / s.F;
    const LinearHalfPeriod<Real50> h = linear_half_period(p, 512);
    const Real50 re = h.Y(j, 0), im = h.Y(N + j, 0), U = U_of(h, h.w);
    const Real50 demand = std::max(largest_demand(h), Real50(acceleration_at_start(h) + (mu - 1) / p.M(j, j)));
    return {sqrt(Real50((re * re + im * im) / (U * U + demand * demand))), modulus(tests::held_contact(p).load) / mu};
}

// The motion from rest on the physical coordinates, phase by phase: matrix exponentials in 50 digits, and no modes.

namespace {

using Number = Real50;
using std::abs;

constexpr int most_periods = 20000;
constexpr int steps = 128; // a period: no phase of the scenes that ends in one and starts another is shorter

} // namespace

std::vector<int> periods_to_settle(const Scene<double>& scene, const Motion& settled, const std::vector<double>& tolerances) {
    const Sample& end = settled.samples.front();
    const std::size_t N = end.x.size();
    Number largest(0);
    for (std::size_t k = 0; k < N; ++k) largest = std::max({largest, Number(abs(end.x[k])), Number(abs(end.x_prime[k]))});
    if (largest == 0) largest = 1;
    std::vector<int> periods(tolerances.size(), 0);
    std::size_t next = 0;
    const HalfPeriodProblem<Number> problem = half_period_problem(scene);
    tests::EventIntegrator<Number> motion(problem, Number(scene.mu) * problem.beta, steps);
    const Vector<Number> zero = Vector<Number>::Zero(static_cast<Eigen::Index>(N));
    motion.start(zero, zero);
    for (int n = 1; n <= most_periods && next < tolerances.size(); ++n) {
        const tests::FollowedMotion<Number>& now = motion.go_on(steps);
        Number apart(0);
        for (std::size_t k = 0; k < N; ++k)
            apart = std::max({apart, Number(abs(now.x(static_cast<Eigen::Index>(k)) - end.x[k])),
                              Number(abs(now.x_prime(static_cast<Eigen::Index>(k)) - end.x_prime[k]))});
        while (next < tolerances.size() && apart <= tolerances[next] * largest) periods[next++] = n;
    }
    return periods;
}

namespace {

const double period = 2 * pi<double>();

// Lengths of the phases of a period, in tau; of a rest or a slide over its end the whole.
std::vector<double> lengths(const Motion& motion) {
    std::vector<double> all;
    for (std::size_t n = 0; n < motion.events.size(); ++n) {
        const bool last = n + 1 == motion.events.size();
        const Real50 end = last ? Real50(motion.events[0].tau + 2 * pi<Real50>()) : motion.events[n + 1].tau;
        all.push_back(static_cast<double>(Real50(end - motion.events[n].tau)));
    }
    return all;
}

bool stops(const Motion& motion) {
    return motion.rests || std::any_of(motion.events.begin(), motion.events.end(), [](const Event& e) { return e.after == 0; });
}

double distance(double F, const Real50& onset) { return std::abs(static_cast<double>(Real50(F / onset - 1))); }

} // namespace

const std::vector<double>& settling_tolerances() {
    static const std::vector<double> all{1e-3, 1e-6, 1e-9, 1e-12};
    return all;
}

CertifiedScene certified(const PackScene& asked) {
    CertifiedScene s;
    s.scene = asked;
    s.onsets = onsets_of(asked);
    const Scene<double> scene = scene_of(asked);
    s.motion = library_motion(scene);
    const Motion by_the_other_route = physical_motion(scene, s.motion);
    s.digits = agreement(s.motion, by_the_other_route);
    if (s.digits < least_digits)
        throw DomainError("the routes to the motion of " + asked.id + " agree on " + std::to_string(s.digits) + " digits only");
    CertifiedScene twin = s;
    twin.motion = by_the_other_route;
    twin.onsets = onsets_of_half_period(asked);
    if (json_of(twin) != json_of(s)) throw DomainError("the routes to " + asked.id + " do not give the same 17 digits");
    s.settles = periods_to_settle(scene, s.motion, settling_tolerances());
    s.regime = s.motion.rests ? "permanent_sticking" : stops(s.motion) ? "stick_slip" : "continuous";
    const bool slides = Real50(asked.F) < s.onsets.sliding, sticks = !(Real50(asked.F) < s.onsets.sticking);
    if (s.regime != (sticks ? "permanent_sticking" : slides ? "continuous" : "stick_slip"))
        throw DomainError("the motion of " + asked.id + " is not in the regime that its friction has");

    const std::vector<double> phases = lengths(s.motion);
    const double shortest = phases.empty() ? period : *std::min_element(phases.begin(), phases.end());
    const double margin = std::min(distance(asked.F, s.onsets.sliding), distance(asked.F, s.onsets.sticking));
    const int settles = s.settles[1] == 0 ? 1 << 30 : s.settles[1];
    double resting = s.motion.rests ? period : 0;
    for (std::size_t n = 0; n < phases.size(); ++n) resting += s.motion.events[n].after == 0 ? phases[n] : 0;
    if (resting > period / 4) s.exposes.emplace_back("creep");
    const bool nothing_moves = asked.m.size() == 1 && s.regime == "stick_slip"; // while it rests: no error bounds a step
    if (shortest < period / 32 || phases.size() > 4 || nothing_moves) s.exposes.emplace_back("missed event");
    if (margin <= 1e-3) s.exposes.emplace_back("trapped event");
    if (settles > 50) s.exposes.emplace_back("transient");
    if (asked.F_static > asked.F) s.exposes.emplace_back("static friction");
    const bool hard = margin <= 1e-3 || shortest < period / 128 || settles > 400;
    const bool easy = margin > 1.0 / 64 && shortest >= period / 32 && settles <= 50 && asked.F_static == asked.F;
    s.difficulty = hard ? "hard" : easy ? "easy" : "medium";
    return s;
}

std::vector<CertifiedScene> certify_all(const std::filesystem::path& pack, bool progress) {
    std::vector<PackScene> all;
    for (const nlohmann::json& s : nlohmann::json::parse(std::ifstream(pack / "scenes.json"))) all.push_back(pack_scene(s));
    std::vector<CertifiedScene> scenes(all.size());
    std::vector<std::string> faults(all.size());
    parallel_for(all.size(), std::max(1U, std::thread::hardware_concurrency()), [&](std::size_t n) {
        try {
            scenes[n] = certified(all[n]);
        } catch (const std::exception& e) {
            faults[n] = all[n].id + ": " + e.what();
        }
        if (progress)
            std::fprintf(stderr, "%s %s, %d digits\n", all[n].id.c_str(),
                         faults[n].empty() ? scenes[n].regime.c_str() : faults[n].c_str(), scenes[n].digits);
        return true;
    });
    for (const std::string& fault : faults)
        if (!fault.empty()) throw DomainError(fault);
    return scenes;
}

} // namespace denhartog::benchmark
