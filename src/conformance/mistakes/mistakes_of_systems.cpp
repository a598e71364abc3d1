#include <algorithm>
#include <cmath>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/modal_basis.hpp"

namespace denhartog::conformance {
namespace {

// A mistake in what only systems beyond the paper have: it says nothing of a question that the change leaves as it is.
MistakeDefinition of_systems(std::string name, std::string equation, std::string told, std::string look_at,
                             std::function<bool(ProtocolQuestion&)> change) {
    return {{std::move(name), std::move(equation), false, std::move(told), std::move(look_at)},
            [change = std::move(change)](const ProtocolQuestion& q) {
                ProtocolQuestion other = q;
                return change(other) ? plain_answer(other) : std::nullopt;
            }};
}

std::vector<double> row_sums(const Matrix<double>& A) {
    const Eigen::VectorXd sums = A.rowwise().sum();
    return {sums.begin(), sums.end()};
}

std::vector<MistakeDefinition> of_contacts() {
    return {
        of_systems("second-contact-mass-ignored", "4",
                   "Of a contact between two masses the first alone is taken: it rubs against a wall.",
                   "how contact is read where it is a list: friction acts on both masses, with opposite signs",
                   [](ProtocolQuestion& q) {
                       if (q.contact_with == 0) return false;
                       q.contact_with = 0;
                       if (q.mass == 0) q.mass = q.contact;
                       return true;
                   }),
        of_systems("relative-displacement-reversed", "5",
                   "Of a contact between two masses the displacement of the second less that of the first is taken.",
                   "the sign of the contact's displacement: contact [a, b] slides by x_a - x_b, whose maximum is at tau = 0",
                   [](ProtocolQuestion& q) {
                       std::swap(q.contact, q.contact_with);
                       return q.contact != 0;
                   }),
    };
}

std::vector<MistakeDefinition> of_loads() {
    return {
        of_systems("loads-normalised", "4", "The forces on the masses are scaled to a vector of unit length.",
                   "how load is read where it is a list: its entries are forces in units of P",
                   [](ProtocolQuestion& q) {
                       double square = 0;
                       for (const double p : q.loads) square += p * p;
                       for (double& p : q.loads) p /= std::sqrt(square);
                       return !q.loads.empty();
                   }),
        of_systems("largest-load-only", "4", "Of the forces on the masses the largest alone is taken.",
                   "how load is read where it is a list: every entry is the force on its mass",
                   [](ProtocolQuestion& q) {
                       if (q.loads.empty()) return false;
                       const auto largest = std::max_element(q.loads.begin(), q.loads.end(),
                                                             [](double a, double b) { return std::abs(a) < std::abs(b); });
                       for (auto p = q.loads.begin(); p != q.loads.end(); ++p)
                           if (p != largest) *p = 0;
                       return true;
                   }),
        of_systems("base-taken-with-wall", "4",
                   "A base that moves alone is taken to move together with the wall: the load is M 1 in place of K 1.",
                   "which load base_motion makes: \"alone\" moves the ends of the springs, in absolute displacements",
                   [](ProtocolQuestion& q) {
                       if (q.base_motion != "alone") return false;
                       q.base_motion = "with_wall";
                       return true;
                   }),
        of_systems(
            "base-taken-alone", "4",
            "A base that moves together with the wall is taken to move alone: the load is K 1 in place of M 1.",
            "which load base_motion makes: \"with_wall\" loads every mass by its inertia, in displacements relative to the wall",
            [](ProtocolQuestion& q) {
                if (q.base_motion != "with_wall") return false;
                q.loads = row_sums(stiffness_matrix(scene_of(q).system));
                q.base_motion.clear();
                return true;
            }),
        of_systems("base-load-without-masses", "4",
                   "A base that moves together with the wall loads every mass by the same force: 1 in place of M 1.",
                   "the load of a base that moves: masses times its acceleration",
                   [](ProtocolQuestion& q) {
                       if (q.base_motion != "with_wall") return false;
                       q.loads.assign(masses_of(q), 1);
                       q.base_motion.clear();
                       return true;
                   }),
    };
}

std::vector<MistakeDefinition> of_damping() {
    return {
        of_systems(
            "coupling-neglected", "18",
            "Of the damping matrix the diagonal in the modes alone is taken, as (18) has it where the modes are not coupled.",
            "whether psi^T C psi is taken to be diagonal: it is where K M^-1 C = C M^-1 K",
            [](ProtocolQuestion& q) {
                if (q.damping_matrix.empty()) return false;
                q.damping_ratios = modal_basis(scene_of(q).system).zeta;
                q.damping_matrix.clear();
                return true;
            }),
        of_systems("dashpots-between-masses-ignored", "19", "Of the damping matrix the diagonal alone is taken.",
                   "the entries of the damping matrix off its diagonal: a dashpot between two masses couples them",
                   [](ProtocolQuestion& q) {
                       const std::size_t N = masses_of(q);
                       for (std::size_t n = 0; n < q.damping_matrix.size(); ++n)
                           if (n % (N + 1) != 0) q.damping_matrix[n] = 0;
                       return !q.damping_matrix.empty();
                   }),
    };
}

} // namespace

std::vector<MistakeDefinition> mistakes_of_systems() {
    std::vector<MistakeDefinition> all = of_contacts();
    for (const auto& part : {of_loads(), of_damping()}) all.insert(all.end(), part.begin(), part.end());
    return all;
}

} // namespace denhartog::conformance
