// The braces of (40) of all modes at an instant, kept for the next question at that instant, and bounds of their sizes. Read
// `FrictionMotions::at`, then `evaluated`.
#include "denhartog/sliding/friction_motion.hpp"

#include <algorithm>

namespace denhartog {
namespace {

constexpr std::size_t most_remembered = std::size_t(1) << 22; // modes times instants

} // namespace

FrictionMotions::FrictionMotions(const ModeSums<double>& sums, Effort* effort)
    : sums_(sums), effort_(effort), first(0), last(sums.R.size()) {
    c.reserve(last);
    for (std::size_t i = first; i < last; ++i) { // |c_i|; the bound of an overdamped mode does not come from amplitudes
        const double cosine = 1 + sums.g[i], sine = (cosine * sums.zeta[i] + sums.u[i] * sums.R[i]) / sums.w[i];
        c.push_back(sums.zeta[i] >= 1 ? 0.0 : modulus(Complex<double>{cosine, sine}));
    }
}

FrictionMotions::FrictionMotions(const FrictionMotions& all_, std::size_t mode)
    : sums_(all_.sums_), effort_(all_.effort_), all(&all_), first(mode), last(mode + 1), c{all_.c[mode]} {}

FrictionMotionsAt FrictionMotions::evaluated(double tau) {
    FrictionMotionsAt at{0.0, 0.0, std::pmr::vector<evaluation::FrictionMotion<double>>(&memory),
                         std::pmr::vector<double>(&memory)};
    if (all != nullptr) {
        if (const auto seen = all->known.find(tau); seen != all->known.end()) {
            at.cosine = seen->second.cosine;
            at.sine = seen->second.sine;
            at.y.push_back(seen->second.y[first]);
            return at;
        }
    }
    const SineCosine<double> turned = sine_cosine(tau);
    at.cosine = turned.c;
    at.sine = turned.s;
    at.y.reserve(last - first);
    for (std::size_t i = first; i < last; ++i)
        at.y.push_back(evaluation::friction_motion(tau, sums_.R[i], sums_.zeta[i], sums_.w[i], sums_.u[i], sums_.g[i]));
    return at;
}

double FrictionMotions::size_of(const evaluation::FrictionMotion<double>& y, std::size_t i, double tau) const {
    const double &R = sums_.R[i], &zeta = sums_.zeta[i];
    if (zeta < 1) return c[i - first] * exp(-zeta * tau / R);
    const double y_1 = R * y.prime, y_2 = R * R * y.double_prime;
    const double y_3 = -(2 * zeta * y_2 + y_1), y_4 = -(2 * zeta * y_3 + y_2);
    return std::max(modulus(Complex<double>{y_2, y_3}), modulus(Complex<double>{y_3, y_4}));
}

const FrictionMotionsAt& FrictionMotions::at(double tau, bool sizes) {
    auto place = known.lower_bound(tau);
    if (place == known.end() || place->first != tau) {
        if (remembered() >= most_remembered) {
            known.clear();
            memory.release();
            place = known.end();
        }
        place = known.emplace_hint(place, tau, evaluated(tau));
    }
    FrictionMotionsAt& now = place->second;
    if (!sizes || !now.size.empty()) return now;
    now.size.reserve(last - first);
    for (std::size_t i = first; i < last; ++i) now.size.push_back(size_of(now.y[i - first], i, tau));
    return now;
}

} // namespace denhartog
