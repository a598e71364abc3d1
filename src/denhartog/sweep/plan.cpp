#include "denhartog/sweep/plan.hpp"

#include <algorithm>
#include <numeric>

#include "denhartog/number/errors.hpp"
#include "denhartog/sweep/plan_rules.hpp"

namespace denhartog::sweep {
namespace {

// The largest chunk: its values are held in memory.
constexpr std::size_t most_points_in_memory = std::size_t(1) << 24;

bool is_of_columns(VariedQuantity q) {
    return q == VariedQuantity::r || q == VariedQuantity::frequency_hz || q == VariedQuantity::beta ||
           q == VariedQuantity::friction;
}

std::vector<Dimension> dimensions_of_study(const Study& study) {
    std::vector<Dimension> all;
    for (const Axis& each : study.axes)
        if (!is_of_columns(each.target.quantity)) all.push_back({each.target.name(), each.values.size(), each.values});
    if (study.samples) all.push_back({"sample", study.samples->count, {}});
    for (const VariedQuantity q :
         {VariedQuantity::r, VariedQuantity::frequency_hz, VariedQuantity::beta, VariedQuantity::friction})
        if (const Axis* axis = study.axis(q)) all.push_back({axis->target.name(), axis->values.size(), axis->values});
    return all;
}

// Whether no chunk may divide an axis.
std::vector<bool> undivided(const Plan& plan) {
    std::vector<bool> whole(plan.dimensions.size(), false);
    for (std::size_t d = 0; d < whole.size(); ++d)
        whole[d] = plan.dimensions[d].name == "beta" || plan.dimensions[d].name == "friction";
    const auto mark = [&](const Reduction& r) {
        for (const std::string& name : r.over) whole[plan.place_of(name)] = true;
    };
    for (const Reduction& each : plan.study.reductions) {
        if (each.statistic == Statistic::quantiles && !each.bins) mark(each);
        if (const Reduction* before = plan.reduction(each.of)) mark(*before);
    }
    return whole;
}

void divide(Plan& plan) {
    const std::vector<bool> whole = undivided(plan);
    plan.chunk.assign(whole.size(), 1);
    std::size_t points = 1;
    for (std::size_t d = 0; d < whole.size(); ++d) {
        if (!whole[d]) continue;
        plan.chunk[d] = plan.dimensions[d].size;
        if (plan.chunk[d] > most_points_in_memory / points)
            throw InputError("reduce",
                             "must not keep more than " + std::to_string(most_points_in_memory) +
                                 " points together: columns of friction and axes of exact quantiles are not split; quantiles "
                                 "with bins are taken from a histogram, which any chunks add up to",
                             plan.dimensions[d].name + " with " + std::to_string(plan.chunk[d]));
        points *= plan.chunk[d];
    }
    for (std::size_t d = whole.size(); d-- > 0;) {
        if (whole[d]) continue;
        const std::size_t size = plan.dimensions[d].size;
        const std::size_t most = std::clamp<std::size_t>(plan.study.points_of_a_chunk / points, 1, size);
        const std::size_t boxes = (size + most - 1) / most;
        plan.chunk[d] = (size + boxes - 1) / boxes;
        points *= plan.chunk[d];
    }
    plan.chunks = 1;
    for (std::size_t d = 0; d < whole.size(); ++d) {
        plan.boxes.push_back((plan.dimensions[d].size + plan.chunk[d] - 1) / plan.chunk[d]);
        if (plan.boxes[d] > most_chunks / plan.chunks)
            throw InputError("points_of_a_chunk", "must leave at most " + std::to_string(most_chunks) + " chunks",
                             std::to_string(plan.study.points_of_a_chunk));
        plan.chunks *= plan.boxes[d];
    }
}

} // namespace

std::size_t Box::points() const { return std::accumulate(count.begin(), count.end(), std::size_t(1), std::multiplies<>()); }

std::size_t Plan::place_of(const std::string& name) const {
    const auto found = std::ranges::find(dimensions, name, &Dimension::name);
    return static_cast<std::size_t>(found - dimensions.begin());
}

Box Plan::box(std::size_t K) const {
    Box box;
    box.place.resize(dimensions.size());
    for (std::size_t d = dimensions.size(); d-- > 0;) {
        box.place[d] = K % boxes[d];
        K /= boxes[d];
    }
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
        box.start.push_back(box.place[d] * chunk[d]);
        box.count.push_back(std::min(chunk[d], dimensions[d].size - box.start[d]));
    }
    return box;
}

bool Plan::splits(const Reduction& r) const {
    return std::ranges::any_of(r.over, [this](const std::string& name) { return splits(place_of(name)); });
}

const Reduction* Plan::reduction(const std::string& name) const {
    const auto found = std::ranges::find(study.reductions, name, &Reduction::name);
    return found == study.reductions.end() ? nullptr : &*found;
}

std::vector<std::size_t> Plan::dimensions_of(const std::string& name) const {
    const Reduction* r = reduction(name);
    if (!r) {
        std::vector<std::size_t> all(dimensions.size());
        std::iota(all.begin(), all.end(), std::size_t(0));
        return all;
    }
    std::vector<std::size_t> left = dimensions_of(r->of);
    std::erase_if(left, [&](std::size_t d) { return std::ranges::find(r->over, dimensions[d].name) != r->over.end(); });
    return left;
}

Plan plan_of(const Study& study) {
    Plan plan;
    plan.study = study;
    plan.dimensions = dimensions_of_study(study);
    check_columns(study);
    plan.points = 1;
    constexpr std::size_t most_points = std::size_t(1) << 60;
    for (const Dimension& each : plan.dimensions) {
        if (each.size > most_points / plan.points)
            throw InputError("the study", "must have at most 2^60 points", each.name + " with " + std::to_string(each.size));
        plan.points *= each.size;
    }
    check_reductions(plan);
    divide(plan);
    check_scenes(plan);
    return plan;
}

} // namespace denhartog::sweep
