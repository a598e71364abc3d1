// Motions that the paper's assumption of symmetry leaves out, stability, hard cases, and what a search that fails says.
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <random>

#include "tests/integration/orbit_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

bool all_finite(const PeriodicOrbit& o) {
    double sum = o.error_bound + o.contact.amplitude + o.contact.phase;
    for (const MassMotion& m : o.masses) sum += m.amplitude + m.phase;
    for (const Stop& s : o.stops) sum += s.start + s.end + s.x;
    for (const Multiplier& m : o.multipliers) sum += std::abs(m.value) + m.error;
    for (std::size_t k = 0; k < o.start.x.size(); ++k) sum += o.start.x[k] + o.start.x_prime[k];
    return std::isfinite(sum);
}

/// True if two multipliers of one size may be the known ones.
bool overlap(const Multiplier& a, const Multiplier& b) {
    return std::abs(size_of(a.value) - size_of(b.value)) <= a.error + b.error;
}

/// Requires that a search finds an orbit of a period and no shorter one, and that propagation confirms it.
void check_kind(const PreparedMotion& p, int periods, bool symmetric, std::size_t stops) {
    const PeriodicOrbit orbit = orbit_of(p);
    INFO(in_words(orbit.reason));
    REQUIRE(orbit.status == OrbitStatus::periodic);
    CHECK(orbit.periods == periods);
    CHECK(orbit.symmetric == symmetric);
    CHECK(orbit.stops.size() == stops);
    CHECK(orbit.stable);
    CHECK(orbit.error_bound < 1e-11);
    // The motion from rest, by propagation alone, is on the orbit after a long time, and comes back to itself no earlier.
    const State late = propagated(p, at_rest(orbit.start.x.size()), 2 * 840);
    double nearest = 1;
    for (int n = 0; n < periods; ++n) nearest = std::min(nearest, distance(propagated(p, late, 2 * n), orbit.start));
    CHECK(nearest < 1e-9);
    for (int h = 1; h <= 2 * periods; ++h) {
        INFO(h << " half-periods");
        const double back = distance(propagated(p, late, h), late);
        if (h % (symmetric ? periods : 2 * periods) == 0)
            CHECK(back < 1e-9);
        else
            CHECK(back > 1e-3);
    }
}

} // namespace

TEST_CASE("static friction above kinetic brings asymmetric and subharmonic motions from rest", "[eq:3][exact-solver][shooting]") {
    check_kind(prepared_oscillator(0.03125, 0.5, 0.1875, 2), 1, false, 1);
    check_kind(prepared_oscillator(0.015625, 0.65625, 0.25, 3), 3, true, 2);
    check_kind(prepared_oscillator(0.015625, 0.46875, 0.21875, 1.5), 2, false, 3);
    check_kind(prepared_oscillator(0, 0.28125, 0.125, 3), 5, true, 16);
}

TEST_CASE("where motions are not unique the orbit is the one that propagation from rest ends in",
          "[eq:3][exact-solver][shooting]") {
    int compared = 0;
    for (const PreparedMotion& p : between_the_boundaries(21, 2, 0)) {
        const PeriodicOrbit orbit = orbit_of(p);
        if (orbit.status != OrbitStatus::periodic || std::abs(orbit.multipliers.front().value) > 0.98) continue;
        INFO(p.name << " " << orbit.periods << " " << orbit.symmetric);
        ++compared;
        State late = propagated(p, at_rest(orbit.start.x.size()), 2 * 840);
        double nearest = distance(late, orbit.start);
        for (int n = 1; n < orbit.periods; ++n) {
            late = propagated(p, late, 2);
            nearest = std::min(nearest, distance(late, orbit.start));
        }
        CHECK(nearest < 1e-6);
    }
    CHECK(compared > 30);
}

TEST_CASE("a contact whose load reaches the friction exactly is on the boundary of rest", "[eq:74][exact-solver][shooting]") {
    const PeriodicOrbit on = orbit_of(prepared_oscillator(0.0625, 0.5, 1));
    CHECK(on.status == OrbitStatus::permanently_stuck);
    CHECK_THAT(in_words(on.reason), Catch::Contains("boundary"));
    const PeriodicOrbit below = orbit_of(prepared_oscillator(0.0625, 0.5, 1 - 0x1p-20));
    REQUIRE(below.status == OrbitStatus::periodic);
    CHECK(below.stops.size() == 2);
    CHECK(below.contact.amplitude > 0);
    const PeriodicOrbit above = orbit_of(prepared_oscillator(0.0625, 0.5, 1 + 0x1p-20));
    CHECK(above.status == OrbitStatus::permanently_stuck);
    CHECK(in_words(above.reason).find("boundary") == std::string::npos);
}

TEST_CASE("the bounds of multipliers take in that the instants of events are off, and no smaller error would do",
          "[exact-solver][shooting]") {
    // The motion next to the orbit has other instants, and so another Jacobian; how far it is from the orbit is known.
    int compared = 0, useful = 0, outside_of_less = 0;
    for (const PreparedMotion& p : between_the_boundaries(33, 3, 1)) {
        const PeriodicOrbit orbit = orbit_of(p);
        if (orbit.status != OrbitStatus::periodic || !orbit.symmetric || orbit.periods != 1) continue;
        ExactSolver solver(p.system, p.excitation);
        OrbitMap map(solver);
        State near = orbit.start;
        for (std::size_t k = 0; k < near.x.size(); ++k) near.x[k] += (k % 2 == 0 ? 1e-7 : -1e-7) * orbit.contact.amplitude;
        REQUIRE(map.apply(near, 1, true));
        const double apart = map.norm(difference(near, orbit.start));
        const auto known_within = [&](double energy) {
            ErrorsOfOrbit errors{0, map.displacement_of_energy() * energy, {}};
            for (const auto& shape : p.system.basis.phi.rowwise()) errors.velocity.push_back(shape.norm() * energy);
            return squared(multipliers_of_orbit(map, errors));
        };
        const std::vector<Multiplier> known = known_within(apart), less = known_within(apart / 4096);
        REQUIRE(known.size() == orbit.multipliers.size());
        INFO(p.name);
        bool inside_less = true;
        for (std::size_t n = 0; n < known.size(); ++n) {
            CHECK(overlap(known[n], orbit.multipliers[n]));
            inside_less = inside_less && overlap(less[n], orbit.multipliers[n]);
            ++compared;
            useful += known[n].error < 1e-2;
        }
        outside_of_less += !inside_less;
    }
    CAPTURE(compared, useful, outside_of_less);
    CHECK(compared > 100);
    CHECK(2 * useful > compared);
    CHECK(outside_of_less > 0);
}

TEST_CASE("with mu above 1 a motion is stable only if its multipliers are inside the unit circle by more than their bounds",
          "[exact-solver][shooting]") {
    int stable = 0, across = 0;
    OrbitSearch any;
    any.follow_start = false;
    for (const PreparedMotion& p : between_the_boundaries(100, 4, 3)) {
        const PeriodicOrbit orbit = orbit_of(p, any);
        if (orbit.status != OrbitStatus::periodic) continue;
        INFO(p.name);
        const bool inside = are_inside(orbit.multipliers);
        CHECK((!orbit.stable || inside));
        stable += orbit.stable;
        across += !inside && size_of(orbit.multipliers.front().value) < 1;
    }
    CHECK(stable > 20);
    CHECK(across > 0); // of these the value alone, or its rounding, would say that they are stable
}

TEST_CASE("with mu = 1 no deviation grows in energy over half a period, whether the contact is at a wall or between two masses",
          "[exact-solver][shooting]") {
    int resting_at_the_start = 0;
    for (const char* contact : {"[2, 1]", "2"})
        for (const double beta : {0.1, 0.3, 0.6, 0.9})
            for (const double r : {0.2, 0.5, 0.9, 1.5}) {
                const Scene<double> scene = named_scene(R"(one of thirty {"contact": )" + std::string(contact) + R"(, "r": )" +
                                                        std::to_string(r) + R"(, "beta": )" + std::to_string(beta) + "}");
                const ContactSystem system = contact_system(scene.system);
                ExactSolver solver(system, {*scene.r, *scene.beta, 1});
                const PeriodicOrbit orbit = periodic_orbit(solver, at_rest(2));
                if (orbit.status != OrbitStatus::periodic) continue;
                OrbitMap map(solver);
                REQUIRE(map.apply(orbit.start, 1, true));
                resting_at_the_start += map.motion().phases.front().direction == 0;
                CHECK(Eigen::JacobiSVD<Matrix<double>>(map.energy_jacobian()).singularValues()(0) < 1);
                CHECK(orbit.stable);
            }
    CHECK(resting_at_the_start >= 12);
}

TEST_CASE("a matrix is seen to contract only where all its eigenvalues are inside the unit circle by more than its error",
          "[shooting]") {
    const auto contracts = [](const Matrix<double>& A, double error) {
        return are_inside(multipliers_of(A, error, std::numeric_limits<double>::infinity()));
    };
    Matrix<double> A(2, 2);
    A << 0.5, 100, 0, 0.5; // far from normal
    CHECK(contracts(A, 1e-9));
    CHECK_FALSE(contracts(A, 0.01)); // in the corner it makes an eigenvalue of 1.5
    A << 1, 0, 0, 0.5;
    CHECK_FALSE(contracts(A, 0));
    A << 1 - 1e-9, 0, 0, 0;
    CHECK(contracts(A, 1e-12));
    CHECK_FALSE(contracts(A, 1e-8));
    A << 0, 1, 0, 0; // a double zero
    CHECK(contracts(A, 1e-12));
    CHECK(multipliers_of(A, 1e-12, 1).size() == 2);
    A(0, 0) = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(contracts(A, 0));
    CHECK(multipliers_of(A, 0, 1).empty());
}

TEST_CASE(
    "the sizes of the eigenvalues of a matrix within an error of another are within their bounds, and not of a smaller error",
    "[shooting]") {
    std::mt19937_64 engine(54);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto random_matrix = [&](Eigen::Index n) {
        return Matrix<double>(Matrix<double>::NullaryExpr(n, n, [&] { return number(engine); }));
    };
    constexpr double infinite = std::numeric_limits<double>::infinity();
    int outside_of_less = 0, useful = 0, compared = 0;
    for (int round = 0; round < 400; ++round) {
        const Eigen::Index n = 2 + round % 7;
        Matrix<double> A = random_matrix(n);
        if (round % 3 == 1) A.col(0) = A.col(n - 1); // a zero
        if (round % 3 == 2) {                        // zeros with fewer eigenvectors, in other coordinates
            Matrix<double> J = Matrix<double>::Zero(n, n);
            for (Eigen::Index k = 2; k < n; ++k) J(k, k) = number(engine);
            J(0, 1) = 1;
            A = A * J * A.inverse();
        }
        const double error = std::ldexp(A.norm(), -4 * (2 + round % 9));
        const Matrix<double> E = random_matrix(n), other = A + E * (error / E.norm());
        const std::vector<Multiplier> known = multipliers_of(A, error, infinite),
                                      less = multipliers_of(A, error / 4096, infinite),
                                      exact = multipliers_of(other, 0, infinite);
        REQUIRE(known.size() == exact.size());
        bool inside_less = true;
        for (std::size_t k = 0; k < known.size(); ++k) {
            INFO("round " << round << ", size " << k << ": " << size_of(known[k].value) << " " << size_of(exact[k].value));
            CHECK(overlap(known[k], exact[k]));
            inside_less = inside_less && overlap(less[k], exact[k]);
            ++compared;
            useful += known[k].error < 1e-2;
        }
        outside_of_less += !inside_less;
    }
    CAPTURE(compared, useful, outside_of_less);
    CHECK(outside_of_less > 40);
    CHECK(2 * useful > compared);
    const std::vector<Multiplier> within_one = multipliers_of(Matrix<double>::Constant(1, 1, 0.75), 100, 1);
    CHECK(within_one.front().error == 0.75); // nothing but the size that is known from elsewhere
    CHECK(multipliers_of(Matrix<double>::Zero(3, 3), 1e-9, infinite).front().error < 2e-9);
}

TEST_CASE("an orbit that is not stable is found where it is asked for, and not given as what the start leads to",
          "[exact-solver][shooting]") {
    const PreparedMotion p = prepared_oscillator(0.03125, 0.5, 0.1875, 2);
    OrbitSearch any;
    any.follow_start = false;
    const PeriodicOrbit symmetric = orbit_of(p, any);
    REQUIRE(symmetric.status == OrbitStatus::periodic);
    CHECK(symmetric.symmetric);
    CHECK_FALSE(symmetric.stable);
    CHECK(std::abs(symmetric.multipliers.front().value) > 1);
    CHECK(orbit_of(p).stable);
}

TEST_CASE("a motion that tends to no orbit is no answer", "[exact-solver][shooting]") {
    OrbitSearch search;
    search.most_periods = 400;
    const PeriodicOrbit resonance = orbit_of(prepared_oscillator(0, 1, 0.5), search);
    CHECK(resonance.status == OrbitStatus::not_converged);
    CHECK_THAT(in_words(resonance.reason), Catch::Contains("grows"));
    System<double> s = named_scene("node").system; // at a node of the second mode, which nothing else damps
    const PeriodicOrbit node = orbit_of({"", contact_system(s), {0.3125, 0.0625, 1}});
    CHECK(node.status == OrbitStatus::not_from_start);
    CHECK_THAT(in_words(node.reason), Catch::Contains("not certainly stable"));
    s.load = Mass{1}; // does not reach that mode: the motion from rest tends to an orbit that attracts nothing else
    const PeriodicOrbit reached = orbit_of({"", contact_system(s), {0.3125, 0.0625, 1}});
    CHECK(reached.status == OrbitStatus::periodic);
    CHECK_FALSE(reached.stable);
    const PreparedMotion irregular = prepared_oscillator(0.015625, 0.40625, 0.125, 2.5);
    const PeriodicOrbit chaotic = orbit_of(irregular, search);
    CHECK(chaotic.status == OrbitStatus::not_from_start);
    CHECK_FALSE(chaotic.stable);
    CHECK_THAT(in_words(chaotic.reason), Catch::Contains("no periodic motion within 400 periods"));
    CHECK(chaotic.periods_propagated >= 400);
}

TEST_CASE("a motion that repeats itself after more half-periods than are looked for is given up where no other orbit is wanted",
          "[shooting][counter]") {
    OrbitSearch search;
    search.converging_only = true;
    const struct {
        double r, beta;
        int half_periods;
    } cases[] = {{1.15625, 0.25, 9}, {1.1875, 0.28125, 31}};
    for (const auto& each : cases) {
        const PreparedMotion p = prepared_chain({1, 1}, {1, 1}, {0.0078125, 0.0078125}, 1, 1, each.r, each.beta, 2);
        const PeriodicOrbit given_up = orbit_of(p, search), whole = orbit_of(p);
        CHECK(given_up.status == OrbitStatus::not_converged);
        CHECK(whole.status != OrbitStatus::periodic);
        CHECK(2 * given_up.periods_propagated < whole.periods_propagated);
        CHECK(in_words(given_up.reason).find("no periodic motion within") != std::string::npos);
        const State late = propagated(p, at_rest(2), 2 * 840);
        CHECK(distance(propagated(p, late, each.half_periods), late) < 1e-9);
        for (int h = 1; h <= 16; ++h)
            if (h <= 8 || h % 2 == 0) CHECK(distance(propagated(p, late, h), late) > 1e-3);
    }
    // A motion that never repeats itself is followed to the end.
    const PreparedMotion irregular = prepared_oscillator(0.0078125, 0.4375, 0.15625, 2);
    CHECK(orbit_of(irregular, search).status == OrbitStatus::not_converged);
    CHECK(orbit_of(irregular, search).periods_propagated > 500);
    // A motion that comes to an orbit gives the same, to the last bit.
    int found = 0;
    for (const PreparedMotion& p : between_the_boundaries(61, 3, 1.75)) {
        const PeriodicOrbit one = orbit_of(p), other = orbit_of(p, search);
        if (!is_from_start(one)) continue;
        INFO(p.name);
        CHECK(other.status == one.status);
        CHECK(other.contact.amplitude == one.contact.amplitude);
        CHECK(other.periods_propagated == one.periods_propagated);
        ++found;
    }
    CHECK(found > 20);
}

TEST_CASE("less is done where less is asked for", "[shooting][counter]") {
    const PreparedMotion p = prepared_three_masses(0.6875, 0.25);
    const PeriodicOrbit all = orbit_of(p);
    OrbitSearch search;
    search.contact_only = true;
    search.with_stability = false;
    const PeriodicOrbit less = orbit_of(p, search);
    REQUIRE(less.status == OrbitStatus::periodic);
    CHECK(less.masses.empty());
    CHECK(less.multipliers.empty());
    CHECK(less.effort_spent < all.effort_spent);
    CHECK(less.contact.amplitude == all.contact.amplitude);
}

TEST_CASE("every number of an answer is finite, for every kind of scene", "[exact-solver][shooting]") {
    int periodic = 0, stuck = 0, open = 0;
    for (const std::uint64_t seed : {11, 12})
        for (PreparedMotion& p : between_the_boundaries(seed, 2, 0)) {
            const double beta = p.excitation.beta;
            for (const double factor : {0.25, 1.0, 3.0}) {
                p.excitation.beta = factor * beta;
                OrbitSearch search;
                search.most_periods = 60;
                const PeriodicOrbit orbit = orbit_of(p, search);
                INFO(p.name << " " << factor << " " << in_words(orbit.reason));
                (orbit.status == OrbitStatus::periodic ? periodic : !is_from_start(orbit) ? open : stuck) += 1;
                CHECK(all_finite(orbit));
                if (!is_from_start(orbit)) CHECK_FALSE(orbit.reason.empty());
                if (orbit.status == OrbitStatus::periodic) CHECK(orbit.error_bound < 0.01);
            }
        }
    CHECK(periodic > 150);
    CHECK(stuck > 30);
    CHECK(open < periodic);
}

TEST_CASE("a start that breaks a rule is refused", "[shooting][input]") {
    const PreparedMotion p = prepared_oscillator(0.01, 0.5, 0.25);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(orbit_from(p, {{nan}, {0}}), InputError);
    CHECK_THROWS_AS(orbit_from(p, {{0}, {nan}}), InputError);
    CHECK_THROWS_AS(orbit_from(p, {{0, 0}, {0}}), InputError);
}

TEST_CASE("a motion is followed for thirty decay times of its slowest mode, overdamped or not", "[shooting]") {
    const auto periods = [](const PreparedMotion& p) {
        const ExactSolver solver(p.system, p.excitation);
        return periods_to_follow(solver, 20000);
    };
    CHECK(periods(prepared_oscillator(0.5, 1, 0.25, 2)) == 500 + 9);     // 30 / (2 pi 0.5)
    CHECK(periods(prepared_oscillator(1000, 1, 0.25, 2)) == 500 + 9549); // the slow one of its two rates is 1 / 2000
    CHECK(periods(prepared_oscillator(0, 1, 0.25, 2)) == 20000);
    CHECK(periods(prepared_oscillator(-0.0, 1, 0.25, 2)) == 20000);
}
