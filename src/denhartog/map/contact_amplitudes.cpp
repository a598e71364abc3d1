#include "denhartog/map/contact_amplitudes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/evaluation/vector_functions.hpp"
#include "denhartog/model/point_rules.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/parallel.hpp"

namespace denhartog {
namespace {

constexpr std::size_t columns_a_piece = 16;

/// What a column of the map needs of its frequency ratio.
struct Column {
    double V;        ///< |V_dj|
    double U;        ///< U_dj
    double G;        ///< G_j
    double exact;    ///< beta_lim
    double sticking; ///< the contact rests from here on; infinite where no friction can hold it
};

struct Row {
    const double* beta;
    std::size_t n;
};

[[gnu::always_inline]] inline double root(const Column& c, double beta) {
    const double square = evaluation::square_of_contact_root(c.V, c.U, beta);
    return std::sqrt(square > 0 ? square : 0.0);
}

[[gnu::always_inline]] inline void amplitudes_any(const Column& c, const Row& row, double* X_j, std::uint8_t* marks) {
    const double* beta = row.beta;
#pragma GCC ivdep
    for (std::size_t i = 0; i < row.n; ++i) {
        const double X = root(c, beta[i]) - beta[i] * c.G;
        X_j[i] = beta[i] < c.exact ? X : 0.0;
    }
#pragma GCC ivdep
    for (std::size_t i = 0; i < row.n; ++i)
        marks[i] = static_cast<std::uint8_t>(beta[i] < c.exact ? 0 : (beta[i] >= c.sticking ? 2 : 1));
}

[[gnu::always_inline]] inline void phases_any(const Column& c, double argument, const Row& row, double* phi_j) {
    const double* beta = row.beta;
    const double circle = 2 * pi<double>();
#pragma GCC ivdep
    for (std::size_t i = 0; i < row.n; ++i) {
        const double t = evaluation::tangent_of_half_delay(c.V, c.U, root(c, beta[i]), beta[i]);
        const double delay = 2 * evaluation::arctangent_of_fraction(t);
        const double phi = -delay - argument;
        const double turned = phi > pi<double>() ? phi - circle : (phi < -pi<double>() ? phi + circle : phi);
        phi_j[i] = beta[i] < c.exact ? turned : 0.0;
    }
}

using Amplitudes = void (*)(const Column&, const Row&, double*, std::uint8_t*);
using Phases = void (*)(const Column&, double, const Row&, double*);

void amplitudes_baseline(const Column& c, const Row& row, double* X_j, std::uint8_t* marks) {
    amplitudes_any(c, row, X_j, marks);
}
void phases_baseline(const Column& c, double a, const Row& row, double* phi_j) { phases_any(c, a, row, phi_j); }

#if defined(__x86_64__)
[[gnu::target("avx2")]] void amplitudes_avx2(const Column& c, const Row& row, double* X_j, std::uint8_t* marks) {
    amplitudes_any(c, row, X_j, marks);
}

[[gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]] void phases_avx512(const Column& c, double a, const Row& row,
                                                                                        double* phi_j) {
    phases_any(c, a, row, phi_j);
}

[[gnu::target("avx2")]] void phases_avx2(const Column& c, double a, const Row& row, double* phi_j) {
    phases_any(c, a, row, phi_j);
}
#endif

bool has(evaluation::Vectors vectors) {
    return std::ranges::find(evaluation::supported_vectors(), vectors) != evaluation::supported_vectors().end();
}

Amplitudes widest_amplitudes() {
#if defined(__x86_64__)
    if (has(evaluation::Vectors::avx2)) return amplitudes_avx2;
#endif
    return amplitudes_baseline;
}

Phases widest_phases() {
#if defined(__x86_64__)
    if (has(evaluation::Vectors::avx512)) return phases_avx512;
    if (has(evaluation::Vectors::avx2)) return phases_avx2;
#endif
    return phases_baseline;
}

Column column_of(const ContactSums& s, std::size_t m, double exact, double sticking) {
    return {std::sqrt(s.V_re[m] * s.V_re[m] + s.V_im[m] * s.V_im[m]), s.U[m], s.G[m], exact, sticking};
}

template <class Work>
void for_columns(std::size_t columns, unsigned threads, const Work& work) {
    parallel_for((columns + columns_a_piece - 1) / columns_a_piece, threads, [&](std::size_t piece) {
        const std::size_t end = std::min(columns, (piece + 1) * columns_a_piece);
        for (std::size_t m = piece * columns_a_piece; m < end; ++m) work(m);
        return true;
    });
}

void check_threads(unsigned threads) {
    if (threads < 1) throw InputError("threads", "must be at least 1", std::to_string(threads));
}

} // namespace

std::optional<double> amplitude_at(const ContactMap& map, std::size_t column, std::size_t row) {
    const std::size_t n = column * map.rows + row;
    if (row >= map.rows || n >= map.points.size() || map.points[n] != BatchPoint::continuous) return std::nullopt;
    return map.X_j[n];
}

ContactMap contact_map(const ModalBasis<double>& basis, Mass contact, Mass load, double mu, const std::vector<double>& r,
                       const std::vector<double>& beta, unsigned threads) {
    for (const double each : beta) check_friction_ratio(each);
    const ContactSums sums = contact_sums(basis, contact, load, r, threads);
    ContactLimits limits = contact_limits(basis, contact, load, mu, r, sums, threads);
    (void)settle_limits(basis, contact, load, mu, r, beta, limits);
    ContactMap map;
    contact_map(sums, limits, beta, threads, map);
    return map;
}

void contact_map(const ContactSums& s, const ContactLimits& limits, const std::vector<double>& beta, unsigned threads,
                 ContactMap& map) {
    const std::size_t columns = s.U.size(), rows = beta.size();
    if (limits.source.size() != columns || limits.exact.size() != columns || limits.sticking.size() != columns)
        throw InputError("limits", "must have an entry for each of the " + std::to_string(columns) + " frequency ratios",
                         std::to_string(limits.source.size()));
    check_threads(threads);
    for (const double each : beta) check_friction_ratio(each);
    map.rows = rows;
    map.points.resize(columns * rows);
    map.X_j.resize(columns * rows);
    const Amplitudes amplitudes = widest_amplitudes();
    for_columns(columns, threads, [&](std::size_t m) {
        const auto start = static_cast<std::ptrdiff_t>(m * rows);
        if (s.at_pole[m] != 0 || limits.source[m] == LimitSource::none) {
            std::fill_n(map.points.begin() + start, rows, BatchPoint::without_numbers);
            std::fill_n(map.X_j.begin() + start, rows, 0.0);
            return;
        }
        amplitudes(column_of(s, m, limits.exact[m], limits.sticking[m]), {beta.data(), rows}, map.X_j.data() + start,
                   reinterpret_cast<std::uint8_t*>(map.points.data() + start));
    });
}

void contact_phases(const ContactSums& s, const ContactMap& map, const std::vector<double>& beta, unsigned threads,
                    std::vector<double>& phi_j) {
    const std::size_t columns = s.U.size(), rows = beta.size();
    check_threads(threads);
    if (map.rows != rows || map.points.size() != columns * rows)
        throw InputError("the map", "must have a point for each of the " + std::to_string(columns * rows) + " of the grid",
                         std::to_string(map.points.size()));
    phi_j.resize(columns * rows);
    const Phases phases = widest_phases();
    for_columns(columns, threads, [&](std::size_t m) {
        const BatchPoint* points = map.points.data() + m * rows;
        double* phi = phi_j.data() + m * rows;
        phases(column_of(s, m, std::numeric_limits<double>::infinity(), 0), std::atan2(s.V_im[m], s.V_re[m]), {beta.data(), rows},
               phi);
        for (std::size_t n = 0; n < rows; ++n) phi[n] = points[n] == BatchPoint::continuous ? phi[n] : 0.0;
    });
}

void amplitudes_of_contact(const Complex<double>& V_dj, double U_dj, double G_j, std::span<const double> beta,
                           std::span<double> X_j) {
    const Column column{modulus(V_dj), U_dj, G_j, 0, 0};
    const double* of = beta.data();
    double* X = X_j.data();
    const std::size_t n = std::min(beta.size(), X_j.size());
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) X[i] = root(column, of[i]) - of[i] * G_j;
}

} // namespace denhartog
