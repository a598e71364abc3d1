// Is the steady motion of an answer the only one, and how much does it vary where a mode keeps any share? Read
// `say_whether_unique`.
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

using Number = Bounded<double>;

// True of a number that may be an even integer.
bool may_be_even(const Number& n) {
    const double nearest = 2 * std::round(n.x / 2);
    return std::abs(n.x - nearest) <= n.e;
}

// The modes that nothing but friction damps.
struct FreeModes {
    bool settle = true;                // friction damps them all
    std::optional<std::size_t> kept{}; // the only one that keeps its share: it has an even number of periods in one of the force
};

constexpr double most_periods = 1000; // of a mode in one of the force, beyond which it is not told how large its share may be

FreeModes free_modes(const ModalBasis<Number>& basis, Mass contact, const Number& r) {
    FreeModes found;
    std::vector<Number> periods; // of the modes without damping, in a period of the force
    bool others_settle = true;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        if (basis.zeta[i].x > basis.zeta[i].e) continue;
        const Number& shape = basis.phi(static_cast<Eigen::Index>(contact.index), static_cast<Eigen::Index>(i));
        const Number n = basis.r_n[i] / r;
        if (may_be_even(n) && n.x <= most_periods && !found.kept && std::abs(shape.x) > shape.e)
            found.kept = i;
        else if (may_be_even(n) || may_be_even(n + Number(1)) || !(std::abs(shape.x) > shape.e))
            others_settle = false;
        for (const Number& other : periods)
            if (may_be_even(n - other) || may_be_even(n + other)) others_settle = false;
        periods.push_back(n);
    }
    found.settle = others_settle && !found.kept;
    if (!others_settle) found.kept.reset();
    return found;
}

// Says that mode i may keep any share of the sliding motion, and how far the contact then moves at most: until its velocity over
// the half-period would change its sign.
void say_what_is_kept(std::size_t i, const System<double>& system, Solution& s) {
    const auto basis = modes_with_errors(system);
    const ModeSums<double> sums = values_of(bounded_sums(system, *basis, as_input(s.r.value)));
    const std::size_t j = sums.contact.index;
    const MassInMotion<double> contact(sums, j, s.beta->value);
    const auto at = [&](double tau) { return motion_with(contact, friction_share(sums, j, tau)); };
    const double n = std::round(basis->r_n[i].x / s.r.value);
    const auto share = [&](double tau) { // as a displacement of the contact
        const double rate = std::abs(n * elementary::sin(n * tau));
        return rate > 0 ? std::abs(at(tau).x_prime) / rate : std::numeric_limits<double>::max();
    };
    double least = std::min(std::abs(at(0).x_double_prime), std::abs(at(pi<double>()).x_double_prime)) / (n * n); // at both ends
    constexpr int looks = 16, bits = 26; // in each half-turn of the mode; half the bits of a double for the instant
    const int pieces = looks * static_cast<int>(n);
    const double step = pi<double>() / pieces;
    std::vector<double> shares;
    for (int k = 0; k < pieces; ++k) shares.push_back(share(k * step));
    for (std::size_t k = 1; k + 1 < shares.size(); ++k) {
        if (shares[k] > std::min(shares[k - 1], shares[k + 1])) continue;
        const double middle = static_cast<double>(k) * step;
        least = std::min(least, boost::math::tools::brent_find_minima(share, middle - step, middle + step, bits).second);
    }
    constexpr double trusted = 1e-10; // relative error of the search, an estimate
    const double most = at(0).x + least;
    s.kept_mode = KeptMode{i, {most, trusted * most, {}}};
    s.not_from_rest = {Why::any_share, i + 1, n, most};
}

} // namespace

void say_whether_unique(const ModalBasis<Number>& basis, Mass contact, const System<double>& system, double mu, Solution& s) {
    const double beta = s.beta->value;
    if (beta == 0) mu = 1; // without friction static friction is none either
    s.unique = mu == 1 && every_motion_is_damped(basis);
    const bool slides = s.regime.regime == Regime::continuous && !s.regime.on_boundary && s.not_from_rest.empty();
    const bool friction_alone = mu == 1 && !s.unique && !basis.coupled() && beta > 0;
    const bool stops = !s.stops.empty() || s.rest_interval;
    if (s.unique) {
        s.unique_because = {Why::unique, basis.coupled()};
        return;
    }
    if (friction_alone && (slides || (stops && basis.r_n.size() == 1))) {
        const FreeModes free = slides ? free_modes(basis, contact, as_input(s.r.value)) : FreeModes{};
        s.unique = free.settle;
        if (free.settle) {
            s.not_from_rest.clear(); // every start leads there
            s.unique_because = {Why::unique, 2};
        }
        if (free.kept) {
            say_what_is_kept(*free.kept, system, s);
            s.unique_because = Why::share_kept;
        }
        if (free.settle || free.kept) return;
    }
    const bool held = s.regime.regime == Regime::permanent_sticking,
               open = mu == 1 && !s.start && s.regime.regime != Regime::stick_slip;
    if (s.not_from_rest.empty() && (open || (held && basis.r_n.size() > 1 && !every_motion_is_damped(basis))))
        s.not_from_rest = Why::may_last;
    const bool elsewhere = !s.not_from_rest.empty() && (mu > 1 || s.start);
    s.unique_because = {Why::may_depend, elsewhere ? 0 : mu > 1 ? 1 : basis.coupled() ? 2 : 3};
}

} // namespace denhartog
