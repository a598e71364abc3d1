/// @file
/// @brief The three ways in which a question cannot be answered, and words for whatever else is thrown.
#pragma once

#include <stdexcept>
#include <string>

namespace denhartog {

/// @brief Input that breaks a rule. It says which quantity, which rule, which value and, in a file, where.
///
/// `what()` reads "QUANTITY RULE, but is VALUE (at PLACE)". Text from outside is made legible: control characters are replaced
/// and long texts are cut, so that neither reaches a terminal or a log.
struct InputError : std::invalid_argument {
    /// @param quantity_  the quantity as the user wrote it, e.g. `mass_ratios`
    /// @param rule_      the rule it breaks, e.g. `must be positive`
    /// @param value_     the value found, as text
    /// @param place_     JSON pointer, or line and column; empty if the input is not a file
    InputError(const std::string& quantity_, const std::string& rule_, const std::string& value_, const std::string& place_ = {});
    std::string quantity; ///< the quantity as the user wrote it
    std::string rule;     ///< the rule that it breaks
    std::string value;    ///< the value found, as text
    std::string place;    ///< JSON pointer, or line and column
};

/// @brief A formula was asked for outside its domain, e.g. the sliding motion beyond the boundary (69).
struct DomainError : std::domain_error {
    using std::domain_error::domain_error;
};

/// @brief A computation could not reach the digits asked for, or spent the work that it is allowed, or found no steady motion.
struct PrecisionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// @brief Whether an exception says that a computed number left the range of its type.
/// @param fault  the exception
/// @return       true for an overflow, an underflow or a range error of the standard library
[[nodiscard]] bool is_beyond_range(const std::exception& fault) noexcept;

/// @brief The text of an exception, in the words of this library, whoever threw it.
/// @param fault  the exception
/// @return       `what()` of an error of this library; for any other, a sentence about memory, range, the system, or a defect
[[nodiscard]] const char* in_own_words(const std::exception& fault) noexcept;

} // namespace denhartog
