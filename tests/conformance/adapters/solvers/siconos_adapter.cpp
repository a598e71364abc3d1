// Siconos' Moreau-Jean time stepping under the conformance kit.
#include <iostream>

#include "tests/conformance/adapters/solvers/solver_adapter.hpp"
#include "tests/conformance/adapters/solvers/time_integrators.hpp"

int main() { return denhartog::tests::serve(denhartog::tests::siconos_time_integrator(16384), std::cin, std::cout); }
