// Bounds of a motion with stops in double. `velocity_ahead` and `load_ahead` bound what ends a phase, so that no event is
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
#include "denhartog/search/zeros.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

// Bound of the energy norm of one coordinate, if D is diagonal: the sum of its two terms. It exceeds the norm by sqrt(2) at most.
double bound_of_energy_norm(const LinearMotion& motion, int m, std::size_t i) {
    return std::abs(motion.q[m + 1][i]) + motion.omega_0[i] * std::abs(motion.q[m][i]);
}

// Energy norm of derivative m, up to the sixth, at the instant last evaluated, sqrt(sum q^(m+1)^2 + omega_0^2 q^(m)^2). It grows
// by |F| at most in a unit of time.
double energy_norm(const LinearMotion& motion, int m) {
    double largest = 0, sum = 0;
    for (std::size_t i = 0; i < motion.size(); ++i) largest = std::max(largest, bound_of_energy_norm(motion, m, i));
    if (!(largest > 0)) return largest;
    for (std::size_t i = 0; i < motion.size(); ++i) {
        const double v = motion.q[m + 1][i] / largest, y = motion.omega_0[i] * motion.q[m][i] / largest;
        sum += v * v + y * y;
    }
    return largest * sqrt(sum);
}

// Displacements over a stretch, remembered: the masses share their instants.
class Displacements {
public:
    Displacements(LinearMotion& motion, const Matrix<double>& phi, Column carried, double frame, Effort& effort)
        : motion_(motion), phi_(phi), effort_(effort), frame_(frame), sizes_(phi.cwiseAbs()), carried_(std::move(carried)),
          norms_(phi.cols()) {
        const Column F = column(motion_.F);
        growth_ = motion_.coupled() ? Column(phi_.rowwise().norm() * F.norm()) : Column(sizes_ * F.cwiseAbs());
    }

    // The displacement of a mass at a time from the start of the stretch.
    [[nodiscard]] double of(Eigen::Index row, double t) { return at(t)(row, 0); }

    // Its rounding error: some units of its terms.
    [[nodiscard]] double noise(Eigen::Index row, double t) {
        motion_.differentiate_at(t);
        return 4 * double_epsilon * (sizes_.row(row).dot(column(motion_.q[0]).cwiseAbs()) + frame_);
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
            for (Eigen::Index i = 0; i < norms_.size(); ++i)
                norms_(i) = bound_of_energy_norm(motion_, m, static_cast<std::size_t>(i));
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
    Column growth_, carried_, norms_;            // `carried_`: what masses have of a contact that rests, empty while it slides
    std::pmr::monotonic_buffer_resource memory_; // of what is known: an instant costs no allocation of its own
    std::pmr::map<double, std::pmr::vector<double>> known_{&memory_};
};

} // namespace

void ExactSolver::set_bounds_of_load() {
    double stiffness = 0, fastest = 0;
    for (std::size_t i = 0; i + 1 < N_; ++i) {
        const double k = k_j_[i] / sticking_.omega_0[i];
        stiffness += k * k;
        fastest = std::max(fastest, sticking_.omega_0[i] + 2 * sticking_.decay[i]);
    }
    if (sticking_.coupled()) fastest += largest_row_sum(sticking_.D);
    const double force = column(sticking_.F).norm(), inertial = m_j_.norm();
    load_per_energy_ = sqrt(stiffness) + c_j_.norm() + fastest * inertial;
    load_rest_ = inertial * force;
    load_growth_ = load_per_energy_ * force;
}

Jet ExactSolver::velocity_ahead(int direction, double t) {
    Jet jet{velocity(direction, t), 0, 0, 0, 0, 0};
    for (std::size_t i = 0; i < N_; ++i) {
        const double size = std::abs(system_->contact_shape(i));
        jet.bound += size * bound_of_energy_norm(sliding_, 6, i);
        jet.fourth += size * bound_of_energy_norm(sliding_, 4, i);
        jet.second += size * bound_of_energy_norm(sliding_, 2, i);
        jet.growth += size * std::abs(sliding_.F[i]);
        jet.noise += size * std::abs(sliding_.q[1][i]);
    }
    if (sliding_.coupled()) { // energy goes from mode to mode
        const double size = system_->contact_shape.norm();
        jet.bound = size * energy_norm(sliding_, 6);
        jet.fourth = size * energy_norm(sliding_, 4);
        jet.second = size * energy_norm(sliding_, 2);
        jet.growth = size * column(sliding_.F).norm();
    }
    jet.noise *= double_epsilon;
    return jet;
}

Jet ExactSolver::load_ahead(double t) {
    const double constant = system_->constant.direct, pull = system_->stuck.k_jj * rest_ - constant;
    Jet jet{load(t),         size_of_direct_, 0.0, std::abs(pull) + size_of_direct_ + std::abs(constant),
            size_of_direct_, size_of_direct_};
    for (std::size_t i = 0; i + 1 < N_; ++i)
        jet.noise +=
            std::abs(k_j_[i] * sticking_.q[0][i]) + std::abs(c_j_[i] * sticking_.q[1][i]) + std::abs(m_j_[i] * sticking_.q[2][i]);
    if (N_ > 1) {
        jet.bound += load_per_energy_ * energy_norm(sticking_, 6) + load_rest_;
        jet.fourth += load_per_energy_ * energy_norm(sticking_, 4) + load_rest_;
        jet.second += load_per_energy_ * energy_norm(sticking_, 2) + load_rest_;
        jet.growth = load_growth_;
    }
    jet.noise *= double_epsilon;
    return jet;
}

EndOfPhase ExactSolver::end_of(std::size_t phase) {
    const Phase& p = motion_.phases[phase];
    stand_at(phase);
    const double length = p.end - p.start;
    const Jet jet = p.direction != 0 ? velocity_ahead(p.direction, length) : load_ahead(length);
    return {std::abs(jet.f[1]), jet.second, jet.noise};
}

double EndOfPhase::error_of_instant(double error) const {
    const double apart = 4 * (error + noise) / (3 * rate);
    return rate > 0 && 4 * second * apart <= rate ? apart : std::numeric_limits<double>::infinity();
}

double ExactSolver::highest_over_force() const { return std::max(1.0, system_->basis.r_n.back() / e_.r); }

double ExactSolver::error_at_ends(bool slides, double displacement, const std::vector<double>& velocity) const {
    if (slides) return velocity[system_->contact.index];
    const StuckConfiguration& stuck = system_->stuck;
    const double r = e_.r, fastest = highest_over_force();
    double error_of_load = std::abs(stuck.k_jj) * displacement;
    for (std::size_t n = 0; n < stuck.masses.size(); ++n)
        error_of_load +=
            std::abs(stuck.k_j[n]) * displacement +
            (r * std::abs(stuck.c_j[n]) + r * r * std::abs(stuck.m_j[n]) * fastest) * velocity[stuck.masses[n].index];
    return error_of_load;
}

// Let a motion be at the distance d, in the norm of the energy, from one that slides throughout. As long as it does not stick
// either, friction and damping oppose the difference of both velocities, and d does not grow, even with mu > 1. The velocities of
// the two contacts then differ by at most |e_j| d, so that this contact can stop only near a turning point of the other one; and
// the loads on them differ by at most c d. If the load on the other exceeds mu beta by more than that near its turning points,
// this never sticks. `load_of_distance` is c.
double ExactSolver::load_of_distance() const {
    const auto n = static_cast<Eigen::Index>(N_);
    const Column& phi_j = system_->contact_shape;
    Column weights(2 * n);
    weights.head(n) = phi_j.cwiseProduct(column(sliding_.omega_0));
    if (sliding_.coupled())
        weights.tail(n) = sliding_.D.transpose() * phi_j;
    else
        weights.tail(n) = 2 * phi_j.cwiseProduct(column(sliding_.decay));
    return inertia_ * weights.norm();
}

// Whether bounds prove that no motion within a distance of the sliding one ever sticks, over the half-period from a turning point,
// where its velocity is `start`; with a load beyond `needed` the contact cannot stick, within the distance.
bool ExactSolver::slides_within(int direction, const Jet& start, double needed, double distance) {
    const double speed = system_->contact_shape.norm() * distance;
    const double half = pi<double>();
    // The load that drives the contact on, after the turning point, and before that at the end, which is its mirror image.
    const auto load = [&](const Jet& jet, int end) { return end * (e_.beta + inertia_ * jet.f[1]); };
    const auto rate = [&](const Jet& jet, double length) { return inertia_ * (jet.second + jet.growth * length); };
    const double margin = load(start, 1) - needed;
    if (!(margin > 0)) return false;
    const double room = margin / inertia_;
    double t = std::min(half / 8, room / (start.second + sqrt(start.second * start.second + 4 * start.growth * room)));
    Jet before = velocity_ahead(direction, half - t);
    if (!(rate(before, t) * t < margin)) return false;
    Jet after = velocity_ahead(direction, t);
    while (!(after.f[0] > speed && before.f[0] > speed)) { // the contact may be at rest there: the load has to last longer
        if (t > half / 8) return false;
        const Jet later = velocity_ahead(direction, 2 * t), earlier = velocity_ahead(direction, half - 2 * t);
        if (!(load(after, 1) + load(later, 1) - rate(after, t) * t > 2 * needed)) return false;
        if (!(load(before, -1) + load(earlier, -1) - rate(earlier, t) * t > 2 * needed)) return false;
        after = later;
        before = earlier;
        t = 2 * t;
    }
    auto above = [&](double at) {
        Jet jet = velocity_ahead(direction, at);
        jet.f[0] -= speed;
        return jet;
    };
    double step = half / 4;
    return !first_crossing(above, t, half - t, 0, step, *effort_);
}

double ExactSolver::sliding_reach(std::size_t phase) {
    constexpr int most_halvings = 10;
    stand_at(phase);
    const int direction = motion_.phases[phase].direction;
    const Jet start = velocity_ahead(direction, 0);
    const double holds = e_.mu * e_.beta, unit = load_of_distance();
    double distance = (e_.beta + inertia_ * start.f[1] - holds) / unit;
    for (int n = 0; n < most_halvings; ++n) {
        distance = distance / 2;
        if (slides_within(direction, start, holds + unit * distance, distance)) return distance;
    }
    return 0;
}

std::vector<Extremum> ExactSolver::largest_displacements(double error, double frame) {
    if (effort_ == &own_) own_ = {default_effort(N_)};
    const ContactSystem& system = *system_;
    const Contact& contact = system.stuck.contact;
    const bool moves = frame > 0;
    const std::size_t count = moves ? N_ : std::max(N_, system.contact.index + 1),
                      j = moves ? count : system.contact.index;                     // the one that is not sought for
    const double start = motion_.phases.empty() ? 0 : motion_.phases.front().start; // a mass at rest is there as ever
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
    for (std::size_t n = 0; n < motion_.phases.size(); ++n) take_all(motion_.start_of(n).x, motion_.phases[n].start);
    if (!motion_.phases.empty()) take_all(motion_.end.x, motion_.phases.back().end);
    for (std::size_t n = 0; n < motion_.phases.size() && (N_ > 1 || moves); ++n) {
        const Phase& p = motion_.phases[n];
        stand_at(n);
        const double length = p.end - p.start;
        const bool sticks = p.direction == 0;
        Displacements displacements(motion_of(p.direction), sticks ? system.stuck.shapes : system.basis.phi,
                                    sticks ? Column(rest_ * column(system.stuck.carried)) : Column(), frame, *effort_);
        for (std::size_t k = 0; k < count; ++k) {
            if (k == j || !(length > 0)) continue;
            const auto row = static_cast<Eigen::Index>(k);
            const Maximum found = global_maximum(displacements.size_of(row), 0., length, displacements.noise(row, 0), effort_,
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
        State state = state_at(tau);
        contact.append(state.x);
        return state.x[k] + (moves ? frame * elementary::cos(tau) : 0) < 0;
    };
    for (std::size_t k = 0; k < count; ++k) {
        if (k == j || places[k].empty()) continue;
        std::erase_if(places[k], [&](const Place& place) { return place.upper < std::abs(largest[k].x) - 2 * error; });
        largest[k].spread =
            spread_of_phases(joined(std::move(places[k])), motion_.phases.front().start, motion_.phases.back().end,
                             largest[k].instant, [&](double tau) { return is_negative(k, tau); });
    }
    return largest;
}

} // namespace denhartog
