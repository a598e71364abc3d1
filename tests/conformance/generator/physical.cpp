#include <Eigen/LU>
#include <limits>
#include <optional>

#include "tests/conformance/generator/linear_half_period.hpp"
#include "tests/conformance/generator/route.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::conformance::generator {
namespace {

using Index = Eigen::Index;

// Number of roots below lambda: negative pivots of K - lambda M. The zeros of a chain are passed over.
template <class T>
Index roots_below(const Matrix<T>& M, const Matrix<T>& K, const T& lambda) {
    const Index N = M.rows();
    Matrix<T> S = K - lambda * M;
    Index count = 0;
    for (Index i = 0; i < N; ++i) {
        T& pivot = S(i, i);
        if (pivot == T(0)) pivot = std::numeric_limits<T>::epsilon() * std::numeric_limits<T>::epsilon() * K(i, i);
        if (pivot < T(0)) ++count;
        for (Index k = i + 1; k < N; ++k)
            for (Index l = k; l < N && S(k, i) != T(0); ++l)
                if (S(l, i) != T(0)) S(l, k) -= S(l, i) * S(k, i) / pivot;
    }
    return count;
}

template <class T>
T root(const Matrix<T>& M, const Matrix<T>& K, Index i, T below, T above) {
    for (int n = 0; n < 4 * std::numeric_limits<T>::digits; ++n) {
        const T middle = (below + above) / 2;
        if (middle <= below || middle >= above) break;
        (roots_below(M, K, middle) > i ? above : below) = middle;
    }
    return (below + above) / 2;
}

// Roots of the characteristic polynomial det(K - lambda M) by Sturm's count and bisection. Both matrices are positive definite,
// and no root exceeds the bound. Gives squares of the natural frequency ratios, ascending.
template <class T>
std::vector<T> determinant_roots(const Matrix<T>& M, const Matrix<T>& K, const T& bound) {
    std::vector<T> lambda;
    for (Index i = 0; i < M.rows(); ++i) lambda.push_back(root(M, K, i, T(0), bound));
    return lambda;
}

// Natural modes without an eigenvector.
template <class T>
struct DeterminantModes {
    std::vector<T> lambda; ///< roots of det(K - lambda M), ascending: squares of the natural frequency ratios
    Matrix<T> products;    ///< phi_ki phi_ji with phi^T M phi = 1 for one j: mass k by mode i
};

// Roots of the characteristic polynomial of a chain, and residues of its receptance: ((K - lambda M)^-1)_kj is the sum of
// phi_ki phi_ji / (lambda_i - lambda), and by Cramer's rule a product of leading and trailing minors over the determinant: each
// product is minus a residue. M is diagonal, K tridiagonal; j counts from 0.
template <class T>
DeterminantModes<T> determinant_modes(const Matrix<T>& M, const Matrix<T>& K, Index j) {
    const Index N = M.rows();
    T bound(0);
    for (Index i = 0; i < N; ++i) bound = std::max(bound, T(4 * K(i, i) / M(i, i)));
    DeterminantModes<T> modes{determinant_roots(M, K, bound), Matrix<T>(N, N)};
    for (Index i = 0; i < N; ++i) {
        const T& lambda = modes.lambda[static_cast<std::size_t>(i)];
        // Leading minors with their derivative, trailing minors.
        std::vector<T> leading(static_cast<std::size_t>(N) + 1, T(1)), slope(leading.size(), T(0)),
            trailing(leading.size() + 1, T(1));
        for (Index n = 0; n < N; ++n) {
            const auto m = static_cast<std::size_t>(n);
            const T a = K(n, n) - lambda * M(n, n), b = n > 0 ? T(K(n, n - 1) * K(n, n - 1)) : T(0);
            leading[m + 1] = a * leading[m] - (n > 0 ? T(b * leading[m - 1]) : T(0));
            slope[m + 1] = a * slope[m] - M(n, n) * leading[m] - (n > 0 ? T(b * slope[m - 1]) : T(0));
        }
        for (Index n = N - 1; n >= 0; --n) {
            const auto m = static_cast<std::size_t>(n);
            const T b = n + 1 < N ? T(K(n + 1, n) * K(n + 1, n)) : T(0);
            trailing[m] = (K(n, n) - lambda * M(n, n)) * trailing[m + 1] - (n + 1 < N ? T(b * trailing[m + 2]) : T(0));
        }
        for (Index k = 0; k < N; ++k) {
            const Index first = std::min(j, k), last = std::max(j, k);
            T product = leading[static_cast<std::size_t>(first)] * trailing[static_cast<std::size_t>(last) + 1];
            for (Index n = first; n < last; ++n) product *= -K(n + 1, n);
            modes.products(k, i) = -product / slope[static_cast<std::size_t>(N)];
        }
    }
    return modes;
}

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
