#include "conformance/question.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"

namespace denhartog::conformance {
namespace {

constexpr std::array<Quantity, 25> table{{
    {"natural_frequency_ratios", "15", Shape::modes, false, false},
    {"modal_frequency_ratios", "22", Shape::modes, false, false},
    {"mode_shape_products", "17", Shape::modes, true, false},
    {"complex_response", "33", Shape::complex, true, false},
    {"first_damping_function", "34", Shape::number, true, false},
    {"second_damping_function", "35", Shape::number, true, false},
    {"H_j", "64", Shape::number, false, false},
    {"S_j", "55", Shape::number, false, false},
    {"amplitude", "38", Shape::number, true, false},
    {"phase", "39", Shape::number, true, true},
    {"amplitude_monoharmonic", "52", Shape::number, true, false},
    {"phase_monoharmonic", "53", Shape::number, true, true},
    {"initial_displacement", "44", Shape::number, true, false},
    {"initial_velocity", "45", Shape::number, true, false},
    {"displacement", "46", Shape::number, true, false},
    {"beta_lim_exact", "69", Shape::number, false, false},
    {"beta_lim_paper", "69", Shape::number, false, false},
    {"beta_lim_approximate", "67", Shape::number, false, false},
    {"beta_lim_sticking", "88", Shape::number, false, false},
    {"beta_lim_high_frequency", "86", Shape::number, false, false},
    {"regime", "69", Shape::word, false, false},
    {"stops_per_period", "", Shape::number, false, false},
    {"stop_durations", "", Shape::durations, false, false},
    {"rest_interval", "", Shape::number, false, false},
    {"motion_under_force", "", Shape::samples, true, false},
}};

// A number as an answer writes it: decimal or hexadecimal, nothing after it.
std::optional<double> finite_number(std::string_view text) {
    const std::string copy(text);
    if (copy.empty() || copy.front() == ' ') return std::nullopt;
    char* end = nullptr;
    const double x = std::strtod(copy.c_str(), &end);
    if (end != copy.c_str() + copy.size() || !std::isfinite(x)) return std::nullopt;
    return x;
}

bool is_regime(std::string_view text) { return text == "continuous" || text == "stick_slip" || text == "permanent_sticking"; }

std::string in_quotes(std::string_view text) {
    constexpr std::size_t most = 60;
    return "'" + legible(text, most) + "'";
}

// As text whatever bytes its strings hold.
std::string dumped(const nlohmann::json& x) { return x.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); }

Answer value_of_words(const std::vector<std::string>& words) {
    Value value;
    if (words.size() == 1 && is_regime(words.front())) {
        value.word = words.front();
        return value;
    }
    for (const std::string& word : words) {
        const std::optional<double> x = finite_number(word);
        if (!x) return Unusable{in_quotes(word) + " is neither a finite number nor a regime"};
        value.numbers.push_back(*x);
    }
    return value;
}

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream stream{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

// A member of an answer's value: a JSON number, or a text that holds one or a regime.
std::optional<std::string> word_of(const nlohmann::json& x) {
    if (x.is_string()) return x.get<std::string>();
    if (x.is_number()) return number_to_text(x.get<double>());
    return std::nullopt;
}

template <class T>
std::vector<T> exact(const std::vector<double>& numbers) {
    return {numbers.begin(), numbers.end()};
}

int place(int counted_from_1, const char* name, std::size_t N) {
    if (counted_from_1 < 1 || static_cast<std::size_t>(counted_from_1) > N)
        throw InputError(name, "must be a mass from 1 to " + std::to_string(N), std::to_string(counted_from_1));
    return counted_from_1 - 1;
}

template <class T>
T member(const nlohmann::json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end()) throw InputError(key, "must be given", "");
    try {
        return found->get<T>();
    } catch (const nlohmann::json::exception&) {
        throw InputError(key, "must have the type that the protocol gives", dumped(*found));
    }
}

// The JSON library would cut a number to an int without a word.
int whole(const nlohmann::json& object, const char* key) {
    const auto x = member<double>(object, key);
    if (!(std::abs(x) < 1e9) || x != std::floor(x))
        throw InputError(key, "must be a whole number of at most nine digits", number_to_text(x));
    return static_cast<int>(x);
}

} // namespace

std::span<const Quantity> quantities() { return table; }

const Quantity& quantity(std::string_view name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Quantity& q) { return q.name == name; });
    if (found == table.end()) throw InputError("quantity", "must be one of the protocol's", std::string(name));
    return *found;
}

bool is_overdamped(const Question& q) {
    return std::any_of(q.damping_ratios.begin(), q.damping_ratios.end(), [](double zeta) { return zeta >= 1; });
}

template <class T>
Scene<T> scene_of(const Question& q) {
    Scene<T> scene;
    const std::size_t N = q.mass_ratios.size();
    scene.system.mass_ratios = exact<T>(q.mass_ratios);
    scene.system.stiffness_ratios = exact<T>(q.stiffness_ratios);
    scene.system.damping_ratios = exact<T>(q.damping_ratios);
    scene.system.contact = Mass{static_cast<std::size_t>(place(q.contact, "contact", N))};
    scene.system.load = Mass{static_cast<std::size_t>(place(q.load, "load", N))};
    scene.mu = T(q.mu);
    scene.r = T(q.r);
    scene.beta = T(q.beta);
    check(scene);
    if (quantity(q.quantity).of_mass) static_cast<void>(place(q.mass, "mass", N));
    return scene;
}

nlohmann::ordered_json question_json(const Question& q) {
    nlohmann::ordered_json scene = {{"mass_ratios", q.mass_ratios},
                                    {"stiffness_ratios", q.stiffness_ratios},
                                    {"damping_ratios", q.damping_ratios},
                                    {"contact", q.contact},
                                    {"load", q.load},
                                    {"mu", q.mu},
                                    {"r", q.r},
                                    {"beta", q.beta}};
    nlohmann::ordered_json object = {{"id", q.id}, {"quantity", q.quantity}, {"scene", std::move(scene)}};
    if (quantity(q.quantity).of_mass) object["mass"] = q.mass;
    if (q.quantity == "displacement") object["tau"] = q.tau;
    if (quantity(q.quantity).shape == Shape::samples) object["samples"] = q.samples;
    return object;
}

std::string question_plain(const Question& q) {
    std::ostringstream line;
    line << q.id << ' ' << q.quantity << ' ' << q.mass_ratios.size() << ' ' << q.contact << ' ' << q.load << ' ' << q.mass << ' '
         << q.samples << ' ' << number_to_text(q.tau) << ' ' << number_to_text(q.mu) << ' ' << number_to_text(q.r) << ' '
         << number_to_text(q.beta);
    for (const auto* list : {&q.mass_ratios, &q.stiffness_ratios, &q.damping_ratios})
        for (const double x : *list) line << ' ' << number_to_text(x);
    return line.str();
}

Question question_from_json(const nlohmann::json& object) {
    if (!object.is_object()) throw InputError("question", "must be a JSON object", dumped(object));
    const auto scene = member<nlohmann::json>(object, "scene");
    Question q;
    q.id = member<std::string>(object, "id");
    q.quantity = quantity(member<std::string>(object, "quantity")).name;
    q.mass_ratios = member<std::vector<double>>(scene, "mass_ratios");
    q.stiffness_ratios = member<std::vector<double>>(scene, "stiffness_ratios");
    q.damping_ratios = member<std::vector<double>>(scene, "damping_ratios");
    q.contact = whole(scene, "contact");
    q.load = whole(scene, "load");
    q.mu = member<double>(scene, "mu");
    q.r = member<double>(scene, "r");
    q.beta = member<double>(scene, "beta");
    if (object.contains("mass")) q.mass = whole(object, "mass");
    if (object.contains("tau")) q.tau = member<double>(object, "tau");
    if (object.contains("samples")) q.samples = whole(object, "samples");
    return q;
}

Answer answer_from_json(std::string_view line, std::string_view id) {
    if (nested_too_deeply(line)) return Unusable{in_quotes(line) + " is nested too deeply"};
    const nlohmann::json object = json_or_nothing(line);
    if (!object.is_object()) return Unusable{in_quotes(line) + " is no JSON object"};
    const auto text = [&](const char* key) {
        return object[key].is_string() ? object[key].get<std::string>() : dumped(object[key]);
    };
    if (!object.contains("id")) return Unusable{"the answer has no id"};
    if (text("id") != id) return Unusable{"the answer is to " + in_quotes(text("id")) + ", the question was " + std::string(id)};
    if (object.contains("skip")) return Skipped{text("skip")};
    if (object.contains("reject")) return Rejected{text("reject")};
    if (!object.contains("value")) return Unusable{"the answer has neither value nor reject nor skip"};
    const nlohmann::json& value = object["value"];
    std::vector<std::string> words;
    for (const nlohmann::json& x : value.is_array() ? value : nlohmann::json::array({value})) {
        const std::optional<std::string> word = word_of(x);
        if (!word) return Unusable{in_quotes(dumped(x)) + " is no number"};
        words.push_back(*word);
    }
    return value_of_words(words);
}

Answer answer_from_plain(std::string_view line, std::string_view id) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) return Unusable{"the answer is an empty line"};
    if (words.front() != id)
        return Unusable{"the answer is to " + in_quotes(words.front()) + ", the question was " + std::string(id)};
    if (words.size() < 2) return Unusable{"the answer has neither value nor reject nor skip"};
    std::string rest;
    for (std::size_t n = 2; n < words.size(); ++n) rest += (n > 2 ? " " : "") + words[n];
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

template Scene<double> scene_of(const Question&);
template Scene<Real50> scene_of(const Question&);
template Scene<Real100> scene_of(const Question&);

} // namespace denhartog::conformance
