/// @file
/// @brief The modes of a system in double, and by the reference, each number proved and rounded to double. What an answer says of a
/// damping matrix that couples them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/evaluation/mode_values.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief The modal basis in double.
struct ModesInDouble {
    std::shared_ptr<const ModalBasis<Bounded<double>>> basis; ///< with bounds of its errors
    Reasons rounded_because{};                                ///< why double has none, where the reference found it; else empty
};

/// @brief Finds the modes of a system.
[[nodiscard]] ModesInDouble modes_in_double(const SceneSource& source);

/// @brief Prepares a system for the exact solver in double, sliding and stuck.
[[nodiscard]] std::shared_ptr<const ContactSystem> moving_in_double(const SceneSource& source, const ModesInDouble& modes);

/// @brief The same with the modes of the reference; `because` says why double has none, or not their digits.
[[nodiscard]] ContactSystem moving_by_reference(const SceneSource& source, const Reasons& because);

/// @brief A damping matrix that couples the modes.
struct CoupledDamping {
    bool taken_in;                      ///< whether the coupling counts, or is left out as `damping_tolerance` allows
    double distance_from_classical;     ///< as that measures it
    double largest_coupling;            ///< of an entry between two modes, over the geometric mean of theirs
    std::vector<double> damping_ratios; ///< those nearest to the matrix, mode by mode
};

/// @brief Whether the damping matrix of a scene couples the modes, and how much: double tells, or else the reference. None where
/// damping was given by ratios, or by a matrix that does not couple the modes by more than the bounds of its entries. @eq{18}
[[nodiscard]] std::optional<CoupledDamping> coupled_damping(const SceneSource& source);

/// @brief The modal basis to `digits_by_default` digits, in double if that has them, else by the reference.
///
/// Of other systems than chains double has the squares of natural frequencies to some units of the highest one. Beside a light
/// mass or a stiff spring that leaves the lowest ones few digits. Of modes with one frequency, and of more than 200 masses, it is
/// what double has.
/// @eq{14,15,18}
[[nodiscard]] std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

/// @brief (23), (28), (29) of each mode at the frequency ratio of a scene, in double if that has the digits, else by the
/// reference. The modes are not coupled; DomainError where an undamped one is at a pole. @eq{22,23,28,29}
[[nodiscard]] std::vector<evaluation::ModeFunctions<Bounded<double>>>
certain_mode_functions(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

/// @brief The modal basis. Its rows and signs are those of the basis in double.
///
/// Modes that more and more bits do not tell apart are refused, unless damping is given by ratios and they may be taken: their
/// shapes are then some orthonormal ones, with bounds that hold any.
/// @eq{14,15,18}
/// @param source      the system
/// @param coinciding  whether modes that coincide may be taken
/// @return            the basis; where a damping matrix counts, `D` is filled whether it couples the modes or not
/// @throws            PrecisionError where something cannot be proved, or the library was built without the reference
[[nodiscard]] ModalBasis<Bounded<double>> modes_by_reference(const SceneSource& source, bool coinciding);

/// @brief What each mode contributes at the frequency ratio of a scene.
/// @eq{22,23,28,29}
/// @param source  the scene, with r, of which no damping matrix couples the modes
/// @return        (23), (28), (29) of each mode, to 6 digits or as many as all bits give
/// @throws        PrecisionError as `modes_by_reference`, and at a pole
[[nodiscard]] std::vector<evaluation::ModeFunctions<Bounded<double>>> mode_functions_by_reference(const SceneSource& source);

/// @brief The modes of a system while the contact slides, and what goes with them.
struct SystemByReference {
    ModalBasis<Bounded<double>> basis; ///< as `modes_by_reference` gives it, modes that coincide too
    RoundedModes held;                 ///< the modes with the contact held, and more
};

/// @brief All modes of a system. @param source the system @return the modes @throws PrecisionError as `modes_by_reference`
[[nodiscard]] SystemByReference system_by_reference(const SceneSource& source);

} // namespace denhartog
