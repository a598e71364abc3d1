/// @file
/// @brief The three ways in which a question cannot be answered, and words for whatever else is thrown.
#pragma once

#include <stdexcept>
#include <string>

namespace denhartog {

/// @brief Input that breaks a rule: says which quantity, which rule, which value and, for a file, where.
///
/// Every message with text from outside is made here: each part is made legible, so that neither control characters nor texts
/// without end reach a terminal or a log.
struct InputError : std::invalid_argument {
    /// @param quantity_  the quantity as the user wrote it, e.g. `mass_ratios`
    /// @param rule_      the rule it breaks, e.g. `must be positive`
    /// @param value_     the value found, as text
    /// @param place_     JSON pointer or line and column; empty where the input is no file
    InputError(const std::string& quantity_, const std::string& rule_, const std::string& value_, const std::string& place_ = {});
    std::string quantity; ///< the quantity as the user wrote it
    std::string rule;     ///< the rule that it breaks
    std::string value;    ///< the value found, as text
    std::string place;    ///< JSON pointer, or line and column
};

/// @brief A formula asked for where it does not hold, e.g. the sliding motion beyond the boundary (69).
struct DomainError : std::domain_error {
    using std::domain_error::domain_error;
};

/// @brief A computation that could not reach the digits asked for.
struct PrecisionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// @brief Whether a number that was computed left the range of its type.
/// @param fault  what was thrown
/// @return       whether it tells of an overflow or the like
[[nodiscard]] bool is_beyond_range(const std::exception& fault) noexcept;

/// @brief What was thrown, in the words of this library: quantity and rule, whoever threw it.
/// @param fault  what was thrown
/// @return       the text of an error of this library; of any other a text about memory, range, the system, or a defect
[[nodiscard]] const char* in_own_words(const std::exception& fault) noexcept;

} // namespace denhartog
