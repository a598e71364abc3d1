#include "denhartog/program/json/damping_json.hpp"

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/program/output/table.hpp"

namespace denhartog::program {

std::optional<Json> damping_json(const SceneSource& source) {
    const std::optional<CoupledDamping> damping = coupled_damping(source);
    if (!damping) return std::nullopt;
    const NumberWriter write;
    Json all{{"coupling", damping->taken_in ? "taken_in" : "left_out"},
             {"distance_from_classical", write(damping->distance_from_classical)},
             {"largest_coupling", write(damping->largest_coupling)},
             {"damping_ratios", Json::array()}};
    for (const double zeta : damping->damping_ratios) all["damping_ratios"].push_back(write(zeta));
    return all;
}

std::string damping_table(const Json& damping) {
    const bool taken_in = damping.at("coupling") == "taken_in";
    return "the damping matrix couples the modes, at most by " + in_table(damping.at("largest_coupling")) +
           " of the geometric mean of two diagonal coefficients: " +
           (taken_in ? "taken in" : "left out, as the paper does; without it the damping ratios nearest to the matrix count") +
           "\n";
}

} // namespace denhartog::program
