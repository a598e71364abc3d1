/// @file
/// @brief Functions and roots as symbols, so that an expression becomes a quotient of polynomials that can be factored.
#pragma once

#include <ginac/ginac.h>
#include <map>
#include <utility>
#include <vector>

#include "derivation/algebra/zero_test.hpp"

namespace denhartog::derivation {

/// @brief The polynomial ring of an expression: a symbol for each of its functions and roots.
class FunctionRing {
public:
    /// @brief An expression with symbols in place of functions and roots. @param e the expression @return the quotient
    GiNaC::ex rewrite(const GiNaC::ex& e);

    /// @brief The functions back in place. @param e an expression in symbols @return the same in functions
    [[nodiscard]] GiNaC::ex named(const GiNaC::ex& e) const { return e.subs(meanings_); }

    /// @brief The symbol of a function that occurs. @param function the function @return its symbol, or zero
    [[nodiscard]] GiNaC::ex known(const GiNaC::ex& function) const;

    /// @brief One quotient in lowest terms, numerator and denominator factored. @param rational a quotient @return the same
    [[nodiscard]] GiNaC::ex simplified(const GiNaC::ex& rational) const;

    /// @brief Numerator and denominator in lowest terms; squares of roots and sines replaced. @param rational a quotient
    /// @return the two
    [[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> fraction(const GiNaC::ex& rational) const;

    /// @brief A quotient of polynomials of degree 2 in one exponential, written with hyperbolic functions.
    /// @param rational  the quotient
    /// @return          the same in functions; zero where it is no such quotient
    [[nodiscard]] GiNaC::ex hyperbolic(const GiNaC::ex& rational) const;

private:
    std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> atoms_; // function or root -> its symbol
    GiNaC::exmap meanings_;                                   // symbol -> what is printed
    std::vector<SquareRelation> relations_;                   // newest last

    GiNaC::ex atom(const GiNaC::ex& e, const GiNaC::ex& shown);
    GiNaC::ex exponential(const GiNaC::ex& argument);
    GiNaC::ex root(const GiNaC::ex& radicand);
    [[nodiscard]] GiNaC::ex factored(const GiNaC::ex& polynomial) const;
};

} // namespace denhartog::derivation
