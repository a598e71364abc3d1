/// @file
/// @brief What is called while one side of a claim is built: the run says from it of which kind the claim is.
#pragma once

namespace denhartog::derivation {

/// @brief Says that GiNaC derives from a premise of the paper: the springs' energy, the equation of motion (4), (6), (12) or
///        (20), or a condition that is set to it, (17), (18), (25) or (30). Only the place that states the premise calls it.
void from_premise();

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
    friend void from_premise();
};

} // namespace denhartog::derivation
