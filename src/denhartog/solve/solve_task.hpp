/// @file
/// @brief What the models of `solve` share: the question to a scene, and how each writes its answer. Included by sources only.
#pragma once

#include <memory>
#include <optional>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/solve/prepared_system.hpp"

namespace denhartog {

/// @brief What is said where a lower bound of (69) tells the regime.
inline constexpr const char* certainly_slides =
    "beta is below a lower bound of beta_lim, Eq. (69): the contact slides throughout";

/// @brief The point asked about.
struct SolvePoint {
    double r;                  ///< frequency ratio
    double beta;               ///< friction ratio
    const SceneSource* source; ///< where both are to be had to any digits; null where the doubles are what is meant
};

/// @brief The scene of a system at a point.
[[nodiscard]] SceneSource source_at(const PreparedSystem& p, const SolvePoint& at);

/// @brief A question to a scene, prepared.
struct SolveTask {
    SceneSource source;                          ///< the scene
    Question question;                           ///< what is asked
    const Scene<double>& scene;                  ///< the scene in double, which `source` holds
    Aim aim;                                     ///< the digits
    ModesInDouble known;                         ///< its modal basis
    std::shared_ptr<const ContactSystem> moving; ///< for the exact solver; none where it is still to be prepared
    bool open = false;                           ///< whether double leaves something open
    bool is_told = true;                         ///< whether the regime is certain nevertheless
    std::optional<std::string> unknown{};        ///< why boundaries and closed form are not known
    bool at_pole = false;                        ///< whether they do not exist
};

/// @brief Amplitude or phase of the contact alone, in the sliding regime at mu = 1: the cheapest model. False where something
/// else is asked, this has not the digits, or sliding is not certain.
[[nodiscard]] bool answer_by_contact(const PreparedSystem& p, const SolvePoint& at, const Question& question, Solution& s);

/// @brief The stuck response as the answer, once the boundary is found; `rests_at` is where the contact rests, if that was
/// followed.
void answer_by_stuck_response(const SolveTask& task, const std::optional<Certified>& rests_at, Solution& s);

/// @brief Says whether the velocities are known not to depend on the start, and why.
void say_whether_unique(const ModalBasis<Bounded<double>>& basis, double mu, Solution& s);

/// @brief Whether the boundaries tell that a motion that is not at rest has stops, seen or not: beyond that of sliding where
/// mu = 1 or every motion is damped.
[[nodiscard]] bool must_stop(const SolveTask& task, const Solution& s);

/// @brief A periodic orbit, with its masses, as the answer; `open` where double does not tell if the motion stops.
void answer_by_orbit(const SolveTask& task, ExactSolver& solver, const PeriodicOrbit& orbit, bool open,
                     Solution& s);

} // namespace denhartog
