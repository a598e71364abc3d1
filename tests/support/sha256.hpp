/// @file
/// @brief SHA-256 (FIPS 180-4), the checksum of files of reference data: `sha256sum` gives the same.
#pragma once

#include <string>
#include <string_view>

namespace denhartog::tests {

/// @brief The checksum of some bytes. @param bytes the bytes @return 64 hexadecimal digits
[[nodiscard]] std::string sha256(std::string_view bytes);

} // namespace denhartog::tests
