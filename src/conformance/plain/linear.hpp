// Linear algebra of the plain closed form, by loops over lists of doubles.
#pragma once

#include <functional>
#include <vector>

namespace denhartog::conformance {

using PlainRow = std::vector<double>;
using PlainMatrix = std::vector<PlainRow>; // by rows

// An amplitude: the real part of (re + i im) exp(i tau).
struct Phasor {
    double re = 0, im = 0;
};

[[nodiscard]] double modulus(const Phasor& a);
[[nodiscard]] double argument(const Phasor& a);
[[nodiscard]] double times_cosine(const Phasor& a, double tau); // real part of a exp(i tau)

[[nodiscard]] double dot(const PlainRow& a, const PlainRow& b); // over the length of a
[[nodiscard]] Phasor dot(const PlainRow& a, const std::vector<Phasor>& b);
[[nodiscard]] PlainRow times(const PlainMatrix& A, const PlainRow& x);
[[nodiscard]] PlainMatrix times(const PlainMatrix& A, const PlainMatrix& B);
[[nodiscard]] PlainMatrix transposed(const PlainMatrix& A);
[[nodiscard]] PlainMatrix square(std::size_t n); // of zeros

// The solution of a system of equations, by elimination with pivots. Not finite where the matrix is singular.
[[nodiscard]] PlainRow solved(PlainMatrix A, PlainRow b);

// The amplitudes X of (A + i B) X = b + i b_i.
[[nodiscard]] std::vector<Phasor> solved(const PlainMatrix& A, const PlainMatrix& B, const PlainRow& b, const PlainRow& b_i);

// The lower triangle L with L L^T = A.
[[nodiscard]] PlainMatrix triangle_of(const PlainMatrix& A);

// Natural frequencies, ascending, and the columns phi with phi^T M phi = 1.
struct PlainShapes {
    PlainRow r_n;
    PlainMatrix phi;
};

// Modes of the stiffness matrix B^T B, by rotations of the columns of B L^-T until they are orthogonal (Jacobi); L L^T = M.
[[nodiscard]] PlainShapes shapes_of(const PlainMatrix& B, const PlainMatrix& M);

// z(dt) - z(0) of z' = A z, by the series of the exponential; z(dt); and the matrix that makes it of z(0).
[[nodiscard]] PlainRow increment(const PlainMatrix& A, const PlainRow& z, double dt);
[[nodiscard]] PlainRow moved(const PlainMatrix& A, const PlainRow& z, double dt);
[[nodiscard]] PlainMatrix propagator(const PlainMatrix& A, double dt);

// Where a function changes its sign between two places; the second where it does not.
[[nodiscard]] double zero_between(const std::function<double(double)>& f, double from, double to);

} // namespace denhartog::conformance
