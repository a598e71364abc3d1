// Siconos' Moreau-Jean time stepping: `benchmark-siconos STEPS PACK`.
#include "tests/benchmark/solvers/pack_runner.hpp"
#include "tests/conformance/adapters/solvers/period.hpp"

int main(int argc, char** argv) {
    using namespace denhartog::tests;
    return run_pack(argc, argv, [](const std::string& steps, double budget) {
        return settled("Siconos, Moreau-Jean", steps + " steps a period",
                       siconos_time_integrator(static_cast<int>(positive(steps))), budget);
    });
}
