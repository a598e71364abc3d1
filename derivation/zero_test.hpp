/// @file
/// @brief The trusted base: decides whether an expression is zero.
///
/// Every function in the paper is rational in its symbols, in square roots, and in exponentials and circular functions of
/// angles. These are replaced by generators, each with one relation:
///  - a root y of a, \f$ y^2 = a \f$;
///  - for an angle \f$ \alpha \f$ its cosine c and sine s, \f$ s^2 = 1 - c^2 \f$; multiples and sums of angles by the addition
///    theorems; `atan2(y, x)` is an angle with \f$ c = x/\rho, s = y/\rho, \rho^2 = x^2+y^2 \f$;
///  - an exponential e of a real quantity, without relation; hyperbolic functions through it.
///
/// The result is brought over one denominator and its numerator reduced by the relations. Remainder zero proves that the
/// expression is zero wherever the denominators are not, and these are reported with the proof. A remainder that is not zero
/// proves nothing: the expression is then evaluated with 50 digits at points of the declared domain, and a value that is
/// clearly not zero refutes it, with that point as witness. What is neither is unknown. Points where the second expression has
/// no real value lie outside the domain and are passed over.
///
/// Signs of roots are the one thing that the relations do not carry: the root of a fraction is taken as the quotient of two
/// roots, numerator and denominator made positive at a point of the domain. A proof therefore also asks that the expression be zero
/// with 50 digits at the sample points; a remainder of zero with a value that is not zero is an error of the base, and throws.
#pragma once

#include <ginac/ginac.h>
#include <string>
#include <utility>
#include <vector>

namespace denhartog::derivation {

/// @brief What the zero test found.
enum class Verdict {
    proved,  ///< zero on the domain, by reduction
    refuted, ///< not zero, with a numeric witness
    unknown  ///< neither
};

/// @brief The word for a verdict. @param v a verdict @return proved, refuted or unknown
[[nodiscard]] std::string to_string(Verdict v);

/// @brief A generator and the value of its square.
using SquareRelation = std::pair<GiNaC::ex, GiNaC::ex>;

/// @brief A polynomial in which every square of a generator is replaced by its value, newest generator first, until none is left.
/// @param polynomial  a polynomial in the generators
/// @param relations   generators with their squares, each in older generators alone; newest last
/// @return            its remainder, of degree one at most in each generator
[[nodiscard]] GiNaC::ex reduced(const GiNaC::ex& polynomial, const std::vector<SquareRelation>& relations);

/// @brief A symbol and the values it may take.
struct Range {
    GiNaC::ex symbol;    ///< the symbol
    GiNaC::numeric low;  ///< least value, rational
    GiNaC::numeric high; ///< largest value, rational
};

/// @brief Values for symbols.
using Point = std::vector<std::pair<GiNaC::ex, GiNaC::numeric>>;

/// @brief What the test decided, and on which grounds.
struct Decision {
    Verdict verdict = Verdict::unknown;                      ///< the verdict
    std::vector<GiNaC::ex> denominators;                     ///< what must not be zero, in generators
    std::vector<std::pair<GiNaC::ex, GiNaC::ex>> generators; ///< generators and what they stand for
    Point witness;                                           ///< the point that refutes; empty otherwise
    std::string left;                                        ///< first value at the witness
    std::string right;                                       ///< second value at the witness
    std::string reason;                                      ///< why unknown; or why an expression has no value
};

/// @brief Decides whether two expressions are equal on a domain.
/// @param left    an expression
/// @param right   another
/// @param domain  the symbols that occur, with their ranges; sample points are drawn from it by a fixed seed
/// @return        the decision
[[nodiscard]] Decision decide_equal(const GiNaC::ex& left, const GiNaC::ex& right, const std::vector<Range>& domain);

/// @brief The remainder of an expression after reduction by the relations; zero for an identity.
/// @param e       an expression
/// @param domain  the symbols that occur, with their ranges
/// @return        the reduced numerator, in generators
[[nodiscard]] GiNaC::ex remainder(const GiNaC::ex& e, const std::vector<Range>& domain);

/// @brief The value of an expression at a point.
/// @param e      an expression
/// @param point  values of all its symbols
/// @return       the value with 50 digits or more; complex where a root has a negative argument
/// @throws       std::domain_error where a symbol has no value
[[nodiscard]] GiNaC::numeric evaluate(const GiNaC::ex& e, const Point& point);

/// @brief Sample points of a domain, the same ones on every run.
/// @param domain  symbols and ranges
/// @param count   how many points
/// @return        the points, rational numbers with small denominators
[[nodiscard]] std::vector<Point> sample_points(const std::vector<Range>& domain, int count);

} // namespace denhartog::derivation
