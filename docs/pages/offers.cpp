#include "offers.hpp"

#include <algorithm>
#include <set>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/vector.hpp"
#include "denhartog/ledger/ledger_entry.hpp"
#include "denhartog/number/errors.hpp"
#include "formula_list.hpp"
#include "text.hpp"

namespace denhartog::pages {

using ledger::Json;

namespace {

constexpr std::size_t most_scenes = 6, most_mistakes = 8;

std::string listed(const std::vector<double>& values) {
    std::string out;
    for (const double value : values) out += (out.empty() ? "" : ", ") + digits(value, "%.10g");
    return out;
}

std::string told(const conformance::ProtocolQuestion& q) {
    std::string out = "γ = " + listed(q.mass_ratios) + "; κ = " + listed(q.stiffness_ratios) +
                      "; ζ = " + listed(q.damping_ratios) + "; j = " + std::to_string(q.contact) +
                      ", l = " + std::to_string(q.load) + "; μ = " + digits(q.mu, "%.10g") + "; r = " + digits(q.r, "%.10g") +
                      "; β = " + digits(q.beta, "%.10g");
    if (q.mass > 0) out += "; k = " + std::to_string(q.mass);
    if (q.quantity == "displacement") out += "; τ = " + digits(q.tau, "%.10g");
    return out;
}

/// The answers of the mistakes that get a question wrong: those of its equations first.
CheckScene scene_of(const conformance::Vector& vector, const std::string& equation) {
    CheckScene scene{told(vector.question), vector.question.quantity, vector.nearest, {}};
    for (const bool own : {true, false})
        for (const conformance::Mistake& mistake : conformance::mistakes()) {
            const bool of_it = mistake.equation == equation;
            if (of_it != own || scene.mistakes.size() >= most_mistakes) continue;
            if (!std::binary_search(vector.catches.begin(), vector.catches.end(), mistake.name)) continue;
            const auto answer = conformance::answer_with_mistake(mistake.name, vector.question);
            if (answer && answer->numbers.size() == vector.nearest.size())
                scene.mistakes.emplace_back(mistake.told, answer->numbers);
        }
    return scene;
}

std::string json_of(const CheckScene& scene) {
    Json mistakes = Json::array();
    for (const auto& [what, numbers] : scene.mistakes) mistakes.push_back({{"what", what}, {"value", numbers}});
    return Json{{"scene", scene.scene}, {"quantity", scene.quantity}, {"right", scene.right}, {"mistakes", mistakes}}.dump();
}

const OfferedFormula* offered(const std::string& equation) {
    const auto& all = offered_formulas();
    const auto found = std::find_if(all.begin(), all.end(), [&](const OfferedFormula& f) { return f.equation == equation; });
    return found == all.end() ? nullptr : &*found;
}

/// A value to start from, inside the domain of every formula.
std::string sample_of(const std::string& argument) {
    static const std::map<std::string, std::string> samples = {
        {"R", "0.8"},       {"zeta", "0.05"},    {"tau", "1"},          {"beta", "0.3"},     {"mu", "1.5"},
        {"V_dk_re", "1.2"}, {"V_dk_im", "-0.4"}, {"V_dj_re", "0.9"},    {"V_dj_im", "-0.7"}, {"U_dj", "0.25"},
        {"U_dk", "0.15"},   {"U_j", "0.25"},     {"U_k", "0.15"},       {"G_j", "0.1"},      {"G_k", "0.12"},
        {"psi_ji", "0.6"},  {"psi_li", "0.7"},   {"psi_ki", "0.5"},     {"eta_0", "0.8"},    {"eta_prime_0", "-0.3"},
        {"phi_j", "0.4"},   {"sgn_x_dot", "1"},  {"X_j", "1.1"},        {"S_dj", "1.3"},     {"H_j", "0.4"},
        {"gamma_j", "2"},   {"r", "0.9"},        {"k_1", "3"},          {"P", "2"},          {"m_1", "2"},
        {"omega", "1.5"},   {"A", "-1.7"},       {"B", "0.4"},          {"C", "0.9"},        {"Q", "1.2"},
        {"V_k_abs", "6"},   {"x_k0", "0.6"},     {"x_prime_k0", "-0.2"}};
    const auto found = samples.find(argument);
    return found == samples.end() ? "1" : found->second;
}

std::string sample_of_modes(const std::string& argument) {
    static const std::map<std::string, std::string> samples = {
        {"R", "0.8, 0.3"}, {"zeta", "0.05, 0.03"}, {"psi_k", "0.6, 0.7"}, {"psi_j", "0.6, -0.7"}, {"psi_l", "0.5, 0.8"}};
    return samples.at(argument);
}

std::string block(const std::string& language, const std::string& shown, const std::string& code) {
    return "<details class=\"copy\">\n<summary>" + shown +
           "</summary>\n<button type=\"button\" class=\"copy-code\">Copy</button>\n<pre tabindex=\"0\"><code class=\"" +
           language + "\">" + html(code) + "</code></pre>\n</details>\n";
}

} // namespace

std::map<std::string, std::vector<CheckScene>> check_scenes(const std::filesystem::path& vectors) {
    std::map<std::string, std::vector<CheckScene>> scenes;
    std::map<std::string, std::string> equation_of;
    for (const conformance::Mistake& mistake : conformance::mistakes()) equation_of[mistake.name] = mistake.equation;
    for (const conformance::Vector& vector : conformance::read_vectors(vectors)) {
        if (vector.tier == "stress" || !vector.reject.empty() || vector.nearest.empty() || vector.nearest.size() > 2) continue;
        std::set<std::string> equations{vector.equation};
        for (const std::string& name : vector.catches)
            if (const auto found = equation_of.find(name); found != equation_of.end()) equations.insert(found->second);
        for (const std::string& equation : equations) {
            if (equation.empty() || scenes[equation].size() >= most_scenes) continue;
            CheckScene scene = scene_of(vector, equation);
            if (!scene.mistakes.empty()) scenes[equation].push_back(std::move(scene));
        }
    }
    return scenes;
}

std::string copy_text(const std::string& equation, const std::string& latex) {
    std::string out = "\\htmlonly[block]\n<div class=\"copies\">\n<p>Copy as</p>\n" + block("latex", "LaTeX", latex + "\n");
    if (const OfferedFormula* formula = offered(equation); formula != nullptr) {
        const bool pair = formula->holds.results.size() > 1;
        const std::string headers = std::string("#include <cmath>\n") + (pair ? "#include <complex>\n" : "") +
                                    "#include <numbers>\n" + (formula->holds.of_modes.empty() ? "" : "#include <vector>\n") +
                                    "\n";
        const std::string from = " Eq. (" + equation + ") of doi:10.1016/j.jsv.2022.117085, as denhartog computes it.\n";
        out += block("cxx", "C++", headers + "//" + from + code_of(formula->holds, Language::cxx)) +
               block("python", "Python", "import numpy as np\n\n\n#" + from + code_of(formula->holds, Language::python)) +
               block("matlab", "MATLAB", "%" + from + code_of(formula->holds, Language::matlab));
    }
    return out + "</div>\n\\endhtmlonly\n";
}

std::string check_text(const std::string& equation, const std::vector<CheckScene>& scenes) {
    const OfferedFormula* formula = offered(equation);
    if (formula == nullptr && scenes.empty()) return {};
    const std::string id = equation_label(equation);
    std::string out = "\\htmlonly[block]\n<form class=\"check\" id=\"" + id + "_check_form\">\n";
    if (formula != nullptr && !scenes.empty())
        out += "<p><label for=\"" + id + "_scene\">Inputs</label> <select id=\"" + id +
               "_scene\" name=\"scene\"><option value=\"\">my own</option>";
    else if (!scenes.empty())
        out += "<p><label for=\"" + id + "_scene\">Inputs</label> <select id=\"" + id + "_scene\" name=\"scene\">";
    for (std::size_t i = 0; i < scenes.size(); ++i)
        out += "<option value=\"" + std::to_string(i) + "\">" + html(scenes[i].quantity) + ": " + html(scenes[i].scene) +
               "</option>";
    if (!scenes.empty()) out += "</select></p>\n";
    if (formula != nullptr) {
        out += "<fieldset class=\"inputs\"><legend>\\(" + html(formula->what) + "\\) at</legend>\n";
        for (const std::string& argument : formula->holds.arguments) {
            const auto& modes = formula->holds.of_modes;
            const bool of_modes = std::find(modes.begin(), modes.end(), argument) != modes.end();
            out += "<label>" + html(argument) + " <input name=\"" + html(argument) + "\" value=\"" +
                   (of_modes ? sample_of_modes(argument) : sample_of(argument)) + "\" size=\"" + (of_modes ? "14" : "7") +
                   "\"></label>\n";
        }
        out += "</fieldset>\n";
    }
    const bool pair = formula != nullptr && formula->holds.results.size() > 1;
    out += "<p><label>Your number <input name=\"number\" size=\"24\" autocomplete=\"off\" placeholder=\"" +
           std::string(pair ? "real part, imaginary part" : "0.123456789") +
           "\"></label> <button type=\"submit\">Check</button></p>\n<p class=\"verdict-of-number\" "
           "role=\"status\"></p>\n</form>\n<script>\n"
           "window.checks = window.checks || {};\nwindow.checks[\"" +
           id + "_check_form\"] = {";
    if (formula != nullptr) {
        out += "\narguments: " + Json(formula->holds.arguments).dump() + ", ofModes: " + Json(formula->holds.of_modes).dump() +
               ",\nholds: " + code_of(formula->holds, Language::javascript) + ",";
        if (!formula->printed.results.empty()) out += "\nprinted: " + code_of(formula->printed, Language::javascript) + ",";
    }
    out += "\nscenes: [";
    for (const CheckScene& scene : scenes) out += "\n" + json_of(scene) + ",";
    return out + "]};\n</script>\n\\endhtmlonly\n";
}

} // namespace denhartog::pages
