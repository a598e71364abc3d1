/// @file
/// @brief The numbers of one point by the reference, each proved and rounded to double.
#pragma once

#include <functional>
#include <span>

#include "denhartog/solve/quantities.hpp"

namespace denhartog {

/// @brief The numbers of a point, masses in their order. Bits are doubled until they are accepted. `accept` says whether the
/// numbers have their digits, and may put zeros for some. PrecisionError where something cannot be proved, the budget of work is
/// spent, or the library was built without the reference. @eq{33,34,35,38,39,41,52,64,69}
[[nodiscard]] QuantitiesAnswer quantities_by_reference(const SceneSource& source, std::span<const double> tau,
                                                       const std::function<bool(Quantities<Bounded<double>>&)>& accept);

} // namespace denhartog
