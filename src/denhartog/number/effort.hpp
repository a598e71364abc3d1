/// @file
/// @brief A budget of work, counted in operations: no search runs on without end, and none looks at a clock.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>

namespace denhartog {

/// @brief Work allowed and spent.
///
/// One operation is the evaluation of one mode at one instant in double: an exponential, a sine, a cosine and what goes with
/// them, about a tenth of a microsecond. A search that finds its budget spent ends and gives what is certain until then.
struct Effort {
    long allowed = std::numeric_limits<long>::max(); ///< operations allowed
    long spent = 0;                                  ///< operations spent
    const std::atomic<bool>* cancelled = nullptr;    ///< ends the search from outside once it is true; null: nobody does

    /// @brief Counts operations. @param operations how many
    void spend(long operations) { spent += operations; }
    /// @brief Whether a search has to end. @return true where the budget is spent or somebody cancelled
    [[nodiscard]] bool exhausted() const {
        return spent >= allowed || (cancelled != nullptr && cancelled->load(std::memory_order_relaxed));
    }
};

/// @brief Operations that one mode at one instant costs in a number type: one in double, about a third of the bits in others.
/// @return the operations
template <class T>
[[nodiscard]] constexpr long cost_of_mode() {
    return std::numeric_limits<T>::digits <= 64 ? 1 : std::numeric_limits<T>::digits / 3;
}

/// @brief The budget of a question where none is asked for: about two seconds for twelve modes and fewer.
/// @param modes  number of modes
/// @return       the operations
[[nodiscard]] constexpr long default_effort(std::size_t modes) {
    return 10'000'000 / 12 * static_cast<long>(std::max<std::size_t>(modes, 12));
}

} // namespace denhartog
