#include "denhartog/sweep/points.hpp"

#include <cmath>

#include "denhartog/map/map_in_units.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/solve/solve.hpp"

namespace denhartog::sweep {
namespace {

constexpr std::int8_t no_scene = 5;

// The columns of one system within a chunk.
struct Columns {
    SystemAt system;
    MapRequest request;
    FrequenciesInUnits in_units; // where the study is in units
};

Columns columns_of(const Plan& plan, SystemAt system, const Box& box) {
    Columns columns;
    const std::size_t frequency = plan.place_of(plan.study.in_units() ? "frequency_hz" : "r");
    if (frequency < plan.dimensions.size()) {
        const auto first = system.frequency.begin() + static_cast<std::ptrdiff_t>(box.start[frequency]);
        system.frequency = {first, first + static_cast<std::ptrdiff_t>(box.count[frequency])};
    }
    columns.request.masses = plan.study.masses;
    columns.request.start = plan.study.start;
    columns.request.effort = plan.study.effort;
    if (plan.study.in_units()) {
        columns.in_units = frequencies_in_units(system.scene, system.frequency);
    } else {
        columns.request.r = system.frequency;
        columns.request.beta = system.friction;
    }
    columns.system = std::move(system);
    return columns;
}

RegimeMap map_of(const Plan& plan, const Columns& c, const std::atomic<bool>& stop) {
    if (!plan.study.in_units()) return regime_map(c.system.scene, c.request, stop);
    return map_in_units(c.system.scene, c.in_units, c.system.friction, c.request, stop, {});
}

// The phases of the points that have numbers.
void add_phases(const Plan& plan, const Columns& c, const RegimeMap& map, std::size_t first, const std::atomic<bool>& stop,
                Points& points) {
    Question question;
    question.asked = Asked::phase;
    if (plan.study.masses.size() == 1) question.mass = plan.study.masses.front();
    const PreparedSystem prepared = prepare(scene_source(c.system.scene), question, Prepared::every_regime);
    const std::size_t rows = c.system.friction.size();
    for (std::size_t n = 0; n < map.points.size() && !stop; ++n) {
        if (!has_numbers(map.points[n].status)) continue;
        const std::size_t column = n / rows;
        const double friction = c.system.friction[n % rows];
        const double r = plan.study.in_units() ? c.in_units.r[column] : c.request.r[column];
        const double beta = plan.study.in_units() ? friction / c.in_units.force[column] : friction;
        try {
            std::optional<QuestionEffort> effort;
            if (plan.study.effort) effort.emplace(0, plan.study.effort);
            const Solution s = solve(prepared, r, beta, question);
            for (std::size_t m = 0; m < plan.study.masses.size(); ++m)
                if (const auto& phase = mass_of(s, plan.study.masses[m]).phase) points.phases[m][first + n] = phase->value;
        } catch (const DomainError&) {
        } catch (const PrecisionError&) {
        }
    }
}

void put(const RegimeMap& map, std::size_t first, Points& points) {
    const std::size_t masses = points.amplitudes.size();
    for (std::size_t n = 0; n < map.points.size(); ++n) {
        const MapPoint& p = map.points[n];
        const bool known = has_numbers(p.status);
        points.status[first + n] = static_cast<std::int8_t>(p.status);
        points.regime[first + n] = known ? static_cast<std::int8_t>(p.regime) : std::int8_t(-1);
        points.stops[first + n] = known ? p.stops : -1;
        points.periods[first + n] = known ? p.periods : -1;
        for (std::size_t m = 0; m < masses; ++m) points.amplitudes[m][first + n] = map.amplitudes[n * masses + m];
    }
}

Points empty_points(const Plan& plan, std::size_t count) {
    Points points;
    points.status.assign(count, no_scene);
    points.regime.assign(count, -1);
    points.stops.assign(count, -1);
    points.periods.assign(count, -1);
    points.amplitudes.assign(plan.study.masses.size(), std::vector<double>(count, std::nan("")));
    if (plan.study.needs_phases()) points.phases = points.amplitudes;
    return points;
}

} // namespace

Points points_of(const Plan& plan, const SceneAt& scenes, const Box& box, const std::atomic<bool>& stop) {
    const std::size_t count = box.points();
    Points points = empty_points(plan, count);
    std::size_t outer = plan.dimensions.size(), of_system = 1; // axes before those of the columns; points of a system
    for (const char* name : {"friction", "beta", "frequency_hz", "r"})
        if (plan.place_of(name) < plan.dimensions.size()) of_system *= box.count[--outer];
    std::vector<std::size_t> point = box.start;
    for (std::size_t first = 0; first < count && !stop; first += of_system) {
        std::optional<Columns> columns;
        try {
            columns = columns_of(plan, scenes.at(point), box);
            const RegimeMap map = map_of(plan, *columns, stop);
            put(map, first, points);
            if (map.complete && plan.study.needs_phases()) add_phases(plan, *columns, map, first, stop, points);
        } catch (const InputError&) {
            // The sample has numbers that make no scene: plan_of has tried every value of every axis.
        }
        for (std::size_t d = outer; d-- > 0;) {
            if (++point[d] < box.start[d] + box.count[d]) break;
            point[d] = box.start[d];
        }
    }
    points.complete = !stop;
    return points;
}

} // namespace denhartog::sweep
