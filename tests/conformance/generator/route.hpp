/// @file
/// @brief The routes by which the numbers of a vector are computed, each in 50 and in 100 digits.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "conformance/question.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/sliding/regime.hpp"
#include "denhartog/stick_slip/motion_record.hpp"
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
    /// @brief Numbers that answer a question about the scene.
    /// @param q  the question
    /// @return   the numbers; none where the route does not serve the quantity
    virtual std::vector<T> numbers(const ProtocolQuestion& q) = 0;
};

/// @brief The scene of a question in 50 or 100 digits, its numbers taken as exact.
/// @param q  the question
/// @return   the scene; a moving base as the load that it is
/// @throws   InputError as `scene_of`
template <class T>
[[nodiscard]] Scene<T> wide_scene_of(const ProtocolQuestion& q) {
    static_cast<void>(scene_of(q));
    return scene_from_json<T>(nlohmann::json(question_json(q).at("scene")));
}

/// @brief Which of the displacements of a system in its own coordinates a question asks about, see `in_own_coordinates`.
/// @param q       the question
/// @param system  its system, in its own coordinates
/// @return        the place of its mass, or of the contact where it asks about that
template <class T>
[[nodiscard]] std::size_t row_of(const ProtocolQuestion& q, const System<T>& system) {
    return q.mass == 0 ? system.contact.index : displacement_of(system, Mass{static_cast<std::size_t>(q.mass - 1)}).index;
}

/// @brief The closed form, by `src/denhartog/sliding`: sums over modes, boundary, steady state; with the contact held by (88).
/// @param scene   a question about the scene
/// @param regime  the regime, where the quantity depends on it
/// @param near    a route of a scene next to this one, whose instants of maxima are corrected in place of a search; may be none
/// @return        the route; must not outlive `near`
template <class T>
[[nodiscard]] std::unique_ptr<Route<T>> closed_form(const ProtocolQuestion& scene, Regime regime, Route<T>* near = nullptr);

/// @brief The physical coordinates: matrix exponentials over half a period, characteristic polynomial, dense linear systems.
/// @param scene   a question about the scene
/// @param regime  the regime, where the quantity depends on it
/// @return        the route
template <class T>
[[nodiscard]] std::unique_ptr<Route<T>> physical(const ProtocolQuestion& scene, Regime regime);

/// @brief A stick-slip motion, seen in double: where the two routes to it start.
struct OrbitSeen {
    State<double> at_zero;             ///< the state at a maximum of the force, in the system's own coordinates
    std::vector<Phase<double>> phases; ///< phases over half a period, the first a rest
    State<double> at_rest;             ///< the state of the masses at the start of the first phase
};

/// @brief The steady motion from rest, cut off after 24 bits: the routes do not depend on the last digits of double.
/// @param scene  a question about the scene
/// @return       the motion
/// @throws       DomainError where it is not a stable symmetric motion of one period with stops
[[nodiscard]] OrbitSeen orbit_seen(const ProtocolQuestion& scene);

/// @brief Stick-slip by Newton's method on the exact solver.
/// @param scene  a question about the scene
/// @param seen   where to start
/// @return       the route
template <class T>
[[nodiscard]] std::unique_ptr<Route<T>> exact_orbit(const ProtocolQuestion& scene, const OrbitSeen& seen);

/// @brief Stick-slip as one boundary-value problem: Newton's method on the state and all instants of the half-period.
///
/// The phases are matrix exponentials on physical coordinates.
/// @param scene  a question about the scene
/// @param seen   where to start
/// @return       the route
template <class T>
[[nodiscard]] std::unique_ptr<Route<T>> phase_problem(const ProtocolQuestion& scene, const OrbitSeen& seen);

} // namespace denhartog::conformance::generator
