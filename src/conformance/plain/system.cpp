// The system of a question as matrices, M, K and C of (8), (73) and (19), with the rows of contact and load, and its responses
// without friction and with the contact held. Read `plain_system` first.
#include "conformance/plain/system.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

PlainMatrix by_rows(const std::vector<double>& entries, Index N) {
    return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(entries.data(), N, N);
}

// A question may break any rule: without masses, springs and a frequency there is no answer.
void require_system(const ProtocolQuestion& q, std::size_t N) {
    const auto is = [&](const std::vector<double>& numbers, const std::vector<double>& matrix, double least) {
        if (!matrix.empty()) return matrix.size() == N * N;
        return numbers.size() == N && std::ranges::all_of(numbers, [&](double x) { return x >= least && std::isfinite(x); });
    };
    constexpr double positive = 1e-300;
    const bool is_system = is(q.mass_ratios, q.mass_matrix, positive) && is(q.stiffness_ratios, q.stiffness_matrix, positive) &&
                           is(q.damping_ratios, q.damping_matrix, 0) && (q.loads.empty() || q.loads.size() == N) &&
                           (q.load_phases.empty() || q.load_phases.size() == q.loads.size());
    if (N == 0 || !is_system || !(q.r > 0) || !std::isfinite(q.r) || (!is_of_the_paper(q) && !(q.beta >= 0)))
        throw NoPlainAnswer();
}

// The ratios of a damping matrix, and whether it couples the modes.
void read_damping(PlainSystem& s) {
    const PlainMatrix in_modes = s.phi.transpose() * s.C * s.phi;
    s.zeta = in_modes.diagonal().cwiseQuotient(2 * s.r_n);
    for (Index i = 0; i < s.size(); ++i)
        for (Index k = 0; k < i; ++k)
            if (std::abs(in_modes(i, k)) > 1e-13 * std::sqrt(in_modes(i, i) * in_modes(k, k))) s.coupled = true;
}

// The load of the forces of the question; if there are none, that of the base or wall that moves: by inertia in the frame of a
// wall, by springs and dampers if it moves alone.
void read_load(PlainSystem& s, const ProtocolQuestion& q) {
    const Index N = s.size();
    const bool with_wall = q.base_motion == "with_wall", wall = q.base_motion == "wall";
    s.p_i = PlainVector::Zero(N);
    if (!q.base_motion.empty()) {
        s.base = with_wall ? 1 / (s.r * s.r) : 1; // P is m_1 omega^2 X, or k_1 X
        s.frame = with_wall || wall ? s.base : 0;
        s.base_stays = wall;
    }
    if (!q.loads.empty() || q.base_motion.empty()) {
        s.p = q.loads.empty() ? place_of(q.load, N) : row_of_list(q.loads);
        for (std::size_t k = 0; k < q.load_phases.size(); ++k) {
            s.p_i[k] = s.p[k] * elementary::sin(q.load_phases[k]);
            s.p[k] *= elementary::cos(q.load_phases[k]);
        }
        return;
    }
    const PlainVector masses = s.M.rowwise().sum(), springs = s.K.rowwise().sum();
    s.p = with_wall ? masses : springs;
    if (wall) s.p = s.r * s.r * masses - springs;
    if (!with_wall) s.p_i = (wall ? -s.r : s.r) * s.C.rowwise().sum();
}

} // namespace

double modulus(const Phasor& a) { return elementary::hypot(a.real(), a.imag()); }
double argument(const Phasor& a) { return elementary::atan2(a.imag(), a.real()); }
double times_cosine(const Phasor& a, double tau) { return a.real() * elementary::cos(tau) - a.imag() * elementary::sin(tau); }

PlainVector solved(const PlainMatrix& A, const PlainVector& b) { return A.partialPivLu().solve(b); }

Phasors solved(const PlainMatrix& A, const PlainMatrix& B, const PlainVector& b, const PlainVector& b_i) {
    const Index n = b.size();
    PlainMatrix both(2 * n, 2 * n); // of real and imaginary parts
    PlainVector right(2 * n);
    both << A, -B, B, A;
    right << b, b_i;
    const PlainVector parts = solved(both, right);
    Phasors X(n);
    for (Index i = 0; i < n; ++i) X[i] = {parts[i], parts[n + i]};
    return X;
}

PlainShapes shapes_of(const PlainMatrix& B, const PlainMatrix& M) {
    const Eigen::LLT<PlainMatrix> triangle(M);
    const PlainMatrix over_triangle = triangle.matrixL().solve(B.transpose()).transpose();
    const Eigen::JacobiSVD<PlainMatrix> modes(over_triangle, Eigen::ComputeFullV);
    return {modes.singularValues().reverse(), triangle.matrixU().solve(modes.matrixV()).rowwise().reverse()};
}

double zero_between(const std::function<double(double)>& f, double from, double to) {
    const double before = f(from), after = f(to);
    if (before == 0) return from;
    if (!(before * after < 0)) return to;
    std::uintmax_t most = 200;
    const auto [a, b] =
        boost::math::tools::toms748_solve(f, from, to, before, after, boost::math::tools::eps_tolerance<double>(52), most);
    return (a + b) / 2;
}

PlainVector row_of_list(const std::vector<double>& list) { return Eigen::Map<const PlainVector>(list.data(), std::ssize(list)); }

PlainVector place_of(int mass, Index N) {
    if (mass < 1 || mass > N) throw NoPlainAnswer();
    return PlainVector::Unit(N, mass - 1);
}

PlainSystem plain_system(const ProtocolQuestion& q) {
    const auto N = static_cast<Index>(masses_of(q));
    require_system(q, masses_of(q));
    PlainSystem s;
    s.r = q.r;
    s.beta = q.beta;
    s.mu = q.mu;
    s.M = q.mass_matrix.empty() ? PlainMatrix(row_of_list(q.mass_ratios).asDiagonal()) : by_rows(q.mass_matrix, N);
    const bool is_chain = q.stiffness_matrix.empty();
    if (!is_chain) s.K = by_rows(q.stiffness_matrix, N);
    const PlainMatrix springs = is_chain ? springs_of(q.stiffness_ratios, 0, N) : PlainMatrix(s.K.llt().matrixU());
    if (is_chain) { // without the rounding of the roots, so that forces of springs which cancel do so here
        const PlainMatrix elongations = springs.array().sign();
        s.K = elongations.transpose() * row_of_list(q.stiffness_ratios).asDiagonal() * elongations;
    }
    static_cast<PlainShapes&>(s) = shapes_of(springs, s.M);
    if (q.damping_matrix.empty()) {
        s.zeta = row_of_list(q.damping_ratios);
        s.C = damping_in_modes(s.M * s.phi, 2 * s.zeta.cwiseProduct(s.r_n)); // (19)
    } else {
        s.C = by_rows(q.damping_matrix, N);
        read_damping(s);
    }
    s.w = place_of(q.contact, N);
    if (q.contact_with != 0) s.w -= place_of(q.contact_with, N);
    read_load(s, q);
    return s;
}

PlainMatrix damping_in_modes(const PlainMatrix& momenta, const PlainVector& of_modes) {
    return momenta * of_modes.asDiagonal() * momenta.transpose();
}

Phasors plain_response(const PlainSystem& s, const PlainVector& b, const PlainVector& b_i) {
    return solved(s.dynamic_stiffness(), s.r * s.C, b, b_i);
}

Phasors plain_response_from_ground(const PlainSystem& s) {
    const double moves = s.base_stays ? 0 : s.base;
    return plain_response(s, moves * s.K.rowwise().sum(), moves * s.r * s.C.rowwise().sum());
}

Phasors held_response(const PlainSystem& s) {
    const Index N = s.size();
    PlainMatrix D(N + 1, N + 1), C = PlainMatrix::Zero(N + 1, N + 1);
    D << s.dynamic_stiffness(), s.w, s.w.transpose(), 0;
    C.topLeftCorner(N, N) = s.r * s.C;
    PlainVector load(N + 1), load_i(N + 1);
    load << s.p, 0;
    load_i << s.p_i, 0;
    return solved(D, C, load, load_i);
}

PlainMatrix springs_of(const std::vector<double>& kappa, Index from, Index to) {
    const Index last = std::min<Index>(to, std::ssize(kappa) - 1);
    PlainMatrix rows = PlainMatrix::Zero(last - from + 1, to - from);
    for (Index n = from; n <= last; ++n) {
        const double root = std::sqrt(kappa[n]);
        if (n < to) rows(n - from, n - from) = root;
        if (n > from) rows(n - from, n - 1 - from) = -root;
    }
    return rows;
}

} // namespace denhartog::conformance
