/// @file
/// @brief (23), (28), (29) of one mode over an array of frequency ratios, as separate arrays that vectors can be read from.
///
/// The forms are those of `batch_forms.hpp`, one reduction of 1/R without rounding as in `mode.hpp`. What the vectors do not
/// answer (ratios and damping ratios outside their range, results that are not finite) is left to the scalar forms and counted. A
/// processor with wider vectors gives the same digits.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "denhartog/evaluation/mode.hpp"

namespace denhartog::evaluation {

/// @brief Arrays of one length for the functions of a mode.
struct ModeArrays {
    std::span<double> v_re;          ///< real part of (23)
    std::span<double> v_im;          ///< imaginary part of (23)
    std::span<double> u;             ///< first damping function, Eq. (28)
    std::span<double> g;             ///< second damping function, Eq. (29)
    std::span<std::uint8_t> at_pole; ///< 1 if one of them is not finite, and all four are 0; elsewhere left as it was
};

/// @brief Width of the vectors.
enum class Vectors : std::uint8_t {
    baseline, ///< what the build is for, 128 bits on x86-64
    avx2,     ///< 256 bits
    avx512    ///< 512 bits
};

/// @brief Name of a width. @param vectors the width @return e.g. `avx2`
[[nodiscard]] std::string name(Vectors vectors);

/// @brief The widths that this processor has. @return in ascending order; `baseline` is always there
[[nodiscard]] const std::vector<Vectors>& supported_vectors();

#if defined(__x86_64__)
/// @brief Runs a kernel, which is inlined, with 256 bits. The fused multiply-add is used where a form asks for it, and in no other
/// place. @param kernel what is run @return what it returns
template <class Kernel>
[[gnu::target("avx2,fma")]] auto run_with_avx2(const Kernel& kernel) {
    return kernel();
}
/// @brief Runs a kernel, which is inlined, with 512 bits. @param kernel what is run @return what it returns
template <class Kernel>
[[gnu::target("avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512")]] auto run_with_avx512(const Kernel& kernel) {
    return kernel();
}
#endif

/// @brief Runs a kernel, an inlined function without arguments, with vectors of a width that the processor has: the digits are the
/// same with each. @param vectors the width @param kernel what is run @return what it returns
template <class Kernel>
auto run_with(Vectors vectors, const Kernel& kernel) {
#if defined(__x86_64__)
    if (vectors == Vectors::avx512) return run_with_avx512(kernel);
    if (vectors == Vectors::avx2) return run_with_avx2(kernel);
#endif
    return kernel();
}

/// @brief Frequency ratios from here on go through the vectors. @return the least of them
[[nodiscard]] constexpr double least_vector_ratio() { return 0x1p-26; }

/// @brief Frequency ratios up to here go through the vectors. @return the largest of them
[[nodiscard]] constexpr double largest_vector_ratio() { return 0x1p200; }

/// @brief Damping ratios from here on go through the vectors, and 0. @return the least of them
[[nodiscard]] constexpr double least_vector_damping() { return 0x1p-500; }

/// @brief \f$ v_{di} \f$, \f$ u_{di} \f$ and \f$ g_i \f$ of one mode over an array of R.
/// @eq{23,28,29}  @derivation{forms/batch_forms}  @domain{R > 0, 0 <= zeta < 1}
/// @param R        modal frequency ratios, Eq. (22)
/// @param zeta     modal damping ratio
/// @param out      arrays as long as R
/// @param vectors  width of the vectors, one that this processor has; the widest if none is chosen
/// @return         how many R were left to the scalar forms
/// @throws         InputError if zeta is negative or not finite, an R is not positive and finite, an array has another
///                 length than R, or the processor has no vectors of that width
std::size_t mode_functions(std::span<const double> R, double zeta, const ModeArrays& out,
                           Vectors vectors = supported_vectors().back());

/// @brief Number of modes evaluated over arrays since the program started, one a frequency ratio; tests gate on it.
/// @return the count, over all threads
[[nodiscard]] long array_mode_evaluations();

/// @brief Number of values that were left to the scalar forms; tests bound it.
/// @return the count, over all threads
[[nodiscard]] long array_modes_left_to_scalar_forms();

} // namespace denhartog::evaluation
