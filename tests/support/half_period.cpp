#include "tests/support/half_period.hpp"

#include <Eigen/LU>
#include <sstream>

#include "denhartog/number/errors.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog {
namespace {

using Index = Eigen::Index;

template <class T>
std::string text(const T& value) {
    std::ostringstream s;
    s << value;
    return s.str();
}

template <class T>
bool is_finite(const T& value) {
    return value - value == T(0);
}

template <class T>
bool all_finite(const Matrix<T>& A) {
    return ((A - A).array() == T(0)).all();
}

/// Product that skips the zeros of the left factor: the propagators here have many.
template <class T>
Matrix<T> product(const Matrix<T>& A, const Matrix<T>& B) {
    Matrix<T> result = Matrix<T>::Zero(A.rows(), B.cols());
    for (Index k = 0; k < A.cols(); ++k)
        for (Index i = 0; i < A.rows(); ++i) {
            if (A(i, k) == T(0)) continue;
            for (Index n = 0; n < B.cols(); ++n)
                if (B(k, n) != T(0)) result(i, n) += A(i, k) * B(k, n);
        }
    return result;
}

/// Largest sum of absolute values in a row.
template <class T>
T row_norm(const Matrix<T>& A) {
    return A.cwiseAbs().rowwise().sum().maxCoeff();
}

template <class T>
Matrix<T> power(Matrix<T> base, int exponent) {
    Matrix<T> result = Matrix<T>::Identity(base.rows(), base.cols());
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1) result = product(base, result);
        if (exponent > 1) base = product(base, base);
    }
    return result;
}

template <class T>
void check_matrix(const char* name, const Matrix<T>& A, Index N) {
    if (A.rows() != N || A.cols() != N)
        throw InputError(name, "must be " + text(N) + " x " + text(N), text(A.rows()) + " x " + text(A.cols()));
    if (!all_finite(A)) throw InputError(name, "must be finite", "not finite");
}

template <class T>
void check_problem(const HalfPeriodProblem<T>& p, int steps) {
    const Index N = p.M.rows();
    if (N == 0) throw InputError("M", "must have at least one row", "empty");
    check_matrix("M", p.M, N);
    check_matrix("C", p.C, N);
    check_matrix("K", p.K, N);
    if (static_cast<Index>(p.contact.index) >= N)
        throw InputError("contact", "must be at most " + text(N), text(p.contact.index + 1));
    if (static_cast<Index>(p.load.index) >= N) throw InputError("load", "must be at most " + text(N), text(p.load.index + 1));
    if (!is_finite(p.beta) || p.beta < T(0)) throw InputError("beta", "must be finite and not negative", text(p.beta));
    if (steps < 2) throw InputError("steps", "must be at least 2", text(steps));
}

/// Force that holds the contact at rest against everything but its own inertia, with the sign of a pull downwards.
template <class T>
T load_on_contact(const HalfPeriodProblem<T>& p, const Vector<T>& x, const Vector<T>& x_prime, const T& cos_phi,
                  const T& sin_phi) {
    const Vector<T> load = p.C * x_prime + p.K * x - cos_phi * load_vector(p) + sin_phi * leading_load(p), w = contact_vector(p);
    const Eigen::FullPivLU<Matrix<T>> M(p.M);
    const Vector<T> inverse_column = M.solve(w);
    return inverse_column.dot(load) / w.dot(inverse_column);
}

template <class T>
void sample(const Matrix<T>& step, const Vector<T>& start, int steps, const Vector<T>& w, HalfPeriodMotion<T>& motion) {
    const Index N = motion.x_0.size();
    motion.x.resize(N, steps + 1);
    motion.x_prime.resize(N, steps + 1);
    Vector<T> z = start;
    for (int n = 0; n <= steps; ++n) {
        if (n > 0) z = Vector<T>(step * z);
        motion.x.col(n) = z.head(N);
        motion.x_prime.col(n) = z.segment(N, N);
    }
    motion.largest_contact_velocity = (w.transpose() * motion.x_prime.middleCols(1, steps - 1)).maxCoeff();
    const Vector<T> defect = (z + start).cwiseAbs();
    motion.mirror_defect = std::max<T>(defect.head(N).maxCoeff() / motion.x.cwiseAbs().maxCoeff(),
                                       defect.segment(N, N).maxCoeff() / motion.x_prime.cwiseAbs().maxCoeff());
}

/// exp(A dt) z by Taylor's series, for a short dt.
template <class T>
Matrix<T> advanced(const Matrix<T>& A, const Matrix<T>& z, const T& dt) {
    const T threshold = Eigen::NumTraits<T>::epsilon() / 1024 * row_norm(z);
    Matrix<T> term = z, sum = z;
    for (int k = 1; row_norm(term) > threshold; ++k) {
        term = product(A, term) * T(dt / k);
        sum += term;
    }
    return sum;
}

/// The instant of the largest sample of a mass, or the end of the half-period that its displacement grows from.
template <class T>
Index largest_sample(const HalfPeriodMotion<T>& motion, Index k) {
    using std::abs;
    Index best = 0;
    for (Index n = 1; n + 1 < motion.x.cols(); ++n)
        if (abs(motion.x(k, n)) > abs(motion.x(k, best))) best = n;
    return best == 0 && motion.x(k, 0) * motion.x_prime(k, 0) < T(0) ? motion.x.cols() - 1 : best;
}

/// Newton's method on x_k' from the largest sample; never further than the samples beside it.
template <class T>
void find_amplitude(const Matrix<T>& A, const T& cos_phi, const T& sin_phi, Index k, HalfPeriodMotion<T>& motion) {
    using std::abs;
    const Index N = motion.x_0.size(), n = largest_sample(motion, k);
    const T h = pi<T>() / static_cast<int>(motion.x.cols() - 1);
    const T from = h * static_cast<int>(n);
    Matrix<T> at_sample(2 * N + 3, 1);
    at_sample.block(0, 0, N, 1) = motion.x.col(n);
    at_sample.block(N, 0, N, 1) = motion.x_prime.col(n);
    at_sample(2 * N, 0) = cos_phi * cos(from) - sin_phi * sin(from);
    at_sample(2 * N + 1, 0) = sin_phi * cos(from) + cos_phi * sin(from);
    at_sample(2 * N + 2, 0) = T(1);
    const T enough = sqrt(Eigen::NumTraits<T>::epsilon());
    T dt(0), change(1);
    Matrix<T> z = at_sample;
    for (int iteration = 0; iteration < 60 && abs(change) > enough; ++iteration) {
        const T acceleration = product(A, z)(N + k, 0);
        const T next = acceleration == T(0) ? dt : T(dt - z(N + k, 0) / acceleration);
        change = -dt;
        dt = next > h ? h : next < -h ? T(-h) : next;
        change += dt;
        z = advanced(A, at_sample, dt);
    }
    motion.amplitude(k) = abs(z(k, 0));
    const T instant = from + dt + (z(k, 0) < T(0) ? pi<T>() : T(0));
    motion.phase(k) =
        atan2(T(sin_phi * cos(instant) + cos_phi * sin(instant)), T(cos_phi * cos(instant) - sin_phi * sin(instant)));
}

} // namespace

template <class T>
Matrix<T> matrix_exponential(const Matrix<T>& A) {
    const T epsilon = Eigen::NumTraits<T>::epsilon();
    if (!all_finite(A)) throw DomainError("the exponential of a matrix that is not finite was asked for");
    Matrix<T> B = A;
    int squarings = 0;
    for (T norm = row_norm(B); norm > T(1); norm = norm / 2, ++squarings) B = B / T(2);
    Matrix<T> term = Matrix<T>::Identity(A.rows(), A.cols());
    Matrix<T> sum = term;
    for (int k = 1; row_norm(term) > epsilon / 4; ++k) {
        term = product(B, term) / T(k);
        sum += term;
    }
    for (; squarings > 0; --squarings) sum = product(sum, sum);
    if (!all_finite(sum)) throw DomainError("the exponential of the matrix overflows the number type");
    return sum;
}

template <class T>
Matrix<T> augmented_system(const HalfPeriodProblem<T>& p) {
    const Index N = p.M.rows();
    const Index cosine = 2 * N, sine = 2 * N + 1, one = 2 * N + 2;
    const Eigen::FullPivLU<Matrix<T>> M(p.M);
    if (!M.isInvertible()) throw InputError("M", "must be regular", "singular");
    Matrix<T> forces = Matrix<T>::Zero(N, 2 * N + 3);
    forces.leftCols(N) = -p.K;
    forces.middleCols(N, N) = -p.C;
    forces.col(cosine) = load_vector(p);
    forces.col(sine) = -leading_load(p);
    forces.col(one) = p.beta * contact_vector(p);
    Matrix<T> A = Matrix<T>::Zero(2 * N + 3, 2 * N + 3);
    for (Index k = 0; k < N; ++k) A(k, N + k) = T(1);
    A.middleRows(N, N) = M.solve(forces);
    A(cosine, sine) = T(-1);
    A(sine, cosine) = T(1);
    return A;
}

template <class T>
HalfPeriodMotion<T> half_period_motion(const HalfPeriodProblem<T>& p, int steps) {
    check_problem(p, steps);
    const Index N = p.M.rows();
    const Vector<T> w = contact_vector(p);
    const Matrix<T> A = augmented_system(p);
    const Matrix<T> step = matrix_exponential(Matrix<T>(A * T(pi<T>() / steps)));
    const Matrix<T> half_period = power(step, steps);

    // (x, x') at tau = 0 is Y (cos phi, sin phi, 1)^T.
    const Matrix<T> free_motion = half_period.topLeftCorner(2 * N, 2 * N);
    const Eigen::FullPivLU<Matrix<T>> mirrored(free_motion + Matrix<T>::Identity(2 * N, 2 * N));
    const T rounding = 1024 * Eigen::NumTraits<T>::epsilon() * row_norm(free_motion);
    if (!(mirrored.matrixLU().diagonal().cwiseAbs().minCoeff() > rounding))
        throw DomainError("no unique motion mirrors itself after half a period: an undamped mode fits it an odd number of times");
    const Matrix<T> Y = mirrored.solve(Matrix<T>(-half_period.topRightCorner(2 * N, 3)));

    // Rest of the contact, a cos phi + b sin phi + d = 0: a line at the distance |d| / sqrt(a^2 + b^2) from the origin.
    const Vector<T> displacement = Y.topRows(N).transpose() * w, velocity = Y.bottomRows(N).transpose() * w;
    const T a = velocity(0), b = velocity(1), d = velocity(2);
    const T square = a * a + b * b;
    const T half_chord_squared = square - d * d;
    if (!(square > T(0)) || !(half_chord_squared >= T(0)))
        throw DomainError("no phase of the load brings the contact to rest at the start of the half-period: it does not slide");
    const T half_chord = sqrt(half_chord_squared);
    T c = (-a * d - b * half_chord) / square;
    T s = (-b * d + a * half_chord) / square;
    const T other_c = (-a * d + b * half_chord) / square;
    const T other_s = (-b * d - a * half_chord) / square;
    if (displacement(0) * other_c + displacement(1) * other_s > displacement(0) * c + displacement(1) * s) {
        c = other_c;
        s = other_s;
    }

    HalfPeriodMotion<T> motion;
    Vector<T> z(2 * N + 3);
    z.head(2 * N) = Y.col(0) * c + Y.col(1) * s + Y.col(2);
    if (p.w.size() == 0) z(N + static_cast<Index>(p.contact.index)) = T(0);
    z.tail(3) << c, s, T(1);
    if (!(w.dot(z.head(N)) > T(0)))
        throw DomainError("the displacement of the contact has no maximum above zero: it does not slide");
    motion.x_0 = z.head(N);
    motion.x_prime_0 = z.segment(N, N);
    motion.phi_j = atan2(s, c);
    motion.contact_load = load_on_contact(p, motion.x_0, motion.x_prime_0, c, s);
    sample(step, z, steps, w, motion);
    if (!all_finite(motion.x) || !all_finite(motion.x_prime))
        throw DomainError("the motion over the half-period overflows the number type");
    motion.amplitude.resize(N);
    motion.phase.resize(N);
    for (Index k = 0; k < N; ++k) find_amplitude(A, c, s, k, motion);
    return motion;
}

template <class T>
bool slides(const HalfPeriodMotion<T>& motion, const T& mu, const T& beta) {
    return motion.contact_load > mu * beta && motion.largest_contact_velocity < T(0);
}

template Matrix<double> matrix_exponential(const Matrix<double>&);
template Matrix<Real50> matrix_exponential(const Matrix<Real50>&);
template Matrix<Real100> matrix_exponential(const Matrix<Real100>&);
template Matrix<double> augmented_system(const HalfPeriodProblem<double>&);
template Matrix<Real50> augmented_system(const HalfPeriodProblem<Real50>&);
template Matrix<Real100> augmented_system(const HalfPeriodProblem<Real100>&);
template HalfPeriodMotion<double> half_period_motion(const HalfPeriodProblem<double>&, int);
template HalfPeriodMotion<Real50> half_period_motion(const HalfPeriodProblem<Real50>&, int);
template HalfPeriodMotion<Real100> half_period_motion(const HalfPeriodProblem<Real100>&, int);
template bool slides(const HalfPeriodMotion<double>&, const double&, const double&);
template bool slides(const HalfPeriodMotion<Real50>&, const Real50&, const Real50&);
template bool slides(const HalfPeriodMotion<Real100>&, const Real100&, const Real100&);

} // namespace denhartog
