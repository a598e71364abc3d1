#include "tests/speed_accuracy/mode_functions_survey.hpp"

#include <cmath>
#include <optional>

#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/multiprecision.hpp"
#include "tests/speed_accuracy/mode_places.hpp"

namespace denhartog::tests {
namespace {

using Four = std::array<Real100, 4>;

/// The paper's formulas; the sine and the exponentials from what the arguments are in this type.
template <class Wide>
std::array<Wide, 4> printed(const Wide& R, const Wide& zeta) {
    const Complex<Wide> v = paper::complex_response(R, zeta);
    return {v.re, v.im, paper::first_damping_function(R, zeta), paper::second_damping_function(R, zeta)};
}

/// Condition numbers, 1 at least.
struct Conditions {
    std::array<double, 4> by_zeta{1, 1, 1, 1}, by_both{1, 1, 1, 1};
};

/// Relative change of each function for a relative change of R or zeta; a few digits are enough, so the shipped forms serve.
template <class T>
Conditions conditions(const Place<T>& p) {
    const auto at = [&p](const Real100& by_R, const Real100& by_zeta) {
        const Real100 R = Real100(p.R) * by_R, zeta = Real100(p.zeta) * by_zeta;
        const evaluation::ModeFunctions<Real100> f = evaluation::mode_functions(R, zeta);
        return Four{f.v.re, f.v.im, f.u, f.g};
    };
    const Real100 h = ldexp(Real100(1), -210), one(1);
    const Four f = at(one, one), other_R = at(1 - h, one), other_zeta = at(one, 1 - h);
    Conditions found;
    for (std::size_t i = 0; i < 4; ++i) {
        if (f[i] == 0) continue;
        const auto change = [&](const Real100& other) {
            return static_cast<double>(Real100(abs(Real100((other - f[i]) / (h * f[i])))));
        };
        found.by_zeta[i] = std::max(1.0, change(other_zeta[i]));
        found.by_both[i] = std::max(found.by_zeta[i], change(other_R[i]));
    }
    return found;
}

template <class Wide, class T>
Four truth_in(const Place<T>& p) {
    const std::array<Wide, 4> f = printed(Wide(p.R), Wide(p.zeta));
    Four truth;
    for (std::size_t i = 0; i < 4; ++i) truth[i] = static_cast<Real100>(f[i]);
    return truth;
}

/// The truth: the paper's formulas in as many digits as they need.
template <class T>
Four truth_of(const Place<T>& p) {
    if (decays_out_of_range(p)) {
        const Real100 wide_R(p.R), wide_zeta(p.zeta);
        const Complex<Real100> v = paper::complex_response(wide_R, wide_zeta);
        return {v.re, v.im, Real100(0), Real100(1)};
    }
    const double needed = digits_needed(p);
    if (needed < 100) return truth_in<Real100>(p);
    if (needed < 300) return truth_in<Real300>(p);
    if (needed < 600) return truth_in<Real600>(p);
    return truth_in<Real1100>(p);
}

template <class T, class Forms>
void note(ZoneErrors& errors, const Place<T>& p, const Forms& forms) {
    ++errors.points;
    const evaluation::ModeFunctions<T> f = forms(p.R, p.zeta);
    if (p.zeta == 0 && evaluation::at_undamped_pole(p.R)) {
        ++errors.poles;
        errors.finite_at_poles += boost::math::isfinite(f.u) ? 1 : 0;
        return;
    }
    const std::array<T, 4> shipped{f.v.re, f.v.im, f.u, f.g}, paper = printed(p.R, p.zeta);
    const Four truth = truth_of(p);
    const std::string at = hexadecimal(p.R) + ", " + hexadecimal(p.zeta);
    const Real100 normal((std::numeric_limits<T>::min)()), R(p.R), square = Real100(p.zeta) * Real100(p.zeta);
    const Real100 least_u = square < normal && R < 1 ? Real100(normal / (R * R)) : normal;
    const bool light = p.zeta * 1024 <= 1;
    std::optional<Conditions> known; // a condition number can only lessen an error: it is needed for those that may be the worst
    for (std::size_t i = 0; i < 4; ++i) {
        const Real100 least = i == 2 ? least_u : normal;
        FunctionErrors& worst = errors.functions[i];
        const double error = error_of(shipped[i], truth[i], least), error_printed = error_of(paper[i], truth[i], least);
        const bool may_be_worst = !(error <= worst.by_both.error) || !(error_printed <= worst.printed.error) ||
                                  (light && !(error <= worst.light.error));
        if (!may_be_worst) continue;
        if (!known) known = conditions(p);
        worst.by_both.note(error / known->by_both[i], at);
        worst.printed.note(error_printed / known->by_both[i], at);
        if (light) worst.light.note(error / known->by_zeta[i], at);
    }
}

template <class T, class Forms>
std::vector<ZoneErrors> survey(int points, const Forms& forms) {
    std::vector<ZoneErrors> zones;
    Source<T> source;
    const std::size_t count = mode_zones().size() - 1;
    for (std::size_t zone = 0; zone < count; ++zone) {
        zones.push_back({mode_zones()[zone], 0, 0, 0, {}});
        for (int n = 0; n < points / static_cast<int>(count); ++n) note(zones.back(), place_in(zone, source), forms);
    }
    zones.push_back({mode_zones().back(), 0, 0, 0, {}});
    for (const Place<T>& p : hard_places<T>()) note(zones.back(), p, forms);
    return zones;
}

template <class T>
std::vector<ZoneErrors> survey_scalar_forms(int points) {
    return survey<T>(points, [](const T& R, const T& zeta) { return evaluation::mode_functions(R, zeta); });
}

/// One mode at one ratio as an array has it. Where it marks a pole the scalar forms must have none either: what they have.
evaluation::ModeFunctions<double> array_of_one(double R, double zeta) {
    double v_re = 0, v_im = 0, u = 0, g = 0;
    std::uint8_t at_pole = 0;
    (void)evaluation::mode_functions(
        std::span(&R, 1), zeta,
        {std::span(&v_re, 1), std::span(&v_im, 1), std::span(&u, 1), std::span(&g, 1), std::span(&at_pole, 1)});
    const evaluation::ModeFunctions<double> scalar = evaluation::mode_functions(R, zeta);
    const bool finite = std::isfinite(scalar.v.re + scalar.v.im) && std::isfinite(scalar.u + scalar.g);
    if (at_pole != 0 && !finite) return scalar;
    return {{v_re, v_im}, u, g};
}

} // namespace

std::string name(Precision p) {
    switch (p) {
    case Precision::in_float: return "float";
    case Precision::in_double: return "double";
    case Precision::in_long_double: return "long double";
    default: return "50 digits";
    }
}

std::vector<ZoneErrors> survey_mode_functions(Precision precision, int points) {
    switch (precision) {
    case Precision::in_float: return survey_scalar_forms<float>(points);
    case Precision::in_double: return survey_scalar_forms<double>(points);
    case Precision::in_long_double: return survey_scalar_forms<long double>(points);
    default: return survey_scalar_forms<Real50>(points);
    }
}

std::vector<ZoneErrors> survey_array_mode_functions(int points) { return survey<double>(points, array_of_one); }

Worst worst_of(const std::vector<ZoneErrors>& zones, Worst FunctionErrors::*which) {
    Worst worst;
    for (const ZoneErrors& zone : zones)
        for (const FunctionErrors& f : zone.functions) worst.note((f.*which).error, zone.zone + ": " + (f.*which).where);
    return worst;
}

Table table_of(const std::string& what, const std::vector<ZoneErrors>& zones) {
    const std::array<std::string, 4> functions{"Re v", "Im v", "u", "g"};
    Table table{
        "Mode functions " + what + ": worst error in units of eps over the condition number",
        {"zone", "points", "function", "printed, R and zeta", "shipped, R and zeta", "at R, zeta",
         "shipped, zeta alone, zeta up to 2^-10", "at R, zeta"},
        {},
        "The condition number is 1 or, where larger, the relative change for one of R or of zeta; zeta alone: R is taken as "
        "exact. Below the least normal number the unit is eps times that number; for u, where zeta^2 is below it, eps times "
        "that number over R^2."};
    for (const ZoneErrors& zone : zones)
        for (std::size_t i = 0; i < 4; ++i) {
            const FunctionErrors& f = zone.functions[i];
            table.rows.push_back({zone.zone, std::to_string(zone.points), functions[i], digits(f.printed.error),
                                  digits(f.by_both.error, "%.2f"), f.by_both.where, digits(f.light.error, "%.2f"),
                                  f.light.where});
        }
    return table;
}

} // namespace denhartog::tests
