/// @file
/// @brief A scene that can be had in every number type.
#pragma once

#include <functional>

#include "denhartog/number/multiprecision.hpp"
#include "denhartog/scene/scene_json.hpp"

namespace denhartog {

/// @brief A scene in every number type: one tenth written as text is one tenth to all the digits of each.
///
/// It is in the paper's form, see `in_own_coordinates`: what is computed from it comes in the order of `displacement_of`.
struct SceneSource {
    std::function<Scene<double>()> in_double;      ///< the scene in double
    std::function<Scene<Real50>()> in_50_digits;   ///< the scene in 50 digits
    std::function<Scene<Real100>()> in_100_digits; ///< the scene in 100 digits
};

/// @brief The scene in a number type. @param source the source @return the scene
template <class T>
[[nodiscard]] Scene<T> scene_in(const SceneSource& source) {
    if constexpr (std::same_as<T, double>)
        return source.in_double();
    else if constexpr (std::same_as<T, Real50>)
        return source.in_50_digits();
    else
        return source.in_100_digits();
}

/// @brief A scene from its JSON text.
/// @param part  the text of one scene; copied
/// @return      the source; each of its functions throws InputError where the text is no scene
[[nodiscard]] SceneSource scene_source(const SceneText& part);

/// @brief A scene from numbers in double: the same binary fractions in every number type.
/// @param scene  the scene
/// @return       the source
[[nodiscard]] SceneSource scene_source(const Scene<double>& scene);

/// @brief The same scene at another point. @param source a scene @param r frequency ratio @param beta friction ratio
/// @return the source: r and beta are these doubles in every number type
[[nodiscard]] SceneSource at_point(const SceneSource& source, double r, double beta);

/// @brief The same scene with another ratio of static to kinetic friction. @param source a scene @param mu Eq. (3)
/// @return the source: mu is this double in every number type
[[nodiscard]] SceneSource with_static_friction(const SceneSource& source, double mu);

/// @brief The same scene with another tolerance of its damping matrix. @param source a scene @param tolerance see `System`
/// @return the source
[[nodiscard]] SceneSource with_damping_tolerance(const SceneSource& source, double tolerance);

/// @brief The same scene with the friction ratio left out: its boundary is asked for, not its regime.
/// @param source  a scene
/// @return        the source
[[nodiscard]] SceneSource without_friction_ratio(const SceneSource& source);

} // namespace denhartog
