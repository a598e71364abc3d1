#include "tests/speed_accuracy/accuracy_record.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

namespace denhartog::tests {

namespace {

using Json = nlohmann::ordered_json;

/// The equations that a function of the surveys is named after or belongs to.
const std::map<std::string, std::vector<std::string>> equations_of = {
    {"Re v", {"23"}}, {"Im v", {"23"}}, {"u", {"28"}},
    {"g", {"29"}},    {"d", {"A.8"}},   {"q", {"A.8"}},
    {"d'", {"A.9"}},  {"q'", {"A.9"}},  {"expression of (57)", {"57"}},
    {"(79)", {"79"}}, {"(83)", {"83"}}, {"(84)", {"84"}},
    {"(85)", {"85"}}};

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(); }

Json row(const std::string& function, const std::string& zone, int points, const Worst& printed, const Worst& shipped) {
    return {{"function", function},       {"equations", equations_of.at(function)}, {"zone", zone},
            {"points", points},           {"printed", number(printed.error)},       {"shipped", number(shipped.error)},
            {"shipped_at", shipped.where}};
}

std::string record(const std::string& type, const Json& rows) { return Json{{"type", type}, {"functions", rows}}.dump(1) + "\n"; }

} // namespace

std::string accuracy_record(const std::string& type, const std::vector<ZoneErrors>& zones) {
    const std::array<std::string, 4> functions{"Re v", "Im v", "u", "g"};
    Json rows = Json::array();
    for (std::size_t i = 0; i < functions.size(); ++i)
        for (const ZoneErrors& zone : zones)
            rows.push_back(row(functions[i], zone.zone, zone.points, zone.functions[i].printed, zone.functions[i].by_both));
    return record(type, rows);
}

std::string accuracy_record(const std::string& type, const std::vector<FunctionInZone>& all) {
    Json rows = Json::array();
    for (const FunctionInZone& f : all) rows.push_back(row(f.function, f.zone, f.points, f.printed, f.shipped));
    return record(type, rows);
}

bool keep_record(const std::string& name, const std::string& text) {
    const char* folder = std::getenv("DENHARTOG_RECORDS");
    if (folder == nullptr) return true;
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    std::string stem = name;
    std::replace(stem.begin(), stem.end(), ' ', '_');
    std::ofstream file(std::filesystem::path(folder) / (stem + ".json"));
    file << text;
    file.close();
    return static_cast<bool>(file);
}

} // namespace denhartog::tests
