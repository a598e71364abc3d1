#include "denhartog/response/batch_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "denhartog/errors.hpp"
#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/model/point_rules.hpp"
#include "denhartog/parallel.hpp"

namespace denhartog {
namespace {

constexpr std::size_t block = 512;

/// Functions of one mode over a block.
struct Block {
    std::array<double, block> R, v_re, v_im, u, g;
};

/// Weights of one mode, the same at every r.
struct ModeWeights {
    double r_n;      ///< natural frequency ratio
    double zeta;     ///< damping ratio
    double load;     ///< phi_j phi_l / r_n^2
    double contact;  ///< phi_j^2 / r_n^2
    double square;   ///< phi_j^2
    double two_zeta; ///< 2 zeta
};

std::vector<ModeWeights> weights(const ModalBasis<double>& basis, Mass contact, Mass load) {
    std::vector<ModeWeights> all;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const double phi_j = basis.phi(contact.index, i) / basis.r_n[i], phi_l = basis.phi(load.index, i) / basis.r_n[i];
        const double whole = basis.phi(contact.index, i);
        all.push_back({basis.r_n[i], basis.zeta[i], phi_j * phi_l, phi_j * phi_j, whole * whole, 2 * basis.zeta[i]});
    }
    return all;
}

[[gnu::always_inline]] inline void add_any(const ModeWeights& m, const Block& of, ContactSums& s, std::size_t start,
                                           std::size_t n) {
    double* V_re = s.V_re.data() + start;
    double* V_im = s.V_im.data() + start;
    double* U = s.U.data() + start;
    double* G = s.G.data() + start;
    double* H = s.H.data() + start;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        V_re[i] += m.load * of.v_re[i];
        V_im[i] += m.load * of.v_im[i];
        U[i] += m.contact * of.u[i];
        G[i] += m.contact * of.g[i];
        H[i] += m.square * (of.g[i] + m.two_zeta * of.R[i] * of.u[i]);
    }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void add_avx2(const ModeWeights& m, const Block& of, ContactSums& s, std::size_t start, std::size_t n) {
    add_any(m, of, s, start, n);
}
#endif

void add(const ModeWeights& m, const Block& of, ContactSums& s, std::size_t start, std::size_t n) {
#if defined(__x86_64__)
    if (evaluation::supported_vectors().back() != evaluation::Vectors::baseline) return add_avx2(m, of, s, start, n);
#endif
    add_any(m, of, s, start, n);
}

void compute(const std::vector<ModeWeights>& modes, const std::vector<double>& r, ContactSums& s, std::size_t start) {
    const std::size_t n = std::min(block, r.size() - start);
    Block of;
    double sum_of_squares = 0;
    for (const ModeWeights& m : modes) {
        for (std::size_t i = 0; i < n; ++i) of.R[i] = r[start + i] / m.r_n;
        const auto part = [n](std::array<double, block>& a) { return std::span<double>(a.data(), n); };
        (void)evaluation::mode_functions(
            std::span<const double>(of.R.data(), n), m.zeta,
            {part(of.v_re), part(of.v_im), part(of.u), part(of.g), std::span<std::uint8_t>(s.at_pole.data() + start, n)});
        add(m, of, s, start, n);
        sum_of_squares += m.square;
    }
    for (std::size_t i = start; i < start + n; ++i) {
        s.H[i] = s.H[i] / r[i] / r[i];
        s.sum_of_squares[i] = sum_of_squares / r[i] / r[i];
        if (!std::isfinite(s.V_re[i] + s.V_im[i] + s.U[i] + s.G[i] + s.H[i] + s.sum_of_squares[i]))
            throw PrecisionError("at r = " + number_to_text(r[i]) + " a sum over the modes is beyond the range of a double");
        if (s.at_pole[i] != 0) s.V_re[i] = s.V_im[i] = s.U[i] = s.G[i] = s.H[i] = s.sum_of_squares[i] = 0;
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
    for (std::vector<double>* each : {&s.V_re, &s.V_im, &s.U, &s.G, &s.H, &s.sum_of_squares}) each->assign(points, 0);
    s.at_pole.assign(points, 0);
    const std::vector<ModeWeights> modes = weights(basis, contact, load);
    parallel_for((points + block - 1) / block, threads, [&](std::size_t b) {
        compute(modes, r, s, b * block);
        return true;
    });
    return s;
}

} // namespace denhartog
