#include "agreement.hpp"

#include <map>
#include <vector>

#include "sliding_scenes.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::derivation {

using nlohmann::json;

namespace {

/// The worst error of a group, and where.
struct Worst {
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

template <class T>
std::map<std::string, Worst> errors_on_paper(std::vector<std::string>& order) {
    std::map<std::string, Worst> groups;
    for (const NamedScene<T>& named : paper_scenes<T>()) {
        if (response(named.scene).regime->regime != Regime::continuous) continue;
        const std::string group = named.name.substr(0, named.name.find(" r="));
        if (!groups.contains(group)) order.push_back(group);
        groups[group].note(error_of(named.scene), named.name);
    }
    return groups;
}

json entry(const std::string& group, const Worst& in_double, double gate_double, const Worst& in_50, double gate_50) {
    return {{"group", group},
            {"scenes", in_double.scenes},
            {"double", {{"worst", in_double.error}, {"scene", in_double.scene}, {"gate", gate_double}}},
            {"50 digits", {{"worst", in_50.error}, {"scene", in_50.scene}, {"gate", gate_50}}},
            {"agrees", in_double.error <= gate_double && in_50.error <= gate_50 && in_double.scenes == in_50.scenes}};
}

} // namespace

json agreement_with_second_witness(const std::function<void(const std::string&)>& progress) {
    json groups = json::array();
    std::vector<std::string> order, same_order;
    progress("second witness, double");
    std::map<std::string, Worst> in_double = errors_on_paper<double>(order);
    progress("second witness, 50 digits");
    std::map<std::string, Worst> in_50 = errors_on_paper<Real50>(same_order);
    for (const std::string& group : order) groups.push_back(entry(group, in_double[group], 1e-12, in_50[group], 1e-45));
    return groups;
}

} // namespace denhartog::derivation
