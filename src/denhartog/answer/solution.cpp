#include "denhartog/answer/solution.hpp"

#include <algorithm>

#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {

double error_of_displacements(const SolvedMass& m) {
    if (!m.sliding) return m.amplitude.error;
    return std::max({m.sliding->x0.error, m.sliding->v0.error, m.amplitude.error, m.sliding->amplitude_monoharmonic.error});
}

void put_in_order_of_masses(const Coordinates<double>& c, Solution& s) {
    if (c.replaced.empty()) return;
    const Mass coordinate = s.contact;
    if (!c.between.empty()) {
        s.contact = c.between[0];
        s.contact_with = c.between[1];
    }
    const auto order = [&](std::vector<SolvedMass>& masses) {
        put_in_order_of_masses<double>(c, masses);
        for (std::size_t n = 0; n < c.replaced.size(); ++n) masses.pop_back();
    };
    if (!s.only && !s.masses.empty()) {
        if (s.contact_with) s.between = s.masses[coordinate.index];
        order(s.masses);
    }
    if (s.start)
        for (std::vector<Certified>* part : {&s.start->x, &s.start->x_prime}) {
            put_in_order_of_masses<double>(c, *part);
            part->resize(part->size() - c.replaced.size());
        }
    for (OtherMotion& motion : s.motions) {
        if (!s.only) order(motion.masses);
        for (State* state : {&motion.from, &motion.start}) {
            take_to_masses(c, state->x);
            take_to_masses(c, state->x_prime);
        }
    }
}

const SolvedMass& mass_of(const Solution& s, Mass k) {
    const std::size_t n = s.only == k ? 0 : k.index;
    if (n >= s.masses.size() || (s.only && s.only != k))
        throw DomainError("the answer has no amplitude of mass " + std::to_string(k.index + 1) +
                          (s.masses.empty() ? ": the closed form does not hold, or the regime alone was asked for" : ""));
    return s.masses[n];
}

const Certified& Solution::amplitude(Mass k) const { return mass_of(*this, k).amplitude; }

const std::optional<Certified>& Solution::phase(Mass k) const { return mass_of(*this, k).phase; }

} // namespace denhartog
