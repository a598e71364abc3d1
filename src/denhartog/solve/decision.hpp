/// @file
/// @brief The choice between double and the reference.
///
/// The reference, if a proof or 15 digits and more are asked for. Else double, if it has the digits, the regime and the
/// stability; if not, the reference. If the reference has no proof either, double answers if its regime is certain; else nothing
/// does. Where a question has no answer, that is a value, see `Outcome`, which is decided where it arises; the functions that
/// users call make an exception of it.
#pragma once

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

/// @brief The answer of double to a question.
struct AnswerInDouble : Tried<Solution> {
    bool open = false;                    ///< whether double does not tell what the contact does
    bool regime_is_certain = true;        ///< whether it is, so that double answers if the reference has no proof
    bool vague = false;                   ///< whether double does not tell if the motion is stable
    std::optional<PeriodicOrbit> orbit{}; ///< the motion from rest, where it was followed

    /// @brief True where it needs nothing more: it has its digits, and regime and stability are certain.
    [[nodiscard]] bool is_settled() const {
        return is_answered() && value->digits_reached && !open && !vague && !value->regime.on_boundary;
    }
};

/// @brief The outcome of a question in double: what its computation throws becomes one.
template <class Answer>
[[nodiscard]] AnswerInDouble tried_in_double(const Answer& answer) {
    Tried<AnswerInDouble> found = tried(answer);
    if (found.is_answered()) return *std::move(found.value);
    return {{Refusal(std::move(found))}};
}

/// @brief The answer in double to a question at a point of a prepared system.
[[nodiscard]] AnswerInDouble answer_in_double(const PreparedSystem& p, const SolvePoint& at, const Question& question);

/// @brief The answer in double, or else by the reference; none where the digits asked for are not reached.
[[nodiscard]] Tried<Solution> answer_or_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question);

/// @brief The outcome of a question at a point of a prepared system. A bad question or point is an InputError.
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

} // namespace denhartog
