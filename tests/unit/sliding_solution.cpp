#include <complex>

#include "denhartog/number/number_text.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/solve/quantities.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::tests;
using namespace denhartog;

namespace {

Scene<double> sliding() { return three_masses(1.125, 0.125); }

Solution answer(const SceneSource& source, std::optional<int> digits = std::nullopt) {
    return sliding_answer(source, Question{Asked::motion, digits});
}

} // namespace

TEST_CASE("the precision follows from the digits asked for", "[accuracy]") {
    const SceneSource source = scene_source(sliding());
    const std::vector<std::pair<std::optional<int>, const char*>> expected{
        {{}, "double"}, {10, "double"}, {12, "reference"}, {16, "reference"}, {45, "reference"}, {46, "reference"}};
    for (const auto& [digits, precision] : expected) CHECK(answer(source, digits).method.precision == precision);
    CHECK(answer(source, 90).digits_reached);
    CHECK_THROWS_AS(answer(source, 0), InputError);
    CHECK_THROWS_AS(answer(source, most_digits + 1), InputError);
}

TEST_CASE("where double has not the digits more precision is taken and said so", "[accuracy]") {
    // The double next to 1/3 is in double not told from the pole at R = 1/3 of a mode without damping; in 50 digits it is.
    const Scene<double> scene = oscillator(0, 1.0 / 3, 1, 0.125);
    const Solution found = answer(scene_source(scene));
    CHECK(found.method.precision != "double");
    CHECK(found.digits_reached);
    CHECK(in_words(found.method.why).find("in double: ") == 0);
}

TEST_CASE("a friction ratio on a boundary that is known exactly is no open question", "[regime]") {
    const Scene<double> scene = oscillator(0.125, 0.75, 1, 1);
    const Solution found = answer(scene_source(scene));
    CHECK(found.method.precision == "double");
    CHECK(found.regime.regime == Regime::permanent_sticking);
    CHECK_FALSE(found.regime.on_boundary);
}

TEST_CASE("a friction ratio that differs from the boundary by its rounding is decided in more digits", "[regime]") {
    Scene<double> scene = three_masses();
    scene.beta = boundary(sums_of(scene), scene.mu).exact;
    const Solution found = answer(scene_source(scene));
    CHECK(found.method.precision == "reference");
    CHECK_FALSE(found.regime.on_boundary);
    const Scene<Real50> wide_scene = converted<Real50>(scene);
    CHECK((found.regime.regime == Regime::continuous) == (*wide_scene.beta < response(wide_scene).boundary.exact));
}

TEST_CASE("a mass that nothing moves has no amplitude beyond its error bound", "[accuracy]") {
    // Mass 3 hangs on the ground alone: a system in two parts, given by its matrices.
    Scene<double> scene = three_masses();
    scene.system.stiffness_ratios.clear();
    scene.system.stiffness_matrix.resize(3, 3);
    scene.system.stiffness_matrix << 1.625, -0.625, 0, -0.625, 0.625, 0, 0, 0, 1.875;
    scene.beta = 0.03125;
    const Solution found = answer(scene_source(scene));
    CHECK(found.digits_reached);
    const SolvedMass& still = found.masses[2];
    CHECK(still.amplitude.value <= still.amplitude.error);
    CHECK_FALSE(still.phase);
    CHECK(still.amplitude.error < 1e-12);
}

TEST_CASE("a damping matrix that double takes for uncoupled counts in more digits as it was given", "[eq:18][accuracy]") {
    Scene<double> scene = sliding();
    const NonDimensionalMatrices m = matrices_of(scene);
    scene.system.damping_ratios.clear();
    scene.system.damping_matrix = 0.1 * m.M / (1.125 * 1.125) + 0.03 * m.K;
    const Solution found = answer(scene_source(scene));
    CHECK(found.method.precision == "double");
    CHECK(found.digits_reached);
    const Solution more = answer(scene_source(scene), 30);
    CHECK(more.method.precision == "reference");
    CHECK(more.digits_reached);
    for (std::size_t k = 0; k < 3; ++k) check_within(found.masses[k].amplitude, more.masses[k].amplitude);
    // (56) of modes that rounding alone couples is that of the modes, and not (69), which stands for it where they are coupled.
    Scene<double> other = chain({1, 0.4270386714783879, 1.4318314422854959, 0.7084766250547844},
                                {1, 2.4821655187041753, 1.1658029398218572, 0.15781309896140538}, {0, 0, 0, 0}, 1, 3, 1, 1.37, 0);
    const NonDimensionalMatrices of_other = matrices_of(other);
    other.system.damping_ratios.clear();
    other.system.damping_matrix = 0.01 * of_other.M + 0.02 * of_other.K;
    const Solution less = answer(scene_source(other)), most = answer(scene_source(other), 30);
    REQUIRE(less.limits);
    REQUIRE(most.limits);
    CHECK(less.method.precision == "double");
    check_within(less.limits->paper, most.limits->paper);
    CHECK(most.limits->paper.value < most.limits->exact.value * (1 - 1e-4));
}

TEST_CASE("of modes that coincide in double alone the damping matrix chooses the shapes, to any number of digits",
          "[eq:18][accuracy]") {
    // The dashpot between the masses is all that couples them.
    const Scene<double> scene = named_scene("one frequency in double");
    const std::complex<double> own(1 - 0.875 * 0.875, 0.25 * 0.875), between(0, -0.125 * 0.875);
    const double amplitude = std::abs(between / (own * own - between * between));
    for (const int digits : {6, 12, 30}) {
        const Solution found = answer(scene_source(scene), digits);
        CHECK(found.regime.regime == Regime::continuous);
        CHECK(found.masses[0].amplitude.value == Approx(amplitude).epsilon(1e-13));
    }
    CHECK(solve(scene_source(scene), {.digits = 30}).masses[0].amplitude.value == Approx(amplitude).epsilon(1e-13));
}

TEST_CASE("a soft mode that double knows to few digits has its damping to all digits in fifty", "[eq:18][accuracy]") {
    // Double has the square of the soft frequency to an eps of the stiff one's, and the damping ratio with it; the mode's impedance
    // is its dashpot's. The off-diagonal entry leaves the modes uncoupled in double alone, and changes nothing to 20 digits.
    Scene<double> scene = named_scene("soft mode");
    const Matrix<double>&K = scene.system.stiffness_matrix, &C = scene.system.damping_matrix;
    const Real50 r(*scene.r), stiff(K(0, 0)), soft(K(1, 1)), between(K(0, 1)), c(C(0, 0));
    const Complex<Real50> impedance{Real50(soft - r * r), Real50(r * c)}, other{Real50(stiff - r * r), Real50(r * c)};
    const Real50 of_other = between * between / (other.re * other.re + other.im * other.im);
    const Complex<Real50> loaded{Real50(impedance.re - of_other * other.re), Real50(impedance.im + of_other * other.im)};
    const Solution found = answer(scene_source(scene), 30);
    CHECK(found.method.precision == "reference");
    CHECK(abs(Real50(Real50(found.masses[1].amplitude.decimal) * modulus(loaded) - 1)) < 1e-20);
    // Where the contact rests the other mass moves by the matrix as it was given.
    scene.system.contact = Mass{0};
    scene.beta = 1;
    const Solution held = solve(scene_source(scene), {.digits = 30});
    REQUIRE(held.regime.regime == Regime::permanent_sticking);
    CHECK(abs(Real50(Real50(held.masses[1].amplitude.decimal) * modulus(impedance) - 1)) < 1e-29);
}

TEST_CASE("an instant next to the end of the half-period has a bound that reaches across it", "[accuracy][eq:52]") {
    // Of mass 4 double does not tell whether the largest displacement is 2.3e-23 before the end, or after the start.
    Scene<double> scene =
        chain({1, 1, 1, 1, 1, 1},
              {1, 4.1795810742721903e-08, 163576085587.22034, 7289899.392812684, 0.0016169929745514513, 5.614267367806852e-06},
              std::vector<double>(6, 0.0005109246153637409), 3, 6, 1, 9.316786434530164e-10);
    scene.beta = 0;
    const Solution few = answer(scene_source(scene));
    const Response<Real50> many = response(converted<Real50>(scene));
    for (std::size_t k = 0; k < 6; ++k) {
        const Certified& a = few.masses[k].sliding->instant;
        const Real50& b = many.steady_state->masses[k].instant;
        Real50 apart = abs(Real50(Real50(a.value) - b));
        apart = std::min(apart, Real50(pi<Real50>() - apart));
        INFO("mass " << k + 1 << ": " << a.value << ", " << b);
        CHECK(apart <= Real50(a.error) + Real50("1e-20"));
    }
}

TEST_CASE("next to a friction ratio at which a phase jumps, its bound holds or reaches to the other maximum",
          "[accuracy][eq:47]") {
    // Mass 1 has two largest displacements at some 0.17523764091237618; their phases are 2.709 and 0.944.
    Scene<double> scene = named_scene("phase that jumps");
    const double jump = 0.17523764091237618;
    for (const double apart : {-1e-6, -1e-14, -1e-16, 1e-16, 1e-14, 1e-6}) {
        scene.beta = jump * (1 + apart);
        const Solution low = answer(scene_source(scene), 10), high = answer(scene_source(scene), 40);
        INFO("beta = " << hexadecimal(*scene.beta) << ", phase " << low.masses[0].phase->value << ", to 40 digits "
                       << high.masses[0].phase->value);
        check_within(*low.masses[0].phase, *high.masses[0].phase);
        CHECK(low.masses[0].phase->error < 1e-10);
        check_within(low.masses[0].amplitude, high.masses[0].amplitude);
        CHECK(std::abs(low.masses[0].amplitude.value - 0.3469650429) < 1e-6);
    }
    scene.beta = jump * (1 - 1e-6);
    CHECK(std::abs(answer(scene_source(scene), 10).masses[0].phase->value - 2.709) < 1e-3);
    CHECK(answer(scene_source(scene), 10).method.precision == "double");
    scene.beta = jump * (1 + 1e-6);
    CHECK(std::abs(answer(scene_source(scene), 10).masses[0].phase->value - 0.944) < 1e-3);

    // The two agree to all of 50 digits; 100 digits tell them apart.
    const auto instant = [&](const Real50& beta) {
        const Scene<Real50> wide = converted<Real50>(scene);
        const ModeSums<Real50> sums = mode_sums(modal_basis(wide.system), wide.system.contact, wide.system.load, *wide.r);
        return steady_state(sums, {Real50(beta + 1), {}}, beta, Mass{0}).masses[0].instant;
    };
    Real50 below = Real50(jump) * (1 - Real50(1e-12)), above = Real50(jump) * (1 + Real50(1e-12));
    const Real50 left = instant(below);
    CHECK(abs(Real50(instant(above) - left)) > 1);
    for (int n = 0; n < 115; ++n) {
        const Real50 middle = (below + above) / 2;
        (abs(Real50(instant(middle) - left)) < Real50(0.1) ? below : above) = middle;
    }
    const auto at = [](const Real50& beta, int digits) {
        return answer(named_source(R"(phase that jumps {"beta": ")" + number_to_text(beta) + "\"}"), digits);
    };
    const Solution closest = at(below, 10);
    CHECK(closest.method.precision == "reference");
    CHECK(closest.digits_reached);

    // Nearer and nearer, from both sides: the two displacements are the same to all digits of double, and one is found first.
    for (const char* apart : {"1e-18", "1e-24", "1e-36", "1e-45", "1e-47", "1e-48", "1e-49"})
        for (const int side : {-1, 1}) {
            const Real50 beta = below * (1 + side * Real50(apart));
            const Solution low = at(beta, 10), high = at(beta, 60);
            INFO("apart by " << apart << ", side " << side);
            check_within(*low.masses[0].phase, *high.masses[0].phase);
            CHECK(low.masses[0].phase->error < 1e-10);
        }
}

TEST_CASE("far off in frequency the motion is known whose boundary is no number in double", "[solve][eq:69]") {
    const Scene<double> scene = oscillator(0, 3.5e225, 1, 0.0009); // below 0.537, which is a quotient of 0 and 0 in double
    const std::vector<double> tau{0, 1};
    for (const int digits : {6, 15}) {
        const QuantitiesAnswer found = quantities(scene_source(scene), tau, digits, PointNumbers::motion);
        CHECK(found.method.precision == "reference");
        CHECK(found.numbers.beta_lim.x == Approx(0.537029272146));
        REQUIRE(found.numbers.X_j);
        CHECK(found.numbers.x.size() == 2);
    }
}

TEST_CASE("a boundary that is no number in double is one of the reference, and refused of more than 100 masses",
          "[solve][eq:69]") {
    Scene<double> scene;
    const auto with_masses = [&](std::size_t N) {
        scene.system = chain_of(std::vector<double>(N, 1.0), std::vector<double>(N, 1.0), 0.01, 36, 12);
    };
    scene.r = 1e200;
    for (const bool with_beta : {false, true}) {
        if (with_beta) scene.beta = 0.5;
        with_masses(41);
        for (const std::optional<int> digits : {std::optional<int>(), std::optional<int>(10)}) {
            const Solution by_reference = answer(scene_source(scene), digits);
            CHECK(by_reference.method.precision == "reference");
            REQUIRE(by_reference.limits);
            CHECK(by_reference.limits->exact.value >= 0);
            CHECK(by_reference.limits->exact.error < 1e-40);
        }
        with_masses(101);
        CHECK_THROWS_WITH(answer(scene_source(scene)), Catch::Contains("beyond the range of the number type"));
    }
    CHECK_THROWS_AS(solve(scene_source(scene), {Asked::motion, std::nullopt}), PrecisionError);
    CHECK_THROWS_AS(solve(scene_source(scene), {Asked::regime, std::nullopt}), PrecisionError);
}

TEST_CASE("the bound of an instant takes in that a fast mode turns over the last step to it", "[solve][eq:47]") {
    const SceneSource source = scene_source(named_scene("fast turn"));
    const Solution few = answer(source);
    const Response<Real100> many = response(converted<Real100>(source->in_double()));
    for (std::size_t k = 0; k < few.masses.size(); ++k) {
        INFO("mass " << k + 1);
        const Certified &instant = few.masses[k].sliding->instant, &phase = *few.masses[k].phase;
        const MassResponse<Real100>& of_mass = many.steady_state->masses[k];
        const auto truth = static_cast<double>(of_mass.instant);
        const double off = std::abs(instant.value - truth);
        CHECK(std::min(off, pi<double>() - off) <= instant.error + 2.3e-16 * truth); // the rounding of the other
        const auto true_phase = static_cast<double>(of_mass.phase);
        CHECK(std::abs(std::remainder(phase.value - true_phase, 2 * pi<double>())) <= phase.error + 8e-16);
    }
}

TEST_CASE("forty masses with dashpots are answered to 30 digits within the work allowed", "[solve][coupled_damping][effort]") {
    constexpr std::size_t N = 40;
    std::vector<double> dashpots(N, 0.1);
    for (std::size_t i = 0; i < N; i += 3) dashpots[i] = 0.3;
    const std::vector<double> ones(N, 1), none;
    Scene<double> scene = scene_of(chain_of(ones, ones, none, 20, 1), 0.3, 0.01);
    scene.system.damping_matrix = matrix_of_chain(dashpots);
    const Solution in_double = answer(scene_source(scene)), by_reference = answer(scene_source(scene), 30);
    CHECK(by_reference.digits_reached);
    CHECK(by_reference.method.precision == "reference");
    for (std::size_t k = 0; k < N; ++k) {
        const Certified &few = in_double.masses[k].amplitude, &many = by_reference.masses[k].amplitude;
        CHECK(std::abs(few.value - many.value) <= few.error + 2.3e-16 * many.value);
    }
}

TEST_CASE("where nothing bounds an amplitude its bound is infinite, and never no number", "[solve]") {
    // Far above all frequencies the masses far from the load move by less than 50 digits tell.
    const SceneSource source = scene_source(named_scene(R"(far above {"contact": [5, 1], "mu": 1})"));
    for (const std::optional<int> digits : {std::optional<int>(), std::optional<int>(30)})
        for (const SolvedMass& mass : answer(source, digits).masses) CHECK(mass.amplitude.error >= 0);
}

TEST_CASE("the turn of a phase by an error keeps its digits however large or small the amplitude is", "[unit]") {
    for (const double amplitude : {1e-200, 1.0, 1e200}) {
        CHECK(largest_turn(1e-10 * amplitude, amplitude) == Approx(1e-10).epsilon(1e-14)); // squares would be 0 or infinite
        CHECK(largest_turn(0.5 * amplitude, amplitude) == Approx(pi<double>() / 6).epsilon(1e-15));
    }
    CHECK(abs(largest_turn(Real50("0.5"), Real50(1)) - pi<Real50>() / 6) < Real50("1e-49"));
}

namespace {

Solution bounded_point(const Scene<double>& scene) { return sliding_solution(scene_source(scene), {}); }

} // namespace

TEST_CASE("error bounds known beforehand hold on random systems", "[eq:38][eq:69][accuracy]") {
    int number = 0, compared = 0;
    for (const RandomScene<double>& each : random_scenes<double>(17)) {
        Scene<double> scene = each.scene;
        if (scene.system.damping_ratios.empty() || ++number % 16 != 0) continue;
        scene.beta = each.fraction_of_limit * boundary(sums_of(scene), scene.mu).exact;
        const Solution low = bounded_point(scene);
        const Response<Real50> high = response(converted<Real50>(scene));
        REQUIRE(low.masses.size() == high.steady_state->masses.size());
        ++compared;
        INFO(each.name);
        CHECK(low.relative_error < 1e-6);
        for (std::size_t k = 0; k < high.steady_state->masses.size(); ++k) {
            const SolvedMass& m = low.masses[k];
            CHECK(abs(Real50(m.amplitude.value - high.steady_state->masses[k].amplitude)) <= m.amplitude.error);
            REQUIRE(m.phase);
            CHECK(abs(wrapped(Real50(m.phase->value - high.steady_state->masses[k].phase))) <= m.phase->error);
        }
    }
    CHECK(compared > 15);
}

TEST_CASE("next to the pole of a mode without damping there is no bound, and solve takes more digits", "[domain][accuracy]") {
    for (const double r : {1.0 / 3, 1.0 / 3 * (1 + 0x1p-50), 1 + 0x1p-52}) {
        Scene<double> scene = oscillator(0, r);
        scene.beta = 0.001;
        double relative = std::numeric_limits<double>::infinity();
        try {
            relative = bounded_point(scene).relative_error;
        } catch (const DomainError&) {
        } catch (const PrecisionError&) {
        }
        INFO("r = " << hexadecimal(r));
        CHECK(relative > 0.01);
    }
}

TEST_CASE("phases at frequencies far below all natural ones keep their bounds, at the ends of the half-period too",
          "[eq:47][accuracy]") {
    for (const double r : {1e-9, 1e-7, 1e-5, 1e-3})
        for (const double part : {0.0, 0.5}) {
            Scene<double> scene = chain({1, 1}, {1, 1}, {0.05, 0.05}, 2, 1, 1, r);
            scene.beta = part * boundary(sums_of(scene), 1.0).exact;
            const Solution low = bounded_point(scene);
            const Response<Real100> high = response(converted<Real100>(scene));
            REQUIRE(low.masses.size() == 2);
            for (std::size_t k = 0; k < 2; ++k) {
                REQUIRE(low.masses[k].phase);
                const Certified& phase = *low.masses[k].phase;
                INFO("r = " << r << ", beta = " << *scene.beta << ", mass " << k + 1 << ", bound " << phase.error);
                CHECK(abs(wrapped(Real100(Real100(phase.value) - high.steady_state->masses[k].phase))) <= Real100(phase.error));
                // With friction the modes ring: at r = 1e-9 the maxima of that ripple differ by less than double can tell.
                CHECK(phase.error < (part > 0 && r == 1e-9 ? 1e-7 : 1e-12));
                const Certified sure = *solve(scene_source(scene), {Asked::phase, 12}).masses[k].phase;
                CHECK(sure.error < 1e-12);
                CHECK(abs(wrapped(Real100(Real100(sure.value) - high.steady_state->masses[k].phase))) <= Real100(sure.error));
            }
        }
}
