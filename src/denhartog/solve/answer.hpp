/// @file
/// @brief The response to the digits asked for: the cheapest precision that has them, with a measured error bound.
///
/// Every response is computed again in a wider number type, and the difference is what the error bound is made of: twice the
/// largest difference, plus one unit in the last place. `double` is checked in 50 digits, or in `long double` where there are
/// more than 40 masses; 50 digits are checked in 100. Above 100 digits there is no wider type: there the bound is the larger of
/// two, the error measured in 50 digits, scaled by the ratio of the two roundings and by 16, and what a frequency ratio 8 units
/// off in its last place changes. The check takes the instants of the maxima from the response it checks and corrects them by a
/// step of Newton's method. A damping matrix that decouples the modes to the digits of double and no more is checked with the
/// damping ratios that it has in double.
#pragma once

#include <string>
#include <variant>

#include "denhartog/solve/response.hpp"
#include "denhartog/solve/scene_source.hpp"

namespace denhartog {

/// @brief How an answer was computed.
struct Method {
    std::string model;     ///< the model that answers, e.g. `closed form`
    std::string precision; ///< `double`, `50 digits` or `100 digits`
    std::string why;       ///< why this model in this precision
};

/// @brief An answer with its method and what was reached.
struct Answer {
    std::variant<Response<double>, Response<Real50>, Response<Real100>> response; ///< error bounds filled in
    Method method;                                                                ///< how it was computed
    bool digits_reached;   ///< whether the digits asked for, or aimed at, are there
    double relative_error; ///< what was measured of them: twice the largest error, relative as the digits are
};

/// @brief The most digits that can be asked for.
constexpr int most_digits = 95;
/// @brief The digits aimed at where none are asked for.
constexpr int digits_by_default = 6;

/// @brief The response to the digits asked for.
///
/// Digits are relative to the amplitude of the mass for displacements, to the value for friction ratios, absolute for phases;
/// a mass that does not move has none. Up to 15 digits `double` is tried first, up to 45 digits 50 digits, else 100. Where a
/// precision does not have the digits the next one is taken. Without digits asked for, 6 are aimed at; a system of more than 40
/// masses then stays in double, whatever its bound.
/// @param scene   the scene
/// @param digits  significant digits, from 1 to 95
/// @param only    the one mass that must have them: no other has a maximum; none for all
/// @return        the answer
/// @throws        InputError for a bad scene or bad digits; DomainError at a pole of a mode without damping
[[nodiscard]] Answer answer(const SceneSource& scene, std::optional<int> digits = std::nullopt,
                            std::optional<Mass> only = std::nullopt);

/// @brief How often a computation did not have the digits and the next precision was taken, since the program started.
/// @return the count over `answer`, `quantities` and `solve`; tests gate on it
[[nodiscard]] long precision_steps();

/// @brief Counts such a step.
void count_precision_step();

} // namespace denhartog
