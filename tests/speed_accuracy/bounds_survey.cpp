#include "tests/speed_accuracy/bounds_survey.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/solve/quantities.hpp"
#include "tests/speed_accuracy/mode_places.hpp"
#include "tests/support/adversarial_scenes.hpp"
#include "tests/support/closed_form.hpp"
#include "tests/support/scene_builder.hpp"

namespace denhartog::tests {
namespace {

constexpr int bins_a_decade = 20, bins = 16 * bins_a_decade;
constexpr double nothing = 1e-280; // bounds of numbers that their formula makes zero
constexpr int frequencies = 8, frictions = 4;

/// A basis rounded to double: its inputs are exact, and each number is off by its own rounding.
ModalBasis<Bounded<double>> bounded_basis(const ModalBasis<Real100>& basis) {
    const auto in_double = [](const Real100& x) {
        const double near = static_cast<double>(x);
        return Bounded<double>::of(near, static_cast<double>(abs(Real100(x - near))) * (1 + unit_of<double>()), 0);
    };
    ModalBasis<Bounded<double>> all;
    for (const Real100& r_n : basis.r_n) all.r_n.push_back(in_double(r_n));
    for (const Real100& zeta : basis.zeta) all.zeta.push_back(in_double(zeta));
    all.phi.resize(basis.phi.rows(), basis.phi.cols());
    for (Eigen::Index i = 0; i < basis.phi.cols(); ++i)
        for (Eigen::Index k = 0; k < basis.phi.rows(); ++k) all.phi(k, i) = in_double(basis.phi(k, i));
    return all;
}

class Comparer {
public:
    Comparer(BoundsSurvey& survey, double damage) : all(survey), damage_(damage) {}

    /// Compares everything that both list; counts the digits that the bounds do not leave.
    void compare(const Quantities<Bounded<double>>& q, const Quantities<Real100>& truth, const Scene<double>& scene, double tau) {
        std::vector<Real100> values;
        list<Real100>(truth, [&](const char*, std::size_t, const Real100& value, const Real100&) { values.push_back(value); });
        std::size_t n = 0;
        double relative = 0;
        list<Bounded<double>>(q, [&](const char* name, std::size_t, const Bounded<double>& value, const Bounded<double>& size) {
            if (n == values.size()) return; // outside the sliding regime by 100 digits
            Real100 error = abs(Real100(Real100(value.x) - values[n++]));
            if (std::string(name) == "phi_j") error = abs(wrapped(error));
            note(name, static_cast<double>(error), value.e, scene, tau);
            const double of_size = value.e <= nothing ? 0 : value.e / std::abs(size.x);
            if (!(of_size <= relative)) relative = of_size >= 0 ? of_size : std::numeric_limits<double>::infinity();
        });
        const bool open = regime_is_open(q, *scene.beta);
        for (const int digits : {6, 8, 10, 12, 13, 14})
            if (open || !(relative <= std::pow(10.0, -digits))) ++all.steps[digits];
    }

    void compare_regime(const Quantities<Bounded<double>>& q, const Quantities<Real100>& truth, double beta) {
        if (regime_is_open(q, beta)) {
            ++all.open_regimes;
            return;
        }
        ++all.regimes;
        all.wrong_regimes += (beta < q.beta_lim.x) != (Real100(beta) < truth.beta_lim) ? 1 : 0;
    }

    void compare_S(const Quantities<Bounded<double>>& q, const Real100& S, const Scene<double>& scene) {
        ++all.full_searches;
        note("S", static_cast<double>(Real100(abs(Real100(Real100(q.S.x) - S)))), q.S.e, scene, 0);
    }

private:
    [[nodiscard]] bool regime_is_open(const Quantities<Bounded<double>>& q, double beta) const {
        return std::abs(q.beta_lim.x - beta) <= q.beta_lim.e * damage_;
    }

    void note(const char* name, double error, double bound, const Scene<double>& scene, double tau) {
        if (error == 0 && bound <= nothing) return;
        QuantityBounds& of = all.quantities[name];
        of.histogram.resize(bins + 1);
        ++of.count;
        bound *= damage_;
        const bool violated = !(error <= bound);
        if (violated) ++of.violations;
        const double used = violated && !(error > bound) ? std::numeric_limits<double>::infinity() : error / bound;
        if (used > of.most_used) {
            of.most_used = used;
            of.worst = json_of(scene) + " at tau = " + digits(tau, "%a");
        }
        const double place = error > 0 ? std::log10(bound / error) * bins_a_decade : bins;
        ++of.histogram[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(bins)))];
    }

    BoundsSurvey& all;
    double damage_;
};

/// Seeded systems and points.
class BoundsScenes : Source<double> {
public:
    using Source<double>::Source;

    bool one_in(int n) { return whole(0, n - 1) == 0; }

    /// A chain or, one time in four, a system of any topology, of 1 to 12 masses.
    System<double> system() {
        const auto N = static_cast<std::size_t>(whole(1, 12));
        System<double> made;
        for (std::size_t i = 0; i < N; ++i) {
            made.mass_ratios.push_back(i == 0 ? 1 : spread(-1, 1));
            made.stiffness_ratios.push_back(i == 0 ? 1 : spread(-1, 1));
        }
        made.damping_ratios = damping(N);
        made.contact = Mass{static_cast<std::size_t>(whole(0, static_cast<int>(N) - 1))};
        made.load = Mass{static_cast<std::size_t>(whole(0, static_cast<int>(N) - 1))};
        if (N == 1 || whole(0, 3) > 0) return made;
        const auto n = static_cast<Eigen::Index>(N);
        Matrix<double> K = Matrix<double>::Zero(n, n);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index k = -1; k < i; ++k) { // -1 is the ground; every pair is joined by chance, neighbours always
                if (k + 1 < i && whole(0, 3) > 0) continue;
                connect(K, i, k, spread(-1, 1));
            }
        made.stiffness_matrix = K;
        made.stiffness_ratios.clear();
        return made;
    }

    /// Any frequency ratio, one near a resonance, or near a pole that a mode without damping would have.
    double frequency(const ModalBasis<Bounded<double>>& basis) {
        const int kind = whole(0, 9);
        const double r_n = basis.r_n[static_cast<std::size_t>(whole(0, static_cast<int>(basis.r_n.size()) - 1))].x;
        const double near = near_one(-13, -1), any = spread(-3, 3);
        const int odd = 2 * whole(1, 10) + 1;
        return kind < 6 ? any : kind < 8 ? r_n * near : r_n * near / odd;
    }

    /// A part of the boundary, a neighbour of it, or any friction ratio.
    double friction(double beta_lim) {
        const int kind = whole(0, 9);
        const double part = spread(-6, 0.2), near = near_one(-15, -2), any = spread(-6, 1);
        return kind < 4 ? part * beta_lim : kind < 7 ? near * beta_lim : any;
    }

    /// From 0 to 4 pi, at times a multiple of pi.
    double instant() {
        const int kind = whole(0, 7);
        const double any = uniform(0, 4 * pi<double>());
        return kind == 0 ? 0 : kind == 1 ? pi<double>() * whole(1, 4) : any;
    }

private:
    // 1 with a deviation of either sign.
    double near_one(double low, double high) {
        const double deviation = spread(low, high);
        return one_in(2) ? 1 + deviation : 1 - deviation;
    }

    std::vector<double> damping(std::size_t N) {
        const int kind = whole(0, 5);
        const double same = std::min(0.99, spread(-12, 0));
        std::vector<double> zeta;
        for (std::size_t i = 0; i < N; ++i) {
            const double own = std::min(0.99, spread(-12, 0)), usual = spread(-3, -1);
            zeta.push_back(kind == 0 ? 0 : kind == 1 ? same : kind < 4 ? usual : own);
        }
        return zeta;
    }
};

class Surveyor {
public:
    Surveyor(BoundsSurvey& survey, std::uint64_t seed, double damage) : all(survey), random(seed), comparer(survey, damage) {}

    void one_system() {
        Scene<double> scene;
        scene.system = random.system();
        const System<double>& s = scene.system;
        const ModalBasis<Real100> wide = modal_basis(converted<Real100>(scene).system);
        const ModalBasis<Bounded<double>> basis = bounded_basis(wide);
        for (int n = 0; n < frequencies; ++n) {
            scene.r = random.frequency(basis);
            scene.beta.reset();
            try {
                one_frequency(scene, bounded_sums(s, basis, Bounded<double>(*scene.r)),
                              mode_sums(wide, s.contact, s.load, Real100(*scene.r)));
            } catch (const DomainError&) {
                all.scenes += frictions;
                ++all.poles;
            } catch (const PrecisionError&) {
                all.scenes += frictions;
                ++all.unsettled;
            }
        }
    }

private:
    void one_frequency(Scene<double>& scene, const ModeSums<Bounded<double>>& sums, const ModeSums<Real100>& wide_sums) {
        const double instant = instant_of_largest_demand(values_of(sums));
        const Quantities<Bounded<double>> still = quantities_without_motion(sums, Bounded<double>(1), Bounded<double>(instant));
        const Real100 wide_instant = instant < pi<double>() ? Real100(instant) : pi<Real100>();
        const Quantities<Real100> truth = quantities_without_motion(wide_sums, Real100(1), wide_instant);
        const bool slow = *scene.r * 4 < sums.r.x / sums.R.back().x;
        if (!slow && random.one_in(32))
            comparer.compare_S(still, sliding_demand(wide_sums, instant_of_largest_demand(wide_sums)), scene);
        for (int n = 0; n < frictions; ++n) one_friction(scene, sums, wide_sums, still, truth);
    }

    void one_friction(Scene<double>& scene, const ModeSums<Bounded<double>>& sums, const ModeSums<Real100>& wide_sums,
                      Quantities<Bounded<double>> q, Quantities<Real100> truth) {
        const double beta = random.friction(q.beta_lim.x), tau = random.instant();
        scene.beta = beta;
        ++all.scenes;
        add_motion(truth, wide_sums, Real100(beta), {Real100(tau)});
        comparer.compare_regime(q, truth, beta);
        try {
            add_motion(q, sums, Bounded<double>(beta), {Bounded<double>(tau)});
        } catch (const DomainError&) { // X_j below 0 by its rounding: it is not given
        }
        comparer.compare(q, truth, scene, tau);
    }

    BoundsSurvey& all;
    BoundsScenes random;
    Comparer comparer;
};

} // namespace

double QuantityBounds::over_estimate(double part) const {
    long left = static_cast<long>(std::ceil(part * static_cast<double>(count)));
    for (std::size_t place = 0; place < histogram.size(); ++place) {
        left -= histogram[place];
        if (left <= 0) return std::pow(10.0, static_cast<double>(place + 1) / bins_a_decade);
    }
    return std::numeric_limits<double>::infinity();
}

long BoundsSurvey::violations() const {
    long sum = wrong_regimes;
    for (const auto& [name, of] : quantities) sum += of.violations;
    return sum;
}

double BoundsSurvey::largest_median() const {
    double largest = 0;
    for (const auto& [name, of] : quantities) largest = std::max(largest, of.over_estimate(0.5));
    return largest;
}

BoundsSurvey survey_bounds(long scenes, std::uint64_t seed, double damage) {
    BoundsSurvey survey;
    Surveyor surveyor(survey, seed, damage);
    while (survey.scenes < scenes) surveyor.one_system();
    return survey;
}

std::vector<Table> tables_of(const BoundsSurvey& survey) {
    Table bounds{"Bounds of rounding errors against 100 digits, " + std::to_string(survey.scenes) + " scenes",
                 {"quantity", "comparisons", "violations", "median over-estimate", "90 %", "99 %", "most used", "where"},
                 {},
                 "Over-estimate: bound over error. Regimes decided by the bound of beta_lim: " + std::to_string(survey.regimes) +
                     ", wrong " + std::to_string(survey.wrong_regimes) + ", left open " + std::to_string(survey.open_regimes) +
                     ". S searched for in 100 digits too: " + std::to_string(survey.full_searches) +
                     ". Frequencies at a pole: " + std::to_string(survey.poles) +
                     ", without an end of the search for S: " + std::to_string(survey.unsettled) + "."};
    for (const auto& [name, of] : survey.quantities)
        bounds.rows.push_back({name, std::to_string(of.count), std::to_string(of.violations), digits(of.over_estimate(0.5)),
                               digits(of.over_estimate(0.9)), digits(of.over_estimate(0.99)), digits(of.most_used), of.worst});
    Table steps{"Scenes whose bounds in double do not leave the digits", {"what", "scenes", "share"}, {}, ""};
    for (const auto& [wanted, count] : survey.steps)
        steps.rows.push_back({std::to_string(wanted) + " digits", std::to_string(count),
                              digits(100 * static_cast<double>(count) / static_cast<double>(survey.scenes), "%.2f %%")});
    return {bounds, steps};
}

} // namespace denhartog::tests
