// Moving bases and contacts of any direction from C: absolute numbers and phases of maps, warnings, the limit (86).
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "denhartog/c/denhartog.h"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "tests/conformance/c_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

const std::string chain =
    R"({"mass_ratios": [1, 2, 1.5], "stiffness_ratios": [1, 0.75, 1.25], "damping_ratios": [0.05, 0.04, 0.06], )";

double limit_of(const std::string& text) {
    double limit = 0;
    REQUIRE(dh_high_frequency_limit(handle_of(text).get(), 1.25, &limit) == DH_OK);
    return limit;
}

} // namespace

TEST_CASE("dh_map has the phases and the absolute numbers of the library", "[c_interface][base][direction]") {
    const std::vector<double> r{0.5, 0.75, 1.5}, beta{0.0625, 0.5, 4};
    for (const auto& [text, ground] : {std::pair<std::string, bool>{R"("contact": 2, "base_motion": "alone"})", true},
                                       {R"("contact": [2, 1], "base_motion": "with_wall"})", true},
                                       {R"("contact": {"direction": [0.5, -1, 0.25]}, "load": [0.25, 1, 0.5]})", false}}) {
        INFO(text);
        const Handle system = handle_of(chain + text);
        dh_map_request request = map_request(r, beta, 1);
        request.threads = 1;
        request.from_ground = ground ? 1 : 0;
        std::vector<double> amplitude(27), phase(27);
        auto result = sized<dh_map_result>();
        result.amplitude_r_step = 9;
        result.amplitude_beta_step = 3;
        result.mass_step = 1;
        result.amplitude = amplitude.data();
        result.phase = phase.data();
        REQUIRE(dh_map(system.get(), &request, &result) == DH_OK);
        const std::atomic<bool> stop{false};
        MapRequest whole{r, beta, {Mass{0}, Mass{1}, Mass{2}}};
        whole.from_ground = ground;
        whole.phases = true;
        const RegimeMap expected = regime_map(read_scene<double>(chain + text), whole, stop);
        check_same(amplitude, expected.amplitudes);
        check_same(phase, expected.phases);
        request.size = offsetof(dh_map_request, from_ground); // as it was
        result.size = offsetof(dh_map_result, phase);
        REQUIRE(dh_map(system.get(), &request, &result) == DH_OK);
        whole.from_ground = whole.phases = false;
        check_same(amplitude, regime_map(read_scene<double>(chain + text), whole, stop).amplitudes);
        result.size = 8;
        CHECK(dh_map(system.get(), &request, &result) == DH_ERROR_SIZE);
    }
    const Handle still = handle_of(chain + R"("contact": 2, "load": 1})");
    dh_map_request request = map_request(r, r, 1);
    request.from_ground = 1;
    auto result = sized<dh_map_result>();
    CHECK(dh_map(still.get(), &request, &result) == DH_ERROR_INPUT);
}

TEST_CASE("the boundary of any load that inertia brings to the contact tends to (86) times its share", "[c_interface][eq:86]") {
    for (const char* text : {R"("contact": 2, "load": 2})", R"("contact": 2, "base_motion": "with_wall"})",
                             R"("contact": [2, 3], "load": [1, -0.5, 2]})", R"("contact": [3, 1], "load": [0, 0, 2]})",
                             R"("contact": {"direction": [0.5, -1, 0.25]}, "load": [0.25, 1, 0.5]})",
                             R"("contact": 1, "base_motion": "alone", "damping_ratios": 0})",
                             R"("contact": 1, "base_motion": "alone", "damping_matrix": [[0.25, -0.25, 0], [-0.25, 0.375, -0.125],
                                [0, -0.125, 0.125]]})", // between masses alone
                             R"("contact": 2, "load": [1, 0.5, 0], "load_phases": [0, 1, 0]})"}) {
        INFO(text);
        const std::string scene =
            std::string(text).find("damping") != std::string::npos
                ? R"({"mass_ratios": [1, 2, 1.5], "stiffness_ratios": [1, 0.75, 1.25], )" + std::string(text)
                : chain + text;
        auto at = sized<dh_boundary>();
        REQUIRE(dh_boundaries(handle_of(scene).get(), 3000, 1.25, &at) == DH_OK);
        CHECK(at.exact == Approx(limit_of(scene)).epsilon(1e-4)); // at r = 3000 what falls with 1/r is left
    }
    CHECK(limit_of(chain + R"("contact": 2, "base_motion": "with_wall"})") ==
          Approx(2 * limit_of(chain + R"("contact": 2, "load": 2})")).epsilon(1e-12)); // gamma_2
    double limit = -1;
    for (const auto& [text, part] : {std::pair{R"("contact": 2, "base_motion": "alone"})", "one load at all frequencies"},
                                     {R"("contact": 2, "base_motion": "wall"})", "one load at all frequencies"},
                                     {R"("contact": 2, "load": 1})", "j = l"},
                                     {R"("contact": [2, 3], "load": 1})", "j = l"}}) {
        INFO(text);
        CHECK(dh_high_frequency_limit(handle_of(chain + text).get(), 1, &limit) == DH_ERROR_DOMAIN);
        CHECK(std::string(dh_last_message()).find(part) != std::string::npos);
    }
    CHECK(limit == -1);
}

TEST_CASE("a contact of any direction from C is w^T x, and stands for the mass with the largest entry",
          "[c_interface][direction]") {
    const Handle system = handle_of(chain + R"("contact": {"direction": [0.5, -1, 0.25]}, "load": 1})");
    size_t N = 0, contact = 0;
    CHECK(dh_system_masses(system.get(), &N, &contact, nullptr) == DH_OK);
    CHECK(contact == 2);
    const Answered solution = solved(system.get(), 0.75, 0.5, 1);
    std::vector<double> x(3 * 512);
    REQUIRE(dh_solution_motion(solution.get(), 512, x.size(), x.data(), nullptr) == DH_OK);
    double largest = 0;
    for (std::size_t n = 0; n < 512; ++n)
        largest = std::max(largest, std::abs(0.5 * x[3 * n] - x[3 * n + 1] + 0.25 * x[3 * n + 2]));
    const dh_mass of = contact_of(solution.get());
    CHECK(of.amplitude == Approx(largest).epsilon(1e-4)); // a sample is half a step of 2 pi / 512 off at most: 1.9e-5
    std::vector<double> psi(9), V(6), U(3), G(3), products(3);
    REQUIRE(dh_mode_shapes(system.get(), 0.75, 9, psi.data()) == DH_OK);
    REQUIRE(dh_sums(system.get(), 0.75, 3, V.data(), U.data(), G.data(), nullptr, nullptr) == DH_OK);
    std::vector<double> R(3), v(6), u(3), g(3);
    REQUIRE(dh_modal_functions(system.get(), 0.75, 3, R.data(), v.data(), u.data(), g.data()) == DH_OK);
    for (std::size_t k = 0; k < 3; ++k) { // (34), (35) with w^T psi_i
        std::size_t count = 0;
        REQUIRE(dh_quantity(system.get(), "mode_shape_products", 0.75, 0.5, 1, k + 1, 0, 3, products.data(), &count) == DH_OK);
        double of_U = 0, of_G = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double w_psi = 0.5 * psi[i] - psi[3 + i] + 0.25 * psi[6 + i];
            of_U += psi[3 * k + i] * w_psi * R[i] * R[i] * u[i];
            of_G += psi[3 * k + i] * w_psi * R[i] * R[i] * g[i];
            CHECK(products[i] == Approx(psi[3 * k + i] * w_psi).margin(1e-12));
        }
        CHECK(U[k] == Approx(of_U).epsilon(1e-9));
        CHECK(G[k] == Approx(of_G).epsilon(1e-9));
    }
}

TEST_CASE("dh_solution_warning says what an answer depends on too much", "[c_interface]") {
    const Handle undamped =
        handle_of(R"({"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0, "contact": 1, "load": 1})");
    const Answered solution = solved(undamped.get(), 1 - 0x1p-45, 0.125, 1);
    char text[512] = "";
    REQUIRE(dh_solution_warning(solution.get(), sizeof text, text) == DH_OK);
    CHECK(std::string(text).find("a unit in the last place of the frequency") == 0);
    CHECK(dh_solution_warning(solution.get(), 10, text) == DH_ERROR_SIZE);
    CHECK(std::string(text).size() > 10);
}
