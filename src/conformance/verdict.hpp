/// @file
/// @brief Verdicts on answers, by what the method of the program can do, and the score of an implementation: counts of verdicts
/// and digits for each tier and group, but never one percentage.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/vector.hpp"

namespace denhartog::conformance {

/// @brief Verdict on an answer.
enum class Verdict : std::uint8_t {
    pass,         ///< right to the digits that the question allows in double
    pass_loose,   ///< right to fewer digits, which is still as good as a careful user needs
    inaccurate,   ///< roughly right, but with too few digits
    as_printed,   ///< wrong; the value is that of an equation as the paper prints it
    wrong,        ///< wrong
    wrong_regime, ///< wrong; the answer belongs to another regime
    rejected,     ///< right: the question had to be rejected, and it was
    not_rejected, ///< wrong: the question had to be rejected, but it was answered
    skipped,      ///< not answered, which is no fault by itself
    crash,        ///< the program ended, closed its output, or wrote without an end
    timeout,      ///< no answer in time, while the program was computing
    stall         ///< no answer in time, while the program was waiting
};

/// @brief Number of verdicts.
inline constexpr std::size_t number_of_verdicts = 12;

/// @brief A verdict as reports write it. @param verdict the verdict @return e.g. `pass-loose`
[[nodiscard]] std::string_view name(Verdict verdict);

/// @brief A verdict by its name. @param name e.g. `pass-loose` @return the verdict; empty if none has the name
[[nodiscard]] std::optional<Verdict> verdict_named(std::string_view name);

/// @brief Rank of a verdict, to compare two runs. @param verdict the verdict @return 0 for the best, equal ones equally bad
[[nodiscard]] int badness(Verdict verdict);

/// @brief Whether an answer is right. @param verdict its verdict @return true for `pass`, `pass-loose` and `rejected`
[[nodiscard]] inline bool is_right(Verdict verdict) { return badness(verdict) <= 1; }

/// @brief Whether an answer has a value that is not right to its digits. @param verdict its verdict
/// @return true for `inaccurate`, `as-printed`, `wrong` and `wrong-regime`
[[nodiscard]] bool is_wrong_value(Verdict verdict);

/// @brief Whether a program broke in place of an answer. @param verdict the verdict @return true for `crash`, `timeout`, `stall`
[[nodiscard]] inline bool is_broken(Verdict verdict) { return badness(verdict) == 5; }

/// @brief A vector with the verdict on the answer to it.
struct Judged {
    const Vector* vector = nullptr;     ///< what was asked
    Verdict verdict = Verdict::skipped; ///< the verdict
    std::string reason;                 ///< why, if there is more to say than the verdict
    std::string equation;               ///< for `as-printed`: the equation that is printed so
    bool answered = false;              ///< whether the program gave an answer that can be used
    Value given;                        ///< the answer; empty if there is none
    std::optional<double> error;        ///< largest error divided by the vector's scale, if both answers are numbers
    std::size_t worst = 0;              ///< index of the number with the largest error, from 0
};

/// @brief Number of correct digits at a relative error. @param error relative error @return from 0 to 17
[[nodiscard]] double digits(double error);

/// @brief Counts of verdicts.
using Counts = std::array<std::size_t, number_of_verdicts>;

/// @brief The score in one group of one tier.
struct Score {
    std::string tier;                    ///< `must`, `should` or `stress`
    std::string group;                   ///< the group
    std::size_t asked = 0;               ///< number of questions
    Counts counts{};                     ///< verdicts on them
    std::optional<double> median_digits; ///< median of the correct digits of numerical answers; empty if there are none
    std::optional<double> worst_digits;  ///< fewest correct digits of a numerical answer; empty if there are none
};

/// @brief Counts verdicts. @param judged the answers @return the counts
[[nodiscard]] Counts counts_of(std::span<const Judged> judged);

/// @brief Scores by tier, most binding first, and group. @param judged the answers @return the scores
[[nodiscard]] std::vector<Score> scores(std::span<const Judged> judged);

/// @brief Error divided by the tolerance of `pass`. @param judged an answer @return the quotient; empty without an error
[[nodiscard]] std::optional<double> error_over_tolerance(const Judged& judged);

/// @brief The answers that are not right: those of a program that broke, then by links of the chain of quantities, words last;
/// within a link by verdict, then by error over tolerance. @param judged the answers
/// @return pointers into them, without the skipped ones
[[nodiscard]] std::vector<const Judged*> worst_first(std::span<const Judged> judged);

/// @brief Whether an implementation conforms: it answered something, every answer of the tier `must` is right or skipped, and
/// none of the needed quantities is skipped. @param judged the answers @param needed quantities that must not be skipped
/// @return whether it does
[[nodiscard]] bool conforms(std::span<const Judged> judged, const std::set<std::string>& needed);

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

/// @brief Largest difference between two lists of numbers, measured as the quantity demands. @param asked the quantity
/// @param given numbers @param reference as many numbers @return the difference
[[nodiscard]] Difference difference(const Quantity& asked, const std::vector<double>& given,
                                    const std::vector<double>& reference);

/// @brief Whether an answer is another one than the true one: within `near` of the other, relative to its size, and no further
/// from it than `nearer_than_truth` of its distance from the truth. Words are equal or not. @param v the vector @param given the
/// answer @param other the answer of a mistake, or of a formula beyond its domain @param near a relative distance
/// @return whether it is
[[nodiscard]] bool agrees(const Vector& v, const Value& given, const Value& other, double near);

/// @brief The verdict on an answer. `as-printed` is not among its results: `diagnose` gives it. @param v the vector
/// @param answer the answer to its question @return the verdict with the error; refers to `v`
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

/// @brief A method by its name. @param name e.g. `time-stepping` @return the method @throws InputError for a name that is none
[[nodiscard]] const SolverMethod& method_named(std::string_view name);

/// @brief Widens the tolerances of a vector to what a method can do. @param v the vector @param method the method
void widen(Vector& v, const SolverMethod& method);

/// @brief Kind of tolerance that holds for a question. @param q the question
/// @return `displacement`, `phase` or `duration`; empty where the vector's own hold
[[nodiscard]] std::string kind_of(const ProtocolQuestion& q);

/// @brief The condition number of a vector. @param v the vector @return the largest over its inputs, at least 1
[[nodiscard]] double condition_of(const Vector& v);

/// @brief Why a method cannot know better what the motion is: a transient without end, a boundary of regimes nearby, no start of
/// a rest. @param v the vector @param method the method @return the reason; empty where there is none
[[nodiscard]] std::string excuse_for(const Vector& v, const SolverMethod& method);

/// @brief Takes a wrong answer for a skipped one, with the reason, where the method cannot know better. @param judged the answer
/// @param method the method
void excuse(Judged& judged, const SolverMethod& method);

} // namespace denhartog::conformance
