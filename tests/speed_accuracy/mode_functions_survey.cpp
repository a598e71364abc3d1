#include "tests/speed_accuracy/mode_functions_survey.hpp"

#include <cmath>
#include <optional>

#include "denhartog/evaluation/mode_arrays.hpp"
#include "tests/speed_accuracy/mode_places.hpp"
#include "tests/support/multiprecision.hpp"

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

/// The shipped forms.
template <class T>
std::array<T, 4> shipped(const T& R, const T& zeta) {
    const evaluation::ModeFunctions<T> f = evaluation::mode_functions(R, zeta);
    return {f.v.re, f.v.im, f.u, f.g};
}

/// Relative change of each function for a relative change of R or zeta; a few digits are enough, so the shipped forms serve.
template <class Wide, class T>
Conditions conditions(const Place<T>& p) {
    const Wide h = ldexp(Wide(1), -5 * std::numeric_limits<Wide>::digits / 8), R(p.R), zeta(p.zeta);
    const std::array<Wide, 4> f = shipped(R, zeta), other_R = shipped(Wide(R * (1 - h)), zeta),
                              other_zeta = shipped(R, Wide(zeta * (1 - h)));
    Conditions found;
    for (std::size_t i = 0; i < 4; ++i) {
        if (f[i] == 0) continue;
        const auto change = [&](const Wide& other) { return static_cast<double>(Wide(abs(Wide((other - f[i]) / (h * f[i]))))); };
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
    using std::remainder;
    if (p.zeta == 0 && remainder(T(1), p.R) == 0) truth[2] = 0; // sin(n pi), which pi rounded does not give
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

/// The values at a point, and what their errors are measured by.
template <class T>
struct SurveyedPoint {
    Place<T> place;
    std::array<T, 4> shipped, printed;
    std::array<Real100, 4> least; ///< sizes below which errors are absolute
    bool light;                   ///< whether the errors count with R taken as exact too

    SurveyedPoint(const Place<T>& p, const std::array<T, 4>& values)
        : place(p), shipped(values), printed(tests::printed(p.R, p.zeta)) {
        const Real100 normal((std::numeric_limits<T>::min)()), R(p.R), square = Real100(p.zeta) * Real100(p.zeta);
        const Real100 least_u = square < normal && R < 1 ? Real100(normal / (R * R)) : normal;
        least = {normal, normal, least_u, normal};
        light = p.zeta * 1024 <= 1;
    }
};

/// Hands the errors over the condition numbers of those functions whose errors may be among the worst to `take`, until that says
/// that it has seen enough. A condition number can only lessen an error: it is needed for these alone.
template <class Wide, class T, class Take>
void over_conditions(const SurveyedPoint<T>& p, const Four& truth, const ZoneErrors& errors, double share, const Take& take) {
    std::optional<Conditions> known;
    for (std::size_t i = 0; i < 4; ++i) {
        const FunctionErrors& worst = errors.functions[i];
        const double error = error_of(p.shipped[i], truth[i], p.least[i]),
                     of_print = error_of(p.printed[i], truth[i], p.least[i]);
        const bool may_be_worst = !(error <= share * worst.by_both.error) || !(of_print <= share * worst.printed.error) ||
                                  (p.light && !(error <= share * worst.light.error));
        if (!may_be_worst) continue;
        if (!known) known = conditions<Wide>(p.place);
        if (take(i, error / known->by_both[i], of_print / known->by_both[i], error / known->by_zeta[i])) return;
    }
}

/// Whether, against the shipped forms in 50 digits, an error is more than half of the worst so far.
template <class T>
bool is_near_worst(const SurveyedPoint<T>& p, const ZoneErrors& errors) {
    const std::array<Real50, 4> near = shipped(Real50(p.place.R), Real50(p.place.zeta));
    Four truth;
    for (std::size_t i = 0; i < 4; ++i) truth[i] = static_cast<Real100>(near[i]);
    bool found = false;
    over_conditions<Real50>(p, truth, errors, 0.5, [&](std::size_t i, double by_both, double printed, double by_zeta) {
        const FunctionErrors& worst = errors.functions[i];
        found = !(by_both <= 0.5 * worst.by_both.error) || !(printed <= 0.5 * worst.printed.error) ||
                (p.light && !(by_zeta <= 0.5 * worst.light.error));
        return found;
    });
    return found;
}

template <class T, class Forms>
void note(ZoneErrors& errors, const Place<T>& place, const Forms& forms, bool is_hard) {
    ++errors.points;
    const evaluation::ModeFunctions<T> f = forms(place.R, place.zeta);
    if (place.zeta == 0 && evaluation::at_undamped_pole(place.R)) {
        ++errors.poles;
        errors.finite_at_poles += boost::math::isfinite(f.u) ? 1 : 0;
        return;
    }
    const SurveyedPoint<T> p(place, {f.v.re, f.v.im, f.u, f.g});
    if constexpr (!std::is_same_v<T, Real50>)
        if (!is_hard && errors.points % always_against_the_paper != 0 && !is_near_worst(p, errors)) return;
    ++errors.against_the_paper;
    const std::string at = hexadecimal(place.R) + ", " + hexadecimal(place.zeta);
    over_conditions<Real100>(p, truth_of(place), errors, 1, [&](std::size_t i, double by_both, double printed, double by_zeta) {
        FunctionErrors& worst = errors.functions[i];
        worst.by_both.note(by_both, at);
        worst.printed.note(printed, at);
        if (p.light) worst.light.note(by_zeta, at);
        return false;
    });
}

template <class T, class Forms>
std::vector<ZoneErrors> survey(int points, const Forms& forms) {
    std::vector<ZoneErrors> zones;
    Source<T> source;
    const std::size_t count = mode_zones().size() - 1;
    for (std::size_t zone = 0; zone < count; ++zone) {
        zones.push_back({mode_zones()[zone], 0, 0, 0, 0, {}});
        for (int n = 0; n < points / static_cast<int>(count); ++n) note(zones.back(), place_in(zone, source), forms, false);
    }
    zones.push_back({mode_zones().back(), 0, 0, 0, 0, {}});
    for (const Place<T>& p : hard_places<T>()) note(zones.back(), p, forms, true);
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
        {"zone", "points", "against the paper's", "function", "printed, R and zeta", "shipped, R and zeta", "at R, zeta",
         "shipped, zeta alone, zeta up to 2^-10", "at R, zeta"},
        {},
        "The condition number is 1 or, where larger, the relative change for one of R or of zeta; zeta alone: R is taken as "
        "exact. Below the least normal number the unit is eps times that number; for u, where zeta^2 is below it, eps times "
        "that number over R^2. Against the paper's formulas in 100 digits and more: one point in 16, the hard points, and every "
        "point at which the "
        "shipped forms in 50 digits, themselves surveyed here, make an error more than half of the worst so far."};
    for (const ZoneErrors& zone : zones)
        for (std::size_t i = 0; i < 4; ++i) {
            const FunctionErrors& f = zone.functions[i];
            table.rows.push_back({zone.zone, std::to_string(zone.points), std::to_string(zone.against_the_paper), functions[i],
                                  digits(f.printed.error), digits(f.by_both.error, "%.2f"), f.by_both.where,
                                  digits(f.light.error, "%.2f"), f.light.where});
        }
    return table;
}

} // namespace denhartog::tests
