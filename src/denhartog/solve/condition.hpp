/// @file
/// @brief A scene with one of its numbers changed, its amplitudes, and how much these change with the numbers of a scene.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "denhartog/number/certified.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

struct SceneReader;
struct Solution;

/// @brief The place of a number in the JSON of a scene: of a key, or of a list's key with the place, counted from 1, behind a slash.
/// InputError where there is no such number.
[[nodiscard]] nlohmann::json::json_pointer place_of(const std::string& key, const nlohmann::json& scene);

/// @brief The amplitudes at the point of a scene.
struct AmplitudesOfScene {
    std::vector<Certified>
        amplitudes{};  ///< of the masses asked for, in the scene's unit of length, else of P / k_1; none if refused
    Reasons refused{}; ///< why there is no answer
};

/// @brief Solves a scene for the amplitude of a mass, or of all, paid from a budget, if there is one. InputError where it breaks a rule.
[[nodiscard]] AmplitudesOfScene amplitudes_of(const nlohmann::json& scene, std::optional<Mass> mass, double damping_tolerance,
                                              Effort* effort);

/// @brief The condition of the amplitudes for one number of a scene.
struct ConditionOfAmplitudes {
    std::string number;                           ///< its key; of a list with the place, counted from 1, behind a slash
    std::vector<std::optional<double>> of_masses; ///< of each mass: the relative change of its amplitude over that of the number
};

/// @brief The conditions of all amplitudes, \f$ \frac{p}{X_k}\frac{\partial X_k}{\partial p} \f$, for each
/// number p of a scene that is not zero and that it has a line for: masses, stiffnesses, damping ratios, frequency, the force or the
/// base's motion, and friction.
///
/// They are estimates to two digits, by differences of answers on both sides with two steps that agree. There is none where they
/// do not agree, as where the regime changes, where an answer is missing, or where a mass does not move. Entries of matrices are
/// left out, because one changes with its mirror image; so are `mu`, the lists of loads and their phases.
/// @param scene              the text of the scene
/// @param damping_tolerance  as in `System`
/// @param effort             the work allowed to all answers together; null: each has its own
/// @return                   one for each number, in the order of the scene
/// @throws                   InputError if the scene breaks a rule
[[nodiscard]] std::vector<ConditionOfAmplitudes> conditions_of(std::string_view scene, double damping_tolerance = 0,
                                                               Effort* effort = nullptr);

/// @brief A mode so near to its resonance, and with so little damping, that amplitudes hang on the last digits of the scene.
struct SensitiveMode {
    std::size_t mode; ///< the mode, counted from 0
    double R;         ///< its frequency ratio, Eq. (22)
    double change;    ///< by what part its amplitude changes if R changes by a unit in the last place
};

/// @brief The first mode that the load excites and whose amplitude a unit in the last place of R changes by more than a thousandth.
///
/// \f$ |v_d| \f$ of (23) changes by \f$ (1-R)/((1-R)^2+\zeta^2) \f$ of itself, for a relative change of R. A damping matrix has none
/// unless it is zero.
/// @eq{23}
/// @param source  the scene, with r
/// @return        the mode, or none
[[nodiscard]] std::optional<SensitiveMode> sensitive_mode(const std::shared_ptr<const SceneReader>& source);

/// @brief What an answer is said to depend on too much, in words: that mode, unless the contact rests for good.
/// @param source    the scene, with r
/// @param solution  its answer
/// @return          a sentence without its full stop; empty where there is nothing to say
[[nodiscard]] std::string warning_of(const std::shared_ptr<const SceneReader>& source, const Solution& solution);

} // namespace denhartog
