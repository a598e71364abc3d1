#include "denhartog/sliding/contact_modes.hpp"

#include <cmath>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

// A sum over modes with the errors of its terms, and of its rounding at the end: what that of every term would be in all.
template <class T>
struct Sum {
    T x{0}, e{0}, size{0};

    void add(const Bounded<T>& weight, const Bounded<T>& term) {
        const T each = weight.x * term.x;
        x += each;
        e += weight.most() * term.e + weight.e * size_of_number(term.x);
        size += size_of_number(each);
    }
    [[nodiscard]] Bounded<T> bounded(std::size_t N) const {
        return Bounded<T>::of(x, e, T(static_cast<int>(N + 2) * unit_of<T>() * size));
    }
};

// (57) is largest for tau -> 0, see `excess_at_the_end`.
template <class T>
bool largest_at_start(const Bounded<T>& R, const ContactMode<T>& m, const evaluation::ModeFunctions<Bounded<T>>& f) {
    if (!(m.zeta.most() < 1)) return false;
    const Bounded<T> excess = evaluation::excess_at_the_end(m.weights.two_zeta, R, f.u, f.g);
    const Bounded<T> room = 4 * R * R - (1 - m.zeta) * (1 + m.zeta);
    return excess.x > excess.e && room.x > room.e;
}

// (23), (28), (29) of every mode.
template <class T>
std::vector<evaluation::ModeFunctions<Bounded<T>>> functions_at(const ContactModes<T>& all, const Bounded<T>& r) {
    std::vector<evaluation::ModeFunctions<Bounded<T>>> functions;
    functions.reserve(all.modes.size());
    for (const ContactMode<T>& m : all.modes) functions.push_back(bounded_mode_functions(Bounded<T>(r / m.r_n), m.zeta));
    work_counted.mode_evaluations += static_cast<long>(all.modes.size());
    return functions;
}

// The largest demand by a search, with its bound; twice that, because the instant found is not followed.
template <class T>
std::optional<T> demand_by_search(const ContactModes<T>& all, const Bounded<T>& r) {
    try {
        BoundedModes<T> functions(all.basis, r);
        const ModeSums<Bounded<T>> sums = mode_sums(*all.basis, all.contact, all.load, r, functions.all());
        const T instant = instant_of_largest_demand(values_of(sums));
        const Bounded<T> largest = sliding_demand(sums, Bounded<T>(instant));
        const Bounded<T> held = paper::static_friction_demand(sums.H_j, Bounded<T>(1), sums.sum_of_squares);
        return std::max(T(largest.x + 2 * largest.e), T(held.x + 2 * held.e));
    } catch (const DomainError&) {
    } catch (const PrecisionError&) {
    }
    return std::nullopt;
}

} // namespace

template <class T>
T largest_demand(const Bounded<T>& R, const Bounded<T>& zeta, const evaluation::DampingFunctions<Bounded<T>>& f) {
    const Bounded<T> cosine = 1 + f.g, uR = f.u * R;
    const Bounded<T> sine =
        zeta.x >= 1 ? cosine + 2 * zeta * uR : (cosine * zeta + uR) / sqrt(Bounded<T>((1 - zeta) * (1 + zeta)));
    const T c = modulus(Complex<T>{zeta.x >= 1 ? uR.most() : cosine.most(), sine.most()});
    return pi<T>() / 2 * (c + Bounded<T>(uR * R).most()) * (1 + 16 * unit_of<T>());
}

template <class T>
ContactModes<T> contact_modes(std::shared_ptr<const ModalBasis<Bounded<T>>> basis, Mass contact, Mass load) {
    ContactModes<T> all{std::move(basis), contact, load, {}};
    for (std::size_t i = 0; i < all.basis->r_n.size(); ++i) {
        const Bounded<T>&r_n = all.basis->r_n[i], &zeta = all.basis->zeta[i];
        const auto mode = static_cast<Eigen::Index>(i);
        const Bounded<T> phi_j = all.basis->phi(static_cast<Eigen::Index>(contact.index), mode),
                         phi_l = all.basis->phi(static_cast<Eigen::Index>(load.index), mode);
        all.modes.push_back({r_n, zeta, evaluation::array_weights(phi_j, phi_l, r_n, zeta)});
    }
    return all;
}

template <class T>
SumsAtContact<T> sums_at_contact(const ContactModes<T>& all, const Bounded<T>& r,
                                 const std::vector<evaluation::ModeFunctions<Bounded<T>>>& functions) {
    const std::size_t N = all.modes.size();
    Sum<T> V_re, V_im, U, G, demand, at_start;
    T others(0);
    for (std::size_t i = 0; i < N; ++i) {
        const ContactMode<T>& m = all.modes[i];
        const evaluation::ModeFunctions<Bounded<T>>& f = functions[i];
        const Bounded<T> R = r / m.r_n;
        V_re.add(m.weights.load, f.v.re);
        V_im.add(m.weights.load, f.v.im);
        U.add(m.weights.contact, f.u);
        G.add(m.weights.contact, f.g);
        const Bounded<T> start = paper::s_d_at_zero(R, m.zeta, f.u, f.g);
        at_start.add(m.weights.square, start);
        if (largest_at_start(R, m, f))
            demand.add(m.weights.square, start);
        else
            others += m.weights.square.most() * largest_demand(R, m.zeta, {f.u, f.g});
    }
    const Bounded<T> left = Bounded<T>::of(others, T(0), T(static_cast<int>(N) * unit_of<T>() * others));
    const Bounded<T> known = (demand.bounded(N) + left) / (r * r);
    return {
        {V_re.bounded(N), V_im.bounded(N)}, U.bounded(N), G.bounded(N), known.most(), (at_start.bounded(N) / (r * r)).least()};
}

template <class T>
std::optional<ContactSolution<T>> contact_solution(const SumsAtContact<T>& s, const Bounded<T>& beta) {
    const Bounded<T> limit = paper::friction_ratio_limit(s.V, s.U, Bounded<T>(s.demand));
    const T slides_below = limit.x - limit.e;
    if (!(beta.most() < slides_below)) return std::nullopt;
    const Bounded<T> X_j = evaluation::displacement_transmissibility_of_contact(s.V, s.U, s.G, beta);
    if (!(X_j.x > 0)) return std::nullopt;
    return ContactSolution<T>{X_j, wrapped(evaluation::phase_of_contact(s.V, s.U, beta)), Bounded<T>(slides_below)};
}

template <class T>
std::optional<ContactSolution<T>> contact_solution(const ContactModes<T>& modes, const Bounded<T>& r, const Bounded<T>& beta) {
    check_frequency_ratio(r.x);
    check_friction_ratio(beta.x);
    SumsAtContact<T> s = sums_at_contact(modes, r, functions_at(modes, r));
    if (const std::optional<ContactSolution<T>> found = contact_solution(s, beta)) return found;
    const Bounded<T> highest = paper::friction_ratio_limit(s.V, s.U, Bounded<T>(s.least));
    if (beta.least() > highest.most()) return std::nullopt;
    const std::optional<T> demand = demand_by_search(modes, r);
    if (!demand) return std::nullopt;
    s.demand = *demand;
    return contact_solution(s, beta);
}

template ContactModes<double> contact_modes(std::shared_ptr<const ModalBasis<Bounded<double>>>, Mass, Mass);
template SumsAtContact<double> sums_at_contact(const ContactModes<double>&, const Bounded<double>&,
                                               const std::vector<evaluation::ModeFunctions<Bounded<double>>>&);
template std::optional<ContactSolution<double>> contact_solution(const SumsAtContact<double>&, const Bounded<double>&);
template std::optional<ContactSolution<double>> contact_solution(const ContactModes<double>&, const Bounded<double>&,
                                                                 const Bounded<double>&);
template double largest_demand(const Bounded<double>&, const Bounded<double>&,
                               const evaluation::DampingFunctions<Bounded<double>>&);

} // namespace denhartog
