#include "denhartog/program/conform/report.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "denhartog/number/errors.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/scene/json_document.hpp"

namespace denhartog::program {

using conformance::Judged;
using conformance::Verdict;

std::optional<Verdicts> tracked_verdicts(const std::string& path) {
    std::error_code fault;
    if (!std::filesystem::exists(path, fault)) return std::nullopt;
    const nlohmann::json file = json_or_nothing(read_input(path));
    const InputError no_such_file("track", "must be a file that --track has written", path);
    if (!file.is_object() || file.value("format", nlohmann::json()) != 1 || !file.contains("verdicts") ||
        !file["verdicts"].is_object())
        throw InputError(no_such_file);
    Verdicts verdicts;
    for (const auto& [id, text] : file["verdicts"].items()) {
        const std::optional<Verdict> verdict =
            text.is_string() ? conformance::verdict_named(text.get_ref<const std::string&>()) : std::nullopt;
        if (!verdict) throw InputError(no_such_file);
        verdicts.emplace(id, *verdict);
    }
    return verdicts;
}

Comparison compare(const Verdicts& before, std::span<const Judged> judged) {
    Comparison changes;
    for (const Judged& one : judged) {
        const auto earlier = before.find(one.vector->question.id);
        if (earlier == before.end()) continue;
        const int change = conformance::badness(one.verdict) - conformance::badness(earlier->second);
        if (change < 0) changes.better.push_back({earlier->first, earlier->second, one.verdict});
        if (change > 0) changes.worse.push_back({earlier->first, earlier->second, one.verdict});
    }
    return changes;
}

std::string tracked_text(Verdicts before, std::span<const Judged> judged) {
    for (const Judged& one : judged) before[one.vector->question.id] = one.verdict;
    nlohmann::ordered_json file = {{"format", 1}, {"verdicts", nlohmann::ordered_json::object()}};
    for (const auto& [id, verdict] : before) file["verdicts"][id] = conformance::name(verdict);
    return file.dump(1) + "\n";
}

} // namespace denhartog::program
