/// @file
/// @brief Everything that a C++ user needs: a scene, `solve`, `boundary`, `map`, `motion`, and the errors.
///
/// Almost every number of an answer is a `Certified`: a value with a bound of its error and, if you ask for more than 15 digits,
/// its decimals. Displacements are in units of P / k_1, and time is tau = omega t. `mu` is the ratio of static to kinetic
/// friction, Eq. (3). Masses are counted from 0 here, as in `Mass{0}`, and from 1 in JSON.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "denhartog/answer/solution.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/scene.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/solve/sampled_solution.hpp"

namespace denhartog {

/// @brief Reads a scene from JSON text.
/// @param json  the text of one scene; docs/scene.schema.json lists the keys
/// @return      the scene; it keeps every rule of `check`, and is non-dimensional even if the text is in physical units
/// @throws      InputError if the text is not JSON or breaks a rule; it names the quantity, the rule, the value and the place
[[nodiscard]] Scene<double> scene(std::string_view json);

/// @brief Finds the steady motion of a scene at its point (r, beta), in every regime.
///
/// If the contact slides throughout, the closed form answers, Eqs. (38), (39) and (44) to (53). If it sticks and slips, an exact
/// solver finds the periodic motion. If it never moves, the response with the contact held answers.
/// @param scene     the scene; needs r > 0 and beta >= 0. Every double is taken as exact
/// @param question  what you ask for, e.g. `{.digits = 10}`
/// @return          the answer, with a bound of the error of each number
/// @throws          InputError if the scene or the question breaks a rule; DomainError if a mode without damping is at a pole;
///                  PrecisionError if the digits asked for cannot be reached, or if no steady motion is found
[[nodiscard]] Solution solve(const Scene<double>& scene, const Question& question = {});

/// @brief Computes the friction ratios that separate the regimes at the frequency ratio of a scene.
///
/// Below `Limits::exact` the contact slides throughout. From `Limits::sticking` on it can rest for ever.
/// @eq{56,67,69,88}
/// @param scene   the scene; needs r > 0, and its beta is not used
/// @param digits  significant digits, from 1 to `most_digits`; by default the aim is 6, and it may be missed
/// @return        the boundary, with a bound of the error of each number
/// @throws        InputError if the scene or `digits` breaks a rule; DomainError if a mode without damping is at a pole;
///                PrecisionError if the digits asked for cannot be reached
[[nodiscard]] Limits boundary(const Scene<double>& scene, std::optional<int> digits = std::nullopt);

/// @brief Computes the regime, the amplitudes of all masses and the number of stops over a grid of (r, beta).
///
/// A number that the map gives has 6 digits or more. A point that cannot be answered has a `PointStatus` that says why, and its
/// amplitudes are NaN.
/// @param scene  the system and mu; its r and beta are not used
/// @param r      frequency ratios, positive; at least one
/// @param beta   friction ratios, zero or positive; at least one
/// @return       the map: point n of column m is at m times the length of `beta` plus n
/// @throws       InputError if the scene or the grid breaks a rule
[[nodiscard]] RegimeMap map(const Scene<double>& scene, const std::vector<double>& r, const std::vector<double>& beta);

/// @brief Samples the steady motion of a scene at equally spaced instants of its period.
///
/// tau is zero where the force is largest. The period of the motion may be several periods of the force.
/// @param scene    the scene; needs r > 0 and beta >= 0
/// @param samples  number of instants in a period of the motion, from 1 to `most_samples_of(N)`
/// @return         displacements in units of P / k_1 and velocities with respect to tau, of all masses
/// @throws         InputError, DomainError and PrecisionError as `solve` does
[[nodiscard]] SampledSolution motion(const Scene<double>& scene, std::size_t samples);

/// @brief Energies that the steady motion dissipates in a period of the force, friction as an equivalent dashpot, and the forces
/// that it hands to wall and base. Every number is proved.
/// @param scene   the scene; needs r > 0 and beta >= 0
/// @param digits  significant digits, from 1 to `most_digits`; by default 6
/// @return        energies and forces, in units of P^2 / k_1 and P
/// @throws        InputError, DomainError and PrecisionError as `solve` does; PrecisionError if the library was built without the
///                reference
[[nodiscard]] Energies energies(const Scene<double>& scene, std::optional<int> digits = std::nullopt);

} // namespace denhartog
