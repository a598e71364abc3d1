#include "tests/speed_accuracy/array_functions.hpp"

#include <cmath>

namespace denhartog::tests {
namespace {

[[gnu::always_inline]] inline void functions(const double* x, double* exps, double* sines, double* cosines, std::size_t n) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) exps[i] = std::exp(-std::abs(x[i]));
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) sines[i] = std::sin(x[i]);
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) cosines[i] = std::cos(x[i]);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void functions_avx2(const double* x, double* exps, double* sines, double* cosines, std::size_t n) {
    functions(x, exps, sines, cosines, n);
}

[[gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]] void
functions_avx512(const double* x, double* exps, double* sines, double* cosines, std::size_t n) {
    functions(x, exps, sines, cosines, n);
}
#endif

} // namespace

void bare_functions(std::span<const double> x, std::span<double> exps, std::span<double> sines, std::span<double> cosines) {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        return functions_avx512(x.data(), exps.data(), sines.data(), cosines.data(), x.size());
    if (__builtin_cpu_supports("avx2")) return functions_avx2(x.data(), exps.data(), sines.data(), cosines.data(), x.size());
#endif
    functions(x.data(), exps.data(), sines.data(), cosines.data(), x.size());
}

void bare_roots(std::span<const double> x, std::span<double> roots) {
    const double* in = x.data();
    double* out = roots.data();
#pragma GCC ivdep
    for (std::size_t i = 0; i < x.size(); ++i) out[i] = std::sqrt(in[i]);
}

} // namespace denhartog::tests
