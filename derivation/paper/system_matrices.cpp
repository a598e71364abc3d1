#include "derivation/paper/system_matrices.hpp"

#include <map>
#include <string>

#include "derivation/algebra/symbols.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::numeric;

namespace {

SymbolicSystem make(int N) {
    SymbolicSystem s;
    s.r = symbols().r;
    const std::string suffix = "_of_" + std::to_string(N);
    std::vector<ex> root_of_gamma;
    for (int i = 1; i <= N; ++i) {
        const std::string n = std::to_string(i);
        root_of_gamma.push_back(new_symbol("root_gamma" + n + suffix, "\\sqrt{\\gamma_{" + n + "}}", numeric(1, 2), 2));
        s.gamma.push_back(root_of_gamma.back() * root_of_gamma.back());
        s.Omega.push_back(new_symbol("Omega" + n + suffix, "\\Omega_{" + n + "}", numeric(1, 2), 3));
        s.zeta.push_back(new_symbol("zeta" + n + suffix, "\\zeta_{" + n + "}", numeric(1, 20), numeric(9, 10)));
    }
    // Cayley: Q = (1 - A)^-1 (1 + A) with a skew-symmetric A
    matrix A(N, N), one(N, N);
    for (int i = 0; i < N; ++i) one(i, i) = 1;
    for (int i = 0; i < N; ++i)
        for (int k = i + 1; k < N; ++k) {
            const std::string n = std::to_string(i + 1) + std::to_string(k + 1);
            A(i, k) = new_symbol("a" + n + suffix, "a_{" + n + "}", -1, 1);
            A(k, i) = -A(i, k);
        }
    const matrix Q = one.sub(A).inverse().mul(one.add(A));
    s.M = matrix(N, N);
    s.Psi = matrix(N, N);
    for (int k = 0; k < N; ++k) {
        s.M(k, k) = s.gamma[k] * s.r * s.r;
        for (int i = 0; i < N; ++i) s.Psi(k, i) = (Q(k, i) / (root_of_gamma[k] * s.r)).normal();
    }
    // K psi_i = Omega_i^2 M psi_i and Psi^T M Psi = 1 give K = sum Omega_i^2 (M psi_i)(M psi_i)^T, and C likewise
    const matrix M_Psi = s.M.mul(s.Psi);
    s.K = matrix(N, N);
    s.C = matrix(N, N);
    for (int k = 0; k < N; ++k)
        for (int n = 0; n < N; ++n)
            for (int i = 0; i < N; ++i) {
                s.K(k, n) = s.K(k, n) + s.Omega[i] * s.Omega[i] * M_Psi(k, i) * M_Psi(n, i);
                s.C(k, n) = s.C(k, n) + 2 * s.zeta[i] * s.Omega[i] * M_Psi(k, i) * M_Psi(n, i);
            }
    return s;
}

} // namespace

const SymbolicSystem& symbolic_system(int N) {
    static std::map<int, SymbolicSystem> made;
    auto found = made.find(N);
    if (found == made.end()) found = made.emplace(N, make(N)).first;
    return found->second;
}

} // namespace denhartog::derivation
