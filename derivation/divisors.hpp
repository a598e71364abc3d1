/// @file
/// @brief What the sides of an identity divide by: quotients become products with inverses, and back.
#pragma once

#include <ginac/ginac.h>
#include <string>
#include <utility>
#include <vector>

namespace denhartog::derivation {

/// @brief What a side divides by, with a symbol for it and one for its inverse. A symbol that is divided by stands for itself.
struct Divisor {
    GiNaC::ex polynomial; // in symbols and generators
    GiNaC::symbol inverse;
    GiNaC::symbol named;
    bool plain = false; // a symbol, a generator or pi
    std::string name, text;
    std::vector<GiNaC::ex> seen; // how it was written, of either sign
};

/// @brief Both sides as polynomials in symbols, generators and inverses of divisors.
class Divisors {
public:
    std::vector<Divisor> all;

    /// An expression with the inverses in place of what is divided by.
    GiNaC::ex without_quotients(const GiNaC::ex& e);
    /// An expanded polynomial times the least product of divisors that leaves no inverse in it, and that product;
    /// divisors by symbols.
    std::pair<GiNaC::ex, GiNaC::ex> cleared(const GiNaC::ex& polynomial) const;
    /// An expression with the polynomials in place of the divisors' symbols.
    GiNaC::ex with_polynomials(const GiNaC::ex& e) const;
    void add(const GiNaC::ex& polynomial);
    static GiNaC::ex shown(const Divisor& d) { return d.plain ? d.polynomial : GiNaC::ex(d.named); }

private:
    GiNaC::ex inverse(const GiNaC::ex& base);
    /// A polynomial, with what divides all its terms as factors.
    static GiNaC::ex factored_content(const GiNaC::ex& polynomial) { return GiNaC::collect_common_factors(polynomial.expand()); }
};

} // namespace denhartog::derivation
