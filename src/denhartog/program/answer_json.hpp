/// @file
/// @brief Answers as JSON objects, the keys in the order of the documentation.
#pragma once

#include "denhartog/program/number_json.hpp"
#include "denhartog/solve/answer.hpp"

namespace denhartog::program {

/// @brief An answer to `response`: regime, boundary, method and, in the sliding regime, every mass.
/// @param answer  the answer, with beta
/// @param write   how numbers are written
/// @return        the object; fields that mean nothing in the regime are absent
[[nodiscard]] Json response_json(const Answer& answer, const NumberWriter& write);

/// @brief The friction ratios that bound the regimes, `beta_lim`.
/// @param b      the boundary
/// @param write  how numbers are written
/// @return       the object; sticking absent where no friction holds the contact
template <class T>
[[nodiscard]] Json limits_json(const Boundary<T>& b, const NumberWriter& write) {
    Json all{{"exact", write(b.exact)}, {"paper", write(b.paper)}, {"approximate", write(b.approximate)}};
    if (b.sticking) all["sticking"] = write(*b.sticking);
    return all;
}

/// @brief How an answer was computed.
/// @param m  the method
/// @return   the object
[[nodiscard]] Json method_json(const Method& m);

/// @brief An answer to `boundary`: the friction ratios that bound the regimes, and the condition that binds.
/// @param answer  the answer, without beta
/// @param write   how numbers are written
/// @return        the object
[[nodiscard]] Json boundary_json(const Answer& answer, const NumberWriter& write);

} // namespace denhartog::program
