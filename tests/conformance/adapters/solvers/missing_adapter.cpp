// Stands for a solver whose package was not there to build with: missing_adapter SOLVER PACKAGE skips every question by name.
#include <iostream>

#include "tests/conformance/adapters/solvers/solver_adapter.hpp"

int main(int arguments, char** argument) {
    using namespace denhartog;
    if (arguments != 3) {
        std::cerr << "usage: missing_adapter SOLVER PACKAGE\n";
        return 2;
    }
    const std::string why = std::string("not installed: ") + argument[2];
    return tests::serve({argument[1], {}, [why](const Scene<double>&) { return why; }}, std::cin, std::cout);
}
