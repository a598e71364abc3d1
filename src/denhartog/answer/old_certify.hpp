#pragma once
#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "denhartog/sums/bounded_modes.hpp"
namespace denhartog {
template <class T> struct SceneIn { Scene<T> scene; std::shared_ptr<const ModalBasis<Bounded<T>>> basis; };
template <class T> SceneIn<T> scene_with_modes(const SceneSource& source) { Scene<T> scene = scene_in<T>(source); auto basis = modes_with_errors(scene.system); return {std::move(scene), std::move(basis)}; }
/// @brief The precisions in which a question is evaluated, in this order.
enum class Precision : std::uint8_t {
    in_double,     ///< double
    in_50_digits,  ///< 50 decimal digits
    in_100_digits, ///< 100 decimal digits
};

/// @brief Its name. @param precision the precision @return `double`, `50 digits` or `100 digits`


/// @brief The most digits that are tried for in it. @param precision the precision @return the digits


/// @brief The last precision of a question. Where no digits are asked for, 50 digits are the last of more than 40 masses, and
/// double of more than 200.
/// @param aim    the digits
/// @param masses N
/// @param last   the last precision that there is
/// @return       the precision


inline std::string name(Precision p) { return p == Precision::in_double ? "double" : p == Precision::in_50_digits ? "50 digits" : "100 digits"; }
inline int most_digits_in(Precision p) { return p == Precision::in_double ? 14 : p == Precision::in_50_digits ? 45 : 95; }
inline Precision highest_precision(const Aim& aim, std::size_t masses, Precision last) {
    if (aim.asked_for || masses <= 40) return last;
    return masses <= 200 ? std::min(last, Precision::in_50_digits) : Precision::in_double;
}
/// @brief The attempt that answers.
struct Certainty {
    Precision precision = Precision::in_double; ///< its precision
    bool settled = false;                       ///< whether its bounds leave the digits
    double relative = 0;                        ///< what it came to
    std::string why;                            ///< what the precisions before left open, and its own verdict
};

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


}
