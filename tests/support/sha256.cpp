#include "tests/support/sha256.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace denhartog::tests {
namespace {

// The fractional parts of the cube roots of the first 64 primes, and of the square roots of the first 8.
constexpr std::array<std::uint32_t, 64> of_cube_roots{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5, 0xd807aa98, 0x12835b01,
    0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc,
    0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147,
    0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116, 0x1e376c08,
    0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3, 0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208,
    0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};
constexpr std::array<std::uint32_t, 8> of_square_roots{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                                       0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

constexpr std::size_t block_size = 64;

void take_block(std::array<std::uint32_t, 8>& state, const unsigned char* block) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t n = 0; n < 16; ++n)
        w[n] = (std::uint32_t(block[4 * n]) << 24) | (std::uint32_t(block[4 * n + 1]) << 16) |
               (std::uint32_t(block[4 * n + 2]) << 8) | std::uint32_t(block[4 * n + 3]);
    for (std::size_t n = 16; n < 64; ++n) {
        const std::uint32_t a = w[n - 15], b = w[n - 2];
        w[n] = w[n - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3)) + w[n - 7] +
               (std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10));
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t n = 0; n < 64; ++n) {
        const std::uint32_t first =
            h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + of_cube_roots[n] + w[n];
        const std::uint32_t second = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + first;
        d = c;
        c = b;
        b = a;
        a = first + second;
    }
    const std::array<std::uint32_t, 8> change{a, b, c, d, e, f, g, h};
    for (std::size_t n = 0; n < 8; ++n) state[n] += change[n];
}

} // namespace

std::string sha256(std::string_view bytes) {
    std::array<std::uint32_t, 8> state = of_square_roots;
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    const std::size_t whole = bytes.size() / block_size * block_size, rest = bytes.size() - whole;
    for (std::size_t n = 0; n < whole; n += block_size) take_block(state, data + n);
    std::array<unsigned char, 2 * block_size> last{};
    std::copy_n(data + whole, rest, last.begin());
    last[rest] = 0x80;
    const std::size_t end = rest + 9 <= block_size ? block_size : 2 * block_size;
    const std::uint64_t bits = 8 * std::uint64_t(bytes.size());
    for (std::size_t n = 0; n < 8; ++n) last[end - 1 - n] = static_cast<unsigned char>(bits >> (8 * n));
    for (std::size_t n = 0; n < end; n += block_size) take_block(state, last.data() + n);
    std::string text;
    for (const std::uint32_t word : state)
        for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[(word >> shift) & 15];
    return text;
}

} // namespace denhartog::tests
