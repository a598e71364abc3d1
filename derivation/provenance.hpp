/// @file
/// @brief What is called while one side of a claim is built: the run says from it of which kind the claim is.
#pragma once

#include "symbolic.hpp"

namespace denhartog::derivation {

/// @brief Says that GiNaC derives from the equation of motion (4), (6), (12) or (20) or from conditions that are set to it. Called
///        where the derivation states the equation or the condition, and nowhere else.
void from_equation_of_motion();

/// @brief Watches what is called while it lives. Not while a `Mutation` is in force.
class Watch {
public:
    Watch();
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    /// @return whether a formula template was instantiated: the operations of the symbolic scalar are only carried out by these
    [[nodiscard]] bool template_called() const;
    /// @return whether `from_equation_of_motion` was called
    [[nodiscard]] bool equation_of_motion_called() const;

private:
    Mutation none_{-1};
    Watch* before_;
    bool equation_of_motion_ = false;
    friend void from_equation_of_motion();
};

} // namespace denhartog::derivation
