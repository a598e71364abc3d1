#include "denhartog/response/batch_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/errors.hpp"
#include "denhartog/model/point_rules.hpp"
#include "denhartog/parallel.hpp"

namespace denhartog {
namespace {

constexpr std::size_t columns_a_piece = 16;

/// What a column of the map needs of its frequency ratio.
struct Column {
    double V;        ///< |V_dj|
    double U;        ///< |U_dj|
    double G;        ///< G_j
    double exact;    ///< beta_lim
    double sticking; ///< the contact rests from here on; infinite where no friction can hold it
};

void compute(const Column& c, std::span<const double> beta, double* X_j, BatchPoint* points) {
    const double* beta_of = beta.data();
    const std::size_t n = beta.size();
    auto* marks = reinterpret_cast<std::uint8_t*>(points);
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const double lag = beta_of[i] * c.U;
        const double square = (c.V - lag) * (c.V + lag);
        const double X = std::sqrt(square > 0 ? square : 0.0) - beta_of[i] * c.G;
        X_j[i] = beta_of[i] < c.exact ? X : 0.0;
    }
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i)
        marks[i] = static_cast<std::uint8_t>(beta_of[i] < c.exact ? 0 : (beta_of[i] >= c.sticking ? 2 : 1));
}

bool has_numbers(const ContactSums& s, std::span<const BoundaryPoint> limits, std::size_t m) {
    return s.at_pole[m] == 0 && (limits[m].status == PointStatus::answered || limits[m].status == PointStatus::on_boundary);
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

std::optional<double> amplitude_at(const ContactMap& map, std::size_t column, std::size_t row) {
    const std::size_t n = column * map.rows + row;
    if (row >= map.rows || n >= map.points.size() || map.points[n] != BatchPoint::continuous) return std::nullopt;
    return map.X_j[n];
}

ContactMap contact_map(const ContactSums& s, std::span<const BoundaryPoint> limits, const std::vector<double>& beta,
                       unsigned threads) {
    ContactMap map;
    contact_map(s, limits, beta, threads, map);
    return map;
}

void contact_map(const ContactSums& s, std::span<const BoundaryPoint> limits, const std::vector<double>& beta, unsigned threads,
                 ContactMap& map) {
    const std::size_t columns = s.U.size(), rows = beta.size();
    if (limits.size() != columns)
        throw InputError("limits", "must have an entry for each of the " + std::to_string(columns) + " frequency ratios",
                         std::to_string(limits.size()));
    if (threads < 1) throw InputError("threads", "must be at least 1", std::to_string(threads));
    for (const double each : beta) check_friction_ratio(each);
    map.rows = rows;
    map.points.resize(columns * rows);
    map.X_j.resize(columns * rows);
    parallel_for((columns + columns_a_piece - 1) / columns_a_piece, threads, [&](std::size_t piece) {
        const std::size_t end = std::min(columns, (piece + 1) * columns_a_piece);
        for (std::size_t m = piece * columns_a_piece; m < end; ++m) {
            if (!has_numbers(s, limits, m)) {
                std::fill_n(map.points.begin() + static_cast<std::ptrdiff_t>(m * rows), rows, BatchPoint::without_numbers);
                std::fill_n(map.X_j.begin() + static_cast<std::ptrdiff_t>(m * rows), rows, 0.0);
                continue;
            }
            const Column column{std::hypot(s.V_re[m], s.V_im[m]), std::abs(s.U[m]), s.G[m], limits[m].exact,
                                limits[m].sticking.value_or(std::numeric_limits<double>::infinity())};
            compute(column, beta, map.X_j.data() + m * rows, map.points.data() + m * rows);
        }
        return true;
    });
}

} // namespace denhartog
