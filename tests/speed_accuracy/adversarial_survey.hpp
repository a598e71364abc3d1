/// @file
/// @brief Every question that a user can ask, put to adversarial scenes: what it costs, and what breaks.
///
/// A question is answered, or refused by one of the project's own errors. Any other exception, a number that is not finite, a
/// negative amplitude, and a question that does not end are faults. So are two answers to the same question that contradict each
/// other: numbers of few digits and of many that differ by more than the bounds of both.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/answer/solution.hpp"
#include "tests/speed_accuracy/table.hpp"
#include "tests/support/adversarial_scenes.hpp"

namespace denhartog::tests {

/// Faults of an answer, in words.
using Faults = std::vector<std::string>;

/// Faults of the samples of a motion, an even number of them, equally spaced over its period.
[[nodiscard]] Faults faults_of_samples(const Solution& solution, const std::vector<State>& states);

/// @brief A number of two answers to the same question.
struct Contradiction {
    std::string quantity;  ///< the number
    std::string between;   ///< the questions, e.g. `solve motion, 12 digits`
    double ratio = 0;      ///< their difference over the sum of their bounds; above 1 one of the bounds is false
    double difference = 0; ///< that difference
};

/// @brief What came of one question to one scene.
struct AskedQuestion {
    std::size_t scene = 0;               ///< number of the scene
    std::string question;                ///< the question
    double seconds = 0;                  ///< processor time
    long spent = 0;                      ///< operations, as a budget counts them, where the run allows so many
    long eigen_solves = 0;               ///< counted operations
    long mode_evaluations = 0;           ///< the same
    long phases = 0;                     ///< the same
    std::string outcome;                 ///< `answered`, the type of the error, or how the process ended
    std::string text;                    ///< the error's text
    std::vector<std::string> faults;     ///< what no answer may have
    std::vector<Contradiction> compared; ///< numbers that were compared with those of other answers
    std::string json;                    ///< the scene
};

/// @brief What the comparisons of one quantity came to.
struct ContradictedQuantity {
    long count = 0;       ///< comparisons
    long violations = 0;  ///< of which with a ratio above 1
    Contradiction worst;  ///< the largest ratio
    std::string json;     ///< its scene
    std::string shortest; ///< the shortest scene with a ratio above 1
};

/// @brief The survey.
struct AdversarialSurvey {
    std::size_t scenes = 0;                                      ///< how many were asked
    long questions = 0;                                          ///< how many questions
    double seconds = 0;                                          ///< processor time of all
    std::map<std::string, std::map<std::string, long>> outcomes; ///< by question, by outcome
    std::map<std::string, std::pair<long, AskedQuestion>>
        refusals; ///< by the error's text without its numbers: how many, the first
    std::map<std::string, std::pair<long, AskedQuestion>> faults;    ///< by fault and question: how many, the first
    std::vector<AskedQuestion> dearest;                              ///< the most expensive, descending by processor time
    std::map<std::string, std::pair<long, std::string>> most_phases; ///< by question: the most phases propagated, and the scene
    std::map<std::string, ContradictedQuantity> quantities;          ///< by quantity, or by quantity and questions
    std::map<std::string, std::pair<long, std::string>> most_spent;  ///< by question: the most operations spent, and the scene
    long most_eigen_solves = 0;                                      ///< of one question
    long most_mode_evaluations = 0;                                  ///< of one question

    /// @brief Adds what came of a question. @param asked the question
    void add(AskedQuestion asked);
};

/// @brief How a survey runs.
struct AdversarialRun {
    std::size_t scenes = 10000;          ///< how many
    std::uint64_t seed = 1;              ///< their seed
    AdversarialRange range = everything; ///< what they are drawn from
    bool questions = true;               ///< whether every question is asked
    bool contradictions = true;          ///< whether answers are compared with each other
    bool all_motions = true;        ///< whether `solve` is asked for all motions, which takes seconds where there may be many
    double seconds_a_question = 60; ///< processor time after which one is said not to end, 200 masses or not
    std::optional<long> effort{};   ///< operations that a question may spend; none: the default of its scene
};

/// @brief Comparisons with a ratio above 1. @param survey a survey @return how many
[[nodiscard]] long contradictions_of(const AdversarialSurvey& survey);

/// @brief Asks in this process. @param run how; nothing stops a question that does not end @return what came of it
[[nodiscard]] AdversarialSurvey survey_in_process(const AdversarialRun& run);

/// @brief Asks in processes of their own, one after the other: what ends one of them is a fault of the question that it was at.
[[nodiscard]] AdversarialSurvey survey_in_children(const AdversarialRun& run);

/// @brief A survey as tables. @param survey the survey @return outcomes, refusals, faults, the most expensive
[[nodiscard]] std::vector<Table> tables_of(const AdversarialSurvey& survey);

} // namespace denhartog::tests
