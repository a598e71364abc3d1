// Errors of (76)-(85) over damping and friction.
#include "denhartog/formulas/other_masses.hpp"
#include "error_curves.hpp"
#include "peak.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::error_of_estimates_at_resonance {

/// A resonance of a system: what the estimates take, and the modes there.
struct Resonance {
    Resonance(const System<double>& system, Mass mass, std::size_t mode)
        : s(system), k(mass), i(mode), sums(s.at(s.basis.r_n[mode])), psi_k(s.psi(mass, mode)), psi_j(s.psi(sums.contact, mode)),
          psi_l(s.psi(sums.load, mode)), zeta(s.basis.zeta[mode]) {}

    [[nodiscard]] const Complex<double>& V() const { return sums.V[k.index]; }
    /// (77) and (80).
    [[nodiscard]] double V_abs() const { return paper::complex_response_amplitude_at_resonance(psi_k, psi_l, zeta); }
    [[nodiscard]] double G() const { return evaluation::second_damping_function_at_resonance(psi_k, psi_j, zeta); }
    /// Largest displacement at the natural frequency ratio; not a number where the contact does not slide.
    [[nodiscard]] double amplitude(double beta) const {
        const Boundary<double> limits = boundary(sums, 1.0);
        return beta < limits.exact ? steady_state(sums, limits, beta).masses[k.index].amplitude : std::nan("");
    }

    WithModes s;                ///< the system
    Mass k;                     ///< the mass
    std::size_t i;              ///< the mode
    ModeSums<double> sums;      ///< modes at its natural frequency ratio
    double psi_k, psi_j, psi_l; ///< its mode shape
    double zeta;                ///< its damping ratio
};

double error_of_76(const Resonance& a) {
    const Complex<double> V = paper::complex_response_at_resonance(a.psi_k, a.psi_l, a.zeta);
    return modulus(Complex<double>{V.re - a.V().re, V.im - a.V().im}) / modulus(a.V());
}

double error_of_77(const Resonance& a) { return std::abs(a.V_abs() / modulus(a.V()) - 1); }

/// Absolute: both sides are cosines.
double error_of_78(const Resonance& a) {
    const double Delta = argument(a.V()) - argument(a.sums.V[a.sums.contact.index]);
    return std::abs(paper::cosine_of_phase_difference_at_resonance(a.psi_k, a.psi_j) - std::cos(Delta));
}

double error_of_79(const Resonance& a) {
    return std::abs(evaluation::second_damping_function_at_resonance(a.zeta) / a.sums.g[a.i] - 1);
}

double error_of_80(const Resonance& a) { return std::abs(a.G() / a.sums.G[a.k.index] - 1); }

double error_of_81(const Resonance& a, double beta) {
    const double U_k = a.sums.U[a.k.index], U_j = a.sums.U[a.sums.contact.index];
    return std::abs(paper::transmissibility_at_resonance(a.V_abs(), U_k, U_j, a.G(), a.psi_k, a.psi_j, beta) / a.amplitude(beta) -
                    1);
}

double error_of_82(const Resonance& a, double beta) {
    return std::abs(paper::transmissibility_at_resonance_without_U(a.V_abs(), a.G(), beta) / a.amplitude(beta) - 1);
}

/// (83) against the height of the peak next to the resonance.
double error_of_83(const Resonance& a, double beta) {
    const std::optional<Peak> peak = sliding_peak(a.s, a.k, a.i, beta);
    return peak ? std::abs(a.s.estimated_peak(a.k, a.i, beta) / peak->X - 1) : std::nan("");
}

double error_of_84(const Resonance& a, double beta) {
    return std::abs(evaluation::resonant_peak_of_single_mass(a.zeta, beta) / a.amplitude(beta) - 1);
}

double error_of_85(const Resonance& a) { return std::abs(a.s.estimated_limit(a.i) / boundary(a.sums, 1.0).exact - 1); }

Record make(Figure& figure) {
    const std::vector<double> zetas = spaced_in_octaves(1e-5, 0.3, 61), few = spaced_in_octaves(1e-4, 0.3, 31),
                              fractions = spaced(0.02, 0.98, 97);
    const Mass first{0}, second{1};
    Record record;
    record.title = "Errors of the estimates (76)-(85) at resonance over damping and friction";
    record.equations = {"76", "77", "78", "79", "80", "81", "82", "83", "84", "85"};
    record.given = {"2DOF of Figs. 8 to 10: j = 2, l = 1, zeta_i = zeta / r_n,i; SDOF; mu = 1"};
    record.chosen = {
        "zeta = 1e-5 to 0.3, in (d) from 1e-4, as below it the search for the peak errs more; mass 1 of 2DOF at its first "
        "resonance, r = r_n,1, where nothing else is said",
        "beta half of (85); (e) beta over (85)",
        "(77), (80) to (82) and (84) against the closed form at r_n,i: |V_k|, G_k, the largest displacement; (78) absolute",
        "(83) against the height of the peak of (52) next to the resonance, (85) against (69) with the maximum of the sum"};
    using Estimate = std::function<double(const Resonance& a)>;
    const auto of_two = [](Mass k, std::size_t i, const Estimate& error) {
        return [=](double zeta) { return error(Resonance(two_masses(zeta), k, i)); };
    };
    const auto half = [](double (*error)(const Resonance&, double)) {
        return [error](const Resonance& a) { return error(a, a.s.estimated_limit(a.i) / 2); };
    };
    const auto over_zeta = [&](const std::string& panel, const std::string& name, const std::string& what,
                               const std::function<double(double)>& error) {
        add(figure, record, {panel, name, what, "zeta", panel == "d" ? few : zetas, error});
    };
    over_zeta("a", "(76)", "(76)", of_two(first, 0, error_of_76));
    over_zeta("a", "(77)", "(77)", of_two(first, 0, error_of_77));
    over_zeta("a", "(78)", "(78)", of_two(first, 0, error_of_78));
    over_zeta("b", "(79)", "(79)", of_two(first, 0, error_of_79));
    over_zeta("b", "(80)", "(80), first resonance", of_two(first, 0, error_of_80));
    over_zeta("b", "(80) second", "(80), second resonance", of_two(first, 1, error_of_80));
    over_zeta("c", "(81)", "(81)", of_two(first, 0, half(error_of_81)));
    over_zeta("c", "(82)", "(82), which is (83)", of_two(first, 0, half(error_of_82)));
    over_zeta("c", "(84)", "(84), SDOF", [](double zeta) {
        const Resonance a(single_mass(zeta), Mass{0}, 0);
        return error_of_84(a, a.s.estimated_limit(0) / 2);
    });
    for (const std::size_t i : {0U, 1U})
        for (const Mass k : {first, second})
            over_zeta("d", "mode " + std::to_string(i + 1) + " mass " + std::to_string(k.index + 1),
                      "(83), mode " + std::to_string(i + 1) + ", mass " + std::to_string(k.index + 1),
                      of_two(k, i, half(error_of_83)));
    for (const double zeta : {0.001, 0.01, 0.1}) {
        const Resonance a(single_mass(zeta), Mass{0}, 0);
        const double limit = a.s.estimated_limit(0);
        add(figure, record,
            {"e", "zeta=" + text(zeta), "(84), SDOF, zeta = " + text(zeta), "beta / (85)", fractions,
             [&](double f) { return error_of_84(a, f * limit); }});
    }
    over_zeta("f", "SDOF", "(85), SDOF", [](double zeta) { return error_of_85(Resonance(single_mass(zeta), Mass{0}, 0)); });
    over_zeta("f", "mode 1", "(85), 2DOF mode 1", of_two(first, 0, error_of_85));
    over_zeta("f", "mode 2", "(85), 2DOF mode 2", of_two(first, 1, error_of_85));
    record.remarks = {"Where the contact does not slide there is no point; the ranges stated are those of the points.",
                      "(83) and (82) with (77) and (80) are one formula; (c) asks for the amplitude at r_n,1, (d) for the peak."};
    return record;
}

const Listed listed("error_of_estimates_at_resonance", make);

} // namespace denhartog::figures::error_of_estimates_at_resonance
