/// @file
/// @brief What a constant load does to a scene, and how the motion of a scene without its harmonic load comes to rest. The reference
/// answers both: every number is proved.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief The places to which the constant load of a scene moves the masses, about which every steady motion is the one without it.
/// \f[ \bar{\mathbf x}_s = \mathbf K^{-1}\mathbf s \f]
///
/// With \f$ \bar{\mathbf x} = \bar{\mathbf x}_s+\mathbf y \f$ the constant load s drops out of (6). Friction depends on the velocity of
/// the contact, and at rest on all other forces on it, (2), (3), (74), (75): both are the same functions of y as they were of x
/// without s. So y is a motion without the constant load, in every regime, with the same stops at the same instants.
/// @eq{6,74,75}
/// @param source  the scene
/// @return        N numbers in units of P / k_1, proved; none where the scene has no constant load
/// @throws        PrecisionError where the stiffness matrix is not proved regular, or the library was built without the reference
[[nodiscard]] std::vector<Certified> place_of_rest(const SceneSource& source);

/// @brief Where the velocity of the contact is zero at the end of a half-cycle.
struct DecayTurn {
    Certified tau; ///< the instant, counted from the start; radians
    Certified x;   ///< displacement of the contact, in units of P / k_1
};

/// @brief A stop after which the contact breaks away again.
struct DecayStop {
    Certified start; ///< tau where the contact comes to rest
    Certified end;   ///< tau where it breaks away
    Certified x;     ///< the displacement at which it rests, in units of P / k_1
};

/// @brief How a motion without a load comes to rest. Every number is proved.
struct FreeDecay {
    bool at_rest = false;          ///< whether the contact rests for good; if not, `rest_from` to `on_limit` say nothing
    std::vector<DecayTurn> turns;  ///< ends of the half-cycles, in order; at the last one the contact rests for good
    std::vector<DecayStop> stops;  ///< stops before that, in order
    Certified rest_from;           ///< tau from which the contact rests for good
    Certified rest_at;             ///< displacement of the contact at rest, in units of P / k_1
    std::vector<Certified> masses; ///< places of rest of all masses with the contact there, in units of P / k_1
    /// Whether the other masses come to rest at these places. True: every free motion of theirs is damped, and they tend to them.
    /// False: nothing damps them, and they move about them for ever. Empty: neither is proved, or there are no other masses.
    std::optional<bool> others_come_to_rest;
    /// Whether the springs pull on the contact at rest with static friction, to some hundred digits. If the two are equal, (74) lets
    /// it stick, as this says.
    bool on_limit = false;
};

/// @brief The motion of a scene from a start after its harmonic load is taken away, until the contact rests for good; the constant load
/// stays. See `reference::free_decay_in_balls`.
/// @eq{6,74,75}
/// @param source  the scene, with r and a positive beta; P and the frequency are no more than units
/// @param start   displacements in units of P / k_1 and velocities with respect to tau, every double exact
/// @param until   an instant, tau, up to which the motion is followed; none: until the contact rests for good. Where nothing damps the
///                other masses they may set it in motion again and again
/// @return        the motion
/// @throws        InputError where the scene or the start breaks a rule; PrecisionError where something cannot be proved, the budget of
///                work is spent before the motion has come to its end, or the library was built without the reference
[[nodiscard]] FreeDecay free_decay(const SceneSource& source, const State& start, const std::optional<double>& until = {});

} // namespace denhartog
