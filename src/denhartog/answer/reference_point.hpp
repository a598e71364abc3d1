/// @file
/// @brief A point of a scene as the reference sees it; the way of the reference to a proof, with more bits, and from one guess of
/// a motion to the next; and proved numbers as they are handed out. Included by sources only.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/number/ball.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/reference/series.hpp"
#include "denhartog/reference/sliding.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief Tries with bits from `first` on, doubled up to `most`, until an attempt says that they were enough. A refusal where
/// something cannot be proved, or the budget of work, its own one where the scene had none, is spent.
[[nodiscard]] Refusal with_enough_bits(const SceneSource& source, slong first, slong most,
                                       const std::function<bool(const SceneSource& paid, slong bits, bool last)>& attempt);

/// @brief The result of an attempt, which gives nothing where the digits are not certain.
template <class Attempt>
[[nodiscard]] auto with_more_bits(const SceneSource& source, slong first, slong most, const Attempt& attempt) {
    decltype(attempt(source, first, true)) found;
    Refusal none = with_enough_bits(source, first, most, [&](const SceneSource& paid, slong bits, bool last) {
        return (found = attempt(paid, bits, last)).has_value();
    });
    using Found = Tried<typename decltype(found)::value_type>;
    return none.is_answered() ? Found(*std::move(found)) : Found(std::move(none));
}

/// @brief Guesses of a motion with stops.
class OrbitGuesses {
public:
    /// @brief The function that makes them, the likeliest first, is called when they are first needed.
    explicit OrbitGuesses(const std::function<std::vector<OrbitGuess>()>& made) : made_(made) {}

    /// @brief The first that is proved. One that is disproved is not tried again, and one that is proved is tried first. Unproved
    /// is thrown where there is none; Disproved where none is left to be tried.
    template <class Prove>
    [[nodiscard]] auto first_proved(Effort* effort, const Prove& prove) {
        if (!known_) guesses_ = made_();
        known_ = true;
        if (guesses_.empty()) pay(effort, 0); // none may be had for want of work
        bool first = true;                    // the likeliest one gives the reason
        for (std::size_t n = 0; n < guesses_.size(); first = false) {
            auto found = tried([&] { return prove(std::as_const(guesses_[n])); });
            if (found.is_answered()) {
                std::swap(guesses_[n], guesses_.front());
                return *std::move(found.value);
            }
            if (first) why_ = found.why;
            if (found.outcome == Outcome::disproved)
                guesses_.erase(guesses_.begin() + static_cast<std::ptrdiff_t>(n));
            else if (found.outcome == Outcome::unproved)
                ++n;
            else
                require(found);
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

/// @brief The knowledge of a point in the bits of the moment.
struct PointInBalls {
    reference::SceneInBalls scene{};                        ///< the scene, with its damping matrix
    std::optional<reference::ResponsesInBalls> responses{}; ///< its response functions; none at a pole
    std::optional<Boundary<Ball>> boundary{};               ///< the boundary of the sliding regime; none at a pole
    std::optional<reference::StuckInBalls> stuck{};         ///< the response with the contact held; none where that may resonate
    std::optional<Ball> sticking{};                         ///< the friction ratio from which the contact can rest for ever
};

/// @brief A scene as it is given, without r at r = 1; InputError where it breaks a rule that double is too coarse to see broken.
[[nodiscard]] reference::SceneInBalls scene_as_given(const SceneSource& source);

/// @brief A scene with the damping that counts: ratios, or a matrix; the ratios nearest to that where it is within
/// `damping_tolerance` of having them.
[[nodiscard]] reference::SceneInBalls scene_in_balls(const SceneSource& source);

/// @brief A scene with its damping at r = 1, where psi of (17) is phi, under the load that it has at its own r.
[[nodiscard]] reference::SceneInBalls scene_at_one(const SceneSource& source);

/// @brief The damping matrix in the modes, \f$ \boldsymbol\Psi^T\mathbf{C}\boldsymbol\Psi \f$; its diagonal damps each by itself.
/// @eq{18}
[[nodiscard]] BallMatrix damping_of_modes(const reference::SceneInBalls& scene, const reference::ModesInBalls& modes);

/// @brief The distance of K M^-1 C from C M^-1 K for the damping D in the modes, and the sizes of both, which are squares.
struct Commutator {
    Ball apart{0}; ///< of the difference
    Ball size{0};  ///< of K times that of C
};
/// @brief The commutator of a damping matrix, which is zero of one that leaves the modes by themselves.
[[nodiscard]] Commutator commutator_of(const reference::ModesInBalls& modes, const BallMatrix& D);

/// @brief A scene with its damping matrix, (19) where damping is given by ratios.
[[nodiscard]] reference::SceneInBalls damped_scene_in_balls(const SceneSource& source);

/// @brief A point of a scene, which may be of no use without its boundary.
[[nodiscard]] PointInBalls point_in_balls(const SceneSource& source, bool needs_boundary);

/// @brief The stuck response at a point; Unproved where the system with its contact held may resonate.
[[nodiscard]] const reference::StuckInBalls& required_stuck(const PointInBalls& p);

/// @brief Throws Disproved, Unproved where a point with its boundary does not lie below (69).
void require_sliding(const PointInBalls& p);

/// @brief A number of an answer from a ball: rounded once, with a bound that holds the rounding, infinite where the ball is not
/// finite. Of more than 15 digits its decimals are written.
[[nodiscard]] Certified printed(const Ball& x, int digits);

/// @brief A ball rounded to double, with the rounding in its bound.
[[nodiscard]] inline Bounded<double> in_double(const Ball& x) {
    const Certified rounded = printed(x, most_digits_of_a_double);
    return {rounded.value, rounded.error};
}

/// @brief Bits of a decimal digit.
inline constexpr double bits_of_digit = 3.3219280948873626;

inline constexpr slong first_bits = 128; ///< bits with which a proof of what is handed out as doubles begins
inline constexpr slong most_bits = 1024; ///< bits with which it ends

/// @brief Bits with which a proof of so many digits begins.
[[nodiscard]] inline slong bits_for(int digits) { return static_cast<slong>(std::max(128.0, bits_of_digit * digits + 64)); }

/// @brief Numbers of an answer as they are written, and whether those that are asked for have their digits.
class WrittenNumbers {
public:
    /// @brief Of an answer with so many digits; `last` where no more bits will be tried.
    WrittenNumbers(int digits, bool last) : digits_(digits), last_(last) {}

    /// @brief A number that need not have the digits. Unproved is thrown where it has no bound, PrecisionError where it is
    /// written as a double and is beyond the range of one.
    [[nodiscard]] Certified shown(const Ball& x) const;
    /// @brief A number that must have them, relative to its size, unless that is below all doubles and a double is asked for.
    [[nodiscard]] Certified relative(const Ball& x);
    /// @brief A number that must have them as it is, such as an angle.
    [[nodiscard]] Certified absolute(const Ball& x) {
        count(radius_of(x));
        return shown(x);
    }
    /// @brief A number that must have them beside the size of another.
    void beside(const Ball& x, const Ball& size) { count(radius_of(x) / abs(size)); }
    /// @brief A mass, whose phase need not have the digits where it is not `asked` for; at rest, within what its amplitude may
    /// be, where that is nothing beside the largest as far as all the bits can tell.
    [[nodiscard]] SolvedMass mass(const Ball& amplitude, const std::optional<Ball>& phase, bool asked, const Ball& largest);
    /// @brief True if every number that must have the digits has them.
    [[nodiscard]] bool enough() const { return enough_; }
    /// @brief The largest error of those numbers, before they are rounded.
    [[nodiscard]] double largest_error() const { return largest_; }

private:
    void count(const Ball& error);

    int digits_;
    bool last_;
    bool enough_ = true;
    double largest_ = 0;
};

} // namespace denhartog
