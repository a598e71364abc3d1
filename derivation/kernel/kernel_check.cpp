#include "derivation/kernel/kernel_check.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <vector>

#include "derivation/claims/workers.hpp"

namespace denhartog::derivation {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* unfinished = "kernel_unfinished.json"; // the files of a check that has not come to its end

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream content;
    content << in.rdbuf();
    if (!in) throw std::runtime_error("cannot read " + file.string());
    return content.str();
}

void write(const fs::path& file, const std::string& content) {
    std::ofstream out(file, std::ios::binary);
    out << content << std::flush;
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

/// FNV-1a, 64 bits: whether a file has changed.
std::string checksum(const std::string& text) {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    std::ostringstream out;
    out << std::hex << h;
    return out.str();
}

/// The checksum of a source; where it makes use of certificates, of these too.
std::string checksum_of(const fs::path& folder, const std::string& file) {
    const fs::path certificates = folder / "certificates" / fs::path(file).filename();
    return checksum(text_of(folder / file) + (file.starts_with("functions/") ? text_of(certificates) : ""));
}

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

/// The output of a command and its exit status.
std::pair<std::string, int> run(const std::string& command) {
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
    std::string said;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) said += static_cast<char>(c);
    const int status = ::pclose(pipe);
    return {said, WIFEXITED(status) ? WEXITSTATUS(status) : 255};
}

/// The lines of a claim in a file, with the part that all need before them.
std::string alone(const std::string& text, const json& claim) {
    const std::size_t from = text.find("(* Claim " + claim.at("claim").get<std::string>() + ": "), head = text.find("(* Claim ");
    const std::size_t to = text.find("(* Claim ", from + 1);
    return text.substr(0, head) + text.substr(from, to == std::string::npos ? to : to - from);
}

/// The entry of a file of certificates, and those of its claims.
json judged(const fs::path& folder, const std::string& file, const std::vector<json>& claims, const std::string& coqc) {
    const std::string text = text_of(folder / file);
    const Compiled whole = compile_with_coq(folder / file, coqc);
    json of_claims = json::object();
    for (const json& claim : claims) {
        Compiled one = whole;
        if (!whole.accepted && claims.size() > 1) {
            const fs::path part =
                (folder / file).parent_path() / ("alone_" + claim.at("lemmas").front().at("name").get<std::string>() + ".v");
            write(part, alone(text, claim));
            one = compile_with_coq(part, coqc);
            for (const char* ending : {".v", ".vo", ".vok", ".vos", ".glob"})
                fs::remove(fs::path(part).replace_extension(ending));
        }
        of_claims[claim.at("claim").get<std::string>()] = {{"status", one.accepted ? "checked" : "failed"},
                                                           {"message", one.message}};
    }
    return {{"file",
             {{"file", file},
              {"status", whole.accepted ? "checked" : "failed"},
              {"seconds", whole.seconds},
              {"checksum", checksum_of(folder, file)}}},
            {"claims", of_claims}};
}

/// A twin with what the compiler says of it.
json judged_twin(const fs::path& folder, json twin, const std::string& coqc) {
    const Compiled found = compile_with_coq(folder / twin.at("file").get<std::string>(), coqc);
    twin.erase("statement");
    twin["rejected"] = !found.accepted && finds_no_proof(found.message);
    twin["message"] = found.accepted ? "accepted" : found.message;
    return twin;
}

/// The verdict of the independent checker on a compiled file: `refused`, empty where it accepts it; the axioms that it rests on;
/// seconds and gigabytes taken. What the file rests on is not read again with it: each certificate is checked as a file of its
/// own, and Coq's library is taken as it is installed. The memory is bounded.
json said_again(const fs::path& folder, const fs::path& file, const std::string& coqchk) {
    constexpr long kilobytes_at_most = 4'000'000;
    const auto start = std::chrono::steady_clock::now();
    const std::string module = (file.parent_path() == "functions" ? "Functions." : "Certificates.") + file.stem().string();
    const auto [said, status] =
        run("cd " + quoted(folder.string()) + " && ulimit -v " + std::to_string(kilobytes_at_most) + " && " + coqchk +
            " -silent -o -Q certificates Certificates -Q functions Functions -norec " + module);
    rusage used{};
    ::getrusage(RUSAGE_CHILDREN, &used);
    json found{{"refused", status == 0 ? "" : module + ": " + said + "(exit status " + std::to_string(status) + ")"},
               {"axioms", json::array()},
               {"seconds", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()},
               {"gigabytes", static_cast<double>(used.ru_maxrss) / 1e6}};
    if (status != 0) return found;
    std::istringstream lines(said);
    bool among_them = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("* ")) among_them = line.starts_with("* Axioms:");
        const std::size_t from = line.find_first_not_of(' ');
        if (among_them && from != std::string::npos && from > 0) found["axioms"].push_back(line.substr(from));
    }
    return found;
}

/// Has the independent checker read each compiled file that it has not read before, one at a time, and notes what it says.
/// @param noted  called after each file @return what it refuses; empty where it accepts them
std::string check_again(const fs::path& folder, json& files, std::size_t workers, const std::string& coqchk,
                        const std::function<void()>& noted) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < files.size(); ++i)
        if (files[i].at("status") == "checked" && !files[i].contains("axioms")) open.push_back(i);
    const auto task = [&](std::size_t i) {
        return said_again(folder, files[open[i]].at("file").get<std::string>(), coqchk).dump();
    };
    std::string all_refused;
    in_processes(open.size(), workers, task, [&](std::size_t i, const Delivery& delivery) {
        if (!delivery.fault.empty()) throw std::runtime_error(delivery.fault);
        const json found = json::parse(delivery.text);
        all_refused += found.at("refused").get<std::string>();
        json& file = files[open[i]];
        if (found.at("refused") == "") file["axioms"] = found.at("axioms");
        file["seconds_again"] = found.at("seconds");
        file["gigabytes_again"] = found.at("gigabytes");
        noted();
    });
    return all_refused;
}

/// The entries of the files that earlier checks have accepted; the last of them may have been broken off.
std::map<std::string, json> accepted_before(const fs::path& folder, const std::string& version) {
    std::map<std::string, json> accepted;
    for (const char* record : {"kernel.json", unfinished}) {
        std::ifstream in(folder / record);
        if (!in) continue;
        const json before = json::parse(in, nullptr, false);
        if (before.is_discarded() || before.value("coq", "") != version) continue;
        for (const json& file : before.value("files", json::array()))
            if (file.value("status", "") == "checked") accepted[file.at("file").get<std::string>()] = file;
    }
    return accepted;
}

/// Adds a sentence to a reason. @param reasons sentences so far; gets one more @param more the sentence
void add_reason(std::string& reasons, const std::string& more) { reasons += (reasons.empty() ? "" : "; ") + more; }

/// The file whose second check took most of something.
std::string dearest(const json& files, const char* key, const char* unit) {
    const json* most = nullptr;
    for (const json& file : files)
        if (most == nullptr || file.value(key, 0.0) > most->value(key, 0.0)) most = &file;
    if (most == nullptr) return "none";
    std::ostringstream out;
    out << std::fixed << std::setprecision(1) << most->value(key, 0.0) << unit << " (" << most->at("file").get<std::string>()
        << ")";
    return out.str();
}

} // namespace

std::string why_not_in_functions(const json& claim) {
    std::map<std::string, std::size_t> counts; // reason -> lemmas
    for (const json& lemma : claim.at("lemmas")) {
        const std::string reason = lemma.at("why_no_functions");
        if (lemma.at("in_functions") == "" && reason != "") ++counts[reason]; // a polynomial needs no other lemma
    }
    std::string reasons;
    for (const auto& [reason, count] : counts)
        add_reason(reasons, std::to_string(count) + " of " + std::to_string(claim.at("lemmas").size()) + ": " + reason);
    return reasons;
}

bool finds_no_proof(const std::string& message) {
    for (const char* said : {"not a valid ring equation", "not a valid field equation", "No applicable tactic"})
        if (message.find(said) != std::string::npos) return true;
    return false;
}

bool can_be_read(const std::string& message) {
    for (const char* said : {"Syntax error", "Lexer error", "was not found in the current environment"})
        if (message.find(said) != std::string::npos) return false;
    return true;
}

Compiled compile_with_coq(const fs::path& file, const std::string& coqc) {
    const auto start = std::chrono::steady_clock::now();
    const fs::path folder = file.parent_path();
    const std::string part = folder.filename().string();
    const std::string library = part == "functions" ? "Functions" : part == "twins" ? "Twins" : "Certificates";
    const auto [said, status] =
        run("cd " + quoted(folder.string()) + " && ulimit -t 120 && timeout 900 " + coqc + " -q -Q . " + library +
            (library == "Functions" ? " -Q ../certificates Certificates " : " ") + quoted(file.filename().string()));
    if (status == 127) throw std::runtime_error("cannot run " + coqc);
    std::string message = status == 124 || status >= 128 ? "longer than two minutes" : said;
    while (!message.empty() && std::isspace(static_cast<unsigned char>(message.back())) != 0) message.pop_back();
    return {status == 0, status == 0 ? "" : message,
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

bool check_certificates(const fs::path& folder, std::size_t workers, const std::string& coqc, const std::string& coqchk,
                        std::ostream& out) {
    const auto start = std::chrono::steady_clock::now();
    const auto [version_said, status] = run(coqc + " --print-version");
    if (status != 0) throw std::runtime_error("cannot run " + coqc);
    const std::string version = version_said.substr(0, version_said.find_first_of(" \n"));
    const json exported = json::parse(text_of(folder / "certificates.json"));
    std::size_t lemmas = 0;
    for (const json& claim : exported.at("certificates"))
        for (const json& lemma : claim.at("lemmas")) lemmas += lemma.at("in_functions") == "" ? 1 : 2;
    const std::map<std::string, json> before = accepted_before(folder, version);
    json record{{"coq", version}, {"claims", json::object()}, {"twins", json::array()}, {"files", json::array()}};
    const json& twins = exported.at("twins");
    bool good = true;
    std::size_t lines = 0, compiled_now = 0;
    const auto keep = [&] { write(folder / unfinished, json{{"coq", version}, {"files", record.at("files")}}.dump(1) + "\n"); };
    // first the certificates, with the twins, then what makes use of them
    for (const char* key : {"file", "functions_file"}) {
        const bool first = std::string(key) == "file";
        std::map<std::string, std::vector<json>> claims_of; // file -> its claims
        for (const json& claim : exported.at("certificates"))
            if (claim.contains(key)) claims_of[claim.at(key).get<std::string>()].push_back(claim);
        std::vector<std::string> open;
        const auto note = [&](const std::string& claim, const json& said) {
            json& of_claim = record["claims"][claim];
            const bool accepted = said.at("status") == "checked";
            if (first)
                of_claim = said;
            else
                of_claim["in_functions"] = accepted ? "checked" : "not_proved"; // the certificate stands by itself
            if (accepted) return;
            const std::string message = said.at("message").get<std::string>();
            if (!first) of_claim["why_not_in_functions"] = "Coq does not prove it: " + message;
            const bool red = first || !can_be_read(message);
            good = good && !red;
            out << (red ? "failed: claim " : "not proved in the functions themselves: claim ") << claim << ": " << message
                << "\n";
        };
        for (const auto& [file, claims] : claims_of) {
            const std::string text = text_of(folder / file);
            lines += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
            const auto known = before.find(file);
            const bool compiled = fs::exists((folder / file).replace_extension(".vo"));
            if (known == before.end() || !compiled || known->second.at("checksum") != checksum_of(folder, file)) {
                open.push_back(file);
                continue;
            }
            record["files"].push_back(known->second);
            for (const json& claim : claims) note(claim.at("claim"), {{"status", "checked"}, {"message", ""}});
        }
        // long ones first, so that no worker is left with the last of them
        std::sort(open.begin(), open.end(), [&folder](const std::string& a, const std::string& b) {
            return fs::file_size(folder / a) > fs::file_size(folder / b);
        });
        compiled_now += open.size();
        const auto task = [&](std::size_t i) {
            if (i < open.size()) return judged(folder, open[i], claims_of.at(open[i]), coqc).dump();
            return judged_twin(folder, twins.at(i - open.size()), coqc).dump();
        };
        std::map<std::size_t, json> found_of_twins;
        in_processes(open.size() + (first ? twins.size() : 0), workers, task, [&](std::size_t i, const Delivery& delivery) {
            if (!delivery.fault.empty()) throw std::runtime_error(delivery.fault);
            json found = json::parse(delivery.text);
            if (i < open.size()) {
                record["files"].push_back(found.at("file"));
                keep();
                for (const auto& [claim, said] : found.at("claims").items()) note(claim, said);
                return;
            }
            if (!found.at("rejected").get<bool>()) {
                good = false;
                out << "not rejected: " << found.at("file").get<std::string>() << ": " << found.at("message").get<std::string>()
                    << "\n";
            }
            found_of_twins[i] = std::move(found);
        });
        for (const auto& [i, twin] : found_of_twins) record["twins"].push_back(twin);
    }
    for (const json& claim : exported.at("certificates"))
        if (std::string reasons = why_not_in_functions(claim); !reasons.empty() && claim.contains("file")) {
            json& of_claim = record["claims"][claim.at("claim").get<std::string>()];
            if (of_claim.contains("why_not_in_functions")) add_reason(reasons, of_claim.at("why_not_in_functions"));
            of_claim["why_not_in_functions"] = reasons;
        }
    std::sort(record["files"].begin(), record["files"].end(),
              [](const json& a, const json& b) { return a.at("file") < b.at("file"); });
    const std::string refused = check_again(folder, record["files"], workers, coqchk, keep);
    std::set<std::string> axioms;
    for (const json& file : record["files"])
        for (const json& axiom : file.value("axioms", json::array())) axioms.insert(axiom);
    record["checked_again"] = refused.empty() ? "accepted" : refused;
    record["axioms"] = axioms;
    if (!refused.empty()) {
        good = false;
        out << coqchk << " refuses the compiled files: " << refused << "\n";
    }
    double sum = 0;
    for (const json& file : record.at("files")) sum += file.at("seconds").get<double>();
    record["lemmas"] = lemmas;
    record["lines"] = lines;
    record["seconds"] = sum;
    write(folder / "kernel.json", record.dump(1) + "\n");
    fs::remove(folder / unfinished);
    const auto count = [](const json& list, const char* key, const json& value) {
        return std::count_if(list.begin(), list.end(), [&](const json& item) { return item.at(key) == value; });
    };
    std::size_t with_functions = 0, in_functions = 0;
    for (const json& claim : record.at("claims")) {
        with_functions += claim.contains("in_functions") ? 1 : 0;
        in_functions += claim.value("in_functions", "") == "checked" ? 1 : 0;
    }
    out << "Coq " << version << ": " << count(record.at("claims"), "status", "checked") << " of " << record.at("claims").size()
        << " claims checked, " << in_functions << " of " << with_functions << " in the functions themselves, " << lemmas
        << " lemmas, " << lines << " lines in " << record.at("files").size() << " files, " << compiled_now
        << " of them compiled now in "
        << static_cast<long>(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()) << " s; "
        << count(record.at("twins"), "rejected", true) << " of " << twins.size() << " twins rejected; " << coqchk << ": "
        << (refused.empty() ? "accepted" : "REFUSED") << ", one file at a time, at most "
        << dearest(record.at("files"), "seconds_again", " s") << " and " << dearest(record.at("files"), "gigabytes_again", " GB")
        << ", axioms:";
    for (const std::string& axiom : axioms) out << " " << axiom;
    out << "\n";
    return good;
}

} // namespace denhartog::derivation
