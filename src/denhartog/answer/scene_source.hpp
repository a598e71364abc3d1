/// @file
/// @brief A scene for double and for the reference: `0.1` in its text is the nearest double for the one, exactly 1/10 for the other.
#pragma once

#include <functional>
#include <memory>

#include "denhartog/number/effort.hpp"
#include "denhartog/scene/scene_json.hpp"

namespace denhartog {

class Ball;

namespace reference {
class KeptModes;
}

/// @brief A scene in double, and how the reference reads it.
struct SceneReader {
    std::shared_ptr<const Scene<double>> scene; ///< null where the text is no scene
    std::optional<InputError> error;            ///< why it is none
    std::function<void(Scene<Ball>&)> in_balls; ///< gives the scene as its author wrote it, in the bits of the moment; throws
                                                ///< InputError where the text is no scene; empty without the reference
    std::shared_ptr<reference::KeptModes> kept_modes; ///< of its system, shared by the scenes made from it
    Effort* effort = nullptr;                         ///< the work that questions about it may spend; null: each has its own

    /// @brief The scene in double, which lives as long as this; InputError where the text is no scene.
    [[nodiscard]] const Scene<double>& in_double() const;
};

/// @brief A scene for both floors.
using SceneSource = std::shared_ptr<const SceneReader>;

/// @brief A scene from its JSON text, which is copied.
[[nodiscard]] SceneSource scene_source(const SceneText& part);

/// @brief A scene of numbers in double, which are exact; it is copied.
[[nodiscard]] SceneSource scene_source(const Scene<double>& scene);

/// @brief A scene that lives, unchanged, as long as the source is in use; it is not copied.
[[nodiscard]] SceneSource source_of_kept(const Scene<double>& scene);

/// @{
/// @brief The scene with something changed to doubles, which are exact, or left out.
[[nodiscard]] SceneSource at_point(const SceneSource& source, double r, double beta);
[[nodiscard]] SceneSource at_frequency(const SceneSource& source, double r); ///< without a friction ratio
[[nodiscard]] SceneSource with_static_friction(const SceneSource& source, double mu);
[[nodiscard]] SceneSource with_damping_tolerance(const SceneSource& source, double tolerance);
[[nodiscard]] SceneSource without_point(const SceneSource& source); ///< without r and beta, and with mu = 1
[[nodiscard]] SceneSource without_friction_ratio(const SceneSource& source);
[[nodiscard]] SceneSource with_effort(const SceneSource& source, Effort* effort); ///< with another budget of work
/// @}

/// @brief A scene with the budget of work that it has, or else with one of its own, see `GivenEffort`.
class ScenePaidFor {
public:
    /// @brief Of a scene. The one that is made must not outlive this.
    explicit ScenePaidFor(const SceneSource& source);
    /// @brief The scene.
    [[nodiscard]] const SceneSource& source() const { return source_; }

private:
    GivenEffort effort_;
    SceneSource source_;
};

} // namespace denhartog
