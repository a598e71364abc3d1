// solvers_table FOLDER: makes solvers.json and solvers.md from FOLDER/solvers/runs.json and the reports that it names.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> tiers = {"must", "should", "stress"};

Json read(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    return Json::parse(in);
}

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    if (!(out << text)) throw std::runtime_error("cannot write " + file.string());
}

// Verdicts of a tier, with the digits of the numbers among the answers.
Json tier_of(const Json& report, const std::string& tier) {
    std::map<std::string, int> verdicts;
    std::vector<std::pair<double, std::string>> digits;
    int asked = 0;
    for (const Json& result : report.at("results")) {
        if (result.at("tier") != tier) continue;
        ++asked;
        ++verdicts[result.at("verdict").get<std::string>()];
        if (result.contains("digits")) digits.emplace_back(result.at("digits").get<double>(), result.at("id").get<std::string>());
    }
    Json object = {{"tier", tier}, {"asked", asked}, {"verdicts", verdicts}};
    if (digits.empty()) return object;
    std::ranges::sort(digits);
    const std::size_t half = digits.size() / 2;
    object["median_digits"] = digits.size() % 2 == 1 ? digits[half].first : (digits[half - 1].first + digits[half].first) / 2;
    object["worst_digits"] = digits.front().first;
    object["worst_id"] = digits.front().second;
    return object;
}

Json solver_of(const Json& run, const std::filesystem::path& folder) {
    const Json report = read(folder / run.at("report").get<std::string>());
    Json object = {{"solver", report.at("subject")}, {"package", run.at("package")}, {"version", run.at("version")},
                   {"seconds", run.at("seconds")},   {"jobs", run.at("jobs")},       {"tiers", Json::array()}};
    for (const char* tier : tiers)
        if (Json one = tier_of(report, tier); one.at("asked") > 0) object["tiers"].push_back(std::move(one));
    return object;
}

std::string one_decimal(const Json& object, const char* key) {
    if (!object.contains(key)) return "";
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f", object[key].get<double>());
    return text.data();
}

std::string row(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
}

std::string rows_of(const Json& solver, const std::vector<std::string>& verdicts) {
    std::string text;
    for (const Json& tier : solver["tiers"]) {
        std::vector<std::string> cells = {solver["solver"].get<std::string>(), tier["tier"].get<std::string>(),
                                          std::to_string(tier["asked"].get<int>())};
        for (const std::string& verdict : verdicts) cells.push_back(std::to_string(tier["verdicts"].value(verdict, 0)));
        cells.push_back(one_decimal(tier, "median_digits"));
        cells.push_back(one_decimal(tier, "worst_digits"));
        cells.push_back(tier.value("worst_id", ""));
        text += row(cells);
    }
    return text;
}

std::string markdown(const Json& solvers) {
    std::vector<std::string> verdicts; // those that were given
    for (const char* verdict : {"pass", "pass-loose", "rejected", "inaccurate", "as-printed", "wrong", "wrong-regime",
                                "not-rejected", "skipped", "crash", "timeout", "stall"})
        for (const Json& solver : solvers)
            if (std::ranges::any_of(solver["tiers"], [&](const Json& tier) { return tier["verdicts"].contains(verdict); })) {
                verdicts.emplace_back(verdict);
                break;
            }
    std::vector<std::string> heading = {"solver", "tier", "asked"};
    heading.insert(heading.end(), verdicts.begin(), verdicts.end());
    heading.insert(heading.end(), {"median digits", "worst digits", "worst"});
    std::string text = row(heading) + row(std::vector<std::string>(heading.size(), "---"));
    for (const Json& solver : solvers) text += rows_of(solver, verdicts);
    text += "\n";
    for (const Json& solver : solvers)
        text += "- " + solver["solver"].get<std::string>() + ": " + solver["package"].get<std::string>() + " " +
                solver["version"].get<std::string>() + ", " + std::to_string(std::lround(solver["seconds"].get<double>())) +
                " s for all questions, " + std::to_string(solver["jobs"].get<int>()) + " at a time\n";
    return text;
}

} // namespace

int main(int arguments, char** argument) {
    if (arguments != 2) {
        std::cerr << "usage: solvers_table FOLDER\n";
        return 2;
    }
    try {
        const std::filesystem::path folder = argument[1];
        Json solvers = Json::array();
        for (const Json& run : read(folder / "solvers" / "runs.json")) solvers.push_back(solver_of(run, folder / "solvers"));
        write(folder / "solvers.json", solvers.dump(1) + "\n");
        write(folder / "solvers.md", markdown(solvers));
        std::cout << markdown(solvers);
    } catch (const std::exception& e) {
        std::cerr << "solvers_table: " << e.what() << "\n";
        return 1;
    }
    return 0;
}
