/// @file
/// @brief The routes by which the numbers of a vector are computed, each in 50 and in 100 digits.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "conformance/question.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/stick_slip/motion_record.hpp"
#include "tests/support/half_period.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::conformance::generator {

/// @brief A way to the numbers of one scene.
template <class T>
class Route {
public:
    Route() = default;
    Route(const Route&) = delete;
    Route& operator=(const Route&) = delete;
    virtual ~Route() = default;
    /// @brief Numbers that answer a question about the scene. None where the route does not serve the quantity.
    virtual std::vector<T> numbers(const ProtocolQuestion& q) = 0;
};

/// @brief The scene of a question in 50 or 100 digits, its numbers taken as exact. A moving base is the load that it is. Throws
/// as `scene_of` does.
template <class T>
[[nodiscard]] Scene<T> wide_scene_of(const ProtocolQuestion& q) {
    static_cast<void>(scene_of(q));
    return scene_from_json<T>(nlohmann::json(question_json(q).at("scene")));
}

/// @brief The numbers of a mass that slides, whose members are named as in `MassResponse`. None where the mass alone does not
/// have the quantity.
template <class SlidingMass>
[[nodiscard]] auto numbers_of_sliding(const SlidingMass& m, const std::string& quantity) -> std::vector<decltype(m.x0)> {
    if (quantity == "amplitude") return {m.amplitude};
    if (quantity == "phase") return {m.phase};
    if (quantity == "amplitude_monoharmonic") return {m.amplitude_monoharmonic};
    if (quantity == "phase_monoharmonic") return {m.phase_monoharmonic};
    if (quantity == "initial_displacement") return {m.x0};
    if (quantity == "initial_velocity") return {m.v0};
    return {};
}

/// @brief The physical coordinates: matrix exponentials over half a period, characteristic polynomial, dense linear systems. The
/// regime is that of the scene, where the quantity depends on it.
template <class T>
[[nodiscard]] std::unique_ptr<Route<T>> physical(const ProtocolQuestion& scene, Regime regime);

/// @brief A stick-slip motion, seen in double: where the two routes to it start.
struct OrbitSeen {
    std::vector<Phase> phases; ///< phases over the stretch, the first a rest
    State at_rest;             ///< the state of the masses at the start of the first phase
    int halves = 1;            ///< half-periods of the force in the stretch; it mirrors itself where they are odd

    [[nodiscard]] int sign() const { return halves % 2 == 1 ? -1 : 1; } ///< what the stretch does to a state
};

/// @brief The steady motion from rest, cut off after 24 bits: the routes do not depend on the last digits of double. DomainError
/// where it is not a stable motion with stops.
[[nodiscard]] OrbitSeen orbit_seen(const ProtocolQuestion& scene);

/// @brief The reference: the paper's own formulas on balls, every number proved. The regime is that of the scene, where the
/// quantity depends on it. `seen` is a motion with stops, near which the one is proved that is asked about; without it the scene
/// is asked about without stops.
template <class T>
[[nodiscard]] std::unique_ptr<Route<T>> by_reference(const ProtocolQuestion& scene, Regime regime,
                                                     const OrbitSeen* seen = nullptr);

/// @brief Stick-slip as one boundary-value problem: Newton's method on the state and all instants of the stretch.
///
/// The phases are matrix exponentials on physical coordinates. It starts from what was seen.
template <class T>
[[nodiscard]] std::unique_ptr<Route<T>> phase_problem(const ProtocolQuestion& scene, const OrbitSeen& seen);

/// @brief The boundary-value problem of a question's scene, its numbers taken as exact.
template <class T>
[[nodiscard]] HalfPeriodProblem<T> problem_of(const ProtocolQuestion& q);
/// @brief In 50 digits. @param q the question @return the problem
template <>
[[nodiscard]] HalfPeriodProblem<Real50> problem_of(const ProtocolQuestion& q);
/// @brief In 100 digits. @param q the question @return the problem
template <>
[[nodiscard]] HalfPeriodProblem<Real100> problem_of(const ProtocolQuestion& q);

/// @brief How far a base or wall moves, in units of P / k_1. @param q the question @return the amplitude of what moves
template <class T>
[[nodiscard]] T base_of(const ProtocolQuestion& q) {
    return q.base_motion == "with_wall" ? T(1 / (T(q.r) * T(q.r))) : T(1);
}

/// @brief How far the frame of the displacements moves. @param q the question @return the amplitude; 0 of a frame at rest
template <class T>
[[nodiscard]] T frame_of(const ProtocolQuestion& q) {
    return q.base_motion == "with_wall" || q.base_motion == "wall" ? base_of<T>(q) : T(0);
}

} // namespace denhartog::conformance::generator
