// The outcome of a computation as a value. Inside the library it is passed on as one; an exception from below becomes one in
// `tried`, and `required` makes an exception of it where a function that users call has no answer.
#pragma once

#include <optional>
#include <utility>

#include "denhartog/number/errors.hpp"

namespace denhartog {

// Nothing where there is a value, else the exception of its outcome.
inline void require(const Refusal& made) {
    if (made.outcome == Outcome::at_a_pole) throw DomainError(made.why);
    if (!made.is_answered()) throw PrecisionError(made.why, made.outcome);
}

// A value, or why there is none.
template <class Value>
struct Tried : Refusal {
    std::optional<Value> value{};

    Tried() : value(std::in_place) {} // an empty value, to be filled
    Tried(Value made) : value(std::move(made)) {}
    Tried(Refusal none) : Refusal(std::move(none)) {}
    Tried(Outcome none, Reasons because) : Refusal{none, std::move(because)} {}

    // The value; DomainError or PrecisionError where there is none.
    [[nodiscard]] Value& required() {
        require(*this);
        return *value;
    }
};

// Computes. Bad input is no outcome: InputError passes.
template <class Compute>
[[nodiscard]] auto tried(const Compute& compute) -> Tried<decltype(compute())> try {
    return compute();
} catch (const Refusal& none) {
    return none;
}

} // namespace denhartog
