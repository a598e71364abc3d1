/// @file
/// @brief Statements of the text as claims: measured, proved or refuted.
///
/// A verdict that is unknown says: searched, and no counterexample met, which a report calls measured; the witness has the
/// largest departure and the number of cases.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "derivation/claims/claim.hpp"
#include "derivation/claims/witness.hpp"

namespace denhartog::derivation {

/// @brief A number of GiNaC's as text. @param n a real number @return as of a double
[[nodiscard]] inline std::string text(const GiNaC::numeric& n) { return text(n.to_double()); }

/// @brief A claim with Role::observation.
/// @param id           unique name
/// @param equations    the equations it speaks of
/// @param title        one sentence, with what a vague word is taken to mean
/// @param assumptions  the range
/// @param check        decides it
/// @return             the claim
[[nodiscard]] Claim observation(std::string id, std::vector<std::string> equations, std::string title,
                                std::vector<std::string> assumptions, std::function<Outcome()> check);

/// @brief Refutes a statement that nothing exceeds a threshold, where something does.
/// @param outcome    gets the verdict and the threshold
/// @param found      the largest that was found
/// @param threshold  what is compared, the number taken, and the one at which the statement is empty; it turns at what was found
void refute_above(Outcome& outcome, double found, Threshold threshold);

/// @brief Decides a statement that nothing falls below a threshold.
/// @param outcome    gets the verdict and the threshold
/// @param found      the least that was found
/// @param threshold  what is compared, the number taken, and the one at which the statement is empty
void refute_below(Outcome& outcome, double found, Threshold threshold);

/// @brief A number in a sentence. @param x a number @return three digits
[[nodiscard]] std::string rounded(double x);

/// @brief The largest of many numbers, and where it was met.
struct Worst {
    double error = -1; ///< the largest
    Witness place;     ///< where
    /// @brief Takes a place if its error is larger. @param e its error @param where the place
    void take(double e, const std::function<Witness()>& where) {
        if (!(e > error)) return;
        error = e;
        place = where();
    }
};

} // namespace denhartog::derivation
