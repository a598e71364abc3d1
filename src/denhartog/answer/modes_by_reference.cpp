#if DENHARTOG_REFERENCE
#include "denhartog/answer/modes_in_double.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/printed.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/why.hpp"

namespace denhartog {

using namespace reference;

namespace {

constexpr slong first_bits = 128, most_bits = 1024;
constexpr double nearly_rounding = 1e-14; // what a number may be off by, relative, in place of its rounding to double

Matrix<Bounded<double>> in_double(const BallMatrix& A) {
    Matrix<Bounded<double>> out(A.rows(), A.columns());
    for (slong i = 0; i < A.rows(); ++i)
        for (slong k = 0; k < A.columns(); ++k) out(i, k) = in_double(A(i, k));
    return out;
}

Matrix<double> values_of(const Matrix<Bounded<double>>& A) {
    return A.unaryExpr([](const Bounded<double>& a) { return a.x; });
}

// A number that may be zero, as far as all the bits tell beside the largest of its kind, is zero.
Ball zero_or_itself(const Ball& x, double largest) {
    const bool nothing = x.may_vanish() && abs(x).high() <= std::ldexp(largest, -static_cast<int>(ball_bits / 2));
    return nothing ? widened(Ball(0), upper_bound_of(abs(x))) : x;
}

// Rows of the mode shapes as double has them: of the masses, and those of contact and load that are no rows of masses.
std::vector<std::size_t> rows_in_balls(const System<double>& s) {
    const std::size_t N = number_of_masses(s);
    std::vector<std::size_t> rows(N);
    for (std::size_t k = 0; k < N; ++k) rows[k] = k;
    if (contact_moves_apart(s)) rows.push_back(N);
    if (load_row(s).index == rows.size()) rows.push_back(N + 1);
    if (load_rows(s).im) rows.push_back(N + 2);
    return rows;
}

// The modes, with the signs that `fix_signs` gives the shapes.
ModesInBalls signed_modes(const SceneInBalls& s) {
    ModesInBalls m = modes_in_balls(s);
    Matrix<double> phi(s.N(), s.N());
    for (slong k = 0; k < s.N(); ++k)
        for (slong i = 0; i < s.N(); ++i)
            phi(k, i) = static_cast<double>(m.psi[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)]);
    const Matrix<double> before = phi;
    fix_signs(phi);
    for (slong i = 0; i < s.N(); ++i)
        if (phi.col(i) != before.col(i))
            for (std::vector<Ball>& row : m.psi) row[static_cast<std::size_t>(i)] = -row[static_cast<std::size_t>(i)];
    return m;
}

// Any orthonormal shapes may stand for those of modes that coincide.
void widen_shapes(const ModesInBalls& m, ModalBasis<Bounded<double>>& basis) {
    for (const ModeCluster& c : m.clusters)
        for (Eigen::Index k = 0; k < basis.phi.rows(); ++k) {
            auto shapes =
                basis.phi.row(k).segment(static_cast<Eigen::Index>(c.first), static_cast<Eigen::Index>(c.last - c.first));
            double squares = 0;
            for (const Bounded<double>& entry : shapes) squares += entry.most() * entry.most();
            for (Bounded<double>& entry : shapes) entry.e = 2 * std::sqrt(squares) * (1 + 1e-9);
        }
}

void set_damping(const SceneInBalls& s, const ModesInBalls& m, ModalBasis<Bounded<double>>& basis) {
    if (!s.zeta.empty()) {
        for (const Ball& zeta : s.zeta) basis.zeta.push_back(in_double(zeta));
        return;
    }
    BallMatrix D = damping_of_modes(s, m);
    const double largest = norm(D);
    Ball apart(0), sum_of_squares(0), sum_of_D(0); // AB - BA in the modes, where A is diagonal
    for (slong i = 0; i < s.N(); ++i) {
        if (D(i, i) < Ball(0))
            throw InputError("damping_matrix",
                             "must give mode " + std::to_string(i + 1) + " a damping ratio that is not negative",
                             printed(D(i, i) * m.R[static_cast<std::size_t>(i)] / 2, 17).decimal);
        const Ball &R_i = m.R[static_cast<std::size_t>(i)], square = 1 / (R_i * R_i);
        sum_of_squares += square * square;
        for (slong k = 0; k < s.N(); ++k) {
            const Ball& R_k = m.R[static_cast<std::size_t>(k)];
            const Ball part = (square - 1 / (R_k * R_k)) * D(i, k);
            apart += part * part;
            sum_of_D += D(i, k) * D(i, k);
        }
    }
    if (!sum_of_D.is_zero())
        basis.distance_from_classical = in_double(root_of_positive(apart) / root_of_positive(sum_of_squares * sum_of_D));
    for (slong i = 0; i < s.N(); ++i)
        for (slong k = 0; k < s.N(); ++k) {
            D(i, k) = zero_or_itself(D(i, k), largest);
            if (i == k) basis.zeta.push_back(in_double(D(i, i) * m.R[static_cast<std::size_t>(i)] / 2));
        }
    if (s.N() > 1) basis.D = in_double(D);
    for (Eigen::Index i = 0; i < basis.D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k) basis.couples = basis.couples || basis.D(i, k).least() > 0;
}

ModalBasis<Bounded<double>> basis_of(const SceneInBalls& s, const ModesInBalls& m, const System<double>& system) {
    const std::size_t N = m.R.size();
    ModalBasis<Bounded<double>> basis;
    for (const Ball& R : m.R) basis.r_n.push_back(in_double(1 / R));
    const std::vector<std::size_t> rows = rows_in_balls(system);
    basis.phi.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(N));
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (std::size_t i = 0; i < N; ++i)
            basis.phi(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) = in_double(m.psi[rows[k]][i]);
    set_damping(s, m, basis);
    return basis;
}

bool is_nearly_rounded(const Bounded<double>& x) { return x.x == 0 || x.e <= nearly_rounding * std::abs(x.x); }

// A mode shape has its digits beside its largest entry.
bool is_nearly_rounded(const ModalBasis<Bounded<double>>& basis) {
    const auto all = [](const auto& numbers) {
        return std::ranges::all_of(numbers, [](const Bounded<double>& x) { return is_nearly_rounded(x); });
    };
    for (const auto& shape : basis.phi.colwise()) {
        Bounded<double> largest(0);
        for (const Bounded<double>& entry : shape)
            largest = {std::max(largest.x, std::abs(entry.x)), std::max(largest.e, entry.e)};
        if (!is_nearly_rounded(largest)) return false;
    }
    return all(basis.r_n) && all(basis.zeta);
}

// Whether all modes are told apart. If twice the bits do not help, nothing will.
bool told_apart(const ModesInBalls& m, slong bits) {
    if (m.clusters.empty()) return true;
    if (bits > first_bits) throw PrecisionError(Why::frequencies_coincide);
    return false;
}

evaluation::ModeFunctions<Ball> functions_of_mode(const Ball& R, const Ball& zeta) {
    if (!is_told_from_critical(zeta)) {
        const ResponsesInBalls r = responses_of_one_mass(R, zeta);
        return {r.V[0], r.U[0], r.G[0]};
    }
    const FrictionMotionOfMode F(R, zeta);
    return {paper::complex_response(R, zeta), F.u, F.g};
}

// The displacements of the masses are O times those with that of the contact in the place of that of mass a, see `Contact`.
BallMatrix with_contact(const SceneInBalls& s, slong a) {
    BallMatrix O = unit_matrix(s.N());
    for (slong k = 0; k < s.N(); ++k)
        if (k == a || !s.w(k).is_zero()) O(a, k) = (k == a ? Ball(1) : -s.w(k)) / s.w(a);
    return O;
}

// Without row and column j.
BallMatrix of_others(const BallMatrix& A, slong j) {
    BallMatrix out(A.rows() - 1, A.rows() - 1);
    for (slong i = 0; i < out.rows(); ++i)
        for (slong k = 0; k < out.rows(); ++k) out(i, k) = A(i < j ? i : i + 1, k < j ? k : k + 1);
    return out;
}

// Gives nothing where the frequencies do not have their digits.
std::optional<RoundedModes> held_modes(const SceneInBalls& s, const ModesInBalls& sliding, const System<double>& system) {
    const auto j = static_cast<slong>(contact_of(contact_vector(system), mass_matrix(system)).a);
    const BallMatrix O = with_contact(s, j), back = transposed(O), C = back * s.C * O;
    RoundedModes held{values_of(in_double(transposed(shapes_of(sliding)) * s.M)), values_of(in_double(C)), {}, {}, {}};
    if (s.N() == 1) return held;
    SceneInBalls others{of_others(back * s.M * O, j), of_others(back * s.K * O, j), of_others(C, j)};
    others.w = others.p = BallMatrix(others.N(), 1);
    others.r = Ball(1);
    others.kept = s.kept;
    others.effort = s.effort;
    const ModesInBalls m = modes_in_balls(others);
    const BallMatrix D = damping_of_modes(others, m);
    const double largest = norm(D);
    held.phi.resize(others.N(), others.N());
    held.damping.resize(others.N(), others.N());
    for (slong i = 0; i < others.N(); ++i) {
        const Bounded<double> r_n = in_double(1 / m.R[static_cast<std::size_t>(i)]);
        const Bounded<double> damping = in_double(zero_or_itself(D(i, i), largest));
        if (!is_nearly_rounded(r_n) || !is_nearly_rounded(damping)) return std::nullopt;
        held.r_n.push_back(r_n.x);
        for (slong k = 0; k < others.N(); ++k) {
            held.phi(k, i) = in_double(m.psi[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)]).x;
            const Bounded<double> between = in_double(zero_or_itself(D(std::max(i, k), std::min(i, k)), largest));
            held.damping(k, i) = std::abs(between.x) > between.e ? between.x : 0;
        }
    }
    return held;
}

} // namespace

ModalBasis<Bounded<double>> modes_by_reference(const SceneSource& source, bool coinciding) {
    const System<double>& system = source->in_double().system;
    return with_more_bits(source, first_bits, most_bits, [&](const SceneSource& paid, slong bits, bool) {
        std::optional<ModalBasis<Bounded<double>>> basis;
        const SceneInBalls s = scene_at_one(paid);
        const ModesInBalls m = signed_modes(s);
        if (!coinciding && !told_apart(m, bits)) return basis;
        basis = basis_of(s, m, system);
        if (!is_nearly_rounded(*basis)) basis.reset();
        if (basis) widen_shapes(m, *basis);
        return basis;
    });
}

std::vector<evaluation::ModeFunctions<Bounded<double>>> mode_functions_by_reference(const SceneSource& source) {
    const double tolerance = tolerance_of(digits_by_default);
    return with_more_bits(source, first_bits, most_bits, [&](const SceneSource& paid, slong bits, bool last) {
        std::optional<std::vector<evaluation::ModeFunctions<Bounded<double>>>> functions;
        const SceneInBalls s = scene_in_balls(paid);
        const ModesInBalls m = modes_in_balls(s);
        if (!told_apart(m, bits)) return functions;
        functions.emplace();
        BallMatrix D;
        if (s.zeta.empty()) D = damping_of_modes(s, m);
        bool enough = true;
        for (std::size_t i = 0; i < m.R.size(); ++i) {
            const auto n = static_cast<slong>(i);
            const Ball zeta = s.zeta.empty() ? D(n, n) * m.R[i] * s.r / 2 : s.zeta[i];
            const evaluation::ModeFunctions<Ball> f = functions_of_mode(m.R[i], zeta);
            const Ball size = root_of_positive(squared_modulus(f.v));
            if (!size.finite() || !f.u.finite() || !f.g.finite()) throw Unproved(Why::may_be_pole);
            functions->push_back({{in_double(f.v.re), in_double(f.v.im)}, in_double(f.u), in_double(f.g)});
            for (const Bounded<double>& x : {in_double(size), functions->back().u, functions->back().g})
                enough = enough && relative_error(x) <= tolerance;
        }
        if (!enough && !last) functions.reset();
        return functions;
    });
}

SystemByReference system_by_reference(const SceneSource& source) {
    const System<double>& system = source->in_double().system;
    return with_more_bits(source, first_bits, most_bits, [&](const SceneSource& paid, slong, bool) {
        std::optional<SystemByReference> found;
        SceneInBalls s = scene_at_one(paid);
        const ModesInBalls m = signed_modes(s);
        ModalBasis<Bounded<double>> basis = basis_of(s, m, system);
        if (!is_nearly_rounded(basis)) return found;
        if (!s.zeta.empty()) s.C = damping_matrix_in_balls(s, m);
        if (std::optional<RoundedModes> held = held_modes(s, m, system)) {
            widen_shapes(m, basis);
            found = {std::move(basis), *std::move(held)};
        }
        return found;
    });
}

} // namespace denhartog
#endif
