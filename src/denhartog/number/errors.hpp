/// @file
/// @brief Reasons, the outcomes of a question, the three exceptions of the library, and words for whatever else is thrown.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace denhartog {

/// @brief The kinds of reasons, which number/why.hpp lists.
enum class Why : std::uint8_t;

/// @brief A reason of an answer or a refusal.
struct Reason {
    Why says;                        ///< what it says
    std::array<double, 4> numbers{}; ///< the numbers that its sentence needs; a mass or a mode counts from 1
    std::string text{};              ///< the reason as a text, if it is no `Why`
    /// @brief Whether two say the same. @return true if they do
    bool operator==(const Reason&) const = default;
};

/// @brief Reasons in the order in which they are given.
struct Reasons : std::vector<Reason> {
    using vector::vector;
    /// @brief One reason. @param says what it says @param numbers the numbers that its sentence needs
    template <class... Numbers>
    Reasons(Why says, const Numbers&... numbers) : vector{Reason{says, {static_cast<double>(numbers)...}}} {}
    /// @brief A reason that is no `Why`, as a text. @param text a sentence without its full stop
    template <std::convertible_to<std::string> Text>
    Reasons(const Text& text) : vector{Reason{Why{}, {}, text}} {}
    /// @brief Appends reasons. @param more the reasons to append @return these
    Reasons& operator+=(const Reasons& more) {
        insert(end(), more.begin(), more.end());
        return *this;
    }
};

/// @brief Joins reasons. @param first the first ones @param then those after them @return all
[[nodiscard]] inline Reasons operator+(Reasons first, const Reasons& then) { return std::move(first += then); }

/// @brief Reasons as sentences. @param reasons the reasons @return the sentences, without the last full stop
[[nodiscard]] std::string in_words(const Reasons& reasons);

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

/// @brief Outcome of a question, or of a computation for it: an answer, or the kind of reason why there is none.
enum class Outcome : std::uint8_t {
    answered = 0,       ///< it has an answer
    at_a_pole = 1,      ///< a formula was asked for outside its domain, as at a pole: a mode without damping that resonates
    budget_spent = 2,   ///< the work allowed is spent, or the question was cancelled; more work may answer it
    digits_missing = 3, ///< numbers do not have the digits asked for, or what they say is not proved
    out_of_range = 4,   ///< a number is beyond the range of a double
    not_converged = 5,  ///< a search did not settle within its share of the work, or no motion became periodic
    unproved = 6,       ///< inside the reference alone: not proved with the bits of the moment, more may do
    disproved = 7       ///< inside the reference alone: certainly not so, and no number of bits helps
};

/// @brief The kind of reason why there is no value, and the reasons with their numbers.
struct Refusal {
    Outcome outcome = Outcome::answered; ///< `answered` where there is a value
    Reasons why{};                       ///< the reasons; none where there is a value

    /// @brief Whether there is a value, and so no refusal. @return true if so
    [[nodiscard]] bool is_answered() const { return outcome == Outcome::answered; }
};

/// @brief A formula was asked for outside its domain, e.g. the sliding motion beyond the boundary (69).
struct DomainError : std::domain_error, Refusal {
    /// @param why_  why there is no value
    explicit DomainError(Reasons why_) : std::domain_error(in_words(why_)), Refusal{Outcome::at_a_pole, std::move(why_)} {}
};

/// @brief A computation did not reach the digits asked for, or spent the work that it is allowed, or left the range of a double,
/// or found no steady motion; `outcome` says which.
struct PrecisionError : std::runtime_error, Refusal {
    /// @param why_      why there is no value
    /// @param outcome_  the kind of that reason
    explicit PrecisionError(Reasons why_, Outcome outcome_ = Outcome::digits_missing)
        : std::runtime_error(in_words(why_)), Refusal{outcome_, std::move(why_)} {}
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
