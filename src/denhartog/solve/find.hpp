/// @file
/// @brief Amplitudes as functions of a number of the scene: where it has to be so that one has a given value, or is largest
/// or least, `find`; and how much they change with it, the condition of an answer.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {

/// @brief A number of a scene, and the interval in which it varies.
struct VariedNumber {
    std::string key; ///< its key, such as `friction`; of a list with the place, counted from 1, such as `damping_ratios/2`
    double from = 0; ///< lower end
    double to = 0;   ///< upper end
};

/// @brief The aim of a search for an amplitude.
enum class AmplitudeIs : unsigned char {
    value,   ///< a given value
    largest, ///< the largest over the interval
    least    ///< the least over the interval
};

/// @brief An amplitude and its aim.
struct Wanted {
    Mass mass{};                           ///< the mass
    AmplitudeIs is = AmplitudeIs::value;   ///< the aim
    double value = 0;                      ///< the value that it has to have; in the scene's unit of length, else of P / k_1
    std::optional<VariedNumber> over{};    ///< if it is not the amplitude at one point that counts: what it is taken over
    AmplitudeIs of = AmplitudeIs::largest; ///< whether the largest or the least amplitude over that counts
};

/// @brief Reads `amplitude of mass 2 = 0.075`, `amplitude of mass 2 is least`, `largest amplitude of mass 2 over r 0.5:2 is
/// least`; InputError if it is no such sentence.
[[nodiscard]] Wanted wanted_from(std::string_view text);

/// @brief An interval of a number from the text `A:B`; InputError, of the quantity, if that is not two numbers.
[[nodiscard]] VariedNumber interval_from(const std::string& key, const std::string& ends, const std::string& quantity);

/// @brief The kind of a place that was found.
enum class PlaceIs : unsigned char {
    crossing, ///< the amplitude is certainly below the value at one end, and above it at the other
    jump,     ///< a crossing at two neighbouring doubles or nearly so, where the amplitude does not come near the value
    undecided, ///< it may reach the value, or only come near, which the digits do not tell; of an extreme: it is not certain on both sides
    extreme,     ///< the amplitude is certainly less, or more, at both ends: an extreme lies between
    end_of_range ///< the extreme is at an end of the interval
};

/// @brief The name of a kind of place, as answers have it.
[[nodiscard]] std::string_view name_of(PlaceIs is);

/// @brief A place that was found.
struct FoundPlace {
    PlaceIs is{};          ///< its kind
    double from = 0;       ///< lower end of the interval that holds it
    double to = 0;         ///< upper end
    double at = 0;         ///< where it most likely is
    Certified amplitude{}; ///< the amplitude there
};

/// @brief The result of a search.
struct FoundPlaces {
    std::vector<FoundPlace> places; ///< ascending; of an extreme the one that is the largest, or the least, of all that were seen
    std::vector<double> unanswered; ///< values of the number at which there is no steady motion that is certain
    Outcome outcome{};              ///< the outcome at the first of them
    Reasons why;                    ///< the reason there
    long questions = 0;             ///< the number of motions that were asked for
    long left_out = 0;              ///< the number of them, over a second number, that have no answer
    Reasons left_out_why;           ///< the reason at the first of these
};

/// @brief Seeks the places in the interval.
///
/// The amplitude is asked for at `samples` + 1 places and, if the frequency varies, at the natural frequencies, sliding and
/// stuck. Two neighbours at which it certainly is on different sides of the value hold a crossing, which is then narrowed by
/// bracketing. Where it comes nearer to the value than at the places beside, it is followed to where it is nearest. What lies
/// between two places and shows at neither is not found: the list is not proved to be whole, whereas each crossing in it is
/// proved to the bounds of the amplitudes at its ends. An amplitude that is taken over a second number is the largest, or the
/// least, that was seen there. `effort` is the work allowed to all questions together; null: each has its own. `line` is
/// where the text of the scene begins in its file. PrecisionError if nothing was found and some samples have no answer.
[[nodiscard]] FoundPlaces find_places(std::string_view scene, const VariedNumber& varied, const Wanted& wanted, int samples,
                                      double damping_tolerance = 0, Effort* effort = nullptr, std::size_t line = 1);

/// @brief The largest number of samples of a search.
inline constexpr int most_samples_to_find = 100'000;

/// @brief The condition of the amplitudes for one number of a scene.
struct ConditionOfAmplitudes {
    std::string number;                           ///< its key; of a list with the place, counted from 1, behind a slash
    std::vector<std::optional<double>> of_masses; ///< of each mass: the relative change of its amplitude over that of the number
};

/// @brief The conditions of all amplitudes, \f$ \frac{p}{X_k}\frac{\partial X_k}{\partial p} \f$, for each number p of a scene
/// that is not zero and that it has a line for: masses, stiffnesses, damping ratios, frequency, the force or the base's motion,
/// and friction.
///
/// They are estimates to two digits, by differences of answers on both sides with two steps that agree. There is none where they
/// do not agree, as where the regime changes, where an answer is missing, or where a mass does not move. Entries of matrices are
/// left out, because one changes with its mirror image; so are `mu`, the lists of loads and their phases. `effort` is the work
/// allowed to all answers together; null: each has its own.
[[nodiscard]] std::vector<ConditionOfAmplitudes> conditions_of(std::string_view scene, double damping_tolerance = 0,
                                                               Effort* effort = nullptr);

/// @brief The warning that an answer depends on too much: the first mode that the load excites and whose amplitude a unit in the
/// last place of R changes by more than a thousandth. Where the contact stops it is one that leaves it still: friction keeps the
/// others from growing. A sentence without its full stop, or nothing.
[[nodiscard]] std::string warning_of(const SceneSource& source, const Solution& solution);

} // namespace denhartog
