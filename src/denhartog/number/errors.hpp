/// @file
/// @brief The three ways in which a question cannot be answered.
#pragma once

#include <stdexcept>
#include <string>

namespace denhartog {

/// @brief Input that breaks a rule: says which quantity, which rule, which value and, for a file, where.
struct InputError : std::invalid_argument {
    /// @param quantity_  the quantity as the user wrote it, e.g. `mass_ratios`
    /// @param rule_      the rule it breaks, e.g. `must be positive`
    /// @param value_     the value found, as text
    /// @param place_     JSON pointer or line and column; empty where the input is no file
    InputError(std::string quantity_, std::string rule_, std::string value_, std::string place_ = {})
        : std::invalid_argument(quantity_ + " " + rule_ + (value_.empty() ? "" : ", but is " + value_) +
                                (place_.empty() ? "" : " (at " + place_ + ")")),
          quantity(std::move(quantity_)), rule(std::move(rule_)), value(std::move(value_)), place(std::move(place_)) {}
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

} // namespace denhartog
