/// @file
/// @brief The certificate of an identity: a lemma that the kernel of a proof assistant checks, an identity of polynomials.
///
/// The lemma is about real numbers: the symbols, the generators of the zero test with their relations, and a name for what each
/// side divides by. Its conditions are the ranges of the symbols, the signs of roots and exponentials, and that no divisor is
/// zero. A second lemma says the same of sine, cosine, exponential and root themselves, by the addition theorems and from the
/// first. The difference of the sides is a sum of quotients whose numerators are combinations of the relations; the coefficients
/// of these, the cofactors of the reduction, are written into the proof. Nothing is searched when it is checked.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "derivation/algebra/kept_identities.hpp"

namespace denhartog::derivation {

/// @brief A combination of relations that is to be the numerator of a part of the difference.
struct Combination {
    GiNaC::ex numerator;                                      ///< what has to be zero, in symbols and names of divisors
    GiNaC::ex factor;                                         ///< what it is multiplied with in the difference
    std::vector<std::pair<std::size_t, GiNaC::ex>> cofactors; ///< place of a relation, and its cofactor
    GiNaC::ex rest;                                           ///< what is left: zero for an identity
};

/// @brief A lemma with its proof.
struct Certificate {
    std::string statement;                                       ///< from `Lemma` to the full stop
    std::string proof;                                           ///< from `Proof.` to `Qed.`
    std::vector<std::pair<std::string, std::string>> generators; ///< names of generators and what they stand for
    std::size_t terms = 0;                                       ///< terms of numerators and cofactors
    bool holds = false;           ///< whether the reduction leaves nothing, so that the kernel is expected to accept it
    bool lacks = false;           ///< whether something that the proof needs was left out
    std::string in_functions;     ///< the lemma on the functions themselves, from `Lemma` to `Qed.`; empty where there is none
    std::string why_no_functions; ///< why there is none; empty where there is one, or where there is no function in it
};

/// @brief The part of a file that all certificates need. @return text in Coq
[[nodiscard]] std::string certificate_prelude();

/// @brief The part that lemmas on the functions themselves need besides. @return text in Coq
[[nodiscard]] std::string functions_prelude();

/// @brief Both sides over generators, for something that need not be an identity.
/// @param left    a side @param right the other @param domain the symbols that occur
/// @param real    roots that are real wherever the statement is made
/// @return        the sides as the zero test sees them
/// @throws        std::domain_error where they are made of something that the generators do not know
[[nodiscard]] Identity in_generators(const GiNaC::ex& left, const GiNaC::ex& right, const std::vector<Range>& domain,
                                     const std::vector<GiNaC::ex>& real);

/// @brief The parts of a lemma of which one is left out, so that the kernel must reject it.
struct LeftOut {
    bool relation = false; ///< the last relation that the proof uses
    bool divisor = false;  ///< that the first divisor is not zero
};

/// @brief The certificate of an identity; of something else a lemma that the kernel rejects.
/// @param identity  both sides
/// @param name      of the lemma
/// @param left_out  hypotheses that are missing
/// @return          the lemma
/// @throws          std::domain_error where it has no form in Coq
[[nodiscard]] Certificate certificate_of(const Identity& identity, const std::string& name, const LeftOut& left_out = {});

} // namespace denhartog::derivation
