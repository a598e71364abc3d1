// The parts that all answers have in common: which masses they list, `finish_lists`, the amplitude and phase of a mass, the
// number of digits that a bound proves, and the sentence on whether these are enough, `verdict`.
#include "denhartog/answer/solution.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>

#include "denhartog/answer/certify.hpp"

namespace denhartog {
namespace {

std::atomic<long> steps{0};

} // namespace

double error_of_displacements(const SolvedMass& m) {
    if (!m.sliding) return m.amplitude.error;
    return std::max({m.sliding->x0.error, m.sliding->v0.error, m.amplitude.error, m.sliding->amplitude_monoharmonic.error});
}

void finish_lists(const System<double>& system, const Question& question, Solution& s) {
    s.contact_with = system.contact_with;
    s.contact_direction = system.contact_direction;
    const std::size_t N = number_of_masses(system);
    const auto keep = [&](std::vector<SolvedMass>& masses) {
        if (question.mass && masses.size() > 1) masses = {masses[question.mass->index]};
        if (masses.size() > N) masses.pop_back();
    };
    if (!question.mass && s.masses.size() > N) s.between = s.masses.back();
    if (!s.masses.empty()) s.only = question.mass;
    keep(s.masses);
    for (OtherMotion& motion : s.motions) keep(motion.masses);
    if (s.start)
        for (std::vector<Certified>* part : {&s.start->x, &s.start->x_prime}) part->resize(N);
    const bool whole = question.asked == Asked::motion && !question.mass;
    if (!whole) s.from_ground.clear();
    if (!whole || system.base_motion != BaseMotion::alone) return;
    for (const SolvedMass& mass : s.masses) s.from_ground.push_back({mass.amplitude, mass.amplitude, mass.phase});
}

const SolvedMass& mass_of(const Solution& s, Mass k) {
    const std::size_t n = s.only == k ? 0 : k.index;
    if (n >= s.masses.size() || (s.only && s.only != k)) throw DomainError({Why::no_amplitude, k.index + 1, s.masses.empty()});
    return s.masses[n];
}

const Certified& Solution::amplitude(Mass k) const { return mass_of(*this, k).amplitude; }

const std::optional<Certified>& Solution::phase(Mass k) const { return mass_of(*this, k).phase; }

double tolerance_of(int digits) {
    constexpr int most = 323; // of a double; beyond, its smallest number stands for all
    static const std::array<double, most + 1> powers = [] {
        std::array<double, most + 1> all{};
        for (int n = 0; n <= most; ++n) {
            const std::string text = "1e-" + std::to_string(n);
            std::from_chars(text.data(), text.data() + text.size(), all[static_cast<std::size_t>(n)]);
        }
        return all;
    }();
    return powers[static_cast<std::size_t>(std::min(digits, most))];
}

Aim aim_of(std::optional<int> digits) {
    if (digits && (*digits < 1 || *digits > most_digits))
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits), std::to_string(*digits));
    const int aimed_at = digits.value_or(digits_by_default);
    return {aimed_at, digits.has_value(), tolerance_of(aimed_at)};
}

int digits_of(double error) {
    constexpr int most = 17;
    int digits = 0;
    while (digits < most && error <= tolerance_of(digits + 1)) ++digits;
    return digits;
}

Reasons verdict(const Attempted& attempted, const Aim& aim) {
    Reasons why{Why::bound, attempted.relative <= aim.tolerance, aim.digits, aim.digits == 1, aim.asked_for};
    if (!attempted.decided) why += Reasons(Why::but) + attempted.doubt;
    return why;
}

long precision_steps() { return steps; }

void count_precision_step() { ++steps; }

} // namespace denhartog
