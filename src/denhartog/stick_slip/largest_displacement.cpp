// How far does each mass go over a motion with stops? `Displacements` gives the displacements in one phase with bounds of their
// derivatives; `largest_displacements` searches all phases with them, so that no maximum between two samples is missed.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory_resource>
#include <utility>
#include <vector>

#include "denhartog/search/largest_in_double.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/stick_slip/contact_phases.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

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
        return 4 * std::numeric_limits<double>::epsilon() * (sizes_.row(row).dot(column(motion_.q[0]).cwiseAbs()) + frame_);
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
        if (frame_ > 0) add_frame(x);
        for (const int m : {2, 4}) {
            if (motion_.coupled()) {
                x.col(4 + m / 2) = phi_.rowwise().norm() * motion_.energy_norm(m);
                continue;
            }
            for (Eigen::Index i = 0; i < norms_.size(); ++i) norms_(i) = motion_.energy_norm(m, static_cast<std::size_t>(i));
            x.col(4 + m / 2).noalias() = sizes_.lazyProduct(norms_);
        }
        if (frame_ > 0) x.rightCols(2).array() += frame_;
        return {known_.emplace_hint(place, t, std::move(numbers))->second.data(), phi_.rows(), columns};
    }

    // Adds the frame's motion and its derivatives.
    void add_frame(Eigen::Map<Matrix<double>>& x) const {
        const double c = frame_ * motion_.cos_tau(), s = frame_ * motion_.sin_tau();
        const double derivatives[] = {c, -s, -c, s, c};
        for (int m = 0; m < 5; ++m) x.col(m).array() += derivatives[m];
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

std::vector<Extremum> ExactSolver::largest_displacements(double error, double frame) {
    Work& work = *work_;
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
