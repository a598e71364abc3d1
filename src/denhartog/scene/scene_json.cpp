/// @file
/// @brief A scene from a JSON value and back.
#include "denhartog/scene/scene_json.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "denhartog/formulas/system.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog {
namespace {

using nlohmann::json;

constexpr auto keys = std::to_array<std::string_view>({"mass_ratios", "stiffness_ratios", "damping_ratios", "contact", "load",
                                                       "mu", "r", "beta", "mass_matrix", "stiffness_matrix", "damping_matrix",
                                                       "masses", "stiffnesses", "force", "friction", "frequency"});
constexpr auto dimensional_keys = std::to_array<const char*>({"masses", "stiffnesses", "force", "friction", "frequency"});
constexpr auto ratio_keys =
    std::to_array<const char*>({"mass_ratios", "stiffness_ratios", "mass_matrix", "stiffness_matrix", "r", "beta"});

std::string value_text(const json& x) { return legible(x.dump(-1, ' ', true, json::error_handler_t::replace), most_of_a_value); }

/// A value of the scene with its key and its place.
struct Item {
    const json& value;
    std::string key;
    std::string place;

    Item operator[](std::size_t i) const { return {value[i], key, place + pointer_step(std::to_string(i))}; }
    [[noreturn]] void fail(const std::string& rule) const { throw InputError(key, rule, value_text(value), place); }
};

Item item(const json& object, const char* key) { return {object.at(key), key, pointer_step(key)}; }

// Before anything as large is made of it.
void check_length(const Item& x, const std::string& of) {
    if (x.value.size() > most_masses) throw InputError(x.key, most_masses_rule(of), std::to_string(x.value.size()), x.place);
}

template <class T>
T read_number(const Item& x) {
    if (x.value.is_number()) return T(x.value.get<double>());
    if (!x.value.is_string()) x.fail("must be a number");
    T number(0);
    const NumberFault fault = number_from_text(x.value.get_ref<const std::string&>(), number);
    if (fault != NumberFault::none) x.fail(number_rule(fault));
    return number;
}

template <class T>
T read_positive(const Item& x) {
    const T number = read_number<T>(x);
    if (!(number > 0)) x.fail("must be positive");
    return number;
}

template <class T>
std::vector<T> read_list(const Item& x) {
    if (x.value.is_number()) return {read_number<T>(x)}; // Octave writes an array of one so
    if (!x.value.is_array()) x.fail("must be an array of numbers");
    if (x.value.empty()) x.fail("must have at least one value");
    check_length(x, "values");
    std::vector<T> list;
    for (std::size_t i = 0; i < x.value.size(); ++i) list.push_back(read_number<T>(x[i]));
    return list;
}

template <class T>
Matrix<T> read_matrix(const Item& x) {
    if (!x.value.is_array()) x.fail("must be an array of rows");
    if (x.value.empty()) x.fail("must have at least one row");
    check_length(x, "rows");
    const std::size_t N = x.value.size();
    Matrix<T> matrix(static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
    for (std::size_t i = 0; i < N; ++i) {
        const Item row = x[i];
        if (!row.value.is_array()) row.fail("must be an array of rows, each an array of numbers");
        if (row.value.size() != N)
            throw InputError(x.key,
                             "must be square: row " + std::to_string(i + 1) + " must have " + std::to_string(N) + " values",
                             std::to_string(row.value.size()), row.place);
        for (std::size_t k = 0; k < N; ++k) matrix(i, k) = read_number<T>(row[k]);
    }
    return matrix;
}

/// Counts from 1 in the text and from 0 in the scene. Whether the mass exists is among the rules of a scene.
std::size_t read_index(const Item& x) {
    const double number = x.value.is_number() ? x.value.get<double>() : 0.0;
    if (!(number >= 1 && number <= 1e9 && number == std::floor(number)))
        x.fail("must be a whole number that counts the masses from 1");
    return static_cast<std::size_t>(number) - 1;
}

/// The first of some keys that a scene has; null where it has none.
template <std::size_t n>
const char* first_of(const json& object, const std::array<const char*, n>& some) {
    for (const char* key : some)
        if (object.contains(key)) return key;
    return nullptr;
}

void require(const json& object, const char* key, const char* in_place_of = nullptr) {
    if (in_place_of && object.contains(key) && object.contains(in_place_of))
        throw InputError(in_place_of, std::string("must not be given together with ") + key, "", pointer_step(in_place_of));
    if (!object.contains(key) && !(in_place_of && object.contains(in_place_of)))
        throw InputError(key, in_place_of ? std::string("must be given (or ") + in_place_of + " in its place)" : "must be given",
                         "");
}

void check_keys(const json& object) {
    if (!object.is_object()) throw InputError("scene", "must be a JSON object", value_text(object));
    for (const auto& entry : object.items())
        if (std::find(keys.begin(), keys.end(), entry.key()) == keys.end())
            throw InputError(entry.key(), "is no key of a scene", "", pointer_step(entry.key()));
    const char* dimensional = first_of(object, dimensional_keys);
    const char* ratio = first_of(object, ratio_keys);
    if (dimensional && ratio)
        throw InputError(ratio,
                         std::string("must not be given together with ") + dimensional + ": a scene is dimensional or it is not",
                         "", pointer_step(ratio));
}

template <class T>
void read_ratios(const json& object, Scene<T>& scene) {
    require(object, "mass_ratios", "mass_matrix");
    require(object, "stiffness_ratios", "stiffness_matrix");
    System<T>& s = scene.system;
    if (object.contains("mass_ratios")) s.mass_ratios = read_list<T>(item(object, "mass_ratios"));
    if (object.contains("mass_matrix")) s.mass_matrix = read_matrix<T>(item(object, "mass_matrix"));
    if (object.contains("stiffness_ratios")) s.stiffness_ratios = read_list<T>(item(object, "stiffness_ratios"));
    if (object.contains("stiffness_matrix")) s.stiffness_matrix = read_matrix<T>(item(object, "stiffness_matrix"));
    if (object.contains("r")) scene.r = read_number<T>(item(object, "r"));
    if (object.contains("beta")) scene.beta = read_number<T>(item(object, "beta"));
}

/// What damping in dimensional units is divided by.
template <class T>
T read_dimensional(const json& object, Scene<T>& scene) {
    require(object, "masses");
    require(object, "stiffnesses");
    std::vector<T> m;
    std::vector<T> k;
    const auto read = [&](const char* key, std::vector<T>& list) {
        const Item x = item(object, key);
        list = read_list<T>(x);
        for (std::size_t i = 0; i < list.size(); ++i)
            if (!(list[i] > 0)) x[i].fail("must be positive");
    };
    read("masses", m);
    read("stiffnesses", k);
    for (const T& m_i : m) scene.system.mass_ratios.push_back(paper::mass_ratio(m_i, m[0]));
    for (const T& k_i : k) scene.system.stiffness_ratios.push_back(paper::stiffness_ratio(k_i, k[0]));
    if (object.contains("frequency")) scene.r = paper::frequency_ratio(read_positive<T>(item(object, "frequency")), m[0], k[0]);
    if (object.contains("force") || object.contains("friction")) {
        require(object, "force");
        require(object, "friction");
        const Item F = item(object, "friction");
        const T friction = read_number<T>(F);
        if (friction < 0) F.fail("must not be negative");
        scene.beta = paper::friction_ratio(friction, read_positive<T>(item(object, "force")));
    }
    return sqrt(k[0]) * sqrt(m[0]);
}

template <class T>
void read_damping(const json& object, const T& unit, System<T>& s) {
    require(object, "damping_ratios", "damping_matrix");
    if (object.contains("damping_matrix")) {
        s.damping_matrix = read_matrix<T>(item(object, "damping_matrix")) / unit;
        return;
    }
    const Item zeta = item(object, "damping_ratios");
    if (zeta.value.is_array())
        s.damping_ratios = read_list<T>(zeta);
    else if (zeta.value.is_number() || zeta.value.is_string())
        s.damping_ratios.assign(number_of_masses(s), read_number<T>(zeta));
    else
        zeta.fail("must be an array of numbers, or one number for all modes");
}

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

std::span<const std::string_view> scene_keys() { return keys; }

template <class T>
Scene<T> scene_from_json(const json& object) {
    check_keys(object);
    Scene<T> scene;
    SceneNames names;
    names.places = true;
    T unit(1);
    if (first_of(object, dimensional_keys)) {
        unit = read_dimensional(object, scene);
        names.masses = "masses";
        names.stiffnesses = "stiffnesses";
        names.r = "frequency";
        names.beta = "friction";
    } else {
        read_ratios(object, scene);
    }
    read_damping(object, unit, scene.system);
    names.one_zeta = object.contains("damping_ratios") && !object.at("damping_ratios").is_array();
    require(object, "contact");
    require(object, "load");
    scene.system.contact.index = read_index(item(object, "contact"));
    scene.system.load.index = read_index(item(object, "load"));
    if (object.contains("mu")) scene.mu = read_number<T>(item(object, "mu"));
    check_under_names(scene, names);
    return scene;
}

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
    object["contact"] = s.contact.index + 1;
    object["load"] = s.load.index + 1;
    object["mu"] = number_to_json(scene.mu);
    if (scene.r) object["r"] = number_to_json(*scene.r);
    if (scene.beta) object["beta"] = number_to_json(*scene.beta);
    return object;
}

template Scene<double> scene_from_json(const json&);
template Scene<Real50> scene_from_json(const json&);
template Scene<Real100> scene_from_json(const json&);
template nlohmann::ordered_json write_scene(const Scene<double>&);
template nlohmann::ordered_json write_scene(const Scene<Real50>&);
template nlohmann::ordered_json write_scene(const Scene<Real100>&);

} // namespace denhartog
