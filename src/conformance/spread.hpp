/// @file
/// @brief A few of many, from all over a list.
#pragma once

#include <algorithm>
#include <vector>

namespace denhartog::conformance {

/// @brief Some elements of a list, equally spaced. @param all the list @param most how many at most @return these, in its order
template <class T>
[[nodiscard]] std::vector<T> spread(const std::vector<T>& all, std::size_t most) {
    const std::size_t count = std::min(all.size(), most);
    std::vector<T> some;
    for (std::size_t n = 0; n < count; ++n) some.push_back(all[n * all.size() / count]);
    return some;
}

} // namespace denhartog::conformance
