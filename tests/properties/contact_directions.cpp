#include <cmath>

#include "tests/properties/against_witness.hpp"
#include "tests/support/kinds_of_scenes.hpp"
#include "tests/support/named_scenes.hpp"
#include "tests/support/rotations.hpp"
#include "tests/support/split_mix.hpp"

using namespace denhartog;
using namespace denhartog::tests;

// A contact of any direction: what a change of coordinates by hand makes of it, a scene with its contact on one mass.

namespace {

// x = T y with y_j = w^T x in the place of x_j; T is exact, as w_j is a power of two.
Matrix<double> coordinates(const System<double>& s) {
    const std::vector<double>& w = s.contact_direction;
    const auto N = static_cast<Eigen::Index>(w.size()), j = static_cast<Eigen::Index>(s.contact.index);
    Matrix<double> T = Matrix<double>::Identity(N, N);
    const double w_j = w[s.contact.index];
    for (Eigen::Index k = 0; k < N; ++k) T(j, k) = k == j ? 1 / w_j : -w[static_cast<std::size_t>(k)] / w_j;
    return T;
}

// Matrices and forces of a scene in y; its contact is then one mass.
Scene<double> in_coordinates(Scene<double> scene, const Matrix<double>& T) {
    System<double>& s = scene.system;
    s.mass_matrix = T.transpose() * mass_matrix(s) * T;
    s.stiffness_matrix = T.transpose() * stiffness_matrix(s) * T;
    if (s.damping_matrix.size() > 0) s.damping_matrix = T.transpose() * s.damping_matrix * T;
    s.mass_ratios.clear();
    s.stiffness_ratios.clear();
    s.contact_direction.clear();
    const auto N = T.rows();
    Eigen::VectorXd re(N), im(N);
    const std::vector<Complex<double>> p = complex_load(s);
    for (Eigen::Index k = 0; k < N; ++k) {
        re(k) = p[static_cast<std::size_t>(k)].re;
        im(k) = p[static_cast<std::size_t>(k)].im;
    }
    re = T.transpose() * re;
    im = T.transpose() * im;
    s.load_vector.resize(static_cast<std::size_t>(N));
    for (std::size_t k = 0; k < s.load_vector.size(); ++k) {
        const double x = re(static_cast<Eigen::Index>(k)), y = im(static_cast<Eigen::Index>(k));
        s.load_vector[k] = s.load_phases.empty() ? x : std::hypot(x, y);
        if (!s.load_phases.empty()) s.load_phases[k] = std::atan2(y, x);
    }
    return scene;
}

// Both answers are certain, and their bounds meet; phases of forces are rounded on the way.
void check_same(const Certified& a, const Certified& b, double size) {
    CHECK(std::abs(a.value - b.value) <= a.error + b.error + 1e-12 * size);
    CHECK(a.error + b.error <= 1e-4 * size + 1e-12);
}

// Compares a scene with the same in y. Whether both were answered.
bool is_the_same_in_coordinates(const Scene<double>& scene, const std::optional<int>& digits, std::array<int, 3>& regimes) {
    const Matrix<double> T = coordinates(scene.system);
    const Scene<double> in_y = in_coordinates(scene, T);
    Solution a, b;
    try {
        a = solve(scene, {Asked::motion, digits});
        b = solve(in_y, {Asked::motion, digits});
    } catch (const PrecisionError&) {
        return false;
    }
    // With mu above 1 rounding may decide which motion the start leads to, or where in its periods that begins.
    if (scene.mu > 1 && (a.regime.regime != b.regime.regime || a.periods > 1 || b.periods > 1 || !a.not_from_rest.empty() ||
                         !b.not_from_rest.empty() || a.stops.size() != b.stops.size()))
        return false;
    CHECK(a.regime.regime == b.regime.regime);
    if (a.regime.regime != b.regime.regime) return true;
    ++regimes[static_cast<std::size_t>(a.regime.regime)];
    const std::size_t j = scene.system.contact.index;
    const SolvedMass& contact = b.masses[j];
    check_same(a.between.value().amplitude, contact.amplitude, contact.amplitude.value);
    if (contact.phase)
        CHECK(std::abs(std::remainder(a.between->phase.value().value - contact.phase->value, 2 * pi<double>())) <=
              a.between->phase->error + contact.phase->error + 1e-12);
    for (std::size_t k = 0; k < b.masses.size(); ++k) // all others are themselves
        if (k != j) check_same(a.masses[k].amplitude, b.masses[k].amplitude, b.masses[k].amplitude.value);
    if (a.limits && b.limits) check_same(a.limits->exact, b.limits->exact, b.limits->exact.value);
    CHECK(a.stops.size() == b.stops.size());
    for (std::size_t n = 0; n < a.stops.size() && n < b.stops.size(); ++n)
        CHECK(std::abs(a.stops[n].x.value - b.stops[n].x.value) <=
              a.stops[n].x.error + b.stops[n].x.error + 1e-12 * contact.amplitude.value);
    if (a.rest_interval && b.rest_interval) { // a difference of friction and load: their size is that of friction
        const double beta = *in_y.beta, sticking = b.limits && b.limits->sticking ? b.limits->sticking->value : 0;
        const double to = b.rest_interval->to.value;
        check_same(a.rest_interval->to, b.rest_interval->to, beta > sticking ? to * beta / (beta - sticking) : to);
    }
    if (!digits) { // the whole motion
        const SampledSolution x = motion(scene, 32), y = motion(in_y, 32);
        double size = 0, apart = 0;
        for (std::size_t n = 0; n < 32; ++n) {
            const auto of = [](const std::vector<double>& v) {
                return Eigen::Map<const Eigen::VectorXd>(v.data(), std::ssize(v));
            };
            const State of_x = x.states()[n], of_y = y.states()[n];
            apart = std::max(apart, (of(of_x.x) - T * of(of_y.x)).cwiseAbs().maxCoeff());
            size = std::max(size, of(of_x.x).cwiseAbs().maxCoeff());
        }
        CHECK(apart <= 1e-7 * size);
    }
    return true;
}

// Random scenes at friction ratios around their boundaries. How many were compared, and how many in each regime.
int compare_in_coordinates(std::uint64_t seed, std::size_t every, std::size_t most_masses, std::optional<int> digits,
                           std::array<int, 3>& regimes) {
    int compared = 0;
    const std::vector<RandomScene<double>> scenes = random_direction_scenes(seed);
    for (std::size_t n = 0; n < scenes.size(); n += every) {
        Scene<double> scene = scenes[n].scene;
        if (number_of_masses(scene.system) > most_masses) break;
        if (n / every % 2 == 0) scene.mu = 1;
        INFO(scenes[n].name);
        try {
            const Limits limits = boundary(scene, 6);
            constexpr double factors[] = {0.5, 1.25, 1.5, 2.5};
            scene.beta = friction_ratio_at(scenes[n].fraction_of_limit * factors[n / every % 4], limits.exact.value);
            if (n / every % 4 > 1 && limits.sticking)
                scene.beta = *scene.beta + limits.sticking->value * (n / every % 4 > 2 ? 1 : 0.25);
        } catch (const PrecisionError&) {
            continue;
        }
        compared += is_the_same_in_coordinates(scene, digits, regimes);
    }
    return compared;
}

} // namespace

TEST_CASE("a contact of any direction is one on a mass after a change of coordinates", "[direction][vectors]") {
    std::array<int, 3> regimes{};
    CHECK(compare_in_coordinates(20271, 1, 7, std::nullopt, regimes) >= 200);
    for (const int count : regimes) CHECK(count >= 20);
}

TEST_CASE("a contact of any direction is proved as one on a mass after a change of coordinates", "[direction][vectors]") {
    std::array<int, 3> regimes{};
    CHECK(compare_in_coordinates(20272, 4, 4, 30, regimes) >= 24);
    for (const int count : regimes) CHECK(count >= 2);
}

TEST_CASE("matrices with a contact held along any direction are off by two units in the last place at most",
          "[direction][stuck]") {
    SplitMix64 random(20273);
    for (const RandomScene<double>& each : random_direction_scenes(20273)) {
        System<double> s = each.scene.system;
        if (number_of_masses(s) > 5) break;
        for (double& w : s.contact_direction) w *= 1 + random.integer(1, 1 << 20) * 0x1p-21; // no power of two
        for (double& k : s.stiffness_ratios) k = k == 1 ? k : k / 3; // the sums of two springs are rounded
        const Contact held = contact_of(contact_vector(s), mass_matrix(s));
        const auto N = static_cast<Eigen::Index>(number_of_masses(s)), a = static_cast<Eigen::Index>(held.a);
        Scene<double> as_scene;
        as_scene.system = s;
        const System<Real50> exact = converted<Real50>(as_scene).system;
        Matrix<Real50> O = Matrix<Real50>::Identity(N, N);
        const std::vector<Real50>& w = exact.contact_direction;
        for (Eigen::Index k = 0; k < N; ++k) O(a, k) = (k == a ? Real50(1) : Real50(-w[static_cast<std::size_t>(k)])) / w[held.a];
        const NonDimensionalMatrices found = held_matrices(s, held, Matrix<double>(Matrix<double>::Zero(N, N)));
        INFO(each.name);
        for (const auto& [in_double, A] :
             {std::pair{found.M, mass_of<Real50, Real50>(exact)}, {found.K, stiffness_of<Real50, Real50>(exact)}}) {
            const Matrix<Real50> expected = O.transpose() * A * O;
            for (Eigen::Index i = 0; i < N; ++i)
                for (Eigen::Index k = 0; k < N; ++k)
                    CHECK(abs(Real50(Real50(in_double(i, k)) - expected(i, k))) <=
                          2 * std::numeric_limits<double>::epsilon() * abs(expected(i, k)));
        }
    }
}

TEST_CASE("a direction twice as long moves the contact twice as far and needs half the friction ratio", "[direction][vectors]") {
    const auto answer = [](const std::string& direction, double beta) {
        return solve(named_scene(R"(storeys {"load": [0.25, 1, 0.5], "contact": {"direction": )" + direction + R"(}, "beta": )" +
                                 std::to_string(beta) + "}"));
    };
    for (const double beta : {0.0625, 0.25, 4.0}) {
        const Solution a = answer("[1, -0.75, 0.5]", beta), b = answer("[2, -1.5, 1]", beta / 2);
        CHECK(a.regime.regime == b.regime.regime);
        for (std::size_t k = 0; k < 3; ++k)
            CHECK(b.amplitude(Mass{k}).value == Approx(a.amplitude(Mass{k}).value).epsilon(1e-12));
        CHECK(b.between.value().amplitude.value == Approx(2 * a.between.value().amplitude.value).epsilon(1e-12).margin(1e-300));
        CHECK(b.limits.value().exact.value == Approx(a.limits.value().exact.value / 2).epsilon(1e-12));
    }
}

TEST_CASE("a direction of one mass, or of two with opposite signs, is read as these", "[direction]") {
    const auto contact = [&](const std::string& text) { return named_scene(R"(storeys {"contact": )" + text + "}").system; };
    CHECK(contact(R"({"direction": [0, 1, 0]})").contact == Mass{1});
    CHECK(contact(R"({"direction": [0, 1.0, 0]})").contact_direction.empty());
    CHECK(contact(R"({"direction": [-1, 0, 1]})").contact == Mass{2});
    CHECK(contact(R"({"direction": [-1, 0, 1]})").contact_with == Mass{0});
    CHECK(contact(R"({"direction": [-1, 0, 1]})").contact_direction.empty());
    CHECK(contact(R"({"direction": [0, "1", 0]})").contact_direction.empty());
    for (const char* other : {"[0, -1, 2]", "[1, 1, 0]", "[1, -1, -1]", "[1, -0.5, 0]", R"([0, "1.5", 1])"}) {
        INFO(other);
        const System<double> s = contact(std::string(R"({"direction": )") + other + "}");
        CHECK(s.contact_direction.size() == 3);
        CHECK_FALSE(s.contact_with);
    }
    CHECK(contact(R"({"direction": [0.5, -2, 2]})").contact == Mass{1}); // the first of the largest entries
}

TEST_CASE("a direction along two masses answers as these do", "[direction][vectors]") {
    Scene<double> named = named_scene(R"(storeys {"damping_ratios": 0.05, "contact": [2, 1]})");
    Scene<double> general = named;
    general.system.contact_with.reset();
    general.system.contact_direction = {-1, 1, 0};
    for (const double beta : {0.05, 0.4, 5.0}) {
        named.beta = general.beta = beta;
        const Solution a = solve(named), b = solve(general);
        CHECK(a.regime.regime == b.regime.regime);
        for (std::size_t k = 0; k < 3; ++k) CHECK(b.amplitude(Mass{k}).value == a.amplitude(Mass{k}).value);
        CHECK(b.between.value().amplitude.value == a.between.value().amplitude.value);
    }
}

TEST_CASE("a wall that moves is seen along any direction", "[direction][base]") {
    // Against the general load: in the wall's frame the masses carry -(K + i r C - r^2 M) 1, by their phases.
    const Scene<double> wall =
        named_scene(R"(pair on a base {"damping_ratios": null, "damping_matrix": [[0.1, -0.05], [-0.05, 0.05]],
        "contact": {"direction": [0.5, 1]}, "base_motion": "wall", "r": 0.75, "beta": 0.1})");
    Scene<double> loaded = wall;
    loaded.system.base_motion = BaseMotion::none;
    const double r = *wall.r;
    loaded.system.load_vector.clear();
    for (Eigen::Index k = 0; k < 2; ++k) {
        const double re = r * r * mass_matrix(wall.system).row(k).sum() - stiffness_matrix(wall.system).row(k).sum(),
                     im = -r * wall.system.damping_matrix.row(k).sum();
        loaded.system.load_vector.push_back(std::hypot(re, im));
        loaded.system.load_phases.push_back(std::atan2(im, re));
    }
    for (const double beta : {0.05, 0.5, 5.0}) {
        Scene<double> a = wall, b = loaded;
        a.beta = b.beta = beta;
        const Solution seen = solve(a), expected = solve(b);
        CHECK(seen.regime.regime == expected.regime.regime);
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(seen.amplitude(Mass{k}).value == Approx(expected.amplitude(Mass{k}).value).epsilon(1e-9));
    }
}

// Contacts between two masses and loads on several: what must be the same, named or built otherwise.

TEST_CASE("two masses that rub against each other may be named in either order", "[vectors]") {
    const auto answer = [](const std::string& contact, const std::string& beta) {
        return solve(named_scene(R"(storeys {"load": [0.25, 1, 0.5], "contact": )" + contact + R"(, "beta": )" + beta + "}"));
    };
    for (const std::string beta : {"0.0625", "0.25"}) {
        const Solution a = answer("[1, 3]", beta), b = answer("[3, 1]", beta);
        INFO("beta = " << beta);
        CHECK(b.between.value().amplitude.value == Approx(a.between.value().amplitude.value).epsilon(1e-9));
        CHECK(std::abs(std::cos(b.between->phase.value().value - a.between->phase.value().value) + 1) < 1e-9);
        for (std::size_t k = 0; k < 3; ++k) CHECK(b.amplitude(Mass{k}).value == Approx(a.amplitude(Mass{k}).value).epsilon(1e-9));
    }
}

TEST_CASE("a mass that cannot move is a wall", "[vectors]") {
    // The last mass of three is heavy: rubbing against it is rubbing against a wall, as a chain of two does.
    const auto at = [](const std::string& name, const std::string& beta) {
        return solve(named_scene(name + R"( {"beta": )" + beta + "}"));
    };
    for (const std::string beta : {"0.125", "0.5", "2"}) {
        const Solution a = at("against a heavy mass", beta), b = at("against a wall", beta);
        INFO("beta = " << beta);
        CHECK(a.regime.regime == b.regime.regime);
        CHECK(a.stops.size() == b.stops.size());
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(a.masses[k].amplitude.value == Approx(b.masses[k].amplitude.value).margin(1e-4)); // it moves by a millionth
    }
}
