/// @file
/// @brief `solve`: the answer in every regime by the cheapest model that is certain to have the digits asked for; the choice
/// between double and the reference; and what a question to a system needs that does not depend on r and beta, done once for many
/// points.
///
/// The models, cheapest first:
///  1. amplitude or phase of the mass in contact alone, mu = 1: (38), (39) below a lower bound of (69), see `contact_alone.hpp`;
///  2. boundary, regime and closed form of all masses, or of the one that is asked about, see `sliding_solution`;
///  3. for a contact that rests the stuck response, see `set_stuck_response`;
///  4. the exact solver's periodic orbit.
/// Each is in double, with the bounds of its numbers. The boundaries tell the regime where mu = 1, unless the motion beyond them
/// never stops. Where mu > 1 more than one motion may exist: the exact solver then follows the start from rest, and where that
/// leads into the closed form or the stuck response these give the numbers.
///
/// The reference answers if a proof or 15 digits and more are asked for, or if double does not have the digits, the regime or the
/// stability. If the reference has no proof, double answers if its regime is certain; else nothing does. Inside the library
/// a missing answer is a value, an `Outcome`; the functions that users call throw it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/sliding/contact_alone.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief Which points are prepared for.
enum class Prepared : std::uint8_t {
    sliding_contact, ///< the cheapest: where the contact alone is asked for, points at which it slides; else every regime
    every_regime     ///< all that the cheaper models of `solve` may need
};

/// @brief A system prepared for a question; it is not changed by its uses. A point that needs more than is there solves for it by
/// itself.
struct PreparedSystem {
    SceneSource source;                    ///< the system in every number type; its r and beta are not used
    std::optional<ContactModes> contact{}; ///< modes as the contact has them
    std::shared_ptr<const ModalBasis<Bounded<double>>> bounded{}; ///< the whole basis in double with its errors
    std::shared_ptr<const ContactSystem> moving{};                ///< the system as the exact solver needs it

    [[nodiscard]] const Scene<double>& scene() const { return source->in_double(); } ///< @return the same in double, checked
};

/// @brief Prepares a system for a question; r and beta are not needed.
[[nodiscard]] PreparedSystem prepare(const SceneSource& source, const Question& question,
                                     Prepared points = Prepared::sliding_contact);

/// @brief A system that is prepared for every regime, with another ratio of static to kinetic friction, Eq. (3).
[[nodiscard]] PreparedSystem with_static_friction(PreparedSystem system, double mu);

/// @brief The steady motion at the point of a scene, in every regime. A bad scene or question is an InputError, a pole of a mode
/// without damping a DomainError; PrecisionError where no model reaches the digits asked for or no steady motion is found.
[[nodiscard]] Solution solve(const SceneSource& source, const Question& question);

/// @brief The steady motion at any point of a prepared system: `solve` of a scene is nothing but both. Another question than was
/// prepared for is answered as well. The work of the answer is that of this point, paid from a budget, if there is one.
[[nodiscard]] Solution solve(const PreparedSystem& system, double r, double beta, const Question& question,
                             Effort* effort = nullptr);

/// @brief The point asked about.
struct SolvePoint {
    double r;                  ///< frequency ratio
    double beta;               ///< friction ratio
    const SceneSource* source; ///< where both are to be had to any digits; null where the doubles are what is meant
    Effort* effort = nullptr;  ///< the work allowed; null: what the scene has, or else by default
};

/// @brief The outcome of a question at a point of a prepared system: the answer in double, or else by the reference; none where
/// the digits asked for are not reached. A bad question or point is an InputError.
[[nodiscard]] Tried<Solution> decide(const PreparedSystem& p, const SolvePoint& at, const Question& question);

/// @brief Boundary, regime and sliding motion of a scene, as `sliding_solution` has them in double.
[[nodiscard]] Tried<Solution> decide_sliding(const SceneSource& source, const Question& question,
                                             const std::shared_ptr<const ModalBasis<Bounded<double>>>& modes = nullptr);

/// @brief Boundary, regime and sliding motion; DomainError at a pole, PrecisionError where there is none for another reason.
[[nodiscard]] inline Solution sliding_answer(const SceneSource& source, const Question& question,
                                             const std::shared_ptr<const ModalBasis<Bounded<double>>>& modes = nullptr) {
    return std::move(decide_sliding(source, question, modes).required());
}

/// @brief Boundary, regime and sliding motion of every mass, refused if the digits asked for are not reached.
[[nodiscard]] Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved);

/// @brief The answer of double to a question.
struct AnswerInDouble : Tried<Solution> {
    bool open = false;             ///< whether double does not tell what the contact does
    bool regime_is_certain = true; ///< whether the regime is certain; then double answers if the reference has no proof
    bool vague = false;            ///< whether double does not tell if the motion is stable, or how often the contact stops
    std::optional<PeriodicOrbit> orbit{}; ///< the motion from rest, where it was followed

    /// @brief True where it needs nothing more: it has its digits, and regime and stability are certain.
    [[nodiscard]] bool is_settled() const {
        return is_answered() && value->digits_reached && !open && !vague && !value->regime.on_boundary;
    }
};

/// @brief The answer in double to a question at a point of a prepared system.
[[nodiscard]] AnswerInDouble answer_in_double(const PreparedSystem& p, const SolvePoint& at, const Question& question);

/// @brief The scene of a system at a point, with the work allowed there.
[[nodiscard]] SceneSource source_at(const PreparedSystem& p, const SolvePoint& at);

/// @brief Checks a question to a system of N masses. InputError where it breaks a rule.
void check(const Question& question, std::size_t N);

/// @brief The guess for a proof of a motion that double found periodic. Stops and slips shorter than `shortest`, in tau, are left
/// out. There are no directions where the motion has no phases that repeat.
[[nodiscard]] OrbitGuess guess_of(ExactSolver& solver, const PeriodicOrbit& orbit, double shortest = 0);

/// @brief Motions that differ from a guess by one stop of nearly no length, which rounding may have invented or hidden; the
/// likeliest first: one where the contact turns or is slow, and the guess without its shortest stop or slip.
[[nodiscard]] std::vector<OrbitGuess> with_other_stops(const OrbitGuess& guess);

/// @brief Motions near the one from rest, as double sees them, the likeliest first; that one is followed here if it was not
/// before.
[[nodiscard]] std::vector<OrbitGuess> guesses_at(const PreparedSystem& p, const SceneSource& source,
                                                 std::optional<PeriodicOrbit>& followed);

} // namespace denhartog
