// The system in coordinates of which the contact is one, so that it can be held: O^T A O for the matrices of (6), with
// sums that keep their roundings. Read `held_matrices`, then `with_contact`.
#include "denhartog/model/contact_and_load.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/evaluation/contact.hpp"

namespace denhartog {
namespace {

// The rest that rounding took of a diagonal entry of K, the sum of two springs of a chain.
double rest_of_stiffness(const System<double>& s, const Matrix<double>& K, std::size_t k) {
    if (s.stiffness_matrix.size() > 0 || k + 1 >= s.stiffness_ratios.size()) return 0.0;
    const auto i = static_cast<Eigen::Index>(k);
    return evaluation::sum_error(s.stiffness_ratios[k], s.stiffness_ratios[k + 1], K(i, i));
}

// Appends xyz to terms of a sum, with the rests that the roundings of the products took.
void add_product(std::vector<double>& terms, double x, double y, double z) {
    const double xy = x * y;
    for (const double part : {xy, evaluation::product_error(x, y, xy)}) {
        const double product = part * z;
        terms.push_back(product);
        terms.push_back(evaluation::product_error(part, z, product));
    }
}

// O^T A O, symmetric to the last bit. `rests` are those that rounding took of A's diagonal, N values.
Matrix<double> with_contact(const Contact& held, const Matrix<double>& A, const std::vector<double>& rests) {
    if (!held.has_own_row()) return A;
    const auto a = static_cast<Eigen::Index>(held.a), N = A.rows();
    const double w_a = held.w_a;
    std::vector<double> w(rests.size(), 0.0), terms;
    for (const BesideContact& other : held.others) w[other.k] = other.w;
    const auto entry = [&](Eigen::Index k) -> double { return w[static_cast<std::size_t>(k)]; };
    const auto sum = [&] { return evaluation::sum_with_rests<double>(std::exchange(terms, {})) / w_a / w_a; };
    Matrix<double> B = A;
    for (const BesideContact& other : held.others) {
        const auto l = static_cast<Eigen::Index>(other.k);
        for (Eigen::Index k = 0; k < N; ++k) {
            if (k == a || (entry(k) != 0 && k < l)) continue;
            add_product(terms, entry(k), other.w, A(a, a));
            add_product(terms, -w_a, entry(k), A(a, l));
            add_product(terms, -w_a, other.w, A(k, a));
            add_product(terms, w_a, w_a, A(k, l));
            add_product(terms, entry(k), other.w, rests[held.a]);
            if (k == l) add_product(terms, w_a, w_a, rests[other.k]);
            B(k, l) = B(l, k) = sum();
        }
    }
    for (Eigen::Index l = 0; l < N; ++l) {
        if (l == a) continue;
        add_product(terms, -entry(l), 1, A(a, a));
        add_product(terms, w_a, 1, A(a, l));
        add_product(terms, -entry(l), 1, rests[held.a]);
        B(a, l) = B(l, a) = sum();
    }
    B(a, a) = A(a, a) / w_a / w_a;
    return B;
}

} // namespace

std::vector<double> error_of_load(const System<double>& s) {
    if (s.load_phases.empty()) return s.load_error;
    std::vector<double> errors = s.load_error;
    errors.resize(s.load_vector.size());
    for (std::size_t k = 0; k < errors.size(); ++k)
        errors[k] += (2 + std::abs(s.load_phases[k])) * std::numeric_limits<double>::epsilon() * std::abs(s.load_vector[k]);
    return errors;
}

Contact contact_of(const std::vector<double>& w, const Matrix<double>& M) {
    double largest = 0;
    for (const double each : w) largest = std::max(largest, std::abs(each));
    const auto inertia = [&](std::size_t k) {
        return M(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)) / (w[k] / largest) / (w[k] / largest);
    };
    Contact contact{w.size(), 0, {}};
    for (std::size_t k = 0; k < w.size(); ++k) { // of two masses that are as heavy the first that was named
        if (w[k] == 0) continue;
        const bool less = contact.a == w.size() || inertia(k) < inertia(contact.a);
        if (less || (inertia(k) == inertia(contact.a) && w[k] > contact.w_a)) contact.a = k, contact.w_a = w[k];
    }
    for (std::size_t k = 0; k < w.size(); ++k)
        if (w[k] != 0 && k != contact.a) contact.others.push_back({k, w[k], -w[k] / contact.w_a});
    return contact;
}

NonDimensionalMatrices held_matrices(const System<double>& s, const Contact& held, const Matrix<double>& C) {
    const Matrix<double> K = stiffness_matrix(s);
    const std::vector<double> none(number_of_masses(s), 0.0);
    std::vector<double> rests_of_springs = none;
    for (std::size_t k = 0; k < rests_of_springs.size(); ++k) rests_of_springs[k] = rest_of_stiffness(s, K, k);
    return {with_contact(held, mass_matrix(s), none), with_contact(held, C, none), with_contact(held, K, rests_of_springs)};
}

} // namespace denhartog
