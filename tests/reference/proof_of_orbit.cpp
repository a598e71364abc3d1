/// @file
/// @brief Every demand of friction on a motion is checked: a motion that breaks one of them is refused.
#include <algorithm>
#include <functional>
#include <random>
#include <string>

#include "orbit_cases.hpp"
#include "tests/catch.hpp"

namespace denhartog::tests {
namespace {

using namespace reference;

constexpr slong bits = 128;

// A motion with two stops, a half of which is the mirror image of the other.
struct TwoStops {
    Scene<double> scene;
    ProvedOrbit orbit;
    std::vector<PhaseInStretches> phases;

    explicit TwoStops(double mu = 1)
        : scene(scene_of(chain_of({1, 1}, {1, 1}, {0.02, 0.01}, 2, 1), 0.3125, 0.25, mu)),
          orbit(proved_near(in_bits(scene), guess_for(scene), bits)), phases(in_stretches(orbit, 64)) {}

    // The event that ends a stop.
    [[nodiscard]] slong slip() const {
        slong i = 1;
        while (orbit.at.direction(i) != 0) ++i;
        return i;
    }
};

std::string refusal(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, bool* certain = nullptr) {
    const Bits few(64);
    try {
        require_friction(orbit, phases);
    } catch (const Unproved& e) {
        if (certain != nullptr) *certain = dynamic_cast<const Disproved*>(&e) != nullptr;
        return e.what();
    }
    return "";
}

TEST_CASE("the demands of friction hold on a motion with stops", "[reference][proof]") {
    for (const double mu : {1.0, 1.25}) {
        const TwoStops motion(mu);
        CHECK(refusal(motion.orbit, motion.phases).empty());
    }
}

TEST_CASE("a contact that slides against its direction is refused", "[reference][proof]") {
    TwoStops motion;
    OrbitUnknowns& at = motion.orbit.at;
    REQUIRE((at.m() == 2 && at.direction(1) == 0));
    const Ball end = at.instant(2); // of the phase of sliding, which now comes first
    at.directions = {0, -at.direction(2), 0};
    at.u(at.states()) = at.instant(1);
    at.u(at.states() + 1) = end;
    motion.orbit.Z.erase(motion.orbit.Z.begin());
    std::swap(motion.phases[0], motion.phases[1]);
    bool certain = false;
    CHECK(!refusal(motion.orbit, motion.phases, &certain).empty());
    CHECK(certain);
}

TEST_CASE("a contact that friction cannot hold, has to slip to the other side or does not jump is refused",
          "[reference][proof]") {
    const struct {
        std::string told;
        bool certain;
        std::function<void(TwoStops&)> change;
    } wrong[] = {
        {"it slips earlier", true, [](TwoStops& m) { m.orbit.s.holds = m.orbit.s.holds * Ball(0.9375); }},
        {"it slips earlier", true, [](TwoStops& m) { m.orbit.s.holds = m.orbit.s.holds * Ball(1 - 0x1p-40); }},
        // A load ten times as large, moved so that it reaches its limit where it did: earlier it is beyond the other limit.
        {"it slips to the other side", true,
         [](TwoStops& m) {
             ContactMechanics& s = m.orbit.s;
             const Ball after(m.orbit.at.direction(m.slip() + 1));
             s.load = s.load * Ball(10);
             s.load(0, s.n() - 1) -= Ball(9) * s.holds * after;
         }},
        // With mu = 1 the velocity grows as the square of the time: it is no jump.
        {"it turns or stops while it slides", false, [](TwoStops& m) { m.orbit.s.equal = false; }}};
    for (const auto& [told, is_certain, change] : wrong) {
        TwoStops motion;
        change(motion);
        bool certain = !is_certain;
        CHECK(refusal(motion.orbit, motion.phases, &certain) == told);
        CHECK(certain == is_certain);
    }
}

TEST_CASE("a turn where the contact has to stop is refused", "[reference][proof]") {
    const Scene<double> scene = scene_of(chain_of({1}, {1}, 0.125), 0.75, 0.125);
    FollowedMotion motion(scene);
    REQUIRE(motion.orbit.stops.empty());
    ProvedOrbit orbit = proved_near(in_bits(scene), guess_of(motion.solver, motion.orbit), bits);
    const std::vector<PhaseInStretches> phases = in_stretches(orbit, 64);
    CHECK(refusal(orbit, phases).empty());
    orbit.s.holds = orbit.s.holds * Ball(64);
    bool certain = false;
    CHECK(refusal(orbit, phases, &certain) == "it stops where it is said to turn");
    CHECK(certain);
    orbit.s.holds = widened(orbit.s.holds, orbit.s.holds); // from nothing on
    CHECK(refusal(orbit, phases, &certain) == "it may stop where it is said to turn");
    CHECK(!certain);
}

TEST_CASE("a phase that ends before it starts is refused", "[reference][proof]") {
    TwoStops motion;
    OrbitUnknowns& at = motion.orbit.at;
    REQUIRE(at.m() >= 2);
    at.u(at.states() + 1) = at.u(at.states()) - Ball(0.25);
    CHECK_THROWS_AS(in_stretches(motion.orbit, 64), Disproved);
    at.u(at.states() + 1) = widened(at.u(at.states()), Ball(0.25));
    CHECK_THROWS_AS(in_stretches(motion.orbit, 64), Unproved);
}

CurveInBalls polynomial(const std::vector<double>& c) {
    CurveInBalls curve;
    for (const double each : c) curve.powers.emplace_back(each);
    return curve;
}

TEST_CASE("a curve is found positive exactly where it is", "[reference][proof]") {
    CHECK_NOTHROW(require_positive(polynomial({1, -0.5}), {}, "x"));
    CHECK_NOTHROW(require_positive(polynomial({0, 1, -0.5}), {1, false}, "x"));
    CHECK_NOTHROW(require_positive(polynomial({0, 0, 1, -0.5}), {2, false}, "x"));
    CHECK_NOTHROW(require_positive(polynomial({0, 1, -1}), {1, true}, "x"));
    CHECK_NOTHROW(require_positive(polynomial({0, 0, 1, -1}), {2, true}, "x"));
    CHECK_NOTHROW(require_positive(polynomial({0.25 + 0x1p-40, -1, 1}), {}, "x")); // only just
    CHECK_THROWS_AS(require_positive(polynomial({0.25 - 0x1p-40, -1, 1}), {}, "x"), Disproved);
    CHECK_THROWS_AS(require_positive(polynomial({0.25, -1, 1}), {}, "x"), Unproved);           // touches zero
    CHECK_THROWS_AS(require_positive(polynomial({0, 1, -0.5}), {}, "x"), Unproved);            // zero where it starts
    CHECK_THROWS_AS(require_positive(polynomial({0, 0, 1, -0.5}), {1, false}, "x"), Unproved); // to another order
    CHECK_THROWS_AS(require_positive(polynomial({1, -1}), {}, "x"), Unproved);                 // zero where it ends
    CHECK_THROWS_AS(require_positive(polynomial({1, -4, 3}), {0, true}, "x"), Disproved);
    CHECK_THROWS_AS(require_positive(polynomial({-1, 3}), {}, "x"), Disproved);
    // 1 - 216 s^4 (1 - 4 s^2), s from the middle: 1 there and at the ends, flat in the middle, and negative on either side of it
    CHECK_THROWS_AS(require_positive(polynomial({1, -54, 486, -1728, 3024, -2592, 864}), {}, "x"), Disproved);
    CHECK_THROWS_AS(require_positive(polynomial({0, -1, 2}), {1, false}, "x"), Disproved);
}

TEST_CASE("a series of the exponential holds its sum and its derivatives", "[reference][proof]") {
    const Bits some(100);
    BallMatrix B(2, 2), y(2, 1); // a turn by 5 radians
    B(0, 1) = Ball(-5);
    B(1, 0) = Ball(5);
    y(0) = Ball(1);
    const ExponentialSeries series(B, y);
    for (const double theta : {0.0, 0.375, 1.0}) {
        const Ball angle(5 * theta);
        const BallMatrix sum = series.at(Ball(theta));
        CHECK((sum(0) - cos(angle)).may_vanish());
        CHECK((sum(1) - sin(angle)).may_vanish());
        CHECK(sum(0).radius() < 1e-24);
        const CurveInBalls c{series.powers(transposed(y))};
        CHECK((derivative(c, 1, Ball(theta)) + Ball(5) * sin(angle)).may_vanish());
        CHECK((derivative(c, 2, Ball(theta)) + Ball(25) * cos(angle)).may_vanish());
    }
}

// A number, or a row of two, as a matrix of one column.
BallMatrix column(const std::vector<Ball>& x) {
    BallMatrix c(static_cast<slong>(x.size()), 1);
    for (std::size_t k = 0; k < x.size(); ++k) c(static_cast<slong>(k)) = x[k];
    return c;
}

TEST_CASE("where slopes are certain by more than half a solution is proved, and its box holds it", "[reference][proof]") {
    const Bits some(100);
    BallMatrix open(1, 1);
    const auto solution = [&](double u, double step, double uncertain, double half_width) {
        open(0, 0) = widened(Ball(0), Ball(uncertain));
        return solution_from(column({Ball(u)}), column({Ball(step)}), open, column({widened(Ball(0), Ball(half_width))}));
    };
    const std::optional<BallMatrix> off = solution(0, 1, 0.375, 4);
    REQUIRE(off);
    for (const double slope : {0.625, 1.0, 1.375}) CHECK(((*off)(0) + Ball(1) / Ball(slope)).may_vanish());
    CHECK((*off)(0).radius() < 1);
    CHECK_FALSE(solution(0, 1, 0.75, 64));    // slopes from 1/4 on: the solution may be four steps away
    CHECK_FALSE(solution(0, 1, 0.375, 1.75)); // twice the step is outside of the box of the slopes
    CHECK_FALSE(solution(3, 1, 0.375, 4));
    CHECK(solution(1, 1, 0.375, 4));
}

TEST_CASE("what one unknown leaves open of another counts in units of both", "[reference][proof]") {
    BallMatrix open(2, 2);
    open(0, 1) = widened(Ball(0), Ball(0.25));
    const auto solution = [&](double half_width) {
        return solution_from(column({Ball(0), Ball(0)}), column({Ball(0x1p-20), Ball(0)}), open,
                             column({widened(Ball(0), Ball(1)), widened(Ball(0), Ball(half_width))}));
    };
    CHECK(solution(1));
    CHECK_FALSE(solution(1024));
}

TEST_CASE("a motion in few bits holds that in many, its events and every state", "[reference][proof]") {
    const TwoStops motion;
    const ProvedOrbit fine = proved_near(in_bits(motion.scene), guess_for(motion.scene), 512), &coarse = motion.orbit;
    for (slong k = 0; k < fine.at.u.rows(); ++k) {
        CHECK((coarse.at.u(k) - fine.at.u(k)).may_vanish());
        CHECK(coarse.at.u(k).radius() < 1e-30);
    }
    for (std::size_t i = 0; i < fine.Z.size(); ++i)
        for (slong k = 0; k < fine.Z[i].rows(); ++k) CHECK((coarse.Z[i](k) - fine.Z[i](k)).may_vanish());
    const Bits enough(512);
    const PeakInBalls few = peak_of_mass(coarse, motion.phases, 0), many = peak_of_mass(fine, in_stretches(fine, 64), 0);
    CHECK((few.size - many.size).may_vanish());
    CHECK((few.phase.value() - many.phase.value()).may_vanish());
    const auto with_speed = [&](const Ball& more) { // of that mass at the events
        ProvedOrbit orbit = fine;
        for (BallMatrix& Z : orbit.Z) Z(orbit.s.N) += more;
        return peak_of_mass(orbit, in_stretches(orbit, 64), 0);
    };
    for (const double most : {0x1p-30, 0x1p-60}) {
        const PeakInBalls all = with_speed(widened(Ball(0), Ball(most)));
        for (const double more : {-most, 0.0, most}) {
            const PeakInBalls one = with_speed(Ball(more));
            CHECK((all.size - one.size).may_vanish());
            CHECK((all.phase.value() - one.phase.value()).may_vanish());
        }
        CHECK(all.phase.value().radius() < 0x1p20 * most);
    }
}

TEST_CASE("of displacements that are not told apart the larger one is held, and one that may be nothing has any phase",
          "[reference][proof]") {
    TwoStops motion;
    ProvedOrbit& orbit = motion.orbit;
    std::ranges::fill(orbit.at.directions, 1);
    const auto place_at = [&](std::size_t i, const Ball& x) { orbit.Z[i](1) = x; };
    for (std::size_t i = 0; i < orbit.Z.size(); ++i) place_at(i, Ball(0.5));
    REQUIRE(orbit.at.m() >= 2);
    for (const std::size_t first : {0, 1}) {
        place_at(first, widened(Ball(2), Ball(0.25)));
        place_at(1 - first, widened(Ball(-2.125), Ball(0.25)));
        const PeakInBalls peak = peak_of_contact(orbit);
        CHECK(arb_contains(peak.size.a, Ball::within(2, 2.375).a) != 0);
        CHECK(peak.size.low() > 1.7);
    }
    place_at(0, Ball::within(-3, 3));
    CHECK(peak_of_contact(orbit).phase.value().radius() > 3);
}

TEST_CASE("vectors in double belong to their eigenvalues, real or not", "[reference][proof]") {
    constexpr Eigen::Index n = 9;
    Matrix<double> A(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index k = 0; k < n; ++k) A(i, k) = static_cast<double>((7 * i * i + 5 * i * k + 11 * k) % 13) - 6;
    const ApproximateEigenvectors found = eigenvectors_of(A);
    REQUIRE(found.values.size() == n);
    int pairs = 0;
    for (Eigen::Index c = 0; c < n; ++c) {
        if (found.values(c).imag() > 0) ++pairs;
        const Eigen::VectorXcd v = found.vectors.col(c), left = A.cast<std::complex<double>>() * v - found.values(c) * v;
        CHECK((v.norm() >= 0.5 && left.norm() < 1e-12 * A.norm() * v.norm()));
    }
    CHECK((found.inverse * found.vectors - Matrix<std::complex<double>>::Identity(n, n)).norm() < 1e-12);
    CHECK((pairs > 0 && 2 * pairs < n));
}

TEST_CASE("multipliers that double hardly tells apart are known all the same", "[reference][proof]") {
    const Bits all(192);
    for (const slong bits_apart : {6, 45}) {         // balls from double are wide, or there are none
        const Ball more = power_of_two(-bits_apart); // than 1/2, the other multiplier; the vectors are both nearly (3, 5)
        MapOfDeviations map{BallMatrix(2, 2), false};
        map.A(0, 0) = Ball(0.5) - 5 * (12 + more);
        map.A(0, 1) = 3 * (12 + more);
        map.A(1, 0) = -5 * (20 + 2 * more);
        map.A(1, 1) = Ball(0.5) + 3 * (20 + 2 * more);
        const std::vector<Ball> sizes = multipliers_over_period(map, false);
        CHECK(are_narrow(sizes));
        CHECK((sizes.at(0) - Ball(0.5) - more).may_vanish());
        CHECK((sizes.at(1) - Ball(0.5)).may_vanish());
    }
}

TEST_CASE("balls about multipliers hold those of every map in the balls of its entries, and hardly more", "[reference][proof]") {
    constexpr slong n = 7;
    constexpr double off = 1e-10;
    const Bits all(192);
    MapOfDeviations map{BallMatrix(n, n), false}, wide{BallMatrix(n, n), false}, moved = map;
    for (slong i = 0; i < n; ++i)
        for (slong k = i; k < n; ++k) {
            map.A(i, k) =
                i == k ? Ball(0.9) - Ball(i) / 8 : Ball((7 * i + 5 * k) % 11 - 5) / 16; // the eigenvalues are the diagonal
            wide.A(i, k) = widened(map.A(i, k), Ball(off));
            moved.A(i, k) = map.A(i, k) + (i == k ? Ball(off) : Ball(0));
        }
    const std::vector<Ball> of_map = multipliers_over_period(map, false), of_wide = multipliers_over_period(wide, false);
    REQUIRE(of_map.size() == n);
    for (slong i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Ball truth = Ball(0.9) - Ball(i) / 8;
        CHECK((of_map[k] - truth).may_vanish());
        CHECK(of_map[k].radius() < 1e-12);
        CHECK((arb_contains(of_wide[k].a, (truth - Ball(off)).a) != 0 && arb_contains(of_wide[k].a, (truth + Ball(off)).a) != 0));
        CHECK(of_wide[k].radius() < 1000 * off); // the vectors are not orthogonal
    }
    CHECK(!(multipliers_over_period(moved, false).front() - Ball(0.9)).may_vanish()); // the test would tell
    for (slong i = 0; i < n; ++i)
        for (slong k = 0; k < n; ++k) wide.A(i, k) = widened(i == k ? map.A(i, k) : Ball(0), Ball(off));
    const Ball of_first = multipliers_over_period(wide, false).front(),
               tenth = widened(middle(of_first), Ball(of_first.radius() / 10));
    CHECK(arb_contains(tenth.a, (Ball(0.9) + Ball(off)).a) == 0); // a tenth of the bound would be none
}

TEST_CASE("multipliers that may meet are held also where they do", "[reference][proof]") {
    const Bits all(192);
    MapOfDeviations map{BallMatrix(2, 2), false}; // with -1e-10 below the diagonal both are 1/2 + 5e-10
    map.A(0, 0) = Ball(0.5);
    map.A(0, 1) = Ball(25) / Ball(10'000'000'000);
    map.A(1, 0) = widened(Ball(0), Ball(1) / Ball(10'000'000'000));
    map.A(1, 1) = Ball(0.5) + Ball(1) / Ball(1'000'000'000);
    for (const Ball& size : multipliers_over_period(map, false))
        CHECK((size - Ball(0.5) - Ball(1) / Ball(2'000'000'000)).may_vanish());
}

TEST_CASE("balls about multipliers hold what double rounds off", "[reference][proof]") {
    const Bits all(192);
    std::mt19937 random(11);
    std::uniform_int_distribution<int> some(-9, 9);
    double tightest = 1; // distance of the truth from the middle, in units of the radius: the bound is no excuse
    for (int n = 0; n < 300; ++n) {
        BallMatrix D(3, 3), T = unit_matrix(3), inverse = unit_matrix(3); // T has whole numbers, and so has its inverse
        for (slong i = 0; i < 3; ++i) D(i, i) = Ball(3 * i + 1) / Ball(10);
        for (int turn = 0; turn < 4; ++turn) {
            BallMatrix E = unit_matrix(3), back = E;
            const slong row = turn % 3;
            E(row, (row + 1) % 3) = Ball(some(random));
            back(row, (row + 1) % 3) = -E(row, (row + 1) % 3);
            T = T * E;
            inverse = back * inverse;
        }
        const std::vector<Ball> sizes = multipliers_over_period({T * D * inverse, false}, false);
        for (slong i = 0; i < 3; ++i) {
            const Ball off = sizes[static_cast<std::size_t>(2 - i)] - D(i, i);
            CHECK(off.may_vanish());
            CHECK(off.radius() < 1e-9);
            tightest = std::min(tightest, 1 - std::abs(static_cast<double>(off)) / off.radius());
        }
    }
    CHECK(tightest < 0.9);
    for (const double e : {1e-9, 3e-9, 0x1p-28, 5e-9}) { // in double the eigenvalues are 1 and 1/2
        MapOfDeviations map{BallMatrix(2, 2), false};
        map.A(0, 0) = Ball(1);
        map.A(0, 1) = map.A(1, 0) = Ball(e);
        map.A(1, 1) = Ball(0.5);
        const Ball root = sqrt(Ball(0.0625) + Ball(e) * Ball(e));
        const std::vector<Ball> sizes = multipliers_over_period(map, false);
        CHECK((sizes.front() - Ball(0.75) - root).may_vanish());
        CHECK((sizes.back() - Ball(0.75) + root).may_vanish());
    }
}

TEST_CASE("of a stable and an unstable map the right one is told", "[reference][proof]") {
    MapOfDeviations map{BallMatrix(2, 2), false};
    map.A(0, 0) = Ball(0.5);
    map.A(0, 1) = Ball(64);
    map.A(1, 1) = Ball(0.75);
    CHECK(dies_out(map.A));
    CHECK((multipliers_over_period(map, true).front() - Ball(0.5625)).may_vanish());
    map.A(1, 1) = Ball(1.25);
    CHECK(!dies_out(map.A));
    CHECK(multipliers_over_period(map, false).front() > Ball(1));
    map.A(1, 1) = Ball(1);
    CHECK(!dies_out(map.A));
    CHECK(!(multipliers_over_period(map, false).front() > Ball(1)));
}

} // namespace
} // namespace denhartog::tests
