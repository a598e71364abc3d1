// Answers as JSON objects, the keys in the order of the documentation, and as tables.
// Members that mean nothing in a regime, or were not asked for, are absent.
#pragma once

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/program/json/number_json.hpp"

namespace denhartog::program {

/// @brief Frame to which displacements are relative; null if they are absolute.
[[nodiscard]] inline const char* frame_of(const System<double>& system) {
    if (system.base_motion == BaseMotion::with_wall) return "base and wall";
    return system.base_motion == BaseMotion::wall ? "wall" : nullptr;
}

// Where the contact is: its mass, the two that it is between, or its direction. Of a system, or an answer about one.
template <class S>
[[nodiscard]] Json contact_name(const S& s) {
    if (!s.contact_direction.empty()) return {{"direction", s.contact_direction}};
    if (s.contact_with) return {{"between", {s.contact.index + 1, s.contact_with->index + 1}}};
    return {{"mass", s.contact.index + 1}};
}

// An answer to `response`, with beta: regime, boundary, method and, in the sliding regime, every mass.
[[nodiscard]] Json response_json(const Solution& solution, const NumberWriter& write);

// An answer to `boundary`, without beta: the friction ratios that bound the regimes, and the condition that binds.
[[nodiscard]] Json boundary_json(const Solution& solution, const NumberWriter& write);

// An answer of `solve`: the object of `response` in every regime, with what is known besides; and the same for reading.
[[nodiscard]] Json solution_json(const Solution& solution, const NumberWriter& write);
[[nodiscard]] std::string solution_table(const Json& answer);

// Method of an answer, as a line: model, precision, whether it is proved, and why.
[[nodiscard]] std::string method_in_words(const Json& method);

// Where the contact is, in words, from the object `contact` of an answer; a line without its end.
[[nodiscard]] std::string contact_in_words(const Json& contact);

// Adds `damping` where a damping matrix couples the modes: whether the coupling was taken in or left out, how large it is, and the
// damping ratios without it; and the same as a line, empty where there is none.
void add_damping(Json& answer, const SceneSource& source);
[[nodiscard]] std::string damping_line(const Json& answer);

// Adds `place_of_rest` where the scene has a constant load: the places from which displacements count, in units of P / k_1 and those
// of the scene; and the same as lines, empty where there is none.
void add_place_of_rest(Json& answer, const SceneSource& source);
[[nodiscard]] std::string place_of_rest_lines(const Json& answer);

// Ratios of a scene in physical units, turned back into these: frequency, force, friction.
[[nodiscard]] Json units_json(const Units& units, double r, const std::optional<double>& beta, double mu);

// Units of displacements and phases of an answer, behind the contact in words.
[[nodiscard]] std::string units_in_words(const Json& answer);

// Adds `dimensional` to the answer to a scene in physical units: frequencies, forces, displacements and times in these units, in
// double. Without its force no displacement and no force is known. And the same as lines, empty where there is none. Where base and
// wall move, adds what displacements are relative to and, where all masses were asked about, `from_ground`: their absolute
// displacements with the transmissibility of each; and that as lines.
void add_dimensional(Json& answer, const SceneSource& source, const Solution& solution, const NumberWriter& write);
[[nodiscard]] std::string from_ground_table(const Json& answer);
[[nodiscard]] std::string dimensional_table(const Json& answer);

// Adds `energy` to an answer of `solve`, and to its `dimensional` the same in the units of the scene; and that as lines, empty
// where there is none.
void add_energies(Json& answer, const SceneSource& source, const Solution& solution, const Energies& e,
                  const NumberWriter& write);
[[nodiscard]] std::string energy_table(const Json& answer);

// The warning of an answer as a line; empty where there is none.
[[nodiscard]] std::string warning_line(const Json& answer);

} // namespace denhartog::program
