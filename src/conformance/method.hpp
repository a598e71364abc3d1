/// @file
/// @brief Methods by which implementations answer, with the errors that a sound one makes.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

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

/// @brief The agreement with a mistake's answer that a method can show. @param method the method @return relative to the size
[[nodiscard]] double least_agreement(const SolverMethod& method);

} // namespace denhartog::conformance
