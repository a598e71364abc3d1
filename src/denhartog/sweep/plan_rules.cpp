#include "denhartog/sweep/plan_rules.hpp"

#include <algorithm>

#include "denhartog/map/map_in_units.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/other_documents.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sweep/scene_at.hpp"

namespace denhartog::sweep {
namespace {

std::string text_of(VariedQuantity q) { return Target{q, {}, false}.name(); }

// Given as an axis or drawn; a drawn factor comes on top. That nothing varies twice was checked before.
void check_one(const Study& study, VariedQuantity ratio, VariedQuantity in_units) {
    const VariedQuantity wanted = study.in_units() ? in_units : ratio;
    const VariedQuantity other = study.in_units() ? ratio : in_units;
    if (study.axis(other) || study.variable(other))
        throw InputError(
            text_of(other),
            "must not be given together with " + text_of(study.in_units() ? VariedQuantity::friction : VariedQuantity::r), "");
    const Axis* axis = study.axis(wanted);
    const Variable* drawn = study.variable(wanted);
    if (axis && axis->target.factor)
        throw InputError(axis->target.name(), "must be drawn, as a factor of the axis " + text_of(wanted), "an axis");
    if (!axis && (!drawn || drawn->target.factor))
        throw InputError(text_of(wanted), "must be an axis or a variable that is drawn", "nothing");
}

std::vector<std::string> fields_of(const Study& study) {
    std::vector<std::string> fields{"stops_per_period", "periods"};
    for (const Mass k : study.masses)
        for (const char* kind : {"amplitude_", "phase_"}) fields.push_back(kind + std::to_string(k.index + 1));
    return fields;
}

void check_of(const Plan& plan, const Reduction& r, std::size_t n) {
    std::vector<std::string> known = fields_of(plan.study);
    for (std::size_t m = 0; m < n; ++m) {
        const Reduction& before = plan.study.reductions[m];
        if (before.statistic == Statistic::maximum || before.statistic == Statistic::minimum) known.push_back(before.name);
    }
    if (std::ranges::find(known, r.of) != known.end()) return;
    const std::vector<std::string_view> words(known.begin(), known.end());
    std::string all;
    for (const std::string& each : known) all += (all.empty() ? "" : ", ") + each;
    throw InputError(r.name, "must be of one of " + all + did_you_mean(r.of, words), r.of);
}

} // namespace

void check_columns(const Study& study) {
    check_one(study, VariedQuantity::r, VariedQuantity::frequency_hz);
    check_one(study, VariedQuantity::beta, VariedQuantity::friction);
}

void check_reductions(const Plan& plan) {
    const std::vector<std::string> own{"regime", "status", "stops_per_period", "periods", "sample"};
    for (std::size_t n = 0; n < plan.study.reductions.size(); ++n) {
        const Reduction& r = plan.study.reductions[n];
        const bool taken = plan.reduction(r.name) != &r || std::ranges::find(own, r.name) != own.end() ||
                           r.name.starts_with("amplitude_") || r.name.starts_with("phase_") ||
                           plan.place_of(r.name) != plan.dimensions.size();
        if (taken) throw InputError("reduce", "must give every reduction a name of its own", r.name);
        if (r.statistic != Statistic::share) check_of(plan, r, n);
        const std::vector<std::size_t> there = plan.dimensions_of(r.statistic == Statistic::share ? "" : r.of);
        for (const std::string& name : r.over) {
            const std::size_t d = plan.place_of(name);
            if (std::ranges::find(there, d) == there.end()) {
                std::vector<std::string_view> words;
                for (const std::size_t each : there) words.push_back(plan.dimensions[each].name);
                throw InputError(r.name, "must be over axes that there are" + (words.empty() ? "" : did_you_mean(name, words)),
                                 name);
            }
            if (std::ranges::count(r.over, name) > 1) throw InputError(r.name, "must not be twice over the same axis", name);
        }
    }
}

void check_scenes(const Plan& plan) {
    const Study& study = plan.study;
    const SceneAt scene_at(plan);
    for (const Axis& axis : study.axes) {
        for (const double value : axis.values) {
            switch (axis.target.quantity) {
            case VariedQuantity::r: check_frequency_ratio(value); break;
            case VariedQuantity::beta:
            case VariedQuantity::friction: check_friction_ratio(value); break;
            case VariedQuantity::frequency_hz: break;
            default: static_cast<void>(scene_at.with(axis.target, value));
            }
        }
    }
    if (study.samples)
        for (const Variable& each : study.samples->variables)
            static_cast<void>(scene_at.with(each.target, quantile(each.marginal, 0.5)));
    const Scene<double> scene = scene_at.unvaried();
    if (const Axis* axis = study.axis(VariedQuantity::frequency_hz)) static_cast<void>(frequencies_in_units(scene, axis->values));
}

} // namespace denhartog::sweep
