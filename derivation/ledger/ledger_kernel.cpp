#include "derivation/ledger/ledger_kernel.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>

#include "denhartog/ledger/ledger_entry.hpp"

namespace denhartog::derivation {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json read_if_there(const fs::path& file) {
    if (file.empty() || !fs::exists(file)) return nullptr;
    std::ifstream in(file, std::ios::binary);
    const json content = json::parse(in, nullptr, false);
    if (!in || content.is_discarded()) throw std::runtime_error(file.string() + " is not JSON that can be read");
    return content;
}

/// The name of a claim in the record: one that is in the ledger once for each equation has the equation at its end there.
std::string recorded_name(const json& certificates, const std::string& id) {
    const std::size_t slash = id.rfind('/');
    if (!certificates.contains(id) && slash != std::string::npos && ledger::equation_number(id.substr(slash + 1)))
        return id.substr(0, slash);
    return id;
}

json kernel_of_claim(const KernelRecord& record, const std::string& id) {
    const std::string name = recorded_name(record.certificates, id);
    if (!record.ran || !record.certificates.contains(name)) return {{"status", "not_run"}};
    const json& certificate = record.certificates.at(name);
    const json said = record.claims.value(name, json::object());
    const std::size_t lemmas = certificate.at("lemmas").size();
    json found;
    if (said.value("status", "") == "failed") {
        found = {{"status", "failed"}, {"message", said.at("message")}};
    } else if (certificate.at("status") != "exported") {
        found = {{"status", "not_exported"}, {"reason", certificate.at("reason")}};
    } else {
        found = {{"status", said.value("status", "") == "checked" ? "checked" : "not_run"}};
    }
    if (lemmas > 0) {
        found["file"] = certificate.at("file");
        found["lemmas"] = lemmas;
        if (said.contains("why_not_in_functions")) found["why_not_in_functions"] = said.at("why_not_in_functions");
    }
    return found;
}

std::string status_of(const json& of) { return of.contains("kernel") ? of.at("kernel").value("status", "not_run") : "not_run"; }

/// A theorem by hand with the word of the kernel on it.
json theorem_entry(const KernelRecord& record, const json& theorem) {
    json entry{{"name", theorem.at("name")}, {"status", "not_run"}};
    for (const char* key : {"file", "says"})
        if (theorem.contains(key)) entry[key] = theorem.at(key);
    const auto said = record.theorems_checked.find(theorem.at("name").get<std::string>());
    if (record.ran && said != record.theorems_checked.end()) entry["status"] = *said;
    return entry;
}

bool holds(const json& list, const json& item) { return std::find(list.begin(), list.end(), item) != list.end(); }

/// Verdict of the kernel on an equation, by its claims and theorems.
void add_to_equation(json& entry, const KernelRecord& record) {
    std::map<std::string, int> counts;
    std::string reason;
    for (const json& claim : entry.at("claims")) {
        const json& kernel = claim.at("kernel");
        ++counts[kernel.at("status").get<std::string>()];
        if (reason.empty() && kernel.contains("reason")) reason = kernel.at("reason");
    }
    json kernel{
        {"status", "not_run"}, {"certificates", counts["checked"]}, {"theorems", json::array()}, {"negations", json::array()}};
    const json* row = nullptr;
    for (const json& candidate : record.by_equation)
        if (candidate.at("equation") == entry.at("equation")) row = &candidate;
    for (const json& theorem : record.theorems) {
        const bool listed = row != nullptr && (holds(row->value("theorems", json::array()), theorem.at("name")) ||
                                               holds(row->value("negations", json::array()), theorem.at("name")));
        if (!listed && !holds(theorem.at("equations"), entry.at("equation"))) continue;
        json found = theorem_entry(record, theorem);
        ++counts[found.at("status").get<std::string>()];
        kernel[theorem.value("kind", "theorem") == "negation" ? "negations" : "theorems"].push_back(std::move(found));
    }
    if (counts["failed"] > 0)
        kernel["status"] = "failed";
    else if (counts["checked"] > 0)
        kernel["status"] = "checked";
    else if (record.ran && counts["not_run"] == 0)
        kernel["status"] = "not_exported";
    if (kernel.at("status") == "not_exported") {
        const std::string kind = entry.at("kind"), why = entry.value("no_function", "");
        const std::string by_hand = row == nullptr ? "" : row->value("reason", "");
        kernel["reason"] = !by_hand.empty()                               ? by_hand
                           : !reason.empty()                              ? reason
                           : kind == "definition" || kind == "assumption" ? kind + ": there is nothing to prove"
                           : !why.empty()                                 ? "no claim: " + why
                                                                          : "no claim is made on it";
    }
    entry["kernel"] = std::move(kernel);
}

} // namespace

KernelRecord read_kernel_record(const fs::path& folder, const fs::path& statements) {
    KernelRecord record;
    if (const json list = read_if_there(statements); list.is_array()) record.theorems = list;
    if (statements.has_parent_path())
        if (const json list = read_if_there(statements.parent_path() / "equations.json"); list.is_array())
            record.by_equation = list;
    if (folder.empty()) return record;
    const json exported = read_if_there(folder / "certificates.json"), said = read_if_there(folder / "kernel.json");
    if (exported.is_null() || said.is_null()) return record;
    record.ran = true;
    for (const json& certificate : exported.at("certificates"))
        record.certificates[certificate.at("claim").get<std::string>()] = certificate;
    record.claims = said.at("claims");
    if (const json theorems = read_if_there(folder / "theorems.json"); theorems.is_object()) record.theorems_checked = theorems;
    return record;
}

std::vector<std::string> add_kernel(json& entries, const KernelRecord& record) {
    std::map<std::string, std::string> faults; // a claim may stand at many equations
    for (json& entry : entries) {
        for (json& claim : entry.at("claims")) {
            claim["kernel"] = kernel_of_claim(record, claim.at("id"));
            if (claim.at("kernel").at("status") == "failed")
                faults[claim.at("id")] = "the kernel refuses the certificate of claim " + claim.at("id").get<std::string>();
        }
        add_to_equation(entry, record);
        for (const char* list : {"theorems", "negations"})
            for (const json& theorem : entry.at("kernel").at(list))
                if (theorem.at("status") == "failed")
                    faults[theorem.at("name")] = "the kernel refuses the theorem " + theorem.at("name").get<std::string>();
    }
    std::vector<std::string> sentences;
    for (const auto& [name, sentence] : faults) sentences.push_back(sentence);
    return sentences;
}

std::string kernel_sentence(const json& entries) {
    std::map<std::string, std::string> claims; // id -> status
    std::map<std::string, int> counts, equations;
    for (const json& entry : entries) {
        ++equations[status_of(entry)];
        for (const json& claim : entry.at("claims")) claims[claim.at("id")] = status_of(claim);
    }
    for (const auto& [id, status] : claims) ++counts[status];
    if (counts["checked"] + counts["failed"] + counts["not_exported"] == 0) return "The kernel was not run.";
    std::string sentence = "The kernel has checked the certificates of " + std::to_string(counts["checked"]) + " of " +
                           std::to_string(claims.size()) + " claims; " + std::to_string(counts["not_exported"]) +
                           " are not exported";
    if (counts["not_run"] > 0) sentence += ", " + std::to_string(counts["not_run"]) + " were not run";
    if (counts["failed"] > 0) sentence += ", " + std::to_string(counts["failed"]) + " FAILED";
    return sentence + ". Of " + std::to_string(entries.size()) + " equations " + std::to_string(equations["checked"]) +
           " have a certificate or a theorem that it has checked.";
}

} // namespace denhartog::derivation
