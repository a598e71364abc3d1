/// @file
/// @brief Limits along a path: the leading term of a series, decided exactly, with values near the limit as second witness; and
/// the functions of one mode on expressions, into which a path is put.
#pragma once

#include <ginac/ginac.h>
#include <string>

#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

/// @brief \f$ c\,x^n \f$, what an expression is to leading order for \f$ x \to 0 \f$ from above.
struct LeadingTerm {
    GiNaC::ex coefficient; ///< c, without x
    int power = 0;         ///< n
};

/// @brief The first term of the series of an expression that is not zero.
/// @param e        the expression; a path has been put in, so that x is its one small quantity
/// @param x        the small quantity, a symbol
/// @param highest  the highest power looked at
/// @return         the term
/// @throws         std::domain_error where all terms up to that power vanish
[[nodiscard]] LeadingTerm leading_term(const GiNaC::ex& e, const GiNaC::ex& x, int highest = 4);

/// @brief Whether \f$ e \sim c\,x^n \f$ for \f$ x \to 0 \f$: by the series, and by 60-digit values of
/// \f$ e/(c\,x^n) - 1 \f$, which have to fall with x at points of the other symbols' domain.
/// @param e         the expression
/// @param x         the small quantity, a symbol
/// @param expected  c and n
/// @return          proved; refuted where the series has another leading term; unknown where the two witnesses disagree
[[nodiscard]] Verdict decide_leading_term(const GiNaC::ex& e, const GiNaC::ex& x, const LeadingTerm& expected);

/// @brief (28) on expressions. @param R modal frequency ratio @param zeta modal damping ratio @return u_di
[[nodiscard]] GiNaC::ex first_function(const GiNaC::ex& R, const GiNaC::ex& zeta);

/// @brief (29) on expressions. @param R modal frequency ratio @param zeta modal damping ratio @return g_i
[[nodiscard]] GiNaC::ex second_function(const GiNaC::ex& R, const GiNaC::ex& zeta);

/// @brief (23) on expressions. @param R modal frequency ratio @param zeta modal damping ratio @return |v_di|^2
[[nodiscard]] GiNaC::ex squared_response(const GiNaC::ex& R, const GiNaC::ex& zeta);

/// @brief (67) of a single mass, mu = 1, on expressions. @param r frequency ratio @param zeta damping ratio @return beta_lim^2
[[nodiscard]] GiNaC::ex squared_limit_of_single_mass(const GiNaC::ex& r, const GiNaC::ex& zeta);

/// @brief Adds a statement to an outcome that rests on several.
/// @param outcome  gets the step; its verdict stays proved only where all its statements are
/// @param verdict  what became of the statement
/// @param what     the statement
/// @param latex    its formula; may be empty
void add_statement(Outcome& outcome, Verdict verdict, const std::string& what, const std::string& latex);

/// @brief Adds an argument that a person gave; the claim is then no machine's proof. @param outcome gets the step
/// @param what   the argument
/// @param latex  its formula; may be empty
void add_argument(Outcome& outcome, const std::string& what, const std::string& latex);

/// @brief Adds a claim that the outcome rests on. @param outcome gets the step @param id the claim @param what what it says
void add_claim(Outcome& outcome, const std::string& id, const std::string& what);

} // namespace denhartog::derivation
