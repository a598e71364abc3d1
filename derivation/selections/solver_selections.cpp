// The selections of the exact solver next to resonance, and of the arrays: each as shipped, with what its forms stand for.
#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/evaluation/driven_motion.hpp"
#include "denhartog/evaluation/mode_arrays.hpp"

#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/forms/overdamped_motion.hpp"
#include "derivation/selections/selections.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

Symbolic as_scalar(const ex& e) { return Symbolic(e); }

bool oscillates(const ex& zeta) { return !zeta.is_equal(1) && !zeta.is_equal(heavy()); }

std::vector<ex> at_ratio_of(std::vector<ex> values, const ex& R) {
    for (ex& value : values) value = value.subs(symbols().R == R);
    return values;
}

/// A double, which is a whole multiple of a power of two, as a number at its place.
Placed exactly(double x) {
    int exponent = 0;
    const double part = std::frexp(x, &exponent);
    if (part != 0.5) throw std::logic_error("a limit of the vectors is no power of two");
    return {as_scalar(GiNaC::pow(ex(2), exponent - 1)), x};
}

/// (23), (28), (29) of a mode.
std::vector<ex> functions_of_mode(const ex& R, const ex& zeta) {
    const Complex<Symbolic> v = paper::complex_response(as_scalar(R), as_scalar(zeta));
    std::vector<ex> functions{v.re.expression(), v.im.expression()};
    const std::vector<ex> damping =
        oscillates(zeta)
            ? std::vector<ex>{first_function(R, zeta), second_function(R, zeta)}
            : at_ratio_of(derived_damping_functions(zeta.is_equal(1) ? derived_double_rate() : derived_two_rates()), R);
    functions.insert(functions.end(), damping.begin(), damping.end());
    return functions;
}

/// An array's values of a mode: exponential, products of the half angle and series stand for themselves as in `batch_forms.cpp`.
std::vector<Placed> array_of_mode(const Placed& R, const Placed& zeta) {
    const evaluation::VectorRange<Placed> range{exactly(evaluation::least_vector_ratio()),
                                                exactly(evaluation::largest_vector_ratio()),
                                                exactly(evaluation::least_vector_damping())};
    if (evaluation::damping_beyond_vectors(zeta, range) || evaluation::ratio_beyond_vectors(R, range)) {
        const Complex<Placed> v = evaluation::complex_response(R, zeta);
        const evaluation::DampingFunctions<Placed> f = evaluation::selected_damping_functions(R, zeta);
        return {v.re, v.im, f.u, f.g};
    }
    const evaluation::ArrayMode<Placed> m = evaluation::array_mode(zeta);
    const evaluation::AngleOfMode<Placed> half = evaluation::angle_of_mode(zeta);
    const Placed x = 1 / (2 * R), delta = m.two_pi_zeta * x, decay = exp(-delta / 2);
    const Placed angle = pi<Placed>() * ((half.w - half.late) * x), s = sin(angle), c = cos(angle);
    const evaluation::Exponential<Placed> e{decay, decay, evaluation::exp_minus_one(Placed(-delta))};
    const evaluation::HalfAngleProducts<Placed> h{s * c, c * c};
    if (!evaluation::is_large_ratio(R)) { // the other form of (29), in any block
        const evaluation::ModeFunctions<Placed> f = evaluation::array_mode_functions<false>(R, m, x, e, h, Placed(0));
        return {f.v.re, f.v.im, f.u, f.g};
    }
    const Placed series = sinhc_less_sinc_over_square(Placed(2 * pi<Placed>() * x), zeta);
    const evaluation::ModeFunctions<Placed> f = evaluation::array_mode_functions<true>(R, m, x, e, h, series);
    return {f.v.re, f.v.im, f.u, f.g};
}

/// The motion (A.6) and its rate, with the free motions that go with the damping ratio.
std::vector<ex> motion_from_start(const ex& R, const ex& zeta) {
    const Symbols& n = symbols();
    std::vector<ex> free;
    if (oscillates(zeta))
        free = {paper::d(as_scalar(n.tau), as_scalar(R), as_scalar(zeta)).expression(),
                paper::q(as_scalar(n.tau), as_scalar(R), as_scalar(zeta)).expression()};
    else
        free = at_ratio_of(derived_free_motions(zeta.is_equal(1) ? derived_double_rate() : derived_two_rates()), R);
    const Complex<Symbolic> v = paper::complex_response(as_scalar(R), as_scalar(zeta));
    const ex v_cos = times_cosine(v, as_scalar(n.phi_j)).expression(), v_sin = times_sine(v, as_scalar(n.phi_j)).expression();
    const ex d = free.at(0), q = free.at(1);
    const ex motion = d * n.eta_0 + R * q * n.eta_prime_0 + n.psi_ji * R * R * (1 - d) * n.beta +
                      n.psi_li * R * R * ((GiNaC::cos(n.tau) - d) * v_cos + (R * q - GiNaC::sin(n.tau)) * v_sin);
    return {motion, motion.diff(GiNaC::ex_to<GiNaC::symbol>(n.tau))};
}

/// The exact solver's form of a coordinate. The difference of the frequencies, `detuning`, is decided by itself, as what is
/// left over; in the motion its meaning stands for it.
std::vector<Placed> motion_taken(const Placed& tau, const Placed& R, const Placed& zeta) {
    const Symbols& n = symbols();
    const auto placed = [](const ex& e, double value) { return Placed(as_scalar(e), value); };
    const Placed omega = 1 / R, decay = zeta * omega, F = placed(n.psi_li, 0.6);
    const Placed at_rest = placed(n.psi_ji * n.beta, 0.1) / (omega * omega);
    const double phi = 0.25;
    const Placed cos_0 = placed(GiNaC::cos(n.phi_j), std::cos(phi)), sin_0 = placed(GiNaC::sin(n.phi_j), std::sin(phi));
    const ex instant = tau.symbolic().expression() + n.phi_j;
    const Placed cosine = placed(GiNaC::cos(instant), std::cos(tau.value() + phi));
    const Placed sine = placed(GiNaC::sin(instant), std::sin(tau.value() + phi));
    evaluation::DrivenCoordinate<Placed> c = evaluation::driven_coordinate(omega, Placed(1 - omega * omega), decay, F);
    Placed left_over(0);
    if (c.together) {
        const Placed apart = 1 - sqrt((1 - zeta) * (1 + zeta)) * omega;
        left_over = c.apart - apart;
        c.apart = apart;
    }
    const InitialValues<Placed> from{placed(n.eta_0, 0.7), placed(n.eta_prime_0, 0.3)};
    const evaluation::DrivenStart<Placed> start{evaluation::free_start(from, at_rest, c.X, cos_0, sin_0), at_rest, cos_0, sin_0};
    const evaluation::FreeMotion<Placed> free = evaluation::free_motion(tau, c.R, c.zeta, c.w);
    const InitialValues<Placed> motion = evaluation::motion_of_coordinate(free, tau, c, start, cosine, sine);
    return {motion.eta_0, motion.eta_prime_0, left_over};
}

const Register claims_of_solver_selections([] {
    using P = const Placed&;
    const std::vector<Selection> selections{{"array_mode_functions", [](P, P R, P zeta) { return array_of_mode(R, zeta); },
                                             [](const ex&, const ex& R, const ex& zeta) { return functions_of_mode(R, zeta); }},
                                            {"motion_of_coordinate", motion_taken, [](const ex&, const ex& R, const ex& zeta) {
                                                 std::vector<ex> meaning = motion_from_start(R, zeta);
                                                 meaning.emplace_back(0);
                                                 return meaning;
                                             }}};
    const std::vector<std::vector<std::string>> equations{{"23", "28", "29"}, {"A.6", "A.7"}};
    const std::vector<std::string> titles{
        "Every form that the arrays can take is proved where it is taken, at any width of the vectors, for which the text is one",
        "Every form that the exact solver can take for a coordinate, next to resonance and elsewhere, is proved where it is "
        "taken"};
    std::vector<Claim> list;
    for (std::size_t i = 0; i < selections.size(); ++i)
        list.push_back({.id = "selection/" + selections[i].name,
                        .equations = equations[i],
                        .role = Role::step,
                        .title = titles[i],
                        .assumptions = {"R_i > 0", "zeta_i >= 0"},
                        .check = [selection = selections[i]] { return check_selection(selection); }});
    return list;
});

} // namespace

} // namespace denhartog::derivation
