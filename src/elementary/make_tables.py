"""Writes the tables of the elementary functions, each entry rounded from 1400 bits.

The build runs it. Usage: make_tables.py FOLDER, which gets angle_tables.hpp, circle_tables.hpp, logarithm_tables.hpp,
power_tables.hpp and series_tables.hpp.
Whole numbers alone are used: a number x stands for x / 2^BITS.
"""
import sys
from fractions import Fraction
from math import factorial, isqrt
from pathlib import Path

BITS = 1400
ONE = 1 << BITS


def times(a, b):
    return a * b >> BITS


def series(first, ratio):
    """Sum of terms, the next one being ratio(n, term) of the one before."""
    total, term, n = 0, first, 0
    while term:
        total += term
        n += 1
        term = ratio(n, term)
    return total


def arc_tangent(p, q):
    """atan(p / q), the argument halved until the series is short."""
    x, halvings = (p << BITS) // q, 0
    while x > ONE >> 8:
        x = (x << BITS) // (ONE + square_root(ONE + times(x, x)))
        halvings += 1
    square, power, total, n = times(x, x), x, 0, 1
    while power:
        total += power // n if n % 4 == 1 else -(power // n)
        power = times(power, square)
        n += 2
    return total << halvings


def square_root(x):
    return isqrt(x << BITS)


def logarithm(p, q):
    """log(p / q) = 2 artanh((p - q) / (p + q))."""
    x = ((p - q) << BITS) // (p + q)
    square, power, total, n = times(x, x), x, 0, 1
    while power not in (0, -1):
        total += power // n
        power = times(power, square)
        n += 2
    return 2 * total


PI = 4 * (4 * arc_tangent(1, 5) - arc_tangent(1, 239))
LN_2 = logarithm(2, 1)


def sine(x):
    square = times(x, x)
    return series(x, lambda n, term: -times(term, square) // (2 * n * (2 * n + 1)))


def exponential(x):
    return series(ONE, lambda n, term: times(term, x) // n)


def rounded(x):
    """The double nearest to x / 2^BITS."""
    return float(Fraction(x, ONE))


def exactly(value):
    return int(Fraction(value) * ONE)


def cut(x, bits):
    """The leading bits of x."""
    drop = abs(x).bit_length() - bits
    return (x >> drop) << drop if x > 0 else -((-x >> drop) << drop)


def in_doubles(x, *bits):
    """x as a sum of doubles: the first of so many bits, the last rounded."""
    parts = []
    for count in bits:
        part = cut(x, count) if x else 0
        parts.append(rounded(part))
        x -= part
    return [*parts, rounded(x)]


def pair(x):
    head = rounded(x)
    return head, rounded(x - exactly(head))


def text(value):
    return "0x0p+0" if value == 0 else value.hex().replace(".0000000000000p", "p")


def row(values):
    return "    {" + ", ".join(text(value) for value in values) + "},"


def sine_of_step(n):
    """sin(n pi / 64), by symmetry exact at 0, 1 and -1."""
    n %= 128
    if n >= 64:
        return -sine_of_step(n - 64)
    if n > 32:
        n = 64 - n
    return ONE if n == 32 else sine(PI * n // 64)


def circle():
    for n in range(128):
        head, tail = pair(sine_of_step(n))
        cosine = sine_of_step(n + 32)
        whole = (2 * cosine + ONE) // (2 * ONE)
        yield row([head, tail, float(whole), rounded(cosine - whole * ONE)])


def powers():
    for n in range(256):
        value = exponential(LN_2 * n // 256)
        head = rounded(value)
        yield row([head, rounded(((value - exactly(head)) << BITS) // exactly(head))])


def expansion(value, slopes):
    """A function at a point and its powers of the distance, from the Taylor coefficients of its slope."""
    coefficients = [rounded(slope // (n + 1)) for n, slope in enumerate(slopes)]
    columns = [*pair(value), rounded(slopes[0] - ONE), *coefficients[1:]]
    return ["    {" + ", ".join(text(value) for value in columns[:5]) + ",",
            "     " + ", ".join(text(value) for value in columns[5:]) + "},"]


def arc_tangents():
    """The slope is 1 / (1 + x^2)."""
    for n in range(65):
        c = ONE * n // 64
        slopes, square = [0], ONE + times(c, c)
        for k in range(8):
            right = ONE if k == 0 else -2 * times(c, slopes[-1]) - slopes[-2]
            slopes.append((right << BITS) // square)
        yield from expansion(arc_tangent(n, 64) if n else 0, slopes[1:])


def logarithms():
    """1 / m to nine bits and the logarithm of its inverse, for m in the middle of each 256th of [1, 2), from the 106th on of half of it."""
    for n in range(256):
        inverse = 512 if n == 0 else 256 if n == 255 else round(Fraction(512 * 512, 513 + 2 * n))
        value = logarithm(512, inverse) - (LN_2 if n >= 106 else 0)
        head = cut(value, max(1, abs(value).bit_length() - (BITS - 42))) if value else 0
        yield row([inverse / (256 if n >= 106 else 512), rounded(head), rounded(value - head)])


def words_of_two_over_pi():
    """The bits of 2 / pi, two words of zeros before them."""
    value = (2 << 2 * BITS) // PI
    for n in range(-2, 20):
        word = value >> (BITS - 64 * (n + 1)) & (1 << 64) - 1 if n >= 0 else 0
        yield f"    0x{word:016x}U,"


def inverse_factorials():
    for n in range(28):
        yield f"    {text(float(Fraction(1, factorial(n))))},"


def constant(name, value, comment):
    return f"inline constexpr double {name} = {text(value)}; ///< {comment}"


def table(comment, type_, name, count, rows):
    return ["", f"/// @brief {comment}", f"inline constexpr {type_} {name}[{count}] = {{", *rows, "};"]


def write(name, brief, lines):
    text_of_file = ["/// @file", f"/// @brief {brief}, written by make_tables.py.", "#pragma once", "", "#include <cstdint>", "",
                    "namespace denhartog::elementary {", "", *lines, "", "} // namespace denhartog::elementary", ""]
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text("\n".join(text_of_file))


def write_circle():
    step = PI // 64
    first, second, third, fourth = in_doubles(step, 24, 24, 53)
    write("circle_tables.hpp", "Sines and the bits of 2 / pi", [
        constant("pi_high", pair(PI)[0], "pi, rounded"),
        constant("pi_low", pair(PI)[1], "what its rounding lacks"),
        constant("steps_in_radian", rounded((ONE << BITS) // step), "64 / pi"),
        constant("step_high", pair(step)[0], "pi / 64, rounded"),
        constant("step_low", pair(step)[1], "what its rounding lacks"),
        constant("step_first", first, "the first 24 bits of pi / 64"),
        constant("step_second", second, "the next 24"),
        constant("step_third", third, "the next 53"),
        constant("step_fourth", fourth, "the rest"),
        "",
        "/// @brief A point of the circle.",
        "struct Direction {",
        "    double sine;              ///< rounded",
        "    double rest;              ///< what the rounding of the sine lacks",
        "    double whole;             ///< the whole number nearest to the cosine",
        "    double cosine_less_whole; ///< the cosine less that",
        "};",
        *table("The points at n pi / 64.", "Direction", "circle", 128, circle()),
        "",
        *table("The bits of 2 / pi, 64 a word, behind two words of zeros.", "std::uint64_t", "two_over_pi", 22,
               words_of_two_over_pi()),
    ])


def write_angles():
    write("angle_tables.hpp", "Arc tangents", [
        "/// @brief A function next to a point, in powers of the distance from it.",
        "struct Expansion {",
        "    double high;           ///< the value at the point, rounded",
        "    double low;            ///< what its rounding lacks",
        "    double slope_less_one; ///< the derivative less one",
        "    double second;         ///< the coefficient of the second power",
        "    double third;          ///< of the third",
        "    double fourth;         ///< of the fourth",
        "    double fifth;          ///< of the fifth",
        "    double sixth;          ///< of the sixth",
        "    double seventh;        ///< of the seventh",
        "    double eighth;         ///< of the eighth",
        "};",
        *table("atan next to n / 64.", "Expansion", "arc_tangents", 65, arc_tangents()),
    ])


def write_powers():
    ln_high, ln_low = in_doubles(LN_2 // 256, 32)
    cubic = Fraction(1, 6) + Fraction(87, 100) * Fraction(LN_2, 512 * ONE) ** 2 / 120
    write("power_tables.hpp", "Powers of two", [
        constant("parts_in_one", rounded((ONE << BITS) // (LN_2 // 256)), "256 / ln 2"),
        constant("part_high", ln_high, "the first 32 bits of ln 2 / 256"),
        constant("part_low", ln_low, "the rest"),
        constant("cubic", float(cubic), "1 / 6, and of 1 / 120 r^2 the part that serves all r up to ln 2 / 512 best"),
        "",
        "/// @brief A power of two.",
        "struct Power {",
        "    double value;    ///< rounded",
        "    double relative; ///< what its rounding lacks, as a part of it",
        "};",
        *table("2^(n / 256).", "Power", "powers", 256, powers()),
    ])


def write_logarithms():
    whole_high, whole_low = in_doubles(LN_2, 42)
    log10_e = (ONE << BITS) // logarithm(10, 1)
    write("logarithm_tables.hpp", "Logarithms", [
        constant("ln_2_high", whole_high, "the first 42 bits of ln 2"),
        constant("ln_2_low", whole_low, "the rest"),
        constant("log10_e_high", pair(log10_e)[0], "1 / ln 10, rounded"),
        constant("log10_e_low", pair(log10_e)[1], "what its rounding lacks"),
        "",
        "/// @brief A number that is nearly 1 / m, and its logarithm.",
        "struct Logarithm {",
        "    double inverse; ///< nine bits",
        "    double high;    ///< minus its logarithm, as a multiple of 2^-42",
        "    double low;     ///< the rest",
        "};",
        *table("For m from 1 + n / 256 to the next, from n = 106 on for half of it.", "Logarithm", "logarithms", 256, logarithms()),
    ])


def write_series():
    write("series_tables.hpp", "Coefficients of series", [
        *table("1 / n!.", "double", "inverse_factorials", 28, inverse_factorials()),
    ])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    for each in (write_angles, write_circle, write_powers, write_logarithms, write_series):
        each()
