/// @file
/// @brief The trusted base: decides whether an expression is zero.
///
/// Every function in the paper is rational in its symbols, in square roots, and in exponentials and circular functions of
/// angles. These are replaced by generators, each with one relation:
///  - a root y of a, \f$ y^2 = a \f$;
///  - for an angle \f$ \alpha \f$ its cosine c and sine s, \f$ s^2 = 1 - c^2 \f$; multiples and sums of angles by the addition
///    theorems; `atan2(y, x)` is an angle with \f$ c = x/\rho, s = y/\rho, \rho^2 = x^2+y^2 \f$, and half of it has the cosine
///    \f$ \sqrt{(1+x/\rho)/2} \f$;
///  - an exponential e of a real quantity, without relation; hyperbolic functions through it.
///
/// A polynomial of symbols that stand in no generator is zero where each of its coefficients is, so that these are tried one by
/// one: a sum over modes falls apart into its modes. Each is brought over one denominator and its numerator reduced by the
/// relations. Remainder zero proves that the expression is zero wherever the denominators are not, and these are reported with
/// the proof: every divisor of either side as it stands, also one that cancels. What GiNaC itself cancels when an expression is
/// written, as in \f$ \sin^2\alpha/\sin\alpha \f$, is no divisor here. A remainder that is not zero proves nothing: the expression
/// is then evaluated with 50 digits at points of the declared domain, and a value that is clearly not zero refutes it, with that
/// point as witness. What is neither is unknown. Points where the second expression has no real value lie outside the domain and
/// are passed over.
///
/// Signs of roots are the one thing that the relations do not carry. A root is therefore taken apart, as the quotient of two or
/// as a product, only where bounds make the signs certain on all of the domain (`signs.hpp`). The radicand of a root of the first
/// expression must be certain not to be negative, unless the second has the same root; the reasons are kept with the proof. A
/// proof also asks that the expression be zero with 50 digits at the sample points: 24 at least, every combination of the signs
/// of six symbols among them, and 16 at least with values. A remainder of zero with a value that is not zero is an error of the
/// base, and throws.
#pragma once

#include <ginac/ginac.h>
#include <string>
#include <utility>
#include <vector>

#include "derivation/algebra/generators.hpp"

namespace denhartog::derivation {

/// @brief The verdict of the zero test.
enum class Verdict {
    proved,  ///< zero on the domain, by reduction
    refuted, ///< not zero, with a numeric witness
    unknown  ///< neither
};

/// @brief The word for a verdict. @param v a verdict @return proved, refuted or unknown
[[nodiscard]] std::string to_string(Verdict v);

/// @brief A symbol, the values at which it is sampled, and the bounds that it has on all of the domain.
struct Range {
    GiNaC::ex symbol;    ///< the symbol
    GiNaC::numeric low;  ///< least sample, rational
    GiNaC::numeric high; ///< largest sample, rational
    Bounds bounds;       ///< of all its values
    int parts;           ///< into how many parts of one width the samples fall, each in its turn: 2 where zero is between
};

/// @brief Values for symbols.
using Point = std::vector<std::pair<GiNaC::ex, GiNaC::numeric>>;

/// @brief The decision of the test, and its grounds.
struct Decision {
    Verdict verdict = Verdict::unknown;                      ///< the verdict
    std::vector<GiNaC::ex> denominators;                     ///< what must not be zero, in generators
    std::vector<std::pair<GiNaC::ex, GiNaC::ex>> generators; ///< generators and what they stand for
    std::vector<RootReason> roots;                           ///< roots in the proof, with what their signs rest on
    Point witness;                                           ///< the point that refutes; empty otherwise
    std::string left;                                        ///< first value at the witness
    std::string right;                                       ///< second value at the witness
    std::string reason;                                      ///< why unknown; or why an expression has no value
};

/// @brief Decides whether two expressions are equal on a domain, where the second has a real value.
/// @param left    an expression
/// @param right   another
/// @param domain  the symbols that occur, with their ranges; sample points are drawn from it by a fixed seed
/// @param real    roots that are real wherever the statement is made, next to those of the second expression
/// @return        the decision
[[nodiscard]] Decision decide_equal(const GiNaC::ex& left, const GiNaC::ex& right, const std::vector<Range>& domain,
                                    const std::vector<GiNaC::ex>& real = {});

/// @brief Whether two expressions differ at a sample point: what refutes, without the reduction.
/// @param left    an expression @param right another @param domain the symbols that occur, with their ranges
/// @param real    roots that are real wherever the statement is made
/// @return        true where they differ clearly
[[nodiscard]] bool differs_at_samples(const GiNaC::ex& left, const GiNaC::ex& right, const std::vector<Range>& domain,
                                      const std::vector<GiNaC::ex>& real = {});

/// @brief The roots that stand in some expressions. @param expressions the expressions @return each root once
[[nodiscard]] std::vector<GiNaC::ex> roots_in(const std::vector<GiNaC::ex>& expressions);

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
