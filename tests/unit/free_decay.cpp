// The motion without a load until the contact rests for good, and what a constant load does: by the textbook, by Runge-Kutta, by
// the motion without the load.

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;

namespace {

Scene<double> free_scene(System<double> system, double beta, double mu = 1) { return {std::move(system), mu, 1.0, beta, {}, {}}; }

bool holds(const Certified& x, double value, double slack = 0) { return std::abs(x.value - value) <= x.error + slack; }

// A free motion in the coordinates of the masses, by Runge-Kutta of fourth order in short steps; each event is bisected.
struct SteppedDecay {
    Eigen::MatrixXd M, C, K;
    Eigen::VectorXd w, s;
    double F, mu;
    Eigen::VectorXd x, v;
    double t = 0;
    std::vector<std::pair<double, double>> turns{}; // instant and displacement of the contact
    std::vector<std::pair<double, double>> stops{}; // from, to
    bool rests = false;

    [[nodiscard]] Eigen::VectorXd forces(const Eigen::VectorXd& at, const Eigen::VectorXd& speed) const {
        return s - K * at - C * speed;
    }
    [[nodiscard]] double load(const Eigen::VectorXd& at, const Eigen::VectorXd& speed) const {
        const Eigen::VectorXd a = M.ldlt().solve(forces(at, speed)), of_w = M.ldlt().solve(w);
        return w.dot(a) / w.dot(of_w);
    }
    [[nodiscard]] Eigen::VectorXd acceleration(int direction, const Eigen::VectorXd& at, const Eigen::VectorXd& speed) const {
        const double friction = direction == 0 ? load(at, speed) : direction * F;
        return M.ldlt().solve(forces(at, speed) - friction * w);
    }
    void step(int direction, double h) {
        const Eigen::VectorXd v1 = v, a1 = acceleration(direction, x, v1);
        const Eigen::VectorXd v2 = v + h / 2 * a1, a2 = acceleration(direction, x + h / 2 * v1, v2);
        const Eigen::VectorXd v3 = v + h / 2 * a2, a3 = acceleration(direction, x + h / 2 * v2, v3);
        const Eigen::VectorXd v4 = v + h * a3, a4 = acceleration(direction, x + h * v3, v4);
        x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    [[nodiscard]] int set_off() const {
        const double q = load(x, v);
        return std::abs(q) <= mu * F ? 0 : q > 0 ? 1 : -1;
    }
    void follow(double until) {
        constexpr double h = 1.0 / 256;
        int direction = w.dot(v) == 0 ? set_off() : w.dot(v) > 0 ? 1 : -1;
        if (direction == 0) stops.push_back({0, -1});
        const auto guard = [&] { return direction == 0 ? mu * F - std::abs(load(x, v)) : direction * w.dot(v); };
        for (bool fresh = true; t < until;) {
            const Eigen::VectorXd x_0 = x, v_0 = v;
            step(direction, h);
            if (guard() > 0) {
                t += h;
                fresh = false;
                continue;
            }
            double from = fresh && direction != 0 ? h / 1024 : 0, to = h;
            for (int n = 0; n < 50; ++n) {
                const double middle = (from + to) / 2;
                x = x_0, v = v_0;
                step(direction, middle);
                (guard() > 0 ? from : to) = middle;
            }
            t += to;
            if (direction != 0) {
                turns.push_back({t, w.dot(x)});
                direction = set_off();
                if (direction == 0) stops.push_back({t, -1});
            } else {
                stops.back().second = t;
                direction = load(x, v) > 0 ? 1 : -1;
            }
            fresh = true;
        }
        rests = direction == 0;
    }
};

} // namespace

TEST_CASE("one mass without damping loses 2 F / k of its peak in every half-cycle and rests where the spring no longer moves it",
          "[free-decay][eq:74]") {
    for (const double x_0 : {7.25, -12.75, 3.5, 0.5, 40.125}) {
        const FreeDecay motion = free_decay(scene_source(free_scene(chain_of({1}, {1}), 1)), {{x_0}, {0}});
        double peak = std::abs(x_0), side = x_0 > 0 ? 1 : -1;
        std::size_t n = 0;
        for (; peak > 1; ++n) { // F / k = 1
            peak -= 2;
            side = -side;
            REQUIRE(n < motion.turns.size());
            CHECK(holds(motion.turns[n].x, side * peak));
            CHECK(motion.turns[n].x.error <= 1e-14);
            CHECK(holds(motion.turns[n].tau, pi<double>() * static_cast<double>(n + 1), 1e-14));
        }
        CHECK(motion.turns.size() == n);
        CHECK(motion.at_rest);
        CHECK(motion.stops.empty());
        CHECK(holds(motion.rest_at, side * peak));
        CHECK(holds(motion.masses.at(0), side * peak));
        CHECK(motion.rest_at.proved);
        CHECK_FALSE(motion.others_come_to_rest.has_value());
        CHECK_FALSE(motion.on_limit);
    }
}

TEST_CASE("the peaks of one damped mass are those of a linear half-cycle about F / k", "[free-decay]") {
    const double zeta = 0.0625, w = std::sqrt(1 - zeta * zeta), kept = std::exp(-pi<double>() * zeta / w);
    const FreeDecay motion = free_decay(scene_source(free_scene(chain_of({1}, {1}, zeta), 0.5, 1.5)), {{20}, {0}});
    double peak = 20;
    for (std::size_t n = 0; n < motion.turns.size(); ++n) {
        CHECK(peak > 0.75); // static friction
        peak = (peak - 0.5) * kept - 0.5;
        CHECK(holds(motion.turns[n].x, (n % 2 == 0 ? -1 : 1) * peak, 1e-13));
        CHECK(holds(motion.turns[n].tau, static_cast<double>(n + 1) * pi<double>() / w, 1e-13));
    }
    CHECK(motion.turns.size() > 5);
    CHECK(std::abs(peak) <= 0.75);
}

TEST_CASE("where the spring pulls with static friction to all digits the contact sticks, and the answer says so",
          "[free-decay][eq:74]") {
    const FreeDecay motion = free_decay(scene_source(free_scene(chain_of({1}, {1}), 1)), {{5}, {0}});
    CHECK(motion.on_limit);
    REQUIRE(motion.turns.size() == 2);
    CHECK(holds(motion.rest_at, 1));
    const FreeDecay beside = free_decay(scene_source(free_scene(chain_of({1}, {1}), 1)), {{5 + 0x1p-40}, {0}});
    CHECK_FALSE(beside.on_limit);
    CHECK(beside.turns.size() == 3);
}

TEST_CASE("the free motion of several masses is that of Runge-Kutta in their coordinates, and the rest lasts",
          "[free-decay][seeded]") {
    std::mt19937 random(61);
    const auto from = [&](double a, double b) { return a + (b - a) * static_cast<double>(random()) / 4294967295.0; };
    int with_stops = 0;
    for (int n = 0; n < 16; ++n) {
        const std::size_t N = 2 + random() % 2;
        std::vector<double> gamma{1}, kappa{1}, c;
        for (std::size_t k = 1; k < N; ++k) {
            gamma.push_back(from(0.5, 2));
            kappa.push_back(from(0.5, 2));
        }
        for (std::size_t k = 0; k < N; ++k) c.push_back(from(0.05, 0.2));
        System<double> system = chain_of(gamma, kappa, 0, 1 + random() % N);
        system.damping_ratios.clear();
        system.damping_matrix = matrix_of_chain(c);
        if (n % 3 == 0) {
            system.contact = Mass{1};
            system.contact_with = Mass{0};
        }
        Scene<double> scene = free_scene(system, 1, n % 2 == 0 ? 1 : 1.25);
        if (n % 4 == 1)
            for (std::size_t k = 0; k < N; ++k) scene.static_load.push_back(from(-2, 2));
        State start = at_rest(N);
        for (std::size_t k = 0; k < N; ++k) {
            start.x[k] = from(-8, 8);
            start.x_prime[k] = n % 2 == 0 ? 0 : from(-3, 3);
        }
        INFO("scene " << n);
        const FreeDecay motion = free_decay(scene_source(scene), start);
        const auto column = [](const std::vector<double>& x) {
            return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
        };
        SteppedDecay stepped{mass_matrix(system),
                             system.damping_matrix,
                             stiffness_matrix(system),
                             column(contact_vector(system)),
                             scene.static_load.empty() ? Eigen::VectorXd(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(N)))
                                                       : column(scene.static_load),
                             1,
                             scene.mu,
                             column(start.x),
                             column(start.x_prime)};
        stepped.follow(motion.rest_from.value + 40);
        CHECK(stepped.rests);
        REQUIRE(motion.turns.size() == stepped.turns.size());
        for (std::size_t k = 0; k < motion.turns.size(); ++k) {
            CHECK(holds(motion.turns[k].tau, stepped.turns[k].first, 1e-7));
            CHECK(holds(motion.turns[k].x, stepped.turns[k].second, 1e-7));
        }
        REQUIRE(motion.stops.size() + 1 == stepped.stops.size());
        for (std::size_t k = 0; k < motion.stops.size(); ++k) {
            CHECK(holds(motion.stops[k].start, stepped.stops[k].first, 1e-7));
            CHECK(holds(motion.stops[k].end, stepped.stops[k].second, 1e-6));
        }
        with_stops += !motion.stops.empty();
        REQUIRE(motion.others_come_to_rest.has_value());
        CHECK(*motion.others_come_to_rest);
        // At rest the springs and the constant forces leave a load on the contact alone, which friction holds.
        Eigen::VectorXd at(static_cast<Eigen::Index>(N));
        for (std::size_t k = 0; k < N; ++k) at(static_cast<Eigen::Index>(k)) = motion.masses[k].value;
        const Eigen::VectorXd left = stepped.s - stepped.K * at;
        const double held = left.dot(stepped.w) / stepped.w.squaredNorm();
        CHECK((left - held * stepped.w).norm() <= 1e-13);
        CHECK(std::abs(held) <= scene.mu);
    }
    CHECK(with_stops > 3);
}

TEST_CASE("a mass that nothing damps vibrates for ever beside a contact at rest, or sets it in motion again and again",
          "[free-decay]") {
    const Scene<double> scene = free_scene(chain_of({1, 1}, {1, 1}), 1);
    const FreeDecay held = free_decay(scene_source(scene), {{0, 0.5}, {0, 0}});
    CHECK(held.at_rest);
    CHECK(held.turns.empty());
    REQUIRE(held.others_come_to_rest.has_value());
    CHECK_FALSE(*held.others_come_to_rest);
    // The spring pulls on the held contact with up to 1.25 F: it slips, a little less each time, and no rest is for good.
    const FreeDecay moved = free_decay(scene_source(scene), {{0, 1.25}, {0, 0}}, 200);
    CHECK_FALSE(moved.at_rest);
    CHECK(moved.turns.size() > 5);
    CHECK(moved.masses.empty());
    QuestionEffort little(2, 300000);
    REQUIRE_THROWS_AS(free_decay(with_effort(scene_source(scene), &little), {{0, 1.25}, {0, 0}}), PrecisionError);
}

TEST_CASE("a rest is for good as long as the others cannot load the contact with static friction, and not a billionth beyond",
          "[free-decay][eq:74][eq:75]") {
    const SceneSource source = scene_source(free_scene(chain_of({1, 1}, {1, 1}), 1));
    const FreeDecay below = free_decay(source, {{0, 0}, {0, 1 - 1e-9}}); // a spring of 1 that swings by that
    CHECK(below.at_rest);
    CHECK(below.turns.empty());
    CHECK(below.rest_from.value == 0);
    const FreeDecay above = free_decay(source, {{0, 0}, {0, 1 + 1e-9}}, 2 * pi<double>());
    CHECK(above.turns.size() + above.stops.size() > 0);
    CHECK(above.stops.at(0).start.value == 0);
    CHECK(holds(above.stops.at(0).end, pi<double>() / 2, 1e-4));
}

TEST_CASE("a free motion with a broken start, or without friction, is refused by name", "[free-decay][bad-input]") {
    const SceneSource source = scene_source(free_scene(chain_of({1, 1}, {1, 1}), 1));
    for (const State& start :
         {State{{0}, {0, 0}}, State{{0, 0}, {0}}, State{{std::nan(""), 0}, {0, 0}}, State{{0, 0}, {INFINITY, 0}}}) {
        try {
            (void)free_decay(source, start);
            FAIL("it was taken");
        } catch (const InputError& e) {
            CHECK(e.quantity == "start");
        }
    }
    REQUIRE_THROWS_AS(free_decay(scene_source(free_scene(chain_of({1}, {1}), 0)), {{1}, {0}}), InputError);
}

TEST_CASE("a constant load moves every motion by K^-1 s and changes nothing else, in every regime",
          "[static-load][eq:6][eq:74][eq:75]") {
    std::mt19937 random(74);
    const auto from = [&](double a, double b) { return a + (b - a) * static_cast<double>(random()) / 4294967295.0; };
    int regimes[3] = {};
    for (int n = 0; n < 24; ++n) {
        const std::size_t N = 1 + random() % 3;
        std::vector<double> gamma{1}, kappa{1};
        for (std::size_t k = 1; k < N; ++k) {
            gamma.push_back(from(0.5, 2));
            kappa.push_back(from(0.5, 2));
        }
        System<double> system = chain_of(gamma, kappa, from(0.02, 0.1), 1 + random() % N, 1 + random() % N);
        if (N > 1 && n % 3 == 0) {
            system.contact = Mass{1};
            system.contact_with = Mass{0};
        }
        Scene<double> plain{system, n % 2 == 0 ? 1 : 1.25, from(0.2, 1.5), n % 4 == 3 ? 3.0 : from(0.05, 0.8), {}, {}},
            loaded = plain;
        for (std::size_t k = 0; k < N; ++k) loaded.static_load.push_back(from(-4, 4));
        const std::vector<Certified> places = place_of_rest(scene_source(loaded));
        REQUIRE(places.size() == N);
        CHECK(place_of_rest(scene_source(plain)).empty());
        const Matrix<double> K = stiffness_matrix(system);
        for (std::size_t k = 0; k < N; ++k) {
            double force = 0;
            for (std::size_t i = 0; i < N; ++i) force += K(k, i) * places[i].value;
            CHECK(force == Approx(loaded.static_load[k]).margin(1e-13));
            CHECK(places[k].proved);
            CHECK(places[k].error <= 1e-14);
        }
        PaperSettings settings;
        settings.cycles = 12;
        settings.samples = 16;
        settings.absolute_tolerance = 1e-11;
        PaperSettings moved = settings;
        moved.start = at_rest(N);
        for (std::size_t k = 0; k < N; ++k) moved.start->x[k] = places[k].value;
        for (const bool exact : {true, false}) {
            INFO("scene " << n << (exact ? ", exact" : ", paper"));
            const PaperMotion a = exact ? exact_cycles(scene_source(plain), settings) : paper_algorithm(plain, settings);
            const PaperMotion b = exact ? exact_cycles(scene_source(loaded), moved) : paper_algorithm(loaded, moved);
            const double tolerance = exact ? 1e-11 : 1e-7;
            REQUIRE(a.stops.size() == b.stops.size());
            REQUIRE(regime_seen(a) == regime_seen(b));
            ++regimes[static_cast<int>(regime_seen(a))];
            for (std::size_t k = 0; k < a.stops.size() && !a.rests; ++k) {
                CHECK(a.stops[k].start == Approx(b.stops[k].start).margin(100 * tolerance));
                CHECK(a.stops[k].end == Approx(b.stops[k].end).margin(100 * tolerance));
            }
            for (std::size_t at = 0; at < a.samples.size(); ++at)
                for (std::size_t k = 0; k < N; ++k) {
                    CHECK(b.samples[at].x[k] - places[k].value == Approx(a.samples[at].x[k]).margin(tolerance));
                    CHECK(b.samples[at].x_prime[k] == Approx(a.samples[at].x_prime[k]).margin(tolerance));
                }
        }
    }
    for (const int seen : regimes) CHECK(seen > 0);
}
