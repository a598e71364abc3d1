// The certified vectors: their files agree with each other, with the manifest, and with what is computed anew.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "conformance/plain/closed_form.hpp"
#include "conformance/verdict.hpp"
#include "denhartog/scene/json_document.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/generator/vector_files.hpp"
#include "tests/conformance/runner_fixtures.hpp"
#include "tests/conformance/shell.hpp"
#include "tests/conformance/vector_folder.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;
using generator::bytes_of;

namespace {

// A copy of the folder that goes when the test does.
class Twin {
public:
    Twin() : folder(std::filesystem::temp_directory_path() / ("vectors-twin-" + std::to_string(std::rand()))) {
        std::filesystem::copy(vector_folder(), folder);
    }
    Twin(const Twin&) = delete;
    Twin& operator=(const Twin&) = delete;
    ~Twin() { std::filesystem::remove_all(folder); }
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    std::filesystem::path folder;
};

bool has_all(const nlohmann::json& object, const nlohmann::json& names) {
    return std::all_of(names.begin(), names.end(), [&](const nlohmann::json& name) { return object.contains(name); });
}

// Of a schema what the lines need: members required, one kind of line, no members besides.
std::string schema_fault(const nlohmann::json& schema, const nlohmann::json& line) {
    if (!has_all(line, schema.at("required"))) return "a required member is missing";
    int kinds = 0;
    for (const auto& kind : schema.at("oneOf")) {
        bool fits = has_all(line, kind.at("required"));
        if (kind.contains("not")) fits = fits && !has_all(line, kind["not"].at("required"));
        if (fits && kind.contains("properties"))
            fits = line.at("value").type_name() == kind["properties"]["value"].at("type").get<std::string>();
        kinds += fits ? 1 : 0;
    }
    if (kinds != 1) return "it is of " + std::to_string(kinds) + " kinds";
    for (const auto& [name, value] : line.items())
        if (!schema.at("properties").contains(name)) return name + " is no member of the schema";
    if (!has_all(line.at("scene"), schema["properties"]["scene"].at("required"))) return "the scene lacks a member";
    return "";
}

} // namespace

TEST_CASE("the manifest has every file of the vectors with its size and checksum, and sees a byte that changed",
          "[conformance][vectors]") {
    CHECK(generator::manifest_faults(vector_folder()).empty());
    const Twin twin;
    std::string bytes = bytes_of(twin.folder / "modes.jsonl");
    bytes[bytes.size() / 2] = bytes[bytes.size() / 2] == '1' ? '2' : '1';
    twin.write("modes.jsonl", bytes);
    CHECK(generator::manifest_faults(twin.folder) == std::vector<std::string>{"modes.jsonl has another checksum"});
    std::filesystem::remove(twin.folder / "masses.jsonl");
    twin.write("more.jsonl", "");
    CHECK(generator::manifest_faults(twin.folder).size() == 3);
}

TEST_CASE("every line of the vectors has what the schema requires, which has the quantities of the protocol",
          "[conformance][vectors]") {
    const nlohmann::json schema = nlohmann::json::parse(bytes_of(vector_folder() / "schema.json"));
    std::vector<std::string> names;
    for (const Quantity& q : quantities()) names.emplace_back(q.name);
    CHECK(schema.at("properties").at("quantity").at("enum") == names);
    CHECK(schema.at("description") == "A line of a file *.jsonl, format version " + std::to_string(format_version));
    std::size_t count = 0;
    nlohmann::json twin;
    for (const auto& entry : std::filesystem::directory_iterator(vector_folder())) {
        if (entry.path().extension() != ".jsonl") continue;
        for (const std::string& line : lines_of(bytes_of(entry.path()))) {
            const nlohmann::json object = nlohmann::json::parse(line);
            INFO(line.substr(0, 60));
            REQUIRE(schema_fault(schema, object).empty());
            REQUIRE(vector_json(vector_from_json(object)).dump() == line);
            ++count;
            if (object.contains("hex")) twin = object;
        }
    }
    CHECK(count == vectors().size());
    for (const char* name : {"tier", "hex", "scale", "digits", "catches"}) {
        nlohmann::json without = twin;
        without.erase(name);
        CHECK_FALSE(schema_fault(schema, without).empty());
    }
}

TEST_CASE("the vectors are enough, of every group, tier and number of masses, with contact and load anywhere",
          "[conformance][vectors]") {
    std::map<std::string, std::map<std::string, int>> groups;
    std::map<std::string, int> tiers, places, asked;
    std::set<std::size_t> masses;
    std::map<std::string, std::map<std::string, int>> kinds; // of systems beyond the paper, by regime
    std::set<double> stops;                                  // that every solver of motions with stops must count
    std::map<std::string, int> flags;
    bool mu = false, rejected_enough = false;
    for (const Vector& v : vectors()) {
        ++groups[v.group][v.tier];
        ++tiers[v.tier];
        ++asked[v.question.quantity];
        if (!v.reject.empty()) continue;
        masses.insert(masses_of(v.question));
        for (const std::string& flag : v.flags) ++flags[flag];
        if (v.question.quantity == "stops_per_period" && v.tier == "must") stops.insert(v.nearest.front());
        for (const std::string& kind : beyond_the_paper(v.question)) ++kinds[kind][v.regime];
        if (!is_of_the_paper(v.question)) continue;
        const int side = v.question.contact - v.question.load;
        if (v.question.mass_ratios.size() > 1) ++places[side < 0 ? "before" : side > 0 ? "behind" : "at"];
        mu = mu || v.question.mu > 1;
    }
    CHECK(vectors().size() >= 1500);
    CHECK(groups.size() == 20);
    CHECK(kinds.size() == 9);
    for (const auto& [kind, regimes] : kinds) {
        INFO(kind);
        CHECK(regimes.at("continuous") >= 20);
        CHECK(regimes.at("permanent_sticking") >= 10);
        CHECK(regimes.at("stick_slip") >= 6);
    }
    CHECK(stops == std::set<double>{1, 2, 3, 4, 6, 8});
    CHECK(flags["unsymmetric"] >= 20);
    CHECK(flags["several-periods"] >= 5);
    CHECK(tiers.size() == 3);
    CHECK(masses == std::set<std::size_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    for (const char* place : {"before", "at", "behind"}) CHECK(places[place] > 100);
    CHECK(mu);
    rejected_enough = groups["reject"]["must"] >= 30;
    CHECK(rejected_enough);
    for (const Quantity& q : quantities()) {
        INFO(q.name);
        CHECK(asked[std::string(q.name)] >= 10);
    }
    const nlohmann::json manifest = nlohmann::json::parse(bytes_of(vector_folder() / "manifest.json"));
    CHECK(manifest.at("format") == format_version);
    CHECK(manifest.at("content") == generator::content_version);
    CHECK(manifest.at("vectors") == vectors().size());
    CHECK(manifest.at("tiers") == nlohmann::json(tiers));
    CHECK(manifest.at("groups") == nlohmann::json(groups));
}

TEST_CASE("the vectors as CSV say what the JSON lines say", "[conformance][vectors]") {
    const std::string command = quoted_program() + " conform list --csv";
    const Run run = run_shell(command + " --systems");
    REQUIRE(run.status == 0);
    std::istringstream output(run.output);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(output, line);) {
        rows.emplace_back();
        std::istringstream cells(line + ',');
        for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    REQUIRE(rows.size() == vectors().size() + 1);
    const auto cell = [&](std::size_t row, const std::string& name) {
        const auto column = std::find(rows[0].begin(), rows[0].end(), name);
        REQUIRE(column != rows[0].end());
        return rows[row][static_cast<std::size_t>(column - rows[0].begin())];
    };
    const auto numbers = [](const std::string& list) {
        std::istringstream words(list);
        std::vector<double> all;
        for (std::string word; words >> word;) all.push_back(std::stod(word));
        return all;
    };
    for (std::size_t n = 0; n < vectors().size(); ++n) {
        const Vector& v = vectors()[n];
        INFO(v.question.id);
        REQUIRE(rows[n + 1].size() == rows[0].size());
        REQUIRE(cell(n + 1, "id") == v.question.id);
        REQUIRE(cell(n + 1, "quantity") == v.question.quantity);
        if (!v.reject.empty()) {
            REQUIRE(cell(n + 1, "value") == "reject");
            continue;
        }
        REQUIRE(cell(n + 1, "tier") == v.tier);
        REQUIRE(numbers(cell(n + 1, "mass_ratios")) == v.question.mass_ratios);
        REQUIRE(numbers(cell(n + 1, "damping_ratios")) == v.question.damping_ratios);
        REQUIRE(numbers(cell(n + 1, "r")) == std::vector<double>{v.question.r});
        REQUIRE(numbers(cell(n + 1, "mass_matrix")) == v.question.mass_matrix);
        REQUIRE(numbers(cell(n + 1, "stiffness_matrix")) == v.question.stiffness_matrix);
        REQUIRE(numbers(cell(n + 1, "damping_matrix")) == v.question.damping_matrix);
        REQUIRE(cell(n + 1, "base_motion") == v.question.base_motion);
        REQUIRE(numbers(cell(n + 1, "load_phases")) == v.question.load_phases);
        if (!v.word.empty())
            REQUIRE(cell(n + 1, "value") == v.word);
        else
            REQUIRE(numbers(cell(n + 1, "value")) == v.nearest);
    }
    const Run group = run_shell(command + " --group limits --tier stress");
    CHECK(std::count(group.output.begin(), group.output.end(), '\n') == 2);
    CHECK(group.output.starts_with(vectors_csv({}))); // the columns of systems are there where systems are
    CHECK(run_shell(command + " --summary").status == 2);
}

TEST_CASE("hexadecimal values are the doubles nearest to the decimals, and the tolerances are in order",
          "[conformance][vectors]") {
    std::size_t compared = 0;
    for (const Vector& v : vectors()) {
        REQUIRE(v.value.size() == v.nearest.size());
        double largest = 0;
        for (std::size_t n = 0; n < v.value.size(); ++n) {
            const Real100 exact(v.value[n]);
            const double x = v.nearest[n];
            INFO(v.question.id << " " << v.value[n] << " " << hexadecimal(x));
            const auto error = [&](double y) { return Real100(abs(Real100(y) - exact)); };
            REQUIRE(error(x) <= error(std::nextafter(x, 1e300)));
            REQUIRE(error(x) <= error(std::nextafter(x, -1e300)));
            largest = std::max(largest, std::abs(x));
            ++compared;
        }
        if (v.value.empty()) continue;
        INFO(v.question.id);
        REQUIRE(v.scale == (quantity(v.question.quantity).angle || largest == 0 ? 1 : largest));
        REQUIRE(v.tolerance.pass <= v.tolerance.loose);
        REQUIRE(v.tolerance.loose <= v.tolerance.inaccurate);
        REQUIRE(v.digits[1] >= generator::least_digits);
    }
    CHECK(compared > 4000);
}

TEST_CASE("a sample of the vectors is computed anew byte for byte", "[conformance][vectors]") {
    const int every = 131, from = 17;
    for (const std::string& difference : generator::differences(vector_folder(), every, from)) FAIL_CHECK(difference);
    CHECK(vectors().size() > 10 * every);
}

TEST_CASE("the mistakes that a vector catches are those of its line, in the groups with poles and in a sample of the others",
          "[conformance][vectors][mistake]") {
    const std::size_t every = 11, from = 5;
    std::size_t looked_at = 0;
    for (std::size_t n = 0; n < vectors().size(); ++n) {
        const Vector& v = vectors()[n];
        const bool has_poles = v.group == "limits" || v.group == "functions";
        if (!v.reject.empty() || (!has_poles && n % every != from)) continue;
        INFO(v.question.id);
        CHECK(generator::catches_of(v) == v.catches);
        ++looked_at;
    }
    CHECK(looked_at > 800);
}

TEST_CASE("a value with another twelfth digit is not what is computed anew", "[conformance][vectors]") {
    const Twin twin;
    const auto found = std::find_if(vectors().begin(), vectors().end(), [](const Vector& v) {
        return v.group == "contact" && v.question.mass_ratios.size() == 2 && v.value.size() == 1 && v.value[0].size() > 40;
    });
    REQUIRE(found != vectors().end());
    const std::string& value = found->value[0];
    std::string changed = value;
    const std::size_t twelfth = value.find('.') + 11;
    changed[twelfth] = value[twelfth] == '9' ? '8' : static_cast<char>(value[twelfth] + 1);
    std::string bytes = bytes_of(twin.folder / "contact.jsonl");
    const std::size_t place = bytes.find("\"" + value + "\"");
    REQUIRE(place != std::string::npos);
    bytes.replace(place + 1, value.size(), changed);
    twin.write("contact.jsonl", bytes);
    const int all = static_cast<int>(vectors().size()), from = static_cast<int>(found - vectors().begin());
    CHECK(generator::differences(twin.folder, all, from) ==
          std::vector<std::string>{found->question.id + " is not what is computed anew"});
    CHECK(generator::differences(vector_folder(), all, from).empty());
}

TEST_CASE("a line with a question alone becomes its vector again, and one that breaks a rule is named",
          "[conformance][vectors]") {
    const std::filesystem::path file = "masses.jsonl";
    const nlohmann::ordered_json whole = nlohmann::ordered_json::parse(lines_of(bytes_of(vector_folder() / file)).front());
    nlohmann::ordered_json question;
    for (const char* key : {"id", "quantity", "scene", "mass"}) question[key] = whole.at(key);
    const Twin twin;
    const auto certified = [&](const nlohmann::ordered_json& first, const std::string& others = "") {
        twin.write(file.string(), first.dump() + "\n" + others);
        return generator::certify_all(twin.folder, {"masses"});
    };
    const auto with = [&](const char* key, const nlohmann::ordered_json& value) {
        nlohmann::ordered_json changed = question;
        changed[key] = value;
        return changed;
    };

    const generator::Certified again = certified(question);
    REQUIRE(again.vectors.size() == 1);
    CHECK(vector_json(again.vectors.front()).dump() == whole.dump());
    CHECK(generator::stored_but(twin.folder, {"masses"}).size() ==
          vectors().size() - lines_of(bytes_of(vector_folder() / file)).size());
    CHECK_THROWS_WITH(generator::certify_all(twin.folder, {"mases"}), Catch::Contains("mases"));

    for (const int mass : {-1, 0, 3, 100'000}) {
        const generator::Certified none = certified(with("mass", mass));
        CHECK(none.vectors.empty());
        REQUIRE(none.refusals.size() == 1);
        CHECK(none.refusals.front().id == "masses-0001");
        CHECK_THAT(none.refusals.front().why, Catch::Contains("mass"));
    }
    CHECK_THROWS_WITH(certified(with("tier", "hard")), Catch::Contains("masses.jsonl, line 1") && Catch::Contains("tier"));
    CHECK_THROWS_WITH(certified(question, question.dump() + "\n"),
                      Catch::Contains("masses.jsonl, line 2") && Catch::Contains("once"));
    CHECK_THROWS_WITH(certified(question, "{\"id\"\n"), Catch::Contains("masses.jsonl, line 2"));
}

TEST_CASE("the plain closed form agrees with every certified vector but motions of several periods",
          "[eq:38][eq:46][eq:69][conformance][vectors]") {
    constexpr double of_what_passes = 5; // in double nothing is done here to keep digits where terms cancel
    std::size_t compared = 0, several_periods = 0;
    std::pair<double, std::string> worst{0, ""};
    for (const Vector& v : tests::vectors()) {
        if (!v.reject.empty()) continue;
        const std::optional<Value> value = plain_answer(v.question);
        INFO(v.question.id << " " << v.question.quantity);
        if (!value && std::ranges::find(v.flags, "several-periods") != v.flags.end()) {
            ++several_periods;
            continue;
        }
        REQUIRE(value);
        CHECK(value->word == v.word);
        REQUIRE(value->numbers.size() == v.nearest.size());
        ++compared;
        if (v.nearest.empty()) continue;
        const double error = difference(quantity(v.question.quantity), value->numbers, v.nearest).size / v.scale;
        CHECK(error <= of_what_passes * v.tolerance.pass);
        if (v.tolerance.pass > 0) worst = std::max(worst, {error / v.tolerance.pass, v.question.id});
    }
    std::printf("plain closed form: %zu vectors, largest error %.2g of what passes, in %s\n", compared, worst.first,
                worst.second.c_str());
    CHECK(several_periods == 10);
    CHECK(compared > 4000);
}

// Lines of vector files that are no vectors: each is refused with the quantity at fault, before anybody is asked or judged by it.

namespace {

// The quantity that a vector is refused for, once a member is replaced.
std::string refused_for(const Vector& good, const char* pointer, const nlohmann::json& member) {
    nlohmann::json object = vector_json(good);
    REQUIRE_NOTHROW(vector_from_json(object));
    object[nlohmann::json::json_pointer(pointer)] = member;
    try {
        static_cast<void>(vector_from_json(object));
        return "nothing";
    } catch (const InputError& fault) {
        return fault.quantity;
    }
}

} // namespace

TEST_CASE("a vector is refused that cannot be asked in both dialects, or judged", "[conformance][vectors]") {
    Vector good = vector_of("a-1", "amplitude", {0.25});
    CHECK(refused_for(good, "/id", "a 1") == "id");
    CHECK(refused_for(good, "/id", "") == "id");
    CHECK(refused_for(good, "/hex", {"0x1p-2", "0x1p-2"}) == "hex");
    CHECK(refused_for(good, "/hex", {"inf"}) == "hex");
    CHECK(refused_for(good, "/scale", "0x0p0") == "scale");
    CHECK(refused_for(good, "/regime", "gliding") == "regime");
    CHECK(refused_for(good, "/scene/r", -1) == "r");
    CHECK(refused_for(reject_vector("a-1"), "/reject", "") == "reject");
    CHECK(refused_for(word_vector("a-1", "stick_slip"), "/value", "gliding") == "value");
    good = vector_of("a-1", "motion_under_force", {0.25, -0.25});
    good.question.samples = 2;
    CHECK(refused_for(good, "/samples", 3) == "samples");
}

TEST_CASE("whole numbers of a vector are not cut to size", "[conformance][vectors]") {
    const Vector good = vector_of("a-1", "amplitude", {0.25});
    for (const nlohmann::json& number :
         {nlohmann::json(1e300), nlohmann::json(1.5), nlohmann::json(4294967297), nlohmann::json(true)}) {
        CHECK(refused_for(good, "/scene/contact", number) == "contact");
        CHECK(refused_for(good, "/mass", number) == "mass");
    }
    CHECK(refused_for(good, "/digits", {40, 1e300}) == "digits");
}

TEST_CASE("neither vectors nor verdicts of earlier runs that are nested without an end do harm", "[conformance][program]") {
    const std::string deep = std::string(300000, '[') + std::string(300000, ']');
    CHECK_FALSE(json_or_nothing(deep).is_array());
    const std::string folder = folder_of("deep", {vector_of("a-1", "amplitude", {0.25})});
    std::ofstream(folder + "/a.jsonl", std::ios::app) << "{\"scene\":{},\"id\":" << deep << "}\n";
    const Run listed = conform("list " + with_vectors(folder, ""));
    CHECK(listed.status == 2);
    CHECK(contains(listed.error, "vector must be a JSON object"));
    const std::string answers = file_with("deep.csv", "id,value\namplitude-1,0.25\n").string();
    const std::string track = file_with("deep.track", "{\"format\":" + deep + "}").string();
    const Run graded = conform("grade " + with_vectors(six(), "") + "--track '" + track + "' '" + answers + "'");
    CHECK(graded.status == 2);
    CHECK(contains(graded.error, "track must be a file that --track has written"));
}

TEST_CASE("next to a pole of a mode without damping, where rounding alone would tell it, the plain closed form has no number",
          "[eq:23][eq:28][eq:29][conformance]") {
    ProtocolQuestion q{.id = "pole", .quantity = "", .mass_ratios = {1}, .stiffness_ratios = {1}, .damping_ratios = {0}};
    q.mass = 1;
    for (const int harmonic : {1, 3, 5}) // (23) has the first alone, (28) and (29) all odd ones
        for (const char* asked : {"complex_response", "first_damping_function", "second_damping_function"}) {
            q.quantity = asked;
            INFO(asked << ", harmonic " << harmonic);
            const bool has_pole = harmonic == 1 || q.quantity != "complex_response";
            for (const double apart : {0.0, 1e-15, -1e-15, 1e-11, -1e-11}) {
                q.r = (1 + apart) / harmonic;
                CHECK(plain_answer(q).has_value() == (!has_pole || std::abs(apart) > 1e-12));
            }
        }
}
