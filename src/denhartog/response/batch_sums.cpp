#include "denhartog/response/batch_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "denhartog/errors.hpp"
#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/model/point_rules.hpp"
#include "denhartog/parallel.hpp"

namespace denhartog {
namespace {

constexpr std::size_t block = 256;

/// Functions of one mode over a block.
struct Block {
    std::array<double, block> R, v_re, v_im, u, g;
};

/// A mode, with its weights, the same at every r.
struct WeightedMode {
    double r_n;                               ///< natural frequency ratio
    double zeta;                              ///< damping ratio
    evaluation::ArrayWeights<double> weights; ///< in the sums
};

std::vector<WeightedMode> modes_of(const ModalBasis<double>& basis, Mass contact, Mass load) {
    std::vector<WeightedMode> all;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const double phi_j = basis.phi(contact.index, i), phi_l = basis.phi(load.index, i);
        all.push_back({basis.r_n[i], basis.zeta[i], evaluation::array_weights(phi_j, phi_l, basis.r_n[i], basis.zeta[i])});
    }
    return all;
}

[[gnu::always_inline]] inline double absolute(double x) { return __builtin_fabs(x); }

[[gnu::always_inline]] inline void add_any(const WeightedMode& mode, const Block& of, ContactSums& s, std::size_t start,
                                           std::size_t n) {
    const evaluation::ArrayWeights<double> m = mode.weights;
    const double zeta = mode.zeta, load_size = absolute(m.load);
    double *V_re = s.V_re.data() + start, *V_im = s.V_im.data() + start, *size_of_V = s.size_of_V.data() + start;
    double *Y_re = s.Y_re.data() + start, *Y_im = s.Y_im.data() + start, *size_of_Y = s.size_of_Y.data() + start;
    double *U = s.U.data() + start, *G = s.G.data() + start, *H = s.H.data() + start;
    double *size_of_U = s.size_of_U.data() + start, *size_of_H = s.size_of_H.data() + start;
    double* certainty = s.certainty.data() + start;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double R = of.R[i], v_re = of.v_re[i], v_im = of.v_im[i], u = of.u[i], g = of.g[i];
        const double size_of_v = absolute(v_re) + absolute(v_im);
        V_re[i] += m.load * v_re;
        V_im[i] += m.load * v_im;
        Y_re[i] += m.contact * v_re;
        Y_im[i] += m.contact * v_im;
        U[i] += m.contact * u;
        G[i] += m.contact * g;
        H[i] += evaluation::term_of_H(m, R, u, g);
        size_of_V[i] += load_size * size_of_v;
        size_of_Y[i] += m.contact * size_of_v;
        size_of_U[i] += m.contact * (absolute(u) + 1);
        size_of_H[i] += m.square * (absolute(g) + m.two_zeta * R * absolute(u) + 1);
        const double of_mode = evaluation::certainty_of_start(R, zeta, u, g);
        certainty[i] = of_mode < certainty[i] ? of_mode : certainty[i];
    }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void add_avx2(const WeightedMode& m, const Block& of, ContactSums& s, std::size_t start, std::size_t n) {
    add_any(m, of, s, start, n);
}

[[gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]] void
add_avx512(const WeightedMode& m, const Block& of, ContactSums& s, std::size_t start, std::size_t n) {
    add_any(m, of, s, start, n);
}
#endif

void add(const WeightedMode& m, const Block& of, ContactSums& s, std::size_t start, std::size_t n) {
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

void compute(const std::vector<WeightedMode>& modes, const std::vector<double>& r, ContactSums& s, std::size_t start) {
    const std::size_t n = std::min(block, r.size() - start);
    Block of;
    double sum_of_squares = 0;
    for (const WeightedMode& m : modes) {
        for (std::size_t i = 0; i < n; ++i) of.R[i] = r[start + i] / m.r_n;
        const auto part = [n](std::array<double, block>& a) { return std::span<double>(a.data(), n); };
        (void)evaluation::mode_functions(
            std::span<const double>(of.R.data(), n), m.zeta,
            {part(of.v_re), part(of.v_im), part(of.u), part(of.g), std::span<std::uint8_t>(s.at_pole.data() + start, n)});
        add(m, of, s, start, n);
        sum_of_squares += m.weights.square;
    }
    for (std::size_t i = start; i < start + n; ++i) {
        s.H[i] = s.H[i] / r[i] / r[i];
        s.size_of_H[i] = s.size_of_H[i] / r[i] / r[i];
        s.sum_of_squares[i] = sum_of_squares / r[i] / r[i];
        double all = 0;
        for (const std::vector<double>* each :
             {&s.V_re, &s.V_im, &s.U, &s.G, &s.H, &s.sum_of_squares, &s.size_of_V, &s.size_of_Y, &s.size_of_U, &s.size_of_H})
            all += (*each)[i];
        if (!std::isfinite(all))
            throw PrecisionError("at r = " + number_to_text(r[i]) + " a sum over the modes is beyond the range of a double");
        if (s.at_pole[i] == 0) continue;
        for (std::vector<double>* each : all_of(s)) (*each)[i] = 0;
        s.certainty[i] = 0;
    }
}

} // namespace

ContactSums contact_sums(const ModalBasis<double>& basis, Mass contact, Mass load, const std::vector<double>& r,
                         unsigned threads) {
    const std::size_t N = basis.r_n.size(), points = r.size();
    const std::string rule = "must be a mass from 1 to " + std::to_string(N);
    if (contact.index >= N) throw InputError("contact", rule, std::to_string(contact.index + 1));
    if (load.index >= N) throw InputError("load", rule, std::to_string(load.index + 1));
    if (threads < 1) throw InputError("threads", "must be at least 1", std::to_string(threads));
    for (const double each : r) check_frequency_ratio(each);
    ContactSums s;
    for (std::vector<double>* each : all_of(s)) each->assign(points, 0);
    s.certainty.assign(points, std::numeric_limits<double>::max());
    s.at_pole.assign(points, 0);
    const std::vector<WeightedMode> modes = modes_of(basis, contact, load);
    parallel_for((points + block - 1) / block, threads, [&](std::size_t b) {
        compute(modes, r, s, b * block);
        return true;
    });
    return s;
}

} // namespace denhartog
