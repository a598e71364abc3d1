/// @file
/// @brief What the handles of the C interface hold.
#pragma once

#include "denhartog/c/guarded.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/mass_rules.hpp"
#include "denhartog/solve/solve.hpp"

/// @brief A system prepared for every regime at mu = 1, with its modes. Nothing in it changes.
struct dh_system {
    denhartog::PreparedSystem prepared;                                               ///< for `solve`
    std::shared_ptr<const denhartog::ModalBasis<denhartog::Bounded<double>>> modes{}; ///< its modes, their digits certain
    denhartog::ModalBasis<double> basis{};                                            ///< the same, shapes a row a mass
};

/// @brief An answer with the scene it answers. Nothing in it changes.
struct dh_solution {
    denhartog::Scene<double> scene; ///< with r, beta and mu
    denhartog::Solution solution;   ///< the answer, the motion asked for
};

namespace denhartog::c_interface {

static_assert(DH_MOST_MASSES == most_masses && DH_MOST_SAMPLES == most_samples && DH_MOST_DISPLACEMENTS == most_displacements);

/// @brief Digits from C. @param digits as a caller gives them @return none for 0 @throws InputError for more than a double has
[[nodiscard]] inline std::optional<int> digits_from(int digits) {
    if (digits < 0 || digits > most_digits_of_a_double)
        throw InputError("digits", "must be from 0 to " + std::to_string(most_digits_of_a_double), std::to_string(digits));
    return digits > 0 ? std::optional(digits) : std::nullopt;
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
