// Bounds of what an answer is made of: modes, response functions, boundaries, invariant points, (88).
#include <cmath>
#include <random>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/mode_sums.hpp"
#include "tests/catch.hpp"
#include "tests/support/closed_form.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog;
using namespace denhartog::tests;
using nlohmann::json;

namespace {

/// Chains and matrices of 1 to 6 masses, as text.
std::vector<std::string> scenes_as_text(int count) {
    std::mt19937_64 generator(1701);
    const auto between = [&](double a, double b) { return a + (b - a) * static_cast<double>(generator() >> 11) * 0x1p-53; };
    std::vector<std::string> texts;
    for (int n = 0; n < count; ++n) {
        const int N = 1 + n % 6;
        json scene{{"mass_ratios", {1}}, {"damping_ratios", json::array()}, {"mu", 1 + between(0, 1)}, {"r", between(0.2, 2)}};
        for (int k = 1; k < N; ++k) scene["mass_ratios"].push_back(std::exp(between(-2, 2)));
        for (int k = 0; k < N; ++k) scene["damping_ratios"].push_back(between(0.01, 1.2));
        if (n % 3 != 0) {
            scene["stiffness_ratios"] = {1};
            for (int k = 1; k < N; ++k) scene["stiffness_ratios"].push_back(std::exp(between(-2, 2)));
        } else {
            for (int i = 0; i < N; ++i) {
                scene["stiffness_matrix"].push_back(json::array());
                for (int k = 0; k < N; ++k)
                    scene["stiffness_matrix"][i].push_back(k == i  ? between(3, 5)
                                                           : k < i ? scene["stiffness_matrix"][k][i].get<double>()
                                                                   : between(-0.5, 0.1));
            }
        }
        scene["contact"] = 1 + static_cast<int>(generator() % static_cast<unsigned>(N));
        scene["load"] = 1 + static_cast<int>(generator() % static_cast<unsigned>(N));
        texts.push_back(scene.dump());
    }
    return texts;
}

/// Numbers held against what they are, and how many use more than a fraction of their bound.
struct Held {
    int numbers = 0;
    int close = 0;

    void take(const char* name, double value, const json& bound, const Real50& truth) {
        INFO(name << " " << value << ", bound " << bound);
        REQUIRE(bound.is_number());
        const auto error = static_cast<double>(abs(Real50(truth - value)));
        CHECK(error <= bound.get<double>() + 1e-29 * std::abs(value)); // what the other number is good to
        ++numbers;
        close += 1024 * error > bound.get<double>();
    }
    void take(const char* name, const json& pair, const json& bound, const Complex<Real50>& truth) {
        take(name, pair[0].get<double>(), bound, truth.re);
        take(name, pair[1].get<double>(), bound, truth.im);
    }
};

} // namespace

TEST_CASE("modes, what they contribute, and the sums over them are within their bounds of 50 digits", "[program][eq:15][eq:33]") {
    Held held;
    for (const std::string& text : scenes_as_text(60)) {
        INFO(text);
        const Run run = run_program("functions --json", text);
        REQUIRE(run.status == 0);
        const json all = json::parse(run.output);
        const Scene<Real50> scene = read_scene<Real50>(text);
        const ModalBasis<Real50> basis = modal_basis(scene.system);
        const ModeSums<Real50> s = mode_sums(basis, scene.system.contact, scene.system.load, *scene.r);
        for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
            const json &mode = all["modes"][i], &bounds = mode["error_bounds"];
            const auto take = [&](const char* key, const Real50& truth) {
                held.take(key, mode[key].get<double>(), bounds[key], truth);
            };
            take("natural_frequency_ratio", basis.r_n[i]);
            take("R", Real50(*scene.r / basis.r_n[i]));
            take("zeta", basis.zeta[i]);
            held.take("v", mode["v"], bounds["v"], s.v[i]);
            take("u", s.u[i]);
            take("g", s.g[i]);
        }
        for (std::size_t k = 0; k < s.V.size(); ++k) {
            const json &mass = all["masses"][k], &bounds = mass["error_bounds"];
            held.take("V", mass["V"], bounds["V"], s.V[k]);
            held.take("U", mass["U"].get<double>(), bounds["U"], s.U[k]);
            held.take("G", mass["G"].get<double>(), bounds["G"], s.G[k]);
        }
        const json& bounds = all["error_bounds"];
        const Boundary<Real50> limits = boundary(s, Real50(scene.mu));
        held.take("H_j", all["H_j"].get<double>(), bounds["H_j"], s.H_j);
        held.take("S_j exact", all["S_j"]["exact"].get<double>(), bounds["S_j"]["exact"], limits.S_exact);
        held.take("S_j paper", all["S_j"]["paper"].get<double>(), bounds["S_j"]["paper"], limits.S_paper);
        const json b = json::parse(run_program("boundary --json", text).output);
        const auto limit = [&](const char* key, const Real50& truth) {
            held.take(key, b["beta_lim"][key].get<double>(), b["beta_lim_error_bounds"][key], truth);
        };
        limit("exact", limits.exact);
        limit("paper", limits.paper);
        limit("approximate", limits.approximate);
        if (limits.sticking) limit("sticking", *limits.sticking);
    }
    INFO(held.close << " of " << held.numbers);
    CHECK(held.close > held.numbers / 4); // bounds a thousand times smaller would not hold
}

TEST_CASE("invariant points are within their bounds of those to 30 digits", "[program][eq:87]") {
    Held held;
    for (const std::string& text : scenes_as_text(18)) {
        INFO(text);
        const json few = json::parse(run_program("boundary --json --invariant-points 0.8:2", text).output).at("invariant_points");
        const json many =
            json::parse(run_program("boundary --json --invariant-points 0.8:2 --digits 30", text).output).at("invariant_points");
        for (std::size_t k = 0; k < few.size(); ++k) {
            const json &a = few[k].at("points"), &b = many[k].at("points");
            if (many[k].contains("undecided")) continue;
            REQUIRE(a.size() == b.size());
            for (std::size_t n = 0; n < a.size(); ++n) {
                held.take("r", a[n]["r"].get<double>(), a[n]["r_error_bound"], Real50(b[n]["r"].get<std::string>()));
                held.take("amplitude", a[n]["amplitude"].get<double>(), a[n]["error_bound"],
                          Real50(b[n]["amplitude"].get<std::string>()));
                CHECK(a[n]["kind"] == b[n]["kind"]);
            }
        }
    }
    INFO(held.close << " of " << held.numbers);
    CHECK(held.numbers > 200);
    CHECK(held.close > held.numbers / 4);
}

TEST_CASE("permanent sticking by (88) has the digits asked for", "[program][eq:88]") {
    const std::string scene = R"({"mass_ratios": [1, 2.5, 0.75], "stiffness_ratios": [1, 0.625, 1.875],
        "damping_ratios": [0.03, 0.06, 0.09], "contact": 2, "load": 1, "mu": 1.375, "r": 1.125, "beta": 0.15625})";
    for (const int digits : {6, 12, 14, 15}) {
        const Run run = run_program("solve --ask regime --json --digits " + std::to_string(digits), scene);
        REQUIRE(run.status == 0);
        const json all = json::parse(run.output);
        INFO(digits << " digits");
        CHECK(all["beta_lim_error_bounds"]["sticking_by_88"].get<double>() <=
              std::pow(10, -digits) * all["beta_lim"]["sticking_by_88"].get<double>());
    }
}
