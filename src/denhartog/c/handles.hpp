/// @file
/// @brief What the handles of the C interface hold.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "denhartog/c/guarded.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/solve/solve.hpp"

/// @brief A system prepared for every regime at mu = 1, with its modes. Nothing in it changes.
struct dh_system {
    denhartog::PreparedSystem prepared;                                               ///< for `solve`
    std::shared_ptr<const denhartog::ModalBasis<denhartog::Bounded<double>>> modes{}; ///< its modes, their digits certain
};

/// @brief An answer with the scene it answers. Nothing in it changes.
struct dh_solution {
    denhartog::SceneSource source; ///< the scene, with r, beta and mu
    denhartog::Solution solution;  ///< the answer, the motion asked for
};

namespace denhartog::c_interface {

static_assert(DH_MOST_MASSES == most_masses && DH_MOST_SAMPLES == most_samples && DH_MOST_DISPLACEMENTS == most_displacements);

/// @brief Digits from C. @param digits as a caller gives them @return none for 0 @throws InputError for more than a double has
[[nodiscard]] inline std::optional<int> digits_from(int digits) {
    if (digits < 0 || digits > most_digits_of_a_double)
        throw InputError("digits", "must be from 0 to " + std::to_string(most_digits_of_a_double), std::to_string(digits));
    return digits > 0 ? std::optional(digits) : std::nullopt;
}

/// @brief Significant digits of the sums over modes and of the closed form.
inline constexpr int digits_of_formulas = 10;

/// @brief Number of masses. @param system a handle @return N @throws CallError for null
[[nodiscard]] inline std::size_t masses_of(const dh_system* system) {
    need(system, "system");
    return number_of_masses(system->prepared.scene().system);
}

/// @brief A system at a point, in every number type.
/// @param system  a handle
/// @param r       frequency ratio
/// @param beta    friction ratio
/// @param mu      static over kinetic friction
/// @return        its scene @throws InputError where one of them breaks a rule
[[nodiscard]] inline SceneSource point_of(const dh_system* system, double r, double beta, double mu) {
    check_frequency_ratio(r);
    check_friction_ratio(beta);
    check_static_friction(mu);
    return at_point(with_static_friction(system->prepared.source, mu), r, beta);
}

/// @brief Which part of a number is handed out.
enum class ValueOrError : std::uint8_t { value, error };

/// @brief A bound that C gets: where there is none, the largest double. @param error a bound @return it, finite
[[nodiscard]] inline double finite_bound(double error) { return std::min(error, std::numeric_limits<double>::max()); }

/// @brief A part of a number. @param x the number @param part which @return it
[[nodiscard]] inline double part_of(const Bounded<double>& x, ValueOrError part) {
    return part == ValueOrError::value ? x.x : finite_bound(x.e);
}

/// @brief A part of a number. @param x the number @param part which @return it
[[nodiscard]] inline double part_of(const Certified& x, ValueOrError part) {
    return part == ValueOrError::value ? x.value : finite_bound(x.error);
}

/// @brief A part of each of several numbers. @param numbers they @param part which @return as many
[[nodiscard]] inline std::vector<double> parts_of(std::span<const Bounded<double>> numbers, ValueOrError part) {
    std::vector<double> parts;
    for (const Bounded<double>& x : numbers) parts.push_back(part_of(x, part));
    return parts;
}

/// @brief Checks the size that a caller has set. @param result the struct @param name its name in the header
/// @throws CallError where it is too small
template <class Struct>
void need_struct(const Struct* result, const char* name) {
    need(result, name);
    if (result->size < sizeof(Struct))
        throw CallError(DH_ERROR_SIZE, std::string(name) + "->size must be at least " + std::to_string(sizeof(Struct)) +
                                           ", but is " + std::to_string(result->size));
}

/// @brief Hands out a struct, its size as the caller had it. @param from the struct @param to the caller's
template <class Struct>
void hand_out(Struct from, Struct* to) noexcept {
    from.size = to->size;
    *to = from;
}

} // namespace denhartog::c_interface
