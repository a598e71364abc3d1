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
template <class T>
T rate_of_friction(const ModeSums<T>& s, const std::vector<T>& weights, const FrictionMotionsAt<T>& at, const T& h) {
    constexpr int most_terms = 16;
    const std::size_t N = weights.size();
    struct Term {
        T size;     // bound of a derivative
        T one, two; // the derivatives one and two below it
    };
    boost::container::small_vector<Term, 8> terms(N);
    bool oscillates = true;
    T rest(0);
    for (std::size_t i = 0; i < N; ++i) {
        terms[i] = {size_of_number(weights[i]) * at.size[i] / (s.R[i] * s.R[i] * s.R[i]), weights[i] * at.y[i].double_prime,
                    weights[i] * at.y[i].prime};
        rest += terms[i].size;
        oscillates = oscillates && s.zeta[i] < 1;
    }
    if (!oscillates) return rest; // the sizes are those of this derivative alone
    T known(0), best = rest, power(1);
    for (int n = 1; n <= most_terms; ++n) {
        T sum(0), rounding(0);
        rest = T(0);
        for (std::size_t i = 0; i < N; ++i) {
            const T& R = s.R[i];
            Term& term = terms[i];
            const T next = -(2 * s.zeta[i] * term.one + term.two / R) / R;
            term.two = term.one;
            term.one = next;
            sum += next;
            rounding += term.size;
            term.size = term.size / R;
            rest += term.size;
        }
        known += power * (size_of_number(sum) + 16 * unit_of<T>() * rounding);
        power = power * h / n;
        const T bound = known + power * rest;
        const bool halved = 2 * bound < best;
        best = std::min(best, bound);
        if (!halved) break;
    }
    return best;
}

template <class T>
std::pair<T, T> instant_and_spread(FrictionMotions<T>& y, const T& beta, std::size_t k, const T& error) {
    const ModeSums<T>& s = y.sums();
    const MassInMotion<T> mass(s, k, beta);
    const T harmonic_size = modulus(Complex<T>{mass.h.A, mass.h.B});
    Curve<T> curve;
    if (s.coupled) { // the bounds come from the free motion, which never grows
        const CoupledFriction<T>& friction = *s.coupled;
        curve.rate = [&](const T& a, const T&) {
            return T(harmonic_size + beta * friction.largest_derivative(k, 3, friction.at(a)));
        };
        curve.cost = friction.cost();
        curve.share = default_effort(friction.size()) / 4;
        const T noise = 2 * unit_of<T>() * (harmonic_size + beta * friction.compliance(k).most());
        return instant_and_spread(
            curve, [&](const T& tau) { return motion_with(mass, friction_share(s, k, tau)); }, noise, error);
    }
    const auto at = [&](const T& tau) {
        const FrictionMotionsAt<T>& now = y.at(tau);
        return mass.at(now.cosine, now.sine, now.y);
    };
    curve.rate = [&](const T& a, const T& b) {
        return T(harmonic_size + beta * rate_of_friction(s, mass.weights, y.at(a, true), T(b - a)));
    };
    // What rounding leaves of the displacement is no reason to look further.
    const FrictionMotionsAt<T>& start = y.at(T(0), true);
    T terms = harmonic_size;
    for (std::size_t i = 0; i < mass.weights.size(); ++i) terms += beta * size_of_number(mass.weights[i]) * (1 + start.size[i]);
    curve.cost = static_cast<long>(s.R.size() + 2); // two for the search itself
    return instant_and_spread(curve, at, T(2 * unit_of<T>() * terms), error);
}

} // namespace

template <class T>
InstantsOfMaxima<T> instants_of_maxima(FrictionMotions<T>& y, const T& beta, std::optional<Mass> only,
                                       const std::vector<T>& errors) {
    const ModeSums<T>& s = y.sums();
    InstantsOfMaxima<T> all{std::vector<T>(s.V.size(), T(0)), std::vector<T>(s.V.size(), T(0))};
    for (std::size_t k = 0; k < s.V.size(); ++k) {
        if (k == s.contact.index || (only && k != only->index)) continue;
        const T error = errors.empty() ? T(0) : errors[k];
        std::tie(all.instants[k], all.spreads[k]) = instant_and_spread(y, beta, k, error);
    }
    return all;
}

template InstantsOfMaxima<double> instants_of_maxima(FrictionMotions<double>&, const double&, std::optional<Mass>,
                                                     const std::vector<double>&);

} // namespace denhartog
