#include <cmath>

#include "denhartog/answer/modes_in_double.hpp"
#include "tests/catch.hpp"
#include "tests/support/closed_form.hpp"
#include "tests/support/named_scenes.hpp"
#include "tests/support/rotations.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Two masses and two springs, all equal, with a damping matrix.
template <class T>
System<T> pair_with(const Matrix<T>& C) {
    System<T> s;
    s.mass_ratios = {T(1), T(1)};
    s.stiffness_ratios = {T(1), T(1)};
    s.damping_matrix = C;
    return s;
}

} // namespace

TEST_CASE("damping that is a combination of mass and stiffness has the known damping ratios", "[model][eq:18]") {
    const auto with = [](auto number) {
        using T = decltype(number);
        System<T> s = chain_of<T>({1, 2.5, 0.75}, {1, 0.625, 1.875});
        s.damping_ratios.clear();
        const T a = T(1) / 8;
        const T b = T(1) / 16;
        s.damping_matrix = b * matrix_of_chain(s.stiffness_ratios);
        for (int i = 0; i < 3; ++i) s.damping_matrix(i, i) += a * s.mass_ratios[static_cast<std::size_t>(i)];
        const ModalBasis<T> basis = modal_basis(s);
        using std::abs;
        for (std::size_t i = 0; i < 3; ++i) {
            const T expected = (a / basis.r_n[i] + b * basis.r_n[i]) / 2;
            REQUIRE(abs(T(basis.zeta[i] - expected)) < 64 * std::numeric_limits<T>::epsilon());
        }
    };
    with(0.0);
    with(Real50());
    with(Real100());
}

TEST_CASE("damping that couples the modes is known by its distance from the condition", "[model][eq:18][coupled-damping]") {
    // One dashpot between mass 1 and the ground. A = [2 -1; -1 1], C = [c 0; 0 0]: AC - CA = c [0 1; -1 0], of size c sqrt 2
    // beside sqrt 7 times c.
    const System<double> s = pair_with<double>(Matrix<double>{{0.1, 0}, {0, 0}});
    const ModalBasis<double> basis = modal_basis(s);
    CHECK(basis.distance_from_classical == Approx(std::sqrt(2.0 / 7.0)).epsilon(1e-12));
    CHECK(basis.coupled());
    CHECK((basis.D - basis.phi.transpose() * s.damping_matrix * basis.phi).norm() < 1e-15);
    for (Eigen::Index i = 0; i < 2; ++i) {
        const auto mode = static_cast<std::size_t>(i);
        CHECK(basis.zeta[mode] == Approx(basis.D(i, i) / (2 * basis.r_n[mode])).epsilon(1e-14));
    }
    CHECK_FALSE(every_motion_is_damped(basis)); // not of every velocity
    CHECK(every_motion_is_damped(modal_basis(pair_with<double>(Matrix<double>{{0.1, 0}, {0, 0.2}}))));
}

TEST_CASE("a tolerance takes in what it says and no more", "[model][eq:18][coupled-damping]") {
    System<double> s = pair_with<double>(Matrix<double>{{0.1, 0}, {0, 0}});
    s.damping_tolerance = 0.53;
    CHECK(modal_basis(s).coupled());
    s.damping_tolerance = 0.54;
    CHECK_FALSE(modal_basis(s).coupled());
}

TEST_CASE("a departure far below the damping itself still couples the modes", "[model][eq:18][coupled-damping]") {
    Matrix<double> C{{0.2, -0.1}, {-0.1, 0.1}};
    CHECK_FALSE(modal_basis(pair_with(C)).couples);
    C(0, 0) += 1e-12;
    CHECK(modal_basis(pair_with(C)).couples);
    const double distance = modal_basis(pair_with(C)).distance_from_classical;
    CHECK(distance < 1e-11);
    CHECK(distance > 1e-13);
}

TEST_CASE("two soft modes are coupled of which the distance has no trace beside a stiff mode that is damped", "[model][eq:18]") {
    // Mass 4 is light; of the soft modes one dashpot to the ground, at mass 3, couples two.
    System<double> s;
    s.mass_ratios = {1, 1e10, 1e9, 1e-6};
    s.stiffness_ratios = {1, 1, 1, 1};
    s.damping_matrix = Matrix<double>::Zero(4, 4);
    s.damping_matrix(2, 2) = 1000 + 4000;
    s.damping_matrix(2, 3) = s.damping_matrix(3, 2) = -4000;
    s.damping_matrix(3, 3) = 4000;
    const ModalBasis<double> basis = modal_basis(s);
    CHECK(basis.distance_from_classical < 1e-15);
    CHECK(basis.couples);
}

TEST_CASE("damping in proportion to stiff and soft springs couples no modes, however far they are apart", "[model][eq:18]") {
    for (const double soft : {1e-4, 1e-8, 1e-12, 1e-15}) {
        System<double> s = chain_of({1, 0.3, 1e-6, 7}, {1, soft, 0.7, 3 * soft});
        s.damping_ratios.clear();
        s.damping_matrix = matrix_of_chain<double>({0.37, 0.37 * soft, 0.37 * 0.7, 0.37 * (3 * soft)});
        for (int i = 0; i < 4; ++i) s.damping_matrix(i, i) += 0.11 * s.mass_ratios[static_cast<std::size_t>(i)];
        INFO(soft);
        CHECK_FALSE(modal_basis(s).couples);
    }
}

TEST_CASE("decimal fractions satisfy the condition in fifty digits where they were not rounded to doubles", "[model][eq:18]") {
    const Real50 tenth = Real50(1) / 10;
    const auto coupled = [](const auto& s) { return modal_basis(s).couples; };
    CHECK_FALSE(coupled(pair_with<Real50>(Matrix<Real50>{{3 * tenth, -tenth}, {-tenth, 2 * tenth}})));
    CHECK(coupled(pair_with<Real50>(Matrix<Real50>{{Real50(0.3), Real50(-0.1)}, {Real50(-0.1), Real50(0.2)}})));
    CHECK_FALSE(coupled(pair_with<double>(Matrix<double>{{0.3, -0.1}, {-0.1, 0.2}})));
}

TEST_CASE("coinciding natural frequencies get the mode shapes that diagonalise the damping", "[model][topology][eq:18]") {
    // A ring of six equal masses on equal ground springs: modes 2 and 3, 4 and 5 are cosine and sine of one order each.
    const std::size_t N = 6;
    System<double> s = tests::named_scene("ring of six").system;
    s.damping_ratios.clear();
    const double zeta[] = {0.0625, 0.125, 0.5, 0.25, 0.03125, 0.75};
    s.damping_matrix = Matrix<double>::Zero(6, 6);
    for (int mode = 0; mode < 6; ++mode) {
        const int order = (mode + 1) / 2;
        const bool sine = mode > 0 && mode < 5 && mode % 2 == 0;
        Matrix<double> shape(6, 1);
        for (int k = 0; k < 6; ++k) {
            const double angle = pi<double>() * order * k / 3 + 0.3;
            shape(k, 0) = mode == 0 || mode == 5 ? std::cos(pi<double>() * order * k / 3)
                          : sine                 ? std::sin(angle)
                                                 : std::cos(angle);
        }
        shape /= shape.norm();
        const double r_n = std::sqrt(2.5 - 2 * std::cos(pi<double>() * order / 3));
        s.damping_matrix += 2 * zeta[mode] * r_n * shape * shape.transpose();
    }
    s.damping_matrix = Matrix<double>((s.damping_matrix + s.damping_matrix.transpose()) / 2);
    const ModalBasis<double> basis = modal_basis(s);
    const double expected[] = {0.0625, 0.125, 0.5, 0.03125, 0.25, 0.75};
    for (std::size_t i = 0; i < N; ++i) REQUIRE(std::abs(basis.zeta[i] - expected[i]) < 64 * eps);
    const Matrix<double> D = basis.phi.transpose() * s.damping_matrix * basis.phi;
    const Matrix<double> A = basis.phi.transpose() * s.stiffness_matrix * basis.phi;
    for (Eigen::Index i = 0; i < 6; ++i)
        for (Eigen::Index k = 0; k < i; ++k) {
            REQUIRE(std::abs(D(i, k)) < 64 * eps);
            REQUIRE(std::abs(A(i, k)) < 64 * eps);
        }
}

TEST_CASE("where double does not tell whether near modes are coupled the reference does", "[model][eq:18]") {
    Scene<double> scene;
    System<double>& s = scene.system;
    s.mass_ratios = {1, 1};
    s.stiffness_matrix = Matrix<double>{{1, 0}, {0, 1 + 0x1p-40}};
    s.damping_matrix = Matrix<double>{{0.125, 0x1p-12}, {0x1p-12, 0.25}};
    CHECK(modal_basis(s).coupled()); // the matrix counts, whatever it does to the modes
    CHECK_FALSE(modal_basis(s).couples);
    const std::optional<CoupledDamping> damping = coupled_damping(scene_source(scene));
    REQUIRE(damping);
    const double commutator = std::sqrt(2.0) * 0x1p-12 * 0x1p-40, of_K = std::sqrt(2.0), of_C = std::sqrt(5.0 / 64 + 0x1p-23);
    CHECK(damping->distance_from_classical == Approx(commutator / (of_K * of_C)).epsilon(1e-11));
    s.damping_matrix = Matrix<double>{{0.125, 0x1p-11}, {0x1p-11, 0.125}}; // whatever turns these modes leaves the coupling
    CHECK(modal_basis(s).couples);
}

TEST_CASE("a mode without damping does not make the coupling of the others endless", "[model][eq:18]") {
    Scene<double> scene;
    scene.system.mass_ratios = {1, 1, 1};
    scene.system.stiffness_matrix = Matrix<double>{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
    for (const double scale : {1.0, 1e-8, 1e8}) { // the coupling is a ratio
        INFO(scale);
        scene.system.damping_matrix = scale * Matrix<double>{{0.1, 0.05, 1e-20}, {0.05, 0.1, 0}, {1e-20, 0, 0}};
        const std::optional<CoupledDamping> damping = coupled_damping(scene_source(scene));
        REQUIRE(damping);
        CHECK(damping->taken_in);
        CHECK(damping->largest_coupling == Approx(0.5).epsilon(1e-15));
        CHECK(damping->damping_ratios.size() == 3);
    }
}

TEST_CASE("light masses do not hide that a damping matrix couples the others", "[model]") {
    System<double> s;
    s.mass_ratios = {1, 2, 1e-8};
    s.stiffness_matrix = Matrix<double>{{2, -1, 0}, {-1, 1001, -1000}, {0, -1000, 1000}};
    s.damping_matrix = Matrix<double>{{1e-3, 0, 0}, {0, 1e-5, -1e-5}, {0, -1e-5, 1e-5}};
    const ModalBasis<double> basis = modal_basis(s);
    REQUIRE(basis.couples);
    CHECK(basis.distance_from_classical < 1e-14); // as norms have it, which are those of the light mass
}

TEST_CASE("damping ratios from a matrix must be in their range, by the name of the mode", "[model][bad-input][eq:18]") {
    REQUIRE_THROWS_AS(modal_basis(pair_with<double>(Matrix<double>{{2e301, 0}, {0, 2e301}})), InputError);
    REQUIRE_THROWS_WITH(modal_basis(pair_with<double>(Matrix<double>{{2e301, 0}, {0, 2e301}})),
                        Catch::StartsWith("damping_matrix") && Catch::Contains("mode 1") && Catch::Contains("at most 1e300"));
    REQUIRE_THROWS_WITH(modal_basis(pair_with<double>(Matrix<double>{{-0.5, 0}, {0, -0.5}})),
                        Catch::Contains("no negative eigenvalue"));
}

TEST_CASE("a damping matrix may make modes critically damped and overdamped", "[model][eq:18][overdamped]") {
    const System<double> s = pair_with<double>(Matrix<double>{{2, 0}, {0, 2}});
    const ModalBasis<double> basis = modal_basis(s);
    for (std::size_t i = 0; i < 2; ++i) REQUIRE(std::abs(basis.zeta[i] * basis.r_n[i] - 1) < 8 * eps);
    REQUIRE(basis.zeta[0] > 1);
}

TEST_CASE("a damping matrix of zeros is a system without damping", "[model][eq:18]") {
    const ModalBasis<double> basis = modal_basis(pair_with<double>(Matrix<double>::Zero(2, 2)));
    REQUIRE(basis.zeta == std::vector<double>{0, 0});
}
