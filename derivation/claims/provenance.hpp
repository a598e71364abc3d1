/// @file
/// @brief The grounds of a claim, from which the run says of which kind the claim is.
///
/// A place that states a premise of the paper puts the factor `from_premise()` before one of its terms. The factor is one. While a
/// `FalsePremise` lives it is another number, and the premise is false: a claim that is proved from it must then fail.
#pragma once

#include <ginac/ginac.h>

namespace denhartog::derivation {

/// @brief The factor of a term of a premise of the paper: of the springs' energy, of the equation of motion (4), (6), (12) or
///        (20), or of a condition that is set to it, (17), (18), (25) or (30). Only the place that states the premise calls it.
/// @return one, or another number while a `FalsePremise` lives
[[nodiscard]] GiNaC::ex from_premise();

/// @brief Makes the premises false while it lives.
class FalsePremise {
public:
    FalsePremise();
    ~FalsePremise();
    FalsePremise(const FalsePremise&) = delete;
    FalsePremise& operator=(const FalsePremise&) = delete;
};

/// @brief Watches whether a premise is stated while it lives.
class Watch {
public:
    Watch();
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    /// @return whether a premise was stated
    [[nodiscard]] bool premise_called() const;

private:
    Watch* before_;
    bool premise_ = false;
    friend GiNaC::ex from_premise();
};

} // namespace denhartog::derivation
