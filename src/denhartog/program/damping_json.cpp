#include "denhartog/program/damping_json.hpp"

#include "denhartog/model/modal_damping.hpp"
#include "denhartog/program/table.hpp"

namespace denhartog::program {

std::optional<Json> damping_json(const Scene<double>& scene) {
    if (scene.system.damping_matrix.size() == 0) return std::nullopt;
    System<double> system = scene.system;
    system.damping_tolerance = 0;
    const ModalBasis<double> basis = modal_basis(system);
    if (!basis.coupled()) return std::nullopt;
    const bool taken_in = basis.distance_from_classical > scene.system.damping_tolerance;
    const NumberWriter write;
    Json all{{"coupling", taken_in ? "taken_in" : "left_out"},
             {"distance_from_classical", write(basis.distance_from_classical)},
             {"largest_coupling", write(largest_coupling(basis.D, 0.0))},
             {"damping_ratios", Json::array()}};
    for (const double zeta : basis.zeta) all["damping_ratios"].push_back(write(zeta));
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
