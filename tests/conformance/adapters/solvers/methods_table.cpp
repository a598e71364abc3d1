// methods_table VECTORS FOLDER METHOD=REPORT...: what solvers of a method do at everyday settings, against the tolerances that
// `denhartog conform --method` gives it. A report is one of `conform run --format json` by the vectors' own tolerances. Leaves
// FOLDER/methods.md; status 1 where a tolerance is below what the reports show, or above ten times as much.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "conformance/verdict.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"

namespace {

using namespace denhartog;
using namespace denhartog::conformance;
using Json = nlohmann::json;

// Errors of the answers of a method's solvers.
struct Shown {
    std::map<std::string, std::vector<double>> errors; // over scale and condition number, by kind of quantity
    double margin = 0;                                 // the largest at which a regime was wrong
};

void take(Shown& shown, const Json& report, const std::map<std::string, const Vector*>& vectors, const SolverMethod& method) {
    for (const Json& result : report.at("results")) {
        const Vector& v = *vectors.at(result.at("id"));
        if (v.question.quantity == "regime" && result.at("verdict") == "wrong-regime")
            shown.margin = std::max(shown.margin, v.margin.value_or(0));
        const std::string kind = kind_of(v.question);
        if (kind.empty() || !result.contains("error") || result["error"].is_null() || !excuse_for(v, method).empty()) continue;
        shown.errors[kind].push_back(result["error"].get<double>() / condition_of(v));
    }
}

double share(const std::vector<double>& sorted, double part) {
    return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(part * static_cast<double>(sorted.size())))];
}

bool allows(double given, double shown) { return shown <= given && given <= 10 * shown; }

std::string number(double x) { return number_in_digits(x, 2); }

std::string row_of(const SolverMethod& method, const std::string& kind, std::vector<double> errors, bool& good) {
    std::sort(errors.begin(), errors.end());
    const Tolerance& given = kind == "displacement" ? method.displacement : kind == "phase" ? method.phase : method.duration;
    const bool fits = allows(given.pass, share(errors, 0.5)) && allows(given.loose, share(errors, 0.99));
    good = good && fits;
    return "| " + std::string(method.name) + " | " + kind + " | " + std::to_string(errors.size()) + " | " +
           number(share(errors, 0.5)) + " | " + number(share(errors, 0.99)) + " | " + number(errors.back()) + " | " +
           number(given.pass) + " | " + number(given.loose) + " | " + number(given.inaccurate) + " | " + (fits ? "yes" : "NO") +
           " |\n";
}

Json report_in(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw InputError("report", "must be readable", file);
    return Json::parse(in);
}

int run(const std::string& vectors_folder, const std::string& folder, const std::vector<std::string>& reports) {
    const std::vector<Vector> all = read_vectors(vectors_folder);
    std::map<std::string, const Vector*> vectors;
    for (const Vector& v : all) vectors[v.question.id] = &v;
    std::map<std::string, Shown> shown;
    for (const std::string& each : reports) {
        const std::size_t mark = each.find('=');
        const SolverMethod& method = method_named(each.substr(0, mark));
        take(shown[std::string(method.name)], report_in(each.substr(mark + 1)), vectors, method);
    }
    bool good = true;
    std::string text = "| method | of | answers | median | 99 of 100 | worst | pass | pass-loose | inaccurate | fits |\n"
                       "|---|---|--:|--:|--:|--:|--:|--:|--:|---|\n",
                margins;
    for (const auto& [name, of_method] : shown) {
        const SolverMethod& method = method_named(name);
        for (const auto& [kind, errors] : of_method.errors) text += row_of(method, kind, errors, good);
        const bool fits = allows(method.margin, of_method.margin);
        good = good && fits;
        margins += "- " + name + ": a regime is wrong up to " + number(of_method.margin) + " from its boundary; the margin is " +
                   number(method.margin) + (fits ? "" : ", which does NOT fit") + "\n";
    }
    std::ofstream(folder + "/methods.md") << text << "\n" << margins;
    std::cout << text << "\n" << margins;
    return good ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::cerr << "usage: methods_table VECTORS FOLDER METHOD=REPORT...\n";
        return 2;
    }
    try {
        return run(argv[1], argv[2], {argv + 3, argv + argc});
    } catch (const std::exception& e) {
        std::cerr << "methods_table: " << e.what() << "\n";
        return 2;
    }
}
