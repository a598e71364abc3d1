// The paper's own Runge-Kutta, Section 3.1, under the conformance kit.
#include <iostream>

#include "tests/conformance/adapters/solvers/solver_adapter.hpp"
#include "tests/conformance/adapters/solvers/time_integrators.hpp"

int main() { return denhartog::tests::serve(denhartog::tests::paper_time_integrator(1e-12), std::cin, std::cout); }
