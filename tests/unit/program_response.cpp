#include <cmath>

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog::tests;
using nlohmann::json;

namespace {

const std::string scene = R"({"mass_ratios": [1, 2.5, 0.75], "stiffness_ratios": [1, 0.625, 1.875],
  "damping_ratios": [0.03, 0.06, 0.09], "contact": 2, "load": 1, "mu": 1.375, "r": 1.125, "beta": 0.15625})";

std::string with_beta(const std::string& beta) {
    return R"({"mass_ratios": [1, 2.5, 0.75], "stiffness_ratios": [1, 0.625, 1.875], "damping_ratios": [0.03, 0.06, 0.09], )"
           R"("contact": 2, "load": 1, "mu": 1.375, "r": 1.125, "beta": )" +
           beta + "}";
}

std::vector<std::string> keys_of(const nlohmann::ordered_json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items()) keys.push_back(item.key());
    return keys;
}

} // namespace

TEST_CASE("the answer in the sliding regime has the keys of the interface", "[program]") {
    const Run run = run_program("response - --json", scene);
    REQUIRE(run.status == 0);
    CHECK(run.error.empty());
    const auto a = nlohmann::ordered_json::parse(run.output);
    CHECK(keys_of(a) == std::vector<std::string>{"regime", "r", "beta", "beta_lim", "beta_lim_error_bounds", "method", "contact",
                                                 "masses", "stops_per_period"});
    for (const char* limits : {"beta_lim", "beta_lim_error_bounds"})
        CHECK(keys_of(a[limits]) == std::vector<std::string>{"exact", "paper", "approximate", "sticking"});
    CHECK(keys_of(a["method"]) == std::vector<std::string>{"model", "precision", "proved", "why"});
    CHECK(a["method"]["proved"] == false);
    CHECK(keys_of(a["contact"]) == std::vector<std::string>{"mass", "amplitude", "phase"});
    REQUIRE(a["masses"].size() == 3);
    CHECK(keys_of(a["masses"][0]) == std::vector<std::string>{"mass", "x0", "v0", "amplitude", "phase", "amplitude_monoharmonic",
                                                              "phase_monoharmonic", "error_bound", "phase_error_bound"});
    CHECK(a["regime"] == "continuous");
    CHECK(a["method"]["model"] == "closed form");
    CHECK(a["stops_per_period"] == 0);
    CHECK(a["contact"]["mass"] == 2);
    CHECK(a["contact"]["amplitude"] == a["masses"][1]["amplitude"]);
    CHECK(run.output.find("-0.0") == std::string::npos);
    CHECK(run.output.find("null") == std::string::npos);
}

TEST_CASE("outside the sliding regime the closed-form fields are absent and a reason is there", "[program]") {
    for (const auto& [beta, regime] : {std::pair<std::string, std::string>{"0.75", "stick_slip"}, {"4", "permanent_sticking"}}) {
        const Run run = run_program("response --json", with_beta(beta));
        REQUIRE(run.status == 0);
        const json a = json::parse(run.output);
        CHECK(a["regime"] == regime);
        CHECK(a["reason"].get<std::string>().size() > 40);
        CHECK_FALSE(a.contains("masses"));
        CHECK_FALSE(a.contains("stops_per_period"));
        CHECK(a["contact"].size() == 1);
        CHECK(a["beta_lim"]["exact"] > 0);
    }
}

TEST_CASE("above 15 digits numbers are text with these digits", "[program]") {
    const Run run = run_program("response --json --digits 40", with_beta("\"0.1\""));
    REQUIRE(run.status == 0);
    const json a = json::parse(run.output);
    CHECK(a["beta"] == "1.000000000000000000000000000000000000000e-01");
    CHECK(a["method"]["precision"] == "reference");
    const std::string amplitude = a["contact"]["amplitude"];
    CHECK(std::count_if(amplitude.begin(), amplitude.begin() + static_cast<long>(amplitude.find('e')), ::isdigit) == 40);
    const json b = json::parse(run_program("response --json", with_beta("0.1")).output);
    CHECK(std::stod(amplitude) == Approx(b["contact"]["amplitude"].get<double>()).epsilon(1e-14));
    const json c = json::parse(run_program("response --json --digits 12", with_beta("0.1")).output);
    CHECK(c["contact"]["amplitude"].is_number());
}

TEST_CASE("a table has the same numbers", "[program]") {
    const Run run = run_program("response", scene);
    REQUIRE(run.status == 0);
    const json a = json::parse(run_program("response --json", scene).output);
    char amplitude[40];
    std::snprintf(amplitude, sizeof amplitude, "%.12g", a["masses"][2]["amplitude"].get<double>());
    CHECK(run.output.find(amplitude) != std::string::npos);
    CHECK(run.output.find("regime: continuous") == 0);
}

TEST_CASE("in JSON Lines a bad scene has its error in its place and the others are answered", "[program]") {
    const Run run =
        run_program("response --json", with_beta("0.125") + "\n" + with_beta("-1") + "\n\n" + with_beta("0.25") + "\n");
    CHECK(run.status == 2);
    const std::vector<std::string> lines = lines_of(run.output);
    REQUIRE(lines.size() == 3);
    CHECK(json::parse(lines[0])["beta"] == 0.125);
    const json error = json::parse(lines[1])["error"];
    CHECK(error["quantity"] == "beta");
    CHECK(error["value"] == "-1");
    CHECK(error["rule"].get<std::string>().size() > 5);
    CHECK(error["place"].get<std::string>().find("/beta") != std::string::npos);
    CHECK(json::parse(lines[2])["beta"] == 0.25);
    CHECK(lines_of(run.error).size() == 1);
}

TEST_CASE("digits that cannot be reached give status 3 and no number", "[program]") {
    const std::string slow =
        R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.05, "contact": 1, "load": 1, "r": 5e-324, "beta": 0.125})";
    const Run run = run_program("response --json --digits 95", slow);
    CHECK(run.status == 3);
    CHECK(run.output.empty());
    CHECK(lines_of(run.error).size() == 1);
    CHECK(run.error.find("the reference does not prove it") != std::string::npos);
    // Next to a pole of an undamped mode the boundary loses a dozen digits and more.
    const std::string pole =
        R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_matrix": [[0]], "damping_tolerance": 0.5, )"
        R"("contact": 1, "load": 1, "r": 0.3333333333333333, "beta": 0.125})";
    CHECK(run_program("response --json --digits 95", pole).status == 0);
}

TEST_CASE("the boundary needs no friction ratio", "[program][eq:69]") {
    const std::string without =
        R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0, "contact": 1, "load": 1, "r": 3})";
    const Run run = run_program("boundary --json", without);
    REQUIRE(run.status == 0);
    const json a = json::parse(run.output);
    CHECK(a["beta_lim"]["exact"] == Approx(0.5625).epsilon(1e-14));
    CHECK(a["beta_lim"]["sticking"] == 1);
    CHECK(a["binding_condition"] == "54a and 54b");
    CHECK(run_program("boundary", without).output.find("0.5625") != std::string::npos);
    const Run response = run_program("response --json", without);
    CHECK(response.status == 2);
    CHECK(response.error.find("beta must be given") != std::string::npos);
}

TEST_CASE("the functions have the keys of the interface and the values of the response", "[program]") {
    const Run run = run_program("functions --json", scene);
    REQUIRE(run.status == 0);
    const auto a = nlohmann::ordered_json::parse(run.output);
    CHECK(keys_of(a) == std::vector<std::string>{"modes", "masses", "H_j", "S_j", "error_bounds"});
    CHECK(keys_of(a["modes"][0]) ==
          std::vector<std::string>{"mode", "natural_frequency_ratio", "R", "zeta", "v", "u", "g", "error_bounds"});
    CHECK(keys_of(a["modes"][0]["error_bounds"]) ==
          std::vector<std::string>{"natural_frequency_ratio", "R", "zeta", "v", "u", "g"});
    CHECK(keys_of(a["masses"][0]) == std::vector<std::string>{"mass", "V", "U", "G", "error_bounds"});
    CHECK(keys_of(a["error_bounds"]) == std::vector<std::string>{"H_j", "S_j"});
    CHECK(keys_of(a["S_j"]) == std::vector<std::string>{"exact", "paper"});
    const auto& contact = a["masses"][1];
    const double V_re = contact["V"][0], V_im = contact["V"][1], U = contact["U"], G = contact["G"], beta = 0.15625;
    const double X_j = -beta * G + std::sqrt(V_re * V_re + V_im * V_im - beta * beta * U * U);
    const json b = json::parse(run_program("response --json", scene).output);
    CHECK(b["contact"]["amplitude"].get<double>() == Approx(X_j).epsilon(1e-13));
    CHECK(run_program("functions", scene).status == 0);
}

TEST_CASE("the modes of a system with a light mass have the digits of those without it", "[program][eq:15]") {
    // Double alone has the first natural frequency of this matrix to three digits.
    const Run light = run_program("functions --json", R"({"mass_matrix": [[1, 0, 0], [0, 2.1, 0], [0, 0, 1e-13]],
        "stiffness_matrix": [[1.9, -0.1, -0.8], [-0.1, 1.1, -0.3], [-0.8, -0.3, 2.2]], "damping_ratios": 0.01, "contact": 1,
        "load": 2, "r": 0.5})");
    const json condensed{{"mass_matrix", {{1, 0}, {0, 2.1}}},
                         {"stiffness_matrix", {{1.9 - 0.64 / 2.2, -0.1 - 0.24 / 2.2}, {-0.1 - 0.24 / 2.2, 1.1 - 0.09 / 2.2}}},
                         {"damping_ratios", 0.01},
                         {"contact", 1},
                         {"load", 2},
                         {"r", 0.5}};
    const Run without = run_program("functions --json", condensed.dump());
    REQUIRE(light.status == 0);
    REQUIRE(without.status == 0);
    const json a = json::parse(light.output).at("modes"), b = json::parse(without.output).at("modes");
    for (const std::size_t i : {0, 1})
        for (const char* key : {"natural_frequency_ratio", "R", "u", "g"})
            CHECK(a[i].at(key).get<double>() == Approx(b[i].at(key).get<double>()).epsilon(1e-6));
}

TEST_CASE("invariant points without digits have those that are asked for", "[program][eq:87]") {
    // Two natural frequencies of 1 to 9 digits beside one of 1e-5: amplitudes between them cancel.
    const std::string frame = R"({"mass_matrix": [[1, 0, 0], [0, 3e9, 0], [0, 0, 2]], "stiffness_matrix": [[1, -0.3, 0],
        [-0.3, 0.9, -0.5], [0, -0.5, 1.3]], "damping_ratios": 0.01, "contact": 3, "load": [1, 3e9, 2], "r": 1e-6})";
    const Run few = run_program("boundary --json --invariant-points 0.5:2", frame);
    const Run many = run_program("boundary --json --invariant-points 0.5:2 --digits 12", frame);
    REQUIRE(few.status == 0);
    REQUIRE(many.status == 0);
    const json a = json::parse(few.output).at("invariant_points"), b = json::parse(many.output).at("invariant_points");
    std::size_t compared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(a[k].at("points").size() == b[k].at("points").size());
        for (std::size_t n = 0; n < a[k].at("points").size(); ++n, ++compared)
            for (const char* key : {"r", "amplitude"})
                CHECK(a[k].at("points")[n].at(key).get<double>() ==
                      Approx(b[k].at("points")[n].at(key).get<double>()).epsilon(1e-6));
    }
    CHECK(compared == 8);
}

TEST_CASE("the motion is a table of one period that mirrors itself", "[program]") {
    const Run run = run_program("motion --samples 8", scene);
    REQUIRE(run.status == 0);
    const std::vector<std::string> lines = lines_of(run.output);
    REQUIRE(lines.size() == 9);
    CHECK(lines[0] == "tau,x_1,x_2,x_3,v_1,v_2,v_3");
    const std::vector<double> first = numbers_of(lines[1]), opposite = numbers_of(lines[5]), third = numbers_of(lines[3]);
    REQUIRE(first.size() == 7);
    CHECK(first[0] == 0);
    CHECK(third[0] == 1.5707963267948966);
    for (std::size_t n = 1; n < 7; ++n) CHECK(first[n] == Approx(-opposite[n]).margin(1e-14));
    const json a = json::parse(run_program("response --json", scene).output);
    CHECK(first[2] == Approx(a["contact"]["amplitude"].get<double>()).epsilon(1e-14));
    CHECK(first[4] == Approx(a["masses"][0]["v0"].get<double>()).epsilon(1e-12));
    CHECK(run_program("motion", with_beta("0.75")).status == 2);
    CHECK(run_program("motion", with_beta("0.75")).output.empty());
    CHECK(run_program("motion --samples 0", scene).status == 2);
    CHECK(run_program("motion", with_beta("0.125") + "\n" + with_beta("0.25")).status == 2);
}

TEST_CASE("displacements above a moving base are said to be relative to it", "[program][response][solve]") {
    for (const bool with_wall : {true, false}) {
        const std::string scene = R"({"mass_ratios": [1, 1], "stiffness_ratios": [1, 1], "contact": 1, "r": 0.3, "beta": 0.1,
            "damping_ratios": 0, "base_motion": ")" + std::string(with_wall ? "with_wall" : "alone") + "\"}";
        for (const std::string command : {"response", "solve", "integrate --cycles 3"}) {
            CHECK(json::parse(run_program(command + " --json", scene).output).contains("relative_to") == with_wall);
            const bool said = run_program(command, scene).output.find("relative to base and wall") != std::string::npos;
            CHECK(said == with_wall);
        }
    }
}

TEST_CASE("how far damping couples the modes is told of a scene of which double has no modes", "[program][response][eq:18]") {
    const Run run = run_program("response --json", R"({"masses": [[27, 0], [0, 3e-9]],
        "stiffnesses": [[546451, -511864], [-511864, 661600]], "damping_matrix": [[300, -200], [-200, 400]], "contact": 1,
        "base_motion": "with_wall", "base_displacement": 0.001, "frequency": 64, "friction": 12})");
    REQUIRE(run.status == 0);
    const json damping = json::parse(run.output)["damping"];
    CHECK(damping["coupling"] == "taken_in");
    CHECK(damping["largest_coupling"] > 0.1);
    CHECK(damping["largest_coupling"] < 1);
}
