// A coupling of modes that double does not tell from rounding counts, or is within the bounds of what it makes.

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/friction_motion.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/rotations.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;
using namespace denhartog::tests;

TEST_CASE("a coupling below rounding is in the bound of a second damping function next to a pole", "[modes][damping][eq:35]") {
    // An undamped mode next to an eleventh of its frequency beside damped ones: their coupling of 1e-24 makes 1.5e-16 of G_1.
    const char* text = R"({"mass_ratios": [1, 1.706606325004763, 0.4032277098542443],
        "stiffness_ratios": [1, 8.881784197001252e-16, 1], "damping_matrix": [[0, 0, 0],
        [0, 1.2648251221268454e-08, -1.2648251221268454e-08], [0, -1.2648251221268454e-08, 1.2648251221268454e-08]],
        "contact": 2, "load": 1, "r": 0.09090909094014846, "beta": 0.025})";
    const Scene<double> scene = read_scene<double>(text);
    const Quantities<Bounded<double>> narrow = quantities(scene_source(scene), {}, 6, PointNumbers::sums).numbers;
    const QuantitiesAnswer by_reference = quantities(scene_source(SceneText{text}), {}, 15, PointNumbers::sums);
    CHECK(by_reference.method.precision == "reference");
    const Quantities<Bounded<double>>& truth = by_reference.numbers;
    CHECK(truth.G[0].x < -1e-16);
    CHECK(std::abs(truth.G[0].x / narrow.G[0].x - 1) < 1e-6);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(truth.G[k].x - narrow.G[k].x) <= narrow.G[k].e + truth.G[k].e);
        CHECK(std::abs(truth.U[k].x - narrow.U[k].x) <= narrow.U[k].e + truth.U[k].e);
    }
}

TEST_CASE("what is left out of the damping of stuck modes is in the error of the damping matrix",
          "[modes][damping][exact-solver]") {
    // Damping in proportion to the masses, but for the last digits of its ratios: these alone couple the stuck modes.
    for (const std::size_t contact : {0, 1, 2, 3}) {
        System<double> s;
        s.mass_ratios = {1, 1.5, 0.7, 2.1};
        s.stiffness_ratios = {1, 0.8, 1.9, 0.6};
        s.damping_ratios = {0.1, 0.1, 0.1, 0.1};
        s.contact = Mass{contact};
        s.load = Mass{0};
        const std::vector<double> r_n = modal_basis(s).r_n;
        for (std::size_t i = 0; i < r_n.size(); ++i) s.damping_ratios[i] = 0.3 / r_n[i];
        const ContactSystem c = contact_system(s);
        REQUIRE(c.stuck.modes_diagonalise_damping);
        const Matrix<Real50> M = mass_of<Real50>(s), K = stiffness_of<Real50>(s), C = damping_of<Real50>(s, M, K);
        std::vector<Eigen::Index> others;
        for (const Mass& each : c.stuck.masses) others.push_back(static_cast<Eigen::Index>(each.index));
        const Matrix<Real50> M_held = M(others, others), K_held = K(others, others), C_held = C(others, others),
                             phi = modes_by_rotations(M, K).phi, phi_held = modes_by_rotations(M_held, K_held).phi;
        Matrix<Real50> left_out = phi_held.transpose() * C_held * phi_held;
        left_out.diagonal().setZero();
        const Matrix<Real50> shares = phi_held.transpose() * M_held * phi(others, Eigen::all),
                             in_modes = shares.transpose() * left_out * shares;
        INFO("contact " << contact << ", " << static_cast<double>(in_modes.cwiseAbs().maxCoeff()));
        REQUIRE(in_modes.cwiseAbs().maxCoeff() > 1e-20);
        REQUIRE(c.damping_error.rows() == 4);
        for (Eigen::Index i = 0; i < 4; ++i)
            for (Eigen::Index k = 0; k < 4; ++k) CHECK(abs(in_modes(i, k)) <= c.damping_error(i, k));
        CHECK(c.damping_error.maxCoeff() < 1e-12);
    }
}
