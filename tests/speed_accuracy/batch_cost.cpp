#include "tests/speed_accuracy/batches.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <thread>

#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/sliding/contact_alone.hpp"
#include "tests/speed_accuracy/chart_survey.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::tests {
namespace {

constexpr double enough = 1e4; // items from which on a batch counts for the exponent

/// The least of stretches of 2 ms on one thread, of single runs on several.
double least_time(int repeats, unsigned threads, const std::function<void()>& run) {
    double least = std::numeric_limits<double>::infinity();
    for (int n = 0; n < (threads == 1 ? repeats : 20 * repeats); ++n) {
        const double start = now(threads);
        int runs = 0;
        do {
            run();
            ++runs;
        } while (threads == 1 && now(threads) - start < 2e6);
        least = std::min(least, (now(threads) - start) / runs);
    }
    return least;
}

/// Modes of N equal masses and springs in closed form: no eigenproblem stands before the batch.
ModalBasis<Bounded<double>> equal_masses(std::size_t N) {
    ModalBasis<Bounded<double>> basis;
    const double quarter = pi<double>() / 2, width = static_cast<double>(2 * N + 1);
    basis.phi.resize(static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
    for (std::size_t i = 0; i < N; ++i) {
        const double angle = static_cast<double>(2 * i + 1) / width * quarter;
        basis.r_n.push_back(2 * std::sin(angle));
        basis.zeta.push_back(0.02);
        for (std::size_t k = 0; k < N; ++k)
            basis.phi(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) =
                2 / std::sqrt(width) * std::sin(2 * static_cast<double>(k + 1) * angle);
    }
    return basis;
}

} // namespace

double now(unsigned threads) {
    if (threads == 1) return 1e9 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<double> grid(double from, double to, std::size_t n) {
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(n - 1);
    return x;
}

double least_boundary(const Scene<double>& scene, const std::vector<double>& r) {
    double least = std::numeric_limits<double>::infinity();
    for (const BoundaryPoint& each : boundary_curves(scene, r)) least = std::min(least, each.exact);
    return least;
}

double BatchCost::items() const { return static_cast<double>(ratios) * static_cast<double>(rows == 0 ? modes : rows); }

std::vector<BatchCost> batch_costs(int repeats) {
    std::vector<BatchCost> costs;
    const auto sums_cost = [&](const std::string& series, std::size_t N, std::size_t ratios, unsigned threads) {
        const ModalBasis<Bounded<double>> basis = equal_masses(N);
        const std::vector<double> r = grid(0.1, 2.5, ratios);
        ContactSums sums;
        const auto run = [&] { contact_sums(basis, Mass{N / 2}, Mass{0}, r, threads, sums); };
        const long before = evaluation::array_mode_evaluations();
        run();
        const long evaluations = evaluation::array_mode_evaluations() - before;
        costs.push_back({series, N, ratios, 0, threads, least_time(repeats, threads, run), evaluations});
    };
    for (const std::size_t N : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000}) sums_cost("modes", N, 2000, 1);
    for (const std::size_t ratios : {100, 1000, 10000, 100000, 1000000}) sums_cost("frequency ratios", 5, ratios, 1);
    Scene<double> scene;
    scene.system = five_masses<double>(3, 0.02);
    const Mass contact = scene.system.contact;
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const std::atomic<bool> never{false};
    const double least = least_boundary(scene, grid(1, 2.5, 3200));
    for (const std::size_t side : {100, 200, 500, 1000, 2000, 3200}) {
        const std::vector<double> r = grid(1, 2.5, side);
        MapRequest request{r, grid(0, 0.999 * least, side), {contact}, MapStart::rest, 1};
        for (const unsigned threads : cores > 1 ? std::vector<unsigned>{1, cores} : std::vector<unsigned>{1}) {
            request.threads = threads;
            const long before = evaluation::array_mode_evaluations();
            (void)regime_map(scene, request, never);
            const long evaluations = evaluation::array_mode_evaluations() - before;
            const double time = least_time(repeats, threads, [&] { (void)regime_map(scene, request, never); });
            costs.push_back({threads == 1 ? "points" : "points on all cores", 5, side, side, threads, time, evaluations});
        }
    }
    return costs;
}

double fitted_exponent(const std::vector<BatchCost>& costs, const std::string& series) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const BatchCost& cost : costs) {
        if (cost.series != series || cost.items() < enough) continue;
        const double a = std::log(cost.items()), b = std::log(cost.nanoseconds);
        n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

Table table_of(const std::vector<BatchCost>& costs) {
    Table table{
        "Cost of a batch: sums over modes after the eigen-solve; points of a whole map, its eigen-solves included",
        {"varied", "modes", "frequency ratios", "friction ratios", "threads", "microseconds", "ns an item", "modes evaluated"},
        {},
        "An item is an (r, mode), or an (r, beta) where there are friction ratios; least of the repeats: processor time on one "
        "thread, by the clock on several."};
    std::vector<std::string> series;
    for (const BatchCost& cost : costs) {
        table.rows.push_back({cost.series, std::to_string(cost.modes), std::to_string(cost.ratios), std::to_string(cost.rows),
                              std::to_string(cost.threads), digits(cost.nanoseconds / 1000),
                              digits(cost.nanoseconds / cost.items()), std::to_string(cost.evaluations)});
        if (series.empty() || series.back() != cost.series)
            if (std::ranges::find(series, cost.series) == series.end()) series.push_back(cost.series);
    }
    for (const std::string& each : series)
        table.note += "\nFitted exponent, " + each + ": " + digits(fitted_exponent(costs, each), "%.3f") + ".";
    return table;
}

std::string batch_cost_csv(const std::vector<BatchCost>& costs, int repeats) {
    const std::string conditions = std::to_string(repeats) + ",\"" + __VERSION__ + "\",\"" + processor_name() + "\"," +
                                   evaluation::name(evaluation::supported_vectors().back()) + "\n";
    std::string csv = "varied,modes,frequency_ratios,friction_ratios,threads,nanoseconds,items,modes_evaluated,repeats,compiler,"
                      "processor,vectors\n";
    for (const BatchCost& cost : costs)
        csv += "\"" + cost.series + "\"," + std::to_string(cost.modes) + "," + std::to_string(cost.ratios) + "," +
               std::to_string(cost.rows) + "," + std::to_string(cost.threads) + "," + digits(cost.nanoseconds, "%.1f") + "," +
               digits(cost.items(), "%.0f") + "," + std::to_string(cost.evaluations) + "," + conditions;
    return csv;
}

} // namespace denhartog::tests
