// (88) on systems with damping, beside the boundary that the equations of motion give without modes.
#include <Eigen/Dense>
#include <cmath>

#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

struct Case {
    std::size_t N, j, l;
    double zeta, r, printed_over_exact; ///< the last: to two digits
};

Scene<double> scene_of(const Case& c) {
    const std::vector<double> ones(c.N, 1.0);
    return chain(ones, ones, std::vector<double>(c.N, c.zeta), c.j, c.l, 1, c.r);
}

/// The amplitude of the force that holds the contact: the constraint's reaction in the full complex system.
double reaction(const Scene<double>& scene) {
    const NonDimensionalMatrices m = matrices_of(scene);
    const auto N = m.M.rows(), j = static_cast<Eigen::Index>(scene.system.contact.index);
    const std::complex<double> i(0, 1);
    Eigen::MatrixXcd A = Eigen::MatrixXcd::Zero(N + 1, N + 1);
    A.topLeftCorner(N, N) = m.K.cast<std::complex<double>>() - m.M + i * m.C;
    A(j, N) = A(N, j) = 1; // the unknown reaction, and x_j = 0
    const Eigen::VectorXcd load = Eigen::VectorXcd::Unit(N + 1, static_cast<Eigen::Index>(scene.system.load.index));
    return std::abs(A.fullPivLu().solve(load)(N));
}

} // namespace

TEST_CASE("the boundary of permanent sticking is the force that holds the contact; (88) as printed is not, once damping couples "
          "the masses",
          "[eq:88][erratum]") {
    for (const Case& c :
         {Case{5, 3, 1, 0.1, 0.62, 0.88}, {5, 3, 1, 0.01, 0.62, 0.90}, {5, 5, 1, 0.1, 2.77, 3.8}, {2, 2, 1, 0.1, 3, 0.97}}) {
        const Scene<double> scene = scene_of(c);
        const StickingBoundary b = sticking_limits(scene);
        CAPTURE(c.N, c.j, c.l, c.zeta, c.r);
        CHECK(b.exact == Approx(reaction(scene)).epsilon(1e-11));
        CHECK(*b.paper / b.exact == Approx(c.printed_over_exact).epsilon(0.01));
    }
}

TEST_CASE("at a resonance of the masses beyond the contact (88) stays wrong however small the damping", "[eq:88][erratum]") {
    for (const double zeta : {1e-2, 1e-4, 1e-6}) {
        const Scene<double> scene = scene_of({5, 3, 5, zeta, 1, 0});
        const StickingBoundary b = sticking_limits(scene);
        CHECK(b.exact == Approx(reaction(scene)).epsilon(1e-8));
        CHECK(*b.paper / b.exact < 0.92);
    }
}

TEST_CASE("where the damping matrix has no entry between the contact and the others (88) holds", "[eq:88][erratum]") {
    Scene<double> scene = scene_of({5, 3, 1, 0.1, 0.62, 1});
    const ModalBasis<double> basis = modal_basis(scene.system);
    for (std::size_t i = 0; i < 5; ++i) scene.system.damping_ratios[i] = 0.05 / basis.r_n[i];
    const StickingBoundary b = sticking_limits(scene);
    CHECK(*b.paper == Approx(b.exact).epsilon(1e-13));
    CHECK(b.exact == Approx(reaction(scene)).epsilon(1e-12));
}
