#include "derivation/ledger/ledger_rows.hpp"

#include <fstream>
#include <functional>
#include <map>
#include <set>

#include "denhartog/number/errors.hpp"

namespace denhartog::derivation {

using ledger::Json;

namespace {

const std::set<std::string> kinds = {"definition", "assumption", "result", "approximation", "quoted"};
const std::set<std::string> sections = {"2.1", "2.2", "2.3", "2.4", "2.5", "2.6", "3.1", "4.1", "4.2", "4.3", "Appendix"};
const std::vector<std::string> required = {"equation", "section", "kind", "statement", "rests_on"};
const std::set<std::string> optional_keys = {"printed_note", "read_as", "in_print", "remark", "perhaps_scan", "no_function"};

std::vector<std::string> faults_of_keys(const Json& row, const std::string& name) {
    std::vector<std::string> faults;
    for (const std::string& key : required)
        if (!row.contains(key)) faults.push_back(name + " has no " + key);
    for (const auto& [key, value] : row.items()) {
        const bool known = optional_keys.contains(key) || std::find(required.begin(), required.end(), key) != required.end();
        if (!known)
            faults.push_back(name + " has an unknown key " + key);
        else if (key == "rests_on" ? !value.is_array() : !(value.is_string() && !value.get<std::string>().empty()))
            faults.push_back(name + ": " + key + " must be " + (key == "rests_on" ? "an array" : "a text that is not empty"));
        else if (key == "rests_on")
            for (const Json& other : value)
                if (!other.is_string()) faults.push_back(name + ": rests_on must hold texts");
    }
    return faults;
}

void check_content(const Json& row, const std::string& name, std::vector<std::string>& faults) {
    if (!kinds.contains(row.at("kind").get<std::string>())) faults.push_back(name + ": unknown kind " + row.at("kind").dump());
    if (!sections.contains(row.at("section").get<std::string>()))
        faults.push_back(name + ": unknown section " + row.at("section").dump());
    for (const char* key : {"statement", "read_as", "in_print"}) {
        const std::string fault = latex_fault(row.value(key, ""));
        if (!fault.empty()) faults.push_back(name + ": " + key + ": " + fault);
    }
    if (row.contains("read_as") != row.contains("printed_note"))
        faults.push_back(name + ": printed_note and read_as belong together");
    if (row.contains("in_print") && !row.contains("printed_note"))
        faults.push_back(name + ": in_print belongs to a printed_note");
    if (row.contains("read_as") && row.at("read_as") == row.at("statement"))
        faults.push_back(name + ": read_as says the same as statement");
}

void check_grounds(const Json& rows, std::vector<std::string>& faults) {
    std::map<std::string, std::size_t> place;
    for (std::size_t n = 0; n < rows.size(); ++n) place[rows[n].at("equation").get<std::string>()] = n;
    for (std::size_t n = 0; n < rows.size(); ++n) {
        const std::string name = "equation " + rows[n].at("equation").get<std::string>();
        std::set<std::string> seen;
        for (const std::string other : rows[n].at("rests_on")) {
            const auto found = place.find(other);
            if (found == place.end()) {
                faults.push_back(name + " rests on " + other + ", which has no row");
                continue;
            }
            const Json& ground = rows[found->second];
            if (!seen.insert(other).second) faults.push_back(name + " rests on " + other + " twice");
            if (found->second >= n && ground.at("kind") != "definition" && ground.at("section") != "Appendix")
                faults.push_back(name + " rests on " + other + ", which comes later and is no definition");
        }
    }
    std::map<std::size_t, int> state; // 1: being visited, 2: done
    std::function<void(std::size_t)> visit = [&](std::size_t n) {
        state[n] = 1;
        for (const std::string other : rows[n].at("rests_on")) {
            const auto found = place.find(other);
            if (found == place.end()) continue;
            if (state[found->second] == 1)
                faults.push_back("equation " + other + " rests on itself by way of " + rows[n].at("equation").get<std::string>());
            else if (state[found->second] == 0)
                visit(found->second);
        }
        state[n] = 2;
    };
    for (std::size_t n = 0; n < rows.size(); ++n)
        if (state[n] == 0) visit(n);
}

} // namespace

Json read_rows(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw InputError("the ledger's rows", "must be a file that can be read", "", file.string());
    try {
        return Json::parse(stream);
    } catch (const Json::parse_error& error) {
        throw InputError("the ledger's rows", "must be JSON: " + std::string(error.what()), "", file.string());
    }
}

std::string latex_fault(const std::string& latex) {
    if (latex.find('$') != std::string::npos) return "has a $";
    std::vector<std::string> open;
    int left = 0;
    for (std::size_t n = 0; n < latex.size(); ++n) {
        if (latex[n] == '{') open.push_back("{");
        if (latex[n] == '}') {
            if (open.empty() || open.back() != "{") return "has a } too many";
            open.pop_back();
        }
        if (latex[n] != '\\') continue;
        std::string word;
        while (n + 1 < latex.size() && std::isalpha(static_cast<unsigned char>(latex[n + 1]))) word += latex[++n];
        if (word.empty()) ++n; // \{ \} \\ and the like
        if (word == "left") ++left;
        if (word == "right" && --left < 0) return "has a \\right without its \\left";
        if (word != "begin" && word != "end") continue;
        const std::size_t close = latex.find('}', n);
        if (close == std::string::npos || latex[n + 1] != '{') return "has a \\" + word + " without a name";
        const std::string name = latex.substr(n + 2, close - n - 2);
        n = close;
        if (word == "begin")
            open.push_back(name);
        else if (open.empty() || open.back() != name)
            return "has \\end{" + name + "} without its beginning";
        else
            open.pop_back();
    }
    if (!open.empty()) return open.back() == "{" ? "has a { too many" : "has \\begin{" + open.back() + "} without its end";
    return left == 0 ? "" : "has a \\left without its \\right";
}

std::vector<std::string> faults_of_rows(const Json& rows) {
    const std::vector<std::string>& numbers = ledger::equation_numbers();
    if (!rows.is_array()) return {"the ledger's rows must be an array"};
    std::vector<std::string> faults;
    for (std::size_t n = 0; n < rows.size(); ++n) {
        const std::string place = "row " + std::to_string(n + 1);
        if (!rows[n].is_object()) {
            faults.push_back(place + " must be an object");
            continue;
        }
        const std::string number = rows[n].contains("equation") ? rows[n].at("equation").dump() : "without number";
        const std::vector<std::string> found = faults_of_keys(rows[n], place + ", equation " + number);
        faults.insert(faults.end(), found.begin(), found.end());
    }
    if (!faults.empty()) return faults;
    for (std::size_t n = 0; n < rows.size(); ++n) {
        const std::string number = rows[n].at("equation").get<std::string>();
        if (n >= numbers.size() || number != numbers[n])
            faults.push_back("row " + std::to_string(n + 1) + " must be equation " +
                             (n < numbers.size() ? numbers[n] : std::string("none")) + ", but is " + number);
        check_content(rows[n], "equation " + number, faults);
    }
    for (std::size_t n = rows.size(); n < numbers.size(); ++n) faults.push_back("equation " + numbers[n] + " has no row");
    check_grounds(rows, faults);
    return faults;
}

} // namespace denhartog::derivation
