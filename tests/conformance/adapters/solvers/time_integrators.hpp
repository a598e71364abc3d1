/// @file
/// @brief The time integrators, each at a setting: for the conformance kit and for the benchmark.
#pragma once

#include "tests/conformance/adapters/solvers/period.hpp"

namespace denhartog::tests {

/// @brief The paper's own Runge-Kutta, Section 3.1. @param tolerance absolute and relative @return the integrator
[[nodiscard]] TimeIntegrator paper_time_integrator(double tolerance);

/// @brief SUNDIALS CVODE, Adams' methods, with root finding. @param tolerance absolute and relative @return the integrator
[[nodiscard]] TimeIntegrator cvode_time_integrator(double tolerance);

/// @brief Siconos' Moreau-Jean scheme, from 256 steps a period. @param most_steps the most steps a period @return the integrator
[[nodiscard]] TimeIntegrator siconos_time_integrator(int most_steps);

} // namespace denhartog::tests
