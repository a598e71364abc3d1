/// @file
/// @brief A scene as a JSON value.
#include <nlohmann/json.hpp>

#include "denhartog/number/multiprecision.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/scene_json.hpp"

namespace denhartog {
namespace {

using nlohmann::json;

template <class T>
json number_to_json(const T& x) {
    const double nearest = static_cast<double>(x);
    return T(nearest) == x ? json(nearest) : json(number_to_text(x));
}

template <class T>
json list_to_json(const std::vector<T>& list) {
    json array = json::array();
    for (const T& x : list) array.push_back(number_to_json(x));
    return array;
}

template <class T>
json matrix_to_json(const Matrix<T>& matrix) {
    json rows = json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        json row = json::array();
        for (Eigen::Index k = 0; k < matrix.cols(); ++k) row.push_back(number_to_json(matrix(i, k)));
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace

template <class T>
nlohmann::ordered_json write_scene(const Scene<T>& scene) {
    check(scene);
    const System<T>& s = scene.system;
    nlohmann::ordered_json object;
    if (s.mass_matrix.size() > 0)
        object["mass_matrix"] = matrix_to_json(s.mass_matrix);
    else
        object["mass_ratios"] = list_to_json(s.mass_ratios);
    if (s.stiffness_matrix.size() > 0)
        object["stiffness_matrix"] = matrix_to_json(s.stiffness_matrix);
    else
        object["stiffness_ratios"] = list_to_json(s.stiffness_ratios);
    if (s.damping_matrix.size() > 0)
        object["damping_matrix"] = matrix_to_json(s.damping_matrix);
    else
        object["damping_ratios"] = list_to_json(s.damping_ratios);
    if (s.damping_tolerance > 0) object["damping_tolerance"] = s.damping_tolerance;
    if (s.contact_with)
        object["contact"] = {s.contact.index + 1, s.contact_with->index + 1};
    else
        object["contact"] = s.contact.index + 1;
    if (s.load_vector.empty())
        object["load"] = s.load.index + 1;
    else
        object["load"] = list_to_json(s.load_vector);
    object["mu"] = number_to_json(scene.mu);
    if (scene.r) object["r"] = number_to_json(*scene.r);
    if (scene.beta) object["beta"] = number_to_json(*scene.beta);
    return object;
}

template nlohmann::ordered_json write_scene(const Scene<double>&);
template nlohmann::ordered_json write_scene(const Scene<Real50>&);
template nlohmann::ordered_json write_scene(const Scene<Real100>&);

} // namespace denhartog
