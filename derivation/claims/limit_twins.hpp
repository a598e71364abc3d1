/// @file
/// @brief Limits with their altered twins: what is proved of a leading term must be refuted of another one.
#pragma once

#include <ginac/ginac.h>

#include "derivation/algebra/limits.hpp"
#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

/// @brief `decide_leading_term`, and the same for its twins: the coefficient doubled, its sign changed, the power one higher and
/// one lower.
/// @param e         the expression
/// @param x         the small quantity, a symbol
/// @param expected  coefficient and power
/// @return          the verdict on the term; unknown where a twin of a proved term is not refuted
[[nodiscard]] Verdict decide_term_and_twins(const GiNaC::ex& e, const GiNaC::ex& x, const LeadingTerm& expected);

/// @brief Whether an expression is zero, and one more than it is not. @param e the expression
/// @return  proved, refuted or unknown; unknown where the twin of a proved zero is not refuted
[[nodiscard]] Verdict decide_zero_and_twin(const GiNaC::ex& e);

/// @brief A claim on an order, a limit or a path, decided by its own check.
/// @param id           unique name
/// @param equations    equations it is about
/// @param title        one sentence
/// @param assumptions  under which it holds
/// @param check        decides it
/// @return             the claim
[[nodiscard]] Claim claim_on_limit(std::string id, std::vector<std::string> equations, std::string title,
                                   std::vector<std::string> assumptions, std::function<Outcome()> check);

} // namespace denhartog::derivation
