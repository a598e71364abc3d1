// (23), (28) and (29) of one mode over an array of frequency ratios, by vector instructions; R beyond their range are left to
// the scalar forms. Read `compute_any` first.
#include "denhartog/evaluation/mode_arrays.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "denhartog/evaluation/detail/vector_functions.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog::evaluation {
namespace {

constexpr std::size_t block = 512;

std::atomic<long> evaluated{0};
std::atomic<long> scalar_evaluations{0};

/// Constants of a mode, which do not depend on R.
struct ModeConstants {
    ArrayMode<double> mode;
    double w;             ///< the half angle is pi (w - late) / (2 R)
    double late;          ///< see w
    double pole_distance; ///< how far 1 / (2 R) is from a whole number at a pole; out of reach where there is damping
    BracketSeries series;
};

constexpr VectorRange<double> vector_range{least_vector_ratio(), largest_vector_ratio(), least_vector_damping()};

ModeConstants constants_of(double zeta) {
    const AngleOfMode<double> angle = angle_of_mode(zeta);
    return {array_mode(zeta), angle.w, angle.late, zeta > 0 ? 2.0 : 0.5, bracket_series(zeta)};
}

struct Pointers {
    const double* R;
    double* v_re;
    double* v_im;
    double* u;
    double* g;
};

/// Parts of a block that the vectors cannot answer.
struct Left {
    std::int64_t outside; ///< R outside their range
    std::int64_t poles;   ///< results that are not finite
};

/// A block; `large_ratios` says whether there is an R of 5/4 and more, where (29) has its second form.
template <bool large_ratios>
[[gnu::always_inline]] inline Left compute(const ModeConstants& m, const Pointers& p, std::size_t n) {
    std::int64_t outside = 0, poles = 0;
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double R = p.R[i];
        const double x = 0.5 / R;
        const double delta = m.mode.two_pi_zeta * x;
        const HalfAngleProducts<double> h = half_angle_products(R, x, m.w, m.late);
        const Exponential<double> e = exponential_of_negative(-delta);
        double series = 0;
        if constexpr (large_ratios) {
            const double q = 2 * pi<double>() * x;
            series = bracket_over_square(m.series, q * q);
        }
        const ModeFunctions<double> f = array_mode_functions<large_ratios>(R, m.mode, x, e, h, series);
        p.v_re[i] = f.v.re;
        p.v_im[i] = f.v.im;
        p.u[i] = f.u;
        p.g[i] = f.g;
        const double zero_if_finite = f.v.re * 0 + f.v.im * 0 + f.u * 0 + f.g * 0;
        poles += (zero_if_finite == 0 ? 0 : 1) + (__builtin_fabs(x - nearest_whole(x)) == m.pole_distance ? 1 : 0);
        outside += (R >= least_vector_ratio() ? 0 : 1) + (R <= largest_vector_ratio() ? 0 : 1);
    }
    return {outside, poles};
}

[[gnu::always_inline]] inline std::int64_t number_of_large(const double* R, std::size_t n) {
    std::int64_t large = 0;
    for (std::size_t i = 0; i < n; ++i) large += is_large_ratio(R[i]) ? 1 : 0;
    return large;
}

[[gnu::always_inline]] inline Left compute_any(const ModeConstants& m, const Pointers& p, std::size_t n) {
    return number_of_large(p.R, n) > 0 ? compute<true>(m, p, n) : compute<false>(m, p, n);
}

void check_arguments(std::span<const double> R, double zeta, const ModeArrays& out, Vectors vectors) {
    if (!(zeta >= 0 && std::isfinite(zeta))) throw InputError("zeta", "must be finite and at least 0", number_to_text(zeta));
    for (const std::size_t size : {out.v_re.size(), out.v_im.size(), out.u.size(), out.g.size(), out.at_pole.size()})
        if (size != R.size())
            throw InputError("an array of results", "must have the length of R, " + std::to_string(R.size()),
                             std::to_string(size));
    if (std::ranges::find(supported_vectors(), vectors) == supported_vectors().end())
        throw InputError("vectors", "must be of a width that the processor has", name(vectors));
}

void write_zeros(const ModeArrays& out, std::size_t i) {
    out.v_re[i] = out.v_im[i] = out.u[i] = out.g[i] = 0;
    out.at_pole[i] = 1;
}

bool finite(const ModeArrays& out, std::size_t i) {
    return std::isfinite(out.v_re[i]) && std::isfinite(out.v_im[i]) && std::isfinite(out.u[i]) && std::isfinite(out.g[i]);
}

} // namespace

std::string name(Vectors vectors) {
    switch (vectors) {
    case Vectors::baseline: return "baseline";
    case Vectors::avx2: return "avx2";
    case Vectors::avx512: return "avx512";
    }
    return {};
}

const std::vector<Vectors>& supported_vectors() {
    static const std::vector<Vectors> found = [] {
        std::vector<Vectors> widths{Vectors::baseline};
#if defined(__x86_64__)
        const bool fused = __builtin_cpu_supports("fma") != 0; // which both kernels are compiled for
        if (fused && __builtin_cpu_supports("avx2")) widths.push_back(Vectors::avx2);
        if (fused && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
            __builtin_cpu_supports("avx512vl"))
            widths.push_back(Vectors::avx512);
#endif
        return widths;
    }();
    return found;
}

std::size_t mode_functions(std::span<const double> R, double zeta, const ModeArrays& out, Vectors vectors) {
    check_arguments(R, zeta, out, vectors);
    evaluated += static_cast<long>(R.size());
    const ModeConstants m = constants_of(zeta);
    const bool without_vectors = damping_beyond_vectors(zeta, vector_range);
    std::size_t scalar = 0;
    for (std::size_t start = 0; start < R.size(); start += block) {
        const std::size_t n = std::min(block, R.size() - start);
        const Pointers p{R.data() + start, out.v_re.data() + start, out.v_im.data() + start, out.u.data() + start,
                         out.g.data() + start};
        const Left left = run_with(
            vectors, [&]() __attribute__((always_inline)) { return compute_any(m, p, n); });
        if (left.outside == 0 && left.poles == 0 && !without_vectors) continue;
        for (std::size_t i = start; i < start + n; ++i) {
            const bool outside = without_vectors || ratio_beyond_vectors(R[i], vector_range);
            if (outside || !finite(out, i) || (zeta == 0 && at_undamped_pole(R[i]))) {
                if (!(R[i] > 0) || !std::isfinite(R[i]))
                    throw InputError("R", "must be positive and finite", number_to_text(R[i]));
                const ModeFunctions<double> f = mode_functions(R[i], zeta);
                out.v_re[i] = f.v.re;
                out.v_im[i] = f.v.im;
                out.u[i] = f.u;
                out.g[i] = f.g;
                ++scalar;
            }
            if (!finite(out, i)) write_zeros(out, i);
        }
    }
    scalar_evaluations += static_cast<long>(scalar);
    return scalar;
}

long array_mode_evaluations() { return evaluated; }

long array_modes_left_to_scalar_forms() { return scalar_evaluations; }

} // namespace denhartog::evaluation
