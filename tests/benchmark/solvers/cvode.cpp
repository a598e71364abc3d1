// SUNDIALS CVODE: `benchmark-cvode TOLERANCE PACK`.
#include "tests/benchmark/solvers/pack_runner.hpp"
#include "tests/conformance/adapters/solvers/period.hpp"

int main(int argc, char** argv) {
    using namespace denhartog::tests;
    return run_pack(argc, argv, [](const std::string& tolerance, double budget) {
        return settled("SUNDIALS CVODE", "tolerance " + tolerance, cvode_time_integrator(positive(tolerance)), budget);
    });
}
