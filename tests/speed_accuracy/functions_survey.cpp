#include "tests/speed_accuracy/functions_survey.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/evaluation/resonance.hpp"
#include "tests/speed_accuracy/function_errors.hpp"

namespace denhartog::tests {
namespace {

using Json = nlohmann::ordered_json;

/// The equations that a function of the surveys is named after or belongs to.
const std::map<std::string, std::vector<std::string>> equations_of = {
    {"Re v", {"23"}}, {"Im v", {"23"}}, {"u", {"28"}},
    {"g", {"29"}},    {"d", {"A.8"}},   {"q", {"A.8"}},
    {"d'", {"A.9"}},  {"q'", {"A.9"}},  {"expression of (57)", {"57"}},
    {"(79)", {"79"}}, {"(83)", {"83"}}, {"(84)", {"84"}},
    {"(85)", {"85"}}};

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(); }

} // namespace

std::string accuracy_record(const std::string& type, const std::vector<FunctionInZone>& all) {
    Json rows = Json::array();
    for (const FunctionInZone& f : all)
        rows.push_back({{"function", f.function},
                        {"equations", equations_of.at(f.function)},
                        {"zone", f.zone},
                        {"points", f.points},
                        {"printed", number(f.printed.error)},
                        {"shipped", number(f.shipped.error)},
                        {"shipped_at", f.shipped.where}});
    return Json{{"type", type}, {"functions", rows}}.dump(1) + "\n";
}

bool keep_record(const std::string& name, const std::string& text) {
    const char* folder = std::getenv("DENHARTOG_RECORDS");
    if (folder == nullptr) return true;
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    std::string stem = name;
    std::replace(stem.begin(), stem.end(), ' ', '_');
    std::ofstream file(std::filesystem::path(folder) / (stem + ".json"));
    file << text;
    file.close();
    return static_cast<bool>(file);
}

namespace {

const std::array<std::string, 4> mode_functions{"Re v", "Im v", "u", "g"};
const std::array<std::string, 5> motions{"d", "q", "d'", "q'", "expression of (57)"};
const std::array<std::string, 4> resonances{"(79)", "(83)", "(84)", "(85)"};

template <class T>
struct Instant {
    Place<T> place;
    T tau;
};

/// The paper's formulas in the digits of Wide.
template <class Wide>
std::array<Wide, 5> printed_motion(const Wide& tau, const Wide& R, const Wide& zeta, const Wide& u, const Wide& g) {
    return {paper::d(tau, R, zeta), paper::q(tau, R, zeta), paper::d_prime(tau, R, zeta), paper::q_prime(tau, R, zeta),
            paper::s_d_integrand(tau, R, zeta, u, g)};
}

/// At time, ratio, damping ratio.
template <class T>
std::array<T, 4> shipped_free_motion(const std::array<T, 3>& a) {
    const evaluation::FreeMotion<T> f = evaluation::free_motion(a[0], a[1], a[2], evaluation::w_if_oscillating(a[2]));
    return {f.d, f.q, f.d_prime, f.q_prime};
}

template <class T>
std::array<T, 5> shipped_motion(const T& tau, const T& R, const T& zeta) {
    const std::array<T, 4> f = shipped_free_motion<T>({tau, R, zeta});
    return {f[0], f[1], f[2], f[3], s_d_rounded_once(tau, R, zeta)};
}

template <class Wide, class T>
std::array<Real100, 5> motion_in(const Instant<T>& p) {
    const Wide tau(p.tau), R(p.place.R), zeta(p.place.zeta);
    std::array<Wide, 5> f;
    if (decays_out_of_range(p.place)) {
        if (std::log10(static_cast<double>(p.tau)) + std::log10(static_cast<double>(p.place.zeta)) -
                std::log10(static_cast<double>(p.place.R)) >
            8.872) // below 2^(-2^30)
            return {};
        f = printed_motion<Wide>(tau, R, zeta, Wide(0), Wide(1));
    } else {
        f = printed_motion<Wide>(tau, R, zeta, paper::first_damping_function(R, zeta), paper::second_damping_function(R, zeta));
    }
    return in_100_digits(f);
}

/// The truth at an instant, in enough digits: the printed forms lose those of the place, and more of them at the ends of the
/// half-period, where a quotient of two
/// small numbers is taken.
template <class T>
std::array<Real100, 5> truth_of(const Instant<T>& p) {
    const double end = static_cast<double>(std::min(p.tau, T(abs(T(pi<T>() - p.tau))) + std::numeric_limits<T>::epsilon()));
    const double needed = digits_needed(p.place) - 2 * std::log10(end);
    return in_digits(needed, [&]<class Wide>(Wide) { return motion_in<Wide>(p); });
}

/// Condition numbers of the motion; of d, q and their rates those of a step of 4 units too where R is small beside tau.
template <class Wide, class T>
ConditionNumbers<5> conditions_of_motion(const Instant<T>& p) {
    const std::array<Wide, 3> arguments{Wide(p.tau), Wide(p.place.R), Wide(p.place.zeta)};
    std::array<double, 5> found =
        conditions<5>(arguments, [](const std::array<Wide, 3>& a) { return shipped_motion(a[0], a[1], a[2]); });
    const Wide step = Wide(most_allowed) * Wide(std::numeric_limits<T>::epsilon());
    if (arguments[0] * arguments[0] * step < arguments[1] * arguments[1]) return {found};
    for (const Wide& h : {step, Wide(-step)}) {
        const std::array<double, 4> of_step = conditions<4>(arguments, shipped_free_motion<Wide>, h);
        for (std::size_t i = 0; i < 4; ++i) found[i] = std::max(found[i], of_step[i]);
    }
    return {found};
}

template <class T>
void note(FunctionInZone* errors, const Instant<T>& p, bool is_hard) {
    const Place<T>& m = p.place;
    if (m.zeta == 0 && evaluation::at_undamped_pole(m.R)) return;
    // Where a unit in the last place of R is a turn of the free motion, no digit of it is known.
    if (p.tau * std::numeric_limits<T>::epsilon() > m.R) return;
    const std::array<T, 5> shipped = shipped_motion(p.tau, m.R, m.zeta),
                           printed = printed_motion(p.tau, m.R, m.zeta, paper::first_damping_function(m.R, m.zeta),
                                                    paper::second_damping_function(m.R, m.zeta));
    const std::string at = hexadecimal(p.tau) + ", " + hexadecimal(m.R) + ", " + hexadecimal(m.zeta);
    note(errors, SurveyedPoint<5, T>(printed, shipped, at, is_hard),
         {[&] { return in_100_digits(shipped_motion(Real50(p.tau), Real50(m.R), Real50(m.zeta))); },
          [&] { return conditions_of_motion<Real50>(p); }},
         {[&] { return truth_of(p); }, [&] { return conditions_of_motion<Real100>(p); }});
}

/// The largest number in the half-period.
template <class T>
T end_of_half_period() {
    return Real1100(pi<T>()) > pi<Real1100>() ? T(pi<T>() * (1 - std::numeric_limits<T>::epsilon() / 2)) : pi<T>();
}

template <class T>
T instant(Source<T>& source) {
    const T near_end = T(source.spread(-18, 0));
    switch (source.whole(0, 3)) {
    case 0: return near_end;
    case 1: return std::min(T(pi<T>() - near_end), end_of_half_period<T>());
    default: return source.spread(-1, 0) * T(source.uniform(0, 3.14)) / 2;
    }
}

template <std::size_t n>
std::vector<FunctionInZone> entries(const std::array<std::string, n>& functions) {
    std::vector<FunctionInZone> all;
    for (const std::string& zone : mode_zones())
        for (const std::string& function : functions) all.push_back({zone, function});
    return all;
}

/// Visits seeded places in each zone, then the hard ones, with where the first entry of the zone stands.
template <class T, class Visit>
void over_places(int points, std::size_t functions, const Visit& visit) {
    Source<T> source;
    const std::size_t seeded = mode_zones().size() - 1;
    for (std::size_t zone = 0; zone < seeded; ++zone)
        for (int n = 0; n < points / static_cast<int>(seeded); ++n) {
            const Place<T> place = place_in(zone, source);
            visit(zone * functions, place, source, false);
        }
    for (const Place<T>& place : hard_places<T>()) visit(seeded * functions, place, source, true);
}

template <class T>
std::vector<FunctionInZone> motion(int points) {
    std::vector<FunctionInZone> all = entries(motions);
    const std::array<T, 4> instants{T(1) / 1024, pi<T>() / 2, T(3), end_of_half_period<T>()};
    std::size_t next = 0;
    over_places<T>(points, motions.size(), [&](std::size_t at, const Place<T>& place, Source<T>& source, bool is_hard) {
        note(&all[at], Instant<T>{place, is_hard ? instants[next++ % instants.size()] : instant(source)}, is_hard);
    });
    return all;
}

/// The paper's formulas in the digits of Wide.
template <class Wide>
std::array<Wide, 4> printed_mode(const Wide& R, const Wide& zeta) {
    const Complex<Wide> v = paper::complex_response(R, zeta);
    return {v.re, v.im, paper::first_damping_function(R, zeta), paper::second_damping_function(R, zeta)};
}

/// At a ratio and a damping ratio.
template <class T>
std::array<T, 4> shipped_mode(const T& R, const T& zeta) {
    const evaluation::ModeFunctions<T> f = evaluation::mode_functions(R, zeta);
    return {f.v.re, f.v.im, f.u, f.g};
}

/// Condition numbers of the mode functions; a few digits are enough, so the shipped forms serve.
template <class Wide, class T>
ConditionNumbers<4> conditions_of_mode(const Place<T>& p) {
    const Wide R(p.R), zeta(p.zeta);
    return {conditions<4>(std::array{R, zeta}, [](const std::array<Wide, 2>& a) { return shipped_mode(a[0], a[1]); }),
            conditions<4>(std::array{zeta}, [&](const std::array<Wide, 1>& a) { return shipped_mode(R, a[0]); })};
}

template <class Wide, class T>
std::array<Real100, 4> mode_in(const Place<T>& p) {
    std::array<Real100, 4> truth = in_100_digits(printed_mode(Wide(p.R), Wide(p.zeta)));
    using std::remainder;
    if (p.zeta == 0 && remainder(T(1), p.R) == 0) truth[2] = 0; // sin(n pi), which pi rounded does not give
    return truth;
}

/// The truth: the paper's formulas in as many digits as they need.
template <class T>
std::array<Real100, 4> truth_of(const Place<T>& p) {
    if (decays_out_of_range(p)) {
        const Complex<Real100> v = paper::complex_response(Real100(p.R), Real100(p.zeta));
        return {v.re, v.im, Real100(0), Real100(1)};
    }
    return in_digits(digits_needed(p), [&]<class Wide>(Wide) { return mode_in<Wide>(p); });
}

template <class T, class Forms>
void note(FunctionInZone* errors, const Place<T>& place, const Forms& forms, bool is_hard) {
    const evaluation::ModeFunctions<T> f = forms(place.R, place.zeta);
    if (place.zeta == 0 && evaluation::at_undamped_pole(place.R)) {
        for (std::size_t i = 0; i < 4; ++i) ++errors[i].points;
        ++errors->poles;
        errors->finite_at_poles += boost::math::isfinite(f.u) ? 1 : 0;
        return;
    }
    SurveyedPoint<4, T> p(printed_mode(place.R, place.zeta), {f.v.re, f.v.im, f.u, f.g},
                          hexadecimal(place.R) + ", " + hexadecimal(place.zeta), is_hard);
    const Real100 R(place.R);
    if (Real100(place.zeta) * Real100(place.zeta) < p.least[2] && R < 1) p.least[2] /= R * R;
    p.light = place.zeta * 1024 <= 1;
    note(errors, p,
         {[&] { return in_100_digits(shipped_mode(Real50(place.R), Real50(place.zeta))); },
          [&] { return conditions_of_mode<Real50>(place); }},
         {[&] { return truth_of(place); }, [&] { return conditions_of_mode<Real100>(place); }});
}

template <class T, class Forms>
std::vector<FunctionInZone> modes(int points, const Forms& forms) {
    std::vector<FunctionInZone> all = entries(mode_functions);
    over_places<T>(points, mode_functions.size(), [&](std::size_t at, const Place<T>& place, Source<T>&, bool is_hard) {
        note(&all[at], place, forms, is_hard);
    });
    std::ranges::stable_sort(all, {}, [](const FunctionInZone& f) { return std::ranges::find(mode_functions, f.function); });
    return all;
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

/// Mode shapes, damping ratio, friction ratio.
template <class T>
std::array<T, 4> shipped_at_resonance(const T& psi_k, const T& psi_j, const T& zeta, const T& beta) {
    return {evaluation::second_damping_function_at_resonance(zeta), evaluation::resonant_peak(psi_k, T(1), psi_j, zeta, beta),
            evaluation::resonant_peak_of_single_mass(zeta, beta),
            evaluation::friction_ratio_limit_at_resonance(psi_k, psi_j, zeta)};
}

template <class T>
std::array<T, 4> printed_at_resonance(const T& psi_k, const T& psi_j, const T& zeta, const T& beta) {
    return {paper::second_damping_function_at_resonance(zeta), paper::resonant_peak(psi_k, T(1), psi_j, zeta, beta),
            paper::resonant_peak_of_single_mass(zeta, beta), paper::friction_ratio_limit_at_resonance(psi_k, psi_j, zeta)};
}

template <class T>
std::array<T, 4> shipped_of(const std::array<T, 4>& a) {
    return shipped_at_resonance(a[0], a[1], a[2], a[3]);
}

/// The paper's formulas in the digits of Wide.
template <class Wide>
std::array<Real100, 4> truth_at_resonance(const std::array<Real100, 4>& a) {
    return in_100_digits(printed_at_resonance<Wide>(Wide(a[0]), Wide(a[1]), Wide(a[2]), Wide(a[3])));
}

template <class T>
std::vector<FunctionInZone> resonance(int points) {
    std::vector<FunctionInZone> all;
    for (const std::string& function : resonances) all.push_back({"zeta subnormal to 1", function});
    Source<T> source;
    for (int n = 0; n < points; ++n) {
        const T zeta = below_one(source.spread(n % 8 == 0 ? (std::is_same_v<T, float> ? -38 : -308) : -12, 0));
        const T psi_k = source.spread(-2, 1), psi_j = source.whole(0, 1) ? psi_k : source.spread(-2, 1);
        const T limit = evaluation::friction_ratio_limit_at_resonance(T(1), T(1), zeta);
        const T beta = source.whole(0, 1) ? T(limit * source.near_one()) : source.spread(-6, 1);
        const std::array<Real100, 4> wide{Real100(psi_k), Real100(psi_j), Real100(zeta), Real100(beta)};
        const double lost = -2 * std::max(-310.0, std::log10(static_cast<double>(zeta))); // by cosh - 1, by the peak at its end
        const double needed = 2 * std::numeric_limits<T>::digits10 + 10 + lost;
        const std::array<Real50, 4> narrow{Real50(psi_k), Real50(psi_j), Real50(zeta), Real50(beta)};
        note(all.data(),
             SurveyedPoint<4, T>(printed_at_resonance(psi_k, psi_j, zeta, beta), shipped_at_resonance(psi_k, psi_j, zeta, beta),
                                 hexadecimal(zeta) + ", " + hexadecimal(beta), false),
             {[&] { return in_100_digits(shipped_of<Real50>(narrow)); },
              [&] { return ConditionNumbers<4>{conditions<4>(narrow, shipped_of<Real50>)}; }},
             {[&] { return in_digits(needed, [&]<class Wide>(Wide) { return truth_at_resonance<Wide>(wide); }); },
              [&] { return ConditionNumbers<4>{conditions<4>(wide, shipped_of<Real100>)}; }});
    }
    return all;
}

/// What a survey in the number type of a precision gives.
template <class Survey>
std::vector<FunctionInZone> in_precision(Precision precision, const Survey& survey) {
    switch (precision) {
    case Precision::in_float: return survey(float());
    case Precision::in_double: return survey(double());
    case Precision::in_long_double: return survey(std::numeric_limits<long double>::epsilon());
    default: return survey(Real50());
    }
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

std::vector<FunctionInZone> survey_mode_functions(Precision precision, int points) {
    return in_precision(precision, [&]<class T>(T) {
        return modes<T>(points, [](const T& R, const T& zeta) { return evaluation::mode_functions(R, zeta); });
    });
}

std::vector<FunctionInZone> survey_array_mode_functions(int points) { return modes<double>(points, array_of_one); }

std::vector<FunctionInZone> survey_motion(Precision precision, int points) {
    return in_precision(precision, [&]<class T>(T) { return motion<T>(points); });
}

std::vector<FunctionInZone> survey_resonance(Precision precision, int points) {
    return in_precision(precision, [&]<class T>(T) { return resonance<T>(points); });
}

Worst worst_of(const std::vector<FunctionInZone>& all, Worst FunctionInZone::*which) {
    Worst worst;
    for (const FunctionInZone& f : all) worst.note((f.*which).error, f.function + ", " + f.zone + ": " + (f.*which).where);
    return worst;
}

Table table_of(const std::string& title, const std::vector<FunctionInZone>& all) {
    Table table{
        title + ": worst error in units of eps over the condition number",
        {"zone", "points", "against the paper's", "function", "printed", "shipped", "at, in hexadecimal",
         "shipped, zeta alone, zeta up to 2^-10", "at R, zeta"},
        {},
        "The condition number is 1 or, where larger, the relative change for one of an argument; of d, q and their rates, which "
        "turn within a few units of a large tau / R, that for an argument moved by 4 units; zeta alone: R is taken as exact. "
        "Below the least normal number the unit is eps times that number; for u, where zeta^2 is below it, eps times that number "
        "over R^2. Against the paper's formulas in 100 digits and more: one point in 16, the hard points, and every point at "
        "which the shipped forms in 50 digits, themselves surveyed here, make an error more than half of the worst so far."};
    for (const FunctionInZone& f : all)
        table.rows.push_back({f.zone, std::to_string(f.points), std::to_string(f.against_the_paper), f.function,
                              digits(f.printed.error), digits(f.shipped.error, "%.2f"), f.shipped.where,
                              f.light.count > 0 ? digits(f.light.error, "%.2f") : "", f.light.where});
    return table;
}

} // namespace denhartog::tests
