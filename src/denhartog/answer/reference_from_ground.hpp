/// @file
/// @brief Absolute displacements of a proved motion. Included by sources only.
#pragma once

#include "denhartog/answer/from_ground.hpp"
#include "denhartog/answer/printed.hpp"
#include "denhartog/answer/reference.hpp"

namespace denhartog {

/// @brief How far the frame of the displacements moves, where absolute ones are wanted beside them; none where they are absolute.
[[nodiscard]] inline std::optional<Ball> frame_of(const Scene<double>& scene, const ReferenceQuestion& q, const Ball& r) {
    const BaseMotion motion = scene.system.base_motion;
    if (q.asked != Asked::motion || q.mass || motion == BaseMotion::none || motion == BaseMotion::alone) return std::nullopt;
    return amplitude_of_base(motion, r);
}

/// @brief A mass as it is seen from the ground; its numbers have the bounds that are written beside them.
[[nodiscard]] inline MassFromGround from_ground(const Ball& amplitude, const std::optional<Ball>& phase, const Ball& base,
                                                const WrittenNumbers& w) {
    MassFromGround seen{w.shown(amplitude), w.shown(amplitude / base), std::nullopt};
    if (phase && !amplitude.is_zero()) seen.phase = w.shown(*phase);
    return seen;
}

/// @brief Writes the amplitude of base or wall, and the masses as they are where their displacements are absolute.
inline void write_base(const Scene<double>& scene, const ReferenceQuestion& q, const Ball& r, const WrittenNumbers& w,
                       Solution& s) {
    if (const std::optional<Ball> base = amplitude_of_base(scene.system.base_motion, r)) s.base_amplitude = w.shown(*base);
    if (scene.system.base_motion != BaseMotion::alone || q.asked != Asked::motion || q.mass) return;
    for (const SolvedMass& mass : s.masses) s.from_ground.push_back({mass.amplitude, mass.amplitude, mass.phase});
}

} // namespace denhartog
