/// @file
/// @brief Boundary, regime and, where the contact slides throughout, the steady state of one point, every number with its bound.
#pragma once

#include <memory>
#include <optional>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/scene_source.hpp"
#include "denhartog/sliding/regime.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {

/// @brief A scene in one number type with its modal basis.
template <class T>
struct SceneIn {
    Scene<T> scene;                                      ///< the scene
    std::shared_ptr<const ModalBasis<Bounded<T>>> basis; ///< its modes with bounds of their errors
};

/// @brief A scene in a number type with its modes. A damping matrix counts as it was given: one that rounding has left uncoupled
/// in double alone couples the modes in more digits.
/// @param source  the scene
/// @return        the scene with its basis
/// @throws        InputError where the scene breaks a rule; PrecisionError as `modal_basis`
template <class T>
[[nodiscard]] SceneIn<T> scene_with_modes(const SceneSource& source);

/// @brief What is known of a point.
template <class T>
struct SlidingPoint {
    Boundary<Bounded<T>> boundary;                ///< the boundary there
    std::optional<RegimeAtPoint> regime;          ///< the regime; none without a friction ratio
    std::optional<SteadyState<Bounded<T>>> state; ///< the steady state, in the sliding regime and where it was asked for
    Attempted attempted{0};                       ///< the largest error, and whether the regime is certain
};

/// @brief What is asked of a point.
struct PointWish {
    bool motion = true;         ///< whether the steady state is wanted too, or boundary and regime alone
    bool limits = true;         ///< whether the friction ratios of the boundary must have the digits, or the regime be certain
    std::optional<Mass> only{}; ///< the one mass that must have the digits: no other has a maximum; none for all
    int digits = digits_by_default; ///< significant digits wanted
};

/// @brief The boundary of a system whose modes may be coupled by what was rounded off its damping matrix alone: of the modes with
/// the damping that each has by itself. (56) is that of these modes, if the coupling makes no difference to (69). Where modes are
/// coupled for good (56) is not defined, and is (69).
/// @eq{56}
/// @param source  the scene
/// @param in      the same in T with its modes
/// @param digits  significant digits wanted
/// @return        the boundary; none where double tells that the modes are coupled or does not tell them apart, or it fails
template <class T>
[[nodiscard]] std::optional<Boundary<Bounded<T>>> boundary_without_coupling(const SceneSource& source, const SceneIn<T>& in,
                                                                            int digits);

/// @brief The point of a scene.
///
/// The instants of the maxima are searched for on values alone, in double where that settles them to the digits wanted, and the
/// formulas are then evaluated there with bounds. Errors count relative to amplitudes and friction ratios, absolute for phases. A
/// mass that does not move, and a contact that the load does not reach, have none.
/// @eq{38,39,44,45,47,52,53,69}
/// @param scene             the scene, with r; without beta the boundary alone is computed
/// @param modes             its modes at r
/// @param wish              what is asked
/// @param without_coupling  the boundary of the modes by themselves, as `boundary_without_coupling` has it; none elsewhere
/// @return                  the point
/// @throws                  DomainError at a pole of a mode without damping; PrecisionError where a maximum is not settled
template <class T>
[[nodiscard]] SlidingPoint<T> sliding_point(const Scene<T>& scene, BoundedModes<T>& modes, const PointWish& wish,
                                            const std::optional<Boundary<Bounded<T>>>& without_coupling = {});

} // namespace denhartog
