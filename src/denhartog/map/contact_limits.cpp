#include "denhartog/map/contact_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

constexpr std::size_t block = 1024;

// The limits by arrays; how far the roundings of the sums carry, in units of what one of them may be off by, is to stay below
// the margin, and twice as far for two routes.
[[gnu::always_inline]] inline void compute_any(const ContactSums& s, double mu, ContactLimits& limits, std::size_t start,
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
[[gnu::target("avx2")]] void compute_avx2(const ContactSums& s, double mu, ContactLimits& limits, std::size_t start,
                                          std::size_t n) {
    compute_any(s, mu, limits, start, n);
}
#endif

void compute(const ContactSums& s, double mu, ContactLimits& limits, std::size_t start, std::size_t n) {
#if defined(__x86_64__)
    if (evaluation::supported_vectors().back() != evaluation::Vectors::baseline) return compute_avx2(s, mu, limits, start, n);
#endif
    compute_any(s, mu, limits, start, n);
}

bool is_near(const std::vector<double>& ascending, double limit) {
    const auto next = std::ranges::lower_bound(ascending, limit * (1 - limit_margin()));
    return next != ascending.end() && *next <= limit * (1 + limit_margin());
}

} // namespace

void contact_limits(const ContactSums& sums, double mu, unsigned threads, ContactLimits& limits) {
    check_static_friction(mu);
    if (threads < 1) throw InputError("threads", "must be at least 1", std::to_string(threads));
    const std::size_t points = sums.U.size();
    limits.exact.resize(points);
    limits.sticking.resize(points);
    limits.certain.resize(points);
    parallel_for((points + block - 1) / block, threads, [&](std::size_t piece) {
        const std::size_t start = piece * block;
        compute(sums, mu, limits, start, std::min(block, points - start));
        return true;
    });
}

bool limits_tell(const ContactLimits& limits, std::size_t m, const std::vector<double>& ascending) {
    return limits.certain[m] != 0 && !is_near(ascending, limits.exact[m]) && !is_near(ascending, limits.sticking[m]);
}

} // namespace denhartog
