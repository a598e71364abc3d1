// Error of leaving out what couples the modes, Section 2.1, over the size of the coefficients left out.
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/solve/solve.hpp"
#include "error_curves.hpp"
#include "tests/support/scene_builder.hpp"

namespace denhartog::figures::error_of_neglected_coupling {

/// Three equal masses and springs with dashpots, the contact on the second mass, the load on the first. The modes and the
/// diagonal of the modal damping matrix stay; the part off the diagonal is taken times a factor.
struct Dashpots {
    System<double> system; ///< with the dashpots
    ModalBasis<double> basis;
    double largest; ///< coefficient off the diagonal over the geometric mean of the two on it

    explicit Dashpots(const std::vector<double>& c) {
        system.mass_ratios = system.stiffness_ratios = {1, 1, 1};
        system.damping_matrix = matrix_of_chain(c);
        system.contact = Mass{1};
        system.load = Mass{0};
        basis = modal_basis(system);
        largest = largest_coupling(basis.D, 0.0);
    }

    /// A system whose coefficients off the diagonal are multiplied by a factor.
    [[nodiscard]] System<double> with(double factor) const {
        Matrix<double> D = factor * basis.D;
        D.diagonal() = basis.D.diagonal();
        System<double> s = system;
        const Matrix<double> C = basis.phi * D * basis.phi.transpose(); // phi^-1 is phi^T where the masses are 1
        s.damping_matrix = (C + C.transpose()) / 2;
        return s;
    }
};

Solution at(const System<double>& system, double r, double beta) {
    Scene<double> scene;
    scene.system = system;
    scene.r = r;
    scene.beta = beta;
    return solve(scene_source(scene), {Asked::amplitude, {}});
}

System<double> nearest_classical(System<double> s) {
    s.damping_tolerance = 2;
    return s;
}

/// Largest error of an amplitude over the masses, relative to that mass.
double error_of_amplitudes(const System<double>& system, double r, double beta) {
    const Solution exact = at(system, r, beta), neglected = at(nearest_classical(system), r, beta);
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double amplitude = exact.masses[k].amplitude.value;
        if (amplitude > 0) worst = std::max(worst, std::abs(neglected.masses[k].amplitude.value / amplitude - 1));
    }
    return worst;
}

double error_of_boundary(const System<double>& system, double r) {
    Scene<double> scene;
    scene.system = system;
    scene.r = r;
    const auto limit = [](const Scene<double>& s) {
        return sliding_answer(scene_source(s), Question{Asked::regime, {}}).limits->exact.value;
    };
    Scene<double> neglected = scene;
    neglected.system = nearest_classical(system);
    return std::abs(limit(neglected) / limit(scene) - 1);
}

/// The frequency at which the amplitudes of the sliding motion err most.
double worst_frequency(const System<double>& system, double beta) {
    double at = 0, largest = 0;
    for (const double r : spaced(0.1, 2.5, 121)) {
        const double error = error_of_amplitudes(system, r, beta);
        if (error > largest) largest = error, at = r;
    }
    return at;
}

Record make(Figure& figure) {
    // 20, 0, 60 of springs 1000 and masses 10, over sqrt(k m) = 100; as much damping, evenly; and a fifth of the first.
    const std::vector<std::pair<std::string, std::vector<double>>> chains{
        {"uneven", {0.2, 0, 0.6}}, {"light", {0.04, 0, 0.12}}, {"nearly even", {0.2, 0.3, 0.25}}};
    const double beta = 0.02;
    const std::vector<double> r = spaced(0.1, 2.5, 241), factors = spaced_in_octaves(1e-3, 1, 41);
    Record record;
    record.title = "Error of neglecting what couples the modes: over frequency, and over the size of the coefficients left out";
    record.equations = {"18"};
    record.given = {"Section 2.1: the off-diagonal terms are usually negligible"};
    record.chosen = {
        "three equal masses and springs, j = 2, l = 1, mu = 1; dashpots (0.2, 0, 0.6), a fifth of them, (0.2, 0.3, 0.25), in "
        "units of sqrt(k_1 m_1)",
        "(a) largest relative error of an amplitude over the masses at beta = 0.02, (b) of the boundary (69)",
        "(c) the same as (a) at its worst frequency, the coefficients off the diagonal of the modal damping matrix times a "
        "factor: over the largest of them, divided by the geometric mean of its two on the diagonal"};
    std::size_t done = 0;
    for (const auto& [name, dashpots] : chains) {
        const Dashpots chain(dashpots);
        const std::string of = ", " + name;
        add(figure, record,
            {"a", name, "amplitudes" + of, "r", r, [&](double x) { return error_of_amplitudes(chain.system, x, beta); }});
        add(figure, record,
            {"b", name, "boundary (69)" + of, "r", r, [&](double x) { return error_of_boundary(chain.system, x); }});
        const double worst = worst_frequency(chain.system, beta);
        std::vector<double> sizes;
        for (const double factor : factors) sizes.push_back(factor * chain.largest);
        add(figure, record, {"c", name, "amplitudes" + of + " at r = " + text(worst, "%.3g"), "size", sizes, [&](double size) {
                                 return error_of_amplitudes(chain.with(size / chain.largest), worst, beta);
                             }});
        const auto error_at = [&](double factor) { return error_of_amplitudes(chain.with(factor), worst, beta); };
        const double exponent = std::log10(error_at(0.01) / error_at(0.001));
        record.statements.push_back(
            {"(c) " + name + ": small errors are in proportion to the coefficients left out",
             "between a thousandth and a hundredth of them they go with the power " + text(exponent, "%.3f"),
             std::abs(exponent - 1) < 0.05});
        figure.progress(++done, chains.size());
    }
    record.remarks = {"The damping ratios of both motions are the same: the diagonal of the modal damping matrix."};
    return record;
}

const Listed listed("error_of_neglected_coupling", make);

} // namespace denhartog::figures::error_of_neglected_coupling
