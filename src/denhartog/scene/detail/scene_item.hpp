// Values of a scene's JSON text, read with the key and the place that a fault names. Included by sources only.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog::scene_items {

// A value of the scene with its key and its place.
struct SceneItem {
    const nlohmann::json& value;
    std::string key;
    std::string place;

    // An entry; a value that stands without its brackets is the only one.
    SceneItem operator[](std::size_t i) const {
        return value.is_array() ? SceneItem{value[i], key, place + "/" + std::to_string(i)} : *this;
    }
    [[noreturn]] void fail(const std::string& rule) const {
        throw InputError(key, rule, legible(value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace), most_of_a_value),
                         place);
    }
};

inline SceneItem item(const nlohmann::json& object, const char* key) { return {object.at(key), key, pointer_step(key)}; }

// Before anything as large is made of it.
inline void check_length(const SceneItem& x, const std::string& of) {
    if (x.value.size() > most_masses) throw InputError(x.key, most_masses_rule(of), std::to_string(x.value.size()), x.place);
}

// A negative zero becomes zero: it has no meaning, and would be printed as -0.
template <class T>
T read_number(const SceneItem& x) {
    if (x.value.is_number()) return T(x.value.get<double>() + 0.0);
    if (!x.value.is_string()) x.fail("must be a number");
    T number(0);
    const NumberFault fault = number_from_text(x.value.get_ref<const std::string&>(), number);
    if (fault != NumberFault::none) x.fail(number_rule(fault));
    return number == T(0) ? T(0) : number;
}

template <class T>
T read_positive(const SceneItem& x) {
    const T number = read_number<T>(x);
    if (!(number > 0)) x.fail("must be positive");
    return number;
}

template <class T>
T read_not_negative(const SceneItem& x) {
    const T number = read_number<T>(x);
    if (number < 0) x.fail("must not be negative");
    return number;
}

template <class T>
std::vector<T> read_list(const SceneItem& x) {
    if (x.value.is_number()) return {read_number<T>(x)}; // Octave writes an array of one so
    if (!x.value.is_array()) x.fail("must be an array of numbers");
    if (x.value.empty()) x.fail("must have at least one value");
    check_length(x, "values");
    std::vector<T> list;
    for (std::size_t i = 0; i < x.value.size(); ++i) list.push_back(read_number<T>(x[i]));
    return list;
}

template <class T>
Matrix<T> read_matrix(const SceneItem& x) {
    if (!x.value.is_array()) x.fail("must be an array of rows");
    if (x.value.empty()) x.fail("must have at least one row");
    check_length(x, "rows");
    const std::size_t N = x.value.size();
    Matrix<T> matrix(static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
    for (std::size_t i = 0; i < N; ++i) {
        const SceneItem row = x[i];
        if (!row.value.is_array()) row.fail("must be an array of rows, each an array of numbers");
        if (row.value.size() != N)
            throw InputError(x.key,
                             "must be square: row " + std::to_string(i + 1) + " must have " + std::to_string(N) + " values",
                             std::to_string(row.value.size()), row.place);
        for (std::size_t k = 0; k < N; ++k) matrix(i, k) = read_number<T>(row[k]);
    }
    return matrix;
}

// Counts from 1 in the text and from 0 in the scene. Whether the mass exists is among the rules of a scene.
inline std::size_t read_index(const SceneItem& x) {
    const double number = x.value.is_number() ? x.value.get<double>() : 0.0;
    if (!(number >= 1 && number <= 1e9 && number == std::floor(number)))
        x.fail("must be a whole number that counts the masses from 1");
    return static_cast<std::size_t>(number) - 1;
}

inline void require(const nlohmann::json& object, const char* key, const char* in_place_of = nullptr) {
    if (in_place_of && object.contains(key) && object.contains(in_place_of))
        throw InputError(in_place_of, std::string("must not be given together with ") + key, "", pointer_step(in_place_of));
    if (!object.contains(key) && !(in_place_of && object.contains(in_place_of)))
        throw InputError(key, in_place_of ? std::string("must be given (or ") + in_place_of + " in its place)" : "must be given",
                         "");
}

} // namespace denhartog::scene_items
