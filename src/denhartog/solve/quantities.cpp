#include "denhartog/solve/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/model/number_text.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "denhartog/sliding/chain_sums.hpp"

namespace denhartog {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr double nothing = 1e-280;    // bounds below it are of numbers that their formula makes zero
constexpr double zero_beside = 1e-25; // of the largest of its kind: what 50 digits cannot tell from zero there is zero
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

bool is_motion(std::string_view name) { return name == "x" || name == "x'"; }

bool is_asked_for(std::string_view name, PointNumbers asked) {
    if (asked == PointNumbers::all) return true;
    const bool of_motion = is_motion(name) || name == "X_j" || name == "phi_j";
    return asked == PointNumbers::sums ? !of_motion : is_motion(name);
}

// With zeros told apart a number without a size is one.
Largest largest_bound(const Quantities<Bounded>& q, PointNumbers asked, bool zeros_told = false) {
    Largest largest;
    list<Bounded>(q, [&](const char* name, std::size_t mass, const Bounded& value, const Bounded& size) {
        if (value.e <= nothing || !is_asked_for(name, asked) || (zeros_told && value.x == 0 && size.x == 0)) return;
        const double relative = value.e / std::abs(size.x);
        if (relative <= largest.relative) return;
        largest = {relative <= std::numeric_limits<double>::max() ? relative : std::numeric_limits<double>::infinity(),
                   std::string(name) + (mass > 0 ? " of mass " + std::to_string(mass) : "")};
    });
    return largest;
}

template <class T>
Quantities<T> quantities_in(const Scene<T>& scene, std::span<const double> tau) {
    const ModeSums<T> sums = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
    Quantities<T> q = quantities_without_motion(sums, scene.mu, instant_of_largest_demand(sums));
    if (scene.beta) add_motion(q, sums, *scene.beta, std::vector<T>(tau.begin(), tau.end()));
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
    all.x_prime = as_double(q.x_prime, wide.x_prime);
    all.x_size = as_double(q.x_size, wide.x_size);
    return all;
}

// A number in the bound that its size leaves is zero, where that is little beside the largest of its kind. How many there are.
std::size_t tell_zeros(const std::vector<std::vector<Bounded*>>& kind, double tolerance) {
    const auto size_of = [](const std::vector<Bounded*>& parts) {
        Bounded size(0);
        for (const Bounded* part : parts) size = larger(size, {std::abs(part->x), part->e});
        return size;
    };
    double largest = 0;
    for (const std::vector<Bounded*>& number : kind) largest = std::max(largest, size_of(number).x);
    std::size_t zeros = 0;
    for (const std::vector<Bounded*>& number : kind) {
        const Bounded size = size_of(number);
        if (size.e <= tolerance * size.x || !(size.x + size.e <= zero_beside * largest)) continue;
        ++zeros;
        for (Bounded* part : number) *part = {0, std::abs(part->x) + part->e};
    }
    return zeros;
}

std::size_t tell_zeros(Quantities<Bounded>& q, double tolerance) {
    std::vector<std::vector<Bounded*>> V, U, G, x;
    for (std::size_t k = 0; k < q.V.size(); ++k) {
        V.push_back({&q.V[k].re, &q.V[k].im});
        U.push_back({&q.U[k]});
        G.push_back({&q.G[k]});
    }
    for (std::size_t k = 0; k < q.x_size.size(); ++k) {
        x.push_back({&q.x_size[k]});
        for (std::size_t n = k; n < q.x.size(); n += q.x_size.size()) x.back().insert(x.back().end(), {&q.x[n], &q.x_prime[n]});
    }
    std::size_t zeros = 0;
    for (const auto& kind : {V, U, G, x}) zeros += tell_zeros(kind, tolerance);
    return zeros;
}

bool regime_is_open(const Quantities<Bounded>& q, double beta) {
    return std::abs(q.beta_lim.x - beta) <= q.beta_lim.e + as_input(beta).e;
}

Quantities<Bounded> bounded_quantities(const Scene<double>& scene, BoundedModes& modes, std::span<const double> tau) {
    const ModeSums<Bounded> sums = bounded_sums(scene.system, modes, Inputs::rounded);
    Quantities<Bounded> q =
        quantities_without_motion(sums, as_input(scene.mu), Bounded(instant_of_largest_demand(values_of(sums))));
    if (!scene.beta) return q;
    std::vector<Bounded> instants;
    for (const double instant : tau) instants.push_back(as_input(instant));
    add_motion(q, sums, as_input(*scene.beta), instants);
    return q;
}

QuantitiesAnswer quantities_at(SceneSource source, std::shared_ptr<const ModalBasis<Bounded>> bounded,
                               std::span<const double> tau, int digits, PointNumbers asked) {
    if (digits < 1 || digits > most_digits_of_quantities)
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits_of_quantities), std::to_string(digits));
    if (asked == PointNumbers::sums) source = without_friction_ratio(source);
    Scene<double> scene = source.in_double();
    check(scene);
    if (!scene.r) throw InputError("r", "must be given", "nothing");
    if (!scene.beta && asked != PointNumbers::sums) throw InputError("beta", "must be given", "nothing");
    if (scene.system.damping_ratios.empty()) {
        scene = with_damping_ratios(scene);
        source = scene_source(scene);
    }
    for (const double instant : tau)
        if (!std::isfinite(instant)) throw InputError("tau", "must be finite", number_to_text(instant));
    const double tolerance = std::pow(10.0, -digits);
    std::string before;
    for (const bool sharp : {false, true}) {
        const std::string with = sharp ? "double with the modes of long double" : "double";
        try {
            if (sharp || !bounded)
                bounded = std::make_shared<const ModalBasis<Bounded>>(
                    sharp ? sharp_basis(scene.system, Inputs::rounded) : with_errors(scene.system, modal_basis(scene.system)));
            BoundedModes modes(bounded, as_input(*scene.r));
            const Quantities<Bounded> q = bounded_quantities(scene, modes, tau);
            const Largest largest = largest_bound(q, asked);
            const bool open = scene.beta && regime_is_open(q, *scene.beta);
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
    Quantities<Bounded> q = as_double(quantities_in(source.in_50_digits(), tau), quantities_in(source.in_100_digits(), tau));
    const bool has_zeros = tell_zeros(q, tolerance) > 0;
    const Largest largest = largest_bound(q, asked, true);
    if (!(largest.relative <= tolerance))
        throw PrecisionError("50 digits do not have the digits asked for of " + largest.name + "; " + before);
    const std::string zeros = has_zeros ? ", but for what is below 1e-25 of the largest of its kind and given as zero" : "";
    return {q, {"closed form", "50 digits", before + "checked in 100 digits: they have the digits" + zeros}, largest.relative};
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
    const std::size_t N = q.x_size.size();
    for (std::size_t n = 0; n < q.x.size(); ++n) {
        read("x", n % N + 1, q.x[n], q.x_size[n % N]);
        read("x'", n % N + 1, q.x_prime[n], q.x_size[n % N]);
    }
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
void add_motion(Quantities<T>& q, const ModeSums<T>& s, const T& beta, const std::vector<T>& tau) {
    if (!(beta < q.beta_lim)) return;
    const SteadyState<T> state = steady_state_without_maxima(s, beta);
    q.X_j = state.X_j;
    q.phi_j = state.phi_j;
    for (const T& instant : tau) {
        const Motion<T> at = motion(s, state, instant);
        q.x.insert(q.x.end(), at.x.begin(), at.x.end());
        q.x_prime.insert(q.x_prime.end(), at.x_prime.begin(), at.x_prime.end());
    }
    for (const MassResponse<T>& m : state.masses) q.x_size.push_back(m.amplitude_monoharmonic);
}

QuantitiesAnswer quantities(const SceneSource& source, std::span<const double> tau, int digits, PointNumbers asked) {
    return quantities_at(source, nullptr, tau, digits, asked);
}

QuantitiesAnswer quantities(const PreparedSystem& system, const SceneSource& point, std::span<const double> tau, int digits,
                            PointNumbers asked) {
    return quantities_at(point, system.bounded, tau, digits, asked);
}

template void list(const Quantities<Bounded>&, const QuantityReader<Bounded>&);
template void list(const Quantities<Real50>&, const QuantityReader<Real50>&);
template Quantities<Bounded> quantities_without_motion(const ModeSums<Bounded>&, const Bounded&, const Bounded&);
template Quantities<Real50> quantities_without_motion(const ModeSums<Real50>&, const Real50&, const Real50&);
template Quantities<Real100> quantities_without_motion(const ModeSums<Real100>&, const Real100&, const Real100&);
template void add_motion(Quantities<Bounded>&, const ModeSums<Bounded>&, const Bounded&, const std::vector<Bounded>&);
template void add_motion(Quantities<Real50>&, const ModeSums<Real50>&, const Real50&, const std::vector<Real50>&);
template void add_motion(Quantities<Real100>&, const ModeSums<Real100>&, const Real100&, const std::vector<Real100>&);

} // namespace denhartog
