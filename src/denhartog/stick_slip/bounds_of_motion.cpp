// What is certain of a motion with stops in double? `velocity_ahead` and `load_ahead` bound what ends a phase, so that no event is
// missed; `end_of` and `error_at_ends` bound the instants of events, `sliding_reach` the distance within which motions slide for
// ever, and `largest_displacements` how far each mass goes, between two samples too.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory_resource>
#include <utility>
#include <vector>

#include "denhartog/search/largest.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/stick_slip/contact_phases.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

// Bound of the norm of one coordinate if D is diagonal: the sum of both sizes, at most sqrt(2) times the norm.
double energy_norm(const LinearMotion& motion, int m, std::size_t i) {
    return std::abs(motion.q[m + 1][i]) + motion.omega_0[i] * std::abs(motion.q[m][i]);
}

// Energy norm of derivative m, at most 4, and its velocity at the instant last evaluated, sqrt(sum q^(m+1)^2 + omega_0^2 q^(m)^2):
// it grows by |F| a unit of time at most.
double energy_norm(const LinearMotion& motion, int m) {
    double largest = 0, sum = 0;
    for (std::size_t i = 0; i < motion.size(); ++i) largest = std::max(largest, energy_norm(motion, m, i));
    if (!(largest > 0)) return largest;
    for (std::size_t i = 0; i < motion.size(); ++i) {
        const double v = motion.q[m + 1][i] / largest, y = motion.omega_0[i] * motion.q[m][i] / largest;
        sum += v * v + y * y;
    }
    return largest * sqrt(sum);
}

// Let a motion be at the distance d, in the norm of the energy, from one that slides throughout. As long as it does not stick
// either, friction and damping oppose the difference of both velocities, and d does not grow, even with mu > 1. The velocities of
// the two contacts then differ by at most |e_j| d, so that this contact can stop only near a turning point of the other one; and
// the loads on them differ by at most c d. If the load on the other exceeds mu beta by more than that near its turning points,
// this never sticks. `load_of_distance` is c.
double load_of_distance(const ContactPhases& c) {
    const auto n = static_cast<Eigen::Index>(c.N);
    const Column& phi_j = c.system->contact_shape;
    Column weights(2 * n);
    weights.head(n) = phi_j.cwiseProduct(column(c.sliding.omega_0));
    if (c.sliding.coupled())
        weights.tail(n) = c.sliding.D.transpose() * phi_j;
    else
        weights.tail(n) = 2 * phi_j.cwiseProduct(column(c.sliding.decay));
    return c.inertia * weights.norm();
}

// Whether bounds prove that no motion within a distance of the sliding one ever sticks, over the half-period from a turning point,
// where its velocity is `start`; with a load beyond `needed` the contact cannot stick, within the distance.
bool slides_within(ContactPhases& c, int direction, const Jet& start, double needed, double distance) {
    const double speed = c.system->contact_shape.norm() * distance;
    const double half = pi<double>();
    // The load that drives the contact on, after the turning point, and before that at the end, which is its mirror image.
    const auto load = [&](const Jet& jet, int end) { return end * (c.e.beta + c.inertia * jet.f[1]); };
    const auto rate = [&](const Jet& jet, double length) { return c.inertia * (jet.second + jet.growth * length); };
    const double margin = load(start, 1) - needed;
    if (!(margin > 0)) return false;
    const double room = margin / c.inertia;
    double t = std::min(half / 8, room / (start.second + sqrt(start.second * start.second + 4 * start.growth * room)));
    Jet before = c.velocity_ahead(direction, half - t);
    if (!(rate(before, t) * t < margin)) return false;
    Jet after = c.velocity_ahead(direction, t);
    while (!(after.f[0] > speed && before.f[0] > speed)) { // the contact may be at rest there: the load has to last longer
        if (t > half / 8) return false;
        const Jet later = c.velocity_ahead(direction, 2 * t), earlier = c.velocity_ahead(direction, half - 2 * t);
        if (!(load(after, 1) + load(later, 1) - rate(after, t) * t > 2 * needed)) return false;
        if (!(load(before, -1) + load(earlier, -1) - rate(earlier, t) * t > 2 * needed)) return false;
        after = later;
        before = earlier;
        t = 2 * t;
    }
    auto above = [&](double at) {
        Jet jet = c.velocity_ahead(direction, at);
        jet.f[0] -= speed;
        return jet;
    };
    double step = half / 4;
    return !first_crossing(above, t, half - t, 0, step, *c.effort);
}

// Displacements over a stretch, remembered: the masses share their instants.
class Displacements {
public:
    Displacements(LinearMotion& motion, const Matrix<double>& phi, double frame, Effort& effort)
        : motion_(motion), phi_(phi), effort_(effort), frame_(frame), sizes_(phi.cwiseAbs()), norms_(phi.cols()) {
        const Column F = column(motion_.F);
        growth_ = motion_.coupled() ? Column(phi_.rowwise().norm() * F.norm()) : Column(sizes_ * F.cwiseAbs());
    }

    // Adds what masses have of a contact that rests, a part each.
    void carry(const std::vector<double>& carried, double rest) { carried_ = rest * column(carried); }

    // The displacement of a mass at a time from the start of the stretch.
    [[nodiscard]] double of(Eigen::Index row, double t) { return at(t)(row, 0); }

    // Its rounding error: some units of its terms.
    [[nodiscard]] double noise(Eigen::Index row, double t) {
        motion_.differentiate_at(t);
        return 4 * eps * (sizes_.row(row).dot(column(motion_.q[0]).cwiseAbs()) + frame_);
    }

    // The size of the displacement as a curve, which refers to this object.
    [[nodiscard]] Curve size_of(Eigen::Index row) {
        Curve curve;
        curve.cost = 0; // the effort is spent if an instant is new
        curve.sample = [this, row](double t) {
            const Known x = at(t);
            return Sample{std::abs(x(row, 0)), x(row, 1), x(row, 2)};
        };
        // The third derivative by its energy norm, or by a Taylor polynomial and the energy norm of the fifth.
        curve.rate = [this, row](double a, double b) {
            const Known x = at(a);
            const double h = b - a, growth = growth_(row) * h;
            return std::min(x(row, 5) + growth, std::abs(x(row, 3)) + h * (std::abs(x(row, 4)) + h * (x(row, 6) + growth) / 2));
        };
        return curve;
    }

private:
    static constexpr Eigen::Index columns = 7;
    using Known = Eigen::Map<const Matrix<double>>;

    // Derivatives 0 to 4 of every mass, then what bounds the third and the fifth ahead, but for the growth.
    Known at(double t) {
        const auto place = known_.lower_bound(t);
        if (place != known_.end() && place->first == t) return {place->second.data(), phi_.rows(), columns};
        effort_.spend(motion_.cost() + static_cast<long>(phi_.size() / 16));
        motion_.differentiate_at(t);
        std::pmr::vector<double> numbers(static_cast<std::size_t>(phi_.rows() * columns), &memory_);
        Eigen::Map<Matrix<double>> x(numbers.data(), phi_.rows(), columns);
        for (int m = 0; m < 5; ++m) x.col(m).noalias() = phi_.lazyProduct(column(motion_.q[m]));
        if (carried_.size() > 0) x.col(0) += carried_;
        if (frame_ > 0) { // the frame's motion and its derivatives
            const double c = frame_ * motion_.now().c, s = frame_ * motion_.now().s;
            const double derivatives[] = {c, -s, -c, s, c};
            for (int m = 0; m < 5; ++m) x.col(m).array() += derivatives[m];
        }
        for (const int m : {2, 4}) {
            if (motion_.coupled()) {
                x.col(4 + m / 2) = phi_.rowwise().norm() * energy_norm(motion_, m);
                continue;
            }
            for (Eigen::Index i = 0; i < norms_.size(); ++i) norms_(i) = energy_norm(motion_, m, static_cast<std::size_t>(i));
            x.col(4 + m / 2).noalias() = sizes_.lazyProduct(norms_);
        }
        if (frame_ > 0) x.rightCols(2).array() += frame_;
        return {known_.emplace_hint(place, t, std::move(numbers))->second.data(), phi_.rows(), columns};
    }

    LinearMotion& motion_;
    const Matrix<double>& phi_;
    Effort& effort_;
    double frame_;
    Matrix<double> sizes_;
    Column growth_;
    Column carried_; // empty while the contact slides
    Column norms_;
    std::pmr::monotonic_buffer_resource memory_; // of what is known: an instant costs no allocation of its own
    std::pmr::map<double, std::pmr::vector<double>> known_{&memory_};
};

} // namespace

void ContactPhases::set_bounds_of_load() {
    double stiffness = 0, fastest = 0;
    for (std::size_t i = 0; i + 1 < N; ++i) {
        const double k = k_j[i] / sticking.omega_0[i];
        stiffness += k * k;
        fastest = std::max(fastest, sticking.omega_0[i] + 2 * sticking.decay[i]);
    }
    if (sticking.coupled()) fastest += largest_row_sum(sticking.D);
    const double force = column(sticking.F).norm(), inertial = m_j.norm();
    load_per_energy = sqrt(stiffness) + c_j.norm() + fastest * inertial;
    load_rest = inertial * force;
    load_growth = load_per_energy * force;
}

Jet ContactPhases::velocity_ahead(int direction, double t) {
    Jet jet{velocity(direction, t), 0, 0, 0, 0};
    for (std::size_t i = 0; i < N; ++i) {
        const double phi = direction * system->contact_shape(i);
        if (!sliding.coupled()) {
            jet.bound += std::abs(phi) * energy_norm(sliding, 4, i);
            jet.second += std::abs(phi) * energy_norm(sliding, 2, i);
        }
        jet.growth += std::abs(phi * sliding.F[i]);
        jet.noise += std::abs(phi * sliding.q[1][i]);
    }
    if (sliding.coupled()) { // energy goes from mode to mode
        const double size = system->contact_shape.norm();
        jet.bound = size * energy_norm(sliding, 4);
        jet.second = size * energy_norm(sliding, 2);
        jet.growth = size * column(sliding.F).norm();
    }
    jet.noise *= eps;
    return jet;
}

Jet ContactPhases::load_ahead(double t) {
    const double constant = system->constant.direct, pull = system->stuck.k_jj * rest - constant;
    Jet jet{load(t), size_of_direct, 0.0, std::abs(pull) + size_of_direct + std::abs(constant), size_of_direct};
    for (std::size_t i = 0; i + 1 < N; ++i)
        jet.noise +=
            std::abs(k_j[i] * sticking.q[0][i]) + std::abs(c_j[i] * sticking.q[1][i]) + std::abs(m_j[i] * sticking.q[2][i]);
    if (N > 1) {
        jet.bound += load_per_energy * energy_norm(sticking, 4) + load_rest;
        jet.second += load_per_energy * energy_norm(sticking, 2) + load_rest;
        jet.growth = load_growth;
    }
    jet.noise *= eps;
    return jet;
}

EndOfPhase ExactSolver::end_of(std::size_t phase) {
    ContactPhases& work = *work_;
    const Phase& p = work.motion.phases[phase];
    work.stand_at(phase);
    const double length = p.end - p.start;
    const Jet jet = p.direction != 0 ? work.velocity_ahead(p.direction, length) : work.load_ahead(length);
    return {std::abs(jet.f[1]), jet.second, jet.noise};
}

double EndOfPhase::error_of_instant(double error) const {
    const double apart = 4 * (error + noise) / (3 * rate);
    return rate > 0 && 4 * second * apart <= rate ? apart : std::numeric_limits<double>::infinity();
}

double highest_over_force(const ExactSolver& solver) {
    return std::max(1.0, solver.system().basis.r_n.back() / solver.excitation().r);
}

double error_at_ends(const ExactSolver& solver, bool slides, double displacement, const std::vector<double>& velocity) {
    if (slides) return velocity[solver.system().contact.index];
    const StuckConfiguration& stuck = solver.system().stuck;
    const double r = solver.excitation().r, fastest = highest_over_force(solver);
    double error_of_load = std::abs(stuck.k_jj) * displacement;
    for (std::size_t n = 0; n < stuck.masses.size(); ++n)
        error_of_load +=
            std::abs(stuck.k_j[n]) * displacement +
            (r * std::abs(stuck.c_j[n]) + r * r * std::abs(stuck.m_j[n]) * fastest) * velocity[stuck.masses[n].index];
    return error_of_load;
}

double ExactSolver::sliding_reach(std::size_t phase) {
    constexpr int most_halvings = 10;
    work_->stand_at(phase);
    ContactPhases& c = *work_;
    const int direction = work_->motion.phases[phase].direction;
    const Jet start = c.velocity_ahead(direction, 0);
    const double holds = c.e.mu * c.e.beta, unit = load_of_distance(c);
    double distance = (c.e.beta + c.inertia * start.f[1] - holds) / unit;
    for (int n = 0; n < most_halvings; ++n) {
        distance = distance / 2;
        if (slides_within(c, direction, start, holds + unit * distance, distance)) return distance;
    }
    return 0;
}

std::vector<Extremum> ExactSolver::largest_displacements(double error, double frame) {
    ContactPhases& work = *work_;
    if (work.effort == &work.own) work.own = {default_effort(work.N)};
    const ContactSystem& system = *work.system;
    const Contact& contact = system.stuck.contact;
    const bool moves = frame > 0;
    const std::size_t count = moves ? work.N : std::max(work.N, system.contact.index + 1),
                      j = moves ? count : system.contact.index;                             // the one that is not sought for
    const double start = work.motion.phases.empty() ? 0 : work.motion.phases.front().start; // a mass at rest is there as ever
    std::vector<Extremum> largest(count, Extremum{0, start});
    std::vector<std::vector<Place>> places(count);
    const auto take = [&](std::size_t k, double x, double tau) {
        const double size = std::abs(x);
        if (size >= std::abs(largest[k].x) - 2 * error) places[k].push_back({tau, tau, tau, size, size, 0});
        if (size > std::abs(largest[k].x)) {
            largest[k].x = x;
            largest[k].instant = tau;
        }
    };
    const auto take_all = [&](std::vector<double> x, double tau) {
        contact.append(x);
        if (moves)
            for (double& each : x) each += frame * elementary::cos(tau);
        for (std::size_t k = 0; k < count; ++k) take(k, x[k], tau);
    };
    for (std::size_t n = 0; n < work.motion.phases.size(); ++n) {
        const auto state = work.motion.states.begin() + static_cast<std::ptrdiff_t>(2 * work.N * n);
        take_all({state, state + static_cast<std::ptrdiff_t>(work.N)}, work.motion.phases[n].start);
    }
    if (!work.motion.phases.empty()) take_all(work.motion.end.x, work.motion.phases.back().end);
    for (std::size_t n = 0; n < work.motion.phases.size() && (work.N > 1 || moves); ++n) {
        const Phase& p = work.motion.phases[n];
        work.stand_at(n);
        const double length = p.end - p.start;
        const bool sticks = p.direction == 0;
        Displacements displacements(sticks ? work.sticking : work.sliding, sticks ? system.stuck.shapes : system.basis.phi, frame,
                                    *work.effort);
        if (sticks) displacements.carry(system.stuck.carried, work.rest);
        for (std::size_t k = 0; k < count; ++k) {
            if (k == j || !(length > 0)) continue;
            const auto row = static_cast<Eigen::Index>(k);
            const Maximum found = global_maximum(displacements.size_of(row), 0., length, displacements.noise(row, 0), work.effort,
                                                 std::abs(largest[k].x) - 2 * error, error);
            const auto in_orbit = [&](double tau) { return tau < length ? p.start + tau : p.end; };
            for (const Place& place : found.places)
                places[k].push_back(
                    {in_orbit(place.from), in_orbit(place.to), in_orbit(place.instant), place.value, place.upper, place.reach});
            if (found.value > std::abs(largest[k].x)) take(k, displacements.of(row, found.instant), p.start + found.instant);
            if (!found.settled) largest[k].unsure = std::max(largest[k].unsure, found.upper - std::abs(largest[k].x));
        }
    }
    const auto is_negative = [&](std::size_t k, double tau) {
        std::size_t n = 0;
        while (n + 1 < work.motion.phases.size() && work.motion.phases[n].end < tau) ++n;
        State state = state_at(n, tau);
        contact.append(state.x);
        return state.x[k] + (moves ? frame * elementary::cos(tau) : 0) < 0;
    };
    for (std::size_t k = 0; k < count; ++k) {
        if (k == j || places[k].empty()) continue;
        std::erase_if(places[k], [&](const Place& place) { return place.upper < std::abs(largest[k].x) - 2 * error; });
        largest[k].spread =
            spread_of_phases(joined(std::move(places[k])), work.motion.phases.front().start, work.motion.phases.back().end,
                             largest[k].instant, [&](double tau) { return is_negative(k, tau); });
    }
    return largest;
}

} // namespace denhartog
