#include "denhartog/sweep/sample.hpp"

#include <algorithm>
#include <bit>
#include <boost/random/sobol.hpp>
#include <cmath>

namespace denhartog::sweep {
namespace {

constexpr int bits_of_a_sample = 52;

// A bijection of 64 bits in which every bit of the input moves every bit of the output (the finaliser of splitmix64).
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

std::uint64_t key_of(std::uint64_t seed, std::size_t quantity) { return mixed(mixed(seed) + quantity); }

// The middle of one of 2^52 parts of (0, 1).
double as_fraction(std::uint64_t part) { return std::ldexp(static_cast<double>(part) + 0.5, -bits_of_a_sample); }

// Each half of the axis, of each half, and so on, is turned or not by a coin of its own.
std::uint64_t scrambled(std::uint64_t x, std::uint64_t key) {
    std::uint64_t turned = 0;
    for (int depth = 0; depth < bits_of_a_sample; ++depth) {
        const std::uint64_t half = (std::uint64_t(1) << depth) | (depth == 0 ? 0 : x >> (64 - depth));
        const std::uint64_t bit = (x >> (63 - depth)) ^ (mixed(key ^ mixed(half)) >> 63);
        turned = (turned << 1) | (bit & 1);
    }
    return turned;
}

// The direction numbers as the engine shows them: its point of Gray code 2^k is the k-th and the one before it together.
std::vector<std::vector<std::uint64_t>> directions_of(std::uint64_t count, std::size_t quantities) {
    std::vector<std::vector<std::uint64_t>> all(quantities);
    boost::random::sobol engine(quantities);
    for (int k = 0, most = static_cast<int>(std::bit_width(count - 1)); k < most; ++k) {
        engine.seed((std::uint64_t(1) << k) - 1);
        for (std::vector<std::uint64_t>& of_quantity : all) of_quantity.push_back(engine() ^ (k == 0 ? 0 : of_quantity.back()));
    }
    return all;
}

// A permutation of the numbers below count: halves of a word of 2h bits take turns in changing each other.
std::uint64_t permuted(std::uint64_t x, std::uint64_t count, std::uint64_t key) {
    const int h = std::max(1, (static_cast<int>(std::bit_width(count - 1)) + 1) / 2);
    const std::uint64_t mask = (std::uint64_t(1) << h) - 1;
    constexpr std::uint64_t rounds = 8;
    do {
        std::uint64_t left = x >> h, right = x & mask;
        for (std::uint64_t round = 0; round < rounds; ++round) {
            const std::uint64_t before = right;
            right = left ^ (mixed(key ^ mixed((round << 32 << 16) | right)) & mask);
            left = before;
        }
        x = (left << h) | right;
    } while (x >= count);
    return x;
}

} // namespace

UnitSamples::UnitSamples(Sampling sampling, std::uint64_t count, std::uint64_t seed, std::size_t quantities)
    : sampling_(sampling), count_(count), seed_(seed) {
    if (sampling == Sampling::sobol && quantities > 0) directions_ = directions_of(count, quantities);
}

double UnitSamples::at(std::uint64_t index, std::size_t quantity) const {
    const std::uint64_t key = key_of(seed_, quantity);
    if (sampling_ == Sampling::sobol) {
        std::uint64_t x = 0;
        for (std::uint64_t rest = index; rest != 0; rest &= rest - 1)
            x ^= directions_[quantity][static_cast<std::size_t>(std::countr_zero(rest))];
        return as_fraction(scrambled(x, key));
    }
    const double within = as_fraction(mixed(key + mixed(~index)) >> (64 - bits_of_a_sample));
    const double u = (static_cast<double>(permuted(index, count_, key)) + within) / static_cast<double>(count_);
    return as_fraction(static_cast<std::uint64_t>(std::ldexp(u, bits_of_a_sample)));
}

} // namespace denhartog::sweep
