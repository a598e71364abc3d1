/// @file
/// @brief The settled motion of a scene by two routes in 50 digits: the reference of the library, and the physical coordinates.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/scene/scene.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::benchmark {

/// @brief Instants of a period at which the motion is given.
inline constexpr int instants = 64;
/// @brief What is smaller is rounding: the number is zero.
inline constexpr double no_motion = 1e-30;

/// @brief Where the contact's motion changes: it comes to rest, breaks away, or turns without a rest.
struct Event {
    Real50 tau; ///< instant, from the maximum of the force, in [0, 2 pi)
    int before; ///< sign of the contact's velocity before it, 0 where it rests
    int after;  ///< the same after it
    Real50 x;   ///< displacement of the contact there
};

/// @brief Displacements and velocities of all masses at an instant.
struct Sample {
    std::vector<Real50> x;       ///< displacements, N values
    std::vector<Real50> x_prime; ///< velocities with respect to tau, N values
};

/// @brief A settled motion.
struct Motion {
    int at_start = 0;                         ///< sign of the contact's velocity at the maximum of the force, 0 where it rests
    std::vector<Event> events;                ///< within a period, ascending
    std::vector<Sample> samples;              ///< at tau = 2 pi n / instants
    std::vector<Real50> amplitude;            ///< of each mass: largest |x_k|
    std::vector<std::optional<Real50>> phase; ///< lag behind the force in (-pi, pi]; none where the mass does not move
    bool rests = false;                       ///< the contact rests for ever
};

/// @brief The motion from rest at zero by the library: found by the exact solver in double, and proved by the reference.
/// DomainError where it is not one period of the force long, or an event is decided by rounding.
[[nodiscard]] Motion library_motion(const Scene<double>& scene);

/// @brief The same motion as one boundary-value problem on physical coordinates: the state at the maximum of the force and the
/// instants of all events by Newton's method, phases by matrix exponentials. Nothing here knows of modes. Of the motion by
/// another route the order of phases is taken over, and its numbers rounded to doubles are the start. DomainError where Newton's
/// method does not converge or a phase does not move as it should.
[[nodiscard]] Motion physical_motion(const Scene<double>& scene, const Motion& seen);

/// @brief Decimal digits on which two motions agree, counted to 40: of displacements and velocities against the largest of all,
/// of instants and phases in radians. -1 where they differ in kind.
[[nodiscard]] int agreement(const Motion& a, const Motion& b);

/// @brief Periods from rest at zero until all displacements and velocities at the maximum of the force are those of the settled
/// motion to a tolerance times the largest of them. The motion is followed on the physical coordinates. Tolerances descend; 0
/// stands for one that was not reached.
[[nodiscard]] std::vector<int> periods_to_settle(const Scene<double>& scene, const Motion& settled,
                                                 const std::vector<double>& tolerances);

} // namespace denhartog::benchmark
