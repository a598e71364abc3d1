// The equations (6) as a system of first order, for a contact that slides either way or is held, and the load on the contact,
// (75), with the bound of its rounding. Read the constructor, which sets up a matrix for each kind of phase.
#include "denhartog/paper_algorithm/contact_equations.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "denhartog/formulas/stuck.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/bounded_modes.hpp"

namespace denhartog {
namespace {

void check_matrix(const Matrix<double>& A, Eigen::Index N, const char* name) {
    if (A.rows() != N || A.cols() != N)
        throw InputError(name, "must be " + std::to_string(N) + " x " + std::to_string(N),
                         std::to_string(A.rows()) + " x " + std::to_string(A.cols()));
    if (!A.allFinite()) throw InputError(name, "must have finite entries", "");
}

void check(const ContactProblem& p) {
    const Eigen::Index N = p.matrices.M.rows();
    if (N < 1) throw InputError("M", "must have one row for each mass", "no rows");
    check_matrix(p.matrices.M, N, "M");
    check_matrix(p.matrices.C, N, "C");
    check_matrix(p.matrices.K, N, "K");
    const auto index = [N](const char* name, Mass m) {
        if (m.index >= static_cast<std::size_t>(N))
            throw InputError(name, "must be from 1 to " + std::to_string(N), std::to_string(m.index + 1));
    };
    index("contact", p.contact);
    if (p.load_vector.empty()) index("load", p.load);
    if (!p.load_phases.empty() &&
        (p.load_phases.size() != static_cast<std::size_t>(N) || p.load_vector.size() != p.load_phases.size()))
        throw InputError("load_phases", "must have one value for each mass, beside as many forces",
                         std::to_string(p.load_phases.size()));
    if (p.contact_with) index("contact", *p.contact_with);
    if (const std::vector<double>& w = p.contact_direction; !w.empty() && std::ssize(w) != N)
        throw InputError("direction", "must have " + std::to_string(N) + " values", std::to_string(w.size()));
    if (!p.static_load.empty() && std::ssize(p.static_load) != N)
        throw InputError("static_load", "must have " + std::to_string(N) + " values", std::to_string(p.static_load.size()));
    if (!(p.mu >= 1) || !std::isfinite(p.mu)) throw InputError("mu", "must be finite and at least 1", number_to_text(p.mu));
    if (!(p.beta >= 0) || !std::isfinite(p.beta))
        throw InputError("beta", "must be finite and not negative", number_to_text(p.beta));
}

} // namespace

ContactProblem contact_problem(const Scene<double>& scene) {
    check(scene);
    (void)frequency_ratio_of(scene);
    (void)friction_ratio_of(scene);
    const System<double> s = with_load_at(scene.system, *scene.r);
    return {non_dimensional_matrices(s, modal_basis(s), *scene.r),
            s.contact,
            s.load,
            scene.mu,
            *scene.beta,
            s.contact_with,
            s.contact_direction,
            s.load_vector,
            s.load_phases,
            scene.static_load};
}

ContactEquations::ContactEquations(const ContactProblem& p) : beta(p.beta), mu(p.mu) {
    check(p);
    const auto& [M, C, K] = p.matrices;
    const Eigen::Index rows = M.rows();
    System<double> places; // of contact and load
    places.mass_ratios.resize(static_cast<std::size_t>(rows));
    places.contact = p.contact, places.load = p.load, places.contact_with = p.contact_with, places.load_vector = p.load_vector;
    places.load_phases = p.load_phases, places.contact_direction = p.contact_direction;
    out_of_phase_ = !p.load_phases.empty();
    const std::vector<double> w_entries = contact_vector(places);
    contact = contact_of(w_entries, M);
    std::vector<double> p_re, p_im;
    for (const Complex<double>& each : complex_load(places)) {
        p_re.push_back(each.re);
        p_im.push_back(each.im);
    }
    const Eigen::Map<const Eigen::VectorXd> w(w_entries.data(), rows), load(p_re.data(), rows), ahead(p_im.data(), rows);
    const Eigen::LLT<Matrix<double>> factor(M);
    if (factor.info() != Eigen::Success) throw InputError("M", "must be positive definite", "");
    const Matrix<double> inverse = factor.solve(Matrix<double>::Identity(rows, rows));
    N = static_cast<std::size_t>(rows);
    const Eigen::VectorXd contact_acceleration = inverse * w;
    compliance = contact.of(contact_acceleration);

    Matrix<double> forces(rows, 2 * rows); // by springs and dampers, per unit of y
    forces << -K, -C;
    const Matrix<double> accelerations = inverse * forces;
    // With the contact held, the reaction takes its acceleration away.
    const Matrix<double> held = contact_acceleration / compliance;
    Matrix<double> held_accelerations = accelerations - held * contact.row_of(accelerations);
    contact.hold(held_accelerations);
    const auto held_force = [&](const Matrix<double>& acceleration) {
        Matrix<double> held_load = acceleration - held * contact.row_of(acceleration);
        contact.hold(held_load);
        return held_load;
    };
    const Matrix<double> load_acceleration = inverse * load, ahead_acceleration = inverse * ahead;
    if (!p.static_load.empty()) {
        const Matrix<double> static_acceleration = inverse * Eigen::Map<const Eigen::VectorXd>(p.static_load.data(), rows);
        sliding_static_ = static_acceleration;
        sticking_static_ = held_force(static_acceleration);
        static_load = contact.of(static_acceleration.col(0)) / compliance;
    }
    // The contact's row with the accelerations of the others eliminated; for a diagonal M it is row j itself.
    const Matrix<double> row = contact_acceleration.transpose() / compliance * forces;
    contact_row_ = -row;
    sliding_ = accelerations;
    sticking_ = held_accelerations;
    sliding_load_ = load_acceleration;
    sticking_load_ = held_force(load_acceleration);
    sliding_ahead_ = ahead_acceleration;
    sticking_ahead_ = held_force(ahead_acceleration);
    contact_column_ = contact_acceleration;
    friction_.resize(rows);
    const auto a = static_cast<Eigen::Index>(contact.a);
    harmonic_load = {contact_acceleration.dot(load) / compliance, contact_acceleration.dot(ahead) / compliance};
    direct_load_ = {contact.over(load(a)), contact.over(ahead(a))};
    inertial_load_ = {harmonic_load.re - direct_load_.re, harmonic_load.im - direct_load_.im};
    if (!(sliding_.allFinite() && sticking_.allFinite() && sliding_load_.allFinite() && contact_row_.allFinite()))
        throw InputError("M", "must not be singular to working precision", "");
    set(1);
}

void ContactEquations::set(int direction) {
    rows_ = (direction == 0 ? sticking_ : sliding_).data();
    load_column_ = (direction == 0 ? sticking_load_ : sliding_load_).data();
    ahead_column_ = (direction == 0 ? sticking_ahead_ : sliding_ahead_).data();
    friction_ = (-direction * beta) * contact_column_;
    if (sliding_static_.size() > 0) friction_ += direction == 0 ? sticking_static_ : sliding_static_;
}

double ContactEquations::load_on_contact(std::span<const double> y, double tau) const {
    const std::span<const double> row(contact_row_.data(), 2 * N);
    double load =
        paper::dynamic_load_on_contact<double>(row.subspan(N), row.first(N), y.first(N), y.subspan(N), direct_load_.re, tau);
    if (out_of_phase_) load += harmonic_load.im * elementary::sin(tau);
    return (inertial_load_.re == 0 ? -load : inertial_load_.re * elementary::cos(tau) - load) + static_load;
}

double ContactEquations::load_error(std::span<const double> y) const {
    double size = std::abs(harmonic_load.re) + std::abs(harmonic_load.im) + mu * beta + std::abs(static_load);
    for (std::size_t n = 0; n < 2 * N; ++n) size += std::abs(contact_row_.data()[n] * y[n]);
    return 16 * std::numeric_limits<double>::epsilon() * size;
}

} // namespace denhartog
