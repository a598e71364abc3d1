/// @file
/// @brief The divisors of an identity: quotients become products with inverses, and back.
#pragma once

#include <ginac/ginac.h>
#include <string>
#include <utility>
#include <vector>

namespace denhartog::derivation {

/// @brief A divisor, with a symbol for it and one for its inverse. A symbol that is divided by stands for itself.
struct Divisor {
    GiNaC::ex polynomial;        ///< in symbols and generators
    GiNaC::symbol inverse;       ///< stands for its inverse
    GiNaC::symbol named;         ///< stands for itself
    bool plain = false;          ///< whether it is a symbol, a generator or pi
    std::string name;            ///< what Coq calls it
    std::string text;            ///< the polynomial in Coq
    std::vector<GiNaC::ex> seen; ///< how it was written, of either sign
};

/// @brief Both sides as polynomials in symbols, generators and inverses of divisors.
class Divisors {
public:
    std::vector<Divisor> all; ///< in the order in which they were found

    /// @brief An expression with the inverses in place of its divisors. @param e the expression @return it without quotients
    GiNaC::ex without_quotients(const GiNaC::ex& e);
    /// @brief An expanded polynomial times the least product of divisors that leaves no inverse in it; divisors by symbols.
    /// @param polynomial  the polynomial @return  the product of the two, and the second of them
    std::pair<GiNaC::ex, GiNaC::ex> cleared(const GiNaC::ex& polynomial) const;
    /// @brief An expression with the polynomials in place of the divisors' symbols. @param e it @return it without the symbols
    GiNaC::ex with_polynomials(const GiNaC::ex& e) const;
    /// @brief Adds a divisor. @param polynomial what is divided by
    void add(const GiNaC::ex& polynomial);
    /// @brief A divisor as an identity shows it. @param d the divisor @return its symbol, or itself where it is plain
    static GiNaC::ex shown(const Divisor& d) { return d.plain ? d.polynomial : GiNaC::ex(d.named); }

private:
    GiNaC::ex inverse(const GiNaC::ex& base);
    /// A polynomial, with what divides all its terms as factors.
    static GiNaC::ex factored_content(const GiNaC::ex& polynomial) { return GiNaC::collect_common_factors(polynomial.expand()); }
};

} // namespace denhartog::derivation
