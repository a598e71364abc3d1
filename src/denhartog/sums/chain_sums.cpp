#include "denhartog/sums/chain_sums.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/elementary/series_tables.hpp"
#include "denhartog/sums/coupled_sums.hpp"

namespace denhartog {
namespace {

std::vector<Bounded<double>> as_inputs(const std::vector<double>& x) {
    std::vector<Bounded<double>> all;
    all.reserve(x.size());
    for (const double each : x) all.push_back(as_input(each));
    return all;
}

// Spring to the next mass or, behind the last one, to the ground; none is 0.
Bounded<double> spring_behind(const std::vector<Bounded<double>>& kappa, std::size_t i) {
    return i + 1 < kappa.size() ? kappa[i + 1] : Bounded<double>(0);
}

// (4 / pi) (1 - 4^-n) zeta(2n); the zeta function of 54 and more is 1 but for a rounding.
Bounded<double> coefficient(int n) {
    const double z = n < elementary::zetas ? elementary::zeta_of_twice[n] : 1;
    return 4 / pi<Bounded<double>>() * (1 - Bounded<double>(std::ldexp(1.0, -2 * n))) *
           Bounded<double>::rounded(z, 0, composed_units);
}

bool undamped_chain(const System<double>& s) {
    return is_chain(s) && !s.damping_ratios.empty() && s.coordinates.load.empty() &&
           std::ranges::all_of(s.damping_ratios, [](double zeta) { return zeta == 0; });
}

void take_sharper(Bounded<double>& a, const Bounded<double>& b) {
    if (b.e < a.e) a = b;
}

} // namespace

std::vector<Bounded<double>> undamped_response_of_chain(const std::vector<Bounded<double>>& gamma,
                                                        const std::vector<Bounded<double>>& kappa, Mass load,
                                                        const Bounded<double>& r) {
    const std::size_t N = gamma.size(), l = load.index;
    const auto own = [&](std::size_t i) { return Bounded<double>(kappa[i] + spring_behind(kappa, i) - r * r * gamma[i]); };
    std::vector<Bounded<double>> left(N), right(N), x(N);
    for (std::size_t i = 0; i < l; ++i) left[i] = i == 0 ? own(i) : Bounded<double>(own(i) - kappa[i] / left[i - 1] * kappa[i]);
    for (std::size_t i = N; i-- > l + 1;)
        right[i] = i + 1 == N ? own(i) : Bounded<double>(own(i) - kappa[i + 1] / right[i + 1] * kappa[i + 1]);
    Bounded<double> both = own(l);
    if (l > 0) both -= kappa[l] / left[l - 1] * kappa[l];
    if (l + 1 < N) both -= kappa[l + 1] / right[l + 1] * kappa[l + 1];
    x[l] = 1 / both;
    for (std::size_t i = l; i > 0; --i) x[i - 1] = kappa[i] * x[i] / left[i - 1];
    for (std::size_t i = l; i + 1 < N; ++i) x[i + 1] = kappa[i + 1] * x[i] / right[i + 1];
    return x;
}

std::vector<Bounded<double>> undamped_damping_function_of_chain(const std::vector<Bounded<double>>& gamma,
                                                                const std::vector<Bounded<double>>& kappa, Mass contact,
                                                                const Bounded<double>& r, const Bounded<double>& highest) {
    const std::size_t N = gamma.size();
    const Bounded<double> square = r * r;
    const double p = std::min(0.5, (highest.x + highest.e) * (highest.x + highest.e) / (square.x - square.e) * (1 + 1e-9));
    std::vector<Bounded<double>> w(N, Bounded<double>(0)), sum(N, Bounded<double>(0));
    w[contact.index] = 1 / gamma[contact.index];
    constexpr std::size_t most_terms = 200;
    for (std::size_t n = 1; n <= most_terms; ++n) {
        const Bounded<double> c = coefficient(static_cast<int>(n));
        for (std::size_t k = 0; k < N; ++k) sum[k] += c * w[k];
        // Of the terms left out each is at most p times the one before in the norm of the masses; n > N reaches every mass.
        double norm = 0;
        for (std::size_t k = 0; k < N; ++k) norm += gamma[k].x * (std::abs(w[k].x) + w[k].e) * (std::abs(w[k].x) + w[k].e);
        const double rest = 1.01 * c.x * std::sqrt(norm) * p / (1 - p);
        bool done = n > N;
        for (std::size_t k = 0; k < N; ++k) done = done && rest / std::sqrt(gamma[k].x) <= 1e-17 * std::abs(sum[k].x);
        if (done || n == most_terms) {
            for (std::size_t k = 0; k < N; ++k) sum[k].e += rest / std::sqrt(gamma[k].x - gamma[k].e);
            break;
        }
        std::vector<Bounded<double>> next(N);
        for (std::size_t k = 0; k < N; ++k) {
            next[k] = (kappa[k] + spring_behind(kappa, k)) * w[k];
            if (k > 0) next[k] -= kappa[k] * w[k - 1];
            if (k + 1 < N) next[k] -= kappa[k + 1] * w[k + 1];
            next[k] /= gamma[k] * square;
        }
        w = std::move(next);
    }
    for (Bounded<double>& each : sum) each /= square;
    return sum;
}

namespace {

void sharpen(const System<double>& system, const BoundedModes<double>& modes, ModeSums<Bounded<double>>& s) {
    if (!undamped_chain(system)) return;
    const std::vector<Bounded<double>> gamma = as_inputs(system.mass_ratios), kappa = as_inputs(system.stiffness_ratios);
    const std::vector<Bounded<double>> V = undamped_response_of_chain(gamma, kappa, system.load, s.r);
    for (std::size_t k = 0; k < V.size(); ++k) take_sharper(s.V[k].re, V[k]);
    const Bounded<double>& highest = modes.basis().r_n.back();
    if (!(s.r.x >= 2 * (highest.x + highest.e))) return;
    const std::vector<Bounded<double>> U = undamped_damping_function_of_chain(gamma, kappa, system.contact, s.r, highest);
    for (std::size_t k = 0; k < U.size(); ++k) take_sharper(s.U[k], U[k]);
}

} // namespace

ModeSums<Bounded<double>> bounded_sums(const System<double>& system, BoundedModes<double>& modes) {
    if (modes.basis().coupled()) return coupled_sums(system, modes.r());
    ModeSums<Bounded<double>> s = mode_sums(modes.basis(), system.contact, system.load, modes.r(), modes.all());
    sharpen(system, modes, s);
    return s;
}

} // namespace denhartog
