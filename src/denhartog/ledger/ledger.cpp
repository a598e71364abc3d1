// The ledger of the equations as the program prints it: the table of all, and the card of one with its verdict, its functions and
// its tests. Read `read_ledger`, then `card`.
#include "denhartog/ledger/ledger.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "denhartog/number/errors.hpp"

namespace denhartog::ledger {

namespace {

std::string joined(const Json& list, const std::string& open, const std::string& close) {
    std::string text;
    for (const Json& item : list) text += (text.empty() ? "" : ", ") + open + item.get<std::string>() + close;
    return text;
}

std::string short_name(const Json& functions) {
    if (functions.empty()) return "-";
    std::string name = functions.front().at("name").get<std::string>();
    if (name.starts_with("denhartog::")) name.erase(0, 11);
    return functions.size() == 1 ? name : name + " +" + std::to_string(functions.size() - 1);
}

std::string counts_of(const Json& entries, const std::string& key) {
    Json counts;
    for (const Json& entry : entries) {
        Json& count = counts[entry.at(key).get<std::string>()];
        count = count.is_null() ? 1 : count.get<int>() + 1;
    }
    std::string text;
    for (const auto& [word, count] : counts.items()) text += (text.empty() ? "" : ", ") + count.dump() + " " + word;
    return text;
}

/// One line of a card; nothing where there is nothing to say.
std::string line(const std::string& label, const std::string& text) {
    return text.empty() ? "" : "  " + label + std::string(label.size() < 12 ? 12 - label.size() : 1, ' ') + text + "\n";
}

void check_entries(const Json& entries, const std::string& file) {
    for (const Json& entry : entries) {
        const std::string number = entry.value("equation", "without number");
        const auto must = [&](const char* key, bool holds, const char* rule) {
            if (!holds) throw InputError("the ledger's equation " + number, std::string("must have ") + rule, key, file);
        };
        for (const char* key : {"equation", "section", "kind", "statement", "printed", "departure", "correction", "shipped"})
            must(key, entry.contains(key) && entry.at(key).is_string(), "the text");
        for (const char* key : {"functions", "claims", "tests", "rests_on", "used_by"})
            must(key, entry.contains(key) && entry.at(key).is_array(), "the array");
    }
}

} // namespace

Json read_array(const std::string& file, const std::string& what) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file)) throw InputError(what, "must be a file that can be read", "", file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    if (text.find('\0') != std::string::npos) throw InputError(what, "must be text", "a zero byte", file);
    Json array;
    try {
        array = Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw InputError(what, "must be JSON: " + std::string(error.what()), "", file);
    }
    if (!array.is_array() || std::any_of(array.begin(), array.end(), [](const Json& item) { return !item.is_object(); }))
        throw InputError(what, "must be an array of objects", "", file);
    return array;
}

Ledger read_ledger(const Places& places) {
    Ledger found;
    found.file = !places.option.empty() ? places.option : places.environment;
    if (found.file.empty() && std::filesystem::exists(places.built)) found.file = places.built;
    found.from_a_run = !found.file.empty();
    if (found.from_a_run) {
        found.entries = read_array(found.file, "the ledger");
    } else {
        found.file = places.rows;
        found.entries = Json::array();
        const Json rows = read_array(found.file, "the ledger's rows");
        try {
            for (const Json& row : rows) found.entries.push_back(entry_without_run(row));
            fill_used_by(found.entries);
        } catch (const Json::exception& error) {
            throw InputError("the ledger's rows", "must be complete: " + std::string(error.what()), "", found.file);
        }
    }
    check_entries(found.entries, found.file);
    return found;
}

std::string asked_equation(const std::string& text) {
    const std::optional<std::string> number = equation_number(text);
    if (!number) throw InputError("the equation", "must be one of 1 to 88 or A.1 to A.15", "'" + text + "'");
    return *number;
}

Json entries_of(const Json& entries, const std::string& equation) {
    if (equation.empty()) return entries;
    Json found = Json::array();
    for (const Json& entry : entries) {
        const Json all = entry.value("equations", Json::array({entry.at("equation")}));
        if (std::find(all.begin(), all.end(), Json(equation)) != all.end()) found.push_back(entry);
    }
    return found;
}

std::string table(const Json& entries) {
    std::vector<std::array<std::string, 7>> lines = {
        {"equation", "section", "kind", "as printed", "as shipped", "departure", "function"}};
    for (const Json& entry : entries)
        lines.push_back({"(" + entry.at("equation").get<std::string>() + ")", entry.at("section"), entry.at("kind"),
                         entry.at("printed"), entry.at("shipped"), entry.at("departure"), short_name(entry.at("functions"))});
    std::array<std::size_t, 7> width{};
    for (const auto& cells : lines)
        for (std::size_t n = 0; n < cells.size(); ++n) width[n] = std::max(width[n], cells[n].size());
    std::string text;
    for (const auto& cells : lines) {
        for (std::size_t n = 0; n + 1 < cells.size(); ++n) text += cells[n] + std::string(width[n] + 2 - cells[n].size(), ' ');
        text += cells.back() + "\n";
    }
    return text + "\n" + std::to_string(entries.size()) + " equations\nas printed: " + counts_of(entries, "printed") +
           "\nas shipped: " + counts_of(entries, "shipped") + "\ndeparture:  " + counts_of(entries, "departure") + "\n";
}

std::string card(const Json& entry) {
    const std::string departure = entry.at("departure");
    const std::string section = entry.at("section");
    const std::string printed = entry.at("printed");
    std::string text = "(" + entry.at("equation").get<std::string>() + ")  " +
                       (section == "Appendix" ? section : "Section " + section) + ", " + entry.at("kind").get<std::string>() +
                       "\n";
    text += line("statement", entry.at("statement"));
    text += line("note", entry.value("printed_note", ""));
    text += line("as printed", printed + (departure == "none" ? "" : ", departure: " + departure));
    text += line("remark", entry.value("remark", ""));
    text += line("in print", entry.value("in_print", ""));
    text += line(departure == "scan" && printed != "refuted" ? "read as" : "correction", entry.at("correction"));
    text += line("as shipped", entry.at("shipped"));
    text += line("kernel", kernel_words(entry.value("kernel", Json())));
    if (entry.contains("witness") && !entry.at("witness").empty()) text += line("witness", entry.at("witness").dump());
    if (printed == "refuted" && entry.contains("loss") && entry.at("loss").is_number())
        text += line("loss", "worst relative error " + number_in_digits(entry.at("loss").get<double>(), 3) +
                                 " for who codes the printed form");
    text += line("consequence", entry.value("consequence", ""));
    const Json scene = entry.value("scene", Json::object());
    if (scene.contains("none")) text += line("no scene", scene.at("none"));
    if (scene.contains("scene")) text += line("to be seen on", scene_sentence(scene)) + line("scene", scene.at("scene"));
    text += line("rests on", joined(entry.at("rests_on"), "(", ")"));
    text += line("used by", joined(entry.at("used_by"), "(", ")"));
    for (const Json& function : entry.at("functions"))
        text += line("function", function.at("name").get<std::string>() + "  " + function.at("file").get<std::string>() + ":" +
                                     function.at("line").dump());
    text += line("no formula", entry.value("no_function", ""));
    for (const Json& claim : entry.at("claims"))
        text += line("claim", claim.value("id", "") + "  " + claim.value("verdict", "") + with_kind(claim) + "  " +
                                  claim.value("what", ""));
    for (const Json& test : entry.at("tests")) text += line("test", test.get<std::string>());
    for (const Json& figure : entry.value("figures", Json::array())) text += line("figure", figure.get<std::string>());
    return text;
}

} // namespace denhartog::ledger
