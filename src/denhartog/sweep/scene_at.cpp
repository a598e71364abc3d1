#include "denhartog/sweep/scene_at.hpp"

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/scene_json.hpp"

namespace denhartog::sweep {
namespace {

using nlohmann::json;

json without_point(json scene) {
    for (const char* key : {"r", "beta", "friction", "frequency", "frequency_hz"}) scene.erase(key);
    return scene;
}

const char* key_of(const json& scene, VariedQuantity q) {
    switch (q) {
    case VariedQuantity::mu: return "mu";
    case VariedQuantity::zeta: return "damping_ratios";
    case VariedQuantity::mass: return scene.contains("masses") ? "masses" : "mass_ratios";
    case VariedQuantity::stiffness: return scene.contains("stiffnesses") ? "stiffnesses" : "stiffness_ratios";
    case VariedQuantity::contact: return "contact";
    case VariedQuantity::load: return "load";
    default: return nullptr; // a point, which is no part of the scene here
    }
}

// A scene may write a number as text; it is one, since the scene was read before.
double as_number(const json& x) {
    double number = 0;
    if (x.is_string())
        static_cast<void>(number_from_text(x.get_ref<const std::string&>(), number));
    else
        number = x.get<double>();
    return number;
}

void change(json& scene, const Target& target, double value, std::size_t masses) {
    const char* key = key_of(scene, target.quantity);
    if (key == nullptr) return;
    if (target.quantity == VariedQuantity::contact || target.quantity == VariedQuantity::load) {
        scene[key] = static_cast<std::uint64_t>(value);
        return;
    }
    if (target.quantity == VariedQuantity::mu) {
        scene[key] = target.factor ? value * (scene.contains(key) ? as_number(scene[key]) : 1) : value;
        return;
    }
    if (!scene.contains(key)) throw InputError(target.name(), std::string("must be varied in scenes that have ") + key, "");
    json& list = scene[key];
    if (!list.is_array()) list = json::array_t(target.quantity == VariedQuantity::zeta ? masses : 1, list);
    if (!list.empty() && list[0].is_array())
        throw InputError(target.name(), "must be varied where the scene has a list", "a matrix");
    if (target.entry && *target.entry >= list.size())
        throw InputError(target.name(), "must be one of " + std::to_string(list.size()) + " entries",
                         std::to_string(*target.entry + 1));
    for (std::size_t n = 0; n < list.size(); ++n)
        if (!target.entry || *target.entry == n) list[n] = target.factor ? value * as_number(list[n]) : value;
}

} // namespace

SceneAt::SceneAt(const Plan& plan)
    : plan_(plan), scene_(without_point(plan.study.scene)), masses_(number_of_masses(scene_from_json<double>(scene_).system)),
      sample_(plan.place_of("sample")),
      samples_(plan.study.samples ? plan.study.samples->sampling : Sampling::sobol,
               plan.study.samples ? plan.study.samples->count : 1, plan.study.samples ? plan.study.samples->seed : 0,
               plan.study.samples ? plan.study.samples->variables.size() : 0) {}

double SceneAt::drawn(std::uint64_t sample, std::size_t variable) const {
    return quantile(plan_.study.samples->variables[variable].marginal, samples_.at(sample, variable));
}

SystemAt SceneAt::at(const std::vector<std::size_t>& point) const {
    const Study& study = plan_.study;
    json scene = scene_;
    SystemAt system;
    const bool units = study.in_units();
    const VariedQuantity frequency = units ? VariedQuantity::frequency_hz : VariedQuantity::r,
                         friction = units ? VariedQuantity::friction : VariedQuantity::beta;
    if (const Axis* axis = study.axis(frequency)) system.frequency = axis->values;
    if (const Axis* axis = study.axis(friction)) system.friction = axis->values;
    for (const Axis& axis : study.axes) {
        if (axis.target.quantity == frequency || axis.target.quantity == friction) continue;
        change(scene, axis.target, axis.values[point[plan_.place_of(axis.target.name())]], masses_);
    }
    for (std::size_t n = 0; study.samples && n < study.samples->variables.size(); ++n) {
        const Target& target = study.samples->variables[n].target;
        const double value = drawn(point[sample_], n);
        if (target.quantity == frequency || target.quantity == friction) {
            std::vector<double>& column = target.quantity == frequency ? system.frequency : system.friction;
            if (!target.factor) column = {value};
            if (target.factor)
                for (double& each : column) each *= value;
        } else {
            change(scene, target, value, masses_);
        }
    }
    system.scene = scene_from_json<double>(scene);
    return system;
}

Scene<double> SceneAt::with(const Target& target, double value) const {
    json scene = scene_;
    change(scene, target, value, masses_);
    return scene_from_json<double>(scene);
}

Scene<double> SceneAt::unvaried() const { return scene_from_json<double>(scene_); }

} // namespace denhartog::sweep
