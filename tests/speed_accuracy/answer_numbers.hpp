/// @file
/// @brief Every number of an answer by its name, to look through them and to compare them with those of another answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "denhartog/answer/solution.hpp"
#include "denhartog/solve/quantities.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::tests {

/// @brief A number of an answer.
struct NamedNumber {
    std::string name;      ///< what it is, e.g. `amplitude`
    std::size_t place = 0; ///< mass, stop or multiplier, from 1; 0 where there is but one
    Certified number;      ///< the number
    double period = 0;     ///< of an angle, radians; 0 of any other number
    bool negative = true;  ///< whether it may be negative
};

/// @brief The numbers of a boundary. @param limits the boundary @return its numbers
[[nodiscard]] std::vector<NamedNumber> numbers_of(const Limits& limits);

/// @brief The numbers of an answer that carry a bound. @param s the answer @return its numbers, without those of other motions
[[nodiscard]] std::vector<NamedNumber> numbers_of(const Solution& s);

/// @brief The numbers of another motion that carry a bound. @param motion the motion @return its numbers
[[nodiscard]] std::vector<NamedNumber> numbers_of(const OtherMotion& motion);

/// @brief The numbers of a point. @param q the numbers with their bounds @return the same with their names
[[nodiscard]] std::vector<NamedNumber> numbers_of(const Quantities<Bounded<double>>& q);

/// @brief What no number of an answer may be: not finite, negative where it cannot be, decimals that are no number, a bound that
/// is none or negative. A sentence for each.
[[nodiscard]] std::vector<std::string> faults_of(const std::vector<NamedNumber>& numbers);

/// @brief What contradicts itself within one answer: the boundaries are in order, (56), exact, (67), and no displacement is
/// larger than its amplitude. A sentence for each contradiction beyond the bounds of both numbers.
[[nodiscard]] std::vector<std::string> contradictions_within(const Solution& s);

/// @brief The same of all numbers of an answer, with those that carry no bound. @param s the answer @return a sentence for each
[[nodiscard]] std::vector<std::string> faults_of(const Solution& s);

/// @brief Two answers to the same question.
struct ComparedNumber {
    std::string name;  ///< the number
    double difference; ///< in size; of angles in the shorter way round
    double allowed;    ///< the sum of the bounds of both
};

/// @brief Compares the numbers that two answers both have. A number of stops or other things that differs is no number to
/// compare.
[[nodiscard]] std::vector<ComparedNumber> compared(const std::vector<NamedNumber>& a, const std::vector<NamedNumber>& b);

} // namespace denhartog::tests
