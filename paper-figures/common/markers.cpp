#include "markers.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>

#include "denhartog/number/parallel.hpp"

namespace denhartog::figures {

std::vector<Marker> markers(const Figure& figure, const System<double>& system, double mu,
                            const std::vector<std::pair<double, double>>& points, const PaperSettings& settings) {
    std::vector<Marker> found(points.size());
    std::atomic<std::size_t> done{0};
    parallel_for(points.size(), threads(), [&](std::size_t n) {
        Scene<double> scene;
        scene.system = system;
        scene.mu = mu;
        scene.r = points[n].first;
        scene.beta = points[n].second;
        found[n] = {points[n].first, points[n].second, paper_algorithm(scene, settings)};
        if (found[n].motion.status != IntegrationStatus::complete)
            throw std::runtime_error("r = " + text(*scene.r) + ", beta = " + text(*scene.beta) + ": " + found[n].motion.reason);
        figure.progress(++done, points.size());
        return true;
    });
    return found;
}

unsigned threads() { return std::max(1U, std::thread::hardware_concurrency()); }

} // namespace denhartog::figures
