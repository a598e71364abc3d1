#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "tests/conformance/generator/linear_half_period.hpp"
#include "tests/conformance/generator/route.hpp"
#include "tests/support/contact_phase.hpp"

namespace denhartog::conformance::generator {
namespace {

using Index = Eigen::Index;
using std::abs;

// Unknowns: x and x' (that of the contact is zero, which gives x_j') at the start of a rest, then the starts of all phases.
// Equations: at the end of each phase its event, at the end of the last the state that the stretch began with, mirrored or not.
template <class T>
class PhaseProblem : public Route<T> {
public:
    PhaseProblem(const ProtocolQuestion& q, const OrbitSeen& seen)
        : p_(problem_of<T>(q)), w_(contact_vector(p_)), N_(p_.M.rows()), j_(static_cast<Index>(p_.contact.index)),
          mu_beta_(T(q.mu) * p_.beta), A_{system_of_phase(p_, -1), system_of_phase(p_, 0), system_of_phase(p_, 1)},
          sign_(seen.sign()), span_(seen.halves * pi<T>()) {
        for (const Phase& phase : seen.phases) {
            directions_.push_back(phase.direction);
            starts_.push_back(T(phase.start));
        }
        x_.resize(2 * N_);
        for (Index k = 0; k < N_; ++k) {
            x_(k) = seen.at_rest.x[static_cast<std::size_t>(k)];
            x_(N_ + k) = seen.at_rest.x_prime[static_cast<std::size_t>(k)];
        }
        for (int n = 0; correct() > std::numeric_limits<T>::epsilon() * 4096; ++n)
            if (n == 12) throw PrecisionError("Newton's method on the phases does not converge");
        follow();
    }

    std::vector<T> numbers(const ProtocolQuestion& q) override {
        const Vector<T> d = q.mass > 0 ? Vector<T>(Vector<T>::Unit(N_, q.mass - 1)) : w_; // the displacement asked about
        const bool absolute = quantity(q.quantity).absolute;
        const T frame = absolute ? frame_of<T>(q) : T(0);
        if (q.quantity == "amplitude" || q.quantity == "absolute_amplitude") return {T(abs(extremum(d, frame).x))};
        if (q.quantity == "transmissibility") return {T(abs(extremum(d, frame).x) / base_of<T>(q))};
        if (q.quantity == "phase" || q.quantity == "absolute_phase") {
            const FurthestPlace<T> e = extremum(d, frame);
            const T instant = e.instant + (e.x < T(0) ? pi<T>() : T(0));
            return {T(atan2(T(sin(instant)), T(cos(instant))))};
        }
        std::vector<T> lengths;
        for (std::size_t n = 0; n < directions_.size(); ++n)
            if (directions_[n] == 0) lengths.insert(lengths.end(), sign_ < 0 ? 2 : 1, T(end_of(n) - starts_[n]));
        std::sort(lengths.begin(), lengths.end());
        if (q.quantity == "stops_per_period") return {T(static_cast<int>(lengths.size()))};
        if (q.quantity == "stop_durations") return lengths;
        if (q.quantity != "motion_under_force") return {};
        std::vector<T> x;
        for (int n = 0; n < q.samples; ++n) x.push_back(displacement(d, T(2 * n * pi<T>() / q.samples)));
        return x;
    }

private:
    HalfPeriodProblem<T> p_;
    Vector<T> w_; ///< displacement of the contact over the masses
    Index N_, j_; ///< a mass that it moves is j
    T mu_beta_;
    std::array<Matrix<T>, 3> A_; ///< matrices of sliding down, of rest, of sliding up
    int sign_;                   ///< -1 where the stretch mirrors itself
    T span_;                     ///< the length of the stretch
    std::vector<int> directions_;
    std::vector<T> starts_;
    Vector<T> x_;
    std::vector<Vector<T>> states_; ///< at the starts of the phases

    const Matrix<T>& of(std::size_t n) const { return A_[static_cast<std::size_t>(directions_[n] + 1)]; }
    T end_of(std::size_t n) const { return n + 1 < starts_.size() ? starts_[n + 1] : T(starts_.front() + span_); }

    Vector<T> start_state() const {
        Vector<T> z(2 * N_ + 3);
        z << x_, cos(starts_.front()), sin(starts_.front()), T(1);
        return z;
    }

    StateRow<T> event(std::size_t n) const {
        return end_of_phase(p_, mu_beta_, directions_[n],
                            n + 1 < directions_.size() ? directions_[n + 1] : sign_ * directions_.front());
    }

    T correct() {
        const Index rows = 2 * N_ + 3, phases = static_cast<Index>(starts_.size()), unknowns = 2 * N_ - 1 + phases;
        const auto column = [&](Index k) { return k < N_ + j_ ? k : k - 1; }; // of an entry of the state, N + j left out
        Vector<T> z = start_state();
        Matrix<T> slope = Matrix<T>::Zero(rows, unknowns); // of z with respect to the unknowns
        for (Index k = 0; k < 2 * N_; ++k)
            if (k != N_ + j_) slope(k, column(k)) = T(1);
        for (Index k = 0; k < N_; ++k)
            if (k != j_) slope(N_ + j_, column(N_ + k)) = -w_(k) / w_(j_);
        const Index first = 2 * N_ - 1; // column of the first instant
        slope(2 * N_, first) = -z(2 * N_ + 1);
        slope(2 * N_ + 1, first) = z(2 * N_);
        Matrix<T> J = Matrix<T>::Zero(unknowns, unknowns);
        Vector<T> F(unknowns);
        for (Index n = 0; n < phases; ++n) {
            const auto m = static_cast<std::size_t>(n);
            const Matrix<T>& A = of(m);
            const Matrix<T> E = matrix_exponential(Matrix<T>(A * T(end_of(m) - starts_[m])));
            slope.col(first + n) -= A * z;
            z = Vector<T>(E * z);
            slope = Matrix<T>(E * slope);
            slope.col(n + 1 < phases ? first + n + 1 : first) += A * z;
            const auto row = event(m);
            F(n) = row.dot(z);
            J.row(n) = row * slope;
        }
        const Vector<T> start = start_state();
        Index row = phases;
        for (Index k = 0; k < 2 * N_; ++k) {
            if (k == N_ + j_) continue; // that is the last event
            F(row) = z(k) - sign_ * start(k);
            J.row(row) = slope.row(k);
            J(row++, column(k)) -= T(sign_);
        }
        const Vector<T> change = Eigen::FullPivLU<Matrix<T>>(J).solve(Vector<T>(-F));
        for (Index k = 0; k < 2 * N_; ++k)
            if (k != N_ + j_) x_(k) += change(column(k));
        for (Index k = 0; k < N_; ++k)
            if (w_(k) != T(0) && k != j_) x_(N_ + j_) -= w_(k) / w_(j_) * change(column(N_ + k));
        for (Index n = 0; n < phases; ++n) starts_[static_cast<std::size_t>(n)] += change(first + n);
        return T(change.cwiseAbs().maxCoeff() / x_.cwiseAbs().maxCoeff());
    }

    // States at the starts of the phases; the contact moves as the phases say.
    void follow() {
        Vector<T> z = start_state();
        for (std::size_t n = 0; n < directions_.size(); ++n) {
            states_.push_back(z);
            const T length = end_of(n) - starts_[n];
            if (!(length > T(0))) throw DomainError("a phase has no length");
            const Vector<T> middle = moved(of(n), z, T(length / 2));
            if (directions_[n] != 0 && !(w_.dot(middle.segment(N_, N_)) * directions_[n] > T(0)))
                throw DomainError("the contact slides back");
            if (directions_[n] == 0 && !(abs(T(event(n).dot(middle)) - event(n)(2 * N_ + 2)) < mu_beta_))
                throw DomainError("friction does not hold the contact");
            z = moved(of(n), z, length);
        }
    }

    T displacement(const Vector<T>& d, T tau) const {
        T sign(1);
        for (; tau < starts_.front(); tau += span_) sign *= sign_;
        for (; tau >= starts_.front() + span_; tau -= span_) sign *= sign_;
        std::size_t n = 0;
        while (n + 1 < starts_.size() && starts_[n + 1] <= tau) ++n;
        return sign * d.dot(moved(of(n), states_[n], T(tau - starts_[n])).head(N_));
    }

    // The contact is furthest where a phase starts; another mass, or any in a frame that moves, where its velocity, which is
    // continuous, changes its sign.
    FurthestPlace<T> extremum(const Vector<T>& d, const T& frame) const {
        FurthestPlace<T> best;
        const auto note = [&](const T& x, const T& instant) {
            if (abs(x) > abs(best.x)) best = {x, instant};
        };
        Vector<T> row = Vector<T>::Zero(2 * N_ + 3);
        row.head(N_) = d;
        row(2 * N_) = frame;
        for (std::size_t n = 0; n < states_.size(); ++n) {
            if (d == w_ && frame == T(0)) { // after a rest it is where it was, but rounded
                if (n == 0 || directions_[n - 1] != 0) note(T(d.dot(states_[n].head(N_))), starts_[n]);
                continue;
            }
            constexpr int samples = 64;
            const FurthestPlace<T> turn = furthest_turn<T>(of(n), states_[n], row, T(end_of(n) - starts_[n]), samples);
            note(turn.x, T(starts_[n] + turn.instant));
        }
        return best;
    }
};

} // namespace

template <class T>
std::unique_ptr<Route<T>> phase_problem(const ProtocolQuestion& scene, const OrbitSeen& seen) {
    return std::make_unique<PhaseProblem<T>>(scene, seen);
}

template std::unique_ptr<Route<Real50>> phase_problem(const ProtocolQuestion&, const OrbitSeen&);
template std::unique_ptr<Route<Real100>> phase_problem(const ProtocolQuestion&, const OrbitSeen&);

} // namespace denhartog::conformance::generator
