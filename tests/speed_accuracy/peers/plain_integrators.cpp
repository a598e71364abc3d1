#include "tests/speed_accuracy/peers/peers.hpp"

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numeric>

#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/number.hpp"
#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {
namespace {

namespace odeint = boost::numeric::odeint;
using State = std::vector<double>; // modal displacements, then modal velocities

constexpr int most_periods = 400;
const double period = 2 * pi<double>();

/// Thrown by the integrator when it has used up its right-hand sides.
struct Stalled {};

/// (13) with friction as a function of the contact's velocity.
class PlainEquations {
public:
    PlainEquations(const System<double>& s, const ModalBasis<double>& basis, const ChartPoint& at, double eps)
        : N_(basis.r_n.size()), beta_(at.beta), eps_(eps), stiffness_(N_), damping_(N_), load_(N_), friction_(N_), shape_(N_) {
        const double square = at.r * at.r;
        for (std::size_t i = 0; i < N_; ++i) {
            const auto mode = static_cast<Eigen::Index>(i);
            shape_[i] = basis.phi(static_cast<Eigen::Index>(s.contact.index), mode);
            stiffness_[i] = basis.r_n[i] * basis.r_n[i] / square;
            damping_[i] = 2 * basis.zeta[i] * basis.r_n[i] / at.r;
            load_[i] = basis.phi(static_cast<Eigen::Index>(s.load.index), mode) / square;
            friction_[i] = shape_[i] / square;
            compliance_ += shape_[i] * friction_[i];
        }
    }

    void operator()(const State& y, State& y_prime, double tau) {
        if (++evaluations > most_plain_evaluations) throw Stalled{};
        const double force = std::cos(tau), v = velocity(y);
        const double friction = beta_ * (eps_ > 0 ? std::tanh(v / eps_) : static_cast<double>((v > 0) - (v < 0)));
        for (std::size_t i = 0; i < N_; ++i) {
            y_prime[i] = y[N_ + i];
            y_prime[N_ + i] = load_[i] * force - stiffness_[i] * y[i] - damping_[i] * y[N_ + i] - friction_[i] * friction;
        }
    }

    [[nodiscard]] double displacement(const State& y) const {
        return std::inner_product(shape_.begin(), shape_.end(), y.begin(), 0.0);
    }
    [[nodiscard]] double velocity(const State& y) const {
        return std::inner_product(shape_.begin(), shape_.end(), y.begin() + static_cast<std::ptrdiff_t>(N_), 0.0);
    }
    /// True if friction can hold the contact: the force on it without friction is less than the largest friction.
    [[nodiscard]] bool holds(const State& y, double tau) const {
        double a = 0;
        for (std::size_t i = 0; i < N_; ++i)
            a += shape_[i] * (load_[i] * std::cos(tau) - stiffness_[i] * y[i] - damping_[i] * y[N_ + i]);
        return std::abs(a) < beta_ * compliance_;
    }
    /// The fastest that the equations can be, per radian: decay by friction and the highest natural frequency.
    [[nodiscard]] double fastest() const { return beta_ * compliance_ / eps_ + std::sqrt(stiffness_.back()); }
    [[nodiscard]] std::size_t coordinates() const { return 2 * N_; }

    long evaluations = 0;

private:
    std::size_t N_;
    double beta_, eps_, compliance_ = 0;
    std::vector<double> stiffness_, damping_, load_, friction_, shape_;
};

/// Records over a period how far the contact moves and whether it sticks.
class Watch {
public:
    Watch(PlainEquations& equations, double tolerance) : equations_(equations), tolerance_(tolerance) {}

    template <class Step>
    void step(const State& from, double tau, const State& to, double h, const Step& restep) {
        const double v_from = equations_.velocity(from), v_to = equations_.velocity(to);
        const double x_from = std::abs(equations_.displacement(from)), x_to = std::abs(equations_.displacement(to));
        largest = std::max({largest, x_from, x_to});
        if (v_from * v_to > 0) return;
        sticks = sticks || equations_.holds(to, tau + h);
        const double gain = h * std::max(std::abs(v_from), std::abs(v_to));
        if (std::max(x_from, x_to) + gain <= largest * (1 + tolerance_ / 16)) return;
        double low = 0, high = h, v_low = v_from, v_high = v_to; // Illinois
        for (int n = 0; n < 12 && high - low > 1e-10 * h; ++n) {
            const double t = v_low == v_high ? low : low + (high - low) * v_low / (v_low - v_high);
            const State y = restep(from, tau, t);
            largest = std::max(largest, std::abs(equations_.displacement(y)));
            const double v = equations_.velocity(y);
            if (v == 0) return;
            const bool below = v * v_low > 0;
            (below ? low : high) = t;
            (below ? v_low : v_high) = v;
            (below ? v_high : v_low) /= 2;
        }
    }

    double largest = 0;
    bool sticks = false;

private:
    PlainEquations& equations_;
    double tolerance_;
};

/// One period by fixed steps.
struct FixedSteps {
    PlainEquations& equations;
    int steps;
    odeint::runge_kutta4<State> stepper{};

    void period_from(State& y, Watch* watch) {
        const double h = period / steps;
        const auto restep = [this](const State& from, double tau, double t) {
            State to(from.size());
            stepper.do_step(std::ref(equations), from, tau, to, t);
            return to;
        };
        State before;
        for (int n = 0; n < steps; ++n) {
            if (watch != nullptr) before = y;
            stepper.do_step(std::ref(equations), y, n * h, h);
            if (watch != nullptr) watch->step(before, n * h, y, h, restep);
        }
    }
};

/// One period by steps whose error is controlled.
struct ControlledSteps {
    PlainEquations& equations;
    double tolerance;
    double h = 1e-3;

    void period_from(State& y, Watch* watch) {
        auto stepper = odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<State>());
        const auto restep = [this](const State& from, double tau, double t) {
            State to(from.size());
            odeint::runge_kutta_dopri5<State>().do_step(std::ref(equations), from, tau, to, t);
            return to;
        };
        State before;
        for (double tau = 0; tau < period;) {
            double tried = std::min(h, period - tau);
            const bool cut = tried < h;
            const double from = tau;
            if (watch != nullptr) before = y;
            const bool taken = stepper.try_step(std::ref(equations), y, tau, tried) == odeint::success;
            if (taken && watch != nullptr) watch->step(before, from, y, tau - from, restep);
            if (!taken || !cut) h = tried;
        }
    }
};

/// Periods until two agree, then one that is watched.
template <class Steps>
PeerAnswer settle(Steps steps, PlainEquations& equations, double tolerance) {
    State y(equations.coordinates(), 0.0), before;
    PeerAnswer found;
    const auto size = [](const State& a) {
        double largest = 0;
        for (const double x : a) largest = std::max(largest, std::abs(x));
        return largest;
    };
    try {
        for (int n = 0; n < most_periods; ++n) {
            before = y;
            steps.period_from(y, nullptr);
            for (std::size_t i = 0; i < y.size(); ++i) before[i] -= y[i];
            if (!(size(before) > tolerance * size(y))) break;
        }
        Watch watch(equations, tolerance);
        steps.period_from(y, &watch);
        found.amplitude = watch.largest;
        found.sticks = watch.sticks;
    } catch (const Stalled&) {
        found.ending = Ending::stalled;
    }
    found.evaluations = equations.evaluations;
    if (std::any_of(y.begin(), y.end(), [](double x) { return !std::isfinite(x); })) found.ending = Ending::not_a_number;
    if (found.ending != Ending::answered) found.amplitude = 0;
    return found;
}

PeerAnswer answer(const System<double>& s, const ModalBasis<double>& basis, const PlainSetting& setting, const ChartPoint& at) {
    constexpr double stable_step = 2.5; // times the fastest rate: Runge-Kutta of fourth order is stable to 2.785
    PlainEquations equations(s, basis, at, setting.eps);
    if (setting.steps == 0) return settle(ControlledSteps{equations, setting.tolerance}, equations, setting.tolerance);
    const double needed = setting.stable ? std::ceil(period * equations.fastest() / stable_step) : 0;
    const double steps = std::min(std::max<double>(setting.steps, needed), static_cast<double>(most_plain_evaluations));
    return settle(FixedSteps{equations, static_cast<int>(steps)}, equations, setting.tolerance);
}

} // namespace

Peer plain_integrator(const PlainSetting& setting) {
    const std::string by = setting.steps == 0 ? "Dormand-Prince" : "Runge-Kutta 4";
    std::string text = setting.eps > 0 ? "eps " + digits(setting.eps) + ", " : "";
    if (setting.steps == 0)
        text += "tolerance " + digits(setting.tolerance);
    else
        text += setting.stable ? "largest stable step" : std::to_string(setting.steps) + " steps a period";
    return {by + (setting.eps > 0 ? ", tanh(v/eps)" : ", sgn(v)"), text, setting.steps == 0 ? setting.tolerance : 0,
            [setting](const System<double>& s) {
                return [s, basis = modal_basis(s), setting](const ChartPoint& at) { return answer(s, basis, setting, at); };
            }};
}

std::vector<Peer> plain_integrator_peers() {
    std::vector<Peer> peers;
    for (const int steps : {100, 1000, 10000}) peers.push_back(plain_integrator({0, steps, 1.0 / steps}));
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-8}) peers.push_back(plain_integrator({0, 0, tolerance}));
    for (const double eps : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) peers.push_back(plain_integrator({eps, 200, eps / 100, true}));
    for (const double eps : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) peers.push_back(plain_integrator({eps, 0, eps / 100}));
    return peers;
}

} // namespace denhartog::tests
