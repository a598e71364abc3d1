// Energy that a motion dissipates, as JSON and as a table.
#pragma once

#include "denhartog/answer/energy.hpp"
#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/program/json/number_json.hpp"

namespace denhartog::program {

// Adds `energy` to an answer of `solve`, and to its `dimensional` the same in the units of the scene; and that as lines, empty
// where there is none.
void add_energies(Json& answer, const SceneSource& source, const Solution& solution, const Energies& e,
                  const NumberWriter& write);
[[nodiscard]] std::string energy_table(const Json& answer);

} // namespace denhartog::program
