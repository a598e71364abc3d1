/// @file
/// @brief The identities that a proof rests on, kept by the zero test if it is asked to.
#pragma once

#include <ginac/ginac.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "derivation/algebra/zero_test.hpp"

namespace denhartog::derivation {

/// @brief An equality that the zero test has proved: both sides, and both in generators with the relations of these.
struct Identity {
    GiNaC::ex left;                                          ///< one side, in symbols and functions
    GiNaC::ex right;                                         ///< the other side
    std::vector<Range> domain;                               ///< the symbols that occur
    GiNaC::ex left_in_generators;                            ///< one side as it was reduced
    GiNaC::ex right_in_generators;                           ///< the other as it was reduced
    std::vector<std::pair<GiNaC::ex, GiNaC::ex>> generators; ///< generators and what they stand for
    std::vector<SquareRelation> relations;                   ///< squares of generators, newest last
    std::vector<std::pair<GiNaC::ex, GiNaC::ex>> functions; ///< functions and roots, and the same in generators; inner ones first
};

/// @brief The ground of a decision beside identities.
enum class Ground {
    argument, ///< the argument of a person
    series,   ///< the leading term of a series
    places,   ///< comparisons of a selection at places of its domain
    claim     ///< another claim
};

/// @brief Keeps the identities that are proved, and the other grounds that are named, while it lives.
class Keeper {
public:
    Keeper();
    ~Keeper();
    Keeper(const Keeper&) = delete;
    Keeper& operator=(const Keeper&) = delete;

    std::vector<Identity> identities; ///< in the order in which they were proved
    std::set<Ground> grounds;         ///< other grounds

private:
    Keeper* before_;
};

/// @brief While it lives nothing is kept: a comparison that only serves to print, or another claim.
class KeepNothing {
public:
    KeepNothing();
    ~KeepNothing();
    KeepNothing(const KeepNothing&) = delete;
    KeepNothing& operator=(const KeepNothing&) = delete;

private:
    Keeper* before_;
};

/// @brief Keeps an identity, where somebody listens. @param identity what was proved
void keep(const Identity& identity);

/// @brief Keeps a ground, where somebody listens. @param ground what the decision rests on
void keep(Ground ground);

} // namespace denhartog::derivation
