/// @file
/// @brief The paper's order of its numbered equations.
#pragma once

#include <stdexcept>
#include <string>

namespace denhartog::derivation {

/// @brief Place of an equation in the paper: (1) to (88), then (A.1) to (A.15).
/// @param equation  `46` or `A.7`
/// @return          1 to 103
/// @throws          std::invalid_argument where there is no such equation
[[nodiscard]] inline int position_of_equation(const std::string& equation) {
    const bool appendix = equation.rfind("A.", 0) == 0;
    const std::string number = appendix ? equation.substr(2) : equation;
    const int last = appendix ? 15 : 88;
    if (number.empty() || number.size() > 2 || number.find_first_not_of("0123456789") != std::string::npos ||
        number.front() == '0' || std::stoi(number) > last)
        throw std::invalid_argument("equation must be 1 to 88 or A.1 to A.15, but is " + equation);
    return (appendix ? 88 : 0) + std::stoi(number);
}

} // namespace denhartog::derivation
