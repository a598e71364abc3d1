#include <Eigen/LU>
#include <optional>

#include "tests/conformance/generator/determinant.hpp"
#include "tests/conformance/generator/linear_half_period.hpp"
#include "tests/conformance/generator/physical_problem.hpp"
#include "tests/conformance/generator/route.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::conformance::generator {
namespace {

using Index = Eigen::Index;

template <class T>
T angle(const T& y, const T& x) {
    return atan2(y, x);
}

// The half-period motion of a problem under a friction ratio, propagated on demand.
template <class T>
class Physical : public Route<T> {
public:
    Physical(const ProtocolQuestion& q, Regime regime)
        : q_(q), p_(problem_of<T>(q)), w_(contact_vector(p_)), j_(static_cast<Index>(p_.contact.index)), regime_(regime),
          mu_(q.mu), r_(q.r) {}

    std::vector<T> numbers(const ProtocolQuestion& q) override {
        const std::string& name = q.quantity;
        const Index k = q.mass > 0 ? q.mass - 1 : 0, N = p_.M.rows();
        const Vector<T> x = q.mass > 0 ? Vector<T>(Vector<T>::Unit(N, k)) : w_; // the displacement asked about
        if (name == "natural_frequency_ratios") return modal([](const T& r_n) { return r_n; });
        if (name == "modal_frequency_ratios") return modal([&](const T& r_n) { return T(r_ / r_n); });
        if (name == "mode_shape_products") return products(k);
        if (name == "beta_lim_high_frequency") return {limit_at_high_frequency()};
        if (name == "complex_response") return {x.dot(linear().Y.col(0).head(N)), T(-x.dot(linear().Y.col(0).tail(N)))};
        if (name == "first_damping_function") return {U_of(linear(), x)};
        if (name == "second_damping_function") return {G_of(linear(), x)};
        if (name == "H_j") return {T(acceleration_at_start(linear()) - inverse_mass())};
        if (name == "S_j") return {largest_demand(linear())};
        if (name == "beta_lim_exact") return {slides_below(std::max(largest_demand(linear()), held_demand()))};
        if (name == "beta_lim_paper") return {slides_below(std::max(sum_of_maxima(), held_demand()))};
        if (name == "beta_lim_approximate") return {slides_below(held_demand())};
        if (name == "beta_lim_sticking") return {T(held_load() / mu_)};
        if (regime_ == Regime::permanent_sticking) return quantity(name).absolute ? held_from_ground(q, x) : held(q, x);
        if (quantity(name).absolute) return sliding_from_ground(q, x);
        if (regime_ == Regime::continuous) return sliding(q, x);
        return {};
    }

private:
    ProtocolQuestion q_;
    HalfPeriodProblem<T> p_;
    Vector<T> w_; ///< displacement of the contact over the masses
    Index j_;
    Regime regime_;
    T mu_, r_;
    std::optional<DeterminantModes<T>> modes_;
    std::optional<LinearHalfPeriod<T>> linear_;
    std::optional<HalfPeriodMotion<T>> motion_;

    const DeterminantModes<T>& modes() {
        if (!modes_) modes_ = determinant_modes(Matrix<T>(p_.M / (r_ * r_)), p_.K, j_);
        return *modes_;
    }

    template <class F>
    std::vector<T> modal(F f) {
        std::vector<T> all;
        const std::vector<T> lambda = is_of_the_paper(q_) ? modes().lambda : roots();
        for (const T& each : lambda) all.push_back(f(T(sqrt(each))));
        return all;
    }

    std::vector<T> roots() { return determinant_roots(Matrix<T>(p_.M / (r_ * r_)), p_.K, largest_root()); }

    // A bound of the eigenvalues of M^-1 K: the largest sum of sizes in a row.
    T largest_root() {
        const Matrix<T> A = Eigen::FullPivLU<Matrix<T>>(p_.M / (r_ * r_)).solve(p_.K);
        return A.cwiseAbs().rowwise().sum().maxCoeff();
    }

    std::vector<T> products(Index k) {
        std::vector<T> all;
        for (Index i = 0; i < p_.M.rows(); ++i) all.push_back(modes().products(k, i) / (r_ * r_));
        return all;
    }

    int steps() { return steps_for(T(sqrt(is_of_the_paper(q_) ? modes().lambda.back() : largest_root()) / r_)); }

    const LinearHalfPeriod<T>& linear() {
        if (!linear_) linear_ = linear_half_period(p_, steps());
        return *linear_;
    }

    T inverse_mass() { return w_.dot(Vector<T>(Eigen::FullPivLU<Matrix<T>>(p_.M).solve(w_))); }
    T held_demand() { return acceleration_at_start(linear()) + (mu_ - 1) * inverse_mass(); }

    // While sliding |V_dj|^2 - beta^2 U_dj^2 has to exceed the square of beta times the demand.
    T slides_below(const T& demand) {
        const Index N = p_.M.rows();
        const T re = w_.dot(linear().Y.col(0).head(N)), im = w_.dot(linear().Y.col(0).tail(N)), U = U_of(linear(), w_);
        return sqrt(T((re * re + im * im) / (U * U + demand * demand)));
    }

    // Every mode by itself is one mass of frequency ratio R_i, whose demand is psi^2 = 1 / R_i^2 times that of the mode.
    T sum_of_maxima() {
        T sum(0);
        for (Index i = 0; i < p_.M.rows(); ++i) {
            const T R = r_ / sqrt(modes().lambda[static_cast<std::size_t>(i)]);
            const T zeta(q_.damping_ratios[static_cast<std::size_t>(i)]);
            const auto one = [](const T& x) { return Matrix<T>(Matrix<T>::Constant(1, 1, x)); };
            const LinearHalfPeriod<T> mode =
                linear_half_period<T>({one(R * R), one(2 * zeta * R), one(T(1)), Mass{0}, Mass{0}, T(0)}, steps_for(T(1 / R)));
            sum += modes().products(j_, i) / (r_ * r_) * R * R * largest_demand(mode);
        }
        return sum;
    }

    // The limit from two frequency ratios so high that what is left falls with their square.
    T limit_at_high_frequency() {
        const auto at = [&](int exponent) {
            ProtocolQuestion q = q_;
            q.r = std::ldexp(1.0, exponent);
            Physical<T> there(q, regime_);
            return there.numbers_of_limit();
        };
        const int e = std::numeric_limits<T>::digits10 > 60 ? 150 : 75;
        return 2 * at(e + 1) - at(e);
    }

    T numbers_of_limit() { return slides_below(std::max(largest_demand(linear()), held_demand())); }

    // Complex amplitudes of all masses while the contact is held (real parts, then imaginary), and of the force that holds it,
    // by one dense real system.
    Vector<T> held_motion() {
        const Index N = p_.M.rows();
        Matrix<T> A = Matrix<T>::Zero(2 * N + 2, 2 * N + 2);
        A.topLeftCorner(2 * N, 2 * N) << p_.K - p_.M, -p_.C, p_.C, p_.K - p_.M;
        A.block(0, 2 * N, N, 1) = A.block(N, 2 * N + 1, N, 1) = -w_;
        A.block(2 * N, 0, 1, N) = A.block(2 * N + 1, N, 1, N) = w_.transpose();
        Vector<T> b = Vector<T>::Zero(2 * N + 2);
        b.head(N) = load_vector(p_);
        b.segment(N, N) = leading_load(p_);
        return Eigen::FullPivLU<Matrix<T>>(A).solve(b);
    }

    T held_load() { return T(held_motion().tail(2).norm()); }

    std::vector<T> held(const ProtocolQuestion& q, const Vector<T>& x) {
        const Index N = p_.M.rows();
        if (q.quantity == "rest_interval")
            return {T((mu_ * p_.beta - held_load()) * w_.dot(Vector<T>(Eigen::FullPivLU<Matrix<T>>(p_.K).solve(w_))))};
        const Vector<T> X = held_motion();
        const T re = is_contact(x) ? T(0) : x.dot(X.head(N)), im = is_contact(x) ? T(0) : x.dot(X.segment(N, N));
        if (q.quantity == "amplitude") return {T(sqrt(T(re * re + im * im)))};
        if (q.quantity == "phase") return {angle(T(-im), re)};
        if (q.quantity != "motion_under_force") return {};
        std::vector<T> samples;
        for (int n = 0; n < q.samples; ++n) {
            const T tau = 2 * n * pi<T>() / q.samples;
            samples.push_back(re * cos(tau) - im * sin(tau));
        }
        return samples;
    }

    bool is_contact(const Vector<T>& x) const { return x == w_; }

    std::vector<T> held_from_ground(const ProtocolQuestion& q, const Vector<T>& x) {
        const Index N = p_.M.rows();
        const Vector<T> X = held_motion();
        const T re = frame_of<T>(q) + (is_contact(x) ? T(0) : x.dot(X.head(N))),
                im = is_contact(x) ? T(0) : x.dot(X.segment(N, N));
        if (q.quantity == "absolute_phase") return {angle(T(-im), re)};
        const T size = sqrt(T(re * re + im * im));
        return {q.quantity == "transmissibility" ? T(size / base_of<T>(q)) : size};
    }

    // The largest absolute displacement.
    std::vector<T> sliding_from_ground(const ProtocolQuestion& q, const Vector<T>& x) {
        const Index N = p_.M.rows();
        const T frame = frame_of<T>(q), phi = motion().phi_j;
        FurthestPlace<T> place{x.dot(motion().x_0), T(0)};
        if (frame != T(0) || !is_contact(x)) {
            Vector<T> z(2 * N + 3), row = Vector<T>::Zero(2 * N + 3);
            z << motion().x_0, motion().x_prime_0, cos(phi), sin(phi), T(1);
            row.head(N) = x;
            row(2 * N) = frame;
            place = furthest_turn<T>(augmented_system(p_), z, row, pi<T>(), steps());
        }
        const T lag = phi + place.instant + (place.x < T(0) ? pi<T>() : T(0)), size = abs(place.x);
        if (q.quantity == "absolute_phase") return {angle(T(sin(lag)), T(cos(lag)))};
        return {q.quantity == "transmissibility" ? T(size / base_of<T>(q)) : size};
    }

    const HalfPeriodMotion<T>& motion() {
        if (!motion_) motion_ = half_period_motion(p_, steps());
        return *motion_;
    }

    // Displacement at any tau: over the half-period from its start, mirrored beyond.
    T displacement(const Vector<T>& x, T tau) {
        T sign(1);
        for (; tau < T(0); tau += pi<T>()) sign = -sign;
        for (; tau >= pi<T>(); tau -= pi<T>()) sign = -sign;
        const Index N = p_.M.rows();
        Vector<T> z(2 * N + 3);
        z << motion().x_0, motion().x_prime_0, cos(motion().phi_j), sin(motion().phi_j), T(1);
        return sign * x.dot(moved(augmented_system(p_), z, tau).head(N));
    }

    // The largest displacement, of the contact that at tau = 0.
    std::vector<T> sliding(const ProtocolQuestion& q, const Vector<T>& x) {
        const HalfPeriodMotion<T>& m = motion();
        const T c = x.dot(m.x_0), s = x.dot(m.x_prime_0);
        const Index k = q.mass - 1;
        if (q.quantity == "amplitude") return {q.mass > 0 ? T(m.amplitude(k)) : c};
        if (q.quantity == "phase") return {is_contact(x) ? m.phi_j : T(m.phase(k))};
        if (q.quantity == "amplitude_monoharmonic") return {T(sqrt(T(c * c + s * s)))};
        if (q.quantity == "phase_monoharmonic")
            return {angle(T(c * sin(m.phi_j) + s * cos(m.phi_j)), T(c * cos(m.phi_j) - s * sin(m.phi_j)))};
        if (q.quantity == "initial_displacement") return {c};
        if (q.quantity == "initial_velocity") return {s};
        if (q.quantity == "displacement") return {displacement(x, T(q.tau))};
        if (q.quantity != "motion_under_force") return {};
        std::vector<T> samples;
        for (int n = 0; n < q.samples; ++n) samples.push_back(displacement(x, T(2 * n * pi<T>() / q.samples - m.phi_j)));
        return samples;
    }
};

} // namespace

template <>
HalfPeriodProblem<Real50> problem_of(const ProtocolQuestion& q) {
    return half_period_problem(scene_of(q));
}

template <>
HalfPeriodProblem<Real100> problem_of(const ProtocolQuestion& q) {
    return half_period_problem(wide_scene_of<Real50>(q));
}

template <class T>
std::unique_ptr<Route<T>> physical(const ProtocolQuestion& scene, Regime regime) {
    return std::make_unique<Physical<T>>(scene, regime);
}

template std::unique_ptr<Route<Real50>> physical(const ProtocolQuestion&, Regime);
template std::unique_ptr<Route<Real100>> physical(const ProtocolQuestion&, Regime);

} // namespace denhartog::conformance::generator
