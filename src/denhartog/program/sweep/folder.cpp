#include "denhartog/program/sweep/folder.hpp"

#include <filesystem>

#include "denhartog/number/errors.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/sweep/sha256.hpp"
#include "denhartog/version.hpp"

namespace denhartog::program {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

} // namespace

std::string fingerprint_of(const std::string& study, const std::string& commit) {
    const json of{{"program", "denhartog " DENHARTOG_VERSION}, {"commit", commit}, {"study", json_or_nothing(study)}};
    return sweep::sha256(of.dump());
}

StudyFolder open_study(const std::string& path, const std::string& commit) {
    std::error_code fault;
    if (!fs::is_regular_file(path + "/plan.json", fault))
        throw InputError("the folder", "must be one that `sweep plan` has written", path);
    const json plan = json_or_nothing(read_input(path + "/plan.json"));
    const std::string study = read_input(path + "/study.json");
    const std::string fingerprint = fingerprint_of(study, commit);
    if (!plan.is_object() || plan.value("fingerprint", "") != fingerprint)
        throw InputError("the plan",
                         "must be of the same program and the same study: this is denhartog " DENHARTOG_VERSION " " + commit +
                             "; plan the study anew",
                         plan.is_object() ? plan.value("program", "") + " " + plan.value("commit", "") : "no JSON object");
    return {path, sweep::plan_of(sweep::read_study(study)), fingerprint};
}

std::string path_of_record(const StudyFolder& study, std::size_t K) { return study.file("done/" + std::to_string(K) + ".json"); }

std::string text_of(const Record& record) {
    nlohmann::ordered_json out{{"chunk", record.chunk}, {"fingerprint", record.fingerprint}, {"seconds", record.seconds}};
    for (std::size_t n = 0; n < record.points.size(); ++n) out["points"][sweep::statuses[n]] = record.points[n];
    out["files"] = json::array();
    for (const Record::File& each : record.files)
        out["files"].push_back({{"path", each.path}, {"bytes", each.bytes}, {"sha256", each.sha256}});
    return out.dump(1) + "\n";
}

std::optional<Record> record_of(const StudyFolder& study, std::size_t K) {
    std::error_code fault;
    if (!fs::exists(path_of_record(study, K), fault)) return std::nullopt;
    Record record;
    try {
        const json in = json_or_nothing(read_input(path_of_record(study, K)));
        in.at("chunk").get_to(record.chunk);
        in.at("fingerprint").get_to(record.fingerprint);
        in.at("seconds").get_to(record.seconds);
        for (std::size_t n = 0; n < record.points.size(); ++n) in.at("points").at(sweep::statuses[n]).get_to(record.points[n]);
        for (const json& each : in.at("files")) record.files.push_back({each.at("path"), each.at("bytes"), each.at("sha256")});
    } catch (const json::exception&) {
        record.files.clear();
    }
    return record;
}

std::string fault_of(const StudyFolder& study, std::size_t K, const Record& record) {
    if (record.files.empty()) return "its record cannot be read";
    if (record.fingerprint != study.fingerprint) return "it was left by another program or another study";
    const std::vector<std::string> paths = sweep::paths_of(study.plan, K);
    bool same = record.chunk == K && record.files.size() == paths.size();
    for (std::size_t n = 0; same && n < paths.size(); ++n) same = record.files[n].path == paths[n];
    if (!same) return "its record names other files than the plan";
    for (const Record::File& each : record.files) {
        std::error_code fault;
        const std::uintmax_t size = fs::file_size(study.file(each.path), fault);
        if (fault) return each.path + " is missing";
        if (size != each.bytes)
            return each.path + " has " + std::to_string(size) + " bytes, its record says " + std::to_string(each.bytes);
        if (sweep::sha256(read_input(study.file(each.path))) != each.sha256)
            return each.path + " has another checksum than its record";
    }
    return {};
}

std::string ranges_of(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (std::size_t n = 0; n < numbers.size();) {
        std::size_t m = n;
        while (m + 1 < numbers.size() && numbers[m + 1] == numbers[m] + 1) ++m;
        if (text.size() > 90) return text + ", ...";
        text += (text.empty() ? "" : ", ") + std::to_string(numbers[n]) + (m > n ? "-" + std::to_string(numbers[m]) : "");
        n = m + 1;
    }
    return text;
}

} // namespace denhartog::program
