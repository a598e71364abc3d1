/// @file
/// @brief Checksums of the vector files.
#pragma once

#include <string>
#include <string_view>

namespace denhartog::conformance::generator {

/// @brief SHA-256, FIPS 180-4. @param bytes the bytes @return 64 hexadecimal digits
[[nodiscard]] std::string sha256(std::string_view bytes);

} // namespace denhartog::conformance::generator
