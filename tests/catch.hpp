/// @file
/// @brief Catch2, version 2 or 3, and the way a failing message prints a number.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

#include <cstdio>
#include <string>

/// @brief Ends no test, but has it counted as skipped. @param why what is missing, as `WARN` takes it
#define SKIPPED(why)                                                                                                             \
    do {                                                                                                                         \
        WARN("skipped: " << why);                                                                                                \
        SUCCEED();                                                                                                               \
    } while (false)

namespace denhartog::tests {

/// @brief A number in hexadecimal, to be pasted back exactly. @param x a number @return its digits as `%a` prints them
[[nodiscard]] inline std::string hexadecimal(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", x);
    return text;
}

/// @brief A number in hexadecimal, to be pasted back exactly. @param x a number @return its digits as `%La` prints them
[[nodiscard]] inline std::string hexadecimal(long double x) {
    char text[48];
    std::snprintf(text, sizeof text, "%La", x);
    return text;
}

} // namespace denhartog::tests
