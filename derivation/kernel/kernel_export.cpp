#include "derivation/kernel/kernel_export.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/workers.hpp"
#include "derivation/kernel/certificate.hpp"
#include "derivation/kernel/coq_text.hpp"

namespace denhartog::derivation {

namespace fs = std::filesystem;
using GiNaC::ex;
using nlohmann::json;

namespace {

constexpr std::size_t most_terms = 20000;     // of a lemma; more take the kernel longer than a minute
constexpr rlim_t longest_seconds = 120;       // for the reduction of a claim's identities
constexpr std::size_t longest_file = 120'000; // characters; a file is one process of the check

std::string lemma_name(const std::string& claim) {
    std::string name = "claim_";
    for (const char c : claim) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (plain || name.back() != '_') name += plain ? c : '_';
    }
    return name;
}

json lemma_of(const Identity& identity, const std::string& name, const LeftOut& left_out = {}) {
    const Certificate c = certificate_of(identity, name, left_out);
    json generators = json::array();
    for (const auto& [generator, meaning] : c.generators) generators.push_back({{"name", generator}, {"stands_for", meaning}});
    return {{"name", name}, {"statement", c.statement}, {"proof", c.proof}, {"generators", generators}, {"terms", c.terms},
            {"holds", c.holds}, {"lacks", c.lacks}, {"in_functions", c.in_functions}, {"why_no_functions", c.why_no_functions}};
}

/// The identities of a claim, and why they are not the whole of it; empty where they are.
std::pair<std::vector<Identity>, std::string> identities_of(const Claim& claim) {
    if (claim.role == Role::observation) return {{}, "an observation of the text: decided by a search, or from other claims"};
    Keeper keeper;
    if (claim.kernel) {
        const Values kernel = claim.kernel();
        const std::vector<ex> derived = claim.derived(), real = roots_in(derived);
        for (std::size_t i = 0; i < kernel.size(); ++i)
            if (decide_component(kernel[i], derived[i], real).verdict != Verdict::proved)
                return {{}, "refuted: the two sides are not equal"};
        return {keeper.identities, ""};
    }
    const Verdict verdict = claim.check().verdict;
    const auto rests_on = [&keeper](Ground ground) { return keeper.grounds.contains(ground); };
    std::string reason;
    if (verdict != Verdict::proved)
        reason = "refuted: what it says does not hold";
    else if (rests_on(Ground::argument))
        reason = "a step of it is an argument that a person gave";
    else if (rests_on(Ground::series))
        reason = "a limit or an order: the leading term of a series";
    else if (rests_on(Ground::places))
        reason = "a selection of forms: its comparisons are made at places of the domain";
    else if (keeper.identities.empty())
        reason = "no identity: it follows from other claims";
    return {keeper.identities, reason};
}

const std::string head_of_file = "(* Written by the derivation: the identities that it has proved, each with the cofactors of its reduction.\n"
                                 "   Variables are the paper's symbols; cos_1, sin_1, exp_1, root_1 stand for what the comment says. *)\n";

const std::string head_of_functions = "(* Written by the derivation: the same identities of sine, cosine, exponential and root themselves. *)\n";

/// A lemma with a comment of what its generators stand for.
std::string text_of_lemma(const json& lemma) {
    std::string text;
    for (const json& g : lemma.at("generators"))
        text += "(* " + g.at("name").get<std::string>() + " stands for " + coq_comment(g.at("stands_for")) + " *)\n";
    return text + lemma.at("statement").get<std::string>() + lemma.at("proof").get<std::string>() + "\n";
}

std::string head_of_claim(const json& found) {
    return "(* Claim " + coq_comment(found.at("claim")) + ": " + coq_comment(found.at("title")) + ". *)\n";
}

std::string text_of_claim(const json& found) {
    std::string text = head_of_claim(found);
    for (const json& lemma : found.at("lemmas")) text += text_of_lemma(lemma);
    return text;
}

/// The lemmas of a claim on the functions themselves; empty where there is none.
std::string functions_of_claim(const json& found) {
    std::string text;
    for (const json& lemma : found.at("lemmas"))
        if (const std::string of_lemma = lemma.at("in_functions"); !of_lemma.empty()) text += of_lemma + "\n";
    return text.empty() ? "" : head_of_claim(found) + text;
}

std::string statement_of(const std::string& lemma) { return lemma.substr(0, lemma.find("Proof.\n")); }

/// Writes a file unless it holds that already.
void write_if_new(const fs::path& file, const std::string& content) {
    std::ifstream before(file, std::ios::binary);
    std::ostringstream held;
    if (before) held << before.rdbuf();
    if (before && held.str() == content) return;
    std::ofstream out(file, std::ios::binary);
    out << content << std::flush;
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

void remove_others(const fs::path& folder, const std::set<std::string>& names) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (!names.contains(entry.path().stem().string())) fs::remove_all(entry.path());
}

/// The entry of a claim without its lemmas. @param reason why it is not exported; empty where it is
json record_of(const Claim& claim, const std::string& reason) {
    return {{"claim", claim.id},
            {"equation", claim.equations.front()},
            {"equations", claim.equations},
            {"title", claim.title},
            {"assumptions", claim.assumptions},
            {"status", reason.empty() ? "exported" : "not_exported"},
            {"reason", reason},
            {"lemmas", json::array()}};
}

/// Claims that the twins are made of: small formulas that are proved.
std::vector<const Claim*> small_claims() {
    constexpr long most_operations = 60;
    std::vector<const Claim*> small;
    for (const Claim& claim : claims()) {
        if (!claim.kernel || claim.role == Role::printed || claim.role == Role::observation) continue;
        const Mutation none(-1);
        const Values kernel = claim.kernel();
        if (kernel.size() <= 3 && none.operations() <= most_operations) small.push_back(&claim);
    }
    return small;
}

json twin_of(const Claim& claim, const std::string& what, json lemma) {
    lemma["claim"] = claim.id;
    lemma["what"] = what;
    return lemma;
}

/// A formula with one operation replaced, as a lemma that does not hold; null where it holds all the same, or has no form in Coq.
json altered_formula(const Claim& claim, const Values& kernel) {
    const std::vector<ex> derived = claim.derived(), real = roots_in(derived);
    for (std::size_t i = 0; i < kernel.size(); ++i) {
        const ex left = kernel[i].expression();
        const std::vector<Range> domain = domain_of({left, derived[i]});
        if (!differs_at_samples(left, derived[i], domain, real)) continue;
        try {
            json lemma = lemma_of(in_generators(left, derived[i], domain, real), lemma_name(claim.id) + "_twin");
            if (!lemma.at("holds").get<bool>()) return lemma;
        } catch (const std::exception&) {
        } // another twin will do
    }
    return nullptr;
}

/// A twin of a claim by the first kind of replacement that no other twin has yet.
void add_altered_formula(const Claim& claim, std::set<std::string>& kinds, json& list) {
    for (long position = 0;; ++position) {
        Values kernel;
        std::string replaced;
        try {
            const Mutation mutation(position);
            kernel = claim.kernel();
            replaced = mutation.replaced();
        } catch (const std::exception&) {
            continue; // a mutant that divides by zero
        }
        if (replaced.empty()) return;
        if (kinds.contains(replaced)) continue;
        json lemma = altered_formula(claim, kernel);
        if (lemma.is_null()) continue;
        kinds.insert(replaced);
        list.push_back(twin_of(claim, replaced, std::move(lemma)));
        return;
    }
}

/// A claim's first lemma that uses what is left out; null where none does.
json with_hypothesis_left_out(const Claim& claim, const LeftOut& left_out) {
    const auto [identities, reason] = identities_of(claim);
    const std::string name = lemma_name(claim.id) + "_twin";
    for (const Identity& identity : identities) {
        json lemma = lemma_of(identity, name, left_out);
        if (lemma.at("lacks").get<bool>()) return lemma;
    }
    return nullptr;
}

/// Twins of the first claims that have the hypothesis.
void add_hypotheses_left_out(const std::vector<const Claim*>& small, const std::string& what, const LeftOut& left_out, json& list) {
    constexpr int enough = 2;
    int count = 0;
    for (const Claim* claim : small) {
        json lemma = with_hypothesis_left_out(*claim, left_out);
        if (lemma.is_null()) continue;
        list.push_back(twin_of(*claim, what, std::move(lemma)));
        if (++count == enough) return;
    }
    throw std::logic_error("no twin: " + what);
}

} // namespace

json certificates_of(const Claim& claim) {
    const auto [identities, reason] = identities_of(claim);
    json found = record_of(claim, reason);
    std::set<std::string> said; // a check may come to the same identity twice
    std::vector<Identity> different;
    for (const Identity& identity : identities)
        if (!identity.left.is_equal(identity.right) || claim.kernel) different.push_back(identity);
    std::string missing;
    for (const Identity& identity : different) {
        const std::string number = std::to_string(found.at("lemmas").size() + 1);
        const std::string name = lemma_name(claim.id) + (different.size() > 1 ? "_" + number : "");
        try {
            json lemma = lemma_of(identity, name);
            if (!lemma.at("holds").get<bool>()) throw std::logic_error("the reduction of " + name + " leaves a remainder");
            const std::size_t terms = lemma.at("terms");
            if (terms > most_terms)
                missing = "too large: " + std::to_string(terms) + " terms";
            else if (said.insert(lemma.at("proof").get<std::string>() +
                                 lemma.at("statement").get<std::string>().substr(std::string("Lemma ").size() + name.size()))
                         .second)
                found["lemmas"].push_back(std::move(lemma));
        } catch (const std::domain_error& e) {
            missing = e.what();
        }
    }
    if (reason.empty() && !missing.empty()) {
        found["reason"] = missing;
        found["status"] = "not_exported";
    }
    return found;
}

json rejected_twins() {
    constexpr std::size_t enough = 12;
    json list = json::array();
    std::set<std::string> kinds;
    const std::vector<const Claim*> small = small_claims();
    for (const Claim* claim : small)
        if (list.size() < enough) add_altered_formula(*claim, kinds, list);
    add_hypotheses_left_out(small, "a relation of the generators is left out", {.relation = true}, list);
    add_hypotheses_left_out(small, "that a divisor is not zero is left out", {.divisor = true}, list);
    return list;
}

json export_certificates(const std::vector<Claim>& all, const fs::path& folder, std::size_t workers, std::ostream& out) {
    const fs::path of_claims = folder / "certificates", of_functions = folder / "functions", of_twins = folder / "twins";
    for (const fs::path& part : {of_claims, of_functions, of_twins}) fs::create_directories(part);
    std::vector<json> found(all.size());
    json twins_found;
    const auto task = [&all](std::size_t i) {
        const rlimit limit{longest_seconds, longest_seconds};
        ::setrlimit(RLIMIT_CPU, &limit);
        return (i == 0 ? rejected_twins() : certificates_of(all[i - 1])).dump();
    };
    in_processes(all.size() + 1, workers, task, [&](std::size_t i, const Delivery& delivery) {
        if (i > 0 && delivery.fault.find("ended by a signal") != std::string::npos)
            found[i - 1] = record_of(all[i - 1], "too large: its reduction takes more than " + std::to_string(longest_seconds) + " s");
        else if (!delivery.fault.empty())
            throw std::runtime_error((i == 0 ? std::string("the twins") : "claim " + all[i - 1].id) +
                                     " could not be exported: " + delivery.fault);
        else
            (i == 0 ? twins_found : found[i - 1]) = json::parse(delivery.text);
    });
    struct File {
        std::string name, certificates, functions;
    };
    std::vector<File> files;
    std::map<std::string, int> parts;                       // how many files an equation has
    std::map<std::string, std::size_t> last;                // the last of them
    json record{{"certificates", json::array()}, {"twins", json::array()}};
    std::size_t exported = 0, lemmas = 0, functions = 0;
    for (json& claim : found) {
        json entry = claim;
        if (!claim.at("lemmas").empty()) {
            const std::string text = text_of_claim(claim), equation = claim.at("equation");
            if (!last.contains(equation) || files[last[equation]].certificates.size() + text.size() > longest_file) {
                std::string name = "equation_" + equation;
                std::replace(name.begin(), name.end(), '.', '_');
                if (const int part = ++parts[equation]; part > 1) name += "_part_" + std::to_string(part);
                last[equation] = files.size();
                files.push_back({name, head_of_file + certificate_prelude() + "\n", ""});
            }
            File& file = files[last[equation]];
            file.certificates += text;
            entry["file"] = "certificates/" + file.name + ".v";
            if (const std::string of_functions = functions_of_claim(claim); !of_functions.empty()) {
                file.functions += of_functions;
                entry["functions_file"] = "functions/" + file.name + ".v";
            }
        }
        entry["lemmas"] = json::array();
        for (const json& lemma : claim.at("lemmas")) {
            const std::string in_functions = lemma.at("in_functions");
            functions += in_functions.empty() ? 0 : 1;
            entry["lemmas"].push_back({{"name", lemma.at("name")},
                                       {"statement", lemma.at("statement")},
                                       {"generators", lemma.at("generators")},
                                       {"terms", lemma.at("terms")},
                                       {"in_functions", statement_of(in_functions)},
                                       {"why_no_functions", lemma.at("why_no_functions")}});
        }
        lemmas += entry.at("lemmas").size();
        exported += entry.at("status") == "exported" ? 1 : 0;
        record["certificates"].push_back(std::move(entry));
    }
    std::set<std::string> names, names_of_twins;
    std::size_t lines = 0;
    std::set<std::string> with_functions;
    const auto put = [&lines](const fs::path& file, const std::string& content) {
        write_if_new(file, content);
        lines += static_cast<std::size_t>(std::count(content.begin(), content.end(), '\n'));
    };
    for (const File& file : files) {
        put(of_claims / (file.name + ".v"), file.certificates);
        names.insert(file.name);
        if (file.functions.empty()) continue;
        put(of_functions / (file.name + ".v"), head_of_functions + "Require Import Reals Lra.\nFrom Certificates Require Import " +
                                                   file.name + ".\nOpen Scope R_scope.\n\n" + functions_prelude() + "\n" +
                                                   file.functions);
        with_functions.insert(file.name);
    }
    for (std::size_t k = 0; k < twins_found.size(); ++k) {
        const json& twin = twins_found[k];
        const std::string name = "twin_" + std::to_string(k + 1);
        write_if_new(of_twins / (name + ".v"), "(* Must be rejected. Claim " + coq_comment(twin.at("claim")) + ": " +
                                                   coq_comment(twin.at("what")) + " *)\n" + certificate_prelude() + "\n" +
                                                   text_of_lemma(twin));
        names_of_twins.insert(name);
        record["twins"].push_back({{"file", "twins/" + name + ".v"}, {"claim", twin.at("claim")}, {"what", twin.at("what")},
                                   {"lemma", twin.at("name")}, {"statement", twin.at("statement")}});
    }
    remove_others(of_claims, names);
    remove_others(of_functions, with_functions);
    remove_others(of_twins, names_of_twins);
    record["counts"] = {{"claims", all.size()}, {"exported", exported}, {"lemmas", lemmas},
                        {"in_functions", functions}, {"files", files.size() + with_functions.size()}, {"lines", lines}};
    write_if_new(folder / "certificates.json", record.dump(1) + "\n");
    out << exported << " of " << all.size() << " claims exported, " << lemmas << " identities, " << functions
        << " of them also in the functions themselves, " << files.size() + with_functions.size() << " files, " << lines << " lines, " << twins_found.size() << " twins\n";
    return record;
}

} // namespace denhartog::derivation
