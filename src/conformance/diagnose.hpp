/// @file
/// @brief Diagnosis of an implementation: the known mistakes whose answers it gives, and what its other wrong answers have
/// in common.
///
/// A mistake is a signature: it explains a wrong answer that agrees with the answer of the mistake, to the mistake's own
/// `agreement`, and that is at least ten times nearer to it than to the truth. docs/diagnosis.md says what contradicts it, and
/// when it is named.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief Mistakes, each that has a number of its own, such as a grid of instants, with the number that fits some answers best.
/// @param judged the answers @param known the mistakes @return the mistakes
[[nodiscard]] std::vector<Mistake> fitted_to(std::span<const Judged> judged,
                                             std::vector<Mistake> known = {mistakes().begin(), mistakes().end()});

/// @brief Thresholds that a mistake must reach to be named. docs/diagnosis.md shows what happens without each threshold.
struct Thresholds {
    double consistency = 0.95; ///< explained answers over the sum of those and the ones that contradict it
    double of_solvers = 0.9;   ///< the same for a mistake of solvers, whose answers agree with it in a few digits only
    double of_its_own = 0.5;   ///< explained answers over all answers that it would have made wrong
    double of_the_wrong = 0.7; ///< explained answers over the wrong ones to the quantities of its core, or that it explains
    double agreement = 0;      ///< the agreement asked of a mistake is at least this, which the program's method can reach
    std::size_t words = 17;    ///< words and counts, if it explains nothing else: 2^-17 times the mistakes is below 1/1000
};

/// @brief A known mistake that was found, or a guess, which has a name and a sentence alone and does not say where to look.
struct Finding {
    Mistake mistake;                     ///< the mistake, with the number of its own that the answers show
    std::size_t explained = 0;           ///< number of wrong answers that it explains
    std::size_t contradicted = 0;        ///< number of answers that contradict it
    bool weak = false;                   ///< whether fewer than three answers are its only evidence
    std::vector<std::string> quantities; ///< the quantities of the answers that it explains
    const Judged* example = nullptr;     ///< the explained answer with the largest error
    Value mistaken;                      ///< what the mistake answers there
};

/// @brief A property that wrong answers have in common, a quantity, or a link of the chain of quantities, each made of those
/// before it: the first that is wrong is where to look.
struct InCommon {
    std::string property;      ///< in words: `mu > 1`, `amplitude`, `shapes`
    std::size_t wrong = 0;     ///< number of unexplained wrong answers that have it
    std::size_t all_wrong = 0; ///< number of all unexplained wrong answers
    std::size_t asked = 0;     ///< number of answers to the same quantities that have it
    std::size_t all_asked = 0; ///< number of all answers to the same quantities
};

/// @brief The diagnosis of an implementation.
struct Diagnosis {
    std::size_t wrong = 0;                  ///< number of answers that are wrong or inaccurate
    std::vector<Finding> findings;          ///< the mistakes that were found, the strongest evidence first
    std::vector<const Judged*> unexplained; ///< wrong answers that no mistake found explains
    std::vector<InCommon> chain;            ///< the unexplained answers by link of the chain of quantities, those that were asked
    std::vector<Finding> simple;            ///< guesses at the unexplained answers, the best first
    std::vector<InCommon> by_quantity;      ///< the unexplained answers by quantity; `asked` counts all answers to it
    std::vector<InCommon> in_common;        ///< properties that those in the first wrong link have more often than right answers
    std::map<std::string, std::size_t> accepted; ///< rules broken by questions that were answered, and how many questions
};

/// @brief Looks for known mistakes.
/// @param judged the answers; a wrong answer that an equation gives as printed gets the verdict `as-printed`
/// @param known the mistakes @param least what a mistake must reach to be named
/// @param guess whether to look for simple explanations as well: a factor or an offset, another value of one input
/// @return the diagnosis; it refers to the answers
[[nodiscard]] Diagnosis diagnose(std::span<Judged> judged, std::span<const Mistake> known, const Thresholds& least = {},
                                 bool guess = true);

} // namespace denhartog::conformance
