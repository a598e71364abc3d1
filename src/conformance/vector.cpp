// Vectors of the conformance kit, a question with its certified answer: read from a folder and checked, written as JSON and CSV.
// Read `vector_from_json` first; it refuses a vector that lacks a scale, condition or tolerance.
#include "conformance/vector.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog::conformance {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> all_hexadecimal(const std::vector<double>& numbers) {
    std::vector<std::string> texts;
    for (const double x : numbers) texts.push_back(hexadecimal_float(x));
    return texts;
}

double from_hexadecimal(const std::string& text) {
    if (const std::optional<double> x = finite_number(text)) return *x;
    throw InputError("hex", "must hold finite hexadecimal floats", text);
}

// Forty digits, of which only those of a double are looked at here.
void check_decimal(const std::string& text) {
    double x = 0;
    const NumberFault fault = number_from_text(text, x);
    if (fault == NumberFault::no_number || fault == NumberFault::too_long) throw InputError("value", number_rule(fault), text);
}

// Members that stand in reports as they are.
void check_text(const std::string& name, const std::string& text) {
    if (text != legible(text)) throw InputError(name, "must be a short text without control characters", text);
}

// The first word of a question in the plain dialect.
void check_id(const std::string& id) {
    check_text("id", id);
    const auto is_allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-'; };
    if (id.empty() || !std::ranges::all_of(id, is_allowed)) throw InputError("id", "must be letters, digits and hyphens", id);
}

void check_regime(const std::string& name, const std::string& word) {
    if (!is_regime(word)) throw InputError(name, "must be a regime", word);
}

constexpr std::pair<const char*, std::string Vector::*> texts[] = {
    {"group", &Vector::group}, {"equation", &Vector::equation}, {"tier", &Vector::tier}};
constexpr std::pair<const char*, double Tolerance::*> tolerances[] = {
    {"pass", &Tolerance::pass}, {"loose", &Tolerance::loose}, {"inaccurate", &Tolerance::inaccurate}};

// Scale, condition and tolerance must be there for each number of an answer.
void check_numbers(const Vector& v) {
    const std::string count = std::to_string(v.value.size());
    if (v.nearest.size() != v.value.size())
        throw InputError("hex", "must have as many numbers as value (" + count + ")", std::to_string(v.nearest.size()));
    if (quantity(v.question.quantity).shape == Shape::samples && static_cast<std::size_t>(v.question.samples) != v.value.size())
        throw InputError("samples", "must be as many as value has numbers (" + count + ")", std::to_string(v.question.samples));
    if (!(v.scale > 0)) throw InputError("scale", "must be positive", number_to_text(v.scale));
}

std::string csv_row(const Vector& v, bool systems) {
    const ProtocolQuestion& q = v.question;
    std::vector<std::string> condition;
    for (const auto& [input, number] : v.condition) condition.push_back(input + ":" + number_to_text(number));
    std::vector<std::string> cells{q.id, v.group, v.equation, v.tier, q.quantity};
    const auto add = [&](const auto&... texts) { (cells.emplace_back(texts), ...); };
    add(std::to_string(q.contact) + (q.contact_with == 0 ? "" : " " + std::to_string(q.contact_with)));
    add(q.loads.empty() ? std::to_string(q.load) : joined(q.loads), std::to_string(q.mass), std::to_string(q.samples));
    for (const double x : {q.tau, q.mu, q.r, q.beta}) add(number_to_text(x));
    for (const auto* list : {&q.mass_ratios, &q.stiffness_ratios, &q.damping_ratios}) add(joined(*list));
    const bool answered = v.reject.empty(), numbers = answered && v.word.empty();
    add(!answered ? "reject" : numbers ? joined(v.value) : v.word, joined(all_hexadecimal(v.nearest)));
    add(numbers ? hexadecimal_float(v.scale) : "");
    for (const auto& [key, number] : tolerances) add(numbers ? number_to_text(v.tolerance.*number) : "");
    add(joined(condition), v.regime, v.margin ? number_to_text(*v.margin) : "", joined(v.flags), joined(v.catches));
    add(answered ? joined(v.routes, "; ") : "", answered ? std::to_string(v.digits[0]) + " " + std::to_string(v.digits[1]) : "");
    if (systems) add(q.base_motion);
    for (const auto* list : {&q.mass_matrix, &q.stiffness_matrix, &q.damping_matrix, &q.load_phases})
        if (systems) add(joined(*list));
    return joined(cells, ",");
}

} // namespace

std::string hexadecimal_float(double x) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%a", x);
    return text.data();
}

Json vector_json(const Vector& v) {
    Json object = question_json(v.question);
    for (const auto& [key, text] : texts) object[key] = v.*text;
    if (!v.reject.empty()) {
        object["reject"] = v.reject;
    } else if (!v.word.empty()) {
        object["value"] = v.word;
    } else {
        object["value"] = v.value;
        object["hex"] = all_hexadecimal(v.nearest);
        object["scale"] = hexadecimal_float(v.scale);
        object["condition"] = Json::object();
        for (const auto& [input, number] : v.condition) object["condition"][input] = number;
        for (const auto& [key, number] : tolerances) object["tolerance"][key] = v.tolerance.*number;
    }
    if (!v.regime.empty()) object["regime"] = v.regime;
    if (v.margin) object["margin"] = *v.margin;
    object["flags"] = v.flags;
    object["catches"] = v.catches;
    if (v.reject.empty()) {
        object["routes"] = v.routes;
        object["digits"] = v.digits;
    }
    return object;
}

Vector vector_from_json(const nlohmann::json& object) {
    Vector v;
    v.question = question_from_json(object);
    try {
        for (const auto& [key, text] : texts) object.at(key).get_to(v.*text);
        check_id(v.question.id);
        for (const auto& [key, text] : texts) check_text(key, v.*text);
        v.regime = object.value("regime", "");
        if (!v.regime.empty()) check_regime("regime", v.regime);
        if (object.contains("margin")) v.margin = object["margin"].get<double>();
        object.at("flags").get_to(v.flags);
        for (const std::string& flag : v.flags) check_text("flags", flag);
        object.at("catches").get_to(v.catches);
        if (object.contains("reject")) {
            v.reject = object["reject"];
            check_text("reject", v.reject);
            if (v.reject.empty()) throw InputError("reject", "must name the rule that is broken", "");
            return v;
        }
        static_cast<void>(scene_of(v.question));
        object.at("routes").get_to(v.routes);
        for (const nlohmann::json& number : object.at("digits"))
            if (!number.is_number_integer()) throw InputError("digits", "must be whole numbers", number.dump());
        object.at("digits").get_to(v.digits);
        if (object.at("value").is_string()) {
            v.word = object["value"];
            check_regime("value", v.word);
            return v;
        }
        object.at("value").get_to(v.value);
        for (const std::string& x : v.value) check_decimal(x);
        for (const std::string& x : object.at("hex").get<std::vector<std::string>>()) v.nearest.push_back(from_hexadecimal(x));
        v.scale = from_hexadecimal(object.at("scale"));
        for (const auto& [input, number] : object.at("condition").items()) v.condition.emplace_back(input, number.get<double>());
        for (const auto& [key, number] : tolerances) object.at("tolerance").at(key).get_to(v.tolerance.*number);
        check_numbers(v);
    } catch (const nlohmann::json::exception& e) {
        throw InputError("vector " + v.question.id, "must have the members of the format", e.what());
    }
    return v;
}

bool is_of_systems(const Vector& v) { return v.group.starts_with("systems-"); }

std::string vectors_csv(const std::vector<const Vector*>& vectors) {
    const bool systems = std::ranges::any_of(vectors, [](const Vector* v) { return is_of_systems(*v); });
    std::string text = "id,group,equation,tier,quantity,contact,load,mass,samples,tau,mu,r,beta,mass_ratios,stiffness_ratios,"
                       "damping_ratios,value,"
                       "hex,scale,pass,loose,inaccurate,condition,regime,margin,flags,catches,routes,digits";
    text += systems ? ",base_motion,mass_matrix,stiffness_matrix,damping_matrix,load_phases\n" : "\n";
    for (const Vector* v : vectors) text += csv_row(*v, systems) + "\n";
    return text;
}

std::vector<Vector> read_vectors(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
        if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
    if (files.empty()) throw InputError("vectors", "must be a folder with files *.jsonl", folder.string());
    std::sort(files.begin(), files.end());
    std::vector<Vector> vectors;
    std::set<std::string> ids;
    for (const std::filesystem::path& file : files) {
        std::ifstream stream(file);
        std::size_t number = 0;
        for (std::string line; std::getline(stream, line);) {
            ++number;
            const nlohmann::json object = json_or_nothing(line);
            if (!object.is_object())
                throw InputError("vector", "must be a JSON object", legible(line, most_of_a_value),
                                 file.string() + ", line " + std::to_string(number));
            vectors.push_back(vector_from_json(object));
            if (!ids.insert(vectors.back().question.id).second)
                throw InputError("id", "must be given once", vectors.back().question.id, file.string());
        }
        if (stream.bad()) throw InputError("vectors", "must be readable", file.string());
    }
    return vectors;
}

} // namespace denhartog::conformance
