/// @file
/// @brief A question is answered in double, in 50 digits or in 100: in the first of them that makes its digits certain.
///
/// Each of them evaluates the same templates on numbers that carry a bound of their error, `Bounded<T>`. No error is measured by
/// computing twice. The first precision whose bounds leave the digits asked for answers.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include "denhartog/answer/solution.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"

namespace denhartog {

/// @brief Digits that a question aims at.
struct Aim {
    int digits;       ///< asked for, or aimed at where none are
    bool asked_for;   ///< which of the two
    double tolerance; ///< ten to the minus that
};

/// @brief What a number of digits aims at. @param digits asked for; none for `digits_by_default` @return the aim
/// @throws InputError where they are not from 1 to `most_digits`
[[nodiscard]] Aim aim_of(std::optional<int> digits);

/// @brief The same in words. @param aim the aim @return e.g. `6 digits aimed at`
[[nodiscard]] std::string in_words(const Aim& aim);

/// @brief The relative error that leaves so many digits. @param digits from 0 to `most_digits` @return ten to the minus digits
[[nodiscard]] double tolerance_of(int digits);

/// @brief How many digits an error leaves. @param error relative @return from 0 to 95
[[nodiscard]] int digits_of(double error);

/// @brief An error as a double. @param error it @return the same; infinite where it is no number
template <class T>
[[nodiscard]] double as_error(const T& error) {
    return error >= 0 ? static_cast<double>(error) : std::numeric_limits<double>::infinity();
}

/// @brief The error of a number beside its size. @param a the number @return its bound over its size; 1 of a zero that is not exact
template <class T>
[[nodiscard]] double relative_error(const Bounded<T>& a) {
    return a.e == 0 ? 0 : a.x == 0 ? 1 : as_error(T(a.e / size_of_number(a.x)));
}

/// @brief The precisions in which a question is evaluated, in this order.
enum class Precision : std::uint8_t {
    in_double,     ///< double
    in_50_digits,  ///< 50 decimal digits
    in_100_digits, ///< 100 decimal digits
};

/// @brief Its name. @param precision the precision @return `double`, `50 digits` or `100 digits`
[[nodiscard]] std::string name(Precision precision);

/// @brief The most digits that are tried for in it. @param precision the precision @return the digits
[[nodiscard]] int most_digits_in(Precision precision);

/// @brief The last precision of a question. Where no digits are asked for, 50 digits are the last of more than 40 masses, and
/// double of more than 200.
/// @param aim    the digits
/// @param masses N
/// @param last   the last precision that there is
/// @return       the precision
[[nodiscard]] Precision highest_precision(const Aim& aim, std::size_t masses, Precision last = Precision::in_100_digits);

/// @brief What an attempt in one precision came to.
struct Attempted {
    double relative;                                    ///< largest error of what must have the digits, relative as they count
    bool decided = true;                                ///< whether its regime is certain
    std::string_view doubt = "beta lies on a boundary"; ///< why it is not
};

/// @brief The attempt that answers.
struct Certainty {
    Precision precision = Precision::in_double; ///< its precision
    bool settled = false;                       ///< whether its bounds leave the digits
    double relative = 0;                        ///< what it came to
    std::string why;                            ///< what the precisions before left open, and its own verdict
};

/// @brief Counts a precision that did not have the digits, for `precision_steps`.
void count_precision_step();

/// @brief What is said of an attempt. @param attempted what it came to @param aim the digits @return a clause
[[nodiscard]] std::string verdict(const Attempted& attempted, const Aim& aim);

/// @brief Tries one precision after the other until one has the digits. The last one answers in any case; where it fails and no
/// digits were asked for, the one before it, if that decided the regime.
/// @param aim      the digits
/// @param attempt  called with `std::type_identity<T>` for T of double, 50 and 100 digits; keeps its own result, and that of the
///                 precision before where it throws
/// @param highest  the last precision
/// @return         the attempt that answers
/// @throws         what the last precision throws
template <class Attempt>
Certainty certify(const Aim& aim, const Attempt& attempt, Precision highest = Precision::in_100_digits) {
    Certainty found;
    bool has_answer = false;
    const auto has_digits = [&]<class T>(std::type_identity<T> type, Precision precision) {
        if (aim.digits > most_digits_in(precision) && precision != highest) return false;
        const auto leave_open = [&](const std::string& words) {
            found.why += "in " + name(precision) + ": " + words + "; ";
            count_precision_step();
            return false;
        };
        try {
            const Attempted attempted = attempt(type);
            has_answer = attempted.decided;
            found.precision = precision;
            found.relative = attempted.relative;
            found.settled = attempted.relative <= aim.tolerance && attempted.decided;
            std::string words = verdict(attempted, aim);
            if (!found.settled && precision != highest) return leave_open(words);
            found.why = found.why.empty() ? std::move(words) : found.why + words;
            return true;
        } catch (const DomainError& e) {
            if (precision == highest) throw;
            return leave_open(e.what());
        } catch (const PrecisionError& e) {
            const bool is_last = precision == highest || QuestionEffort::exhausted();
            if (!is_last) return leave_open(e.what());
            if (!has_answer || aim.asked_for) throw;
            found.why += "in " + name(precision) + ": " + e.what();
            return true;
        }
    };
    (void)(has_digits(std::type_identity<double>{}, Precision::in_double) || highest == Precision::in_double ||
           has_digits(std::type_identity<Real50>{}, Precision::in_50_digits) || highest == Precision::in_50_digits ||
           has_digits(std::type_identity<Real100>{}, Precision::in_100_digits));
    return found;
}

/// @brief Whether a mass does not move, as far as numbers tell: its amplitude is no larger than its error, and that is next to
/// nothing of the largest amplitude. In 50 digits more units are believed to be nothing, and are still far below what can be
/// measured.
/// @param amplitude  its amplitude
/// @param error      a bound of its error
/// @param largest    the largest amplitude of the masses
/// @return           whether it does not move
template <class T>
[[nodiscard]] bool does_not_move(const T& amplitude, const T& error, const T& largest) {
    constexpr double units = std::same_as<T, double> ? 1024 : 0x1p20;
    return amplitude <= error && error <= largest * units * unit_of<T>();
}

/// @brief A number of an answer from one with a bound, the rounding of what is handed out included.
/// @param a       the number
/// @param digits  significant digits asked for: above 15 its decimals are written
/// @return        the number
template <class T>
[[nodiscard]] Certified certified(const Bounded<T>& a, int digits) {
    const Bounded<double> rounded = in_double(a);
    Certified number{rounded.x, rounded.e, {}};
    if constexpr (!std::same_as<T, double>) {
        if (digits > most_digits_of_a_double && a.x - a.x == 0) {
            number.decimal = a.x == 0 ? "0" : a.x.str(digits - 1, std::ios_base::scientific);
            // The decimals are rounded when they are read back, unless they are those of a double.
            const T apart = size_of_number(T(T(number.decimal) - a.x));
            const bool exact = apart == 0 && T(rounded.x) == a.x;
            const T error = a.e + (exact ? T(0) : T(apart + unit_of<T>() * size_of_number(a.x)));
            number.error = static_cast<double>(error) * (1 + 4 * unit_of<double>()); // rounded twice
            if (error > 0) number.error = std::max(number.error, std::numeric_limits<double>::denorm_min());
        }
    }
    return number;
}

/// @brief A number that is exact. @param x the number @param digits significant digits asked for @return the number
template <class T>
[[nodiscard]] Certified exactly(const T& x, int digits) {
    return certified(Bounded<T>(x), digits);
}

/// @brief By how much an error may turn the phase of a motion: the arc sine of its share in the amplitude.
/// @param error      the error
/// @param amplitude  positive, larger than the error; of any size
/// @return           radians
template <class T>
[[nodiscard]] T largest_turn(T error, T amplitude) {
    using std::frexp;
    using std::ldexp;
    using std::sqrt;
    int exponent = 0; // of two: it keeps the squares within the range, and every digit
    amplitude = frexp(amplitude, &exponent);
    error = ldexp(error, -exponent);
    return atan2(error, T(sqrt(T((amplitude - error) * (amplitude + error)))));
}

} // namespace denhartog
