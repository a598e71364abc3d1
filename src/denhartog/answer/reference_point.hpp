/// @file
/// @brief A point of a scene as the reference sees it; and how the reference goes on until it has a proof, with more bits, and
/// from one guess of a motion to the next. Included by sources only.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/ball.hpp"
#include "denhartog/reference/series.hpp"
#include "denhartog/reference/sliding.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief Tries with bits from `first` on, doubled up to `most`, until an attempt says that they were enough. PrecisionError
/// where something cannot be proved, or the budget of work, its own one where the scene had none, is spent.
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

    /// @brief The first that is proved. What is disproved is not tried again, and what is proved is tried first. Unproved is
    /// thrown where there is none; Disproved where none is left to be tried.
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

/// @brief What is known of a point in the bits of the moment.
struct PointInBalls {
    reference::SceneInBalls scene{};                        ///< the scene, with its damping matrix
    std::optional<reference::ResponsesInBalls> responses{}; ///< its response functions; none at a pole
    std::optional<reference::BoundaryInBalls> boundary{};   ///< the boundary of the sliding regime; none at a pole
    std::optional<reference::StuckInBalls> stuck{};         ///< the response with the contact held; none where that may resonate
    std::optional<Ball> sticking{};                         ///< the friction ratio from which the contact can rest for ever
};

/// @brief A scene as it is given, without r at r = 1; InputError where it breaks a rule that double is too coarse to see broken.
[[nodiscard]] reference::SceneInBalls scene_as_given(const SceneSource& source);

/// @brief A scene with the damping that counts: ratios, or a matrix; the ratios nearest to that where it is within
/// `damping_tolerance` of having them.
[[nodiscard]] reference::SceneInBalls scene_in_balls(const SceneSource& source);

/// @brief The same at r = 1, where psi of (17) is phi, under the load that it has at its own r.
[[nodiscard]] reference::SceneInBalls scene_at_one(const SceneSource& source);

/// @brief The damping matrix in the modes, \f$ \boldsymbol\Psi^T\mathbf{C}\boldsymbol\Psi \f$; its diagonal damps each by itself.
/// @eq{18}
[[nodiscard]] BallMatrix damping_of_modes(const reference::SceneInBalls& scene, const reference::ModesInBalls& modes);

/// @brief How far K M^-1 C is from C M^-1 K for the damping D in the modes, and the sizes of both, which are squares.
struct Commutator {
    Ball apart{0}; ///< of the difference
    Ball size{0};  ///< of K times that of C
};
/// @brief How far a damping matrix is from one that leaves the modes by themselves. @return the distance, and the sizes
[[nodiscard]] Commutator commutator_of(const reference::ModesInBalls& modes, const BallMatrix& D);

/// @brief A scene with its damping matrix, (19) where damping is given by ratios.
[[nodiscard]] reference::SceneInBalls damped_scene_in_balls(const SceneSource& source);

/// @brief A point of a scene, which may be of no use without its boundary.
[[nodiscard]] PointInBalls point_in_balls(const SceneSource& source, bool needs_boundary);

/// @brief The stuck response at a point; Unproved where the system with its contact held may resonate.
[[nodiscard]] const reference::StuckInBalls& required_stuck(const PointInBalls& p);

/// @brief Throws Disproved, Unproved where a point with its boundary does not lie below (69).
void require_sliding(const PointInBalls& p);

} // namespace denhartog
