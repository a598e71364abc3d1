// How does the contact alone move? For a single question `contact_solution` has (38), (39), and (69) with an upper bound of the
// demand (57) in place of its maximum; without an answer here a point is solved in full. For maps `contact_sums` has (33)-(35), (64),
// (65) over arrays of r, `contact_limits` the boundaries of them, and `contact_amplitudes` (38) over beta.
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

std::vector<ContactMode> weighted_modes(const ModalBasis<Number>& basis, Mass contact, Mass load) {
    std::vector<ContactMode> modes;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i)
        modes.push_back(
            {basis.r_n[i], basis.zeta[i],
             evaluation::array_weights(basis.phi(contact.index, i), basis.phi(load.index, i), basis.r_n[i], basis.zeta[i])});
    return modes;
}

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
bool is_largest_at_start(const Number& R, const ContactMode& m, const evaluation::ModeFunctions<Number>& f) {
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
        if (is_largest_at_start(R, m, f))
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
        const ModeSums<Number> sums = mode_sums(*all.basis, all.contact, all.load, r, functions);
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

constexpr std::size_t block = 256;

evaluation::Vectors widest() { return evaluation::supported_vectors().back(); }

/// Functions of one mode over a block.
struct ModeBlock {
    std::array<double, block> R, v_re, v_im, u, g;
};

/// A mode, with its weights, the same at every r.
struct WeightedMode {
    double r_n;                               ///< natural frequency ratio
    double zeta;                              ///< damping ratio
    evaluation::ArrayWeights<double> weights; ///< in the sums
    evaluation::ArrayWeights<double> sizes;   ///< in the sizes of their terms
    double sharpness; ///< what the error of R makes of (23), (28), (29): a size of the function grows by so many of its square
};

// The weight that a term counts with in the sizes, the error of its own among them.
double size_of_weight(const Bounded<double>& weight) { return std::abs(weight.x) + weight.e / error_of_size(); }

// Of v an error of R makes at most 2 R^2 |v|^2 of its relative size, of u and g about as much; R^2 is below 9/4 or |v| below 1.
double sharpness_of(const Bounded<double>& r_n) { return 5 * r_n.e / r_n.x / error_of_size(); }

WeightedMode without_bounds(const ContactMode& m) {
    const evaluation::ArrayWeights<Number>& w = m.weights;
    return {m.r_n.x,
            m.zeta.x,
            {w.load.x, w.contact.x, w.square.x, w.two_zeta.x},
            {size_of_weight(w.load), size_of_weight(w.contact), size_of_weight(w.square), w.two_zeta.x},
            sharpness_of(m.r_n)};
}

[[gnu::always_inline]] inline double absolute(double x) { return __builtin_fabs(x); }

using SumsOfBlock = SumsOverRatios<std::array<double, block>>;

/// Adds the terms of a mode.
[[gnu::always_inline]] inline void add(const WeightedMode& mode, const ModeBlock& of, SumsOfBlock& s, std::size_t n) {
    const evaluation::ArrayWeights<double> m = mode.weights, size = mode.sizes;
    const double zeta = mode.zeta, sharpness = mode.sharpness;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double R = of.R[i], v_re = of.v_re[i], v_im = of.v_im[i], u = of.u[i], g = of.g[i];
        const double modulus = absolute(v_re) + absolute(v_im), size_of_v = modulus * (1 + sharpness * modulus);
        const double size_of_u = absolute(u) + 1, grown = 1 + sharpness * size_of_u;
        s.V_re[i] += m.load * v_re;
        s.V_im[i] += m.load * v_im;
        s.Y_re[i] += m.contact * v_re;
        s.Y_im[i] += m.contact * v_im;
        s.U[i] += m.contact * u;
        s.G[i] += m.contact * g;
        s.H[i] += evaluation::term_of_H(m, R, u, g);
        s.size_of_V[i] += size.load * size_of_v;
        s.size_of_Y[i] += size.contact * size_of_v;
        s.size_of_U[i] += size.contact * size_of_u * grown;
        s.size_of_H[i] += size.square * (absolute(g) + size.two_zeta * R * absolute(u) + 1) * grown;
        const double certainty = evaluation::certainty_of_start(R, zeta, u, g);
        s.certainty[i] = certainty < s.certainty[i] ? certainty : s.certainty[i];
    }
}

/// The sums by themselves, of a block or of all frequency ratios.
auto all_of(auto& s) {
    return std::array{&s.V_re, &s.V_im,      &s.U,         &s.G,         &s.H,         &s.sum_of_squares, &s.Y_re,
                      &s.Y_im, &s.size_of_V, &s.size_of_Y, &s.size_of_U, &s.size_of_H, &s.certainty};
}

/// The factors 1 / r^2; nothing where a sum has no number, or a mode has none.
void finish(const double* r, double sum_of_squares, SumsOfBlock& s, std::uint8_t* without_numbers, std::size_t n) {
    std::array<double, block> zero_if_finite;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        s.H[i] = s.H[i] / r[i] / r[i];
        s.size_of_H[i] = s.size_of_H[i] / r[i] / r[i];
        s.sum_of_squares[i] = sum_of_squares / r[i] / r[i];
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
    double sum_of_squares = 0;
    for (const WeightedMode& m : modes) {
        for (std::size_t i = 0; i < n; ++i) of.R[i] = r[start + i] / m.r_n;
        (void)evaluation::mode_functions(part(of.R), m.zeta,
                                         {part(of.v_re), part(of.v_im), part(of.u), part(of.g), without_numbers});
        run_with(
            widest(), [&]() __attribute__((always_inline)) { add(m, of, s, n); });
        sum_of_squares += m.weights.square;
    }
    finish(r.data() + start, sum_of_squares, s, without_numbers.data(), n);
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
    std::vector<ContactMode> modes = weighted_modes(*basis, contact, load);
    return {std::move(basis), contact, load, std::move(modes)};
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
    for (const ContactMode& m : weighted_modes(basis, contact, load)) modes.push_back(without_bounds(m));
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
