/// @file
/// @brief Random numbers that are the same on every platform, to the last bit.
#pragma once

#include <cmath>
#include <cstdint>

namespace denhartog {

/// @brief Steele, Lea and Flood's SplitMix64: a counter and a mixing function, the same on every platform.
///
/// Call it once an expression: the order within one is the compiler's.
class SplitMix64 {
public:
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

    /// @brief The next number. @return 64 random bits
    std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    /// @brief An integer between two bounds, both included. @param low least @param high largest @return the integer
    int integer(int low, int high) { return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1)); }

    /// @brief A chance. @param n how rare @return true one time in n
    bool one_in(int n) { return integer(1, n) == 1; }

    /// @brief A number of 53 random bits in [2^low, 2^(high+1)), equally often in every octave; rounded where it is subnormal.
    double over_octaves(int low, int high) {
        const double significand = 1 + static_cast<double>(next() >> 12) * 0x1p-52;
        return std::ldexp(significand, integer(low, high));
    }

    /// @brief 1, or 1 with a deviation of either sign. @param least exponent of two of the least @param most of the largest
    double near_one(int least, int most) {
        const double deviation = over_octaves(least, most);
        return one_in(2) ? 1 + deviation : 1 - deviation;
    }

private:
    std::uint64_t state_;
};

} // namespace denhartog
