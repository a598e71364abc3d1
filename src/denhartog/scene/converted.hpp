// Numbers, matrices and systems in another type, rounded where it is narrower. Included by sources only.
#pragma once

#include "denhartog/scene/scene.hpp"

namespace denhartog {

template <class To, class From>
[[nodiscard]] std::vector<To> in_type(const std::vector<From>& x) {
    std::vector<To> out;
    out.reserve(x.size());
    for (const From& each : x) out.push_back(static_cast<To>(each));
    return out;
}

template <class To, class From>
[[nodiscard]] Matrix<To> in_type(const Matrix<From>& A) {
    return A.unaryExpr([](const From& x) { return static_cast<To>(x); });
}

template <class To, class From>
[[nodiscard]] System<To> in_type(const System<From>& s) {
    return {in_type<To>(s.mass_ratios),
            in_type<To>(s.stiffness_ratios),
            in_type<To>(s.mass_matrix),
            in_type<To>(s.stiffness_matrix),
            in_type<To>(s.damping_ratios),
            in_type<To>(s.damping_matrix),
            s.damping_tolerance,
            s.contact,
            s.load,
            s.contact_with,
            in_type<To>(s.load_vector),
            in_type<To>(s.load_phases),
            s.base_motion,
            s.load_error,
            in_type<To>(s.contact_direction)};
}

} // namespace denhartog
