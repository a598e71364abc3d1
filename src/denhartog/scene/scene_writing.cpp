#include <nlohmann/json.hpp>

#include "denhartog/scene/scene_json.hpp"

namespace denhartog {
namespace {

using nlohmann::json;

json matrix_to_json(const Matrix<double>& matrix) {
    json rows = json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        json row = json::array();
        for (Eigen::Index k = 0; k < matrix.cols(); ++k) row.push_back(matrix(i, k));
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace

nlohmann::ordered_json write_scene(const Scene<double>& scene) {
    check(scene);
    const System<double>& s = scene.system;
    nlohmann::ordered_json object;
    if (s.mass_matrix.size() > 0)
        object["mass_matrix"] = matrix_to_json(s.mass_matrix);
    else
        object["mass_ratios"] = s.mass_ratios;
    if (s.stiffness_matrix.size() > 0)
        object["stiffness_matrix"] = matrix_to_json(s.stiffness_matrix);
    else
        object["stiffness_ratios"] = s.stiffness_ratios;
    if (s.damping_matrix.size() > 0)
        object["damping_matrix"] = matrix_to_json(s.damping_matrix);
    else
        object["damping_ratios"] = s.damping_ratios;
    if (s.damping_tolerance > 0) object["damping_tolerance"] = s.damping_tolerance;
    if (s.contact_with)
        object["contact"] = {s.contact.index + 1, s.contact_with->index + 1};
    else
        object["contact"] = s.contact.index + 1;
    if (s.load_vector.empty())
        object["load"] = s.load.index + 1;
    else
        object["load"] = s.load_vector;
    object["mu"] = scene.mu;
    if (scene.r) object["r"] = *scene.r;
    if (scene.beta) object["beta"] = *scene.beta;
    return object;
}

} // namespace denhartog
