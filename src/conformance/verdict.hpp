/// @file
/// @brief Verdicts on answers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "conformance/vector.hpp"

namespace denhartog::conformance {

/// @brief What an answer is.
enum class Verdict : std::uint8_t {
    pass,         ///< right to the digits that the question allows in double
    pass_loose,   ///< right to fewer digits, which is still as good as a careful user needs
    inaccurate,   ///< roughly right, but with too few digits
    as_printed,   ///< wrong; the value is that of an equation as the paper prints it
    wrong,        ///< wrong
    wrong_regime, ///< wrong; the answer belongs to another regime
    rejected,     ///< right: the question had to be rejected, and it was
    not_rejected, ///< wrong: the question had to be rejected, but it was answered
    skipped,      ///< not answered, which is no fault by itself
    crash,        ///< the program ended, closed its output, or wrote without an end
    timeout,      ///< no answer in time, while the program was computing
    stall         ///< no answer in time, while the program was waiting
};

/// @brief Number of verdicts.
inline constexpr std::size_t number_of_verdicts = 12;

/// @brief A verdict as reports write it. @param verdict the verdict @return e.g. `pass-loose`
[[nodiscard]] std::string_view name(Verdict verdict);

/// @brief A verdict by its name. @param name e.g. `pass-loose` @return the verdict; empty if none has the name
[[nodiscard]] std::optional<Verdict> verdict_named(std::string_view name);

/// @brief Whether an answer is right. @param verdict its verdict @return true for `pass`, `pass-loose` and `rejected`
[[nodiscard]] bool is_right(Verdict verdict);

/// @brief Whether an answer has a value that is not right to its digits. @param verdict its verdict
/// @return true for `inaccurate`, `as-printed`, `wrong` and `wrong-regime`
[[nodiscard]] bool is_wrong_value(Verdict verdict);

/// @brief How bad a verdict is, to compare two runs. @param verdict the verdict @return 0 for the best; equal numbers are equally
/// bad
[[nodiscard]] int badness(Verdict verdict);

/// @brief A vector with the verdict on the answer to it.
struct Judged {
    const Vector* vector = nullptr;     ///< what was asked
    Verdict verdict = Verdict::skipped; ///< the verdict
    std::string reason;                 ///< why, if there is more to say than the verdict
    std::string equation;               ///< for `as-printed`: the equation that is printed so
    bool answered = false;              ///< whether the program gave an answer that can be used
    Value given;                        ///< the answer; empty if there is none
    std::optional<double> error;        ///< largest error divided by the vector's scale, if both answers are numbers
    std::size_t worst = 0;              ///< index of the number with the largest error, from 0
};

/// @brief Number of correct digits at a relative error. @param error relative error @return from 0 to 17
[[nodiscard]] double digits(double error);

} // namespace denhartog::conformance
