/// @file
/// @brief The scene of a system of a study: what its axes and samples have put in place of the scene's own numbers.
#pragma once

#include <nlohmann/json.hpp>

#include "denhartog/scene/scene.hpp"
#include "denhartog/sweep/plan.hpp"

namespace denhartog::sweep {

/// @brief A system of a study with its columns.
struct SystemAt {
    Scene<double> scene;           ///< the scene
    std::vector<double> frequency; ///< r, or frequencies in hertz: all of the axis, or the one that is drawn
    std::vector<double> friction;  ///< beta, or friction forces
};

/// @brief Makes the scenes of a study. Nothing in it changes when it is used.
class SceneAt {
public:
    /// @param plan  the plan; must outlive the object
    explicit SceneAt(const Plan& plan);

    /// @brief A system. @param point the place of one of its points along every axis of the grid @return the system
    /// @throws InputError where its numbers make no scene
    [[nodiscard]] SystemAt at(const std::vector<std::size_t>& point) const;
    /// @brief The study's scene with one quantity changed. @param target the quantity @param value its value @return the scene
    /// @throws InputError where that is no scene
    [[nodiscard]] Scene<double> with(const Target& target, double value) const;
    /// @brief The study's scene as it stands, without its own point. @return the scene
    [[nodiscard]] Scene<double> unvaried() const;
    /// @brief A drawn value. @param sample its index @param variable the place of the variable @return the value
    [[nodiscard]] double drawn(std::uint64_t sample, std::size_t variable) const;

private:
    const Plan& plan_;
    nlohmann::json scene_; // without a point of its own
    std::size_t masses_;
    std::size_t sample_; // place of the axis of samples
    UnitSamples samples_;
};

} // namespace denhartog::sweep
