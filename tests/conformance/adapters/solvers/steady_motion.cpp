#include "tests/conformance/adapters/solvers/steady_motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/paper_algorithm/contact_equations.hpp"

namespace denhartog::tests {
namespace {

constexpr double period = 2 * std::numbers::pi;
constexpr double least_decay = 0.01;     // of a transient in a period, where one asks whether the motion has settled
constexpr double least_size = 1e-3;      // of a state, in units of P / k_1, that a change is measured by
constexpr double no_motion = 1e-13;      // in units of P / k_1: rounding of a mass that rests
constexpr double most_growth = 100;      // of a state by extrapolation
constexpr double creeping = 1e-4;        // a contact that moves less may be on its way to rest for ever
constexpr double holding = 1e6;          // friction that lets nothing move
constexpr int patience = 200;            // periods after which a change of the integrator's own noise is enough
constexpr double same_direction = 1e-10; // below this part of the largest a change adds no direction to the extrapolation

using Vector = Eigen::VectorXd;

Vector vector_of(const std::vector<double>& y) { return Eigen::Map<const Vector>(y.data(), static_cast<Eigen::Index>(y.size())); }

// Loss of the slowest transient in a period while the contact slides, a mode above critical damping included.
double loss_in_a_period(const Scene<double>& scene) {
    const ModalBasis<double> basis = modal_basis(scene.system);
    double slowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const double zeta = basis.zeta[i], rate = zeta > 1 ? 1 / (zeta + std::sqrt((zeta - 1) * (zeta + 1))) : zeta;
        slowest = std::min(slowest, rate * basis.r_n[i] / *scene.r);
    }
    return -std::expm1(-period * slowest);
}

/// States at the ends of successive periods, and what they tend to.
class Sequence {
public:
    explicit Sequence(std::size_t size) : size_(size) {}

    void clear() { states_.clear(); }
    void push(const std::vector<double>& y) { states_.push_back(vector_of(y)); }

    /// Where there are two more than a linear map needs: the combination of states, with weights that add up to one, that changes
    /// least in a period.
    [[nodiscard]] std::optional<std::vector<double>> limit() const {
        const std::size_t used = size_ + 2;
        if (states_.size() < used) return std::nullopt;
        const std::size_t first = states_.size() - used;
        const auto columns = static_cast<Eigen::Index>(size_);
        Eigen::MatrixXd changes(columns, columns), second(columns, columns);
        for (Eigen::Index n = 0; n < columns; ++n) {
            const std::size_t at = first + static_cast<std::size_t>(n);
            changes.col(n) = states_[at + 1] - states_[at];
            second.col(n) = states_[at + 2] - 2 * states_[at + 1] + states_[at];
        }
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(columns, columns);
        fit.setThreshold(same_direction);
        fit.compute(second);
        const Vector y = states_[first] - changes * fit.solve(changes.col(0));
        if (!y.allFinite()) return std::nullopt;
        return std::vector<double>(y.begin(), y.end());
    }

private:
    std::size_t size_;
    std::vector<Vector> states_;
};

struct Settled {
    std::string why_not; // empty where it has
    std::vector<double> y;
};

Settled settle(const Stage& stage, std::vector<double> y, double loss, bool extrapolates) {
    const double allowed = stage.tolerance * std::max(loss, least_decay), noise = 10 * stage.tolerance;
    Sequence sequence(y.size());
    sequence.push(y);
    double relative = 0;
    for (int n = 0; n < stage.most_periods; ++n) {
        PeriodRecord record = stage.period(y, 0);
        if (!record.failure.empty()) return {record.failure, {}};
        const double size = std::max(vector_of(record.end).cwiseAbs().maxCoeff(), least_size);
        relative = (vector_of(record.end) - vector_of(y)).cwiseAbs().maxCoeff() / size;
        y = std::move(record.end);
        if (relative <= allowed || (n >= patience && relative <= noise)) return {{}, y};
        if (!extrapolates) continue;
        sequence.push(y);
        if (relative <= noise) continue;
        if (const auto limit = sequence.limit()) {
            if (vector_of(*limit).cwiseAbs().maxCoeff() <= most_growth * size) y = *limit;
            sequence.clear();
            sequence.push(y);
        }
    }
    return {"the motion has not settled within " + std::to_string(stage.most_periods) + " periods: it still changes by " +
                brief(relative) + " of its size in one",
            {}};
}

// A rest over the end of the period comes in two parts.
std::vector<Stop> whole_rests(std::vector<Stop> rests) {
    if (rests.size() > 1 && rests.front().start == 0 && rests.back().end == period) {
        rests.back().end += rests.front().end;
        rests.erase(rests.begin());
    }
    return rests;
}

void read_regime(SteadyMotion& motion) {
    motion.stops = whole_rests(motion.record.rests);
    const bool rests = motion.stops.size() == 1 && motion.stops[0].end - motion.stops[0].start >= period;
    motion.regime = motion.stops.empty() ? Regime::continuous : rests ? Regime::permanent_sticking : Regime::stick_slip;
}

SteadyMotion motion_from(const std::vector<Stage>& stages, std::vector<double> y, double loss, bool extrapolates) {
    SteadyMotion motion;
    for (const Stage& stage : stages) {
        Settled settled = settle(stage, y, loss, extrapolates);
        if (!settled.why_not.empty()) {
            if (motion.start.empty()) motion.why_none = settled.why_not;
            break;
        }
        motion.start = y = settled.y;
        motion.stage = stage;
    }
    if (!motion.why_none.empty()) return motion;
    motion.record = motion.stage.period(motion.start, motion.stage.nodes);
    motion.why_none = motion.record.failure;
    read_regime(motion);
    return motion;
}

// The motion shifted so that the contact is at zero: the other masses are shifted as at rest under a displaced contact.
std::vector<double> moved_to_zero(std::vector<double> y, const Scene<double>& scene) {
    const Matrix<double> K = contact_problem(scene).matrices.K;
    const Eigen::Index N = K.rows(), j = static_cast<Eigen::Index>(scene.system.contact.index);
    const Vector column = K.inverse().col(j);
    const double x_j = y[static_cast<std::size_t>(j)];
    for (Eigen::Index k = 0; k < N; ++k) y[static_cast<std::size_t>(k)] -= x_j * column[k] / column[j];
    y[static_cast<std::size_t>(j)] = 0;
    return y;
}

Scene<double> with_friction(Scene<double> scene, double beta) {
    scene.mu = 1;
    scene.beta = beta;
    return scene;
}

/// The cubic with the displacements and velocities of two nodes.
struct Between {
    const Node &a, &b;
    std::size_t k, N = a.y.size() / 2;
    double h = b.tau - a.tau, x_a = a.y[k], x_b = b.y[k], v_a = a.y[N + k] * h, v_b = b.y[N + k] * h;

    [[nodiscard]] double at(double s) const {
        const double c = 3 * (x_b - x_a) - 2 * v_a - v_b, d = v_a + v_b - 2 * (x_b - x_a);
        return x_a + s * (v_a + s * (c + s * d));
    }
    // Where the velocity changes its sign: the place in [0, 1].
    [[nodiscard]] std::optional<double> turn() const {
        if (!(v_a * v_b < 0)) return std::nullopt;
        const double a_2 = 3 * (v_a + v_b - 2 * (x_b - x_a)), a_1 = 6 * (x_b - x_a) - 4 * v_a - 2 * v_b;
        double low = 0, high = 1;
        for (int n = 0; n < 60; ++n) {
            const double middle = (low + high) / 2;
            ((v_a + middle * (a_1 + middle * a_2)) * v_a > 0 ? low : high) = middle;
        }
        return (low + high) / 2;
    }
};

struct Range {
    double lowest, highest, lowest_at = 0, highest_at = 0;
    void take(double x, double tau) {
        if (x > highest) highest = x, highest_at = tau;
        if (x < lowest) lowest = x, lowest_at = tau;
    }
};

Range range_of(const std::vector<Node>& nodes, std::size_t k) {
    Range range{nodes.front().y[k], nodes.front().y[k]};
    for (std::size_t n = 1; n < nodes.size(); ++n) {
        const Between step{nodes[n - 1], nodes[n], k};
        range.take(step.x_b, nodes[n].tau);
        if (const auto s = step.turn()) range.take(step.at(*s), nodes[n - 1].tau + *s * step.h);
    }
    return range;
}

double wrapped(double angle) {
    const double turned = std::remainder(angle, period);
    return turned <= -std::numbers::pi ? turned + period : turned;
}

} // namespace

double positive(const std::string& text) {
    double x = 0;
    if (number_from_text(text, x) != NumberFault::none || !(x > 0))
        throw InputError("setting", "must be a positive number", legible(text));
    return x;
}

std::string brief(double x) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.0e", x);
    return text.data();
}

SteadyMotion steady_motion(const Scene<double>& scene, const TimeIntegrator& integrator) {
    const std::vector<Stage> stages = integrator.prepare(scene);
    const double loss = loss_in_a_period(scene);
    const std::size_t j = scene.system.contact.index;
    const std::vector<double> rest(2 * number_of_masses(scene.system));
    if (scene.mu > 1)
        if (const SteadyMotion free = motion_from(integrator.prepare(with_friction(scene, 0)), rest, loss, true);
            free.why_none.empty())
            if (SteadyMotion sliding = motion_from(stages, free.start, loss, true);
                sliding.why_none.empty() && sliding.regime == Regime::continuous)
                return sliding;
    const bool extrapolates = scene.mu == 1; // with mu > 1 that can lead to a motion with stops that is not stable
    SteadyMotion motion = motion_from(stages, rest, loss, extrapolates);
    if (!motion.why_none.empty() || motion.regime == Regime::continuous) return motion;
    if (motion.regime == Regime::permanent_sticking) {
        motion = motion_from({motion.stage}, moved_to_zero(motion.start, scene), loss, extrapolates);
        if (motion.why_none.empty() && std::abs(motion.start[j]) > motion.stage.tolerance)
            motion.why_none = "the contact comes to rest for ever, but not at zero";
        return motion;
    }
    const Range moves = range_of(motion.record.nodes, j);
    if (scene.mu > 1 || moves.highest - moves.lowest < creeping) {
        const SteadyMotion held = motion_from({integrator.prepare(with_friction(scene, holding)).front()}, rest, loss, true);
        if (held.why_none.empty())
            if (SteadyMotion other = motion_from({motion.stage}, held.start, loss, extrapolates);
                other.why_none.empty() && other.regime == Regime::permanent_sticking)
                return other;
    }
    return motion;
}

double amplitude(const SteadyMotion& motion, std::size_t k, std::size_t contact) {
    if (k == contact && motion.record.contact) return motion.record.contact->amplitude;
    const Range range = range_of(motion.record.nodes, k);
    return std::max(range.highest, -range.lowest);
}

std::optional<double> phase(const SteadyMotion& motion, std::size_t k, std::size_t contact) {
    const Range range = range_of(motion.record.nodes, k);
    if (!(range.highest - range.lowest > no_motion)) return std::nullopt;
    if (k == contact) {
        const double near = (range.highest - range.lowest) * 1e-6;
        for (const Stop& stop : motion.stops)
            if (std::abs(stop.x - range.highest) <= near) return wrapped(stop.start);
        if (motion.record.contact && motion.record.contact->phase) return wrapped(*motion.record.contact->phase);
    }
    return wrapped(range.highest_at);
}

std::vector<double> samples(const SteadyMotion& motion, std::size_t k, int samples) {
    const std::vector<Node>& nodes = motion.record.nodes;
    std::vector<double> x;
    for (int n = 0; n < samples; ++n) {
        const double tau = period * n / samples;
        const auto after = std::ranges::upper_bound(nodes, tau, {}, &Node::tau);
        const std::size_t b = std::clamp<std::size_t>(static_cast<std::size_t>(after - nodes.begin()), 1, nodes.size() - 1);
        const Between step{nodes[b - 1], nodes[b], k};
        x.push_back(step.at((tau - nodes[b - 1].tau) / step.h));
    }
    return x;
}

} // namespace denhartog::tests
