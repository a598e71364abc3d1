/// @file
/// @brief What a question to a system needs that does not depend on r and beta: done once, used for many points.
#pragma once

#include <memory>
#include <optional>

#include "denhartog/sliding/contact_modes.hpp"
#include "denhartog/solve/scene_source.hpp"
#include "denhartog/solve/solution.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief Which points are prepared for.
enum class Prepared : std::uint8_t {
    sliding_contact, ///< the cheapest: where the contact alone is asked for, points at which it slides; else every regime
    every_regime     ///< all that the cheaper rungs of `solve` may need
};

/// @brief A system prepared for a question. Nothing in it changes when it is used.
///
/// A point that needs more than is there, such as a wider number type than the digits let expect, solves for it by itself.
struct PreparedSystem {
    SceneSource source;                                    ///< the system in every number type; its r and beta are not used
    Scene<double> scene;                                   ///< the same in double, checked
    std::optional<ContactModes> contact{};                 ///< modes as the contact has them, solved in double
    std::optional<ContactModes> contact_sharp{};           ///< the same, solved in long double
    std::optional<ModalBasis<Real50>> contact_in_50{};     ///< shapes at contact and load in 50 digits
    std::optional<ModalBasis<Real100>> contact_in_100{};   ///< the same in 100 digits
    std::optional<ModalBasis<double>> basis{};             ///< the whole basis in double
    std::shared_ptr<const ModalBasis<Bounded>> bounded{};  ///< the same with errors; none where damping is given by a matrix
    std::shared_ptr<const ContactSystem<double>> moving{}; ///< the system as the exact solver needs it
};

/// @brief Digits that a question aims at.
struct Aim {
    int digits;       ///< asked for, or aimed at where none are
    bool asked_for;   ///< which of the two
    double tolerance; ///< ten to the minus that
};

/// @brief What a question aims at. @param question the question @return its digits
[[nodiscard]] Aim aim_of(const Question& question);

/// @brief The same in words. @param aim the aim @return e.g. `6 digits aimed at`
[[nodiscard]] std::string in_words(const Aim& aim);

/// @brief Digits of the contact to which bounds known beforehand reach; beyond, they are too wide.
constexpr int most_digits_bounded_beforehand = 13;

/// @brief Checks a question to a system. @param question the question @param N number of masses
/// @throws InputError naming quantity, rule and value
void check(const Question& question, std::size_t N);

/// @brief Whether amplitude or phase of the mass in contact is all that is asked for. @param question the question
/// @param contact  the mass in contact
/// @return         true where it is
[[nodiscard]] bool asks_for_contact(const Question& question, Mass contact);

/// @brief The rows of the mode shapes that the contact needs. @param system the system @return the contact and, where that is
/// another mass, the loaded one
template <class T>
[[nodiscard]] std::vector<Mass> contact_and_load(const System<T>& system);

/// @brief Prepares a system for a question.
/// @param source    the scene; r and beta are not needed
/// @param question  what will be asked
/// @param points    which points are prepared for
/// @return          the system
/// @throws          InputError for a bad scene or question; as `modal_basis`
[[nodiscard]] PreparedSystem prepare(const SceneSource& source, const Question& question,
                                     Prepared points = Prepared::sliding_contact);

/// @brief The same of a system in double, mu = 1: the same binary fractions in every number type.
/// @param system    the system
/// @param question  what will be asked
/// @param points    which points are prepared for
/// @return          the system
[[nodiscard]] PreparedSystem prepare(const System<double>& system, const Question& question,
                                     Prepared points = Prepared::sliding_contact);

/// @brief The same system with another ratio of static to kinetic friction. @param system a system prepared for every regime
/// @param mu  static over kinetic friction, Eq. (3)
/// @return    the system
[[nodiscard]] PreparedSystem with_static_friction(PreparedSystem system, double mu);

} // namespace denhartog
