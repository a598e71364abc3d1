/// @file
/// @brief The modes of a system in double, and by the reference, each number proved and rounded to double; and the coupling of
/// modes by a damping matrix.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/evaluation/mode_values.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief The modal basis in double.
struct ModesInDouble {
    std::shared_ptr<const ModalBasis<Bounded<double>>> basis; ///< with bounds of its errors
    Reasons rounded_because{};                                ///< why double has none, where the reference found it; else empty
};

/// @brief The modes of a system; PrecisionError where the reference has none either.
[[nodiscard]] ModesInDouble modes_in_double(const SceneSource& source);

/// @brief Prepares a system for the exact solver in double, sliding and stuck.
[[nodiscard]] std::shared_ptr<const ContactSystem> moving_in_double(const SceneSource& source, const ModesInDouble& modes);

/// @brief A system for the exact solver with the modes of the reference, those that coincide too; `because` says why double has
/// none, or not their digits. None as of `modes_by_reference`.
[[nodiscard]] Tried<ContactSystem> moving_by_reference(const SceneSource& source, const Reasons& because);

/// @brief A damping matrix that couples the modes.
struct CoupledDamping {
    bool taken_in;                      ///< whether the coupling counts, or is left out as `damping_tolerance` allows
    double distance_from_classical;     ///< as that measures it
    double largest_coupling;            ///< of an entry between two modes, over the geometric mean of theirs
    std::vector<double> damping_ratios; ///< those nearest to the matrix, mode by mode
};

/// @brief The coupling of the modes by the damping matrix of a scene, by double or else by the reference; none where damping was
/// given by ratios, or it is no more than the bounds of the matrix's entries. @eq{18}
[[nodiscard]] std::optional<CoupledDamping> coupled_damping(const SceneSource& source);

/// @brief The modal basis to `digits_by_default` digits, in double if that has them, else by the reference; of modes with one
/// frequency, and of more than 200 masses, what double has. @eq{14,15,18}
[[nodiscard]] std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

/// @brief (23), (28) and (29) of each mode, with as many digits as `certain_modes`; DomainError at a pole of an undamped mode.
/// @eq{22,23,28,29}
[[nodiscard]] std::vector<evaluation::ModeFunctions<Bounded<double>>>
certain_mode_functions(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

/// @brief The numbers of a basis that must have digits: frequencies, damping ratios, and the largest entry of each mode shape.
[[nodiscard]] std::vector<Bounded<double>> sizes_in(const ModalBasis<Bounded<double>>& basis);

/// @brief The modal basis by the reference, with the rows and signs of that in double; `D` is filled where a damping matrix
/// counts. Modes that no bits tell apart are refused, or, where `coinciding` ones may be taken, have bounds that hold any
/// orthonormal shapes. None where something cannot be proved, or the library was built without the reference.
/// @eq{14,15,18}
[[nodiscard]] Tried<ModalBasis<Bounded<double>>> modes_by_reference(const SceneSource& source, bool coinciding);

/// @brief (23), (28), (29) of each mode by the reference, to 6 digits or as many as all bits give; none also at a pole.
[[nodiscard]] Tried<std::vector<evaluation::ModeFunctions<Bounded<double>>>>
mode_functions_by_reference(const SceneSource& source);

} // namespace denhartog
