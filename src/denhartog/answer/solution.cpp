#include "denhartog/answer/solution.hpp"

#include <algorithm>
#include <utility>

#include "denhartog/number/why.hpp"

namespace denhartog {

double error_of_displacements(const SolvedMass& m) {
    if (!m.sliding) return m.amplitude.error;
    return std::max({m.sliding->x0.error, m.sliding->v0.error, m.amplitude.error, m.sliding->amplitude_monoharmonic.error});
}

void take_contact_between(const System<double>& system, Solution& s) {
    if (!contact_moves_apart(system)) return;
    s.contact_with = system.contact_with;
    s.contact_direction = system.contact_direction;
    if (!s.only && !s.masses.empty()) {
        s.between = s.masses.back();
        s.masses.pop_back();
    }
    if (s.start)
        for (std::vector<Certified>* part : {&s.start->x, &s.start->x_prime}) part->pop_back();
    if (!s.only)
        for (OtherMotion& motion : s.motions) motion.masses.pop_back();
}

Solution required(AnswerOrNone answer) {
    if (answer.outcome == Outcome::at_a_pole) throw DomainError(answer.refused);
    if (!answer.is_answered()) throw PrecisionError(answer.refused);
    return std::move(answer.solution);
}

const SolvedMass& mass_of(const Solution& s, Mass k) {
    const std::size_t n = s.only == k ? 0 : k.index;
    if (n >= s.masses.size() || (s.only && s.only != k)) throw DomainError({Why::no_amplitude, k.index + 1, s.masses.empty()});
    return s.masses[n];
}

const Certified& Solution::amplitude(Mass k) const { return mass_of(*this, k).amplitude; }

const std::optional<Certified>& Solution::phase(Mass k) const { return mass_of(*this, k).phase; }

} // namespace denhartog
