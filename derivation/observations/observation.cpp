#include "observation.hpp"

#include <cstdio>

namespace denhartog::derivation {

Claim observation(std::string id, std::vector<std::string> equations, std::string title, std::vector<std::string> assumptions,
                  std::function<Outcome()> check) {
    return {.id = std::move(id),
            .equations = std::move(equations),
            .role = Role::observation,
            .title = std::move(title),
            .assumptions = std::move(assumptions),
            .check = std::move(check)};
}

std::string rounded(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", x);
    return buffer;
}

} // namespace denhartog::derivation
