#include "denhartog/orbit/orbit_search.hpp"

#include <sstream>

namespace denhartog {

std::string in_words(const SearchWithoutOrbit& seen) {
    std::ostringstream s;
    s.precision(3);
    if (seen.restless) s << "rounding keeps the motion from settling: ";
    if (!seen.ended.empty()) s << seen.ended << ": ";
    s << (seen.chattering ? "phases of zero length follow each other" : "the motion comes to no periodic motion") << " within "
      << seen.periods << " periods";
    if (seen.grows_to > 0)
        s << ". The motion still grows; its size is " << seen.grows_to;
    else if (seen.repeats_after > 0)
        s << ". After " << seen.repeats_after << " half-periods the motion comes nearest to repeating itself: it is "
          << seen.repeats_to << " of its size away";
    if (seen.orbit > 0)
        s << ". A periodic motion of " << seen.orbit << " half-periods exists, which is "
          << (seen.orbit_is_stable ? "stable" : "not certainly stable") << " with a largest multiplier of "
          << seen.largest_multiplier << ", but the motion from the start is " << seen.away
          << " of its size away from it, and it is not known to lead there";
    return s.str();
}

} // namespace denhartog
