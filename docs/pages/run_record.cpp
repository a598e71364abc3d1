#include "run_record.hpp"

#include <algorithm>
#include <fstream>

#include "denhartog/ledger/ledger.hpp"
#include "denhartog/number/errors.hpp"
#include "derivation/ledger/source_text.hpp"

namespace denhartog::pages {

namespace fs = std::filesystem;

namespace {

Json read_json(const fs::path& file) {
    try {
        return Json::parse(derivation::text_of(file));
    } catch (const Json::exception& e) {
        throw InputError(file.string(), "must be JSON", e.what());
    }
}

std::string text_if_there(const fs::path& file) { return fs::exists(file) ? derivation::text_of(file) : ""; }

/// The first sentence of a plot script, where no program has recorded a title.
std::string title_of_script(const fs::path& script) {
    std::ifstream in(script);
    std::string line, title;
    while (std::getline(in, line) && line.starts_with("# ")) {
        title += (title.empty() ? "" : " ") + line.substr(2);
        const std::size_t end = title.find_first_of(".;");
        if (end != std::string::npos && !title.starts_with("Fig. ")) return title.substr(0, end);
    }
    if (title.starts_with("Fig. ")) { // Fig. 1: the chain of N masses. ...
        title.erase(0, title.find(": ") + 2);
        title = title.substr(0, title.find(". "));
        title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
        if (title.ends_with('.')) title.pop_back();
    }
    return title;
}

std::vector<FigureRecord> read_figures(const fs::path& folder, const fs::path& source) {
    const Json captions = read_json(source / "docs/ledger/figures.json");
    std::vector<FigureRecord> figures;
    for (const fs::path& picture : derivation::files_in(folder, ".svg")) {
        FigureRecord figure{picture.stem().string(), "", nullptr, ""};
        for (const char* place : {"paper-figures/", "paper-figures/beyond/", "paper-figures/beyond/chart/"})
            if (fs::exists(source / (place + figure.name + ".gp"))) figure.script = place + figure.name + ".gp";
        if (figure.script.empty()) continue; // left by an earlier run
        const fs::path record = folder / (figure.name + ".json");
        if (fs::exists(record)) figure.record = read_json(record);
        for (const char* ending : {".dat", ".csv"})
            for (const fs::path& data : derivation::files_in(folder, ending))
                if (data.filename().string().starts_with(figure.name)) figure.data.push_back(data.filename().string());
        figure.title =
            figure.record.is_null() ? title_of_script(source / figure.script) : figure.record.at("title").get<std::string>();
        if (!captions.contains(figure.name))
            throw InputError("figure " + figure.name, "must have its caption in docs/ledger/figures.json", "");
        figure.caption = captions.at(figure.name);
        figures.push_back(std::move(figure));
    }
    std::stable_partition(figures.begin(), figures.end(), [](const FigureRecord& f) { return f.name.starts_with("fig"); });
    return figures;
}

} // namespace

std::string figure_number(const FigureRecord& figure) {
    return figure.name.starts_with("fig") ? "Fig. " + std::to_string(std::stoi(figure.name.substr(3, 2))) : "";
}

std::string figure_title(const FigureRecord& figure) {
    const std::string number = figure_number(figure);
    return number.empty() ? figure.title : number + ": " + figure.title;
}

RunRecord read_run(const fs::path& verify, const fs::path& source) {
    RunRecord run;
    run.ledger = ledger::read_array((verify / "paper/ledger.json").string(), "the ledger");
    for (Json& claim : ledger::read_array((verify / "paper/derivation.json").string(), "the derivation's record"))
        run.claims.emplace(claim.at("claim").get<std::string>(), claim);
    for (const auto& [id, claim] : run.claims)
        for (const Json& value : claim.value("witness", Json::array()))
            if (const std::string latex = value.value("name_latex", ""); !latex.empty())
                run.symbols.emplace(value.at("name").get<std::string>(), latex);
    run.run = read_json(verify / "paper/run.json");
    if (const fs::path exported = verify / "kernel/certificates.json"; fs::exists(exported))
        for (const Json& certificate : read_json(exported).at("certificates"))
            run.certificates.emplace(certificate.at("claim").get<std::string>(), certificate);
    run.figures = read_figures(verify / "figures", source);
    for (const fs::path& file : derivation::files_in(verify / "test-results/accuracy", ".json"))
        run.accuracy.push_back(read_json(file));
    std::stable_sort(run.accuracy.begin(), run.accuracy.end(), [](const Json& a, const Json& b) {
        const auto rank = [](const Json& record) { // double before long double before 50 digits
            const std::string type = record.at("type");
            return type.starts_with("double") ? 0 : type.starts_with("long") ? 1 : 2;
        };
        return rank(a) < rank(b);
    });
    run.chart = text_if_there(verify / "chart/tables.md");
    run.batch = text_if_there(verify / "chart/batch.md");
    for (const fs::path& file : derivation::files_in(verify / "conformance", ".md"))
        run.conformance.emplace(file.stem().string(), text_if_there(file));
    run.departures = read_departures(source / "docs/ledger/departures.json");
    run.notation = read_symbols(source / "docs/notation.md");
    run.checks = check_scenes(source / "tests/conformance/vectors");
    for (const std::string& equation : ledger::equation_numbers()) (void)entry_of(run, equation);
    return run;
}

const Json& entry_of(const RunRecord& run, const std::string& equation) {
    for (const Json& entry : run.ledger)
        if (entry.at("equation") == equation) return entry;
    throw InputError("the ledger", "must have an entry for equation (" + equation + ")", "");
}

const Json& record_of(const RunRecord& run, const std::string& claim) {
    auto found = run.claims.find(claim);
    const std::size_t slash = claim.rfind('/');
    if (found == run.claims.end() && slash != std::string::npos && ledger::equation_number(claim.substr(slash + 1)))
        found = run.claims.find(claim.substr(0, slash));
    if (found == run.claims.end())
        throw InputError("claim " + claim, "must have its steps in derivation.json; run ./verify paper again", "");
    return found->second;
}

std::string statement_that_holds(const Json& entry) {
    const std::string correction = entry.at("correction");
    return correction.empty() ? entry.at("statement").get<std::string>() : correction;
}

std::string verdict_text(const std::string& verdict) {
    if (verdict == "illegible") return "illegible in the text at hand";
    return verdict == "not_applicable" ? "not applicable" : verdict;
}

std::string verdict_mark(const std::string& verdict) {
    const std::string name = verdict == "not_applicable" ? "not-applicable" : verdict;
    return "<span class=\"verdict " + name + "\">" + verdict_text(verdict) + "</span>";
}

std::string departure_text(const std::string& departure) {
    if (departure == "scan") return "a slip of the scan";
    if (departure == "misprint") return "a misprint: the paper's own other equations contradict it";
    if (departure == "substance") return "an error of substance: it does not hold as it is meant";
    if (departure == "convention") return "a convention that the paper does not state";
    return "none";
}

} // namespace denhartog::pages
