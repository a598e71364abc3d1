/// @file
/// @brief The bytes of an input as choices: of numbers, sizes, and what is left out.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace denhartog::fuzz {

/// @brief Choices, one byte or a few each; where the bytes end every choice is the first.
class Choices {
public:
    /// @brief Of the input, which outlives the object.
    explicit Choices(std::span<const std::uint8_t> bytes) : rest(bytes) {}

    /// @brief Whether there are bytes left. @return whether there are
    [[nodiscard]] bool more() const { return !rest.empty(); }
    /// @brief A byte. @return it; 0 where there is none
    std::uint8_t byte() {
        if (rest.empty()) return 0;
        const std::uint8_t first = rest.front();
        rest = rest.subspan(1);
        return first;
    }
    /// @brief One of some. @param count how many @return its number, from 0
    std::size_t of(std::size_t count) { return byte() % count; }
    /// @brief What is rare: one byte in sixteen. @return whether it is chosen
    bool rarely() { return byte() % 16 == 15; }
    /// @brief Any number at all. @return a number on the edge of a range, or one of eight bytes
    double any_number() {
        using Limits = std::numeric_limits<double>;
        constexpr double edges[] = {0,
                                    -0.0,
                                    -1,
                                    0.5,
                                    1,
                                    2,
                                    1e-12,
                                    1e-9,
                                    1e16,
                                    1e-160,
                                    1e155,
                                    1e-300,
                                    1e300,
                                    Limits::max(),
                                    Limits::min(),
                                    Limits::denorm_min(),
                                    Limits::infinity(),
                                    Limits::quiet_NaN()};
        const std::size_t edge = of(std::size(edges) + 3);
        if (edge < std::size(edges)) return edges[edge];
        std::uint64_t bits = 0;
        for (std::size_t n = 0; n < sizeof bits; ++n) bits = bits << 8U | byte();
        return std::bit_cast<double>(bits);
    }
    /// @brief A number that keeps the rules of most quantities, but rarely. @return a positive number, or any
    double number() { return rarely() ? any_number() : static_cast<double>(1 + byte()) / 32; }
    /// @brief Numbers. @param count how many @return them
    std::vector<double> numbers(std::size_t count) {
        std::vector<double> all;
        for (std::size_t n = 0; n < count; ++n) all.push_back(number());
        return all;
    }
    /// @brief What is left. @return it as text
    std::string_view text() {
        const std::string_view all(reinterpret_cast<const char*>(rest.data()), rest.size());
        rest = {};
        return all;
    }

private:
    std::span<const std::uint8_t> rest;
};

} // namespace denhartog::fuzz
