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
    pass_loose,   ///< right to fewer digits, as good as a careful user needs
    inaccurate,   ///< right in kind, too few digits
    as_printed,   ///< wrong, and the value of an equation as the paper prints it
    wrong,        ///< wrong
    wrong_regime, ///< the answer of another regime
    rejected,     ///< rejected, and the question had to be
    not_rejected, ///< answered, and the question had to be rejected
    skipped,      ///< not answered; no fault by itself
    crash,        ///< the program ended, closed its output or wrote without an end
    timeout,      ///< no answer in time, the program was computing
    stall         ///< no answer in time, the program was waiting
};

/// @brief Number of verdicts.
inline constexpr std::size_t number_of_verdicts = 12;

/// @brief A verdict as reports write it. @param verdict the verdict @return e.g. `pass-loose`
[[nodiscard]] std::string_view name(Verdict verdict);

/// @brief A verdict by its name. @param name e.g. `pass-loose` @return the verdict; none where there is none of the name
[[nodiscard]] std::optional<Verdict> verdict_named(std::string_view name);

/// @brief Whether nothing is to be said against an answer. @param verdict its verdict @return `pass`, `pass-loose`, `rejected`
[[nodiscard]] bool is_right(Verdict verdict);

/// @brief Whether an answer was given that is not right to its digits. @param verdict its verdict
/// @return `inaccurate`, `as-printed`, `wrong`, `wrong-regime`
[[nodiscard]] bool is_wrong_value(Verdict verdict);

/// @brief How bad a verdict is, to compare two runs. @param verdict the verdict @return 0 for the best; equals are as bad
[[nodiscard]] int badness(Verdict verdict);

/// @brief A vector with the verdict on the answer to it.
struct Judged {
    const Vector* vector = nullptr;     ///< what was asked
    Verdict verdict = Verdict::skipped; ///< the verdict
    std::string reason;                 ///< why, where there is more to say than the verdict
    std::string equation;               ///< of `as-printed`: the equation whose print it is
    bool answered = false;              ///< whether an answer was given that can be used
    Value given;                        ///< the answer; empty where there is none
    std::optional<double> error;        ///< largest error over the vector's scale, where numbers answer numbers
    std::size_t worst = 0;              ///< the number of the answer that has it, from 0
};

/// @brief Digits that an error leaves. @param error relative error @return at least 0, at most 17
[[nodiscard]] double digits(double error);

} // namespace denhartog::conformance
