/// @file
/// @brief Two scenes compared to the last bit.
#pragma once

#include "denhartog/scene/scene.hpp"

namespace denhartog::fuzz {

/// @brief Whether two matrices are the same. @param A a matrix @param B a matrix @return whether they are
template <class T>
[[nodiscard]] bool same(const Matrix<T>& A, const Matrix<T>& B) {
    return A.rows() == B.rows() && A.cols() == B.cols() && (A.size() == 0 || A == B);
}

/// @brief Whether two scenes are the same. @param a a scene @param b a scene @return whether they are
template <class T>
[[nodiscard]] bool same(const Scene<T>& a, const Scene<T>& b) {
    const System<T>&s = a.system, &t = b.system;
    return s.mass_ratios == t.mass_ratios && s.stiffness_ratios == t.stiffness_ratios && same(s.mass_matrix, t.mass_matrix) &&
           same(s.stiffness_matrix, t.stiffness_matrix) && s.damping_ratios == t.damping_ratios &&
           same(s.damping_matrix, t.damping_matrix) && s.contact == t.contact && s.load == t.load && a.mu == b.mu && a.r == b.r &&
           a.beta == b.beta;
}

} // namespace denhartog::fuzz
