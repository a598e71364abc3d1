#include "denhartog/scene/scene.hpp"

#include <functional>
#include <limits>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;

namespace {

template <class T>
Scene<T> good() {
    Scene<T> scene;
    scene.system.mass_ratios = {T(1), T(5) / 2, T(3) / 4};
    scene.system.stiffness_ratios = {T(1), T(5) / 8, T(15) / 8};
    scene.system.damping_ratios = {T(1) / 32, T(0), T(1) / 8};
    scene.system.contact.index = 1;
    scene.system.load.index = 0;
    scene.mu = T(11) / 8;
    scene.r = T(9) / 8;
    scene.beta = T(5) / 32;
    return scene;
}

/// The good scene with matrices in place of ratios.
Scene<double> by_matrices() {
    Scene<double> scene = good<double>();
    System<double>& s = scene.system;
    s.mass_ratios.clear();
    s.stiffness_ratios.clear();
    s.damping_ratios.clear();
    s.mass_matrix = Matrix<double>{{1, 0.5, 0}, {0.5, 2.5, 0}, {0, 0, 0.75}};
    s.stiffness_matrix = Matrix<double>{{2, -1, 0}, {-1, 2, -1}, {0, -1, 1}};
    s.damping_matrix = Matrix<double>::Zero(3, 3);
    return scene;
}

template <class T>
InputError refusal(const Scene<T>& scene) {
    try {
        check(scene);
    } catch (const InputError& fault) {
        return fault;
    }
    FAIL("no error");
    return InputError("", "", "");
}

/// The error after one change to a good scene.
InputError after(const std::function<void(Scene<double>&)>& change, Scene<double> scene = good<double>()) {
    change(scene);
    const InputError fault = refusal(scene);
    REQUIRE(fault.place.empty());
    return fault;
}

bool says(const InputError& fault, const std::string& quantity, const std::string& rule, const std::string& value) {
    INFO(fault.what());
    CHECK(fault.quantity == quantity);
    CHECK(fault.rule.find(rule) != std::string::npos);
    CHECK(fault.value == value);
    return fault.quantity == quantity && fault.rule.find(rule) != std::string::npos && fault.value == value;
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("a scene that keeps every rule is accepted in every number type", "[scene]") {
    REQUIRE_NOTHROW(check(good<double>()));
    REQUIRE_NOTHROW(check(good<Real50>()));
    REQUIRE_NOTHROW(check(good<Real100>()));
    REQUIRE_NOTHROW(check(by_matrices()));
    Scene<double> edge = good<double>();
    edge.mu = 1;
    edge.beta = 0;
    edge.system.damping_ratios = {0, 0, 0};
    edge.r.reset();
    REQUIRE_NOTHROW(check(edge));
}

TEST_CASE("a scene has masses, springs and damping, each given once", "[scene][bad-input]") {
    REQUIRE(refusal(Scene<double>{}).quantity == "mass_ratios");
    REQUIRE(after([](auto& s) { s.system.stiffness_ratios.clear(); }).quantity == "stiffness_ratios");
    REQUIRE(after([](auto& s) { s.system.damping_ratios.clear(); }).quantity == "damping_ratios");
    REQUIRE(says(after([](auto& s) { s.system.mass_matrix = Matrix<double>::Identity(3, 3); }), "mass_matrix",
                 "must not be given together with mass_ratios", ""));
    REQUIRE(says(after([](auto& s) { s.system.damping_matrix = Matrix<double>::Identity(3, 3); }), "damping_matrix",
                 "must not be given together with damping_ratios", ""));
}

TEST_CASE("mass ratios are positive, finite and in units of the first", "[scene][bad-input]") {
    REQUIRE(says(after([](auto& s) { s.system.mass_ratios[1] = -2; }), "mass_ratios", "of mass 2 must be positive", "-2"));
    REQUIRE(says(after([](auto& s) { s.system.mass_ratios[2] = 0; }), "mass_ratios", "of mass 3 must be positive", "0"));
    REQUIRE(
        says(after([](auto& s) { s.system.mass_ratios[2] = not_a_number; }), "mass_ratios", "of mass 3 must be finite", "nan"));
    REQUIRE(says(after([](auto& s) { s.system.mass_ratios[2] = infinity; }), "mass_ratios", "of mass 3 must be finite", "inf"));
    REQUIRE(says(after([](auto& s) { s.system.mass_ratios[0] = 2; }), "mass_ratios", "of mass 1 must be 1", "2"));
}

TEST_CASE("stiffness ratios are positive, finite, in units of the first and as many as the masses", "[scene][bad-input]") {
    REQUIRE(
        says(after([](auto& s) { s.system.stiffness_ratios[1] = 0; }), "stiffness_ratios", "of spring 2 must be positive", "0"));
    REQUIRE(says(after([](auto& s) { s.system.stiffness_ratios[1] = not_a_number; }), "stiffness_ratios",
                 "of spring 2 must be finite", "nan"));
    REQUIRE(says(after([](auto& s) { s.system.stiffness_ratios[0] = 0.5; }), "stiffness_ratios", "of spring 1 must be 1", "0.5"));
    REQUIRE(says(after([](auto& s) { s.system.stiffness_ratios.pop_back(); }), "stiffness_ratios", "as many values", "2"));
}

TEST_CASE("damping ratios are at least 0, and may be 1 and more", "[scene][bad-input]") {
    REQUIRE(says(after([](auto& s) { s.system.damping_ratios[2] = -0.125; }), "damping_ratios", "of mode 3 must not be negative",
                 "-0.125"));
    REQUIRE(says(after([](auto& s) { s.system.damping_ratios[2] = not_a_number; }), "damping_ratios", "of mode 3 must be finite",
                 "nan"));
    REQUIRE(says(after([](auto& s) { s.system.damping_ratios[0] = 1e301; }), "damping_ratios", "of mode 1 must be at most 1e300",
                 "1e+301"));
    REQUIRE(
        says(after([](auto& s) { s.system.damping_ratios[0] = infinity; }), "damping_ratios", "of mode 1 must be finite", "inf"));
    for (const double zeta : {1.0, 1.5, 1e300}) {
        Scene<double> scene = good<double>();
        scene.system.damping_ratios[1] = zeta;
        REQUIRE_NOTHROW(check(scene));
    }
    REQUIRE(says(after([](auto& s) { s.system.damping_ratios.push_back(0); }), "damping_ratios", "as many values", "4"));
}

TEST_CASE("contact and load are masses of the system and count from 1 in messages", "[scene][bad-input]") {
    REQUIRE(says(after([](auto& s) { s.system.contact.index = 3; }), "contact", "from 1 to 3", "4"));
    REQUIRE(says(after([](auto& s) { s.system.load.index = 7; }), "load", "from 1 to 3", "8"));
}

TEST_CASE("mu is at least 1, beta at least 0, r positive", "[scene][bad-input]") {
    REQUIRE(says(after([](auto& s) { s.mu = 0.5; }), "mu", "at least 1", "0.5"));
    REQUIRE(says(after([](auto& s) { s.mu = not_a_number; }), "mu", "finite", "nan"));
    REQUIRE(says(after([](auto& s) { s.beta = -0.25; }), "beta", "not be negative", "-0.25"));
    REQUIRE(says(after([](auto& s) { s.beta = infinity; }), "beta", "finite", "inf"));
    REQUIRE(says(after([](auto& s) { s.r = 0; }), "r", "positive", "0"));
    REQUIRE(says(after([](auto& s) { s.r = -1; }), "r", "positive", "-1"));
    REQUIRE(says(after([](auto& s) { s.r = not_a_number; }), "r", "finite", "nan"));
}

TEST_CASE("matrices are square, finite and symmetric to the last bit", "[scene][bad-input]") {
    const auto change = [](auto edit) { return after(edit, by_matrices()); };
    REQUIRE(says(change([](auto& s) {
                     s.system.stiffness_matrix.resize(3, 2);
                     s.system.stiffness_matrix.setOnes();
                 }),
                 "stiffness_matrix", "must have 3 rows and columns", "3 by 2"));
    REQUIRE(says(change([](auto& s) { s.system.damping_matrix = Matrix<double>::Zero(2, 2); }), "damping_matrix",
                 "must have 3 rows and columns", "2 by 2"));
    REQUIRE(says(change([](auto& s) { s.system.mass_matrix(2, 0) = not_a_number; }), "mass_matrix",
                 "in row 3, column 1 must be finite", "nan"));
    REQUIRE(says(change([](auto& s) { s.system.stiffness_matrix(2, 1) = -1.5; }), "stiffness_matrix",
                 "symmetric: in row 3, column 2 must be -1 as in row 2, column 3", "-1.5"));
    REQUIRE(says(change([](auto& s) { s.system.damping_matrix(0, 1) = 0x1p-1000; }), "damping_matrix", "symmetric", "0"));
}

TEST_CASE("mass and stiffness matrices are positive definite", "[scene][bad-input]") {
    const auto change = [](auto edit) { return after(edit, by_matrices()); };
    REQUIRE(says(change([](auto& s) { s.system.mass_matrix(1, 1) = 0.125; }), "mass_matrix", "positive definite",
                 "not: its leading minor of order 2 is negative"));
    REQUIRE(says(change([](auto& s) { s.system.mass_matrix(2, 2) = 0; }), "mass_matrix", "positive definite",
                 "singular: its leading minor of order 3 is zero to working precision"));
    REQUIRE(says(change([](auto& s) { s.system.stiffness_matrix(0, 0) = 1; }), "stiffness_matrix", "positive definite",
                 "singular: its leading minor of order 3 is zero to working precision"));
    REQUIRE(says(change([](auto& s) { s.system.stiffness_matrix(0, 0) = -1; }), "stiffness_matrix", "positive definite",
                 "not: its leading minor of order 1 is negative"));
}

TEST_CASE("a matrix that is singular only to fifteen digits is accepted in fifty", "[scene]") {
    Scene<double> scene = by_matrices();
    scene.system.stiffness_matrix = Matrix<double>{{1 + 0x1p-52, -1, 0}, {-1, 1, 0}, {0, 0, 1}};
    REQUIRE(refusal(scene).value.find("singular") == 0);
    Scene<Real50> fifty;
    fifty.system.mass_matrix = scene.system.mass_matrix.cast<Real50>();
    fifty.system.stiffness_matrix = scene.system.stiffness_matrix.cast<Real50>();
    fifty.system.damping_matrix = scene.system.damping_matrix.cast<Real50>();
    REQUIRE_NOTHROW(check(fifty));
}
