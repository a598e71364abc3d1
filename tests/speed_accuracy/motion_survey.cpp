#include "tests/speed_accuracy/motion_survey.hpp"

#include <array>
#include <functional>

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/evaluation/resonance.hpp"
#include "tests/speed_accuracy/mode_places.hpp"

namespace denhartog::tests {
namespace {

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

template <std::size_t n, class Wide>
std::array<Real100, n> in_100_digits(const std::array<Wide, n>& f) {
    std::array<Real100, n> all;
    for (std::size_t i = 0; i < n; ++i) all[i] = static_cast<Real100>(f[i]);
    return all;
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
    if (needed < 100) return motion_in<Real100>(p);
    if (needed < 300) return motion_in<Real300>(p);
    if (needed < 600) return motion_in<Real600>(p);
    return motion_in<Real1100>(p);
}

/// Condition numbers, 1 at least, with respect to any argument of a function, moved by h of itself.
template <std::size_t n, class Wide, std::size_t m, class Function>
std::array<double, n> conditions(const std::array<Wide, m>& arguments, const Function& function,
                                 const Wide& h = ldexp(Wide(1), -5 * std::numeric_limits<Wide>::digits / 8)) {
    const std::array<Wide, n> f = function(arguments);
    std::array<double, n> found;
    found.fill(1);
    for (std::size_t k = 0; k < m; ++k) {
        std::array<Wide, m> other = arguments;
        other[k] *= 1 - h;
        const std::array<Wide, n> there = function(other);
        for (std::size_t i = 0; i < n; ++i)
            if (f[i] != 0) found[i] = std::max(found[i], static_cast<double>(Wide(abs(Wide((there[i] - f[i]) / (h * f[i]))))));
    }
    return found;
}

/// The truth at a point, by which errors are measured, and condition numbers, computed only if they are needed.
template <std::size_t n>
struct Reference {
    std::function<std::array<Real100, n>()> truth;
    std::function<std::array<double, n>()> conditions;
};

/// Hands the errors over the condition numbers of those functions whose errors may be among the worst to `take`, until that says
/// that it has seen enough. A condition number can only lessen an error: it is needed for these alone.
template <std::size_t n, class T, class Take>
void over_conditions(const FunctionInZone* errors, const std::array<T, n>& printed, const std::array<T, n>& shipped,
                     const Reference<n>& by, double share, const Take& take) {
    const Real100 least((std::numeric_limits<T>::min)());
    const std::array<Real100, n> truth = by.truth();
    std::array<double, n> condition{};
    for (std::size_t i = 0; i < n; ++i) {
        const double by_shipped = error_of(shipped[i], truth[i], least), by_printed = error_of(printed[i], truth[i], least);
        if (by_shipped <= share * errors[i].shipped.error && by_printed <= share * errors[i].printed.error) continue;
        if (condition[0] == 0) condition = by.conditions();
        if (take(i, by_shipped / condition[i], by_printed / condition[i])) return;
    }
}

/// Notes the errors of n functions at one point: by the paper's formulas where `always`, where there is nothing nearer, and where
/// by what is nearer an error is more than half of the worst so far.
template <std::size_t n, class T>
void note(FunctionInZone* errors, const std::array<T, n>& printed, const std::array<T, n>& shipped, const std::string& at,
          bool always, const Reference<n>& near, const Reference<n>& paper) {
    for (std::size_t i = 0; i < n; ++i) ++errors[i].points;
    bool is_near_worst = always || std::is_same_v<T, Real50> || errors[0].points % always_against_the_paper == 0;
    if (!is_near_worst)
        over_conditions(errors, printed, shipped, near, 0.5, [&](std::size_t i, double by_shipped, double by_printed) {
            is_near_worst = !(by_shipped <= 0.5 * errors[i].shipped.error) || !(by_printed <= 0.5 * errors[i].printed.error);
            return is_near_worst;
        });
    if (!is_near_worst) return;
    for (std::size_t i = 0; i < n; ++i) ++errors[i].against_the_paper;
    over_conditions(errors, printed, shipped, paper, 1, [&](std::size_t i, double by_shipped, double by_printed) {
        errors[i].shipped.note(by_shipped, at);
        errors[i].printed.note(by_printed, at);
        return false;
    });
}

/// Condition numbers of the motion; of d, q and their rates those of a step of 4 units too where R is small beside tau.
template <class Wide, class T>
std::array<double, 5> conditions_of_motion(const Instant<T>& p) {
    const std::array<Wide, 3> arguments{Wide(p.tau), Wide(p.place.R), Wide(p.place.zeta)};
    std::array<double, 5> found =
        conditions<5>(arguments, [](const std::array<Wide, 3>& a) { return shipped_motion(a[0], a[1], a[2]); });
    const Wide step = Wide(most_allowed) * Wide(std::numeric_limits<T>::epsilon());
    if (arguments[0] * arguments[0] * step < arguments[1] * arguments[1]) return found;
    for (const Wide& h : {step, Wide(-step)}) {
        const std::array<double, 4> of_step = conditions<4>(arguments, shipped_free_motion<Wide>, h);
        for (std::size_t i = 0; i < 4; ++i) found[i] = std::max(found[i], of_step[i]);
    }
    return found;
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
    note<5>(errors, printed, shipped, hexadecimal(p.tau) + ", " + hexadecimal(m.R) + ", " + hexadecimal(m.zeta), is_hard,
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

template <class T>
std::vector<FunctionInZone> motion(int points) {
    std::vector<FunctionInZone> all;
    const std::vector<std::string>& zones = mode_zones();
    for (const std::string& zone : zones)
        for (const std::string& function : motions) all.push_back({zone, function, 0, 0, {}, {}});
    Source<T> source;
    const std::size_t seeded = zones.size() - 1;
    for (std::size_t zone = 0; zone < seeded; ++zone)
        for (int n = 0; n < points / static_cast<int>(seeded); ++n) {
            const Place<T> place = place_in(zone, source);
            note(&all[zone * motions.size()], Instant<T>{place, instant(source)}, false);
        }
    const std::array<T, 4> instants{T(1) / 1024, pi<T>() / 2, T(3), end_of_half_period<T>()};
    std::size_t next = 0;
    for (const Place<T>& place : hard_places<T>())
        note(&all[seeded * motions.size()], Instant<T>{place, instants[next++ % instants.size()]}, true);
    return all;
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
    for (const std::string& function : resonances) all.push_back({"zeta subnormal to 1", function, 0, 0, {}, {}});
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
        note<4>(all.data(), printed_at_resonance(psi_k, psi_j, zeta, beta), shipped_at_resonance(psi_k, psi_j, zeta, beta),
                hexadecimal(zeta) + ", " + hexadecimal(beta), false,
                {[&] { return in_100_digits(shipped_of<Real50>(narrow)); },
                 [&] { return conditions<4>(narrow, shipped_of<Real50>); }},
                {[&] {
                     return needed < 100   ? truth_at_resonance<Real100>(wide)
                            : needed < 300 ? truth_at_resonance<Real300>(wide)
                                           : truth_at_resonance<Real1100>(wide);
                 },
                 [&] { return conditions<4>(wide, shipped_of<Real100>); }});
    }
    return all;
}

} // namespace

std::vector<FunctionInZone> survey_motion(Precision precision, int points) {
    switch (precision) {
    case Precision::in_float: return motion<float>(points);
    case Precision::in_double: return motion<double>(points);
    case Precision::in_long_double: return motion<long double>(points);
    default: return motion<Real50>(points);
    }
}

std::vector<FunctionInZone> survey_resonance(Precision precision, int points) {
    switch (precision) {
    case Precision::in_float: return resonance<float>(points);
    case Precision::in_double: return resonance<double>(points);
    case Precision::in_long_double: return resonance<long double>(points);
    default: return resonance<Real50>(points);
    }
}

Worst worst_of(const std::vector<FunctionInZone>& all, Worst FunctionInZone::*which) {
    Worst worst;
    for (const FunctionInZone& f : all) worst.note((f.*which).error, f.function + ", " + f.zone + ": " + (f.*which).where);
    return worst;
}

Table table_of(const std::string& title, const std::vector<FunctionInZone>& all) {
    Table table{
        title + ": worst error in units of eps over the condition number",
        {"zone", "points", "against the paper's", "function", "printed", "shipped", "at, in hexadecimal"},
        {},
        "The condition number is 1 or, where larger, the relative change for one of an argument; of d, q and their rates, which "
        "turn within a few units of a large tau / R, that for an argument moved by 4 units. Below the least normal number "
        "the unit is eps times that number. Against the paper's formulas in 100 digits and more: one point in 16, the hard "
        "points, and every point at which the shipped forms in 50 digits, themselves surveyed here, make an error more than half "
        "of the "
        "worst so far."};
    for (const FunctionInZone& f : all)
        table.rows.push_back({f.zone, std::to_string(f.points), std::to_string(f.against_the_paper), f.function,
                              digits(f.printed.error), digits(f.shipped.error, "%.2f"), f.shipped.where});
    return table;
}

} // namespace denhartog::tests
