#include "tests/speed_accuracy/bounds_survey.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/solve/quantities.hpp"
#include "tests/speed_accuracy/bounds_scenes.hpp"
#include "tests/support/closed_form.hpp"

namespace denhartog::tests {
namespace {

constexpr int bins_a_decade = 20, bins = 16 * bins_a_decade;
constexpr double nothing = 1e-280; // bounds of numbers that their formula makes zero
constexpr int frequencies = 8, frictions = 4;

/// Whether the sums over modes in 50 digits leave fewer than 25 of some V or U.
bool loses_digits(const ModeSums<Real50>& s) {
    const Real50 least("1e-25");
    const std::size_t N = s.R.size();
    const auto psi_l = mode_shapes_at(s, s.load), psi_j = mode_shapes_at(s, s.contact);
    for (std::size_t k = 0; k < N; ++k) {
        const auto psi_k = mode_shapes_at(s, Mass{k});
        Real50 of_V(0), of_U(0);
        for (std::size_t i = 0; i < N; ++i) {
            of_V += abs(Real50(psi_k[i] * psi_l[i] * s.R[i] * s.R[i])) * modulus(s.v[i]);
            of_U += abs(Real50(psi_k[i] * psi_j[i] * s.R[i] * s.R[i] * s.u[i]));
        }
        if (modulus(s.V[k]) < least * of_V || abs(s.U[k]) < least * of_U) return true;
    }
    return false;
}

std::vector<Real50> in_50_digits(const std::vector<Real100>& x) {
    std::vector<Real50> all;
    for (const Real100& each : x) all.push_back(static_cast<Real50>(each));
    return all;
}

const Quantities<Real50>& in_50_digits(const Quantities<Real50>& q) { return q; }

Quantities<Real50> in_50_digits(const Quantities<Real100>& q) {
    Quantities<Real50> all;
    for (const Complex<Real100>& V : q.V) all.V.push_back({static_cast<Real50>(V.re), static_cast<Real50>(V.im)});
    all.U = in_50_digits(q.U);
    all.G = in_50_digits(q.G);
    all.H_j = static_cast<Real50>(q.H_j);
    all.S = static_cast<Real50>(q.S);
    all.beta_lim = static_cast<Real50>(q.beta_lim);
    if (q.X_j) all.X_j = static_cast<Real50>(*q.X_j);
    if (q.phi_j) all.phi_j = static_cast<Real50>(*q.phi_j);
    all.x = in_50_digits(q.x);
    all.x_prime = in_50_digits(q.x_prime);
    all.x_size = in_50_digits(q.x_size);
    return all;
}

/// A basis rounded to double: its inputs are exact, and each number is off by its own rounding.
ModalBasis<Bounded<double>> rounded(const ModalBasis<Real50>& basis) {
    const auto in_double = [](const Real50& x) {
        const double near = static_cast<double>(x);
        return Bounded<double>::of(near, static_cast<double>(abs(Real50(x - near))) * (1 + unit_of<double>()), 0);
    };
    ModalBasis<Bounded<double>> all;
    for (const Real50& r_n : basis.r_n) all.r_n.push_back(in_double(r_n));
    for (const Real50& zeta : basis.zeta) all.zeta.push_back(in_double(zeta));
    all.phi.resize(basis.phi.rows(), basis.phi.cols());
    for (Eigen::Index i = 0; i < basis.phi.cols(); ++i)
        for (Eigen::Index k = 0; k < basis.phi.rows(); ++k) all.phi(k, i) = in_double(basis.phi(k, i));
    return all;
}

class Comparer {
public:
    Comparer(BoundsSurvey& survey, double damage) : all(survey), damage_(damage) {}

    /// Compares everything that both list; notes from how many digits on the bounds make a step.
    void compare(const Quantities<Bounded<double>>& q, const Quantities<Real50>& truth, const Scene<double>& scene, double tau,
                 const std::string& kind) {
        std::vector<Real50> values;
        list<Real50>(truth, [&](const char*, std::size_t, const Real50& value, const Real50&) { values.push_back(value); });
        std::size_t n = 0;
        double relative = 0;
        std::string largest;
        list<Bounded<double>>(q, [&](const char* name, std::size_t, const Bounded<double>& value, const Bounded<double>& size) {
            if (n == values.size()) return; // outside the sliding regime by 50 digits
            Real50 error = abs(Real50(Real50(value.x) - values[n++]));
            if (std::string(name) == "phi_j") error = abs(wrapped(error));
            note(name, static_cast<double>(error), value.e, [&] { return text_of(scene, tau); });
            const double of_size = value.e <= nothing ? 0 : value.e / std::abs(size.x);
            if (of_size <= relative) return;
            relative = of_size >= 0 ? of_size : std::numeric_limits<double>::infinity();
            largest = name;
        });
        const bool open = regime_is_open(q, *scene.beta);
        for (const int digits : {6, 8, 10, 12, 13, 14})
            if (open || !(relative <= std::pow(10.0, -digits))) ++all.steps[digits];
        if (!open && relative <= 1e-12) return;
        ++all.why[open ? "beta_lim: the regime" : largest];
        ++all.where[kind];
    }

    void compare_regime(const Quantities<Bounded<double>>& q, const Quantities<Real50>& truth, double beta) {
        if (regime_is_open(q, beta)) {
            ++all.open_regimes;
            return;
        }
        ++all.regimes;
        all.wrong_regimes += (beta < q.beta_lim.x) != (Real50(beta) < truth.beta_lim) ? 1 : 0;
    }

    void compare_S(const Quantities<Bounded<double>>& q, const Real50& S, const Scene<double>& scene) {
        ++all.full_searches;
        note("S", static_cast<double>(Real50(abs(Real50(Real50(q.S.x) - S)))), q.S.e, [&] { return text_of(scene, 0); });
    }

private:
    [[nodiscard]] bool regime_is_open(const Quantities<Bounded<double>>& q, double beta) const {
        return std::abs(q.beta_lim.x - beta) <= q.beta_lim.e * damage_;
    }

    template <class Where>
    void note(const char* name, double error, double bound, const Where& where) {
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
            of.worst = where();
        }
        const double place = error > 0 ? std::log10(bound / error) * bins_a_decade : bins;
        ++of.histogram[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(bins)))];
    }

    BoundsSurvey& all;
    double damage_;
};

class Surveyor {
public:
    Surveyor(BoundsSurvey& survey, std::uint64_t seed, double damage) : all(survey), random(seed), comparer(survey, damage) {}

    void one_system() {
        Scene<double> scene;
        scene.system = random.system();
        const System<Real50> wide_system = converted<Real50>(scene).system;
        const ModalBasis<Real50> wide = modal_basis(wide_system);
        const ModalBasis<Bounded<double>> basis = rounded(wide);
        std::optional<ModalBasis<Real100>> wider; // where a chain hands so little on that 50 digits are too few
        for (int n = 0; n < frequencies; ++n) {
            const SurveyedFrequency frequency = random.frequency(basis);
            scene.r = frequency.r;
            scene.beta.reset();
            try {
                const ModeSums<Bounded<double>> sums = bounded_sums(scene.system, basis, Bounded<double>(frequency.r));
                const System<double>& s = scene.system;
                const ModeSums<Real50> wide_sums = mode_sums(wide, s.contact, s.load, Real50(frequency.r));
                if (!loses_digits(wide_sums)) {
                    one_frequency(scene, sums, wide_sums, frequency.kind);
                    continue;
                }
                ++all.in_100_digits;
                if (!wider) wider = modal_basis(converted<Real100>(scene).system);
                one_frequency(scene, sums, mode_sums(*wider, s.contact, s.load, Real100(frequency.r)), frequency.kind);
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
    template <class T>
    void one_frequency(Scene<double>& scene, const ModeSums<Bounded<double>>& sums, const ModeSums<T>& wide_sums,
                       const std::string& kind) {
        const double instant = instant_of_largest_demand(values_of(sums));
        const Quantities<Bounded<double>> still = quantities_without_motion(sums, Bounded<double>(1), Bounded<double>(instant));
        const T wide_instant = instant < pi<double>() ? T(instant) : pi<T>();
        const Quantities<T> truth = quantities_without_motion(wide_sums, T(1), wide_instant);
        const bool slow = *scene.r * 4 < sums.r.x / sums.R.back().x;
        if (!slow && random.one_in(32))
            comparer.compare_S(still, static_cast<Real50>(sliding_demand(wide_sums, instant_of_largest_demand(wide_sums))),
                               scene);
        for (int n = 0; n < frictions; ++n) one_friction(scene, sums, wide_sums, still, truth, kind);
    }

    template <class T>
    void one_friction(Scene<double>& scene, const ModeSums<Bounded<double>>& sums, const ModeSums<T>& wide_sums,
                      Quantities<Bounded<double>> q, Quantities<T> truth, const std::string& kind) {
        const double beta = random.friction(q.beta_lim.x), tau = random.instant();
        scene.beta = beta;
        ++all.scenes;
        add_motion(truth, wide_sums, T(beta), {T(tau)});
        const Quantities<Real50> known = in_50_digits(truth);
        comparer.compare_regime(q, known, beta);
        try {
            add_motion(q, sums, Bounded<double>(beta), {Bounded<double>(tau)});
        } catch (const DomainError&) { // X_j below 0 by its rounding: it is not given
        }
        comparer.compare(q, known, scene, tau, kind);
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
    Table bounds{"Bounds of rounding errors against 50 digits, " + std::to_string(survey.scenes) + " scenes",
                 {"quantity", "comparisons", "violations", "median over-estimate", "90 %", "99 %", "most used", "where"},
                 {},
                 "Over-estimate: bound over error. Regimes decided by the bound of beta_lim: " + std::to_string(survey.regimes) +
                     ", wrong " + std::to_string(survey.wrong_regimes) + ", left open " + std::to_string(survey.open_regimes) +
                     ". S searched for in 50 digits too: " + std::to_string(survey.full_searches) +
                     ". Frequencies compared with 100 digits: " + std::to_string(survey.in_100_digits) +
                     "; at a pole: " + std::to_string(survey.poles) +
                     ", without an end of the search for S: " + std::to_string(survey.unsettled) + "."};
    for (const auto& [name, of] : survey.quantities)
        bounds.rows.push_back({name, std::to_string(of.count), std::to_string(of.violations), digits(of.over_estimate(0.5)),
                               digits(of.over_estimate(0.9)), digits(of.over_estimate(0.99)), digits(of.most_used), of.worst});
    Table steps{"Scenes whose bounds in double do not leave the digits", {"what", "scenes", "share"}, {}, ""};
    const auto add = [&](const std::string& what, long count) {
        const double share = static_cast<double>(count) / static_cast<double>(survey.scenes);
        steps.rows.push_back({what, std::to_string(count), digits(100 * share, "%.2f %%")});
    };
    for (const auto& [wanted, count] : survey.steps) add(std::to_string(wanted) + " digits", count);
    for (const auto& [name, count] : survey.why) add("12 digits, largest bound: " + name, count);
    for (const auto& [kind, count] : survey.where) add("12 digits, " + kind, count);
    return {bounds, steps};
}

} // namespace denhartog::tests
