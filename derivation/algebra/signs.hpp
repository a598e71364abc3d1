/// @file
/// @brief Which polynomials are never negative on a domain, and why.
///
/// A root may be taken apart, or exchanged for another of the same square, only where signs are certain on all of the domain.
/// They are found here by bounds alone; a sample point certifies nothing.
#pragma once

#include <ginac/ginac.h>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief Bounds of a quantity on the domain; none where it has none.
struct Bounds {
    std::optional<GiNaC::numeric> lower; ///< it is never less
    std::optional<GiNaC::numeric> upper; ///< it is never more
};

/// @brief Bounds of symbols and generators.
using KnownBounds = std::map<GiNaC::ex, Bounds, GiNaC::ex_is_less>;

/// @brief Bounds of a polynomial by those of its symbols, term by term.
/// @param polynomial  the polynomial
/// @param known       bounds of symbols; one that is missing has none
/// @return            its bounds; they need not be reached
[[nodiscard]] Bounds bounds_of(const GiNaC::ex& polynomial, const KnownBounds& known);

/// @brief Why a polynomial is not negative anywhere on the domain.
///
/// By the bounds of its terms; as a product of such factors and of squares; or as a quadratic in a symbol, or in its square,
/// whose discriminant is not positive.
/// @param polynomial  the polynomial
/// @param known       bounds of symbols
/// @return            the reason; empty where it is not certain
[[nodiscard]] std::string why_not_negative(const GiNaC::ex& polynomial, const KnownBounds& known);

} // namespace denhartog::derivation
