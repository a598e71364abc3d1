/// @file
/// @brief Bytes that choose what the C functions are given, and outputs that tell whether they were written.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <denhartog.h>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "tests/fuzz/claims.hpp"

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

/// @brief Bits of a NaN that no computation makes: a number that has not been written.
inline constexpr std::uint64_t unwritten = 0x7ff8'dead'beef'1234;

/// @brief An array for numbers, rarely a null pointer.
class Output {
public:
    /// @brief Room for so many numbers; the choices say whether it is null.
    Output(Choices& choices, std::size_t size)
        : numbers(size, std::bit_cast<double>(unwritten)), pointer(choices.rarely() ? nullptr : numbers.data()) {}
    /// @brief The array. @return its start; null where there is none
    [[nodiscard]] double* data() { return pointer; }
    /// @brief Checks it after a call. @param ok whether the call answered @param written how many numbers it then writes
    void check(bool ok, std::size_t written) const {
        for (std::size_t n = 0; n < numbers.size(); ++n) {
            const bool is_unwritten = std::bit_cast<std::uint64_t>(numbers[n]) == unwritten;
            const bool expected = pointer != nullptr && ok && n < written;
            claim(is_unwritten != expected, expected ? "every number is written" : "what is not asked for is untouched");
            claim(!expected || std::isfinite(numbers[n]), "a number handed out is finite");
        }
    }

private:
    std::vector<double> numbers;
    double* pointer;
};

/// @brief A struct that receives an answer: null, too small, as it is, or larger than the library knows.
template <class Struct>
class StructOutput {
public:
    /// @brief The choices say what size it has, and whether it is null.
    explicit StructOutput(Choices& choices) : bytes(sizeof(Struct) + 16, filler) {
        const std::size_t sizes[] = {sizeof(Struct), sizeof(Struct) + 16, sizeof(Struct) - 1, 0};
        const std::size_t size = sizes[choices.rarely() ? choices.of(4) : 0];
        std::memcpy(bytes.data(), &size, sizeof size);
        before = bytes;
        pointer = choices.rarely() ? nullptr : reinterpret_cast<Struct*>(bytes.data());
    }
    /// @brief The struct. @return it; null where there is none
    [[nodiscard]] Struct* data() { return pointer; }
    /// @brief Checks it after a call. @param ok whether the call answered @param numbers its numbers
    void check(bool ok, std::initializer_list<double Struct::*> numbers) const {
        if (!ok) return claim(bytes == before, "after a fault a struct is untouched");
        claim(std::memcmp(bytes.data(), before.data(), sizeof(std::size_t)) == 0, "the size of a struct is the caller's");
        claim(std::memcmp(bytes.data() + sizeof(Struct), before.data() + sizeof(Struct), 16) == 0,
              "no more than the struct is written");
        double unwritten_number = 0;
        std::memcpy(&unwritten_number, before.data() + sizeof(std::size_t), sizeof unwritten_number);
        for (const auto number : numbers) {
            const double x = pointer->*number;
            claim(std::isfinite(x) && x != unwritten_number, "every number of a struct is written and finite");
        }
    }

private:
    static constexpr unsigned char filler = 0xA5;
    std::vector<unsigned char> bytes, before;
    Struct* pointer = nullptr;
};

/// @brief Checks the status of a call, and the message that a fault leaves. `allowed` is what the header says that it may return,
/// but for #DH_OK. True where it answered.
inline bool answered(int status, std::initializer_list<int> allowed, const char* what) {
    if (status == DH_OK) return true;
    bool documented = false;
    for (const int each : allowed) documented = documented || each == status;
    claim(documented, "the status is one of the header's",
          std::string(what) + ": " + dh_status_text(status) + ": " + dh_last_message());
    claim_message(dh_last_message());
    return false;
}

} // namespace denhartog::fuzz
