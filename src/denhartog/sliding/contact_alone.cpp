// The motion of the contact alone. `add_mode` is the summation (33)-(35), (64), (65). For a single question `contact_solution`
// has (38), (39) and a lower bound of (69): by the maximum of the demand (57) if a search settles it, else by an upper bound of
// it. If that does not decide, a point is solved in full. For maps `contact_sums` has the sums over arrays of r, `contact_limits`
// the boundaries of them, and `contact_amplitudes` (38) over beta.
#include "denhartog/sliding/contact_alone.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"

namespace denhartog {
namespace {

using evaluation::run_with;

using Number = Bounded<double>;
using Functions = std::vector<evaluation::ModeFunctions<Number>>; // (23), (28), (29) of every mode

std::vector<ContactMode<Number>> weighted_modes(const ModalBasis<Number>& basis, Mass contact, Mass load) {
    std::vector<ContactMode<Number>> modes;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i)
        modes.push_back(
            {basis.r_n[i], basis.zeta[i],
             evaluation::array_weights(basis.phi(contact.index, i), basis.phi(load.index, i), basis.r_n[i], basis.zeta[i])});
    return modes;
}

// Adds the terms of a mode to (33)-(35), and to (64) without 1 / r^2.
template <class T, class Sums>
[[gnu::always_inline]] inline void add_mode(const evaluation::ArrayWeights<T>& m, const T& R,
                                            const evaluation::ModeFunctions<T>& f, const Sums& s) {
    s.V_re += m.load * f.v.re;
    s.V_im += m.load * f.v.im;
    s.U += m.contact * f.u;
    s.G += m.contact * f.g;
    s.H += evaluation::term_of_H(m, R, f.u, f.g);
}

// The factors 1 / r^2 of (64) and, from the squares of the shapes at the contact, of (65).
template <class T, class Sums>
[[gnu::always_inline]] inline void divide_by_square(const T& r, const T& squares, const Sums& s) {
    s.H = s.H / r / r;
    s.sum_of_squares = squares / r / r;
}

// (57) is largest for tau -> 0, see `excess_at_the_end`.
bool is_largest_at_start(const Number& R, const ContactMode<Number>& m, const evaluation::ModeFunctions<Number>& f) {
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
    for (const ContactMode<Number>& m : all.modes) functions.push_back(bounded_mode_functions(Number(r / m.r_n), m.zeta));
    work_counted.mode_evaluations += static_cast<long>(all.modes.size());
    return functions;
}

SumsAtContact<Number> sums_at_contact(const ContactModes& all, const Number& r, const Functions& functions) {
    SumsAtContact<Number> s{};
    const SumsAtContact<Number&> sums{s.V_re, s.V_im, s.U, s.G, s.H, s.sum_of_squares};
    Number squares(0);
    for (std::size_t i = 0; i < all.modes.size(); ++i) {
        add_mode(all.modes[i].weights, Number(r / all.modes[i].r_n), functions[i], sums);
        squares += all.modes[i].weights.square;
    }
    divide_by_square(r, squares, sums);
    return s;
}

// A bound of what the largest demand is above that at the start, by the modes whose (57) may be largest elsewhere.
double demand_above_start(const ContactModes& all, const Number& r, const Functions& functions) {
    Number above(0);
    for (std::size_t i = 0; i < all.modes.size(); ++i) {
        const ContactMode<Number>& m = all.modes[i];
        const evaluation::ModeFunctions<Number>& f = functions[i];
        const Number R = r / m.r_n;
        if (is_largest_at_start(R, m, f)) continue;
        above += m.weights.square * (Number(largest_demand(R, m.zeta, f)) - paper::s_d_at_zero(R, m.zeta, f.u, f.g));
    }
    return Number(above / (r * r)).most();
}

// (69) with the largest demand, which may be searched for; none if it is not settled.
std::optional<Number> limit_by_search(const ContactModes& all, const Number& r, const Functions& functions) {
    const auto limit = [&] {
        return regime_boundary(mode_sums(*all.basis, all.contact, all.load, r, functions), Number(1)).exact;
    };
    return tried(limit).value;
}

// None if it is not certain that beta is below the limit (69), which may be too small.
std::optional<ContactSolution> solution_below(const Number& limit, const SumsAtContact<Number>& s, const Number& beta) {
    const double slides_below = limit.x - limit.e;
    if (!(beta.most() < slides_below)) return std::nullopt;
    const Complex<Number> V_dj{s.V_re, s.V_im};
    const Number X_j = evaluation::displacement_transmissibility_of_contact(V_dj, s.U, s.G, beta);
    if (!(X_j.x > 0)) return std::nullopt;
    return ContactSolution{X_j, wrapped(evaluation::phase_of_contact(V_dj, s.U, beta)), Number(slides_below)};
}

constexpr std::size_t block = 256;

evaluation::Vectors widest() { return evaluation::supported_vectors().back(); }

// Functions of one mode over a block.
struct ModeBlock {
    std::array<double, block> R, v_re, v_im, u, g;
};

// A mode without its bounds.
struct WeightedMode : ContactMode<double> {
    evaluation::ArrayWeights<double> sizes; // in the sizes of the terms
    double sharpness;                       // by the error of R a size of (23), (28), (29) grows by so many of its square
};

// The weight that a term counts with in the sizes, the error of its own among them.
double size_of_weight(const Bounded<double>& weight) { return std::abs(weight.x) + weight.e / error_of_size(); }

// Of v an error of R makes at most 2 R^2 |v|^2 of its relative size, of u and g about as much; R^2 is below 9/4 or |v| below 1.
double sharpness_of(const Bounded<double>& r_n) { return 5 * r_n.e / r_n.x / error_of_size(); }

WeightedMode without_bounds(const ContactMode<Number>& m) {
    const evaluation::ArrayWeights<Number>& w = m.weights;
    return {{m.r_n.x, m.zeta.x, {w.load.x, w.contact.x, w.square.x, w.two_zeta.x}},
            {size_of_weight(w.load), size_of_weight(w.contact), size_of_weight(w.square), w.two_zeta.x},
            sharpness_of(m.r_n)};
}

[[gnu::always_inline]] inline double absolute(double x) { return __builtin_fabs(x); }

using SumsOfBlock = SumsOverRatios<std::array<double, block>>;

[[gnu::always_inline]] inline SumsAtContact<double&> entry(SumsOfBlock& s, std::size_t i) {
    return {s.V_re[i], s.V_im[i], s.U[i], s.G[i], s.H[i], s.sum_of_squares[i]};
}

// Adds the terms of a mode over a block, and their sizes.
[[gnu::always_inline]] inline void add(const WeightedMode& mode, const ModeBlock& of, SumsOfBlock& s, std::size_t n) {
    const evaluation::ArrayWeights<double> m = mode.weights, size = mode.sizes;
    const double zeta = mode.zeta, sharpness = mode.sharpness;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double R = of.R[i], v_re = of.v_re[i], v_im = of.v_im[i], u = of.u[i], g = of.g[i];
        const double modulus = absolute(v_re) + absolute(v_im), size_of_v = modulus * (1 + sharpness * modulus);
        const double size_of_u = absolute(u) + 1, grown = 1 + sharpness * size_of_u;
        add_mode(m, R, evaluation::ModeFunctions<double>{{v_re, v_im}, u, g}, entry(s, i));
        s.Y_re[i] += m.contact * v_re;
        s.Y_im[i] += m.contact * v_im;
        s.size_of_V[i] += size.load * size_of_v;
        s.size_of_Y[i] += size.contact * size_of_v;
        s.size_of_U[i] += size.contact * size_of_u * grown;
        s.size_of_H[i] += size.square * (absolute(g) + size.two_zeta * R * absolute(u) + 1) * grown;
        const double certainty = evaluation::certainty_of_start(R, zeta, u, g);
        s.certainty[i] = certainty < s.certainty[i] ? certainty : s.certainty[i];
    }
}

// The sums by themselves, of a block or of all frequency ratios.
auto all_of(auto& s) {
    return std::array{&s.V_re, &s.V_im,      &s.U,         &s.G,         &s.H,         &s.sum_of_squares, &s.Y_re,
                      &s.Y_im, &s.size_of_V, &s.size_of_Y, &s.size_of_U, &s.size_of_H, &s.certainty};
}

// The factors 1 / r^2; zeros if a sum has no number, or a mode has none.
void finish(const double* r, double squares, SumsOfBlock& s, std::uint8_t* without_numbers, std::size_t n) {
    std::array<double, block> zero_if_finite;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        divide_by_square(r[i], squares, entry(s, i));
        s.size_of_H[i] = s.size_of_H[i] / r[i] / r[i];
        zero_if_finite[i] = s.V_re[i] * 0 + s.V_im[i] * 0 + s.Y_re[i] * 0 + s.Y_im[i] * 0 + s.U[i] * 0 + s.G[i] * 0 + s.H[i] * 0 +
                            s.sum_of_squares[i] * 0 + s.size_of_V[i] * 0 + s.size_of_Y[i] * 0 + s.size_of_U[i] * 0 +
                            s.size_of_H[i] * 0;
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (zero_if_finite[i] == 0 && without_numbers[i] == 0) continue;
        without_numbers[i] = 1;
        for (std::array<double, block>* each : all_of(s)) (*each)[i] = 0;
    }
}

void compute(const std::vector<WeightedMode>& modes, std::span<const double> r, ContactSums& sums, std::size_t start) {
    const std::size_t n = std::min(block, r.size() - start);
    const std::span<std::uint8_t> without_numbers(sums.without_numbers.data() + start, n);
    std::ranges::fill(without_numbers, std::uint8_t(0));
    ModeBlock of;
    SumsOfBlock s{};
    const bool known = std::ranges::all_of(modes, [](const WeightedMode& m) { return m.sharpness <= 1; });
    s.certainty.fill(known ? std::numeric_limits<double>::max() : 0.0);
    const auto part = [n](std::array<double, block>& a) { return std::span<double>(a.data(), n); };
    double squares = 0;
    for (const WeightedMode& m : modes) {
        for (std::size_t i = 0; i < n; ++i) of.R[i] = r[start + i] / m.r_n;
        (void)evaluation::mode_functions(part(of.R), m.zeta,
                                         {part(of.v_re), part(of.v_im), part(of.u), part(of.g), without_numbers});
        run_with(
            widest(), [&]() __attribute__((always_inline)) { add(m, of, s, n); });
        squares += m.weights.square;
    }
    finish(r.data() + start, squares, s, without_numbers.data(), n);
    const auto from = all_of(s);
    const auto to = all_of(sums);
    for (std::size_t k = 0; k < from.size(); ++k)
        std::copy_n(from[k]->begin(), n, to[k]->begin() + static_cast<std::ptrdiff_t>(start));
}

// The limits by arrays; how far the roundings of the sums carry, in units of what one of them may be off by, is to stay below
// the margin, and twice as far for two routes.
[[gnu::always_inline]] inline void set_limits(const ContactSums& s, double mu, ContactLimits& limits, std::size_t start,
                                              std::size_t n) {
    const double *V_re = s.V_re.data() + start, *V_im = s.V_im.data() + start, *size_of_V = s.size_of_V.data() + start;
    const double *Y_re = s.Y_re.data() + start, *Y_im = s.Y_im.data() + start, *size_of_Y = s.size_of_Y.data() + start;
    const double *U = s.U.data() + start, *size_of_U = s.size_of_U.data() + start, *certainty = s.certainty.data() + start;
    const double *H = s.H.data() + start, *size_of_H = s.size_of_H.data() + start, *squares = s.sum_of_squares.data() + start;
    double *exact = limits.exact.data() + start, *sticking = limits.sticking.data() + start;
    const double most = limit_margin() / (error_of_size() * static_cast<double>(s.modes));
    const double largest = std::numeric_limits<double>::max();
    double doubts[block];
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const Complex<double> V_dj{V_re[i], V_im[i]}, Y_jj{Y_re[i], Y_im[i]};
        const double S = paper::static_friction_demand(H[i], mu, squares[i]), size_of_S = size_of_H[i] + mu * squares[i];
        exact[i] = paper::friction_ratio_limit(V_dj, U[i], S);
        sticking[i] = evaluation::sticking_limit_by_responses(V_dj, Y_jj, mu);
        const double V = squared_modulus(V_dj), Y = squared_modulus(Y_jj), square = U[i] * U[i] + S * S;
        const double from_U = __builtin_fabs(U[i]) * size_of_U[i] + __builtin_fabs(S) * size_of_S;
        double count = certainty[i] > 0 ? 0.0 : 1.0; // of what is in doubt
        count += size_of_V[i] * size_of_V[i] <= most * most * V ? 0.0 : 1.0;
        count += size_of_Y[i] * size_of_Y[i] <= most * most * Y ? 0.0 : 1.0;
        count += from_U <= most * square ? 0.0 : 1.0;
        count += exact[i] <= largest ? 0.0 : 1.0;
        count += sticking[i] <= largest ? 0.0 : 1.0;
        doubts[i] = count;
    }
    for (std::size_t i = 0; i < n; ++i) limits.certain[start + i] = doubts[i] > 0 ? 0 : 1;
}

bool is_near(const std::vector<double>& ascending, double limit) {
    const auto next = std::ranges::lower_bound(ascending, limit * (1 - limit_margin()));
    return next != ascending.end() && *next <= limit * (1 + limit_margin());
}

} // namespace

ContactModes contact_modes(std::shared_ptr<const ModalBasis<Number>> basis, Mass contact, Mass load) {
    std::vector<ContactMode<Number>> modes = weighted_modes(*basis, contact, load);
    return {std::move(basis), contact, load, std::move(modes)};
}

std::optional<ContactSolution> contact_solution(const ContactModes& modes, const Number& r, const Number& beta) {
    check_frequency_ratio(r.x);
    check_friction_ratio(beta.x);
    const Functions functions = functions_at(modes, r);
    const SumsAtContact<Number> s = sums_at_contact(modes, r, functions);
    const auto limit = [&](double S) { return paper::friction_ratio_limit(Complex<Number>{s.V_re, s.V_im}, s.U, Number(S)); };
    const Number at_start = paper::static_friction_demand(s.H, Number(1), s.sum_of_squares); // (72)
    const double most = (at_start.most() + demand_above_start(modes, r, functions)) * (1 + unit_of<double>());
    if (const std::optional<ContactSolution> found = solution_below(limit(most), s, beta)) return found;
    if (!(beta.least() <= limit(at_start.least()).most())) return std::nullopt; // at a pole it is no number
    const std::optional<Number> searched = limit_by_search(modes, r, functions);
    return searched ? solution_below(*searched, s, beta) : std::nullopt;
}

void contact_sums(const ModalBasis<Bounded<double>>& basis, Mass contact, Mass load, std::span<const double> r, unsigned threads,
                  ContactSums& s) {
    const std::size_t N = basis.r_n.size(), points = r.size();
    check_mass(contact, N, "contact");
    check_mass(load, static_cast<std::size_t>(basis.phi.rows()), "load");
    if (threads < 1) throw InputError("threads", "must be at least 1", std::to_string(threads));
    for (const double each : r) check_frequency_ratio(each);
    for (std::vector<double>* each : all_of(s)) each->resize(points);
    s.modes = N;
    s.without_numbers.resize(points);
    std::vector<WeightedMode> modes;
    for (const ContactMode<Number>& m : weighted_modes(basis, contact, load)) modes.push_back(without_bounds(m));
    parallel_for((points + block - 1) / block, threads, [&](std::size_t b) {
        compute(modes, r, s, b * block);
        return true;
    });
}

void contact_limits(const ContactSums& sums, double mu, unsigned threads, ContactLimits& limits) {
    check_static_friction(mu);
    if (threads < 1) throw InputError("threads", "must be at least 1", std::to_string(threads));
    const std::size_t points = sums.U.size();
    limits.exact.resize(points);
    limits.sticking.resize(points);
    limits.certain.resize(points);
    parallel_for((points + block - 1) / block, threads, [&](std::size_t piece) {
        const std::size_t start = piece * block;
        const std::size_t n = std::min(block, points - start);
        run_with(
            widest(), [&]() __attribute__((always_inline)) { set_limits(sums, mu, limits, start, n); });
        return true;
    });
}

bool limits_tell(const ContactLimits& limits, std::size_t m, const std::vector<double>& ascending) {
    return limits.certain[m] != 0 && !is_near(ascending, limits.exact[m]) && !is_near(ascending, limits.sticking[m]);
}

void contact_amplitudes(const Complex<double>& V_dj, double U_dj, double G_j, std::span<const double> beta,
                        std::span<double> X_j) {
    const std::size_t n = std::min(beta.size(), X_j.size());
    const double* const ratios = beta.data();
    double* const amplitudes = X_j.data();
    run_with(
        widest(), [&]() __attribute__((always_inline)) {
#pragma GCC ivdep
            for (std::size_t i = 0; i < n; ++i)
                amplitudes[i] = evaluation::displacement_transmissibility_of_contact(V_dj, U_dj, G_j, ratios[i]);
        });
}

} // namespace denhartog
