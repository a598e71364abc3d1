/// @file
/// @brief What answers a question.
///
/// The reference, if a proof or 15 digits and more are asked for. Else double, if it has the digits, the regime and the
/// stability; if not, the reference. If the reference has no proof either, double answers if its regime is certain; else nothing
/// does. Where a question has no answer, that is a value, see `Outcome`; the functions that users call make an exception of it.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief The point asked about.
struct SolvePoint {
    double r;                  ///< frequency ratio
    double beta;               ///< friction ratio
    const SceneSource* source; ///< where both are to be had to any digits; null where the doubles are what is meant
    Effort* effort = nullptr;  ///< the work allowed; null: what the scene has, or else by default
};

/// @brief The scene of a system at a point, with the work allowed there.
[[nodiscard]] SceneSource source_at(const PreparedSystem& p, const SolvePoint& at);

/// @brief Says whether the velocities are known not to depend on the start, and why; and what is steady besides where a mode
/// without damping keeps any share of the sliding motion. The answer has its point already; `contact` is the row of the contact
/// in the shapes of the basis.
///
/// With mu = 1 no two motions move apart, and their distance stays the same only if friction and dampers do no work on their
/// difference. That is then a free motion of modes without damping, which lets the contact turn at the same instants: at
/// multiples of pi. Of modes whose phases over pi are told from 0, from pi and from each other's it is zero. A mode with an even
/// number of periods in one of the force may keep any share. Of one mass that stops, two motions at the same distance rest and
/// break away together, and so from the same place.
void say_whether_unique(const ModalBasis<Bounded<double>>& basis, Mass contact, const System<double>& system, double mu,
                        Solution& s);

/// @brief What a proof of a motion that double found periodic starts from. Stops and slips shorter than `shortest`, in tau, are
/// left out. There are no directions where the motion has no phases that repeat.
[[nodiscard]] OrbitGuess guess_of(ExactSolver& solver, const PeriodicOrbit& orbit, double shortest = 0);

/// @brief Motions that differ from a guess by one stop of nearly no length, which rounding may have invented or hidden; the
/// likeliest first: one where the contact turns or is slow, and the guess without its shortest stop or slip.
[[nodiscard]] std::vector<OrbitGuess> with_other_stops(const OrbitGuess& guess);

/// @brief Motions near the one from rest, as double sees them, the likeliest first; that one is followed here if it was not
/// before.
[[nodiscard]] std::vector<OrbitGuess> guesses_at(const PreparedSystem& p, const SceneSource& source,
                                                 std::optional<PeriodicOrbit>& followed);

/// @brief What double makes of a question.
struct AnswerInDouble : AnswerOrNone {
    bool open = false;                    ///< whether double does not tell what the contact does
    bool regime_is_certain = true;        ///< whether it is, so that double answers if the reference has no proof
    bool vague = false;                   ///< whether double does not tell if the motion is stable
    std::optional<PeriodicOrbit> orbit{}; ///< the motion from rest, where it was followed

    /// @brief Whether it needs nothing more: it has its digits, and regime and stability are certain.
    [[nodiscard]] bool is_settled() const {
        return is_answered() && solution.digits_reached && !open && !vague && !solution.regime.on_boundary;
    }
};

/// @brief What comes of a question in double: what its computation throws becomes an outcome.
template <class Answer>
[[nodiscard]] AnswerInDouble tried_in_double(const Answer& answer) {
    Tried<AnswerInDouble> found = tried(answer);
    if (found.value) return *std::move(found.value);
    return {{found.at_pole ? Outcome::at_a_pole : Outcome::not_certain, {}, std::move(found.why)}};
}

/// @brief How double answers a question.
using InDouble = std::function<AnswerInDouble(const Question&)>;

/// @brief The answer in double, or else by the reference; none where the digits asked for are not reached.
[[nodiscard]] AnswerOrNone answer_or_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question,
                                               const InDouble& fast);

/// @brief What comes of a question at a point of a prepared system. A bad question or point is an InputError.
[[nodiscard]] AnswerOrNone decide(const PreparedSystem& p, const SolvePoint& at, const Question& question);

/// @brief Boundary, regime and sliding motion of a scene, as `sliding_solution` has them in double.
[[nodiscard]] AnswerOrNone decide_sliding(const SceneSource& source, const Question& question,
                                          const std::shared_ptr<const ModalBasis<Bounded<double>>>& modes = nullptr);

/// @brief The same; DomainError at a pole, PrecisionError where there is none for another reason.
[[nodiscard]] inline Solution sliding_answer(const SceneSource& source, const Question& question,
                                             const std::shared_ptr<const ModalBasis<Bounded<double>>>& modes = nullptr) {
    return required(decide_sliding(source, question, modes));
}

/// @brief The same for every mass, refused if the digits asked for are not reached.
[[nodiscard]] Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved);

} // namespace denhartog
