// SUNDIALS CVODE with root finding under the conformance kit: cvode_adapter [TOLERANCE].
#include "tests/conformance/adapters/solvers/period.hpp"
#include "tests/conformance/adapters/solvers/solver_adapter.hpp"

int main(int argc, char** argv) { return denhartog::tests::serve_at(argc, argv, 1e-12, denhartog::tests::cvode_time_integrator); }
