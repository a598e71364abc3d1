// Siconos' Moreau-Jean time stepping under the conformance kit: siconos_adapter [STEPS], at last, a period.
#include "tests/conformance/adapters/solvers/period.hpp"
#include "tests/conformance/adapters/solvers/solver_adapter.hpp"

int main(int argc, char** argv) {
    return denhartog::tests::serve_at(
        argc, argv, 16384, [](double steps) { return denhartog::tests::siconos_time_integrator(static_cast<int>(steps)); });
}
