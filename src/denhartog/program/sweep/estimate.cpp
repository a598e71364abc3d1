#include "denhartog/program/sweep/estimate.hpp"

#include <algorithm>
#include <atomic>

#include "denhartog/program/sweep/processor_time.hpp"
#include "denhartog/sweep/pieces.hpp"

namespace denhartog::program {
namespace {

constexpr std::size_t most_places = 32;
constexpr std::size_t points_of_a_place = 4096;
constexpr double most_seconds = 4;

// One system of a chunk, with as many of its columns as a place may have points.
sweep::Box place_in(const sweep::Plan& plan, std::size_t n) {
    sweep::Box box = plan.box(plan.chunks * (2 * n + 1) / (2 * most_places));
    std::size_t points = 1;
    for (std::size_t d = box.count.size(); d-- > 0;) {
        const std::string& name = plan.dimensions[d].name;
        const bool friction = name == "beta" || name == "friction", frequency = name == "r" || name == "frequency_hz";
        const std::size_t all = box.count[d];
        if (friction)
            points *= all;
        else
            box.count[d] = frequency ? std::clamp<std::size_t>(points_of_a_place / points, 1, all) : 1;
        // Another part of the chunk at each place.
        box.start[d] += (all - box.count[d]) * ((7 * n) % most_places) / most_places;
    }
    return box;
}

} // namespace

nlohmann::ordered_json estimate_of(const sweep::Plan& plan) {
    const sweep::SceneAt scenes(plan);
    const std::atomic<bool> stop{false};
    double seconds = 0, least = 0, most = 0;
    std::size_t points = 0, places = 0;
    // In an order in which any first few are spread over the study as well.
    for (; places < most_places && (places < 2 || seconds < most_seconds); ++places) {
        const sweep::Box box = place_in(plan, (places * 13) % most_places);
        const double start = processor_seconds();
        static_cast<void>(points_of(plan, scenes, box, stop));
        const double here = processor_seconds() - start;
        const double of_point = here / static_cast<double>(box.points());
        least = places == 0 ? of_point : std::min(least, of_point);
        most = std::max(most, of_point);
        seconds += here;
        points += box.points();
    }
    const double mean = seconds / static_cast<double>(points);
    return {{"places_measured", places},    {"points_measured", points},
            {"seconds_a_point", mean},      {"least_seconds_a_point", least},
            {"most_seconds_a_point", most}, {"hours_of_one_core", mean * static_cast<double>(plan.points) / 3600},
            {"bytes", bytes_of_study(plan)}};
}

} // namespace denhartog::program
