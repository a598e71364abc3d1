/// @file
/// @brief How the reference goes on until it has a proof: with more bits, and from one guess of a motion to the next. Included by
/// sources only.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/ball.hpp"
#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/reference/modes.hpp"

namespace denhartog {

/// @brief Tries with bits from `first` on, doubled up to `most`, until an attempt says that they were enough. It gets the scene with
/// a budget of work, its own one where it had none, and is told whether the bits are the last.
/// @throws PrecisionError where something cannot be proved, or the budget of work is spent
void with_enough_bits(const SceneSource& source, slong first, slong most,
                      const std::function<bool(const SceneSource& paid, slong bits, bool last)>& attempt);

/// @brief The same for an attempt that gives its result, or nothing where the digits are not certain.
template <class Attempt>
[[nodiscard]] auto with_more_bits(const SceneSource& source, slong first, slong most, const Attempt& attempt) {
    decltype(attempt(source, first, true)) found;
    with_enough_bits(source, first, most, [&](const SceneSource& paid, slong bits, bool last) {
        return (found = attempt(paid, bits, last)).has_value();
    });
    return *std::move(found);
}

/// @brief Whether more bits will not help.
[[nodiscard]] inline bool is_disproved(const reference::Unproved& e) {
    return dynamic_cast<const reference::Disproved*>(&e) != nullptr;
}

/// @brief Guesses of a motion with stops.
class OrbitGuesses {
public:
    /// @brief What makes them, the likeliest first, is called when they are first needed.
    explicit OrbitGuesses(const std::function<std::vector<OrbitGuess>()>& made) : made_(made) {}

    /// @brief The first of them that is proved, paid from a budget. What is disproved is not tried again, and what is proved is tried first.
    /// @throws Unproved where there is none; Disproved where none is left to be tried
    template <class Prove>
    [[nodiscard]] auto first_proved(Effort* effort, const Prove& prove) {
        if (!known_) guesses_ = made_();
        known_ = true;
        if (guesses_.empty()) pay(effort, 0); // none may be had for want of work
        bool first = true;                    // what is said of the likeliest one is said
        for (std::size_t n = 0; n < guesses_.size(); first = false) {
            try {
                auto found = prove(std::as_const(guesses_[n]));
                std::swap(guesses_[n], guesses_.front());
                return found;
            } catch (const reference::Unproved& e) {
                if (first) why_ = e.why;
                if (is_disproved(e))
                    guesses_.erase(guesses_.begin() + static_cast<std::ptrdiff_t>(n));
                else
                    ++n;
            }
        }
        if (guesses_.empty()) throw reference::Disproved(why_);
        throw reference::Unproved(why_);
    }

private:
    const std::function<std::vector<OrbitGuess>()>& made_;
    std::vector<OrbitGuess> guesses_{};
    bool known_ = false;
    Reasons why_ = Why::no_guess;
};

} // namespace denhartog
