/// @file
/// @brief Functions and roots replaced by generators, each with its relation: the reduction of the zero test.
#pragma once

#include <ginac/ginac.h>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "derivation/algebra/signs.hpp"

namespace denhartog::derivation {

/// @brief A generator and the value of its square.
using SquareRelation = std::pair<GiNaC::ex, GiNaC::ex>;

/// @brief A polynomial in which every square of a generator is replaced by its value, newest generator first, until none is left.
/// @param polynomial  a polynomial in the generators
/// @param relations   generators with their squares, each in older generators alone; newest last
/// @return            its remainder, of degree one at most in each generator
[[nodiscard]] GiNaC::ex reduced(const GiNaC::ex& polynomial, const std::vector<SquareRelation>& relations);

/// @brief A quotient without generators in its denominator: it is multiplied by the conjugates, so that a sum in an angle shows.
/// @param rational   a rational function of the generators
/// @param relations  generators with their squares, newest last
/// @return           the same, wherever the relations hold
/// @throws           std::domain_error where a conjugate is zero
[[nodiscard]] GiNaC::ex rationalised(const GiNaC::ex& rational, const std::vector<SquareRelation>& relations);

/// @brief A root in a proof.
struct RootReason {
    GiNaC::ex radicand; ///< what is under it, in symbols
    std::string reason; ///< why that is not negative
};

/// @brief Replaces functions and roots by generators.
///
/// Two passes over the expressions: the first finds by which fraction each monomial occurs in angles and exponents, the second
/// replaces. A root is a generator of its own, the principal one: no other generator of the same square takes its place, unless
/// it is a root too. Roots are multiplied and divided by one another only where the signs of their radicands are certain.
class Generators {
public:
    /// @param bounds  of the symbols
    explicit Generators(KnownBounds bounds) : known_(std::move(bounds)) {}

    /// @brief First pass. @param e an expression
    /// @param real_there  whether the statement is made only where the roots in it are real, as it is of a derived side; of
    ///                    other roots the sign of the radicand must be certain
    void collect(const GiNaC::ex& e, bool real_there);

    /// @brief Second pass, after the first has seen all expressions. @param e an expression @param real_there as there
    /// @return  it in generators
    /// @throws  std::domain_error where it is made of something that the generators do not know
    GiNaC::ex rewrite(const GiNaC::ex& e, bool real_there);

    /// @brief Remainder of the numerator of a rational function of the generators; the denominators met are kept.
    /// @param rational  the function
    /// @return          the remainder
    GiNaC::ex reduced_numerator(const GiNaC::ex& rational);

    /// @brief Keeps what one side of a comparison divides by, divisor by divisor as they stand, before anything cancels.
    /// @param rational  a side, in generators
    void note_divisions(const GiNaC::ex& rational);

    /// @return the generators that have a square, each with it in older generators; newest last
    [[nodiscard]] const std::vector<SquareRelation>& relations() const { return relations_; }

    std::vector<GiNaC::ex> denominators;                ///< what must not be zero
    std::vector<std::pair<GiNaC::ex, GiNaC::ex>> names; ///< generator, what it stands for
    std::vector<RootReason> roots;                      ///< the roots met, with the reasons why they may be taken
    std::vector<std::pair<GiNaC::ex, GiNaC::ex>> functions; ///< functions and roots as they stood, and in generators; inner ones first

private:
    using Pair = std::pair<GiNaC::ex, GiNaC::ex>;
    struct Circular {
        GiNaC::ex cosine, sine;
        GiNaC::numeric unit;
    };
    struct Exponential {
        GiNaC::ex generator;
        GiNaC::numeric unit;
    };
    struct Root {
        GiNaC::ex generator, square;
        bool certain; // by bounds, not only by the domain of the statement
    };
    using Units = std::map<GiNaC::ex, GiNaC::numeric, GiNaC::ex_is_less>;

    KnownBounds known_;                                                // of symbols and generators
    GiNaC::exmap meaning_;                                             // generator -> what it stands for
    Units angle_unit_, exponent_unit_;                                 // monomial -> common denominator
    std::map<GiNaC::ex, Circular, GiNaC::ex_is_less> angles_;          // monomial -> cosine, sine of the unit angle
    std::map<GiNaC::ex, Exponential, GiNaC::ex_is_less> exponentials_; // monomial -> generator
    std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> arcs_;           // atan2 -> angle symbol
    std::vector<Root> roots_;
    std::vector<SquareRelation> relations_; // newest last
    bool real_there_ = false;

    void collect(const GiNaC::ex& e);
    GiNaC::ex replace(const GiNaC::ex& e);
    GiNaC::ex replaced_function(const GiNaC::ex& e);
    GiNaC::ex new_generator(const std::string& name, const GiNaC::ex& stands_for, const Bounds& bounds);
    GiNaC::ex root(const GiNaC::ex& polynomial, const std::string& reason = "");
    [[nodiscard]] GiNaC::ex same_root(const GiNaC::ex& a) const;
    [[nodiscard]] GiNaC::ex composed_root(const GiNaC::ex& a) const;
    GiNaC::ex root_of_fraction(const GiNaC::ex& radicand, const std::string& reason = "");
    Circular unit_angle_of_arc(const GiNaC::ex& arc, const GiNaC::numeric& unit);
    Circular unit_angle(const GiNaC::ex& monomial);
    Pair angle(const GiNaC::ex& argument);
    GiNaC::ex exponential(const GiNaC::ex& argument);
    void note_denominator(const GiNaC::ex& d);
};

} // namespace denhartog::derivation
