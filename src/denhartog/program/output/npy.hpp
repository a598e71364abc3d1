/// @file
/// @brief Arrays of records in NumPy's file format, version 1.0.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace denhartog::program {

/// @brief A field of a record.
struct NpyField {
    std::string name; ///< its name, letters, digits and underscores
    std::string type; ///< its type without byte order: `f8`, `i4` or `i1`
};

/// @brief The file's beginning: magic string, version, length and a dictionary padded to a multiple of 64 bytes.
/// @param fields  fields of a record, packed without gaps
/// @param shape   lengths of the axes, the last running fastest
/// @return        the header; the records follow it
[[nodiscard]] std::string npy_header(const std::vector<NpyField>& fields, const std::vector<std::size_t>& shape);

/// @brief Appends a number to the records, least significant byte first.
/// @param records  the records
/// @param x        the number
template <class T>
void append(std::string& records, T x) {
    using Bits =
        std::conditional_t<sizeof(T) == 8, std::uint64_t, std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint8_t>>;
    static_assert(sizeof(T) == sizeof(Bits));
    const Bits bits = std::bit_cast<Bits>(x);
    for (std::size_t byte = 0; byte < sizeof(T); ++byte) records += static_cast<char>((bits >> (8 * byte)) & 0xff);
}

} // namespace denhartog::program
