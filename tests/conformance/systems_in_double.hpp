// The library in double: its sums over modes, and its answers on systems beyond the paper.
#pragma once

#include "conformance/question.hpp"
#include "denhartog/sliding/mode_sums.hpp"

namespace denhartog::tests {

// The answer that the sums over modes give: what friction does not change, and the motion of a row while the contact slides.
[[nodiscard]] std::vector<double> numbers_of_sums(const conformance::ProtocolQuestion& q, const ModeSums<double>& s,
                                                  std::size_t k);

// The answer about a system beyond the paper (a contact between two masses, several loads, a moving base, matrices), by the
// library in double. None if only a chain has the quantity, or if the motion takes more than one period to repeat. Throws
// InputError if the question breaks a rule; DomainError and PrecisionError if the library has no answer.
[[nodiscard]] std::optional<conformance::Value> answer_of_system(const conformance::ProtocolQuestion& q);

} // namespace denhartog::tests
