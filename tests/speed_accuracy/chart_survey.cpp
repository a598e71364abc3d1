#include "tests/speed_accuracy/chart_survey.hpp"

#include <algorithm>
#include <ctime>
#include <random>

#include "denhartog/sliding/boundary.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/paper_systems.hpp"
#include "tests/support/sample_scenes.hpp"

namespace denhartog::tests {
namespace {

/// Numbers from 0 to 1 that do not depend on the platform.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : engine_(seed) {}
    double between(double from, double to) { return from + (to - from) * static_cast<double>(engine_() >> 11) * 0x1p-53; }

private:
    std::mt19937_64 engine_;
};

double beta_lim(const System<double>& system, double r) {
    return boundary(mode_sums(modal_basis(system), system.contact, system.load, r), 1.0).exact;
}

// Points that slide, at 1/64 to 63/64 of the boundary.
ChartScene sliding(const std::string& name, const System<double>& system, double from, double to, int points, Draw& draw) {
    ChartScene scene{name, system, {}};
    while (static_cast<int>(scene.points.size()) < points) {
        const double r = draw.between(from, to), limit = beta_lim(system, r);
        if (limit > 0) scene.points.push_back({r, friction_ratio_at(draw.between(1.0 / 64, 63.0 / 64), limit)});
    }
    return scene;
}

} // namespace

std::vector<ChartScene> chart_scenes(std::uint64_t seed, int points) {
    Draw draw(seed);
    std::vector<ChartScene> scenes{sliding("SDOF, sliding", single_mass(0.1), 0.3, 2.5, points, draw)};
    ChartScene stick_slip{"SDOF, stick-slip", single_mass(0.01), {}};
    const double limit = beta_lim(stick_slip.system, 0.1);
    for (int n = 0; n < points; ++n) stick_slip.points.push_back({0.1, draw.between(limit + 0.01, 0.95)});
    scenes.push_back(stick_slip);
    ChartScene sweep{"2DOF, all regimes", two_masses(0.01), {}};
    for (int n = 0; n < 2 * points; ++n) sweep.points.push_back({0.1 + 2.9 * (n + 0.5) / (2 * points), 0.3});
    scenes.push_back(sweep);
    scenes.push_back(sliding("5DOF, j = 3, l = 1", five_masses<double>(3, 0.1), 0.3, 1.9, points, draw));
    const System<double> long_chain = equal_chain<double>(50, 10, 1, std::vector<double>(50, 0.05));
    scenes.push_back(sliding("N = 50", long_chain, 0.3, 1.9, std::max(1, points / 4), draw));
    return scenes;
}

namespace {

Real100 whole(const PeerAnswer& answer) {
    Real100 sum(answer.amplitude);
    for (const double part : answer.beyond) sum += Real100(part);
    return sum;
}

ChartTruth solved(const System<double>& system, const ChartPoint& point, int digits) {
    Scene<double> scene;
    scene.system = system;
    scene.r = point.r;
    scene.beta = point.beta;
    const Solution s = solve(scene_source(scene), {Asked::amplitude, digits, false, system.contact});
    ChartTruth truth;
    truth.regime = s.regime.regime;
    truth.answer.sticks = truth.regime != Regime::continuous;
    const Certified& X_j = s.masses.front().amplitude;
    set_amplitude(truth.answer, X_j.decimal.empty() ? Real100(X_j.value) : Real100(X_j.decimal));
    return truth;
}

} // namespace

ChartTruth truth_at(const System<double>& system, const ChartPoint& point) {
    ChartTruth truth = solved(system, point, 40);
    if (truth.regime == Regime::permanent_sticking) return truth;
    constexpr double step = 0x1p-20;
    for (const bool of_r : {true, false}) {
        const auto moved = [&](double by) {
            return ChartPoint{of_r ? point.r * (1 + by) : point.r, of_r ? point.beta : point.beta * (1 + by)};
        };
        const Real100 change = whole(solved(system, moved(step), 20).answer) - whole(solved(system, moved(-step), 20).answer);
        truth.condition += std::abs(static_cast<double>(change / whole(truth.answer))) / (2 * step);
    }
    return truth;
}

double error_of(const PeerAnswer& answer, const ChartTruth& truth) {
    if (truth.regime == Regime::permanent_sticking) return 0;
    const Real100 exact = whole(truth.answer);
    return std::max(1e-36, std::abs(static_cast<double>((whole(answer) - exact) / exact)));
}

namespace {

double processor_time() { return 1e6 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <class T>
T median(std::vector<T> x) {
    if (x.empty()) return T(0);
    std::ranges::sort(x);
    return x[x.size() / 2];
}

/// Microseconds a run: the first run says how many fill a millisecond; up to five times that, or one run where it is long.
struct Timing {
    double time = 0;
    int repeats = 1;
};

Timing timing_of(const std::function<void()>& run) {
    double start = processor_time();
    run();
    const double first = processor_time() - start;
    if (first > 2e4) return {first, 1};
    const int runs = std::max(1, static_cast<int>(1000 / std::max(first, 0.1)));
    std::vector<double> times;
    for (int n = 0; n < 5; ++n) {
        start = processor_time();
        for (int m = 0; m < runs; ++m) run();
        times.push_back((processor_time() - start) / runs);
    }
    return {median(times), 5};
}

constexpr std::size_t did_not_finish = 0, stalled = 1, wrong_regime = 2, not_a_number = 3, outside_domain = 4;

std::size_t failure_of(Ending ending) {
    switch (ending) {
    case Ending::answered: break;
    case Ending::did_not_finish: return did_not_finish;
    case Ending::stalled: return stalled;
    case Ending::not_a_number: return not_a_number;
    case Ending::outside_domain: return outside_domain;
    }
    return wrong_regime;
}

PeerAnswer answer_of(const std::function<PeerAnswer(const ChartPoint&)>& method, const ChartPoint& point) {
    PeerAnswer answer;
    try {
        answer = method(point);
    } catch (const DomainError&) {
        answer.ending = Ending::outside_domain;
    } catch (const PrecisionError&) {
        answer.ending = Ending::did_not_finish;
    }
    if (answer.ending == Ending::answered && !std::isfinite(answer.amplitude)) answer.ending = Ending::not_a_number;
    return answer;
}

// One exponential, sine and cosine a mode, of arguments as the modes have them.
double bare_time(std::size_t N) {
    volatile double argument = 0.7, sink = 0;
    return timing_of([&] {
               double sum = 0;
               for (std::size_t i = 0; i < N; ++i) {
                   const double x = argument + static_cast<double>(i) / 64;
                   sum += std::exp(-x) + std::sin(x) * std::cos(x);
               }
               sink = sum;
           })
        .time;
}

} // namespace

const std::array<std::string, 5>& failure_names() {
    static const std::array<std::string, 5> names{"did not finish", "stalled", "wrong regime", "not a number",
                                                  "outside its domain"};
    return names;
}

ChartGround ground_of(const ChartScene& scene) {
    ChartGround ground{scene, {}, 0, 0, bare_time(number_of_masses(scene.system))};
    std::vector<double> conditions;
    for (const ChartPoint& point : scene.points) {
        ground.truth.push_back(truth_at(scene.system, point));
        if (ground.truth.back().regime != Regime::permanent_sticking) conditions.push_back(ground.truth.back().condition);
    }
    ground.condition_median = median(conditions);
    ground.condition_worst = conditions.empty() ? 0 : std::ranges::max(conditions);
    return ground;
}

ChartRow measure(const Peer& peer, const ChartGround& ground, double budget) {
    ChartRow row;
    row.scene = ground.scene.name;
    row.method = peer.method;
    row.setting = peer.setting;
    row.asked = peer.asked;
    row.points = static_cast<int>(ground.scene.points.size());
    row.present = static_cast<bool>(peer.prepare);
    if (!row.present) return row;
    const double begin = processor_time();
    std::function<PeerAnswer(const ChartPoint&)> method;
    row.setup = timing_of([&] { method = peer.prepare(ground.scene.system); }).time;
    std::vector<double> errors, times, times_of_all;
    std::vector<long> evaluations;
    for (std::size_t n = 0; n < ground.scene.points.size(); ++n) {
        if (processor_time() - begin > 1e6 * budget) {
            ++row.failures[did_not_finish];
            continue;
        }
        const ChartTruth& truth = ground.truth[n];
        PeerAnswer answer;
        const Timing timing = timing_of([&] { answer = answer_of(method, ground.scene.points[n]); });
        times_of_all.push_back(timing.time);
        row.longest = std::max(row.longest, timing.time);
        row.repeats = std::max(row.repeats, timing.repeats);
        evaluations.push_back(answer.evaluations);
        if (answer.ending == Ending::answered) times.push_back(timing.time);
        if (answer.ending != Ending::answered || answer.sticks != truth.answer.sticks) {
            ++row.failures[failure_of(answer.ending)];
            continue;
        }
        ++row.right;
        if (truth.regime != Regime::permanent_sticking) errors.push_back(error_of(answer, truth));
    }
    row.worst = errors.empty() ? 0 : std::ranges::max(errors);
    row.median = median(errors);
    row.time = median(times.empty() ? times_of_all : times);
    row.evaluations = median(evaluations);
    return row;
}

double digits_left(double error) { return error > 0 ? std::max(0.0, -std::log10(error)) : 0; }

bool right_everywhere(const ChartRow& row) { return row.present && row.right == row.points && row.worst > 0; }

const ChartRow* fastest(const std::vector<ChartRow>& rows, const std::string& scene, double digits, bool with_setup,
                        const std::function<bool(const ChartRow&)>& counts) {
    const ChartRow* best = nullptr;
    const double most = 5 * std::pow(10, -digits); // what rounding to so many digits leaves
    const auto cost = [&](const ChartRow& row) { return row.time + (with_setup ? row.setup : 0); };
    for (const ChartRow& row : rows)
        if (row.scene == scene && right_everywhere(row) && row.worst <= most && counts(row) && (!best || cost(row) < cost(*best)))
            best = &row;
    return best;
}

} // namespace denhartog::tests
