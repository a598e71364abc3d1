#include "denhartog/map/contact_amplitudes.hpp"

#include <algorithm>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mode_arrays.hpp"

namespace denhartog {
namespace {

[[gnu::always_inline]] inline void compute_any(const Complex<double>& V_dj, double U_dj, double G_j, const double* beta,
                                               double* X_j, std::size_t n) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) X_j[i] = evaluation::displacement_transmissibility_of_contact(V_dj, U_dj, G_j, beta[i]);
}

#if defined(__x86_64__)
// Every processor with these vectors has the fused multiply-add; it stands in the form itself, and in no other place.
[[gnu::target("avx2,fma")]] void compute_avx2(const Complex<double>& V_dj, double U_dj, double G_j, const double* beta,
                                              double* X_j, std::size_t n) {
    compute_any(V_dj, U_dj, G_j, beta, X_j, n);
}
#endif

} // namespace

void contact_amplitudes(const Complex<double>& V_dj, double U_dj, double G_j, std::span<const double> beta,
                        std::span<double> X_j) {
    const std::size_t n = std::min(beta.size(), X_j.size());
#if defined(__x86_64__)
    if (evaluation::supported_vectors().back() != evaluation::Vectors::baseline)
        return compute_avx2(V_dj, U_dj, G_j, beta.data(), X_j.data(), n);
#endif
    compute_any(V_dj, U_dj, G_j, beta.data(), X_j.data(), n);
}

} // namespace denhartog
