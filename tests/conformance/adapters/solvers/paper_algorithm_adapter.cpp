// The paper's own Runge-Kutta, Section 3.1, under the conformance kit: paper_algorithm_adapter [TOLERANCE].
#include "tests/conformance/adapters/solvers/period.hpp"
#include "tests/conformance/adapters/solvers/solver_adapter.hpp"

int main(int argc, char** argv) { return denhartog::tests::serve_at(argc, argv, 1e-12, denhartog::tests::paper_time_integrator); }
