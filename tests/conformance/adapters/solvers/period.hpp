/// @file
/// @brief What a time integrator does for the conformance kit, one period of the force from a given state, and the integrators.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/scene/scene.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog::tests {

/// @brief The masses at an instant.
struct Node {
    double tau = 0;        ///< from the maximum of the force at the start of the period
    std::vector<double> y; ///< displacements, then velocities, 2N
};

/// @brief The largest size of the contact's displacement, where an integrator finds it closer than its nodes tell.
struct ContactExtremum {
    double amplitude = 0;        ///< largest |x_j|
    std::optional<double> phase; ///< instant of the largest x_j
};

/// @brief What an integration over one period leaves.
struct PeriodRecord {
    std::string failure;                    ///< why the period could not be integrated; empty where it could
    std::vector<double> end;                ///< displacements, then velocities, at the end
    std::vector<Node> nodes;                ///< instants from 0 to 2 pi; where asked for
    std::vector<Stop> rests;                ///< of the contact, where asked for; one that lasts over the end in two parts
    std::optional<ContactExtremum> contact; ///< of the contact, where the integrator has it from elsewhere
};

/// @brief Integrates one period of the force, from its maximum on. @param y the state at the start @param nodes how many equal
/// parts of the period are recorded; 0 for the end alone
using OnePeriod = std::function<PeriodRecord(const std::vector<double>& y, int nodes)>;

/// @brief An integrator at one setting.
struct Stage {
    OnePeriod period;     ///< one period at this setting
    double tolerance = 0; ///< what may be left of transients, relative to the state
    int most_periods = 0; ///< periods after which the motion is said not to settle
    int nodes = 0;        ///< parts of a period recorded, at least
};

/// @brief A time integrator under test.
struct TimeIntegrator {
    std::string name; ///< as the handshake gives it
    /// @brief Prepares for a scene: settings from coarse to fine. Each starts where the one before settled.
    std::function<std::vector<Stage>(const Scene<double>&)> prepare;
    /// @brief Why the integrator cannot model a scene; empty where it can.
    std::function<std::string(const Scene<double>&)> declines = [](const Scene<double>&) { return std::string(); };
};

/// @brief A number as names and sentences have it. @param x the number @return its first figure and its exponent, e.g. `1e-12`
[[nodiscard]] std::string brief(double x);

/// @brief A setting as a positive number. @param text the setting @return the number @throws InputError where it is none
[[nodiscard]] double positive(const std::string& text);

/// @brief The paper's own Runge-Kutta, Section 3.1. @param tolerance absolute and relative @return the integrator
[[nodiscard]] TimeIntegrator paper_time_integrator(double tolerance);

/// @brief SUNDIALS CVODE, Adams' methods, with root finding. @param tolerance absolute and relative @return the integrator
[[nodiscard]] TimeIntegrator cvode_time_integrator(double tolerance);

/// @brief Siconos' Moreau-Jean scheme, from 256 steps a period. @param most_steps the most steps a period @return the integrator
[[nodiscard]] TimeIntegrator siconos_time_integrator(int most_steps);

} // namespace denhartog::tests
