/// @file
/// @brief `solve`: the answer in every regime by the cheapest model that is certain to have the digits asked for; and what a
/// question to a system needs that does not depend on r and beta, done once for many points.
///
/// The models, cheapest first:
///  1. amplitude or phase of the mass in contact alone, mu = 1: (38), (39) below a lower bound of (69), see `contact_alone.hpp`;
///  2. boundary, regime and closed form of all masses, or of the one that is asked about, see `sliding_solution`;
///  3. for a contact that rests the stuck response, see `held_solution`;
///  4. the exact solver's periodic orbit.
/// Each is in double, with the bounds of its numbers. Where these do not leave the digits, or the regime is open, the reference
/// answers, see `decision.hpp`.
/// The boundaries tell the regime where mu = 1. Where mu > 1 more than one motion may exist: the exact solver then follows the
/// start from rest, and where that leads into the closed form or the stuck response these give the numbers.
#pragma once

#include <memory>
#include <optional>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/sliding/contact_alone.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief Which points are prepared for.
enum class Prepared : std::uint8_t {
    sliding_contact, ///< the cheapest: where the contact alone is asked for, points at which it slides; else every regime
    every_regime     ///< all that the cheaper models of `solve` may need
};

/// @brief A system prepared for a question, which no use changes. A point that needs more than is there solves for it by itself.
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

} // namespace denhartog
