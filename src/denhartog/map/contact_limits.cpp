#include "denhartog/map/contact_limits.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/model/point_rules.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/sliding/boundary.hpp"

namespace denhartog {
namespace {

constexpr std::size_t block = 1024;
constexpr double infinite = std::numeric_limits<double>::infinity();

std::atomic<long> left_to_search{0};

// The limits by arrays; how far the roundings of the sums carry, in units of what one of them may be off by, is to stay below
// the margin, and twice as far for two routes.
[[gnu::always_inline]] inline void compute_any(const ContactSums& s, double mu, std::size_t N, ContactLimits& limits,
                                               std::size_t start, std::size_t n) {
    const double *V_re = s.V_re.data() + start, *V_im = s.V_im.data() + start, *size_of_V = s.size_of_V.data() + start;
    const double *Y_re = s.Y_re.data() + start, *Y_im = s.Y_im.data() + start, *size_of_Y = s.size_of_Y.data() + start;
    const double *U_of = s.U.data() + start, *size_of_U = s.size_of_U.data() + start;
    const double *H = s.H.data() + start, *size_of_H = s.size_of_H.data() + start, *squares = s.sum_of_squares.data() + start;
    const double* certainty = s.certainty.data() + start;
    double *exact = limits.exact.data() + start, *sticking = limits.sticking.data() + start;
    auto* source = reinterpret_cast<std::uint8_t*>(limits.source.data() + start);
    const double most = limit_margin() / (0x1p-40 * static_cast<double>(N)); // 2^-40: a thousand times a few eps
    const double inverse_mu = 1 / mu;
    double doubts[block];
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double S = H[i] + mu * squares[i], size_of_S = size_of_H[i] + mu * squares[i];
        const double V = V_re[i] * V_re[i] + V_im[i] * V_im[i], Y = Y_re[i] * Y_re[i] + Y_im[i] * Y_im[i]; // squares
        const double square = U_of[i] * U_of[i] + S * S;
        const double from_U = __builtin_fabs(U_of[i]) * size_of_U[i] + __builtin_fabs(S) * size_of_S;
        exact[i] = std::sqrt(V / square);
        sticking[i] = std::sqrt(V / Y) * inverse_mu;
        const double most_double = std::numeric_limits<double>::max();
        double count = certainty[i] > 0 ? 0.0 : 1.0; // of what is in doubt
        count += size_of_V[i] * size_of_V[i] <= most * most * V ? 0.0 : 1.0;
        count += size_of_Y[i] * size_of_Y[i] <= most * most * Y ? 0.0 : 1.0;
        count += from_U <= most * square ? 0.0 : 1.0;
        count += exact[i] <= most_double ? 0.0 : 1.0;
        count += sticking[i] <= most_double ? 0.0 : 1.0;
        doubts[i] = count;
    }
    for (std::size_t i = 0; i < n; ++i) source[i] = doubts[i] > 0 ? 1 : 0;
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void compute_avx2(const ContactSums& s, double mu, std::size_t N, ContactLimits& limits,
                                          std::size_t start, std::size_t n) {
    compute_any(s, mu, N, limits, start, n);
}
#endif

void compute(const ContactSums& s, double mu, std::size_t N, ContactLimits& limits, std::size_t start, std::size_t n) {
#if defined(__x86_64__)
    if (evaluation::supported_vectors().back() != evaluation::Vectors::baseline) return compute_avx2(s, mu, N, limits, start, n);
#endif
    compute_any(s, mu, N, limits, start, n);
}

void search(const ModalBasis<double>& basis, Mass contact, Mass load, double mu, double r, ContactLimits& limits, std::size_t m) {
    ++left_to_search;
    try {
        const RegimeBoundary<double> b = regime_boundary(mode_sums(basis, contact, load, r), mu);
        limits.exact[m] = b.exact;
        limits.sticking[m] = b.sticking.value_or(infinite);
        limits.source[m] = LimitSource::search;
        return;
    } catch (const DomainError&) {
    } catch (const PrecisionError&) {
    }
    limits.exact[m] = limits.sticking[m] = 0;
    limits.source[m] = LimitSource::none;
}

bool is_near(const std::vector<double>& ascending, double limit) {
    const auto next = std::ranges::lower_bound(ascending, limit * (1 - limit_margin()));
    return next != ascending.end() && *next <= limit * (1 + limit_margin());
}

} // namespace

std::vector<double> approximate_limits(const ContactSums& s, double mu) {
    check_static_friction(mu);
    std::vector<double> limits(s.U.size());
    const double *V_re = s.V_re.data(), *V_im = s.V_im.data(), *U = s.U.data(), *H = s.H.data(),
                 *squares = s.sum_of_squares.data();
    double* limit = limits.data();
    const std::size_t n = limits.size();
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double S = H[i] + mu * squares[i];
        limit[i] = std::sqrt((V_re[i] * V_re[i] + V_im[i] * V_im[i]) / (U[i] * U[i] + S * S));
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (s.at_pole[i] != 0) limit[i] = 0;
        if (!std::isfinite(limit[i])) throw PrecisionError("a limit of the friction ratio is beyond the range of a double");
    }
    return limits;
}

ContactLimits contact_limits(const ModalBasis<double>& basis, Mass contact, Mass load, double mu, const std::vector<double>& r,
                             const ContactSums& sums, unsigned threads) {
    ContactLimits limits;
    contact_limits(basis, contact, load, mu, r, sums, threads, limits);
    return limits;
}

void contact_limits(const ModalBasis<double>& basis, Mass contact, Mass load, double mu, const std::vector<double>& r,
                    const ContactSums& sums, unsigned threads, ContactLimits& limits) {
    check_static_friction(mu);
    if (sums.U.size() != r.size())
        throw InputError("sums", "must have an entry for each of the " + std::to_string(r.size()) + " frequency ratios",
                         std::to_string(sums.U.size()));
    if (threads < 1) throw InputError("threads", "must be at least 1", std::to_string(threads));
    limits.exact.resize(r.size());
    limits.sticking.resize(r.size());
    limits.source.resize(r.size());
    parallel_for((r.size() + block - 1) / block, threads, [&](std::size_t piece) {
        const std::size_t start = piece * block, n = std::min(block, r.size() - start);
        compute(sums, mu, basis.r_n.size(), limits, start, n);
        for (std::size_t m = start; m < start + n; ++m)
            if (limits.source[m] != LimitSource::arrays) search(basis, contact, load, mu, r[m], limits, m);
        return true;
    });
}

std::size_t settle_limits(const ModalBasis<double>& basis, Mass contact, Mass load, double mu, const std::vector<double>& r,
                          const std::vector<double>& beta, ContactLimits& limits) {
    std::vector<double> ascending = beta;
    std::ranges::sort(ascending);
    std::size_t settled = 0;
    for (std::size_t m = 0; m < r.size(); ++m) {
        if (limits.source[m] != LimitSource::arrays) continue;
        if (!is_near(ascending, limits.exact[m]) && !is_near(ascending, limits.sticking[m])) continue;
        search(basis, contact, load, mu, r[m], limits, m);
        ++settled;
    }
    return settled;
}

long limits_left_to_search() { return left_to_search; }

} // namespace denhartog
