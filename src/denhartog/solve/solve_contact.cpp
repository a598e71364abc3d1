#include <algorithm>
#include <utility>

#include "denhartog/solve/solve_task.hpp"

namespace denhartog {

SceneSource source_at(const PreparedSystem& p, const SolvePoint& at) {
    return at.source != nullptr ? *at.source : at_point(p.source, at.r, at.beta);
}

bool answer_by_contact(const PreparedSystem& p, const SolvePoint& at, const Question& question, Solution& s) {
    if (!p.contact || !asks_for_contact(question, p.scene().system)) return false;
    const Aim aim = aim_of(question.digits);
    if (aim.digits > most_digits_in_double) return false;
    try {
        const std::optional<ContactSolution> found = contact_solution(*p.contact, as_input(at.r), as_input(at.beta));
        if (!found) return false;
        const double relative = found->amplitude.e / found->amplitude.x;
        const Attempted attempted{question.asked == Asked::phase ? std::max(relative, found->phase.e) : relative};
        if (!is_settled(attempted, aim)) return false;
        s.r = exactly(at.r);
        s.beta = exactly(at.beta);
        s.slides_below = exactly(found->slides_below.x * (1 - aim.tolerance)); // its rounding must not raise it
        s.masses = {{certified(found->amplitude), certified(found->phase), std::nullopt}};
        s.method = {"closed form", "double", verdict(attempted, aim)};
        s.relative_error = attempted.relative;
    } catch (const DomainError&) {
        return false; // the next model says where the pole is
    } catch (const PrecisionError&) {
        return false;
    }
    s.contact = p.scene().system.contact;
    s.only = s.contact;
    s.regime = {Regime::continuous, {}, false, certainly_slides};
    return true;
}

} // namespace denhartog
