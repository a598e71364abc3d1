#include <nlohmann/json.hpp>

#include "tests/conformance/generator/vector_files.hpp"

namespace denhartog::conformance::generator {
namespace {

using Json = nlohmann::ordered_json;

Json list_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json text(const char* pattern) { return {{"type", "string"}, {"pattern", pattern}}; }

Json told(Json schema, const char* description) {
    schema["description"] = description;
    return schema;
}

const Json number{{"type", "number"}};
const Json integer{{"type", "integer"}};
const Json positive{{"type", "number"}, {"minimum", 0}};

Json scene_schema() {
    Json properties{{"mass_ratios", told(list_of(number), "gamma, Eq. (9)")},
                    {"stiffness_ratios", told(list_of(number), "Eq. (73)")},
                    {"damping_ratios", told(list_of(number), "zeta, Eq. (18), modes by ascending natural frequency")},
                    {"mass_matrix", told(list_of(list_of(number)), "M in units of m_1, in place of mass_ratios")},
                    {"stiffness_matrix", told(list_of(list_of(number)), "K in units of k_1, in place of stiffness_ratios")},
                    {"damping_matrix", told(list_of(list_of(number)), "C in units of sqrt(k_1 m_1), in place of damping_ratios")},
                    {"contact", told({{"oneOf", {integer, list_of(integer)}}},
                                     "the mass in contact, j, from 1; or two that rub against each other")},
                    {"load", told({{"oneOf", {integer, list_of(number)}}},
                                  "the loaded mass, l, from 1; or the force on each mass in units of P")},
                    {"load_phases", told(list_of(number), "by how much each of the forces leads cos(tau), radians")},
                    {"base_motion", told({{"type", "string"}}, "with_wall, alone or wall, in place of load")},
                    {"mu", told(number, "static over kinetic friction, Eq. (3)")},
                    {"r", told(number, "frequency ratio, Eq. (10)")},
                    {"beta", told(number, "friction ratio, Eq. (11)")}};
    const auto either = [](const char* a, const char* b) { return Json{{"oneOf", {{{"required", {a}}}, {{"required", {b}}}}}}; };
    const Json either_of_each{either("mass_ratios", "mass_matrix"), either("stiffness_ratios", "stiffness_matrix"),
                              either("damping_ratios", "damping_matrix"), either("load", "base_motion")};
    return {{"type", "object"},
            {"properties", properties},
            {"required", {"contact", "mu", "r", "beta"}},
            {"allOf", either_of_each},
            {"additionalProperties", false}};
}

Json properties_of_a_line() {
    Json names = Json::array();
    for (const Quantity& q : quantities()) names.push_back(std::string(q.name));
    const Json decimal = text("^-?[0-9](\\.[0-9]+)?(e-?[0-9]+)?$"), hex = text("^-?0x[01](\\.[0-9a-f]+)?p[+-][0-9]+$");
    const Json regime{{"enum", {"continuous", "stick_slip", "permanent_sticking"}}};
    const Json tolerances{{"type", "object"},
                          {"properties", {{"pass", positive}, {"loose", positive}, {"inaccurate", positive}}},
                          {"required", {"pass", "loose", "inaccurate"}}};
    return {{"id", text("^[a-z-]+-[0-9]{4}$")},
            {"quantity", {{"enum", names}}},
            {"scene", scene_schema()},
            {"mass", told({{"type", "integer"}}, "the mass asked about, k, from 1; 0: the contact between two masses")},
            {"tau", told(positive, "non-dimensional time")},
            {"samples", told({{"type", "integer"}, {"minimum", 1}}, "number of instants asked for")},
            {"group", text("^[a-z-]+$")},
            {"equation", told({{"type", "string"}}, "number in the paper, empty where there is none")},
            {"tier", {{"enum", {"must", "should", "stress"}}}},
            {"reject", told({{"type", "string"}}, "the rule that the question breaks: to be rejected")},
            {"value", told({{"oneOf", {list_of(decimal), regime}}}, "rounded to 40 significant digits, or a regime")},
            {"hex", told(list_of(hex), "the doubles nearest to the value")},
            {"scale", told(hex, "what errors are divided by")},
            {"condition", told({{"type", "object"}, {"additionalProperties", positive}},
                               "|change of value| / scale over relative change of an input")},
            {"tolerance", told(tolerances, "largest errors over scale")},
            {"regime", regime},
            {"margin", told(positive, "|beta / nearest boundary - 1|")},
            {"flags", list_of(text("^[a-z-]+$"))},
            {"catches", told(list_of({{"type", "string"}}), "known mistakes whose answer is judged wrong")},
            {"routes", list_of({{"type", "string"}})},
            {"digits",
             told(list_of({{"type", "integer"}}), "on which the routes agree in 50 and in 100 digits, counted to 40 and 80")}};
}

} // namespace

std::string schema_text() {
    const Json rejected{{"required", {"reject"}}, {"not", {{"required", {"value"}}}}};
    const Json word{{"properties", {{"value", {{"type", "string"}}}}},
                    {"required", {"value", "regime", "margin", "routes", "digits"}}};
    const Json numbers{{"properties", {{"value", {{"type", "array"}}}}},
                       {"required", {"value", "hex", "scale", "condition", "tolerance", "routes", "digits"}}};
    const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                      {"title", "A certified vector of denhartog"},
                      {"description", "A line of a file *.jsonl, format version " + std::to_string(format_version)},
                      {"type", "object"},
                      {"properties", properties_of_a_line()},
                      {"required", {"id", "quantity", "scene", "group", "equation", "tier", "flags", "catches"}},
                      {"oneOf", {rejected, word, numbers}},
                      {"additionalProperties", false}};
    return schema.dump(1) + "\n";
}

} // namespace denhartog::conformance::generator
