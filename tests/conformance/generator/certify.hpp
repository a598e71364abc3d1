/// @file
/// @brief From a case to its vectors: two routes, their agreement, condition numbers, tolerances.
#pragma once

#include <set>

#include "conformance/vector.hpp"

namespace denhartog::conformance::generator {

/// @brief Questions about one scene, on lines one after the other. Of each vector the question, group, tier, flags and the rule that
/// is broken are read. The first tells whether the scene breaks a rule.
using Case = std::vector<Vector>;

/// @brief A question that no vector came of.
struct Refusal {
    std::string id;  ///< its id
    std::string why; ///< a sentence
};

/// @brief What came of a case.
struct Certified {
    std::vector<Vector> vectors;          ///< in the order of the questions
    std::vector<Refusal> refusals;        ///< the others
    std::array<int, 2> least{1000, 1000}; ///< least digits on which the routes agree, not cut off at what vectors state
};

/// @brief Least digits that a vector has in the computation in 100 digits.
inline constexpr int least_digits = 40;

/// @brief Computes the vectors of a case. The tier that a question has is the easiest that its vector may have. `only` has the
/// ids that are wanted; none stands for all.
[[nodiscard]] Certified certify(const Case& c, const std::set<std::string>& only = {});

/// @brief Names of the mistakes that a vector catches: their answers are wrong by more than four times what is inaccurate. Names
/// ascend.
[[nodiscard]] std::vector<std::string> catches_of(const Vector& v);

} // namespace denhartog::conformance::generator
