/// @file
/// @brief What a question to a system needs that does not depend on r and beta: done once, used for many points.
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

/// @brief A system prepared for a question. Nothing that can be seen of it changes when it is used.
///
/// A point that needs more than is there solves for it by itself.
struct PreparedSystem {
    SceneSource source;                    ///< the system in every number type; its r and beta are not used
    std::optional<ContactModes> contact{}; ///< modes as the contact has them
    std::shared_ptr<const ModalBasis<Bounded<double>>> bounded{}; ///< the whole basis in double with its errors
    std::shared_ptr<const ContactSystem> moving{};                ///< the system as the exact solver needs it

    [[nodiscard]] const Scene<double>& scene() const { return source->in_double(); } ///< @return the same in double, checked
};

/// @brief Checks a question to a system of N masses; InputError names quantity, rule and value.
void check(const Question& question, std::size_t N);

/// @brief Whether amplitude or phase of a mass in contact with the wall is all that is asked for.
[[nodiscard]] bool asks_for_contact(const Question& question, const System<double>& s);

/// @brief Prepares a system for a question; r and beta are not needed.
[[nodiscard]] PreparedSystem prepare(const SceneSource& source, const Question& question,
                                     Prepared points = Prepared::sliding_contact);

/// @brief The same of a system in double, mu = 1: the same binary fractions in every number type.
[[nodiscard]] PreparedSystem prepare(const System<double>& system, const Question& question,
                                     Prepared points = Prepared::sliding_contact);

/// @brief The same system, which is prepared for every regime, with another ratio of static to kinetic friction, Eq. (3).
[[nodiscard]] PreparedSystem with_static_friction(PreparedSystem system, double mu);

} // namespace denhartog
