#include "denhartog/sweep/study/study.hpp"

#include <algorithm>

#include "denhartog/sweep/study/study_items.hpp"

namespace denhartog::sweep {

std::string Target::name() const {
    std::string text(name_of(quantity));
    if (entry) text += "_" + std::to_string(*entry + 1);
    return factor ? text + "_factor" : text;
}

std::vector<double> Bins::edges() const {
    if (logarithmic) return logarithmic_values(from, to, count + 1);
    std::vector<double> values;
    for (std::size_t n = 0; n <= count; ++n)
        values.push_back(n == count ? to : from + (to - from) * (static_cast<double>(n) / static_cast<double>(count)));
    return values;
}

const Axis* Study::axis(VariedQuantity q) const {
    const auto found = std::ranges::find_if(axes, [q](const Axis& each) { return each.target.quantity == q; });
    return found == axes.end() ? nullptr : &*found;
}

const Variable* Study::variable(VariedQuantity q) const {
    if (!samples) return nullptr;
    const auto found = std::ranges::find_if(samples->variables, [q](const Variable& each) { return each.target.quantity == q; });
    return found == samples->variables.end() ? nullptr : &*found;
}

bool Study::in_units() const {
    return axis(VariedQuantity::frequency_hz) || axis(VariedQuantity::friction) || variable(VariedQuantity::frequency_hz) ||
           variable(VariedQuantity::friction);
}

bool Study::needs_phases() const {
    return answers.phases || std::ranges::any_of(reductions, [](const Reduction& each) { return each.of.starts_with("phase_"); });
}

} // namespace denhartog::sweep
