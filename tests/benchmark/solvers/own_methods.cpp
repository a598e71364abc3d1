// Methods of this library and those that need no other: `benchmark-solver METHOD SETTING PACK`.
#include <boost/numeric/odeint.hpp>
#include <iostream>
#include <numbers>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/denhartog.hpp"
#include "denhartog/paper_algorithm/contact_equations.hpp"
#include "tests/benchmark/solvers/pack_runner.hpp"
#include "tests/conformance/adapters/solvers/period.hpp"
#include "tests/speed_accuracy/peers/peers.hpp"

namespace {

using namespace denhartog;
using namespace denhartog::tests;

const double period = 2 * std::numbers::pi;

Ran solved(const Scene<double>& scene, int digits) {
    const Solution s = solve(scene, {Asked::motion, digits});
    Ran ran{std::vector<std::vector<double>>(number_of_masses(scene.system)), std::vector<std::array<double, 2>>()};
    for (const State& state : sampled_solution(scene_source(scene), s, pack_instants).states())
        for (std::size_t k = 0; k < state.x.size(); ++k) ran.x[k].push_back(state.x[k]);
    for (const SolvedStop& stop : s.stops) ran.stops->push_back({stop.start.value, stop.end.value});
    if (s.regime.regime == Regime::permanent_sticking) ran.stops = {{{0, period}}};
    return ran;
}

Ran balanced(const Scene<double>& scene, int highest) {
    if (scene.mu > 1) throw DomainError("harmonic balance has one bound for rest and sliding: mu = 1 only");
    const Peer peer = harmonic_balance({FrictionLaw::augmented_lagrangian, highest});
    const PeerAnswer answer = peer.prepare(scene.system)({*scene.r, *scene.beta});
    if (answer.ending != Ending::answered) throw DomainError("Newton's method does not converge");
    Ran ran{std::vector<std::vector<double>>(number_of_masses(scene.system)), std::nullopt};
    for (int n = 0; n < pack_instants; ++n)
        ran.x[scene.system.contact.index].push_back(answer.motion(period * n / pack_instants));
    return ran;
}

// (6) with friction beta tanh(v / width), v in units of P / sqrt(k_1 m_1).
class Regularised {
public:
    using State = std::vector<double>;
    Regularised(const ContactProblem& p, double r, double width)
        : N_(static_cast<std::size_t>(p.matrices.M.rows())), j_(p.contact.index), l_(p.load.index), M_(p.matrices.M),
          C_(p.matrices.C), K_(p.matrices.K), beta_(p.beta), width_(width / r) {}

    void operator()(const State& y, State& y_prime, double tau) const {
        for (std::size_t i = 0; i < N_; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            double f = i == l_ ? std::cos(tau) : 0;
            if (i == j_) f -= beta_ * std::tanh(y[N_ + i] / width_);
            for (std::size_t k = 0; k < N_; ++k) {
                const auto column = static_cast<Eigen::Index>(k);
                f -= K_(row, column) * y[k] + C_(row, column) * y[N_ + k];
            }
            y_prime[i] = y[N_ + i];
            y_prime[N_ + i] = f / M_(row, row);
        }
    }

private:
    std::size_t N_, j_, l_;
    Matrix<double> M_, C_, K_;
    double beta_, width_;
};

// Dormand and Prince's Runge-Kutta, its tolerance a hundredth of the width.
TimeIntegrator regularised(double width) {
    namespace odeint = boost::numeric::odeint;
    const auto stages = [width](const Scene<double>& scene) {
        const Regularised equations(contact_problem(scene), *scene.r, width);
        const double tolerance = width / 100;
        const auto one_period = [equations, tolerance](const std::vector<double>& y, int nodes) {
            PeriodRecord record;
            record.end = y;
            const auto stepper = odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<Regularised::State>());
            const int parts = std::max(nodes, 1);
            if (nodes > 0) record.nodes.push_back({0, y});
            for (int n = 1; n <= parts; ++n) {
                const double from = period * (n - 1) / parts, to = period * n / parts;
                odeint::integrate_adaptive(stepper, equations, record.end, from, to, (to - from) / 16);
                if (nodes > 0) record.nodes.push_back({to, record.end});
            }
            return record;
        };
        return std::vector<Stage>{{one_period, 10 * tolerance, 1000, 1024}};
    };
    return {"tanh", stages};
}

PackSolver solver_of(const std::string& method, const std::string& setting, double budget) {
    const double number = positive(setting);
    const int whole = static_cast<int>(number);
    if (method == "solve")
        return {"denhartog, solve", setting + " digits", [whole](const Scene<double>& s) { return solved(s, whole); }};
    if (method == "harmonic-balance")
        return {"harmonic balance", setting + " harmonics", [whole](const Scene<double>& s) { return balanced(s, whole); }};
    if (method == "tanh") return settled("tanh(v/width), Dormand-Prince", "width " + setting, regularised(number), budget);
    if (method == "paper")
        return settled("the paper's Runge-Kutta", "tolerance " + setting, paper_time_integrator(number), budget);
    throw InputError("method", "must be solve, paper, tanh or harmonic-balance", method);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::cerr << "usage: benchmark-solver METHOD SETTING PACK\n";
        return 2;
    }
    const std::string method = argv[1];
    return run_pack(argc - 1, argv + 1,
                    [&](const std::string& setting, double budget) { return solver_of(method, setting, budget); });
}
