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

} // namespace

std::string accuracy_record(const std::string& type, const std::vector<FunctionInZone>& all) {
    Json rows = Json::array();
    for (const FunctionInZone& f : all)
        rows.push_back({{"function", f.function},
                        {"equations", equations_of.at(f.function)},
                        {"zone", f.zone},
                        {"points", f.points},
                        {"printed", number(f.printed.error)},
                        {"shipped", number(f.shipped.error)},
                        {"shipped_at", f.shipped.where}});
    return Json{{"type", type}, {"functions", rows}}.dump(1) + "\n";
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
