#include "denhartog/solve/answer.hpp"

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

Scene<double> sliding(double beta = 0.125) {
    Scene<double> scene = three_masses();
    scene.beta = beta;
    return scene;
}

const char* one_tenth = R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 1], "damping_ratios": ["0.1", "0.2"],
                            "contact": 2, "load": 1, "r": "0.9", "beta": "0.1"})";

} // namespace

TEST_CASE("the error bound of double holds against 100 digits", "[accuracy]") {
    for (const double r : {0.0625, 0.3125, 0.875, 1.125, 4.0}) {
        Scene<double> scene = three_masses(r);
        scene.beta = 0.75 * boundary(sums_of(scene), scene.mu).exact;
        const Response<double> low = std::get<Response<double>>(answer(scene_source(scene)).response);
        const Response<Real100> high = response(scene_source(scene).in_100_digits());
        for (std::size_t k = 0; k < 3; ++k) {
            const MassResponse<double>& m = low.steady_state->masses[k];
            const MassResponse<Real100>& w = high.steady_state->masses[k];
            INFO("r = " << hexadecimal(r) << ", mass " << k + 1 << ", bound " << hexadecimal(m.error_bound));
            CHECK(m.error_bound > 0);
            CHECK(m.error_bound < 1e-12 * m.amplitude);
            CHECK(abs(Real100(m.x0 - w.x0)) <= m.error_bound);
            CHECK(abs(Real100(m.v0 - w.v0)) <= m.error_bound);
            CHECK(abs(Real100(m.amplitude - w.amplitude)) <= m.error_bound);
            CHECK(abs(Real100(m.amplitude_monoharmonic - w.amplitude_monoharmonic)) <= m.error_bound);
        }
    }
}

TEST_CASE("the precision follows from the digits asked for", "[accuracy]") {
    CHECK(answer(scene_source(sliding())).method.precision == "double");
    CHECK(answer(scene_source(sliding()), 12).method.precision == "double");
    CHECK(answer(scene_source(sliding()), 16).method.precision == "50 digits");
    CHECK(answer(scene_source(sliding()), 45).method.precision == "50 digits");
    CHECK(answer(scene_source(sliding()), 46).method.precision == "100 digits");
    CHECK(answer(scene_source(sliding()), 90).digits_reached);
    CHECK_THROWS_AS(answer(scene_source(sliding()), 0), InputError);
    CHECK_THROWS_AS(answer(scene_source(sliding()), 96), InputError);
}

TEST_CASE("the digits of 50 agree with those of 100", "[accuracy]") {
    const Answer fifty = answer(scene_source(sliding()), 45);
    const Answer hundred = answer(scene_source(sliding()), 90);
    const Response<Real50>& low = std::get<Response<Real50>>(fifty.response);
    const Response<Real100>& high = std::get<Response<Real100>>(hundred.response);
    for (std::size_t k = 0; k < 3; ++k) {
        const MassResponse<Real50>& m = low.steady_state->masses[k];
        const MassResponse<Real100>& w = high.steady_state->masses[k];
        CHECK(abs(Real100(Real100(m.amplitude) - w.amplitude)) <= Real100(m.error_bound));
        CHECK(m.error_bound < Real50("1e-45") * m.amplitude);
        CHECK(w.error_bound < Real100("1e-90") * w.amplitude);
        CHECK(abs(Real100(Real100(m.phase) - w.phase)) < Real100("1e-45"));
    }
}

TEST_CASE("a number written as text is read anew in every precision", "[accuracy]") {
    const SceneText part{one_tenth};
    CHECK(scene_source(part).in_100_digits().beta == Real100(1) / 10);
    CHECK(scene_source(part).in_double().beta == 0.1);
    Scene<double> rounded = scene_source(part).in_double();
    CHECK(scene_source(rounded).in_100_digits().beta == Real100(0.1));
    // The difference between one tenth and its double shows in the 17th digit of the answer.
    const Response<Real50> exact = std::get<Response<Real50>>(answer(scene_source(part), 30).response);
    const Response<Real50> near = std::get<Response<Real50>>(answer(scene_source(rounded), 30).response);
    const Real50 difference = abs(Real50(exact.steady_state->X_j / near.steady_state->X_j - 1));
    CHECK(difference > Real50("1e-19"));
    CHECK(difference < Real50("1e-15"));
}

TEST_CASE("where double has not the digits more precision is taken and said so", "[accuracy]") {
    // The double next to 1/3 is in double not told from the pole at R = 1/3 of a mode without damping; in 50 digits it is.
    Scene<double> scene = oscillator(0, 1.0 / 3);
    scene.beta = 0.125;
    const Answer found = answer(scene_source(scene));
    CHECK(found.method.precision != "double");
    CHECK(found.digits_reached);
    CHECK(found.method.why.find("in double: ") == 0);
}

TEST_CASE("a friction ratio on a boundary that is known exactly is no open question", "[regime]") {
    Scene<double> scene = oscillator(0.125, 0.75);
    scene.beta = 1;
    const Answer found = answer(scene_source(scene));
    CHECK(found.method.precision == "double");
    CHECK(std::get<Response<double>>(found.response).regime->regime == Regime::permanent_sticking);
    CHECK_FALSE(std::get<Response<double>>(found.response).regime->on_boundary);
}

TEST_CASE("a friction ratio that differs from the boundary by its rounding is decided in more digits", "[regime]") {
    Scene<double> scene = three_masses();
    scene.beta = boundary(sums_of(scene), scene.mu).exact;
    const Answer found = answer(scene_source(scene));
    CHECK(found.method.precision == "50 digits");
    const Response<Real50>& r = std::get<Response<Real50>>(found.response);
    CHECK_FALSE(r.regime->on_boundary);
    CHECK((r.regime->regime == Regime::continuous) == (*r.beta < r.boundary.exact));
}

TEST_CASE("at a true pole there is an error in every precision", "[domain]") {
    Scene<double> scene = oscillator(0, 1);
    scene.beta = 0.125;
    CHECK_THROWS_AS(answer(scene_source(scene)), DomainError);
    CHECK_THROWS_AS(answer(scene_source(scene), 60), DomainError);
}

TEST_CASE("a mass that nothing moves has no amplitude beyond its error bound", "[accuracy]") {
    // Mass 3 hangs on the ground alone: a system in two parts, given by its matrices.
    Scene<double> scene = three_masses();
    scene.system.stiffness_ratios.clear();
    scene.system.stiffness_matrix.resize(3, 3);
    scene.system.stiffness_matrix << 1.625, -0.625, 0, -0.625, 0.625, 0, 0, 0, 1.875;
    scene.beta = 0.03125;
    const Answer found = answer(scene_source(scene));
    CHECK(found.digits_reached);
    const MassResponse<double>& still = std::get<Response<double>>(found.response).steady_state->masses[2];
    CHECK(still.amplitude <= still.error_bound);
    CHECK(still.error_bound < 1e-14);
}

TEST_CASE("a damping matrix rounded to double is answered in double and refused where more digits are asked for",
          "[eq:18][accuracy]") {
    Scene<double> scene = sliding();
    const NonDimensionalMatrices<double> m = matrices_of(scene);
    scene.system.damping_ratios.clear();
    scene.system.damping_matrix = 0.1 * m.M / (1.125 * 1.125) + 0.03 * m.K;
    const Answer found = answer(scene_source(scene));
    CHECK(found.method.precision == "double");
    CHECK(found.method.why.find("damping ratios that the damping matrix has in double") != std::string::npos);
    CHECK(found.digits_reached);
    CHECK_THROWS_AS(answer(scene_source(scene), 30), InputError);
}
