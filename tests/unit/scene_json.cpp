#include "denhartog/scene/scene_json.hpp"
#include "denhartog/denhartog.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using nlohmann::json;

namespace {

json good() {
    return json::parse(
        R"({"mass_ratios": [1, 2.5, 0.75], "stiffness_ratios": [1, 0.625, 1.875], "damping_ratios": [0.03, 0.06, 0.09],
                           "contact": 2, "load": 1, "mu": 1.375, "r": 1.125, "beta": 0.15625})");
}

json dimensional() {
    return json::parse(R"({"masses": [4, 10, 3], "stiffnesses": [16, 10, 30], "damping_ratios": 0.25, "contact": 3, "load": 1,
                           "force": 8, "friction": 2, "frequency": 3})");
}

/// The error of a scene.
InputError refusal(const json& scene) {
    try {
        (void)read_scene<double>(scene.dump());
    } catch (const InputError& fault) {
        return fault;
    }
    FAIL("no error of " << scene.dump());
    return InputError("", "", "");
}

json changed(json scene, const std::string& patch) {
    scene.merge_patch(json::parse(patch));
    return scene;
}

void check_refused(const json& scene, const std::string& quantity, const std::string& rule, const std::string& value,
                   const std::string& place) {
    const InputError fault = refusal(scene);
    INFO(scene.dump() << ": " << fault.what());
    CHECK(fault.quantity == quantity);
    CHECK(fault.rule.find(rule) != std::string::npos);
    CHECK(fault.value == value);
    CHECK(fault.place == place);
}

/// Checks what is said of a scene after a merge patch. A row is `PATCH | QUANTITY | PIECE OF THE RULE | VALUE | PLACE`.
void refuses(const json& scene, const std::string& table) {
    std::istringstream lines(table);
    int rows = 0;
    for (std::string line, more; std::getline(lines, line);) {
        if (line.find('|') == std::string::npos) continue;
        if (std::ranges::count(line, '|') < 4 && std::getline(lines, more)) line += more; // a row of two lines
        std::vector<std::string> cells;
        std::istringstream in(line + " |");
        for (std::string cell; std::getline(in, cell, '|');) {
            const std::size_t from = cell.find_first_not_of(' ');
            cells.push_back(from == std::string::npos ? "" : cell.substr(from, cell.find_last_not_of(' ') + 1 - from));
        }
        REQUIRE(cells.size() == 5);
        check_refused(changed(scene, cells[0]), cells[1], cells[2], cells[3], cells[4]);
        ++rows;
    }
    CHECK(rows > 0);
}

template <class T>
void require_same(const Scene<T>& a, const Scene<T>& b) {
    REQUIRE(a.system.mass_ratios == b.system.mass_ratios);
    REQUIRE(a.system.stiffness_ratios == b.system.stiffness_ratios);
    REQUIRE(a.system.damping_ratios == b.system.damping_ratios);
    REQUIRE(a.system.mass_matrix == b.system.mass_matrix);
    REQUIRE(a.system.stiffness_matrix == b.system.stiffness_matrix);
    REQUIRE(a.system.damping_matrix == b.system.damping_matrix);
    REQUIRE(a.system.contact == b.system.contact);
    REQUIRE(a.system.load == b.system.load);
    REQUIRE(a.mu == b.mu);
    REQUIRE(a.r == b.r);
    REQUIRE(a.beta == b.beta);
}

} // namespace

TEST_CASE("a scene by ratios is read, masses counted from 1", "[scene][json]") {
    const Scene<double> scene = read_scene<double>(good().dump());
    REQUIRE(scene.system.mass_ratios == std::vector<double>{1, 2.5, 0.75});
    REQUIRE(scene.system.stiffness_ratios == std::vector<double>{1, 0.625, 1.875});
    REQUIRE(scene.system.damping_ratios == std::vector<double>{0.03, 0.06, 0.09});
    REQUIRE(scene.system.contact == Mass{1});
    REQUIRE(scene.system.load == Mass{0});
    REQUIRE(scene.mu == 1.375);
    REQUIRE(scene.r == 1.125);
    REQUIRE(scene.beta == 0.15625);
}

TEST_CASE("mu, r and beta may be left out, one damping ratio serves all modes", "[scene][json]") {
    const Scene<double> scene = read_scene<double>(
        R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 1], "damping_ratios": "0.125", "contact": 2.0, "load": 1})");
    REQUIRE(scene.system.damping_ratios == std::vector<double>{0.125, 0.125});
    REQUIRE(scene.mu == 1);
    REQUIRE_FALSE(scene.r);
    REQUIRE_FALSE(scene.beta);
}

TEST_CASE("a number as text has all digits of the number type, a JSON number is the double", "[scene][json]") {
    json text = good();
    text["r"] = "0.1";
    text["beta"] = 0.1;
    const Scene<Real50> scene = read_scene<Real50>(text.dump());
    REQUIRE(*scene.r == Real50(1) / 10);
    REQUIRE(*scene.beta == Real50(0.1));
}

TEST_CASE("a dimensional scene is divided by its first mass, its first spring and its load",
          "[scene][json][eq:9][eq:10][eq:11][eq:73]") {
    const Scene<double> scene = read_scene<double>(dimensional().dump());
    REQUIRE(scene.system.mass_ratios == std::vector<double>{1, 2.5, 0.75});
    REQUIRE(scene.system.stiffness_ratios == std::vector<double>{1, 0.625, 1.875});
    REQUIRE(scene.system.damping_ratios == std::vector<double>{0.25, 0.25, 0.25});
    REQUIRE(scene.r == 1.5);
    REQUIRE(scene.beta == 0.25);
    json by_matrix = dimensional();
    by_matrix.erase("damping_ratios");
    by_matrix["damping_matrix"] = {{4, 0, 0}, {0, 10, 0}, {0, 0, 3}};
    REQUIRE(read_scene<double>(by_matrix.dump()).system.damping_matrix ==
            Matrix<double>{{0.5, 0, 0}, {0, 1.25, 0}, {0, 0, 0.375}});
}

TEST_CASE("matrices take the place of ratios", "[scene][json]") {
    const Scene<double> scene =
        read_scene<double>(R"({"mass_matrix": [[1, 0.25], [0.25, 2]], "stiffness_matrix": [[2, -1], [-1, "1.5"]],
        "damping_matrix": [[0.2, -0.1], [-0.1, 0.15]], "contact": 1, "load": 2})");
    REQUIRE(scene.system.mass_matrix == Matrix<double>{{1, 0.25}, {0.25, 2}});
    REQUIRE(scene.system.stiffness_matrix == Matrix<double>{{2, -1}, {-1, 1.5}});
    REQUIRE(scene.system.damping_matrix == Matrix<double>{{0.2, -0.1}, {-0.1, 0.15}});
}

TEST_CASE("a scene that is written is read again to the last bit", "[scene][json]") {
    Scene<double> scene;
    scene.system.mass_ratios = {1, std::sqrt(2)};
    scene.system.stiffness_ratios = {1, 1.0 / 3};
    scene.system.damping_ratios = {0.1, 0};
    scene.system.contact.index = 1;
    scene.mu = 4.0 / 3;
    scene.r = std::sqrt(3);
    require_same(read_scene<double>(write_scene(scene).dump()), scene);
    scene.beta = 1.0 / 7;
    scene.system.mass_ratios.clear();
    scene.system.stiffness_ratios.clear();
    scene.system.damping_ratios.clear();
    scene.system.mass_matrix = Matrix<double>{{1, 1.0 / 3}, {1.0 / 3, 2}};
    scene.system.stiffness_matrix = Matrix<double>{{2, -std::sqrt(2)}, {-std::sqrt(2), 2}};
    scene.system.damping_matrix = scene.system.mass_matrix / 10;
    require_same(read_scene<double>(write_scene(scene).dump()), scene);
    REQUIRE(json::parse(write_scene(read_scene<double>(good().dump())).dump()) == good());
    REQUIRE_THROWS_AS(write_scene(Scene<double>{}), InputError);
}

TEST_CASE("a key that is missing is named", "[scene][json][bad-input]") {
    for (const char* key : {"mass_ratios", "stiffness_ratios", "damping_ratios", "contact", "load"})
        check_refused(changed(good(), json{{key, nullptr}}.dump()), key, "must be given", "", "");
    for (const char* key : {"masses", "stiffnesses", "force"})
        check_refused(changed(dimensional(), json{{key, nullptr}}.dump()), key, "must be given", "", "");
}

TEST_CASE("keys that exclude each other are both named", "[scene][json][bad-input]") {
    refuses(good(), R"(
        {"masses": [1]}           | mass_ratios    | together with masses         | | /mass_ratios
        {"mass_matrix": [[1]]}    | mass_matrix    | together with mass_ratios    | | /mass_matrix
        {"damping_matrix": [[1]]} | damping_matrix | together with damping_ratios | | /damping_matrix
        {"normal_force": 1}       | mass_ratios    | together with normal_force   | | /mass_ratios
    )");
    refuses(dimensional(), R"(
        {"r": 1}    | r    | together with masses | | /r
        {"beta": 1} | beta | together with masses | | /beta
    )");
}

TEST_CASE("a key that a scene does not have is refused", "[scene][json][bad-input]") {
    refuses(good(), R"(
        {"mas_ratios": [1]}      | mas_ratios        | is no key of a scene                            | | /mas_ratios
        {"zzz": 1}               | zzz               | is no key of a scene. The keys are mass_ratios, | | /zzz
        {"a/b": 1}               | a/b               | is no key of a scene                            | | /a~1b
        {"mas_ratios": [1]}      | mas_ratios        | did you mean mass_ratios?                       | | /mas_ratios
        {"contacts": [1]}        | contacts          | did you mean contact?                           | | /contacts
        {"weight": 1}            | weight            | did you mean static_load?                       | | /weight
        {"stribeck_velocity": 1} | stribeck_velocity | another law of friction                         | | /stribeck_velocity
        {"qq": 1}                | qq                | The keys are mass_ratios, stiffness_ratios,     | | /qq
    )");
    CHECK(refusal(changed(good(), R"({"stribeck_velocity": 1})")).rule.find("did you mean") == std::string::npos);
}

TEST_CASE("a word for what a scene has under another name is answered with that name", "[scene][json][bad-input]") {
    refuses(good(), R"(
        {"mass": 1}    | mass    | did you mean masses, or mass_ratios?             | | /mass
        {"k": 1}       | k       | did you mean stiffnesses, or stiffness_ratios?   | | /k
        {"c": 1}       | c       | did you mean damping_matrix?                     | | /c
        {"damping": 1} | damping | did you mean damping_ratios, or damping_matrix?  | | /damping
        {"omega": 1}   | omega   | did you mean frequency, or r?                    | | /omega
        {"mu_s": 1}    | mu_s    | did you mean static_friction_coefficient, with friction_coefficient and normal_force? | | /mu_s
        {"mu": 0.12}   | mu      | a coefficient of friction is friction_coefficient | 0.12 | /mu
    )");
}

TEST_CASE("friction by its coefficients is the normal force times the kinetic one, and mu their ratio",
          "[scene][json][eq:3][eq:11]") {
    const auto with_friction = [](const json& friction) {
        json scene = dimensional();
        scene.erase("friction");
        scene.erase("mu");
        scene.update(friction);
        return scene;
    };
    const double P = dimensional().at("force").get<double>();
    const Scene<double> kinetic = read_scene<double>(with_friction({{"normal_force", 8}, {"friction_coefficient", 0.25}}).dump());
    REQUIRE(kinetic.beta == 2 / P);
    REQUIRE(kinetic.mu == 1);
    const json both{{"normal_force", 8}, {"friction_coefficient", 0.25}, {"static_friction_coefficient", 0.375}};
    REQUIRE(read_scene<double>(with_friction(both).dump()).mu == 1.5);
    REQUIRE(read_scene<Real50>(with_friction({{"normal_force", "0.1"}, {"friction_coefficient", "0.1"}}).dump()).beta.value() ==
            Real50("0.1") * Real50("0.1") / P);
    refuses(with_friction(both), R"(
        {"friction": 2}                        | friction | must not be given together with normal_force | 2 | /friction
        {"mu": 1.5}                            | mu | must not be given together with static_friction_coefficient | 1.5 | /mu
        {"normal_force": -1}                   | normal_force | must not be negative | -1 | /normal_force
        {"friction_coefficient": 0}            | friction_coefficient | must be positive, if static_friction_coefficient
                                               | 0 | /friction_coefficient
        {"static_friction_coefficient": 0.125} | static_friction_coefficient | must not be below friction_coefficient
                                               | 0.125 | /static_friction_coefficient
        {"normal_force": null}                 | normal_force | must be given | |
        {"friction_coefficient": null}         | friction_coefficient | must be given | |
    )");
}

TEST_CASE("a constant load is in units of P, read and written", "[scene][json][static-load]") {
    json s = good();
    s["static_load"] = {1, "-0.1", 0};
    const Scene<double> scene = read_scene<double>(s.dump());
    CHECK(scene.static_load == std::vector<double>{1, -0.1, 0});
    CHECK(read_scene<double>(write_scene(scene).dump()).static_load == scene.static_load);
    CHECK(read_scene<double>(good().dump()).static_load.empty());
    json units = dimensional();
    const double P = units.at("force").get<double>();
    units["static_load"] = {3, 0, -1};
    CHECK(read_scene<double>(units.dump()).static_load == std::vector<double>{3 / P, 0 / P, -1 / P});
    refuses(good(), R"({"static_load": [1, 2]} | static_load | as many values | 2 | /static_load)");
}

TEST_CASE("the values of a single mass may stand without their brackets, as Octave writes them", "[scene][json]") {
    json one = good();
    for (const char* key : {"mass_ratios", "stiffness_ratios"}) one[key] = 1;
    one["damping_ratios"] = 0.03;
    one["contact"] = 1;
    const Scene<double> scene = read_scene<double>(one.dump());
    CHECK(scene.system.mass_ratios == std::vector<double>{1});
    CHECK(scene.system.stiffness_ratios == std::vector<double>{1});
    CHECK(scene.system.damping_ratios == std::vector<double>{0.03});
    refuses(good(), R"({"mass_ratios": 1} | stiffness_ratios | as many values as there are masses | 3 | /stiffness_ratios)");
}

TEST_CASE("a value of the wrong type is refused at its place", "[scene][json][bad-input]") {
    refuses(good(), R"(
        {"mass_ratios": [1, "abc", 1]} | mass_ratios    | written as a number           | "abc"    | /mass_ratios/1
        {"mass_ratios": [1, "inf", 1]} | mass_ratios    | written as a number           | "inf"    | /mass_ratios/1
        {"r": "1e999"}                 | r              | beyond the largest number     | "1e999"  | /r
        {"r": "1e-999"}                | r              | not below the smallest number | "1e-999" | /r
        {"mu": true}                   | mu             | must be a number              | true     | /mu
        {"mass_ratios": true}          | mass_ratios    | array of numbers              | true     | /mass_ratios
        {"mass_ratios": []}            | mass_ratios    | at least one                  | []       | /mass_ratios
        {"damping_ratios": []}         | damping_ratios | at least one                  | []       | /damping_ratios
        {"contact": 1.5}               | contact        | whole number                  | 1.5      | /contact
        {"contact": "2"}               | contact        | whole number                  | "2"      | /contact
        {"contact": 0}                 | contact        | whole number                  | 0        | /contact
        {"contact": -1}                | contact        | whole number                  | -1       | /contact
        {"contact": 1e300}             | contact        | whole number                  | 1e+300   | /contact
        {"contact": [1]}               | contact        | whole number                  | [1]      | /contact
        [1, 2]                         | scene          | must be a JSON object         | [1,2]    |
    )");
    json s = good(); // what a merge patch cannot put there
    s["r"] = nullptr;
    check_refused(s, "r", "must be a number", "null", "/r");
    s = good();
    s["damping_ratios"] = json::object();
    check_refused(s, "damping_ratios", "or one number", "{}", "/damping_ratios");
}

TEST_CASE("a matrix is an array of rows of equal length", "[scene][json][bad-input]") {
    const json by_matrix = changed(good(), R"({"stiffness_ratios": null})");
    refuses(by_matrix, R"(
        {"stiffness_matrix": [[1, 2], [3]]}      | stiffness_matrix | row 2 must have 2 values | 1      | /stiffness_matrix/1
        {"stiffness_matrix": 5}                  | stiffness_matrix | array of rows            | 5      | /stiffness_matrix
        {"stiffness_matrix": [1, 2]}             | stiffness_matrix | array of rows            | 1      | /stiffness_matrix/0
        {"stiffness_matrix": []}                 | stiffness_matrix | at least one row         | []     | /stiffness_matrix
        {"stiffness_matrix": [[1, "x"], [0, 1]]} | stiffness_matrix | written as a number      | "x"    | /stiffness_matrix/0/1
        {"stiffness_matrix": [[1, 0], [0, 1]]}   | stiffness_matrix | 3 rows and columns       | 2 by 2 | /stiffness_matrix
        {"stiffness_matrix": [[2, -1, 0], [-1, 2, -1], [0.5, -1, 2]]} | stiffness_matrix | symmetric | 0.5 | /stiffness_matrix/2/0
        {"stiffness_matrix": [[2, -1, 0], [-1, 2, -1], [0, -1.5, 1]]} | stiffness_matrix
            | symmetric: in row 3, column 2 must be -1 as in row 2, column 3 | -1.5 | /stiffness_matrix/2/1
        {"stiffness_matrix": [[1, -1, 0], [-1, 2, -1], [0, -1, 1]]} | stiffness_matrix
            | positive definite | singular: its leading minor of order 3 is zero to working precision | /stiffness_matrix
        {"stiffness_matrix": [[-1, -1, 0], [-1, 2, -1], [0, -1, 1]]} | stiffness_matrix
            | positive definite | not: its leading minor of order 1 is negative | /stiffness_matrix
        {"damping_ratios": null, "damping_matrix": [[0, 0], [0, 0]], "stiffness_ratios": [1, 1, 1]} | damping_matrix
            | must have 3 rows and columns | 2 by 2 | /damping_matrix
    )");
    refuses(changed(good(), R"({"mass_ratios": null})"), R"(
        {"mass_matrix": [[1, 0.5, 0], [0.5, 0.125, 0], [0, 0, 0.75]]} | mass_matrix
            | positive definite | not: its leading minor of order 2 is negative | /mass_matrix
        {"mass_matrix": [[1, 0.5, 0], [0.5, 2.5, 0], [0, 0, 0]]} | mass_matrix
            | positive definite | singular: its leading minor of order 3 is zero to working precision | /mass_matrix
    )");
}

TEST_CASE("every rule of a scene gives the place in the JSON", "[scene][json][bad-input]") {
    refuses(good(), R"(
        {"mass_ratios": [1, -2, 1]}         | mass_ratios      | of mass 2 must be positive     | -2     | /mass_ratios/1
        {"mass_ratios": [1, 2, 0]}          | mass_ratios      | of mass 3 must be positive     | 0      | /mass_ratios/2
        {"mass_ratios": [2, 2, 1]}          | mass_ratios      | of mass 1 must be 1            | 2      | /mass_ratios/0
        {"stiffness_ratios": [1, 0, 1]}     | stiffness_ratios | of spring 2 must be positive   | 0      | /stiffness_ratios/1
        {"stiffness_ratios": [1, 1, 0]}     | stiffness_ratios | positive                       | 0      | /stiffness_ratios/2
        {"stiffness_ratios": [0.5, 1, 1]}   | stiffness_ratios | of spring 1 must be 1          | 0.5    | /stiffness_ratios/0
        {"stiffness_ratios": [1]}           | stiffness_ratios | as many values                 | 1      | /stiffness_ratios
        {"stiffness_ratios": [1, 1]}        | stiffness_ratios | as many values                 | 2      | /stiffness_ratios
        {"damping_ratios": [0, 0, -0.125]}  | damping_ratios   | of mode 3 must not be negative | -0.125 | /damping_ratios/2
        {"damping_ratios": [1e301, 0, 0]}   | damping_ratios   | mode 1 must be at most 1e300   | 1e+301 | /damping_ratios/0
        {"damping_ratios": [0.1, 0, 1e301]} | damping_ratios   | mode 3 must be at most 1e300   | 1e+301 | /damping_ratios/2
        {"damping_ratios": [0, 0, 0, 0]}    | damping_ratios   | as many values                 | 4      | /damping_ratios
        {"damping_ratios": 2e300}           | damping_ratios   | mode 1 must be at most 1e300   | 2e+300 | /damping_ratios
        {"damping_ratios": -0.5}            | damping_ratios   | not be negative                | -0.5   | /damping_ratios
        {"contact": 4}                      | contact          | from 1 to 3                    | 4      | /contact
        {"load": 8}                         | load             | from 1 to 3                    | 8      | /load
        {"mu": 0.5}                         | mu               | at least 1                     | 0.5    | /mu
        {"beta": -0.25}                     | beta             | not be negative                | -0.25  | /beta
        {"r": 0}                            | r                | positive                       | 0      | /r
        {"r": -1}                           | r                | positive                       | -1     | /r
    )");
}

TEST_CASE("a dimensional scene breaks rules under its own names", "[scene][json][bad-input]") {
    refuses(dimensional(), R"(
        {"masses": [0, 10, 3]}         | masses      | positive                 | 0   | /masses/0
        {"stiffnesses": [16, 10, -30]} | stiffnesses | positive                 | -30 | /stiffnesses/2
        {"stiffnesses": [10, 30]}      | stiffnesses | as many                  | 2   | /stiffnesses
        {"force": 0}                   | force       | positive                 | 0   | /force
        {"friction": -1}               | friction    | negative                 | -1  | /friction
        {"frequency": 0}               | frequency   | positive                 | 0   | /frequency
        {"stiffnesses": 0}             | stiffnesses | positive                 | 0   | /stiffnesses
        {"masses": [1e-300, 1e300, 1]} | masses      | of mass 2 must be finite | inf | /masses/1
    )");
}

TEST_CASE("the schema has the keys that the reader accepts", "[scene][json][docs]") {
    std::ifstream file(tests::source_file("docs/scene.schema.json"));
    const json schema = json::parse(file);
    std::set<std::string> documented;
    for (const auto& entry : schema.at("properties").items()) {
        documented.insert(entry.key());
        REQUIRE(entry.value().contains("description"));
    }
    REQUIRE(documented == std::set<std::string>(scene_keys().begin(), scene_keys().end()));
}

TEST_CASE("a contact may be between two masses, a load on each, and there is room for a comment", "[scene][json][vectors]") {
    json s = good();
    s["contact"] = {1, 3};
    s["load"] = {0.5, -1, "0.25"};
    s["comment"] = "as measured";
    const Scene<double> read = read_scene<double>(s.dump());
    REQUIRE(read.system.contact == Mass{0});
    REQUIRE(read.system.contact_with == Mass{2});
    REQUIRE(read.system.load_vector == std::vector<double>{0.5, -1, 0.25});
    const Scene<double> again = read_scene<double>(write_scene(read).dump());
    REQUIRE(again.system.contact_with == read.system.contact_with);
    REQUIRE(again.system.load_vector == read.system.load_vector);

    refuses(good(), R"(
        {"contact": [1, 2, 3]} | contact | or two of them                      | [1,2,3]  | /contact
        {"contact": [1, 4]}    | contact | must be a mass from 1 to 3          | 4        | /contact/1
        {"contact": [2, 2]}    | contact | between two masses                  | 2        | /contact/1
        {"load": [1, 2]}       | load    | as many values as there are masses (3) | 2     | /load
        {"load": [0, 0, 0]}    | load    | must act on at least one mass       | 0 on all | /load
    )");
    json on_contact = good();
    on_contact["load"] = {0, -2, 0};
    REQUIRE(read_scene<double>(on_contact.dump()).system.load_vector == std::vector<double>{0, -2, 0});
}

TEST_CASE("a moving base loads the masses by inertia, or by its springs", "[scene][json][vectors]") {
    json s = good();
    s.erase("load");
    s["base_motion"] = "with_wall";
    REQUIRE(read_scene<double>(s.dump()).system.load_vector == std::vector<double>{1, 2.5, 0.75});
    s["mass_matrix"] = {{2, 0.5, 0}, {0.5, 1, 0}, {0, 0, 3}};
    s.erase("mass_ratios");
    REQUIRE(read_scene<double>(s.dump()).system.load_vector == std::vector<double>{2.5, 1.5, 3});
    s["base_motion"] = "alone";
    s["damping_ratios"] = 0;
    REQUIRE(read_scene<double>(s.dump()).system.load_vector == std::vector<double>{1, 0, 0});
    s["base_motion"] = "up";
    REQUIRE_THROWS_WITH(read_scene<double>(s.dump()), Catch::Matchers::Contains("(base and wall move together)"));
    s["load"] = 1;
    REQUIRE_THROWS_WITH(read_scene<double>(s.dump()), Catch::Matchers::Contains("must not be given together with load"));
}

TEST_CASE("the forces of a load may have phases", "[scene][json][phases][bad-input]") {
    json s = good();
    s["load"] = {0.5, -1, 0.25};
    s["load_phases"] = {0, "1.5", -2};
    const Scene<double> read = read_scene<double>(s.dump());
    REQUIRE(read.system.load_phases == std::vector<double>{0, 1.5, -2});
    REQUIRE(read_scene<double>(write_scene(read).dump()).system.load_phases == read.system.load_phases);
    s["load_phases"] = {0, 0, 0}; // all in phase
    REQUIRE(read_scene<double>(s.dump()).system.load_phases.empty());

    refuses(changed(good(), R"({"load": [0.5, -1, 0.25]})"), R"(
        {"load_phases": [0, 1]}                       | load_phases | as many values as there are masses (3) | 2 | /load_phases
        {"load_phases": [0, 1, "x"]}                  | load_phases | number                        | "x"      | /load_phases/2
        {"load_phases": "late"}                       | load_phases | must be an array              | "late"   | /load_phases
        {"load": 1, "load_phases": [0, 1, 2]}         | load_phases | together with load as a list  | [0,1,2]  | /load_phases
        {"load": [0, 0, 0], "load_phases": [0, 1, 2]} | load        | must act on at least one mass | 0 on all | /load
        {"load": null, "base_motion": "with_wall", "load_phases": [0, 1, 2]} | load_phases
                                                      | must not be given together with base_motion | [0,1,2] | /load_phases
    )");
    Scene<double> in_code = read;
    in_code.system.load_phases[1] = std::numeric_limits<double>::quiet_NaN();
    REQUIRE_THROWS_WITH(check(in_code), Catch::Matchers::Contains("load_phases of the force on mass 2 must be finite"));
    in_code.system.load_vector.clear();
    REQUIRE_THROWS_WITH(check(in_code),
                        Catch::Matchers::Contains("load_phases must be given together with load as a force on each"));
}

TEST_CASE("the contact may have any direction", "[scene][json][direction][bad-input]") {
    const Scene<double> read = read_scene<double>(changed(good(), R"({"contact": {"direction": [0.5, "-2", 0]}})").dump());
    REQUIRE(read.system.contact_direction == std::vector<double>{0.5, -2, 0});
    REQUIRE(read.system.contact == Mass{1}); // where one mass is asked for
    REQUIRE(read_scene<double>(write_scene(read).dump()).system.contact_direction == read.system.contact_direction);
    const json one = changed(good(), R"({"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0.05, "load": 1,
        "contact": {"direction": 1}})"); // as Octave writes a list of one number
    REQUIRE(read_scene<double>(one.dump()).system.contact_direction.empty());

    refuses(good(), R"(
        {"contact": {"direction": [0, 2, 0]}}      | direction | two entries at least that are not zero  | 2       | /contact/direction
        {"contact": {"direction": [1, 2]}}         | direction | as many values as there are masses (3)   | 2       | /contact/direction
        {"contact": {"direction": [1, 2, 3, 4]}}   | direction | as many values as there are masses (3)   | 4       | /contact/direction
        {"contact": {"direction": []}}             | direction | must have at least one value             | []      | /contact/direction
        {"contact": {"direction": [0, 0, 0]}}      | direction | must have an entry that is not zero      | 0 for all | /contact/direction
        {"contact": {"direction": [1, "x", 2]}}    | direction | number                                   | "x"     | /contact/direction/1
        {"contact": {"direction": [1, 2, 1e-7]}, "stiffness_ratios": [1, 2, 0]} | stiffness_ratios | positive | 0 | /stiffness_ratios/2
        {"contact": {"direction": [0, 1e-7, 1e-8]}} | direction | from 1e-6 to 1e6                         | 1e-07   | /contact/direction
        {"contact": {"direction": [0, 2, 1e7]}}    | direction | from 1e-6 to 1e6                         | 1e+07   | /contact/direction
        {"contact": {"direction": [0, "1.00000000000000000000001", 0]}} | direction | two entries at least       | 1       | /contact/direction
        {"contact": {"direction": "up"}}           | direction | must be an array of numbers              | "up"    | /contact/direction
        {"contact": {"direction": null}}           | contact   | must have the key direction              | {}      | /contact
        {"contact": {"mass": 2}}                   | contact   | must have the key direction alone        | mass    | /contact/mass
        {"contact": [1, 2, 3]}                     | contact   | {"direction": [..]}, a number for each   | [1,2,3] | /contact
        {"contact": {"direction": [1, -2, 1]}, "load": null, "base_motion": "wall"} | direction
                                                   | sum is not zero where the wall moves | 0 | /contact/direction
        {"contact": {"direction": [0.1, 0.2, -0.3]}, "load": null, "base_motion": "wall"} | direction
                                                   | sum is not zero where the wall moves | 0 | /contact/direction
        {"contact": {"direction": [2]}, "mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0.05} | direction
                                                   | must be 1 for a single mass          | 2 | /contact/direction
    )");
    Scene<double> in_code = read;
    in_code.system.contact_direction[1] = std::numeric_limits<double>::infinity();
    REQUIRE_THROWS_WITH(check(in_code), Catch::Matchers::Contains("direction of mass 2 must be finite"));
    in_code = read;
    in_code.system.contact_with = Mass{2};
    REQUIRE_THROWS_WITH(check(in_code), Catch::Matchers::Contains("direction must not be given together with a contact between"));
}

TEST_CASE("a dimensional scene is asked for what it lacks under its own names", "[scene][json][bad-input]") {
    for (const auto& [patch, told] : {std::pair(R"({"friction": null})", "friction must be given"),
                                      {R"({"friction": null, "force": null})", "force must be given, and friction with it"},
                                      {R"({"friction": null, "force": null, "frequency": null})", "frequency must be given"}})
        REQUIRE_THROWS_WITH(solve(read_scene<double>(changed(dimensional(), patch).dump())), Catch::Matchers::StartsWith(told));
}

TEST_CASE("a dimensional scene may have matrices, a frequency in hertz and a base that moves", "[scene][json][units]") {
    const auto read = [](const std::string& patch) { return read_scene<double>(changed(dimensional(), patch).dump()); };
    const Scene<double> plain = read("{}");
    CHECK(plain.units.value().mass == 4);
    CHECK(plain.units->stiffness == 16);
    CHECK(plain.units->force == 8.0);
    const Scene<double> by_matrices = read(R"({"masses": [[4, 1, 0], [1, 10, 0], [0, 0, 3]],
        "stiffnesses": [[26, -10, 0], [-10, 40, -30], [0, -30, 30]]})");
    CHECK(by_matrices.system.mass_matrix(1, 1) == 2.5);
    CHECK(by_matrices.system.mass_matrix(0, 1) == 0.25);
    CHECK(by_matrices.system.stiffness_matrix(2, 2) == 30.0 / 26);
    CHECK(by_matrices.r == Approx(3 * std::sqrt(4.0 / 26)));
    CHECK(read(R"({"frequency": null, "frequency_hz": 0.5})").r == Approx(pi<double>() * std::sqrt(4.0 / 16)));
    const std::string of_base = R"({"load": null, "force": null, "damping_ratios": 0, )";
    for (const auto& [base, force] : {std::pair(R"("base_motion": "with_wall", "base_displacement": 0.25})", 4 * 9 * 0.25),
                                      {R"("base_motion": "alone", "base_displacement": 0.25})", 4.0},
                                      {R"("base_motion": "wall", "base_displacement": 0.25})", 4.0},
                                      {R"("base_motion": "wall", "base_acceleration": 2.25})", 16 * 2.25 / 9},
                                      {R"("base_motion": "with_wall", "base_acceleration": 2.25})", 4 * 2.25}}) {
        INFO(base);
        CHECK(read(of_base + base).units.value().force == force);
        CHECK(read(of_base + base).beta == Approx(2 / force));
    }
    refuses(dimensional(), R"(
        {"masses": [[4, 1, 0], [2, 10, 0], [0, 0, 3]]} | masses | symmetric | 0.5 | /masses/1/0
        {"frequency_hz": 0.5} | frequency_hz | must not be given together with | 0.5 | /frequency_hz
        {"masses": null, "mass_matrix": [[4, 1, 0], [1, 10, 0], [0, 0, 3]]} | mass_matrix
            | a dimensional one has masses instead | | /mass_matrix
        {"load": null, "force": null, "base_motion": "wall", "base_displacement": 1, "base_acceleration": 2} | base_acceleration
            | must not be given together with base_displacement | 2 | /base_acceleration
        {"force": null, "base_displacement": 0.25} | base_displacement | must be given together with | 0.25 | /base_displacement
    )");
}
