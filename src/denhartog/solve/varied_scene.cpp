#include "denhartog/solve/varied_scene.hpp"

#include <cmath>
#include <limits>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/solve/decision.hpp"

namespace denhartog {

using Json = nlohmann::json;

nlohmann::json::json_pointer place_of(const std::string& key, const nlohmann::json& scene) {
    const std::size_t slash = key.find('/');
    const std::string name = key.substr(0, slash);
    const auto refuse = [&](const std::string& rule) { throw InputError("vary", rule, key); };
    if (!scene.contains(name)) refuse("must be a key of the scene that has a number");
    std::string path = pointer_step(name);
    const Json& value = scene.at(name);
    if (value.is_array() && !value.empty() && value.front().is_array())
        refuse("must not name an entry of a matrix, because one changes with its mirror image");
    if (slash != std::string::npos) {
        double place = 0;
        const bool is_number = number_from_text(key.substr(slash + 1), place) == NumberFault::none;
        if (!value.is_array() || !is_number || !(place >= 1 && place <= static_cast<double>(value.size())) ||
            place != std::floor(place))
            refuse("must name a list of the scene and a place in it, counted from 1");
        path += "/" + std::to_string(static_cast<long>(place) - 1);
    } else if (value.is_array()) {
        refuse("must name the place in the list too, counted from 1, such as " + name + "/1");
    }
    const Json::json_pointer pointer(path);
    if (!number_in(scene.at(pointer))) refuse("must be a key of the scene that has a number");
    return pointer;
}

AmplitudesOfScene amplitudes_of(const Json& scene, std::optional<Mass> mass, double damping_tolerance, Effort* effort) {
    const std::string text = scene.dump();
    SceneSource source = scene_source(SceneText{text});
    if (damping_tolerance > 0) source = with_damping_tolerance(source, damping_tolerance);
    const Scene<double>& s = source->in_double();
    Question question{Asked::amplitude, std::nullopt};
    question.mass = mass;
    const SolvePoint at{frequency_ratio_of(s), friction_ratio_of(s), &source, effort};
    const AnswerOrNone answer = decide(prepare(source, question), at, question);
    if (!answer.is_answered()) return {{}, answer.refused};
    double unit = 1;
    if (s.units)
        if (const std::optional<double> P = s.units->force_at(angular_frequency(*s.units, at.r)))
            unit = displacement_unit(*s.units, *P);
    AmplitudesOfScene found;
    const double rounding = 4 * std::numeric_limits<double>::epsilon();
    for (const SolvedMass& m : answer.solution.masses) {
        const Certified& a = m.amplitude;
        found.amplitudes.push_back({a.value * unit, (a.error + rounding * a.value) * unit, {}, a.proved});
    }
    return found;
}

} // namespace denhartog
