/// @file
/// @brief A point of a scene as the reference sees it. Included by sources only.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/reference/boundary.hpp"
#include "denhartog/reference/series.hpp"
#include "denhartog/reference/stuck.hpp"

namespace denhartog {

/// @brief What is known of a point in the bits of the moment.
struct PointInBalls {
    reference::SceneInBalls scene{};                        ///< the scene, with its damping matrix
    std::optional<reference::ResponsesInBalls> responses{}; ///< its response functions; none at a pole
    std::optional<reference::BoundaryInBalls> boundary{};   ///< the boundary of the sliding regime; none at a pole
    std::optional<reference::StuckInBalls> stuck{};         ///< the response with the contact held; none where that may resonate
    std::optional<Ball> sticking{};                         ///< the friction ratio from which the contact can rest for ever
};

/// @brief A scene with the damping that counts: ratios, or a matrix; with a `damping_tolerance` of 2 the ratios nearest to that.
/// @param source  the scene
/// @return        the scene in the bits of the moment
/// @throws        Unproved where the bits do not suffice; PrecisionError for a damping tolerance that the reference does not know
[[nodiscard]] reference::SceneInBalls scene_in_balls(const SceneSource& source);

/// @brief The mode shapes of the masses, (17). @param modes the modes @return Psi, mass by mode
[[nodiscard]] BallMatrix shapes_of(const reference::ModesInBalls& modes);

/// @brief The damping matrix in the modes, \f$ \boldsymbol\Psi^T\mathbf{C}\boldsymbol\Psi \f$, whose diagonal has the damping of
/// each by itself.
/// @eq{18}
/// @param scene  a scene with its damping matrix
/// @param modes  its modes
/// @return       the matrix, mode by mode
[[nodiscard]] BallMatrix damping_of_modes(const reference::SceneInBalls& scene, const reference::ModesInBalls& modes);

/// @brief A scene with its damping matrix, (19) where damping is given by ratios. @param source the scene
/// @return  the scene in the bits of the moment
[[nodiscard]] reference::SceneInBalls damped_scene_in_balls(const SceneSource& source);

/// @brief A point of a scene.
/// @param source          the scene
/// @param needs_boundary  whether it is of no use without its boundary
/// @return                the point
/// @throws                Unproved where the bits do not suffice; PrecisionError for a damping tolerance that the reference does not know
[[nodiscard]] PointInBalls point_in_balls(const SceneSource& source, bool needs_boundary);

/// @brief Frees, at the end of this thread, the constants that Arb keeps for it.
void free_constants_of_balls_at_end_of_thread();

/// @brief Doubles the bits until an attempt succeeds.
/// @param N        number of masses, which says what an attempt costs
/// @param first    bits of the first attempt
/// @param most     bits of the last one
/// @param attempt  called with the bits, and whether they are the last; gives an optional, empty where the digits are not certain
/// @return         what it gave
/// @throws         PrecisionError where something cannot be proved, or the budget of work is spent
template <class Attempt>
[[nodiscard]] auto with_more_bits(std::size_t N, slong first, slong most, const Attempt& attempt) {
    free_constants_of_balls_at_end_of_thread();
    std::string why;
    for (slong bits = first;; bits = std::min(2 * bits, most)) {
        const bool last = bits == most;
        QuestionEffort::pay(static_cast<long>(N * N * (N + 8)) * (bits / 64) / 4);
        try {
            const Bits all(bits);
            reference::bits_of_search = 64 * (bits / first);
            if (auto found = attempt(bits, last)) return *std::move(found);
            why = "the digits are not certain with " + std::to_string(bits) + " bits";
        } catch (const reference::Disproved& e) {
            throw PrecisionError(std::string("the reference does not prove it: ") + e.what());
        } catch (const reference::Unproved& e) {
            why = e.what();
        }
        if (last) throw PrecisionError("the reference does not prove it: " + why);
    }
}

} // namespace denhartog
