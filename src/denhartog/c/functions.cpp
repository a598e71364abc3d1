// The functions of the paper in C: natural frequencies and mode shapes, (14) to (18), v, u and g of each mode, (23), (28) and
// (29), and their sums, (33) to (35), (57) and (64). Values and bounds of one quantity come from one function.
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/c/handles.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

int natural_frequency_ratios(const dh_system* system, size_t count, ValueOrError part, double* r_n, double* zeta) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(r_n, part, "r_n");
        need_count(count, N);
        hand_out(part, {{system->modes->r_n, r_n}, {system->modes->zeta, zeta}});
    });
}

int mode_shapes(const dh_system* system, double r, size_t count, ValueOrError part, double* psi) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(psi, part, "psi");
        need_count(count, N * N);
        check_frequency_ratio(r);
        hand_out(part, {{shapes_at(system, r), psi}});
    });
}

int modal_functions(const dh_system* system, double r, size_t count, ValueOrError part, double* R, double* v, double* u,
                    double* g) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(R, part, "R");
        need_count(count, N);
        check_frequency_ratio(r);
        const Numbers ratios = frequency_ratios_at(system, r);
        if (v == nullptr && u == nullptr && g == nullptr) return hand_out(part, {{ratios, R}}); // there is no pole
        check_uncoupled(*system->modes);
        Numbers v_values, u_values, g_values;
        for (const auto& f : certain_mode_functions(paid(at_frequency(system->prepared.source, r)), system->modes)) {
            v_values.insert(v_values.end(), {f.v.re, f.v.im});
            u_values.push_back(f.u);
            g_values.push_back(f.g);
        }
        hand_out(part, {{ratios, R}, {v_values, v}, {u_values, u}, {g_values, g}});
    });
}

int sums(const dh_system* system, double r, size_t count, ValueOrError part, double* V, double* U, double* G, double* H_j,
         double* S_j) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(V, part, "V");
        need_count(count, N);
        const Quantities<Bounded<double>> q = sums_at(system, r);
        Numbers V_values;
        for (const Complex<Bounded<double>>& each : q.V) V_values.insert(V_values.end(), {each.re, each.im});
        hand_out(part, {{V_values, V}, {q.U, U}, {q.G, G}, {{q.H_j}, H_j}, {{q.S}, S_j}});
    });
}

} // namespace

Numbers c_interface::shapes_at(const dh_system* system, double r) {
    Numbers psi;
    for (std::size_t k = 0; k < masses_of(system); ++k)
        for (const Bounded<double>& phi : system->modes->phi.row(static_cast<Eigen::Index>(k)))
            psi.push_back(phi / Bounded<double>(r));
    return psi;
}

Numbers c_interface::frequency_ratios_at(const dh_system* system, double r) {
    Numbers R;
    for (const Bounded<double>& r_n : system->modes->r_n) R.push_back(Bounded<double>(r) / r_n);
    return R;
}

Quantities<Bounded<double>> c_interface::sums_at(const dh_system* system, double r) {
    return quantities(paid(point_of(system, r, 0, 1)), {}, digits_of_formulas, PointNumbers::sums, system->prepared.bounded)
        .numbers;
}

extern "C" {

int dh_natural_frequency_ratios(const dh_system* system, size_t count, double* r_n, double* zeta) noexcept {
    return natural_frequency_ratios(system, count, ValueOrError::value, r_n, zeta);
}

int dh_natural_frequency_ratio_errors(const dh_system* system, size_t count, double* r_n_error, double* zeta_error) noexcept {
    return natural_frequency_ratios(system, count, ValueOrError::error, r_n_error, zeta_error);
}

int dh_mode_shapes(const dh_system* system, double r, size_t count, double* psi) noexcept {
    return mode_shapes(system, r, count, ValueOrError::value, psi);
}

int dh_mode_shape_errors(const dh_system* system, double r, size_t count, double* psi_error) noexcept {
    return mode_shapes(system, r, count, ValueOrError::error, psi_error);
}

int dh_modal_functions(const dh_system* system, double r, size_t count, double* R, double* v, double* u, double* g) noexcept {
    return modal_functions(system, r, count, ValueOrError::value, R, v, u, g);
}

int dh_modal_function_errors(const dh_system* system, double r, size_t count, double* R_error, double* v_error, double* u_error,
                             double* g_error) noexcept {
    return modal_functions(system, r, count, ValueOrError::error, R_error, v_error, u_error, g_error);
}

int dh_sums(const dh_system* system, double r, size_t count, double* V, double* U, double* G, double* H_j, double* S_j) noexcept {
    return sums(system, r, count, ValueOrError::value, V, U, G, H_j, S_j);
}

int dh_sum_errors(const dh_system* system, double r, size_t count, double* V_error, double* U_error, double* G_error,
                  double* H_j_error, double* S_j_error) noexcept {
    return sums(system, r, count, ValueOrError::error, V_error, U_error, G_error, H_j_error, S_j_error);
}

} // extern "C"
