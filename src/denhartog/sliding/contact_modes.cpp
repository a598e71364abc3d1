// Amplitude and phase of the contact alone, for maps: (38), (39), and (69) with an upper bound of the demand (57) in place of
// its maximum. Read `contact_solution` first; without an answer here a point is solved in full.
#include "denhartog/sliding/contact_modes.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

using Number = Bounded<double>;
using Functions = std::vector<evaluation::ModeFunctions<Number>>; // (23), (28), (29) of every mode

// A sum over modes with the errors of its terms, and of its rounding at the end: what that of every term would be in all.
struct Sum {
    double x = 0, e = 0, size = 0;

    void add(const Number& weight, const Number& term) {
        const double each = weight.x * term.x;
        x += each;
        e += weight.most() * term.e + weight.e * std::abs(term.x);
        size += std::abs(each);
    }
    [[nodiscard]] Number bounded(std::size_t N) const {
        return Number::of(x, e, static_cast<double>(N + 2) * unit_of<double>() * size);
    }
};

// The sums over modes that the contact needs.
struct SumsAtContact {
    Complex<Number> V;
    Number U, G;
    double demand; // what the largest (57) does not exceed
    double least;  // what it is not below: its value at the start
};

// (57) is largest for tau -> 0, see `excess_at_the_end`.
bool largest_at_start(const Number& R, const ContactMode& m, const evaluation::ModeFunctions<Number>& f) {
    if (!(m.zeta.most() < 1)) return false;
    const Number excess = evaluation::excess_at_the_end(m.weights.two_zeta, R, f.u, f.g);
    const Number room = 4 * R * R - (1 - m.zeta) * (1 + m.zeta);
    return excess.x > excess.e && room.x > room.e;
}

// An upper bound of (57) of a mode at any instant. |c_i| is that of two amplitudes if the mode oscillates; if it does not,
// the root of R^2 y'^2 + R^4 y''^2 at tau = 0, which never grows.
double largest_demand(const Number& R, const Number& zeta, const evaluation::ModeFunctions<Number>& f) {
    const Number cosine = 1 + f.g, uR = f.u * R;
    const Number sine = zeta.x >= 1 ? cosine + 2 * zeta * uR : (cosine * zeta + uR) / sqrt(Number((1 - zeta) * (1 + zeta)));
    const double c = modulus(Complex<double>{zeta.x >= 1 ? uR.most() : cosine.most(), sine.most()});
    return pi<double>() / 2 * (c + Number(uR * R).most()) * (1 + 16 * unit_of<double>());
}

Functions functions_at(const ContactModes& all, const Number& r) {
    Functions functions;
    functions.reserve(all.modes.size());
    for (const ContactMode& m : all.modes) functions.push_back(bounded_mode_functions(Number(r / m.r_n), m.zeta));
    work_counted.mode_evaluations += static_cast<long>(all.modes.size());
    return functions;
}

SumsAtContact sums_at_contact(const ContactModes& all, const Number& r, const Functions& functions) {
    const std::size_t N = all.modes.size();
    Sum V_re, V_im, U, G, demand, at_start;
    double others = 0;
    for (std::size_t i = 0; i < N; ++i) {
        const ContactMode& m = all.modes[i];
        const evaluation::ModeFunctions<Number>& f = functions[i];
        const Number R = r / m.r_n;
        V_re.add(m.weights.load, f.v.re);
        V_im.add(m.weights.load, f.v.im);
        U.add(m.weights.contact, f.u);
        G.add(m.weights.contact, f.g);
        const Number start = paper::s_d_at_zero(R, m.zeta, f.u, f.g);
        at_start.add(m.weights.square, start);
        if (largest_at_start(R, m, f))
            demand.add(m.weights.square, start);
        else
            others += m.weights.square.most() * largest_demand(R, m.zeta, f);
    }
    const Number left = Number::of(others, 0.0, static_cast<double>(N) * unit_of<double>() * others);
    const Number known = (demand.bounded(N) + left) / (r * r);
    return {
        {V_re.bounded(N), V_im.bounded(N)}, U.bounded(N), G.bounded(N), known.most(), (at_start.bounded(N) / (r * r)).least()};
}

// The largest demand by a search, with its bound; twice that, because the instant found is not followed.
std::optional<double> demand_by_search(const ContactModes& all, const Number& r, const Functions& functions) {
    const auto demand = [&] {
        const ModeSums<Number> sums = mode_sums(*all.basis, all.contact, LoadRows{all.load}, r, functions);
        const Number largest = sliding_demand(sums, Number(instant_of_largest_demand(values_of(sums))));
        const Number held = paper::static_friction_demand(sums.H_j, Number(1), sums.sum_of_squares);
        return std::max(largest.x + 2 * largest.e, held.x + 2 * held.e);
    };
    return tried(demand).value;
}

// None if the bound of (57) leaves open whether the contact slides.
std::optional<ContactSolution> solution_from(const SumsAtContact& s, const Number& beta) {
    const Number limit = paper::friction_ratio_limit(s.V, s.U, Number(s.demand));
    const double slides_below = limit.x - limit.e;
    if (!(beta.most() < slides_below)) return std::nullopt;
    const Number X_j = evaluation::displacement_transmissibility_of_contact(s.V, s.U, s.G, beta);
    if (!(X_j.x > 0)) return std::nullopt;
    return ContactSolution{X_j, wrapped(evaluation::phase_of_contact(s.V, s.U, beta)), Number(slides_below)};
}

} // namespace

ContactModes contact_modes(std::shared_ptr<const ModalBasis<Number>> basis, Mass contact, Mass load) {
    ContactModes all{std::move(basis), contact, load, {}};
    for (std::size_t i = 0; i < all.basis->r_n.size(); ++i) {
        const Number &r_n = all.basis->r_n[i], &zeta = all.basis->zeta[i];
        const auto mode = static_cast<Eigen::Index>(i);
        const Number phi_j = all.basis->phi(static_cast<Eigen::Index>(contact.index), mode),
                     phi_l = all.basis->phi(static_cast<Eigen::Index>(load.index), mode);
        all.modes.push_back({r_n, zeta, evaluation::array_weights(phi_j, phi_l, r_n, zeta)});
    }
    return all;
}

std::optional<ContactSolution> contact_solution(const ContactModes& modes, const Number& r, const Number& beta) {
    check_frequency_ratio(r.x);
    check_friction_ratio(beta.x);
    const Functions functions = functions_at(modes, r);
    SumsAtContact s = sums_at_contact(modes, r, functions);
    if (const std::optional<ContactSolution> found = solution_from(s, beta)) return found;
    const Number highest = paper::friction_ratio_limit(s.V, s.U, Number(s.least));
    if (!(beta.least() <= highest.most())) return std::nullopt; // at a pole it is no number
    const std::optional<double> demand = demand_by_search(modes, r, functions);
    if (!demand) return std::nullopt;
    s.demand = *demand;
    return solution_from(s, beta);
}

} // namespace denhartog
