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
struct FunctionWithZeros {
    std::function<ZerosInStretch(double from, double to)> look; ///< over a stretch
    std::function<bool(double x)> has_sign;                     ///< whether it is certainly not zero at x, and no pole
};

/// @brief A stretch of an interval.
struct StretchOfZeros {
    double from; ///< its lower end
    double to;   ///< its upper end
};

/// @brief What a search found, ascending.
struct ZerosOnStretches {
    std::vector<StretchOfZeros> single;    ///< stretches with one zero each
    std::vector<StretchOfZeros> undecided; ///< stretches of which nothing is known; outside of all of these there is no zero
};

/// @brief The zeros of a function: an interval is divided until it is known of each part that it has none or one. The lower end
/// is not negative. A stretch is not divided further once it is as narrow as `narrow`, as a part of its upper end. `found` gets
/// the stretches behind those that it has.
inline void find_zeros(const FunctionWithZeros& f, double a, double b, double narrow, ZerosOnStretches& found) {
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
        double at = a + (b - a) / 2; // a zero at the end of a part would be seen by neither
        for (const int sixteenths : {8, 7, 9, 6, 10}) {
            const double x = a + (b - a) * sixteenths / 16;
            if (!f.has_sign(x)) continue;
            at = x;
            break;
        }
        find_zeros(f, a, at, narrow, found);
        find_zeros(f, at, b, narrow, found);
    }
}

} // namespace denhartog
