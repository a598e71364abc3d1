#include "tests/conformance/generator/vector_files.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/parallel.hpp"
#include "tests/support/sha256.hpp"

namespace denhartog::conformance::generator {
namespace {

using Json = nlohmann::ordered_json;

unsigned threads() { return std::max(1U, std::thread::hardware_concurrency()); }

Json counts_of(const std::map<std::string, int>& tiers) {
    Json counts = Json::object();
    for (const char* tier : {"must", "should", "stress"})
        if (const auto found = tiers.find(tier); found != tiers.end()) counts[tier] = found->second;
    return counts;
}

std::string manifest_of(const std::vector<Vector>& vectors, const std::map<std::string, std::string>& files) {
    std::map<std::string, std::map<std::string, int>> groups;
    std::map<std::string, int> tiers;
    for (const Vector& v : vectors) {
        ++groups[v.group][v.tier];
        ++tiers[v.tier];
    }
    Json manifest{
        {"format", format_version}, {"content", content_version}, {"vectors", vectors.size()}, {"tiers", counts_of(tiers)}};
    for (const auto& [group, counts] : groups) manifest["groups"][group] = counts_of(counts);
    for (const auto& [name, bytes] : files)
        manifest["files"].push_back({{"name", name}, {"bytes", bytes.size()}, {"sha256", denhartog::tests::sha256(bytes)}});
    return manifest.dump(1) + "\n";
}

// Gives every line of the vector files with the group that it is of, and says where a fault is.
void for_each_line(const std::filesystem::path& folder,
                   const std::function<void(const std::string& group, const std::string& line)>& take) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
    std::ranges::sort(files);
    for (const std::filesystem::path& file : files) {
        std::istringstream lines(bytes_of(file));
        int number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            try {
                take(file.stem().string(), line);
            } catch (const std::exception& e) {
                throw std::runtime_error(file.filename().string() + ", line " + std::to_string(number) + ": " + e.what());
            }
        }
    }
}

Vector asked_in(const nlohmann::json& line, const std::string& group) {
    Vector asked;
    asked.question = question_from_json(line);
    asked.group = group;
    asked.tier = line.value("tier", "must");
    asked.flags = line.value("flags", asked.flags);
    asked.reject = line.value("reject", "");
    if (asked.tier != "must" && asked.tier != "should" && asked.tier != "stress")
        throw InputError("tier", "must be must, should or stress", asked.tier);
    return asked;
}

} // namespace

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    if (!stream) throw InputError("file", "must be readable", file.string());
    return bytes.str();
}

std::map<std::string, std::string> files_of(const std::vector<Vector>& vectors, const std::string& schema) {
    std::map<std::string, std::string> files{{"schema.json", schema}};
    for (const Vector& v : vectors) files[v.group + ".jsonl"] += vector_json(v).dump() + "\n";
    std::string manifest = manifest_of(vectors, files);
    files["manifest.json"] = std::move(manifest);
    return files;
}

std::vector<std::string> manifest_faults(const std::filesystem::path& folder) {
    std::vector<std::string> faults;
    const nlohmann::json manifest = nlohmann::json::parse(bytes_of(folder / "manifest.json"));
    std::map<std::string, nlohmann::json> stated;
    for (const auto& file : manifest.at("files")) stated[file.at("name")] = file;
    for (const auto& [name, file] : stated) {
        if (!std::filesystem::exists(folder / name)) {
            faults.push_back(name + " is missing");
            continue;
        }
        const std::string bytes = bytes_of(folder / name);
        if (bytes.size() != file.at("bytes").get<std::size_t>()) faults.push_back(name + " has another size");
        if (denhartog::tests::sha256(bytes) != file.at("sha256").get<std::string>())
            faults.push_back(name + " has another checksum");
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name != "manifest.json" && stated.count(name) == 0) faults.push_back(name + " is not in the manifest");
    }
    return faults;
}

std::vector<Case> cases_of(const std::filesystem::path& folder) {
    std::vector<Case> cases;
    std::set<std::string> ids;
    nlohmann::json scene;
    for_each_line(folder, [&](const std::string& group, const std::string& line) {
        const nlohmann::json object = nlohmann::json::parse(line);
        Vector asked = asked_in(object, group);
        if (!ids.insert(asked.question.id).second) throw InputError("id", "must be given once", asked.question.id);
        const auto goes_on = [&](const Vector& before) {
            return before.group == group && before.reject.empty() == asked.reject.empty() && object.at("scene") == scene;
        };
        if (cases.empty() || !goes_on(cases.back().front())) cases.emplace_back();
        scene = object.at("scene");
        cases.back().push_back(std::move(asked));
    });
    return cases;
}

std::vector<Vector> stored_but(const std::filesystem::path& folder, const std::set<std::string>& groups) {
    std::vector<Vector> vectors;
    for_each_line(folder, [&](const std::string& group, const std::string& line) {
        if (groups.count(group) == 0) vectors.push_back(vector_from_json(nlohmann::json::parse(line)));
    });
    return vectors;
}

Certified certify_all(const std::filesystem::path& folder, const std::set<std::string>& groups) {
    std::vector<Case> cases = cases_of(folder);
    for (const std::string& group : groups)
        if (!std::filesystem::exists(folder / (group + ".jsonl")))
            throw InputError("group", "must have a file of vectors", group);
    if (!groups.empty()) std::erase_if(cases, [&](const Case& c) { return groups.count(c.front().group) == 0; });
    std::vector<Certified> parts(cases.size());
    std::atomic<std::size_t> done{0};
    parallel_for(cases.size(), threads(), [&](std::size_t n) {
        parts[n] = certify(cases[n]);
        const std::size_t count = ++done;
        if (count % 20 == 0) std::fprintf(stderr, "\r%zu of %zu scenes", count, cases.size());
        return true;
    });
    std::fprintf(stderr, "\n");
    Certified all;
    for (Certified& part : parts) {
        for (Vector& v : part.vectors) all.vectors.push_back(std::move(v));
        for (Refusal& r : part.refusals) all.refusals.push_back(std::move(r));
        for (const std::size_t place : {0U, 1U}) all.least[place] = std::min(all.least[place], part.least[place]);
    }
    return all;
}

std::vector<std::string> differences(const std::filesystem::path& folder, int every, int from) {
    std::map<std::string, std::string> stored;
    const std::vector<Vector> vectors = read_vectors(folder);
    std::set<std::string> wanted;
    for (std::size_t n = static_cast<std::size_t>(from); n < vectors.size(); n += static_cast<std::size_t>(every))
        wanted.insert(vectors[n].question.id);
    for_each_line(folder,
                  [&](const std::string&, const std::string& line) { stored[nlohmann::json::parse(line).at("id")] = line; });
    std::vector<Case> cases;
    for (const Case& c : cases_of(folder))
        if (std::ranges::any_of(c, [&](const Vector& asked) { return wanted.count(asked.question.id) > 0; })) cases.push_back(c);
    std::vector<std::string> told;
    std::set<std::string> missing = wanted;
    std::mutex lock;
    parallel_for(cases.size(), threads(), [&](std::size_t n) {
        const Certified some = certify(cases[n], wanted);
        const std::lock_guard<std::mutex> guard(lock);
        for (const Vector& v : some.vectors) {
            if (vector_json(v).dump() != stored[v.question.id]) told.push_back(v.question.id + " is not what is computed anew");
            missing.erase(v.question.id);
        }
        return true;
    });
    for (const std::string& id : missing) told.push_back(id + " is in the files, and no vector comes of it");
    return told;
}

} // namespace denhartog::conformance::generator
