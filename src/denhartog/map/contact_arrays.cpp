#include "denhartog/map/contact_arrays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

constexpr std::size_t block = 256;

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

std::vector<WeightedMode> modes_of(const ModalBasis<Bounded<double>>& basis, Mass contact, Mass load) {
    std::vector<WeightedMode> all;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const evaluation::ArrayWeights<Bounded<double>> w =
            evaluation::array_weights(basis.phi(contact.index, i), basis.phi(load.index, i), basis.r_n[i], basis.zeta[i]);
        all.push_back({basis.r_n[i].x,
                       basis.zeta[i].x,
                       {w.load.x, w.contact.x, w.square.x, w.two_zeta.x},
                       {size_of_weight(w.load), size_of_weight(w.contact), size_of_weight(w.square), w.two_zeta.x},
                       sharpness_of(basis.r_n[i])});
    }
    return all;
}

[[gnu::always_inline]] inline double absolute(double x) { return __builtin_fabs(x); }

[[gnu::always_inline]] inline void add_any(const WeightedMode& mode, const ModeBlock& of, ContactSums& s, std::size_t start,
                                           std::size_t n) {
    const evaluation::ArrayWeights<double> m = mode.weights;
    const evaluation::ArrayWeights<double> size = mode.sizes;
    const double zeta = mode.zeta, sharpness = mode.sharpness;
    double *V_re = s.V_re.data() + start, *V_im = s.V_im.data() + start, *size_of_V = s.size_of_V.data() + start;
    double *Y_re = s.Y_re.data() + start, *Y_im = s.Y_im.data() + start, *size_of_Y = s.size_of_Y.data() + start;
    double *U = s.U.data() + start, *G = s.G.data() + start, *H = s.H.data() + start;
    double *size_of_U = s.size_of_U.data() + start, *size_of_H = s.size_of_H.data() + start;
    double* certainty = s.certainty.data() + start;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double R = of.R[i], v_re = of.v_re[i], v_im = of.v_im[i], u = of.u[i], g = of.g[i];
        const double modulus = absolute(v_re) + absolute(v_im), size_of_v = modulus * (1 + sharpness * modulus);
        const double size_of_u = absolute(u) + 1, grown = 1 + sharpness * size_of_u;
        V_re[i] += m.load * v_re;
        V_im[i] += m.load * v_im;
        Y_re[i] += m.contact * v_re;
        Y_im[i] += m.contact * v_im;
        U[i] += m.contact * u;
        G[i] += m.contact * g;
        H[i] += evaluation::term_of_H(m, R, u, g);
        size_of_V[i] += size.load * size_of_v;
        size_of_Y[i] += size.contact * size_of_v;
        size_of_U[i] += size.contact * size_of_u * grown;
        size_of_H[i] += size.square * (absolute(g) + size.two_zeta * R * absolute(u) + 1) * grown;
        const double certainty_of_mode = evaluation::certainty_of_start(R, zeta, u, g);
        certainty[i] = certainty_of_mode < certainty[i] ? certainty_of_mode : certainty[i];
    }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void add_avx2(const WeightedMode& m, const ModeBlock& of, ContactSums& s, std::size_t start,
                                      std::size_t n) {
    add_any(m, of, s, start, n);
}

[[gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]] void
add_avx512(const WeightedMode& m, const ModeBlock& of, ContactSums& s, std::size_t start, std::size_t n) {
    add_any(m, of, s, start, n);
}
#endif

void add(const WeightedMode& m, const ModeBlock& of, ContactSums& s, std::size_t start, std::size_t n) {
#if defined(__x86_64__)
    if (evaluation::supported_vectors().back() == evaluation::Vectors::avx512) return add_avx512(m, of, s, start, n);
    if (evaluation::supported_vectors().back() == evaluation::Vectors::avx2) return add_avx2(m, of, s, start, n);
#endif
    add_any(m, of, s, start, n);
}

/// The sums, all but the certainty.
std::vector<std::vector<double>*> all_of(ContactSums& s) {
    return {&s.V_re, &s.V_im, &s.U,         &s.G,         &s.H,         &s.sum_of_squares,
            &s.Y_re, &s.Y_im, &s.size_of_V, &s.size_of_Y, &s.size_of_U, &s.size_of_H};
}

/// The factors 1 / r^2; nothing where a sum has no number.
void finish(std::span<const double> r, double sum_of_squares, ContactSums& s, std::size_t start, std::size_t n) {
    const double* ratio = r.data() + start;
    double *H = s.H.data() + start, *size_of_H = s.size_of_H.data() + start, *squares = s.sum_of_squares.data() + start;
    const double *V_re = s.V_re.data() + start, *V_im = s.V_im.data() + start, *Y_re = s.Y_re.data() + start,
                 *Y_im = s.Y_im.data() + start, *U = s.U.data() + start, *G = s.G.data() + start;
    const double *size_of_V = s.size_of_V.data() + start, *size_of_Y = s.size_of_Y.data() + start,
                 *size_of_U = s.size_of_U.data() + start;
    std::array<double, block> zero_if_finite;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        H[i] = H[i] / ratio[i] / ratio[i];
        size_of_H[i] = size_of_H[i] / ratio[i] / ratio[i];
        squares[i] = sum_of_squares / ratio[i] / ratio[i];
        zero_if_finite[i] = V_re[i] * 0 + V_im[i] * 0 + Y_re[i] * 0 + Y_im[i] * 0 + U[i] * 0 + G[i] * 0 + H[i] * 0 +
                            squares[i] * 0 + size_of_V[i] * 0 + size_of_Y[i] * 0 + size_of_U[i] * 0 + size_of_H[i] * 0;
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (zero_if_finite[i] == 0 && s.without_numbers[start + i] == 0) continue;
        s.without_numbers[start + i] = 1;
        for (std::vector<double>* each : all_of(s)) (*each)[start + i] = 0;
        s.certainty[start + i] = 0;
    }
}

void compute(const std::vector<WeightedMode>& modes, std::span<const double> r, ContactSums& s, std::size_t start) {
    const std::size_t n = std::min(block, r.size() - start);
    ModeBlock of;
    const auto at = static_cast<std::ptrdiff_t>(start);
    for (std::vector<double>* each : all_of(s)) std::fill_n(each->begin() + at, n, 0.0);
    const bool known = std::ranges::all_of(modes, [](const WeightedMode& m) { return m.sharpness <= 1; });
    std::fill_n(s.certainty.begin() + at, n, known ? std::numeric_limits<double>::max() : 0.0);
    std::fill_n(s.without_numbers.begin() + at, n, std::uint8_t(0));
    double sum_of_squares = 0;
    for (const WeightedMode& m : modes) {
        for (std::size_t i = 0; i < n; ++i) of.R[i] = r[start + i] / m.r_n;
        const auto part = [n](std::array<double, block>& a) { return std::span<double>(a.data(), n); };
        (void)evaluation::mode_functions(
            std::span<const double>(of.R.data(), n), m.zeta,
            {part(of.v_re), part(of.v_im), part(of.u), part(of.g), std::span<std::uint8_t>(s.without_numbers.data() + start, n)});
        add(m, of, s, start, n);
        sum_of_squares += m.weights.square;
    }
    finish(r, sum_of_squares, s, start, n);
}

// The limits by arrays; how far the roundings of the sums carry, in units of what one of them may be off by, is to stay below
// the margin, and twice as far for two routes.
[[gnu::always_inline]] inline void set_limits_any(const ContactSums& s, double mu, ContactLimits& limits, std::size_t start,
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

#if defined(__x86_64__)
[[gnu::target("avx2")]] void set_limits_avx2(const ContactSums& s, double mu, ContactLimits& limits, std::size_t start,
                                             std::size_t n) {
    set_limits_any(s, mu, limits, start, n);
}
#endif

void set_limits(const ContactSums& s, double mu, ContactLimits& limits, std::size_t start, std::size_t n) {
#if defined(__x86_64__)
    if (evaluation::supported_vectors().back() != evaluation::Vectors::baseline) return set_limits_avx2(s, mu, limits, start, n);
#endif
    set_limits_any(s, mu, limits, start, n);
}

bool is_near(const std::vector<double>& ascending, double limit) {
    const auto next = std::ranges::lower_bound(ascending, limit * (1 - limit_margin()));
    return next != ascending.end() && *next <= limit * (1 + limit_margin());
}

[[gnu::always_inline]] inline void set_amplitudes_any(const Complex<double>& V_dj, double U_dj, double G_j, const double* beta,
                                                      double* X_j, std::size_t n) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) X_j[i] = evaluation::displacement_transmissibility_of_contact(V_dj, U_dj, G_j, beta[i]);
}

#if defined(__x86_64__)
// Every processor with these vectors has the fused multiply-add; it stands in the form itself, and in no other place.
[[gnu::target("avx2,fma")]] void set_amplitudes_avx2(const Complex<double>& V_dj, double U_dj, double G_j, const double* beta,
                                                     double* X_j, std::size_t n) {
    set_amplitudes_any(V_dj, U_dj, G_j, beta, X_j, n);
}
#endif

} // namespace

void contact_sums(const ModalBasis<Bounded<double>>& basis, Mass contact, Mass load, std::span<const double> r, unsigned threads,
                  ContactSums& s) {
    const std::size_t N = basis.r_n.size(), points = r.size();
    check_mass(contact, N, "contact");
    check_mass(load, static_cast<std::size_t>(basis.phi.rows()), "load");
    if (threads < 1) throw InputError("threads", "must be at least 1", std::to_string(threads));
    for (const double each : r) check_frequency_ratio(each);
    for (std::vector<double>* each : all_of(s)) each->resize(points);
    s.certainty.resize(points);
    s.modes = N;
    s.without_numbers.resize(points);
    const std::vector<WeightedMode> modes = modes_of(basis, contact, load);
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
        set_limits(sums, mu, limits, start, std::min(block, points - start));
        return true;
    });
}

bool limits_tell(const ContactLimits& limits, std::size_t m, const std::vector<double>& ascending) {
    return limits.certain[m] != 0 && !is_near(ascending, limits.exact[m]) && !is_near(ascending, limits.sticking[m]);
}

void contact_amplitudes(const Complex<double>& V_dj, double U_dj, double G_j, std::span<const double> beta,
                        std::span<double> X_j) {
    const std::size_t n = std::min(beta.size(), X_j.size());
#if defined(__x86_64__)
    if (evaluation::supported_vectors().back() != evaluation::Vectors::baseline)
        return set_amplitudes_avx2(V_dj, U_dj, G_j, beta.data(), X_j.data(), n);
#endif
    set_amplitudes_any(V_dj, U_dj, G_j, beta.data(), X_j.data(), n);
}

} // namespace denhartog
