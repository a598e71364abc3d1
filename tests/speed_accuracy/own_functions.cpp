#include "tests/speed_accuracy/array_functions.hpp"

#include "denhartog/evaluation/detail/vector_functions.hpp"

namespace denhartog::tests {
namespace {

[[gnu::always_inline]] inline void functions(const double* x, double* exps, double* products, double* squares, std::size_t n) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double size = __builtin_fabs(x[i]);
        const evaluation::Exponential<double> e = evaluation::exponential_of_negative(-size);
        const evaluation::HalfAngleProducts<double> h = evaluation::half_angle_products(size, 0.5 / size, 1, 0);
        exps[i] = e.head * e.tail;
        products[i] = h.sine_cosine;
        squares[i] = h.cosine_square;
    }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void functions_avx2(const double* x, double* exps, double* products, double* squares, std::size_t n) {
    functions(x, exps, products, squares, n);
}

[[gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]] void
functions_avx512(const double* x, double* exps, double* products, double* squares, std::size_t n) {
    functions(x, exps, products, squares, n);
}
#endif

} // namespace

void own_functions(std::span<const double> x, std::span<double> exps, std::span<double> products, std::span<double> squares) {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        return functions_avx512(x.data(), exps.data(), products.data(), squares.data(), x.size());
    if (__builtin_cpu_supports("avx2")) return functions_avx2(x.data(), exps.data(), products.data(), squares.data(), x.size());
#endif
    functions(x.data(), exps.data(), products.data(), squares.data(), x.size());
}

} // namespace denhartog::tests
