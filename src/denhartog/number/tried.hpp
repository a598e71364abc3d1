// The outcome of a computation: its value, or the reason why there is none.
#pragma once

#include <optional>

#include "denhartog/number/errors.hpp"

namespace denhartog {

template <class Value>
struct Tried {
    std::optional<Value> value{};
    bool at_pole = false; // whether there is none because a formula is outside its domain
    Reasons why{};        // why there is none

    // The value; what was thrown is thrown again if there is none.
    [[nodiscard]] Value& required() {
        if (at_pole) throw DomainError(why);
        if (!value) throw PrecisionError(why);
        return *value;
    }
};

// Computes. Bad input is no outcome: InputError passes.
template <class Compute>
[[nodiscard]] auto tried(const Compute& compute) -> Tried<decltype(compute())> {
    Tried<decltype(compute())> made;
    try {
        made.value.emplace(compute());
    } catch (const DomainError& e) {
        made.at_pole = true;
        made.why = e.why;
    } catch (const PrecisionError& e) {
        made.why = e.why;
    }
    return made;
}

} // namespace denhartog
