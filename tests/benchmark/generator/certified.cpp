#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <thread>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/parallel.hpp"
#include "tests/benchmark/generator/pack.hpp"

namespace denhartog::benchmark {
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
