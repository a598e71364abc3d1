// The quantities of the protocol, and a question about one of them: read from JSON, written as JSON or in the plain dialect, and
// as a scene of the library. `beyond_the_paper` says what of a question the paper does not treat. Read the table first.
#include "conformance/question.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_json.hpp"

namespace denhartog::conformance {
namespace {

constexpr std::array<Quantity, 28> table{{
    {"natural_frequency_ratios", "15", Shape::modes, false, false, 0},
    {"modal_frequency_ratios", "22", Shape::modes, false, false, 1},
    {"mode_shape_products", "17", Shape::modes, true, false, 2},
    {"complex_response", "33", Shape::complex, true, false, 6},
    {"first_damping_function", "34", Shape::number, true, false, 7},
    {"second_damping_function", "35", Shape::number, true, false, 8},
    {"H_j", "64", Shape::number, false, false, 9},
    {"S_j", "55", Shape::number, false, false, 10},
    {"amplitude", "38", Shape::number, true, false, 16},
    {"phase", "39", Shape::number, true, true, 17},
    {"amplitude_monoharmonic", "52", Shape::number, true, false, 15},
    {"phase_monoharmonic", "53", Shape::number, true, true, 15},
    {"initial_displacement", "44", Shape::number, true, false, 13},
    {"initial_velocity", "45", Shape::number, true, false, 13},
    {"displacement", "46", Shape::number, true, false, 14},
    {"beta_lim_exact", "69", Shape::number, false, false, 11},
    {"beta_lim_paper", "69", Shape::number, false, false, 11},
    {"beta_lim_approximate", "67", Shape::number, false, false, 11},
    {"beta_lim_sticking", "88", Shape::number, false, false, 11},
    {"beta_lim_high_frequency", "86", Shape::number, false, false, 11},
    {"regime", "69", Shape::word, false, false, 11},
    {"stops_per_period", "", Shape::number, false, false},
    {"stop_durations", "", Shape::durations, false, false},
    {"rest_interval", "", Shape::number, false, false, 12},
    {"motion_under_force", "", Shape::samples, true, false},
    {"absolute_amplitude", "", Shape::number, true, false, 18, true},
    {"absolute_phase", "", Shape::number, true, true, 18, true},
    {"transmissibility", "", Shape::number, true, false, 18, true},
}};

// JSON as text, whatever bytes its strings hold.
std::string text_of_json(const nlohmann::json& x) { return x.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); }

// Reads a member of an object, which has to be there if it must.
template <class T>
void read(const nlohmann::json& object, const char* key, T& x, bool must = true) {
    const auto found = object.find(key);
    if (found == object.end() && !must) return;
    if (found == object.end()) throw InputError(key, "must be given", "");
    try {
        found->get_to(x);
    } catch (const nlohmann::json::exception&) {
        throw InputError(key, "must have the type that the protocol gives", text_of_json(*found));
    }
}

// The JSON library would cut a number to an int without a word.
void read(const nlohmann::json& object, const char* key, int& number, bool must = true) {
    double x = number;
    read(object, key, x, must);
    if (!(std::abs(x) < 1e9) || x != std::floor(x))
        throw InputError(key, "must be a whole number of at most nine digits", number_to_text(x));
    number = static_cast<int>(x);
}

// A square matrix row by row; empty where it is not given.
std::vector<double> matrix_or_nothing(const nlohmann::json& object, const char* key) {
    std::vector<std::vector<double>> rows;
    read(object, key, rows, false);
    std::vector<double> entries;
    for (const std::vector<double>& row : rows) {
        if (row.size() != rows.size()) throw InputError(key, "must be square", text_of_json(object[key]));
        entries.insert(entries.end(), row.begin(), row.end());
    }
    return entries;
}

std::vector<std::vector<double>> rows_of(const std::vector<double>& matrix) {
    const auto N = std::lround(std::sqrt(static_cast<double>(matrix.size())));
    std::vector<std::vector<double>> rows;
    for (long i = 0; i < N; ++i) rows.emplace_back(matrix.begin() + i * N, matrix.begin() + (i + 1) * N);
    return rows;
}

// Parts of a system, each as ratios or as a matrix in their place.
struct PartOfSystem {
    const char* ratios_key;
    std::vector<double> ProtocolQuestion::*ratios;
    const char* matrix_key;
    std::vector<double> ProtocolQuestion::*matrix;
};

constexpr PartOfSystem parts_of_system[] = {
    {"mass_ratios", &ProtocolQuestion::mass_ratios, "mass_matrix", &ProtocolQuestion::mass_matrix},
    {"stiffness_ratios", &ProtocolQuestion::stiffness_ratios, "stiffness_matrix", &ProtocolQuestion::stiffness_matrix},
    {"damping_ratios", &ProtocolQuestion::damping_ratios, "damping_matrix", &ProtocolQuestion::damping_matrix}};

constexpr std::pair<const char*, double ProtocolQuestion::*> numbers_of_scene[] = {
    {"mu", &ProtocolQuestion::mu}, {"r", &ProtocolQuestion::r}, {"beta", &ProtocolQuestion::beta}};

// As `denhartog solve` takes it.
nlohmann::ordered_json scene_json(const ProtocolQuestion& q) {
    nlohmann::ordered_json scene;
    using Json = nlohmann::ordered_json;
    for (const PartOfSystem& part : parts_of_system) {
        if ((q.*part.matrix).empty())
            scene[part.ratios_key] = q.*part.ratios;
        else
            scene[part.matrix_key] = rows_of(q.*part.matrix);
    }
    scene["contact"] = q.contact_with == 0 ? Json(q.contact) : Json{q.contact, q.contact_with};
    if (!q.base_motion.empty())
        scene["base_motion"] = q.base_motion;
    else
        scene["load"] = q.loads.empty() ? Json(q.load) : Json(q.loads);
    if (!q.load_phases.empty()) scene["load_phases"] = q.load_phases;
    for (const auto& [key, number] : numbers_of_scene) scene[key] = q.*number;
    return scene;
}

void read_places(const nlohmann::json& scene, ProtocolQuestion& q) {
    const nlohmann::json contact = scene.value("contact", nlohmann::json());
    if (contact.is_array()) {
        if (contact.size() != 2) throw InputError("contact", "must be one mass or two", text_of_json(contact));
        read({{"contact", contact[0]}}, "contact", q.contact);
        read({{"contact_with", contact[1]}}, "contact_with", q.contact_with);
    } else {
        read(scene, "contact", q.contact);
    }
    q.load = 0;
    const bool several = scene.contains("load") && scene["load"].is_array();
    read(scene, "base_motion", q.base_motion, false);
    if (!scene.contains("base_motion") && several) read(scene, "load", q.loads);
    if (!scene.contains("base_motion") && !several) read(scene, "load", q.load);
    read(scene, "load_phases", q.load_phases, false);
}

std::string in_quotes(std::string_view text) { return "'" + legible(text, 60) + "'"; }

Answer value_of_words(const std::vector<std::string>& words) {
    if (words.size() == 1 && is_regime(words.front())) return Value{{}, words.front()};
    Value value;
    for (const std::string& word : words) {
        const std::optional<double> x = finite_number(word);
        if (!x) return Unusable{in_quotes(word) + " is neither a finite number nor a regime"};
        value.numbers.push_back(*x);
    }
    return value;
}

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream stream{std::string(text)};
    return {std::istream_iterator<std::string>(stream), {}};
}

std::string place_of(std::size_t line) { return "line " + std::to_string(line); }

struct Row {
    std::vector<std::string> cells;
    std::size_t line = 1;
};

// CSV as RFC 4180 has it: quotes round a cell, doubled within.
std::vector<Row> rows_of(std::string_view text) {
    std::vector<Row> rows;
    std::size_t line = 1;
    for (std::size_t n = 0; n < text.size();) {
        Row row{{""}, line};
        bool quoted = false;
        for (; n < text.size(); ++n) {
            const char c = text[n];
            if (c == '\n') ++line;
            if (quoted && c == '"' && n + 1 < text.size() && text[n + 1] == '"') {
                row.cells.back() += '"';
                ++n;
            } else if (c == '"' && (quoted || row.cells.back().empty())) {
                quoted = !quoted;
            } else if (!quoted && c == ',') {
                row.cells.emplace_back();
            } else if (!quoted && c == '\n') {
                ++n;
                break;
            } else {
                row.cells.back() += c;
            }
        }
        if (quoted) throw InputError("answers", "must end every quoted cell", "", place_of(row.line));
        if (!row.cells.back().empty() && row.cells.back().back() == '\r') row.cells.back().pop_back();
        if (row.cells.size() > 1 || !row.cells.front().empty()) rows.push_back(std::move(row));
    }
    return rows;
}

void put(std::map<std::string, Answer>& answers, const std::set<std::string>& known, const std::string& id, Answer answer,
         std::size_t line) {
    if (!known.contains(id)) throw InputError("id", "must be a vector's", legible(id), place_of(line));
    if (!answers.emplace(id, std::move(answer)).second) throw InputError("id", "must be given once", id, place_of(line));
}

std::map<std::string, Answer> from_csv(std::string_view text, const std::set<std::string>& known) {
    const std::vector<Row> rows = rows_of(text);
    if (rows.empty() || rows.front().cells != std::vector<std::string>{"id", "value"})
        throw InputError("answers", "must be JSON Lines, or CSV with the heading id,value",
                         rows.empty() ? "empty" : legible(rows.front().cells.front()), place_of(1));
    std::map<std::string, Answer> answers;
    for (std::size_t n = 1; n < rows.size(); ++n) {
        const Row& row = rows[n];
        if (row.cells.size() != 2)
            throw InputError("answers", "must have two cells a line, numbers separated by spaces",
                             std::to_string(row.cells.size()) + " cells", place_of(row.line));
        put(answers, known, row.cells[0], answer_from_cell(row.cells[1]), row.line);
    }
    return answers;
}

std::map<std::string, Answer> from_json_lines(std::string_view text, const std::set<std::string>& known) {
    std::map<std::string, Answer> answers;
    std::istringstream lines{std::string(text)};
    std::string one;
    for (std::size_t line = 1; std::getline(lines, one); ++line) {
        if (one.find_first_not_of(" \t\r") == std::string::npos) continue;
        const nlohmann::json object = json_or_nothing(one);
        if (!object.is_object() || !object.contains("id") || !object["id"].is_string())
            throw InputError("answers", "must hold a JSON object with an id in every line", legible(one), place_of(line));
        const std::string id = object["id"];
        put(answers, known, id, answer_from_json(one, id), line);
    }
    return answers;
}

} // namespace

std::span<const Quantity> quantities() { return table; }

bool is_of_the_paper(const ProtocolQuestion& q) { return beyond_the_paper(q).empty(); }

std::size_t masses_of(const ProtocolQuestion& q) {
    return q.mass_matrix.empty() ? q.mass_ratios.size() : rows_of(q.mass_matrix).size();
}

std::vector<std::string> beyond_the_paper(const ProtocolQuestion& q) {
    std::vector<std::string> names;
    if (q.contact_with != 0) names.emplace_back("contact-between-masses");
    if (!q.loads.empty()) names.emplace_back("several-loads");
    if (!q.load_phases.empty()) names.emplace_back("loads-out-of-phase");
    if (!q.base_motion.empty())
        names.emplace_back(q.base_motion == "alone" ? "base-alone" : q.base_motion == "wall" ? "wall-alone" : "base-with-wall");
    if (!q.mass_matrix.empty()) names.emplace_back("mass-matrix");
    if (!q.stiffness_matrix.empty()) names.emplace_back("stiffness-matrix");
    if (!q.damping_matrix.empty()) names.emplace_back("damping-matrix");
    return names;
}

bool asks_for(const ProtocolQuestion& q, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, q.quantity) != names.end();
}

const Quantity& quantity(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Quantity::name);
    if (found == table.end()) throw InputError("quantity", "must be one of the protocol's", std::string(name));
    return *found;
}

std::size_t place_in_chain(const ProtocolQuestion& q) {
    const std::size_t place = quantity(q.quantity).link;
    const bool of_one_mass = q.mass_ratios.size() == 1 && place >= 6 && place <= 8;
    return of_one_mass ? place - 3 : place;
}

bool is_overdamped(const ProtocolQuestion& q) {
    return std::ranges::any_of(q.damping_ratios, [](double zeta) { return zeta >= 1; });
}

Scene<double> scene_of(const ProtocolQuestion& q) {
    Scene<double> scene = scene_from_json<double>(nlohmann::json(scene_json(q)));
    const Quantity& asked = quantity(q.quantity);
    if (asked.absolute && q.base_motion.empty()) throw InputError("base_motion", "must be given for " + q.quantity, "");
    // Of a contact between two masses, 0 stands for its own displacement, which is the same in every frame.
    const bool of_contact = q.mass == 0 && q.contact_with != 0 && !asked.absolute;
    if (asked.of_mass && !of_contact) (void)mass_from(q.mass, masses_of(q), "mass");
    return scene;
}

nlohmann::ordered_json question_json(const ProtocolQuestion& q) {
    nlohmann::ordered_json object = {{"id", q.id}, {"quantity", q.quantity}, {"scene", scene_json(q)}};
    if (quantity(q.quantity).of_mass) object["mass"] = q.mass;
    if (q.quantity == "displacement") object["tau"] = q.tau;
    if (quantity(q.quantity).shape == Shape::samples) object["samples"] = q.samples;
    return object;
}

std::string question_plain(const ProtocolQuestion& q) {
    const int N = static_cast<int>(masses_of(q));
    std::vector<std::string> words{q.id, q.quantity};
    for (const int x : {N, q.contact, q.load, q.mass, q.samples}) words.push_back(std::to_string(x));
    const auto add = [&](const std::vector<double>& list) {
        for (const double x : list) words.push_back(number_to_text(x));
    };
    add({q.tau, q.mu, q.r, q.beta});
    for (const PartOfSystem& part : parts_of_system)
        add((q.*part.matrix).empty() ? q.*part.ratios : std::vector<double>(static_cast<std::size_t>(N), 0));
    // Words for a scene beyond the paper, behind all those for one of the paper.
    if (q.contact_with != 0) words.insert(words.end(), {"contact_with", std::to_string(q.contact_with)});
    if (!q.base_motion.empty()) words.insert(words.end(), {"base_motion", q.base_motion});
    const auto add_under = [&](const char* tag, const std::vector<double>& list) {
        if (!list.empty()) words.emplace_back(tag);
        add(list);
    };
    add_under("loads", q.loads);
    add_under("load_phases", q.load_phases);
    for (const PartOfSystem& part : parts_of_system) add_under(part.matrix_key, q.*part.matrix);
    return joined(words);
}

ProtocolQuestion question_from_json(const nlohmann::json& object) {
    if (!object.is_object()) throw InputError("question", "must be a JSON object", text_of_json(object));
    nlohmann::json scene;
    read(object, "scene", scene);
    ProtocolQuestion q;
    read(object, "id", q.id);
    read(object, "quantity", q.quantity);
    static_cast<void>(quantity(q.quantity));
    for (const PartOfSystem& part : parts_of_system) {
        if (!scene.contains(part.matrix_key)) read(scene, part.ratios_key, q.*part.ratios);
        q.*part.matrix = matrix_or_nothing(scene, part.matrix_key);
    }
    read_places(scene, q);
    for (const auto& [key, number] : numbers_of_scene) read(scene, key, q.*number);
    read(object, "mass", q.mass, false);
    read(object, "tau", q.tau, false);
    read(object, "samples", q.samples, false);
    return q;
}

bool is_regime(std::string_view word) { return word == "continuous" || word == "stick_slip" || word == "permanent_sticking"; }

std::optional<double> finite_number(std::string_view text) {
    const std::string copy(text);
    char* end = nullptr;
    const double x = std::strtod(copy.c_str(), &end);
    const bool whole = !copy.empty() && copy.front() != ' ' && end == copy.c_str() + copy.size();
    return whole && std::isfinite(x) ? std::optional(x) : std::nullopt;
}

std::string joined(std::span<const std::string> words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : between).append(word);
    return text;
}

std::string joined(std::span<const double> numbers, std::string_view between) {
    std::vector<std::string> words;
    for (const double x : numbers) words.push_back(number_to_text(x));
    return joined(words, between);
}

Answer answer_from_json(std::string_view line, std::string_view id) {
    if (nested_too_deeply(line)) return Unusable{in_quotes(line) + " is nested too deeply"};
    const nlohmann::json object = json_or_nothing(line);
    if (!object.is_object()) return Unusable{in_quotes(line) + " is no JSON object"};
    const auto text = [&](const char* key) {
        return object[key].is_string() ? object[key].get<std::string>() : text_of_json(object[key]);
    };
    if (!object.contains("id")) return Unusable{"the answer has no id"};
    if (text("id") != id) return Unusable{"the answer is to " + in_quotes(text("id")) + ", the question was " + std::string(id)};
    if (object.contains("skip")) return Skipped{text("skip")};
    if (object.contains("reject")) return Rejected{text("reject")};
    if (!object.contains("value")) return Unusable{"the answer has neither value nor reject nor skip"};
    const nlohmann::json& value = object["value"];
    std::vector<std::string> words;
    for (const nlohmann::json& x : value.is_array() ? value : nlohmann::json::array({value})) {
        if (!x.is_string() && !x.is_number()) return Unusable{in_quotes(text_of_json(x)) + " is no number"};
        words.push_back(x.is_string() ? x.get<std::string>() : number_to_text(x.get<double>()));
    }
    return value_of_words(words);
}

Answer answer_from_plain(std::string_view line, std::string_view id) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) return Unusable{"the answer is an empty line"};
    if (words.front() != id)
        return Unusable{"the answer is to " + in_quotes(words.front()) + ", the question was " + std::string(id)};
    if (words.size() < 2) return Unusable{"the answer has neither value nor reject nor skip"};
    const std::string rest = joined(std::span(words).subspan(2));
    if (words[1] == "skip") return Skipped{rest};
    if (words[1] == "reject") return Rejected{rest};
    if (words[1] != "value") return Unusable{in_quotes(words[1]) + " is neither value nor reject nor skip"};
    return value_of_words({words.begin() + 2, words.end()});
}

Answer answer_from_cell(std::string_view text) {
    const std::vector<std::string> words = words_of(text);
    if (words.empty()) return Skipped{"no answer"};
    if (words.front() == "skip") return Skipped{"skip"};
    if (words.front() == "reject") return Rejected{"reject"};
    return value_of_words(words);
}

std::map<std::string, Answer> answers_in(std::string_view text, const std::set<std::string>& known) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    refuse_zero_byte("answers", text);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{' ? from_json_lines(text, known) : from_csv(text, known);
}

} // namespace denhartog::conformance
