/// @file
/// @brief The digits of an answer in double, whose numbers carry bounds of their errors; and the motion as it is seen from the
/// ground, where base and wall, or the wall alone, move by \f$ b\cos\tau \f$: absolute displacements are the relative ones and
/// that.
#pragma once

#include <cmath>
#include <limits>

#include "denhartog/answer/solution.hpp"
#include "denhartog/formulas/complex.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/number/why.hpp"

namespace denhartog {

/// @brief Digits that a question aims at.
struct Aim {
    int digits;       ///< asked for, or aimed at where none are
    bool asked_for;   ///< which of the two
    double tolerance; ///< ten to the minus that
};

/// @brief The aim of a number of digits, by default of `digits_by_default`; InputError where they are not from 1 to
/// `most_digits`.
[[nodiscard]] Aim aim_of(std::optional<int> digits);
[[nodiscard]] double tolerance_of(int digits); ///< the relative error that leaves so many digits: ten to the minus that
[[nodiscard]] int digits_of(double error);     ///< the number of digits that a relative error leaves, from 0 to 17

/// @brief An error as a double, infinite where it is no number.
template <class T>
[[nodiscard]] double as_error(const T& error) {
    return error >= 0 ? static_cast<double>(error) : std::numeric_limits<double>::infinity();
}

/// @brief The error of a number beside its size; 1 of a zero that is not exact.
template <class T>
[[nodiscard]] double relative_error(const Bounded<T>& a) {
    return a.e == 0 ? 0 : a.x == 0 ? 1 : as_error(T(a.e / size_of_number(a.x)));
}

/// @brief The most digits that double is asked for.
inline constexpr int most_digits_in_double = 14;

/// @brief The result of double, as far as digits need it.
struct Attempted {
    double relative;              ///< largest error of what must have the digits, relative as they count
    bool decided = true;          ///< whether its regime is certain
    Why doubt = Why::on_boundary; ///< why it is not
};

/// @brief Counts a question for which double did not have the digits, for `precision_steps`.
void count_precision_step();

/// @brief The reasons that an attempt gives.
[[nodiscard]] Reasons verdict(const Attempted& attempted, const Aim& aim);

/// @brief True of a mass that does not move, as far as numbers tell: its amplitude is no larger than its error, and that is next
/// to nothing of the largest amplitude.
[[nodiscard]] inline bool does_not_move(double amplitude, double error, double largest) {
    constexpr double units = 1024;
    return amplitude <= error && error <= largest * units * unit_of<double>();
}

/// @brief Brings the lists over masses into the form in which answers have them. If one mass was asked about, only that one is
/// left. Otherwise the last entry of a contact that does not move as one mass goes to `between`. `from_ground` is left only if
/// the motion of all masses was asked for; if the base moves alone, it is a copy, as the displacements are absolute already.
void finish_lists(const System<double>& system, const Question& question, Solution& s);

[[nodiscard]] inline Certified certified(const Bounded<double>& a) { return {a.x, a.e, {}}; } ///< a number with its bound
[[nodiscard]] inline Certified exactly(double x) { return {x, 0, {}}; }                       ///< a number that is exact

/// @brief By how much an error may turn the phase of a motion: the arc sine of its share in the amplitude, in radians. The
/// amplitude is larger than the error, and may have any size.
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

/// @brief b in units of P / k_1: \f$ 1/r^2 \f$ of base and wall with \f$ P = m_1\omega^2X \f$, 1 of one of them with
/// \f$ P = k_1X \f$; none where neither moves.
template <class T>
[[nodiscard]] std::optional<T> amplitude_of_base(BaseMotion motion, const T& r) {
    if (motion == BaseMotion::none) return std::nullopt;
    return motion == BaseMotion::with_wall ? T(T(1) / (r * r)) : T(1);
}

/// @brief The amplitude of the frame of the displacements, b; none where they are absolute.
template <class T>
[[nodiscard]] std::optional<T> amplitude_of_frame(BaseMotion motion, const T& r) {
    return motion == BaseMotion::alone ? std::nullopt : amplitude_of_base(motion, r);
}

/// @brief A mass in its absolute motion, whose amplitude and phase have the bounds of the relative one's.
[[nodiscard]] inline MassFromGround from_ground(const SolvedMass& absolute, const Bounded<double>& base) {
    const Bounded<double> X(absolute.amplitude.value, absolute.amplitude.error);
    return {absolute.amplitude, certified(X / base), absolute.phase};
}

/// @brief (33) of an absolute displacement: a harmonic motion of the frame adds to it. A wall that moves alone acts by friction
/// alone: without friction no mass moves, and \f$ V_{dk} = -b \f$ in its frame.
template <class T>
[[nodiscard]] Complex<T> response_from_ground(const Complex<T>& V_dk, BaseMotion motion, const T& b) {
    return motion == BaseMotion::wall ? Complex<T>{T(0), T(0)} : Complex<T>{V_dk.re + b, V_dk.im};
}

} // namespace denhartog
