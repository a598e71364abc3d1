#include "denhartog/response/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/errors.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/model/number_text.hpp"
#include "denhartog/multiprecision.hpp"
#include "denhartog/response/chain_sums.hpp"

namespace denhartog {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr double nothing = 1e-280; // bounds below it are of numbers that their formula makes zero
constexpr int most_digits_of_quantities = 15;

template <class T>
T larger(const T& a, const T& b) {
    return a < b ? b : a;
}
Bounded larger(const Bounded& a, const Bounded& b) { return {std::max(a.x, b.x), std::max(a.e, b.e)}; }

// The search compares rounded values: the true maximum exceeds what it found by no more than the error where that lies, which is
// taken to be at most half again of the error where the search ended, and a unit or two.
template <class T>
T found_by_search(const T& S) {
    return S;
}
Bounded found_by_search(const Bounded& S) { return rounded(S.x, 1.5 * S.e, 2); }

struct Largest {
    double relative = 0;
    std::string name;
};

Largest largest_bound(const Quantities<Bounded>& q) {
    Largest largest;
    list<Bounded>(q, [&](const char* name, std::size_t mass, const Bounded& value, const Bounded& size) {
        if (value.e <= nothing) return;
        const double relative = value.e / std::abs(size.x);
        if (relative <= largest.relative) return;
        largest = {relative <= std::numeric_limits<double>::max() ? relative : std::numeric_limits<double>::infinity(),
                   std::string(name) + (mass > 0 ? " of mass " + std::to_string(mass) : "")};
    });
    return largest;
}

template <class T>
Quantities<T> quantities_in(const Scene<T>& scene, double tau) {
    const ModeSums<T> sums = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
    Quantities<T> q = quantities_without_motion(sums, scene.mu, instant_of_largest_demand(sums));
    add_motion(q, sums, *scene.beta, T(tau));
    return q;
}

// A number of 50 digits as a double: with its rounding, and twice what 100 digits say otherwise.
Bounded as_double(const Real50& x, const Real100& wide) {
    const double value = static_cast<double>(x);
    const Real100 error = abs(Real100(value) - wide) + abs(Real100(x) - wide);
    return {value, static_cast<double>(error) * (1 + 4 * unit) + std::numeric_limits<double>::min()};
}

std::vector<Bounded> as_double(const std::vector<Real50>& x, const std::vector<Real100>& wide) {
    std::vector<Bounded> all;
    for (std::size_t k = 0; k < x.size(); ++k) all.push_back(as_double(x[k], wide[k]));
    return all;
}

Quantities<Bounded> as_double(const Quantities<Real50>& q, const Quantities<Real100>& wide) {
    Quantities<Bounded> all;
    for (std::size_t k = 0; k < q.V.size(); ++k)
        all.V.push_back({as_double(q.V[k].re, wide.V[k].re), as_double(q.V[k].im, wide.V[k].im)});
    all.U = as_double(q.U, wide.U);
    all.G = as_double(q.G, wide.G);
    all.H_j = as_double(q.H_j, wide.H_j);
    all.S = as_double(q.S, wide.S);
    all.beta_lim = as_double(q.beta_lim, wide.beta_lim);
    all.instant = as_double(q.instant, wide.instant);
    if (q.X_j.has_value() != wide.X_j.has_value())
        throw PrecisionError("50 and 100 digits differ in whether the contact slides: beta is beta_lim to the digits of both");
    if (!q.X_j) return all;
    all.X_j = as_double(*q.X_j, *wide.X_j);
    all.phi_j = as_double(*q.phi_j, *wide.phi_j);
    all.x = as_double(q.x, wide.x);
    all.x_size = as_double(q.x_size, wide.x_size);
    return all;
}

bool regime_is_open(const Quantities<Bounded>& q, double beta, Inputs inputs) {
    return std::abs(q.beta_lim.x - beta) <= q.beta_lim.e + as_input(beta, inputs).e;
}

} // namespace

template <class T>
void list(const Quantities<T>& q, const QuantityReader<T>& read) {
    for (std::size_t k = 0; k < q.V.size(); ++k) {
        const T size = modulus(q.V[k]);
        read("Re V", k + 1, q.V[k].re, size);
        read("Im V", k + 1, q.V[k].im, size);
        read("U", k + 1, q.U[k], q.U[k]);
        read("G", k + 1, q.G[k], q.G[k]);
    }
    read("H", 0, q.H_j, q.H_j);
    read("S", 0, q.S, q.S);
    read("beta_lim", 0, q.beta_lim, q.beta_lim);
    if (!q.X_j) return;
    read("X_j", 0, *q.X_j, *q.X_j);
    read("phi_j", 0, *q.phi_j, T(1));
    for (std::size_t k = 0; k < q.x.size(); ++k) read("x", k + 1, q.x[k], q.x_size[k]);
}

template <class T>
Quantities<T> quantities_without_motion(const ModeSums<T>& s, const T& mu, const T& instant) {
    const std::size_t j = s.contact.index;
    Quantities<T> q;
    q.V = s.V;
    q.U = s.U;
    q.G = s.G;
    q.H_j = s.H_j;
    q.instant = instant;
    q.S = found_by_search(sliding_demand(s, instant));
    q.beta_lim =
        paper::friction_ratio_limit(s.V[j], s.U[j], larger(q.S, paper::static_friction_demand(s.H_j, mu, s.sum_of_squares)));
    return q;
}

template <class T>
void add_motion(Quantities<T>& q, const ModeSums<T>& s, const T& beta, const T& tau) {
    if (!(beta < q.beta_lim)) return;
    const SteadyState<T> state = steady_state_without_maxima(s, beta);
    q.X_j = state.X_j;
    q.phi_j = state.phi_j;
    q.x = motion(s, state, tau).x;
    for (const MassResponse<T>& m : state.masses) q.x_size.push_back(m.amplitude_monoharmonic);
}

Quantities<Bounded> bounded_quantities(const Scene<double>& scene, BoundedModes& modes, double tau, Inputs inputs) {
    const ModeSums<Bounded> sums = bounded_sums(scene.system, modes, inputs);
    Quantities<Bounded> q =
        quantities_without_motion(sums, as_input(scene.mu, inputs), Bounded(instant_of_largest_demand(values_of(sums))));
    add_motion(q, sums, as_input(*scene.beta, inputs), as_input(tau, inputs));
    return q;
}

QuantitiesAnswer quantities(const SceneSource& source, double tau, int digits) {
    if (digits < 1 || digits > most_digits_of_quantities)
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits_of_quantities), std::to_string(digits));
    const Scene<double> scene = source.in_double();
    check(scene);
    if (!scene.r) throw InputError("r", "must be given", "nothing");
    if (!scene.beta) throw InputError("beta", "must be given", "nothing");
    if (scene.system.damping_ratios.empty()) throw InputError("damping_ratios", "must be given", "nothing");
    if (!std::isfinite(tau)) throw InputError("tau", "must be finite", number_to_text(tau));
    const double tolerance = std::pow(10.0, -digits);
    std::string before;
    for (const bool sharp : {false, true}) {
        const std::string with = sharp ? "double with the modes of long double" : "double";
        try {
            BoundedModes modes(sharp ? sharp_basis(scene.system, Inputs::rounded)
                                     : with_errors(scene.system, modal_basis(scene.system)),
                               as_input(*scene.r));
            const Quantities<Bounded> q = bounded_quantities(scene, modes, tau, Inputs::rounded);
            const Largest largest = largest_bound(q);
            const bool open = regime_is_open(q, *scene.beta, Inputs::rounded);
            if (largest.relative <= tolerance && !open)
                return {q, {"closed form", with, before + "the bounds known beforehand have the digits"}, largest.relative};
            before += "in " + with + ": " +
                      (open ? "beta is beta_lim within its bound" : "the bound of " + largest.name + " is too large") + "; ";
        } catch (const DomainError& e) {
            before += "in " + with + ": " + e.what() + "; ";
        } catch (const PrecisionError& e) {
            before += "in " + with + ": " + e.what() + "; ";
        }
        count_precision_step();
    }
    const Quantities<Bounded> q =
        as_double(quantities_in(source.in_50_digits(), tau), quantities_in(source.in_100_digits(), tau));
    const Largest largest = largest_bound(q);
    if (!(largest.relative <= tolerance))
        throw PrecisionError("50 digits do not have the digits asked for of " + largest.name + "; " + before);
    return {q, {"closed form", "50 digits", before + "checked in 100 digits: they have the digits"}, largest.relative};
}

template void list(const Quantities<Bounded>&, const QuantityReader<Bounded>&);
template void list(const Quantities<Real50>&, const QuantityReader<Real50>&);
template Quantities<Bounded> quantities_without_motion(const ModeSums<Bounded>&, const Bounded&, const Bounded&);
template Quantities<Real50> quantities_without_motion(const ModeSums<Real50>&, const Real50&, const Real50&);
template Quantities<Real100> quantities_without_motion(const ModeSums<Real100>&, const Real100&, const Real100&);
template void add_motion(Quantities<Bounded>&, const ModeSums<Bounded>&, const Bounded&, const Bounded&);
template void add_motion(Quantities<Real50>&, const ModeSums<Real50>&, const Real50&, const Real50&);
template void add_motion(Quantities<Real100>&, const ModeSums<Real100>&, const Real100&, const Real100&);

} // namespace denhartog
