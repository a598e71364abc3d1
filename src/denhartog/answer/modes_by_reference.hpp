/// @file
/// @brief The modes of a system by the reference, each number proved and rounded to double.
#pragma once

#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/evaluation/mode_values.hpp"
#include "denhartog/model/stuck_configuration.hpp"
#include "denhartog/number/bounded.hpp"

namespace denhartog {

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
