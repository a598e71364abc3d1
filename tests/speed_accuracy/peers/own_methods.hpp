/// @file
/// @brief The methods of this library on the chart: the closed form as printed and as shipped, the exact solver, the paper's
/// algorithm, `solve`.
#pragma once

#include "denhartog/answer/solution.hpp"
#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief (38) by (22)-(35) as printed, in float, double, long double and 50 digits; no question of the regime is asked. A peer a
/// number type.
[[nodiscard]] std::vector<Peer> printed_form_peers();

/// @brief (38) by the forms that callers get, outside the domain (69) without an answer; in float without (69). A peer a number
/// type.
[[nodiscard]] std::vector<Peer> shipped_form_peers();

/// @brief The exact solver's periodic orbit from rest, amplitude of the contact alone.
[[nodiscard]] Peer exact_solver_peer();

/// @brief The paper's Runge-Kutta at tolerances from 1e-3 to 1e-12, absolute and relative alike: over its 200 cycles, and over as
/// many as damping needs to bring transients down to the tolerance. Two peers a tolerance.
[[nodiscard]] std::vector<Peer> paper_algorithm_peers();

/// @brief What `solve` is asked on the chart, the same as all other methods: the amplitude of the mass in contact.
[[nodiscard]] Question question_of_chart(const System<double>& system, int digits);

/// @brief `solve` of a prepared system, asked for the amplitude of the contact to 2, 4, 8, 12, 15 and 30 digits. A peer a number
/// of digits.
[[nodiscard]] std::vector<Peer> solve_peers();

/// @brief All of these. @return the peers
[[nodiscard]] std::vector<Peer> own_peers();

/// @brief Rate at which the slowest transient of a system that slides decays. The smallest \f$ \zeta_i r_{n,i} \f$.
[[nodiscard]] double slowest_decay(const System<double>& system);

/// @brief Cycles that bring every transient down to a tolerance, from 20 to 20000. With the `slowest_decay` they are
/// \f$ -\ln(\mathrm{tolerance})\, r / (2\pi\,\mathrm{decay}) \f$, rounded up.
[[nodiscard]] int cycles_needed(double decay, double r, double tolerance);

/// @brief Tolerances that the integrators of the chart are asked for. @return 1e-3, 1e-4 to 1e-12
[[nodiscard]] std::vector<double> chart_tolerances();

/// @brief A tolerance as a setting. @param tolerance the tolerance @return e.g. `1e-06`
[[nodiscard]] std::string tolerance_text(double tolerance);

} // namespace denhartog::tests
