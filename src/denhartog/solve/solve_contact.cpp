#include <algorithm>
#include <utility>

#include "denhartog/solve/solve_task.hpp"

namespace denhartog {

SceneSource source_at(const PreparedSystem& p, const SolvePoint& at) {
    return at.source != nullptr ? *at.source : at_point(p.source, at.r, at.beta);
}

bool answer_by_contact(const PreparedSystem& p, const SolvePoint& at, const Question& question, Solution& s) {
    if (!p.contact || !asks_for_contact(question, p.scene().system.contact)) return false;
    const Aim aim = aim_of(question.digits);
    bool slides = true;
    const auto attempt = [&]<class T>(std::type_identity<T>) {
        std::optional<ContactModes<T>> own;
        const ContactModes<T>* modes = nullptr;
        T r, beta;
        if constexpr (std::same_as<T, double>) {
            modes = &*p.contact;
            r = at.r;
            beta = at.beta;
        } else {
            if constexpr (std::same_as<T, Real50>)
                modes = &p.contact_in_50->get();
            else
                modes = &own.emplace(contact_modes_of<T>(p.source));
            const Scene<T> scene = scene_in<T>(source_at(p, at));
            r = *scene.r;
            beta = *scene.beta;
        }
        const std::optional<ContactSolution<T>> found = contact_solution(*modes, as_input(r), as_input(beta));
        slides = found.has_value();
        if (!slides) return Attempted{0};
        s.r = exactly(r, aim.digits);
        s.beta = exactly(beta, aim.digits);
        s.slides_below = exactly(T(found->slides_below.x * (1 - T(aim.tolerance))), aim.digits); // its rounding must not raise it
        s.masses = {{certified(found->amplitude, aim.digits), certified(found->phase, aim.digits), std::nullopt}};
        const double relative = static_cast<double>(T(found->amplitude.e / found->amplitude.x));
        return Attempted{question.asked == Asked::phase ? std::max(relative, static_cast<double>(found->phase.e)) : relative};
    };
    try {
        Certainty found = certify(aim, attempt);
        if (!slides || !found.settled) return false;
        s.method = {"closed form", name(found.precision), std::move(found.why)};
        s.relative_error = found.relative;
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
