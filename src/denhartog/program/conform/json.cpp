// The report of a conformance run as JSON, and the file of verdicts with which a later run is compared. Read `report_json`, then
// `tracked_verdicts` and `compare`.
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "conformance/verdict.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/program/conform/conform.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/scene/json_document.hpp"

namespace denhartog::program {
namespace {

using conformance::Judged;
using conformance::Verdict;
using Json = nlohmann::ordered_json;

Json optional_number(const std::optional<double>& x) { return x && std::isfinite(*x) ? Json(*x) : Json(); }

template <class All, class Of>
Json list_of(const All& all, const Of& of) {
    Json list = Json::array();
    for (const auto& one : all) list.push_back(of(one));
    return list;
}

Json counts_json(const conformance::Counts& counts) {
    Json object = Json::object();
    for (std::size_t n = 0; n < counts.size(); ++n) object[std::string(name(static_cast<Verdict>(n)))] = counts[n];
    return object;
}

Json value_json(const conformance::Value& value) { return value.word.empty() ? Json(value.numbers) : Json(value.word); }

Json result_json(const Judged& one) {
    const conformance::Vector& v = *one.vector;
    Json object = {{"id", v.question.id},
                   {"group", v.group},
                   {"tier", v.tier},
                   {"quantity", v.question.quantity},
                   {"verdict", name(one.verdict)}};
    if (!one.equation.empty()) object["equation"] = one.equation;
    if (!one.reason.empty()) object["reason"] = one.reason;
    if (one.answered) object["answer"] = value_json(one.given);
    if (!one.given.numbers.empty()) object["answer_hex"] = list_of(one.given.numbers, conformance::hexadecimal_float);
    if (!v.reject.empty()) return object;
    object["truth"] = v.word.empty() ? Json(v.value) : Json(v.word);
    if (!v.word.empty()) return object;
    object["truth_hex"] = list_of(v.nearest, conformance::hexadecimal_float);
    if (!one.error) return object;
    object["error"] = optional_number(one.error);
    object["worst_number"] = one.worst;
    object["digits"] = conformance::digits(*one.error);
    object["error_over_tolerance"] = optional_number(conformance::error_over_tolerance(one));
    object["condition"] = Json::object();
    for (const auto& [input, number] : v.condition) object["condition"][input] = number;
    return object;
}

Json finding_json(const conformance::Finding& f) {
    return {{"mistake", f.mistake.name},
            {"equation", f.mistake.equation},
            {"as_printed", f.mistake.as_printed},
            {"told", f.mistake.told},
            {"look_at", f.mistake.look_at},
            {"explained", f.explained},
            {"contradicted", f.contradicted},
            {"weak", f.weak},
            {"number", f.mistake.number},
            {"quantities", f.quantities},
            {"example",
             {{"id", f.example->vector->question.id},
              {"answer", value_json(f.example->given)},
              {"mistaken", value_json(f.mistaken)},
              {"truth", value_json(truth_of(*f.example->vector))}}}};
}

Json in_common_json(const conformance::InCommon& one) {
    return {{"property", one.property}, {"wrong", one.wrong}, {"of_wrong", one.all_wrong}, {"answers", one.asked}};
}

Json diagnosis_json(const conformance::Diagnosis& d) {
    Json object = {{"wrong", d.wrong}, {"findings", list_of(d.findings, finding_json)}};
    object["unexplained"] = list_of(d.unexplained, [](const Judged* one) { return one->vector->question.id; });
    object["chain"] = list_of(d.chain, [](const conformance::InCommon& link) {
        return Json{{"link", link.property}, {"answers", link.asked}, {"wrong", link.wrong}};
    });
    object["simple"] = list_of(d.simple, [](const conformance::Finding& one) {
        return Json{{"told", one.mistake.told},
                    {"explained", one.explained},
                    {"contradicted", one.contradicted},
                    {"quantities", one.quantities}};
    });
    object["by_quantity"] = list_of(d.by_quantity, in_common_json);
    object["in_common"] = list_of(d.in_common, in_common_json);
    object["accepted"] = d.accepted;
    return object;
}

Json change_json(const Change& c) { return {{"id", c.id}, {"before", name(c.before)}, {"now", name(c.now)}}; }

Json score_json(const conformance::Score& score) {
    return {{"tier", score.tier},
            {"group", score.group},
            {"asked", score.asked},
            {"counts", counts_json(score.counts)},
            {"median_digits", optional_number(score.median_digits)},
            {"worst_digits", optional_number(score.worst_digits)}};
}

} // namespace

std::string report_json(const ConformReport& report) {
    Json object = {{"format", 1}, {"subject", report.name}};
    if (!report.options.command.empty()) object["command"] = shell_text(report.options.command);
    if (!report.dialect.empty()) object["dialect"] = report.dialect;
    object["method"] = report.options.method;
    object["status"] = report.status();
    object["conforms"] = report.conforms;
    object["broken"] = report.broken;
    if (!report.cut_short.empty()) object["cut_short"] = report.cut_short;
    object["needed"] = report.options.needed;
    object["counts"] = counts_json(conformance::counts_of(report.judged));
    object["scores"] = list_of(conformance::scores(report.judged), score_json);
    object["diagnosis"] = diagnosis_json(report.diagnosis);
    object["notes"] = report.notes;
    if (report.changes)
        object["since"] = {{"better", list_of(report.changes->better, change_json)},
                           {"worse", list_of(report.changes->worse, change_json)}};
    object["results"] = list_of(report.judged, result_json);
    return object.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

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
        const auto verdict = text.is_string() ? conformance::verdict_named(text.get<std::string>()) : std::nullopt;
        if (!verdict) throw InputError(no_such_file);
        verdicts.emplace(id, *verdict);
    }
    return verdicts;
}

Comparison compare(const Verdicts& before, std::span<const Judged> judged) {
    Comparison changes;
    // Fewer digits of a right answer, and a wrong answer where there was none, are no step back.
    const auto rank = [](Verdict verdict) { return conformance::is_right(verdict) ? 0 : conformance::badness(verdict); };
    for (const Judged& one : judged) {
        const auto earlier = before.find(one.vector->question.id);
        if (earlier == before.end()) continue;
        const int change = rank(one.verdict) - rank(earlier->second);
        if (change < 0) changes.better.push_back({earlier->first, earlier->second, one.verdict});
        if (change > 0 && earlier->second != Verdict::skipped)
            changes.worse.push_back({earlier->first, earlier->second, one.verdict});
    }
    return changes;
}

std::string tracked_text(Verdicts before, std::span<const Judged> judged) {
    for (const Judged& one : judged) before[one.vector->question.id] = one.verdict;
    Json file = {{"format", 1}, {"verdicts", Json::object()}};
    for (const auto& [id, verdict] : before) file["verdicts"][id] = conformance::name(verdict);
    return file.dump(1) + "\n";
}

} // namespace denhartog::program
