/// @file
/// @brief The parts of a certificate and of its text in Coq, made one after the other.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "derivation/algebra/divisors.hpp"
#include "derivation/kernel/certificate.hpp"
#include "derivation/kernel/coq_text.hpp"

namespace denhartog::derivation {

/// @brief A relation with whole coefficients: scale * y^2 = scale * square.
struct Relation {
    GiNaC::ex generator;  ///< y
    GiNaC::ex square;     ///< what its square is
    GiNaC::numeric scale; ///< makes the coefficients whole
    std::string name;     ///< what Coq calls it
    std::string text;     ///< the equation in Coq
};

/// @brief The symbols in an expression. @param e the expression @param found gets them
void symbols_in(const GiNaC::ex& e, GiNaC::exset& found);

/// @brief A lemma on an identity of polynomials, and the same of the functions themselves.
class Lemma {
public:
    /// @param identity what it says, which has to outlive it @param left_out what a twin leaves out
    Lemma(const Identity& identity, const LeftOut& left_out);

    /// @brief The lemma under a name. @param name the name @return its statement and its proof
    Certificate written(const std::string& name) const;

private:
    const Identity& identity_;
    LeftOut left_out_;
    CoqNames names_;
    std::vector<std::pair<std::string, std::string>> meanings_;
    std::set<std::string> exponentials_, roots_;
    Divisors divisors_;
    std::vector<Relation> relations_; // in the order of the reduction: newest first
    std::vector<Combination> parts_;
    GiNaC::ex left_, right_;
    GiNaC::exmap meaning_; // generator -> what it stands for

    std::string text(const GiNaC::ex& e) const { return coq_text(e, names_); }

    // lemma.cpp: the parts
    /// Generators by what they stand for and not by GiNaC's order. Signs that GiNaC chooses still differ from run to run.
    void name_generators();
    /// Each divisor in that of the ways in which it is written that comes first by its text.
    void find_divisors();
    void name_divisors();
    /// The relations of generators that occur, each before those of the generators in its square; ties by name.
    void order_relations();
    /// The difference of the sides by powers of the symbols that stand in no relation and no divisor; each coefficient reduced.
    void find_parts();
    Combination combination(const GiNaC::ex& monomial, const GiNaC::ex& coefficient) const;

    // lemma_text.cpp: the lemma on polynomials
    std::vector<std::string> variables() const;
    /// Ranges of the symbols, as far as these are known, and the signs that generators have.
    std::vector<std::string> ranges(const std::vector<std::string>& variables) const;
    std::vector<std::string> ranges_of_symbols(const std::vector<std::string>& variables) const;
    bool is_left_out(const Relation& relation) const;
    std::string statement(const std::string& name, const std::string& left, const std::string& right) const;
    std::string proof() const;

    // lemma_in_functions.cpp: the lemma on the functions themselves
    /// An expression in generators with what these stand for, as text: nothing is simplified.
    std::string meant(const GiNaC::ex& e) const;
    /// An expression with generators in place of functions and roots.
    GiNaC::ex replaced(const GiNaC::ex& e) const;
    /// The argument of a generator with generators in place of its roots.
    GiNaC::ex in_roots(const GiNaC::ex& argument) const;
    /// An angle or an exponent as a sum of whole multiples of those of the generators, as text.
    std::string sum_of_units(const GiNaC::ex& argument, const std::vector<GiNaC::ex>& units) const;
    /// Why a function is what the generators say, as a tactic; empty where it is a generator itself.
    /// @param inner rewrites the roots in its argument @param by_squares proves an equation of quotients
    std::string why_function(const GiNaC::ex& function, const GiNaC::ex& value, const std::string& inner,
                             const std::string& by_squares) const;
    /// Adds what the squares of the roots among the generators are. @return a tactic that proves an equation of quotients by them
    std::string assert_squares(std::string& out) const;
    /// The divisors by their texts: in the sides, in arguments and under roots.
    static void collect_divided(const GiNaC::ex& e, std::map<std::string, GiNaC::ex>& found);
    /// True if a divisor of the first lemma is a number times the numerator of another divisor.
    bool follows(const Divisor& divisor, const std::map<std::string, GiNaC::ex>& divided) const;
    /// Whether a function or a root stands in one of the sides.
    bool occurs(const GiNaC::ex& function) const;
    /// The lemma on the functions themselves: each is what the generators say, these have their relations, and the first
    /// lemma applies.
    std::string in_functions(const std::string& name) const;
};

} // namespace denhartog::derivation
