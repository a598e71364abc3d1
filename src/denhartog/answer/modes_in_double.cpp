// The modes of a system, (14) to (18), in double: those of double where they have their digits; else those of the
// reference, rounded, whose part of the file begins with `DENHARTOG_REFERENCE`.
#include "denhartog/answer/modes_in_double.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#if DENHARTOG_REFERENCE
#include "denhartog/answer/reference_point.hpp"
#endif

namespace denhartog {
namespace {

double relative_error(const ModalBasis<Bounded<double>>& basis) {
    double largest = 0;
    for (const Bounded<double>& x : sizes_in(basis)) largest = std::max(largest, relative_error(x));
    return largest;
}

using ModeFunctionsInDouble = std::vector<evaluation::ModeFunctions<Bounded<double>>>;

double relative_error(const ModeFunctionsInDouble& functions) {
    double largest = 0;
    for (const auto& f : functions)
        largest = std::max({largest, relative_error(modulus(f.v)), relative_error(f.u), relative_error(f.g)});
    return largest;
}

constexpr std::size_t most_masses_by_reference = 200; // beyond, the reference takes too long

bool is_for_reference(const SceneSource& source, double error) {
    if (error <= tolerance_of(digits_by_default) || number_of_masses(source->in_double().system) > most_masses_by_reference)
        return false;
    count_precision_step();
    return true;
}

} // namespace

std::vector<Bounded<double>> sizes_in(const ModalBasis<Bounded<double>>& basis) {
    std::vector<Bounded<double>> sizes = basis.r_n;
    sizes.insert(sizes.end(), basis.zeta.begin(), basis.zeta.end());
    for (const auto& shape : basis.phi.colwise()) {
        Bounded<double>& largest = sizes.emplace_back(0);
        for (const Bounded<double>& entry : shape) largest = larger(largest, {size_of_number(entry.x), entry.e});
    }
    return sizes;
}

ModesInDouble modes_in_double(const SceneSource& source) {
    auto found = tried([&] { return modes_with_errors(source->in_double().system, source->effort); });
    if (found.is_answered()) return {*std::move(found.value)};
    return {std::make_shared<const ModalBasis<Bounded<double>>>(std::move(modes_by_reference(source, true).required())),
            found.why};
}

std::shared_ptr<const ContactSystem> moving_in_double(const SceneSource& source, const ModesInDouble& modes) {
    Tried<ContactSystem> system(Outcome::digits_missing, modes.rounded_because);
    if (modes.rounded_because.empty())
        system = tried([&] { return contact_system(source->in_double().system, *modes.basis, nullptr, source->effort); });
    if (!system.is_answered()) system = moving_by_reference(source, system.why);
    return std::make_shared<const ContactSystem>(std::move(system.required()));
}

std::optional<CoupledDamping> coupled_damping(const SceneSource& source) {
    const System<double>& system = source->in_double().system;
    if (system.damping_matrix.size() == 0) return std::nullopt;
    const SceneSource as_given = with_damping_tolerance(source, 0);
    std::shared_ptr<const ModalBasis<Bounded<double>>> modes = modes_in_double(as_given).basis;
    if (!modes->couples) modes = certain_modes(as_given, modes);
    if (!modes->couples) return std::nullopt;
    ModalBasis<double> basis = values_of(*modes);
    return CoupledDamping{basis.distance_from_classical > system.damping_tolerance, basis.distance_from_classical,
                          largest_coupling(basis.D), std::move(basis.zeta)};
}

std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    if (!is_for_reference(source, relative_error(*basis))) return basis;
    Tried<ModalBasis<Bounded<double>>> modes = modes_by_reference(source, false);
    return modes.is_answered() ? std::make_shared<const ModalBasis<Bounded<double>>>(*std::move(modes.value)) : basis;
}

ModeFunctionsInDouble certain_mode_functions(const SceneSource& source,
                                             const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis) {
    Tried<ModeFunctionsInDouble> functions = tried([&] { return mode_functions_at(*basis, as_input(*source->in_double().r)); });
    if (is_for_reference(source, functions.outcome == Outcome::at_a_pole ? 1 : relative_error(functions.required()))) {
        Tried<ModeFunctionsInDouble> proved = mode_functions_by_reference(source);
        if (proved.is_answered()) return *std::move(proved.value);
    }
    return std::move(functions.required());
}

#if DENHARTOG_REFERENCE

namespace {

using namespace reference;

constexpr double nearly_rounding = 1e-14; // relative error of a number, in place of its rounding to double

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
    for (slong i = 0; i < s.N(); ++i)
        if (D(i, i) < Ball(0))
            throw InputError("damping_matrix",
                             "must give mode " + std::to_string(i + 1) + " a damping ratio that is not negative",
                             printed(D(i, i) * m.R[static_cast<std::size_t>(i)] / 2, 17).decimal);
    const Commutator c = commutator_of(m, D);
    if (!c.size.is_zero()) basis.distance_from_classical = in_double(root_of_positive(c.apart) / root_of_positive(c.size));
    for (slong i = 0; i < s.N(); ++i)
        for (slong k = 0; k < s.N(); ++k) {
            D(i, k) = zero_or_itself(D(i, k), largest);
            if (i == k) basis.zeta.push_back(in_double(D(i, i) * m.R[static_cast<std::size_t>(i)] / 2));
        }
    if (s.N() > 1) basis.D = in_double(D);
    for (Eigen::Index i = 0; i < basis.D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k) basis.couples = basis.couples || basis.D(i, k).least() > 0;
}

bool is_nearly_rounded(const Bounded<double>& x) { return x.x == 0 || x.e <= nearly_rounding * std::abs(x.x); }

// None where numbers do not have their digits.
std::optional<ModalBasis<Bounded<double>>> basis_of(const SceneInBalls& s, const ModesInBalls& m, const System<double>& system) {
    const std::size_t N = m.R.size();
    ModalBasis<Bounded<double>> basis;
    for (const Ball& R : m.R) basis.r_n.push_back(in_double(1 / R));
    const std::vector<std::size_t> rows = rows_in_balls(system);
    basis.phi.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(N));
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (std::size_t i = 0; i < N; ++i)
            basis.phi(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) = in_double(m.psi[rows[k]][i]);
    set_damping(s, m, basis);
    if (!std::ranges::all_of(sizes_in(basis), is_nearly_rounded)) return std::nullopt;
    widen_shapes(m, basis);
    return basis;
}

// True of modes that are all told apart. If twice the bits do not help, nothing will.
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

// A matrix without row and column j.
BallMatrix without_row_of(const BallMatrix& A, slong j) {
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
    SceneInBalls others{without_row_of(back * s.M * O, j), without_row_of(back * s.K * O, j), without_row_of(C, j)};
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

Tried<ModalBasis<Bounded<double>>> modes_by_reference(const SceneSource& source, bool coinciding) {
    const System<double>& system = source->in_double().system;
    return with_more_bits(source, first_bits, most_bits, [&](const SceneSource& paid, slong bits, bool) {
        const SceneInBalls s = scene_at_one(paid);
        const ModesInBalls m = signed_modes(s);
        return coinciding || told_apart(m, bits) ? basis_of(s, m, system) : std::nullopt;
    });
}

Tried<ModeFunctionsInDouble> mode_functions_by_reference(const SceneSource& source) {
    const double tolerance = tolerance_of(digits_by_default);
    return with_more_bits(source, first_bits, most_bits, [&](const SceneSource& paid, slong bits, bool last) {
        std::optional<ModeFunctionsInDouble> functions;
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
            const Ball size = size_in_balls(f.v);
            if (!size.finite() || !f.u.finite() || !f.g.finite()) throw Unproved(Why::may_be_pole);
            functions->push_back({{in_double(f.v.re), in_double(f.v.im)}, in_double(f.u), in_double(f.g)});
            for (const Bounded<double>& x : {in_double(size), functions->back().u, functions->back().g})
                enough = enough && relative_error(x) <= tolerance;
        }
        if (!enough && !last) functions.reset();
        return functions;
    });
}

Tried<ContactSystem> moving_by_reference(const SceneSource& source, const Reasons& because) {
    const System<double>& system = source->in_double().system;
    return with_more_bits(source, first_bits, most_bits, [&](const SceneSource& paid, slong, bool) {
        std::optional<ContactSystem> moving;
        SceneInBalls s = scene_at_one(paid);
        const ModesInBalls m = signed_modes(s);
        const std::optional<ModalBasis<Bounded<double>>> basis = basis_of(s, m, system);
        if (!basis) return moving;
        if (!s.zeta.empty()) s.C = damping_matrix_in_balls(s, m);
        const std::optional<RoundedModes> held = held_modes(s, m, system);
        if (!held) return moving;
        moving = contact_system(system, *basis, &*held);
        moving->rounded_because = because;
        return moving;
    });
}

#endif

} // namespace denhartog
