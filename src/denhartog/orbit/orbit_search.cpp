#include "denhartog/orbit/orbit_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"

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

void check_search(const OrbitSearch& search, const State& start, std::size_t N) {
    if (search.periods_before < 0)
        throw InputError("periods_before", "must not be negative", std::to_string(search.periods_before));
    for (const auto& [name, value] :
         {std::pair("most_periods", search.most_periods), std::pair("most_subharmonic", search.most_subharmonic)})
        if (value < 1) throw InputError(name, "must be at least 1", std::to_string(value));
    if (!(search.tolerance >= 0)) throw InputError("tolerance", "must be zero or positive", number_to_text(search.tolerance));
    if (start.x.size() != N || start.x_prime.size() != N)
        throw InputError("start", "must have a displacement and a velocity for each mass", std::to_string(start.x.size()));
    for (const std::vector<double>* part : {&start.x, &start.x_prime})
        for (const double each : *part)
            if (!std::isfinite(each)) throw InputError("start", "must be finite", "");
}

int periods_to_follow(const ExactSolver& solver, int most) {
    const ModalBasis<double>& basis = solver.system().basis;
    if (basis.coupled()) return most; // a motion may decay more slowly than the diagonal of the damping tells
    double slowest = std::numeric_limits<double>::infinity(); // decay rate, a period of the force
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const double zeta = basis.zeta[i];
        const double rate = zeta < 1 ? zeta : 1 / (zeta + sqrt((zeta - 1) * (zeta + 1)));
        slowest = std::min(slowest, 2 * pi<double>() * rate * basis.r_n[i] / solver.excitation().r);
    }
    if (!(slowest > 0)) return most; // 30 over a damping ratio of -0 is no number of periods
    const double periods = 500 + 30 / slowest;
    return periods < most ? static_cast<int>(periods) : most;
}

} // namespace denhartog
