#include <array>
#include <initializer_list>

#include "denhartog/c/denhartog.h"
#include "denhartog/c/handles.hpp"
#include "denhartog/solve/certain_modes.hpp"
#include "denhartog/solve/quantities.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

void need_all_finite(std::initializer_list<std::span<const double>> arrays) {
    for (const std::span<const double> array : arrays) need_finite(array);
}

// Real and imaginary parts, one after the other.
void append(std::vector<double>& parts, const Complex<Bounded<double>>& z, ValueOrError part) {
    parts.insert(parts.end(), {part_of(z.re, part), part_of(z.im, part)});
}

int natural_frequency_ratios(const dh_system* system, size_t count, ValueOrError part, Output r_n, double* zeta) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(r_n.numbers, r_n.name);
        need_count(count, N);
        hand_out(parts_of(system->modes->r_n, part), r_n.numbers);
        hand_out(parts_of(system->modes->zeta, part), zeta);
    });
}

int mode_shapes(const dh_system* system, double r, size_t count, ValueOrError part, Output psi) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(psi.numbers, psi.name);
        need_count(count, N * N);
        check_frequency_ratio(r);
        std::vector<double> at_r;
        for (std::size_t k = 0; k < N; ++k) {
            const auto row = system->modes->phi.row(static_cast<Eigen::Index>(k));
            for (Eigen::Index i = 0; i < row.size(); ++i) at_r.push_back(part_of(row(i) / Bounded<double>(r), part));
        }
        need_finite(at_r);
        hand_out(at_r, psi.numbers);
    });
}

int modal_functions(const dh_system* system, double r, size_t count, ValueOrError part, Output R, double* v, double* u,
                    double* g) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(R.numbers, R.name);
        need_count(count, N);
        check_frequency_ratio(r);
        std::vector<double> ratios;
        for (const Bounded<double>& r_n : system->modes->r_n) ratios.push_back(part_of(Bounded<double>(r) / r_n, part));
        need_finite(ratios);
        if (v == nullptr && u == nullptr && g == nullptr) return hand_out(ratios, R.numbers); // there is no pole
        check_uncoupled(*system->modes);
        std::vector<double> of_v, of_u, of_g;
        for (const auto& f : certain_mode_functions(at_frequency(system->prepared.source, r), system->modes)) {
            append(of_v, f.v, part);
            of_u.push_back(part_of(f.u, part));
            of_g.push_back(part_of(f.g, part));
        }
        need_all_finite({of_v, of_u, of_g});
        hand_out(ratios, R.numbers);
        hand_out(of_v, v);
        hand_out(of_u, u);
        hand_out(of_g, g);
    });
}

int sums(const dh_system* system, double r, size_t count, ValueOrError part, Output V, double* U, double* G, double* H_j,
         double* S_j) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(V.numbers, V.name);
        need_count(count, N);
        const Quantities<Bounded<double>> q =
            quantities(system->prepared, point_of(system, r, 0, 1), {}, digits_of_formulas, PointNumbers::sums).numbers;
        std::vector<double> of_V;
        for (const Complex<Bounded<double>>& each : q.V) append(of_V, each, part);
        const std::vector<double> of_U = parts_of(q.U, part), of_G = parts_of(q.G, part);
        const double of_H_j = part_of(q.H_j, part), of_S_j = part_of(q.S, part);
        need_all_finite({of_V, of_U, of_G, std::array{of_H_j, of_S_j}});
        hand_out(of_V, V.numbers);
        hand_out(of_U, U);
        hand_out(of_G, G);
        if (H_j != nullptr) *H_j = of_H_j;
        if (S_j != nullptr) *S_j = of_S_j;
    });
}

} // namespace

extern "C" {

int dh_natural_frequency_ratios(const dh_system* system, size_t count, double* r_n, double* zeta) noexcept {
    return natural_frequency_ratios(system, count, ValueOrError::value, {r_n, "r_n"}, zeta);
}

int dh_natural_frequency_ratio_errors(const dh_system* system, size_t count, double* r_n_error, double* zeta_error) noexcept {
    return natural_frequency_ratios(system, count, ValueOrError::error, {r_n_error, "r_n_error"}, zeta_error);
}

int dh_mode_shapes(const dh_system* system, double r, size_t count, double* psi) noexcept {
    return mode_shapes(system, r, count, ValueOrError::value, {psi, "psi"});
}

int dh_mode_shape_errors(const dh_system* system, double r, size_t count, double* psi_error) noexcept {
    return mode_shapes(system, r, count, ValueOrError::error, {psi_error, "psi_error"});
}

int dh_modal_functions(const dh_system* system, double r, size_t count, double* R, double* v, double* u, double* g) noexcept {
    return modal_functions(system, r, count, ValueOrError::value, {R, "R"}, v, u, g);
}

int dh_modal_function_errors(const dh_system* system, double r, size_t count, double* R_error, double* v_error, double* u_error,
                             double* g_error) noexcept {
    return modal_functions(system, r, count, ValueOrError::error, {R_error, "R_error"}, v_error, u_error, g_error);
}

int dh_sums(const dh_system* system, double r, size_t count, double* V, double* U, double* G, double* H_j, double* S_j) noexcept {
    return sums(system, r, count, ValueOrError::value, {V, "V"}, U, G, H_j, S_j);
}

int dh_sum_errors(const dh_system* system, double r, size_t count, double* V_error, double* U_error, double* G_error,
                  double* H_j_error, double* S_j_error) noexcept {
    return sums(system, r, count, ValueOrError::error, {V_error, "V_error"}, U_error, G_error, H_j_error, S_j_error);
}

} // extern "C"
