// Siconos' Moreau-Jean time stepping, a period at a time.
#include <array>
#include <cmath>
#include <numbers>

#include "denhartog/paper_algorithm/contact_equations.hpp"
#include "tests/conformance/adapters/solvers/period.hpp"
#include "tests/speed_accuracy/peers/siconos_steps.hpp"

namespace denhartog::tests {
namespace {

constexpr double still = 1e-12; // a velocity below it is one that the relay holds

/// The matrices row by row.
struct Rows {
    std::vector<double> M, C, K;
};

std::vector<double> rows_of(const Matrix<double>& A) {
    std::vector<double> rows;
    for (Eigen::Index row = 0; row < A.rows(); ++row)
        for (Eigen::Index column = 0; column < A.cols(); ++column) rows.push_back(A(row, column));
    return rows;
}

/// The contact's rests, from its velocities at the steps. A rest starts where the velocity before it, taken as straight, is
/// zero, and ends where the one after it is, taken as a parabola: with mu = 1 the acceleration starts from zero.
class Rests {
public:
    Rests(double step, std::size_t steps) : step_(step), steps_(steps) {}

    [[nodiscard]] std::vector<Stop> of(const std::vector<double>& v, const std::vector<double>& x) const {
        std::vector<Stop> rests;
        for (std::size_t n = 0; n <= steps_; ++n) {
            if (std::abs(v[n]) > still) continue;
            const std::size_t first = n;
            while (n < steps_ && std::abs(v[n + 1]) <= still) ++n;
            if (n > first) rests.push_back({start(v, first), end(v, n), x[first]});
        }
        return rests;
    }

private:
    [[nodiscard]] double start(const std::vector<double>& v, std::size_t n) const {
        if (n < 2 || v[n - 2] * v[n - 1] <= 0 || std::abs(v[n - 2]) <= std::abs(v[n - 1])) return step_ * static_cast<double>(n);
        return step_ * (static_cast<double>(n - 1) + std::min(1.0, v[n - 1] / (v[n - 2] - v[n - 1])));
    }
    [[nodiscard]] double end(const std::vector<double>& v, std::size_t n) const {
        if (n == steps_) return 2 * std::numbers::pi;
        if (n + 2 > steps_ || v[n + 1] * v[n + 2] <= 0 || std::abs(v[n + 2]) <= std::abs(v[n + 1]))
            return step_ * static_cast<double>(n);
        const double a = std::sqrt(std::abs(v[n + 1])), b = std::sqrt(std::abs(v[n + 2]));
        return step_ * (static_cast<double>(n + 1) - std::min(1.0, a / (b - a)));
    }

    double step_;
    std::size_t steps_;
};

PeriodRecord siconos_period(const Rows& rows, const Scene<double>& scene, int steps, const std::vector<double>& y, bool nodes) {
    const std::size_t N = y.size() / 2, j = scene.system.contact.index;
    const double step = 2 * std::numbers::pi / steps;
    SiconosSteps stepping(rows.M, rows.C, rows.K, static_cast<unsigned>(j), static_cast<unsigned>(scene.system.load.index),
                          *scene.beta, step, steps, y);
    PeriodRecord record;
    record.end = y;
    if (nodes) record.nodes.push_back({0, y});
    std::vector<double> v{y[N + j]}, x{y[j]};
    for (int n = 1; n <= steps; ++n) {
        stepping.advance(record.end);
        if (!nodes) continue;
        record.nodes.push_back({step * n, record.end});
        v.push_back(record.end[N + j]);
        x.push_back(record.end[j]);
    }
    if (nodes) record.rests = Rests(step, static_cast<std::size_t>(steps)).of(v, x);
    for (const double each : record.end)
        if (!std::isfinite(each)) record.failure = "the state is no longer finite";
    return record;
}

// Steps a period from coarse to fine, so that transients are gone before steps are many; about as many steps at each.
std::vector<Stage> siconos_stages(const Scene<double>& scene, int most_steps) {
    const NonDimensionalMatrices m = contact_problem(scene).matrices;
    const Rows rows{rows_of(m.M), rows_of(m.C), rows_of(m.K)};
    std::vector<Stage> all;
    constexpr std::array<std::pair<int, int>, 4> steps_and_periods = {{{256, 500}, {1024, 100}, {4096, 30}, {16384, 14}}};
    for (const auto& [steps, periods] : steps_and_periods) {
        if (steps > most_steps) break;
        all.push_back({[rows, scene, steps = steps](const std::vector<double>& y, int nodes) {
                           return siconos_period(rows, scene, steps, y, nodes > 0);
                       },
                       1.0 / steps / steps, periods, steps});
    }
    return all;
}

std::string declines(const Scene<double>& scene) {
    return scene.mu > 1 ? "Siconos' relay has one bound for rest and sliding: mu = 1 only" : "";
}

} // namespace

TimeIntegrator siconos_time_integrator(int most_steps) {
    return {"Siconos, Moreau-Jean, up to " + std::to_string(most_steps) + " steps a period",
            [most_steps](const Scene<double>& scene) { return siconos_stages(scene, most_steps); }, declines};
}

} // namespace denhartog::tests
