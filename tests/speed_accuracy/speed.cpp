#include "tests/speed_accuracy/speed.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <functional>

#include "denhartog/denhartog.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::tests {
namespace {

using Amplitudes = std::vector<std::vector<double>>; // mass by mass, point by point

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> x) {
    std::ranges::sort(x);
    return x[x.size() / 2];
}

/// Microseconds of processor time a run, of as many runs as fill a twentieth of a second.
double time_of(const std::function<void()>& run) {
    const double start = processor_time();
    double now = start;
    long runs = 0;
    for (long more = 1; now - start < 0.05; now = processor_time(), more = runs) { // the clock takes as long as a short run
        for (long n = 0; n < more; ++n) run();
        runs += more;
    }
    return 1e6 * (now - start) / static_cast<double>(runs);
}

/// Points of one system along r.
struct Curve {
    std::string name;
    System<double> system;
    double beta;
    std::vector<double> r;
};

Scene<double> scene_at(const Curve& curve, double r) {
    Scene<double> scene;
    scene.system = curve.system;
    scene.r = r;
    scene.beta = curve.beta;
    return scene;
}

std::vector<double> r_of_curve() {
    std::vector<double> r;
    for (int n = 10; n <= 250; ++n) r.push_back(n / 100.0);
    return r;
}

Curve sdof_point() { return {"SDOF, r = 0.1, beta = 0.2, zeta = 0.01", single_mass(0.01), 0.2, {0.1}}; }
Curve sdof_sliding() { return {"SDOF, r = 0.9, beta = 0.2, zeta = 0.01", single_mass(0.01), 0.2, {0.9}}; }
Curve two_masses_curve() {
    return {"2DOF, r = 0.1 to 2.5, 241 points, beta = 0.3, zeta_i = 0.01/r_n,i", two_masses(0.01), 0.3, r_of_curve()};
}
Curve five_masses_point() { return {"5DOF j=3 l=1, r = 0.9, beta = 0.2, zeta = 0.01", five_masses<double>(3, 0.01), 0.2, {0.9}}; }

/// Amplitudes of every mass, proved; none at points where the contact rests for ever, in a place that depends on the start.
Amplitudes reference(const Curve& curve) {
    Amplitudes all;
    for (const double r : curve.r) {
        const Solution answer = solve(scene_at(curve, r), {.digits = 15, .proved = true});
        all.emplace_back();
        if (answer.regime.regime == Regime::permanent_sticking) continue;
        for (std::size_t k = 0; k < number_of_masses(curve.system); ++k) all.back().push_back(answer.amplitude(Mass{k}).value);
    }
    return all;
}

Amplitudes exact_from_rest(const Curve& curve, ExactSolver& solver) {
    Amplitudes all;
    const std::size_t N = solver.system().basis.r_n.size();
    for (const double r : curve.r) {
        solver.set({r, curve.beta, 1});
        const PeriodicOrbit orbit = periodic_orbit(solver, at_rest(N));
        all.emplace_back();
        for (const MassMotion& mass : orbit.masses) all.back().push_back(mass.amplitude);
    }
    return all;
}

Amplitudes by_paper(const Curve& curve) {
    Amplitudes all;
    for (const double r : curve.r) {
        const PaperMotion motion = paper_algorithm(scene_at(curve, r));
        all.emplace_back();
        for (const PaperMassMotion& mass : motion.masses) all.back().push_back(mass.amplitude);
    }
    return all;
}

Amplitudes by_solve(const Curve& curve, Asked asked) {
    Amplitudes all;
    Scene<double> scene = scene_at(curve, 1);
    for (const double r : curve.r) {
        scene.r = r;
        const Solution solution = solve(scene, {asked, std::nullopt, false});
        all.emplace_back();
        for (const SolvedMass& mass : solution.masses) all.back().push_back(mass.amplitude.value);
    }
    return all;
}

/// The largest of 1000 samples of the motion.
Amplitudes by_samples(const Curve& curve) {
    Amplitudes all;
    for (const double r : curve.r) {
        const SampledSolution sampled = motion(scene_at(curve, r), 1000);
        const std::size_t N = number_of_masses(curve.system);
        all.emplace_back(N);
        for (std::size_t n = 0; n < sampled.x.size(); ++n)
            all.back()[n % N] = std::max(all.back()[n % N], std::abs(sampled.x[n]));
    }
    return all;
}

Amplitudes by_map(const Curve& curve) {
    MapRequest request;
    request.r = curve.r;
    request.beta = {curve.beta};
    for (std::size_t k = 0; k < number_of_masses(curve.system); ++k) request.masses.push_back(Mass{k});
    const std::atomic<bool> stop{false};
    const RegimeMap map = regime_map(scene_at(curve, 1), request, stop);
    Amplitudes all;
    const auto N = static_cast<std::ptrdiff_t>(request.masses.size());
    for (auto each = map.amplitudes.begin(); each != map.amplitudes.end(); each += N) all.emplace_back(each, each + N);
    return all;
}

/// Digits of the amplitudes of all masses: the worst, and the median over the points.
std::string digits_of(const Amplitudes& found, const Amplitudes& exact) {
    std::vector<double> errors;
    for (std::size_t n = 0; n < exact.size(); ++n) {
        if (exact[n].empty()) continue;
        double worst = 1e-17;
        for (std::size_t k = 0; k < exact[n].size(); ++k)
            worst = std::max(worst, k < found[n].size() ? std::abs(found[n][k] / exact[n][k] - 1) : 1);
        errors.push_back(-std::log10(worst));
    }
    const std::string least = digits(*std::ranges::min_element(errors), "%.1f");
    return errors.size() == 1 ? least
                              : least + " to " + digits(*std::ranges::max_element(errors), "%.1f") + ", median " +
                                    digits(median(errors), "%.1f");
}

void compare(const Curve& curve, const std::string& what, const std::function<Amplitudes()>& fast, int repeats,
             const Amplitudes& exact, Table& table) {
    std::vector<double> of_fast, of_paper;
    for (int n = 0; n < repeats; ++n) {
        of_fast.push_back(time_of([&] { (void)fast(); }));
        of_paper.push_back(time_of([&] { (void)by_paper(curve); }));
    }
    const double points = static_cast<double>(curve.r.size());
    const double a = median(of_fast) / points, b = median(of_paper) / points;
    table.rows.push_back({curve.name, what, digits(a), digits(b, "%.4g"), digits(b / a), digits_of(fast(), exact),
                          digits_of(by_paper(curve), exact)});
}

std::vector<std::string> head() {
    return {"scene", "by", "microseconds a point", "paper's algorithm", "ratio", "digits", "digits of the paper's algorithm"};
}

} // namespace

Table exact_solver_speed(int repeats) {
    Table table{
        "Exact solver against the paper's algorithm, 200 cycles at 1e-6",
        head(),
        {},
        "Processor time, medians of " + std::to_string(repeats) +
            " runs; digits of the amplitudes of all masses, against the proved ones. The exact solver "
            "starts from rest and gives amplitudes, phases, stops, Floquet multipliers, stability and an error bound; the modes "
            "are known."};
    for (const Curve& curve : {sdof_point(), two_masses_curve()}) {
        const ContactSystem system = contact_system(curve.system);
        ExactSolver solver(system, {1, curve.beta, 1});
        compare(
            curve, "exact solver", [&] { return exact_from_rest(curve, solver); }, repeats, reference(curve), table);
    }
    return table;
}

Table usual_questions_speed(int repeats) {
    Table table{"The usual questions against the paper's algorithm, 200 cycles at 1e-6",
                head(),
                {},
                "Processor time, medians of " + std::to_string(repeats) +
                    " runs; digits of the amplitudes of all masses, against the proved ones. `solve` includes the "
                    "eigenproblem, its error bounds and its reasons in words; the map one eigenproblem for all points. The digits of "
                    "samples are those of the largest."};
    for (const Curve& curve : {sdof_point(), sdof_sliding(), two_masses_curve(), five_masses_point()}) {
        const Amplitudes exact = reference(curve);
        compare(
            curve, "solve, motion", [&] { return by_solve(curve, Asked::motion); }, repeats, exact, table);
        compare(
            curve, "motion, 1000 samples", [&] { return by_samples(curve); }, repeats, exact, table);
        compare(
            curve, "solve, amplitudes", [&] { return by_solve(curve, Asked::amplitude); }, repeats, exact, table);
        compare(
            curve, "map", [&] { return by_map(curve); }, repeats, exact, table);
    }
    return table;
}

} // namespace denhartog::tests
