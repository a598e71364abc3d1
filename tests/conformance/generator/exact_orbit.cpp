#include <Eigen/LU>
#include <algorithm>

#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "tests/conformance/generator/route.hpp"

namespace denhartog::conformance::generator {
namespace {

using Index = Eigen::Index;

// Newton's method for the state at a maximum of the force that half a period mirrors.
template <class T>
class ExactOrbit : public Route<T> {
public:
    ExactOrbit(const ProtocolQuestion& q, const OrbitSeen& seen)
        : scene_(in_own_coordinates(wide_scene_of<T>(q))), system_(contact_system(scene_.system)),
          solver_(system_, {T(q.r), T(q.beta), T(q.mu)}) {
        start_.x.assign(seen.at_zero.x.begin(), seen.at_zero.x.end());
        start_.x_prime.assign(seen.at_zero.x_prime.begin(), seen.at_zero.x_prime.end());
        for (int n = 0; correct() > std::numeric_limits<T>::epsilon() * 4096; ++n)
            if (n == 12) throw PrecisionError("Newton's method on the exact solver does not converge");
        const ExactMotion<T>& motion = solver_.run(start_, T(0), T(2 * pi<T>()));
        largest_ = solver_.largest_displacements();
        largest_[scene_.system.contact.index] = contact_at_its_furthest(motion);
    }

    std::vector<T> numbers(const ProtocolQuestion& q) override {
        const std::size_t k = row_of(q, scene_.system);
        using std::abs;
        if (q.quantity == "amplitude") return {T(abs(largest_[k].x))};
        if (q.quantity == "phase") return {wrapped(T(largest_[k].instant + (largest_[k].x < 0 ? pi<T>() : T(0))))};
        if (q.quantity == "stops_per_period") return {T(static_cast<int>(stops().size()))};
        if (q.quantity == "stop_durations") return stops();
        if (q.quantity != "motion_under_force") return {};
        const ExactMotion<T>& motion = solver_.run(start_, T(0), T(2 * pi<T>()));
        std::vector<T> x;
        std::size_t phase = 0;
        for (int n = 0; n < q.samples; ++n) {
            const T tau = 2 * n * pi<T>() / q.samples;
            while (phase + 1 < motion.phases.size() && motion.phases[phase].end < tau) ++phase;
            State<T> state = solver_.state_at(phase, tau);
            add_displacements(scene_.system.coordinates, state.x);
            x.push_back(state.x[k]);
        }
        return x;
    }

private:
    Scene<T> scene_;
    ContactSystem<T> system_;
    ExactSolver<T> solver_;
    State<T> start_;
    std::vector<Extremum<T>> largest_;

    // A step; how long it was, relative.
    T correct() {
        const auto N = static_cast<Index>(start_.x.size());
        const ExactMotion<T>& motion = solver_.run(start_, T(0), pi<T>(), true);
        if (motion.status != MotionStatus::complete) throw PrecisionError("the exact solver does not reach the end");
        Eigen::Matrix<T, Eigen::Dynamic, 1> d(2 * N);
        for (Index k = 0; k < N; ++k) {
            const auto n = static_cast<std::size_t>(k);
            d(k) = -motion.end.x[n] - start_.x[n];
            d(N + k) = -motion.end.x_prime[n] - start_.x_prime[n];
        }
        const Matrix<T> slope = motion.jacobian + Matrix<T>::Identity(2 * N, 2 * N);
        d = Eigen::PartialPivLU<Matrix<T>>(slope).solve(d);
        T size(0);
        for (Index k = 0; k < N; ++k) {
            const auto n = static_cast<std::size_t>(k);
            using std::abs;
            size = std::max({size, T(abs(start_.x[n])), T(abs(start_.x_prime[n]))});
            start_.x[n] += d(k);
            start_.x_prime[n] += d(N + k);
        }
        return T(d.cwiseAbs().maxCoeff() / size);
    }

    // Where the contact turns or comes to rest; of equal ones the first. At the end of a rest it is where it was, but rounded.
    Extremum<T> contact_at_its_furthest(const ExactMotion<T>& motion) const {
        using std::abs;
        Extremum<T> furthest{T(0), T(0)};
        const std::size_t N = start_.x.size();
        for (std::size_t n = 1; n < motion.phases.size(); ++n) {
            if (motion.phases[n - 1].direction == 0) continue;
            const T& x = motion.states[2 * N * n + scene_.system.contact.index];
            if (abs(x) > abs(furthest.x) * (1 + T(1) / 1000000000)) furthest = {x, motion.phases[n].start};
        }
        return furthest;
    }

    // Lengths of the rests that start within a period, ascending.
    std::vector<T> stops() {
        const T period = 2 * pi<T>();
        std::vector<T> lengths;
        const ExactMotion<T>& motion = solver_.run(start_, T(0), T(2 * period));
        for (const Phase<T>& p : motion.phases)
            if (p.direction == 0 && p.start > T(0) && p.start <= period) lengths.push_back(p.end - p.start);
        std::sort(lengths.begin(), lengths.end());
        return lengths;
    }
};

} // namespace

template <class T>
std::unique_ptr<Route<T>> exact_orbit(const ProtocolQuestion& scene, const OrbitSeen& seen) {
    return std::make_unique<ExactOrbit<T>>(scene, seen);
}

template std::unique_ptr<Route<Real50>> exact_orbit(const ProtocolQuestion&, const OrbitSeen&);
template std::unique_ptr<Route<Real100>> exact_orbit(const ProtocolQuestion&, const OrbitSeen&);

} // namespace denhartog::conformance::generator
