#include "derivation/observations/agreement.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <vector>

#include "derivation/claims/workers.hpp"
#include "derivation/observations/sliding_scenes.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::derivation {

using nlohmann::json;

namespace {

/// Into how many parts the scenes are dealt, so that all workers end at about the same time.
constexpr std::size_t parts = 16;

/// The worst error of a group, and where.
struct WorstDigits {
    double error = 0;
    std::string scene;
    long scenes = 0;

    void note(double e, const std::string& name) {
        ++scenes;
        if (e < error) return;
        error = e;
        scene = name;
    }
};

template <class T>
double error_of(const Scene<T>& scene) {
    return static_cast<double>(worst(compare_with_second_witness(scene)));
}

/// Errors of every PARTS-th scene from the PART-th on: an array of group, scene and error, in the order of the scenes.
template <class T>
json errors_on_paper(std::size_t part) {
    json errors = json::array();
    const std::vector<NamedScene<T>> scenes = paper_scenes<T>();
    for (std::size_t i = part; i < scenes.size(); i += parts) {
        const auto& [name, scene] = scenes[i];
        if (response(scene).regime->regime != Regime::continuous) continue;
        errors.push_back({i, name.substr(0, name.find(" r=")), name, error_of(scene)});
    }
    return errors;
}

std::map<std::string, WorstDigits> worst_of_groups(std::vector<json> errors, std::vector<std::string>& order) {
    std::map<std::string, WorstDigits> groups;
    std::sort(errors.begin(), errors.end());
    for (const json& error : errors) {
        const std::string group = error[1];
        if (!groups.contains(group)) order.push_back(group);
        groups[group].note(error[3], error[2]);
    }
    return groups;
}

json entry(const std::string& group, const WorstDigits& in_double, double gate_double, const WorstDigits& in_50, double gate_50) {
    return {{"group", group},
            {"scenes", in_double.scenes},
            {"double", {{"worst", in_double.error}, {"scene", in_double.scene}, {"gate", gate_double}}},
            {"50 digits", {{"worst", in_50.error}, {"scene", in_50.scene}, {"gate", gate_50}}},
            {"agrees", in_double.error <= gate_double && in_50.error <= gate_50 && in_double.scenes == in_50.scenes}};
}

} // namespace

json agreement_with_second_witness(std::size_t workers) {
    std::vector<json> in_double, in_50;
    const auto task = [](std::size_t part) { return json{errors_on_paper<double>(part), errors_on_paper<Real50>(part)}.dump(); };
    in_processes(parts, workers, task, [&](std::size_t part, const Delivery& delivery) {
        if (!delivery.fault.empty())
            throw std::runtime_error("part " + std::to_string(part) + " of the second witness: " + delivery.fault);
        const json errors = json::parse(delivery.text);
        in_double.insert(in_double.end(), errors[0].begin(), errors[0].end());
        in_50.insert(in_50.end(), errors[1].begin(), errors[1].end());
    });
    std::vector<std::string> order, same_order;
    std::map<std::string, WorstDigits> groups_in_double = worst_of_groups(in_double, order),
                                 groups_in_50 = worst_of_groups(in_50, same_order);
    json groups = json::array();
    for (const std::string& group : order)
        groups.push_back(entry(group, groups_in_double[group], 1e-12, groups_in_50[group], 1e-45));
    return groups;
}

} // namespace denhartog::derivation
