/// @file
/// @brief An answer in the units that a dimensional scene was given in.
#pragma once

#include "denhartog/answer/solution.hpp"
#include "denhartog/program/json/number_json.hpp"

namespace denhartog::program {

/// @brief Frequencies, forces, displacements and times of an answer, in double: in SI units where the scene has them.
/// @param solution  the answer
/// @param units     what the scene was divided by; without its force no displacement and no force is known
/// @return          the object; what is not known is absent
[[nodiscard]] Json dimensional_json(const Solution& solution, const Units& units);

/// @brief The same for reading. @param dimensional the object @return lines of text
[[nodiscard]] std::string dimensional_table(const Json& dimensional);

} // namespace denhartog::program
