// Systems that the reference prepares for the exact solver in double.
#include <cmath>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

SceneSource source_of(const std::string& json) { return scene_source(SceneText{json, 1, true}); }

/// Checks that two matrices agree beside the largest entry.
void same(const char* name, const Matrix<double>& one, const Matrix<double>& other) {
    INFO(name);
    REQUIRE(one.rows() == other.rows());
    REQUIRE(one.cols() == other.cols());
    if (one.size() > 0) CHECK((one - other).cwiseAbs().maxCoeff() <= 1e-12 * one.cwiseAbs().maxCoeff());
}

Matrix<double> column(const std::vector<double>& x) {
    return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

Matrix<double> real_parts(const std::vector<Complex<double>>& x) {
    std::vector<double> parts;
    for (const Complex<double>& each : x) parts.push_back(each.re);
    return column(parts);
}

} // namespace

TEST_CASE("a system prepared by the reference is that of double, where double has its digits", "[eq:15][eq:19][stuck]") {
    for (const char* json :
         {R"({"mass_ratios":[1,2,0.5],"stiffness_ratios":[1,3,1],"damping_ratios":[0.1,0.02,0.3],"contact":2,"load":3})",
          R"({"mass_ratios":[1,2,0.5],"stiffness_ratios":[1,3,1],"damping_matrix":[[0.3,-0.1,0],[-0.1,0.2,-0.05],[0,-0.05,0.1]],
                 "contact":[3,1],"load":[1,0.5,0.25]})",
          R"({"mass_ratios":[1,2],"stiffness_ratios":[1,3],"damping_ratios":[0,0],"contact":[1,2],"load":1})",
          R"({"mass_ratios":[1],"stiffness_ratios":[1],"damping_ratios":[0.1],"contact":1,"load":1})"}) {
        INFO(json);
        const SceneSource source = source_of(json);
        const ContactSystem one = contact_system(source->in_double().system);
        const ContactSystem other = moving_by_reference(source, "a test").required();
        CHECK(in_words(other.rounded_because) == "a test");
        same("r_n", column(one.basis.r_n), column(other.basis.r_n));
        same("phi", one.basis.phi, other.basis.phi);
        same("zeta", column(one.basis.zeta), column(other.basis.zeta));
        same("D", one.basis.D, other.basis.D);
        same("momentum", one.momentum, other.momentum);
        same("load", real_parts(one.modal_load), real_parts(other.modal_load));
        same("contact", one.contact_shape, other.contact_shape);
        same("damping matrix", one.stuck.C, other.stuck.C);
        same("r_n held", column(one.stuck.r_n), column(other.stuck.r_n));
        same("phi held", one.stuck.phi.cwiseAbs(), other.stuck.phi.cwiseAbs());
        same("damping held", one.stuck.damping.cwiseAbs(), other.stuck.damping.cwiseAbs());
        CHECK(one.stuck.k_contact == Approx(other.stuck.k_contact).epsilon(1e-12));
        for (const double part : other.detuned) CHECK(part <= 1e-15);
    }
}

TEST_CASE("two masses in contact that a spring ties too stiffly for double are refused", "[eq:6]") {
    const auto cycles = [](const std::string& stiffness) {
        PaperSettings settings;
        settings.cycles = 20;
        return exact_cycles(
            source_of(R"({"contact": [2, 1], "mass_ratios": [1, 1, 2], "damping_ratios": 0.08894, "load": 3, "r": 0.5,
                                          "beta": 0.3, "stiffness_ratios": [1, )" +
                      stiffness + ", 4.979]}"),
            settings);
    };
    CHECK(cycles("1e9").stops.size() == 2);
    CHECK_THROWS_WITH(cycles("1e10"), Catch::Contains("tied so stiffly"));
}

TEST_CASE("beside a stiff spring the exact cycles end in the steady motion, for a contact between two masses too", "[eq:6]") {
    const SceneSource source = source_of(
        R"({"mass_ratios":[1,2,3],"stiffness_matrix":[[2,-1,0],[-1,1.0000000000001e13,-1e13],[0,-1e13,1e13]],
            "damping_ratios":[0.3,0.3,0.3],"contact":[2,1],"load":1,"mu":1,"beta":0.05,"r":0.8})");
    PaperSettings settings;
    settings.cycles = 60;
    const PaperMotion cycles = exact_cycles(source, settings);
    REQUIRE(cycles.status == IntegrationStatus::complete);
    const Solution steady = solve(source, {});
    for (std::size_t k = 0; k < 3; ++k)
        CHECK(cycles.masses[k].amplitude == Approx(steady.masses[k].amplitude.value).epsilon(1e-9));
}
