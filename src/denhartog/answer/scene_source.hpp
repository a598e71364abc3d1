/// @file
/// @brief A scene that can be had in every number type.
#pragma once

#include <memory>

#include "denhartog/scene/scene_json.hpp"

namespace denhartog {

class Ball;

namespace reference {
class KeptModes;
}

/// @brief How a scene is had in every number type.
struct SceneReader {
    std::shared_ptr<reference::KeptModes> kept_modes{}; ///< of its system, shared by the scenes made from it; null: not kept
    virtual ~SceneReader() = default;
    [[nodiscard]] virtual const Scene<double>&
    in_double() const = 0; ///< @return the scene in double, which lives as long as this
    /// @brief The scene for the reference, in the bits of the moment and as its author wrote it: not in coordinates of its own.
    /// @param scene  gets it @throws PrecisionError where there is none, as in a library built without the reference
    virtual void in_balls(Scene<Ball>& scene) const;
};

/// @brief A scene in every number type: one tenth written as text is one tenth to all the digits of each.
///
/// It is in the paper's form, see `in_own_coordinates`: what is computed from it comes in the order of `displacement_of`.
using SceneSource = std::shared_ptr<const SceneReader>;

/// @brief A scene from its JSON text.
/// @param part  the text of one scene; copied
/// @return      the source; each of its functions throws InputError where the text is no scene
[[nodiscard]] SceneSource scene_source(const SceneText& part);

/// @brief A scene from numbers in double: the same binary fractions in every number type.
/// @param scene  the scene
/// @return       the source
[[nodiscard]] SceneSource scene_source(const Scene<double>& scene);

/// @brief The same of a scene that somebody keeps, unchanged, as long as the source is in use. @param scene the scene
/// @return the source; a scene of the paper is not copied
[[nodiscard]] SceneSource source_of_kept(const Scene<double>& scene);

/// @brief The same scene at another point. @param source a scene @param r frequency ratio @param beta friction ratio
/// @return the source: r and beta are these doubles in every number type
[[nodiscard]] SceneSource at_point(const SceneSource& source, double r, double beta);

/// @brief The same scene at a frequency ratio, without a friction ratio: its boundary is asked for.
/// @param source  a scene
/// @param r       frequency ratio
/// @return        the source: r is this double in every number type
[[nodiscard]] SceneSource at_frequency(const SceneSource& source, double r);

/// @brief The same scene with another ratio of static to kinetic friction. @param source a scene @param mu Eq. (3)
/// @return the source: mu is this double in every number type
[[nodiscard]] SceneSource with_static_friction(const SceneSource& source, double mu);

/// @brief The same scene with another tolerance of its damping matrix. @param source a scene @param tolerance see `System`
/// @return the source
[[nodiscard]] SceneSource with_damping_tolerance(const SceneSource& source, double tolerance);

/// @brief The same system at mu = 1, with frequency ratio and friction ratio left out.
/// @param source  a scene
/// @return        the source
[[nodiscard]] SceneSource without_point(const SceneSource& source);

/// @brief The same scene with the friction ratio left out: its boundary is asked for, not its regime.
/// @param source  a scene
/// @return        the source
[[nodiscard]] SceneSource without_friction_ratio(const SceneSource& source);

} // namespace denhartog
