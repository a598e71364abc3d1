/// @file
/// @brief All zeros of a function on an interval. Nothing here knows of modes, masses or friction.
#pragma once

#include <functional>
#include <vector>

namespace denhartog {

/// @brief What a function says of its zeros in a stretch.
enum class ZerosInStretch : unsigned char {
    unknown, ///< nothing is certain: the stretch is divided
    none,    ///< it has none
    one,     ///< it has one, which lies inside
    hidden   ///< nothing is certain, and will not be in its parts
};

/// @brief A function on an interval, as a search for its zeros sees it.
template <class T>
struct FunctionWithZeros {
    std::function<ZerosInStretch(const T& from, const T& to)> look; ///< over a stretch
    std::function<bool(const T& x)> has_sign;                       ///< whether it is certainly not zero at x, and no pole
};

/// @brief A stretch of an interval.
template <class T>
struct StretchOfZeros {
    T from; ///< its lower end
    T to;   ///< its upper end
};

/// @brief What a search found, ascending.
template <class T>
struct ZerosOnStretches {
    std::vector<StretchOfZeros<T>> single;    ///< stretches with one zero each
    std::vector<StretchOfZeros<T>> undecided; ///< stretches of which nothing is known; outside of all of these there is no zero
};

/// @brief The zeros of a function: an interval is divided until it is known of each part that it has none or one.
/// @param f       the function
/// @param a       lower end, positive
/// @param b       upper end
/// @param narrow  a stretch is not divided further once it is as narrow, as a part of its upper end
/// @param found   gets the stretches behind those that it has
template <class T>
void find_zeros(const FunctionWithZeros<T>& f, const T& a, const T& b, const T& narrow, ZerosOnStretches<T>& found) {
    const ZerosInStretch seen = f.look(a, b);
    if (seen == ZerosInStretch::none) return;
    if (seen == ZerosInStretch::one) {
        found.single.push_back({a, b});
    } else if (seen == ZerosInStretch::hidden || b - a <= narrow * b) {
        if (!found.undecided.empty() && found.undecided.back().to >= a)
            found.undecided.back().to = b;
        else
            found.undecided.push_back({a, b});
    } else {
        T at = a + (b - a) / 2; // a zero at the end of a part would be seen by neither
        for (const int sixteenths : {8, 7, 9, 6, 10}) {
            const T x = a + (b - a) * sixteenths / 16;
            if (!f.has_sign(x)) continue;
            at = x;
            break;
        }
        find_zeros(f, a, at, narrow, found);
        find_zeros(f, at, b, narrow, found);
    }
}

} // namespace denhartog
