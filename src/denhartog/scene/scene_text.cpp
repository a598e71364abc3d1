/// @file
/// @brief One scene or many from JSON text, and a scene as a JSON value.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "denhartog/number/ball_or_none.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/scene_json.hpp"

namespace denhartog {
namespace {

constexpr std::string_view blanks = " \t\r";

/// The lines that are not blank, each as if it were a scene among many.
std::vector<SceneText> lines_of(std::string_view text) {
    std::vector<SceneText> lines;
    std::size_t number = 1;
    for (std::size_t from = 0; from <= text.size(); ++number) {
        const std::size_t to = std::min(text.find('\n', from), text.size());
        const std::string_view line = text.substr(from, to - from);
        if (line.find_first_not_of(blanks) != line.npos) lines.push_back({line, number, false});
        from = to + 1;
    }
    return lines;
}

bool opens_object(const SceneText& line) { return line.text[line.text.find_first_not_of(blanks)] == '{'; }

/// No line of a scene that runs over many lines is an object by itself, and at most one of them opens one.
bool one_scene_a_line(const std::vector<SceneText>& lines) {
    if (lines.size() < 2) return false;
    if (std::count_if(lines.begin(), lines.end(), opens_object) > 1) return true;
    return std::any_of(lines.begin(), lines.end(),
                       [](const SceneText& line) { return opens_object(line) && is_json(line.text); });
}

nlohmann::json matrix_to_json(const Matrix<double>& matrix) {
    nlohmann::json rows;
    for (const auto& row : matrix.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
    return rows;
}

} // namespace

std::vector<SceneText> split_scenes(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    if (is_json(text)) return {{text, 1, true}};
    std::vector<SceneText> lines = lines_of(text);
    if (one_scene_a_line(lines)) return lines;
    return {{text, 1, true}};
}

template <class T>
Scene<T> read_scene(std::string_view text) {
    return scene_from_json<T>(read_json(text));
}

template <class T>
SceneOrError<T> read_scene(const SceneText& part) {
    SceneOrError<T> result{part.line, std::nullopt, std::nullopt};
    try {
        result.scene = scene_from_json<T>(read_json(part.text, part.line));
    } catch (const InputError& fault) {
        std::string place = fault.place;
        if (!part.alone && !place.starts_with("line ")) {
            const std::string line = std::string("line ").append(std::to_string(part.line));
            place = place.empty() ? line : line + ", " + place;
        }
        result.error.emplace(fault.quantity, fault.rule, fault.value, place);
    }
    return result;
}

template <class T>
std::vector<SceneOrError<T>> read_scenes(std::string_view text) {
    std::vector<SceneOrError<T>> scenes;
    for (const SceneText& part : split_scenes(text)) scenes.push_back(read_scene<T>(part));
    return scenes;
}

nlohmann::ordered_json write_scene(const Scene<double>& scene) {
    check(scene);
    const System<double>& s = scene.system;
    nlohmann::ordered_json object;
    const auto put = [&object](const char* ratios_key, const std::vector<double>& ratios, const char* key,
                               const Matrix<double>& matrix) {
        if (matrix.size() > 0)
            object[key] = matrix_to_json(matrix);
        else
            object[ratios_key] = ratios;
    };
    put("mass_ratios", s.mass_ratios, "mass_matrix", s.mass_matrix);
    put("stiffness_ratios", s.stiffness_ratios, "stiffness_matrix", s.stiffness_matrix);
    put("damping_ratios", s.damping_ratios, "damping_matrix", s.damping_matrix);
    if (s.damping_tolerance > 0) object["damping_tolerance"] = s.damping_tolerance;
    if (s.contact_with)
        object["contact"] = {s.contact.index + 1, s.contact_with->index + 1};
    else if (!s.contact_direction.empty())
        object["contact"] = {{"direction", s.contact_direction}};
    else
        object["contact"] = s.contact.index + 1;
    if (s.load_vector.empty())
        object["load"] = s.load.index + 1;
    else
        object["load"] = s.load_vector;
    if (!scene.static_load.empty()) object["static_load"] = scene.static_load;
    if (!s.load_phases.empty()) object["load_phases"] = s.load_phases;
    object["mu"] = scene.mu;
    if (scene.r) object["r"] = *scene.r;
    if (scene.beta) object["beta"] = *scene.beta;
    return object;
}

template Scene<double> read_scene(std::string_view);
template SceneOrError<double> read_scene(const SceneText&);
#if DENHARTOG_REFERENCE
template SceneOrError<Ball> read_scene(const SceneText&);
#endif
template std::vector<SceneOrError<double>> read_scenes(std::string_view);

} // namespace denhartog
