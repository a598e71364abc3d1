// At which instant is each mass farthest out while the contact slides? The motion (46) is searched with a bound of its third
// derivative, `rate_of_friction`.
#include "denhartog/sliding/instants_of_maxima.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <limits>
#include <tuple>
#include <utility>

#include "denhartog/number/effort.hpp"
#include "denhartog/sliding/mass_in_motion.hpp"
#include "denhartog/sums/friction_motion.hpp"

namespace denhartog {
namespace {

// A bound of the third derivative of the sum over modes of the friction motions on a stretch of length h. The terms of a mode may
// exceed the sum by far: far above the natural frequencies the sums of the first derivatives all but vanish. Taylor's formula
// with more and more of those sums bounds the rest, each derivative of a mode being smaller by R_i than the one before.
double rate_of_friction(const ModeSums<double>& s, const std::vector<double>& weights, const FrictionMotionsAt& at, double h) {
    constexpr int most_terms = 16;
    const std::size_t N = weights.size();
    struct Term {
        double size;     // bound of a derivative
        double one, two; // the derivatives one and two below it
    };
    boost::container::small_vector<Term, 8> terms(N);
    bool oscillates = true;
    double rest(0);
    for (std::size_t i = 0; i < N; ++i) {
        terms[i] = {size_of_number(weights[i]) * at.size[i] / (s.R[i] * s.R[i] * s.R[i]), weights[i] * at.y[i].double_prime,
                    weights[i] * at.y[i].prime};
        rest += terms[i].size;
        oscillates = oscillates && s.zeta[i] < 1;
    }
    if (!oscillates) return rest; // the sizes are those of this derivative alone
    double known(0), best = rest, power(1);
    for (int n = 1; n <= most_terms; ++n) {
        double sum(0), rounding(0);
        rest = 0.0;
        for (std::size_t i = 0; i < N; ++i) {
            const double& R = s.R[i];
            Term& term = terms[i];
            const double next = -(2 * s.zeta[i] * term.one + term.two / R) / R;
            term.two = term.one;
            term.one = next;
            sum += next;
            rounding += term.size;
            term.size = term.size / R;
            rest += term.size;
        }
        known += power * (size_of_number(sum) + 16 * unit_of<double>() * rounding);
        power = power * h / n;
        const double bound = known + power * rest;
        const bool halved = 2 * bound < best;
        best = std::min(best, bound);
        if (!halved) break;
    }
    return best;
}

std::pair<double, double> instant_and_spread(FrictionMotions& y, double beta, std::size_t k, double error) {
    const ModeSums<double>& s = y.sums();
    const MassInMotion<double> mass(s, k, beta);
    const double harmonic_size = modulus(Complex<double>{mass.h.A, mass.h.B});
    Curve curve;
    curve.question = y.effort();
    if (s.coupled) { // the bounds come from the free motion, which never grows
        const CoupledFriction& friction = *s.coupled;
        curve.rate = [&](double a, double) { return harmonic_size + beta * friction.largest_derivative(k, 3, friction.at(a)); };
        curve.cost = friction.cost();
        curve.share = default_effort(friction.size()) / 4;
        const double noise = 2 * unit_of<double>() * (harmonic_size + beta * friction.compliance(k).most());
        return instant_and_spread(
            curve, [&](double tau) { return motion_with(mass, friction_share(s, k, tau)); }, noise, error);
    }
    const auto at = [&](double tau) {
        const FrictionMotionsAt& now = y.at(tau);
        return mass.at(now.cosine, now.sine, now.y);
    };
    curve.rate = [&](double a, double b) {
        return harmonic_size + beta * rate_of_friction(s, mass.weights, y.at(a, true), b - a);
    };
    // A displacement within its rounding error is no reason to look further.
    const FrictionMotionsAt& start = y.at(0.0, true);
    double terms = harmonic_size;
    for (std::size_t i = 0; i < mass.weights.size(); ++i) terms += beta * size_of_number(mass.weights[i]) * (1 + start.size[i]);
    curve.cost = static_cast<long>(s.R.size() + 2); // two for the search itself
    return instant_and_spread(curve, at, 2 * unit_of<double>() * terms, error);
}

} // namespace

InstantsOfMaxima instants_of_maxima(FrictionMotions& y, double beta, std::optional<Mass> only,
                                    const std::vector<double>& errors) {
    const ModeSums<double>& s = y.sums();
    InstantsOfMaxima all{std::vector<double>(s.V.size(), 0.0), std::vector<double>(s.V.size(), 0.0)};
    for (std::size_t k = 0; k < s.V.size(); ++k) {
        if (k == s.contact.index || (only && k != only->index)) continue;
        const double error = errors.empty() ? 0.0 : errors[k];
        std::tie(all.instants[k], all.spreads[k]) = instant_and_spread(y, beta, k, error);
    }
    return all;
}

} // namespace denhartog
