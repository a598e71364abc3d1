/// @file
/// @brief What is the matter with an implementation: known mistakes whose answers its wrong answers are, and what the rest of the
/// wrong ones have in common.
///
/// A mistake is a signature. It explains a wrong answer that agrees with the answer of the mistake, to the mistake's own
/// `agreement`, and is at least ten times nearer to it than to the truth. It is contradicted by every right answer, to whatever
/// quantity, that it would have made wrong, and by every wrong one, to a quantity in which it explains something, that is another
/// than its own. A mistake gets its name where it explains three answers, or all where fewer are wrong in the whole, which is
/// then called weak; where the shares of `Thresholds` are reached; and where it explains a number, if it would have made a number
/// wrong. One that says of what equation it is has to explain a quantity of that equation; others it need not reach. Words and
/// counts alone, which agree by chance, have to be more than chance explains.
///
/// The mistake with the most explained minus contradicted is told first; of two that have as many, the one that other answers
/// contradict less. What it explains is set aside; and so on while one is left.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/chain.hpp"
#include "conformance/fitted.hpp"
#include "conformance/mistakes/mistake.hpp"
#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief The known mistakes, or others in their place.
struct Signatures {
    std::span<const Mistake> mistakes;                                                           ///< what is known
    std::function<std::optional<Value>(std::string_view name, const Question& question)> answer; ///< as `answer_with_mistake`
    /// The number that was found from the answers, in words; empty where a mistake has none of its own.
    std::function<std::string(std::string_view name)> number = {};
};

/// @brief The mistakes of `mistake.hpp`; those with a number of their own, as a grid of instants, with the number that
/// fits some answers best.
/// @param judged  the answers
/// @return        the mistakes with their answers
[[nodiscard]] Signatures known_signatures(std::span<const Judged> judged = {});

/// @brief The mistakes of `mistake.hpp`, some with the numbers that fit.
/// @param fitted  these
/// @param answer  what the others answer
/// @return        the mistakes with their answers
[[nodiscard]] Signatures signatures_with(FittedMistakes fitted,
                                         std::function<std::optional<Value>(std::string_view, const Question&)> answer);

/// @brief What a mistake must reach to get its name. docs/diagnosis.md shows what happens without each of them.
struct Thresholds {
    double consistency = 0.95; ///< of what it explains and what contradicts it, the share that it explains
    double of_solvers = 0.9;   ///< the same for a mistake of solvers, whose answers are near to its own in some digits only
    double of_its_own = 0.5; ///< of all answers, to whatever quantity, that it would have made wrong, the share that it explains
    double of_the_wrong =
        0.5;              ///< of the wrong answers in the links of the chain in which it explains something, the share explained
    double agreement = 0; ///< least agreement: what the method of the program can show, if that is less than a mistake asks
    std::size_t words = 17; ///< words and counts where it explains nothing else: 2^-17 times the mistakes is below 1/1000
};

/// @brief A mistake found.
struct Finding {
    const Mistake* mistake = nullptr;    ///< which
    std::size_t explained = 0;           ///< wrong answers that are its answers
    std::size_t contradicted = 0;        ///< answers that it would make wrong, but that are right or others
    std::string number;                  ///< the number of its own that the answers show, in words; empty where it has none
    bool weak = false;                   ///< whether fewer than three answers are all that it rests on
    std::vector<std::string> quantities; ///< of the answers that it explains
    const Judged* example = nullptr;     ///< the answer explained whose error is the largest
    Value mistaken;                      ///< what the mistake answers there
};

/// @brief Something that wrong answers have in common.
struct InCommon {
    std::string property;      ///< in words: `mu > 1`
    std::size_t wrong = 0;     ///< unexplained wrong answers that have it
    std::size_t all_wrong = 0; ///< unexplained wrong answers
    std::size_t asked = 0;     ///< answers to the same quantities that have it
    std::size_t all_asked = 0; ///< answers to the same quantities
};

/// @brief A simple explanation of answers that no known mistake explains; it names no culprit.
struct Simple {
    std::string told;                    ///< in words: `beta times 1.414`
    std::size_t explained = 0;           ///< wrong answers that are as it says
    std::size_t contradicted = 0;        ///< answers that it would make wrong, but that are right or others
    std::vector<std::string> quantities; ///< of the answers that it explains
};

/// @brief What was found.
struct Diagnosis {
    std::size_t wrong = 0;                       ///< answers that are wrong or inaccurate
    std::vector<Finding> findings;               ///< most telling first
    std::vector<const Judged*> unexplained;      ///< wrong answers of no mistake found
    std::vector<Link> chain;                     ///< where these stand along the chain of quantities
    std::vector<Simple> simple;                  ///< simple explanations of these, most telling first
    std::vector<InCommon> by_quantity;           ///< these by quantity; `asked` counts the answers to the quantity
    std::vector<InCommon> in_common;             ///< what these have in common and the right ones have less often
    std::map<std::string, std::size_t> accepted; ///< broken rules of questions that were answered, with their number
};

/// @brief Looks for known mistakes.
/// @param judged      the answers; wrong ones that are an equation's print become `as-printed`
/// @param signatures  the mistakes
/// @param least       what a name needs
/// @param guess       whether simple explanations are sought as well
/// @return            what was found; refers to the answers
[[nodiscard]] Diagnosis diagnose(std::span<Judged> judged, const Signatures& signatures, const Thresholds& least = {},
                                 bool guess = true);

} // namespace denhartog::conformance
