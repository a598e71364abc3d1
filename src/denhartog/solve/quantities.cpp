#include "denhartog/solve/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sums/chain_sums.hpp"

namespace denhartog {
namespace {

constexpr double nothing = 1e-280;    // bounds below it are of numbers that their formula makes zero
constexpr double zero_beside = 1e-25; // of the largest of its kind: what 50 digits cannot tell from zero there is zero
constexpr int most_digits_of_quantities = 15;

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
Largest largest_bound(const Quantities<Bounded<double>>& q, PointNumbers asked, bool zeros_told = false) {
    Largest largest;
    list<Bounded<double>>(q, [&](const char* name, std::size_t mass, const Bounded<double>& value, const Bounded<double>& size) {
        if (value.e <= nothing || !is_asked_for(name, asked) || (zeros_told && value.x == 0 && size.x == 0)) return;
        const double relative = value.e / std::abs(size.x);
        if (relative <= largest.relative) return;
        largest = {relative <= std::numeric_limits<double>::max() ? relative : std::numeric_limits<double>::infinity(),
                   std::string(name) + (mass > 0 ? " of mass " + std::to_string(mass) : "")};
    });
    return largest;
}

template <class T>
std::vector<Bounded<double>> all_in_double(const std::vector<Bounded<T>>& numbers) {
    std::vector<Bounded<double>> all;
    for (const Bounded<T>& each : numbers) all.push_back(in_double(each));
    return all;
}

template <class T>
Quantities<Bounded<double>> all_in_double(const Quantities<Bounded<T>>& q) {
    Quantities<Bounded<double>> all;
    for (const Complex<Bounded<T>>& each : q.V) all.V.push_back({in_double(each.re), in_double(each.im)});
    all.U = all_in_double(q.U);
    all.G = all_in_double(q.G);
    all.H_j = in_double(q.H_j);
    all.S = in_double(q.S);
    all.beta_lim = in_double(q.beta_lim);
    all.instant = in_double(q.instant);
    if (!q.X_j) return all;
    all.X_j = in_double(*q.X_j);
    all.phi_j = in_double(*q.phi_j);
    all.x = all_in_double(q.x);
    all.x_prime = all_in_double(q.x_prime);
    all.x_size = all_in_double(q.x_size);
    return all;
}

// A number in the bound that its size leaves is zero, where that is little beside the largest of its kind. How many there are.
std::size_t tell_zeros(const std::vector<std::vector<Bounded<double>*>>& kind, double tolerance) {
    const auto size_of = [](const std::vector<Bounded<double>*>& parts) {
        Bounded<double> size(0);
        for (const Bounded<double>* part : parts) size = larger(size, {std::abs(part->x), part->e});
        return size;
    };
    double largest = 0;
    for (const std::vector<Bounded<double>*>& number : kind) largest = std::max(largest, size_of(number).x);
    std::size_t zeros = 0;
    for (const std::vector<Bounded<double>*>& number : kind) {
        const Bounded<double> size = size_of(number);
        if (size.e <= tolerance * size.x || !(size.x + size.e <= zero_beside * largest)) continue;
        ++zeros;
        for (Bounded<double>* part : number) *part = {0, std::abs(part->x) + part->e};
    }
    return zeros;
}

std::size_t tell_zeros(Quantities<Bounded<double>>& q, double tolerance) {
    std::vector<std::vector<Bounded<double>*>> V, U, G, x;
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

template <class T>
Quantities<Bounded<T>> quantities_in(const SceneIn<T>& in, std::span<const double> tau, double tolerance) {
    const Scene<T>& scene = in.scene;
    BoundedModes<T> modes(in.basis, as_input(*scene.r));
    const ModeSums<Bounded<T>> sums = bounded_sums(scene.system, modes);
    const Bounded<T> mu = as_input(scene.mu);
    // The search works on values in double; elsewhere (57) is larger by no more than it could tell.
    const ModeSums<Bounded<double>> searched = in_double(sums);
    const double instant = instant_of_largest_demand(values_of(searched));
    const T at = instant >= pi<double>() ? pi<T>() : T(instant);
    Quantities<Bounded<T>> q;
    if constexpr (std::same_as<T, double>) {
        q = quantities_without_motion(sums, mu, Bounded<T>(at));
    } else {
        const Bounded<T> unsure(T(sliding_demand(searched, Bounded<double>(instant)).e));
        q = quantities_without_motion(sums, mu, Bounded<T>(at), unsure);
        if (!(q.S.e <= T(tolerance) * size_of_number(q.S.x))) // the search on values of this type tells more
            q = quantities_without_motion(sums, mu, Bounded<T>(instant_of_largest_demand(values_of(sums))));
    }
    if (!scene.beta) return q;
    std::vector<Bounded<T>> instants;
    for (const double each : tau) instants.push_back(as_input(T(each)));
    add_motion(q, sums, as_input(*scene.beta), instants);
    return q;
}

void put_in_order_of_masses(const Coordinates<double>& c, Quantities<Bounded<double>>& q) {
    if (c.replaced.empty()) return;
    const auto order = [&c](auto& of_displacements) {
        put_in_order_of_masses(c, of_displacements);
        of_displacements.resize(of_displacements.size() - c.replaced.size());
    };
    const std::size_t count = q.V.size(), instants = q.x.size() / count;
    for (std::vector<Bounded<double>>* motion : {&q.x, &q.x_prime}) {
        std::vector<Bounded<double>> all;
        for (std::size_t n = 0; n < instants; ++n) {
            const auto from = motion->begin() + static_cast<std::ptrdiff_t>(n * count);
            std::vector<Bounded<double>> at(from, from + static_cast<std::ptrdiff_t>(count));
            order(at);
            all.insert(all.end(), at.begin(), at.end());
        }
        *motion = std::move(all);
    }
    order(q.V);
    order(q.U);
    order(q.G);
    if (!q.x_size.empty()) order(q.x_size);
}

QuantitiesAnswer quantities_at(const SceneSource& asked_source, std::shared_ptr<const ModalBasis<Bounded<double>>> basis,
                               std::span<const double> tau, int digits, PointNumbers asked) {
    if (digits < 1 || digits > most_digits_of_quantities)
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits_of_quantities), std::to_string(digits));
    const SceneSource source = asked == PointNumbers::sums ? without_friction_ratio(asked_source) : asked_source;
    const Scene<double>& scene = source->in_double();
    check(scene);
    (void)frequency_ratio_of(scene);
    if (asked != PointNumbers::sums) (void)friction_ratio_of(scene);
    if (!tau.empty()) check_samples("the number of instants tau", tau.size(), number_of_masses(scene.system));
    for (const double instant : tau)
        if (!std::isfinite(instant)) throw InputError("tau", "must be finite", number_to_text(instant));
    const Aim aim = aim_of(digits);
    const QuestionEffort effort(number_of_masses(scene.system));
    QuantitiesAnswer answer;
    Largest largest;
    bool has_zeros = false;
    const auto attempt = [&]<class T>(std::type_identity<T>) {
        SceneIn<T> in;
        if constexpr (std::same_as<T, double>) {
            if (basis) in = {scene, basis};
        }
        if (!in.basis) in = scene_with_modes<T>(source);
        const Quantities<Bounded<T>> q = quantities_in(in, tau, aim.tolerance);
        answer.numbers = all_in_double(q);
        // What 50 digits cannot tell from zero is told as zero.
        has_zeros = !std::same_as<T, double> && tell_zeros(answer.numbers, aim.tolerance) > 0;
        largest = largest_bound(answer.numbers, asked, !std::same_as<T, double>);
        // A boundary that is no number in this type is open as well.
        const bool open = scene.beta && !(size_of_number(T(q.beta_lim.x - *in.scene.beta)) > q.beta_lim.e);
        return Attempted{largest.relative, !open};
    };
    const Certainty found = certify(aim, attempt);
    if (!found.settled)
        throw PrecisionError("computing in 100 digits does not give " + (largest.name.empty() ? "beta_lim" : largest.name) +
                             " to the digits asked for; " + found.why);
    const std::string zeros = has_zeros ? "; numbers below 1e-25 of the largest of their kind are given as zero" : "";
    put_in_order_of_masses(scene.system.coordinates, answer.numbers);
    answer.method = {"closed form", name(found.precision), found.why + zeros};
    answer.relative = found.relative;
    return answer;
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
Quantities<T> quantities_without_motion(const ModeSums<T>& s, const T& mu, const T& instant, const T& unsure) {
    const std::size_t j = s.contact.index;
    Quantities<T> q;
    q.V = s.V;
    q.U = s.U;
    q.G = s.G;
    q.H_j = s.H_j;
    q.instant = instant;
    q.S = with_neglected(found_by_search(sliding_demand(s, instant)), unsure);
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
    for (const Motion<T>& at : motions(s, state, std::span<const T>(tau))) {
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

template void list(const Quantities<Bounded<double>>&, const QuantityReader<Bounded<double>>&);
template void list(const Quantities<Real50>&, const QuantityReader<Real50>&);
template Quantities<Bounded<double>> quantities_without_motion(const ModeSums<Bounded<double>>&, const Bounded<double>&,
                                                               const Bounded<double>&, const Bounded<double>&);
template Quantities<Real50> quantities_without_motion(const ModeSums<Real50>&, const Real50&, const Real50&, const Real50&);
template Quantities<Real100> quantities_without_motion(const ModeSums<Real100>&, const Real100&, const Real100&, const Real100&);
template void add_motion(Quantities<Bounded<double>>&, const ModeSums<Bounded<double>>&, const Bounded<double>&,
                         const std::vector<Bounded<double>>&);
template void add_motion(Quantities<Real50>&, const ModeSums<Real50>&, const Real50&, const std::vector<Real50>&);
template void add_motion(Quantities<Real100>&, const ModeSums<Real100>&, const Real100&, const std::vector<Real100>&);

} // namespace denhartog
