/// @file
/// @brief The methods of the chart: those of this library, equivalent linearisation, harmonic balance, and integrators in time.
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

/// @brief Equivalent linearisation with the first harmonic \f$ 4\beta/\pi \f$ of a square wave, in closed form. One method,
/// without settings.
[[nodiscard]] std::vector<Peer> monoharmonic_peers();

// Harmonic balance by alternating frequency and time, as small as it can be: odd harmonics, one contact. Unknown are the
// harmonics lambda_n of friction on the contact alone: the linear system is condensed to its receptances there,
// X_n = delta_n1 h_l - h_n lambda_n. In time, friction is a law of its trial lambda and of x_j'. Odd harmonics describe every
// motion that mirrors itself after half a period, Eq. (25).

/// @brief The law of friction in time, with a width w in velocity.
enum class FrictionLaw {
    regularised,         ///< beta tanh(v / w)
    augmented_lagrangian ///< exact Coulomb: lambda is what lies nearest in [-beta, beta] to lambda + beta v / w
};

/// @brief A setting of harmonic balance.
struct HarmonicBalanceSetting {
    FrictionLaw law;       ///< the law
    int highest;           ///< highest harmonic, odd
    double sharpness = 10; ///< width of the law: the velocity of the first harmonic over (highest times sharpness)
};

/// @brief Harmonic balance at one setting. @param setting the setting @return the method; its unit of work is a Newton step
[[nodiscard]] Peer harmonic_balance(const HarmonicBalanceSetting& setting);

/// @brief Both laws with harmonics up to 1, 3, 5, 11, 21, 51, 101. @return the methods
[[nodiscard]] std::vector<Peer> harmonic_balance_peers();

// Integrators as people write them: friction as a function of velocity in the right-hand side, no events. From rest until two
// successive periods agree to the setting's tolerance or 400 have passed; the answer is the maximum of the period after that.
// The equations are integrated in modal coordinates, where a right-hand side costs least.

/// @brief A setting of a plain integrator.
struct PlainSetting {
    double eps = 0;       ///< friction is beta tanh(v / eps), v in units of y_0 a radian; 0: beta sgn(v)
    int steps = 0;        ///< fixed steps a period, Runge-Kutta of fourth order; 0: fifth order, step size controlled
    double tolerance = 0; ///< absolute and relative error of a controlled step; to which two periods agree
    /// As many fixed steps as stability asks for where friction is steepest, and at least `steps`.
    bool stable = false;
};

/// @brief Right-hand sides after which an integrator counts as stalled.
inline constexpr long most_plain_evaluations = 4'000'000;

/// @brief The integrator at one setting. @param setting the setting @return the method; its unit of work is a right-hand side
[[nodiscard]] Peer plain_integrator(const PlainSetting& setting);

/// @brief sgn(v), and tanh(v/eps) for eps from 1e-2 to 1e-6, by both integrators. @return the methods
[[nodiscard]] std::vector<Peer> plain_integrator_peers();

/// @brief CVODE, Adams' methods, with its root finding at the ends of sliding and sticking, at tolerances from 1e-3 to 1e-12.
///
/// A step is at most a sixteenth of a period long: while the contact of a single mass sticks no error bounds it, and whole
/// periods would be skipped. Ends of phases restart the integrator. A peer a tolerance; one without a method where SUNDIALS was
/// not there to build with.
[[nodiscard]] std::vector<Peer> cvode_peers();

/// @brief Siconos' Moreau-Jean scheme, theta = 1/2, with friction as a relay, 100 to 100000 steps a period.
///
/// The scheme's relay bounds are impulses, beta times the step; and it looks at a contact only where a gap is below zero, so that
/// the relation between relay and displacement has an offset that no motion reaches. A peer a number of steps; one without a
/// method where Siconos was not there to build with.
[[nodiscard]] std::vector<Peer> siconos_peers();

} // namespace denhartog::tests
