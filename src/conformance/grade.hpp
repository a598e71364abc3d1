/// @file
/// @brief The verdict on an answer, by what the method of the program can do.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief Largest difference between two values of one question.
struct Difference {
    double size = 0;       ///< angles are compared round the circle if they are in (-pi, pi], curves by `curve_deviation`
    std::size_t worst = 0; ///< index of the number where it is, from 0
};

/// @brief Largest deviation of a motion from the true one, both sampled at equal steps over one period.
///
/// At most samples the deviation is the difference of the two. Around an event the samples do not resolve the motion. There the
/// deviation is the least distance to the true motion within half a step, taken as linear between its samples. A sample is at an
/// event if the true second difference, which stands for the acceleration, changes by more than a quarter of its largest size
/// between neighbouring samples. The half step is allowed nowhere else, as it would pass a motion that is late by half a step.
/// @param given      the motion to be judged
/// @param reference  the true one; as many samples
/// @return           the deviation, in the units of the curves
[[nodiscard]] Difference curve_deviation(const std::vector<double>& given, const std::vector<double>& reference);

/// @brief Largest size of some numbers. @param numbers any numbers @return the largest |x|; 0 if there are none
[[nodiscard]] double size_of(const std::vector<double>& numbers);

/// @brief Largest difference between two lists of numbers, measured as the quantity demands.
/// @param asked      the quantity
/// @param given      numbers
/// @param reference  as many numbers
/// @return           the difference
[[nodiscard]] Difference difference(const Quantity& asked, const std::vector<double>& given,
                                    const std::vector<double>& reference);

/// @brief The verdict on an answer. `as-printed` is not among its results: `diagnose` gives it.
/// @param v       the vector
/// @param answer  the answer to its question
/// @return        the verdict with the error; refers to `v`
[[nodiscard]] Judged grade(const Vector& v, const Answer& answer);

/// @brief A method. Its tolerances are for a condition number of 1 and grow with that of the vector; 0 leaves the vector's own.
struct SolverMethod {
    std::string_view name;  ///< e.g. `time-stepping`
    std::string_view told;  ///< what it is
    Tolerance displacement; ///< of amplitudes and motions, over their scale
    Tolerance phase;        ///< of phases
    Tolerance duration;     ///< of the durations of stops
    double margin = 0;      ///< a regime that is this near to its boundary, relative to beta, may be taken for the one beyond
    bool settles = false;   ///< whether it goes through the transient, which never ends without damping
    bool rests = true;      ///< whether a contact at rest is at rest in it
};

/// @brief All methods; the first is that by which vectors are judged as they stand. @return the methods
[[nodiscard]] std::span<const SolverMethod> methods();

/// @brief A method by its name. @param name e.g. `time-stepping` @return the method
/// @throws InputError for a name that is none
[[nodiscard]] const SolverMethod& method_named(std::string_view name);

/// @brief Widens the tolerances of a vector to what a method can do. @param v the vector @param method the method
void widen(Vector& v, const SolverMethod& method);

/// @brief Kind of tolerance that holds for a question. @param q the question @return `displacement`, `phase` or `duration`;
/// empty where the vector's own hold
[[nodiscard]] std::string kind_of(const ProtocolQuestion& q);

/// @brief The condition number of a vector. @param v the vector @return the largest over its inputs, at least 1
[[nodiscard]] double condition_of(const Vector& v);

/// @brief Why a method cannot know better what the motion is: a transient without end, a boundary of regimes nearby, no start of
/// a rest.
/// @param v       the vector
/// @param method  the method
/// @return        the reason; empty where there is none
[[nodiscard]] std::string excuse_for(const Vector& v, const SolverMethod& method);

/// @brief Takes a wrong answer for a skipped one, with the reason, where the method cannot know better.
/// @param judged  the answer
/// @param method  the method
void excuse(Judged& judged, const SolverMethod& method);

} // namespace denhartog::conformance
