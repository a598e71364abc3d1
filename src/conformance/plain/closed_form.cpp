// The answer of the closed form to each quantity of the protocol, from sums over modes, (33) to (69), with formulas written anew
// and no part of the library but the elementary functions; a contact that rests is followed from event to event. Read
// `numbers_of` first, then `computed` and `answer_of_steady_motion`.
#include "conformance/plain/closed_form.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

using std::numbers::pi;

// Largest value of a smooth function over [0, pi]: the best of equally spaced samples, refined by Brent's method to half the
// digits of the instant, which are all digits of the value.
double largest_over_half_period(const std::function<double(double)>& f, int steps) {
    const double h = pi / steps;
    const auto less = [&](double tau) { return -f(tau); };
    std::vector<double> samples;
    for (int n = 0; n < steps; ++n) samples.push_back(f(n * h)); // at pi it is less than at 0
    double best = *std::ranges::max_element(samples);
    const double reach = 1e-2 * std::abs(best);
    for (int n = 0; n < steps; ++n) {
        const auto at = static_cast<std::size_t>(n);
        if (samples[at] < best - reach || (n > 0 && samples[at - 1] > samples[at]) ||
            (n + 1 < steps && samples[at + 1] > samples[at]))
            continue;
        const double from = std::max(0.0, (n - 1) * h), to = (n + 1) * h;
        best = std::max(best,
                        -boost::math::tools::brent_find_minima(less, from, to, std::numeric_limits<double>::digits / 2).second);
    }
    return best;
}

// Largest value over the half-period, or at the instants tried: (57) as printed has none but those.
double largest(const PlainModes& m, const Choices& c, const std::function<double(double)>& f) {
    if (!c.instants) return largest_over_half_period(f, plain_steps(m));
    const double from = c.instants->first, to = pi - c.instants->before_end, last = static_cast<double>(c.instants->count - 1);
    double best = -1e300;
    for (double n = 0; n <= last; ++n) best = std::max(best, f(n == last ? to : from + n * (to - from) / last));
    return best;
}

// (56): the sum of the maxima of the modes.
double sum_of_maxima(const PlainModes& m, const Choices& c) {
    if (m.coupled) throw NoPlainAnswer();
    double S = 0;
    for (Index i = 0; i < m.R.size(); ++i)
        S += m.psi(m.j, i) * m.psi(m.j, i) *
             largest(m, c, [&](double tau) { return demand_of_mode(m, i, tau, c.demand_as_printed); });
    return S;
}

// Whether every mode meets (63) on its own.
bool every_mode_meets_63(PlainModes m, double beta) {
    m.beta = beta;
    const double phase = plain_phase(m, {});
    for (Index i = 0; i < m.R.size(); ++i) {
        const double psi_j = m.psi(m.j, i), psi_l = m.psi(m.l, i), R = m.R[i];
        const double eta_0 = R * R * (psi_l * times_cosine(m.v[i], phase) - psi_j * m.g[i] * beta);
        const double load = eta_0 - beta * psi_j * ((1 - R * R) * m.g[i] + 2 * m.zeta[i] * R * m.u[i]);
        if (std::abs(load) <= std::abs(psi_j) * m.mu * beta) return false;
    }
    return true;
}

// The first friction ratio up to a limit at which a mode fails (63).
double limit_mode_by_mode(const PlainModes& m, double limit) {
    constexpr int steps = 256;
    const auto met = [&](double beta) { return every_mode_meets_63(m, beta) ? 1.0 : -1.0; };
    for (int n = 1; n <= steps; ++n)
        if (met(limit * n / steps) < 0) return zero_between(met, limit * (n - 1) / steps, limit * n / steps);
    return limit;
}

double demand_at_rest(const PlainModes& m) { return m.H_j + m.mu * m.sum_of_squares; }

// (69) with the demand alone; and (67).
double limit_by(const PlainModes& m, double S) { return modulus(m.V[m.j]) / elementary::hypot(m.U[m.j], S); }

double approximate_limit(const PlainModes& m, const Choices& c) {
    const double limit = limit_by(m, demand_at_rest(m));
    return c.load_of_each_mode ? limit_mode_by_mode(m, limit) : limit;
}

// The smallest beta at which the contact never moves.
double sticking_limit(const ProtocolQuestion& q, const PlainModes& m, const Choices& c) {
    return c.sticking ? c.sticking(q) : modulus(m.V[m.j]) / (m.mu * modulus(m.Y_jj));
}

// The response of one mass to a force on another, of a chain that is cut out of the system between two of its masses, counted
// from 0, the second left out; by modes as if damping did not couple them.
Phasor response_of_part(const ProtocolQuestion& q, const PlainSystem& s, Index from, Index to, Index load, Index mass,
                        bool by_modes) {
    const Index n = to - from;
    const auto part = [&](const PlainMatrix& A) -> PlainMatrix { return A.block(from, from, n, n); };
    PlainMatrix C = part(s.C);
    if (by_modes) {
        const PlainMatrix phi = shapes_of(springs_of(q.stiffness_ratios, from, to), part(s.M)).phi;
        C = damping_in_modes(part(s.M) * phi, (phi.transpose() * C * phi).diagonal());
    }
    return solved(part(s.dynamic_stiffness()), s.r * C, PlainVector::Unit(n, load), PlainVector::Zero(n))[mass];
}

// The instant and the displacement of a mass where that is largest in size over the half-period: the contact turns there, the
// others too.
std::pair<double, double> largest_displacement(const PlainModes& m, const Choices& c, Index k) {
    if (k == m.j) return {0, turn_of(m, k).root - m.beta * m.G[k]};
    const int steps = plain_steps(m);
    std::pair<double, double> best{0, 0};
    const auto take = [&](double tau) {
        const double x = plain_motion(m, c, k, tau).x;
        if (std::isnan(x) || std::abs(x) > std::abs(best.second)) best = {tau, x};
    };
    const auto velocity = [&](double tau) { return plain_motion(m, c, k, tau).v; };
    take(0);
    double before = velocity(0);
    for (int n = 1; n <= steps; ++n) {
        const double from = (n - 1) * pi / steps, to = n == steps ? pi * (1 - 1e-15) : n * pi / steps;
        const double after = velocity(to);
        if (before * after < 0) take(zero_between(velocity, from, to));
        before = after;
    }
    take(pi * (1 - 1e-15));
    return best;
}

double phase_of_mass(const PlainModes& m, const Choices& c, Index k) {
    if (k == m.j) return plain_phase(m, c);
    const auto [tau, x] = largest_displacement(m, c, k);
    return plain_phase(m, c) + tau + (x < 0 && !c.no_half_period_for_minima ? pi : 0);
}

// (50), (51): the parts of the monoharmonic response; by (49) they are those of the start.
PlainMotion monoharmonic(const PlainModes& m, const Choices& c, Index k) {
    PlainMotion parts = plain_start(m, c, k);
    if (!c.cosine_as_printed) return parts;
    const auto [cosine, sine, root, drag] = turn_of(m, k);
    parts.x = root * cosine + drag * sine / elementary::hypot(cosine, sine) - m.beta * m.G[k];
    return parts;
}

double monoharmonic_amplitude(const PlainModes& m, const Choices& c, Index k) {
    const PlainMotion parts = monoharmonic(m, c, k);
    if (!c.monoharmonic_as_printed) return elementary::hypot(parts.x, parts.v); // (52)
    const auto [cosine, sine, root, drag] = turn_of(m, k);
    const double V = modulus(m.V[k]), G = m.beta * m.G[k], U = m.beta * m.U[k];
    return std::sqrt(V * V + G * G + U * U - 2 * (root * (G * cosine + U * sine) + drag * (G * sine + U * cosine)));
}

bool slides(const PlainModes& m, const Choices& c) {
    if (c.beyond_the_boundary || c.harmonics > 0) return true;
    const double V = modulus(m.V[m.j]), root = std::sqrt(V * V - m.beta * m.U[m.j] * (m.beta * m.U[m.j]));
    if (!(root > m.beta * (m.H_j + m.mu * m.sum_of_squares))) return false; // (67), which costs no search
    return m.beta < plain_limit(m, {}, plain_demand(m, {}, false));
}

PlainVector row_of_mass(const ProtocolQuestion& q, const PlainSystem& s) {
    return q.mass == 0 ? s.w : place_of(q.mass, s.size());
}

// The answer that the last period of a motion shows, in a frame that moves by frame cos(tau).
std::optional<Value> read_off(const PlainContact& motion, const ProtocolQuestion& q, double frame = 0) {
    if (q.quantity == "stops_per_period") return Value{{static_cast<double>(motion.stops().size())}, ""};
    if (q.quantity == "stop_durations") return Value{motion.stops(), ""};
    if (q.quantity == "rest_interval") return std::nullopt;
    const PlainVector row = row_of_mass(q, motion.system);
    if (q.quantity == "motion_under_force") return Value{motion.samples(row, q.samples), ""};
    const auto [tau, x] = motion.largest(row, frame);
    return Value{{q.quantity == "amplitude" ? std::abs(x) : std::remainder(tau + (x < 0 ? pi : 0), 2 * pi)}, ""};
}

// The answer for a contact that rests permanently, under a force that holds it.
std::optional<Value> answer_of_stuck_motion(const ProtocolQuestion& q, const PlainSystem& s, const Phasors& held, double frame) {
    const double force = modulus(held[s.size()]), compliance = s.w.dot(solved(s.K, s.w));
    if (q.quantity == "rest_interval") return Value{{(s.mu * s.beta - force) * compliance}, ""};
    if (q.quantity == "stops_per_period") return Value{{0}, ""};
    if (q.quantity == "stop_durations") return Value{};
    const PlainVector row = row_of_mass(q, s);
    Phasor X(row.dot(held.head(s.size()).real()), row.dot(held.head(s.size()).imag()));
    double largest = force * compliance;
    for (const Phasor& x : held.head(s.size())) largest = std::max(largest, modulus(x));
    constexpr double rounding = 1e-14;
    if (row == s.w || modulus(X) <= rounding * largest) X = {0, 0};
    X += frame;
    if (q.quantity == "amplitude") return Value{{modulus(X)}, ""};
    if (q.quantity != "phase") return sampled(q, [&](double tau) { return times_cosine(X, tau); });
    return modulus(X) > 0 ? std::optional(Value{{-argument(X)}, ""}) : std::nullopt;
}

// The steady motion of a question's system; none if there is none of one period. Questions about one system come one after the
// other: the motion of the last one is kept.
const std::optional<PlainContact>& settled(const ProtocolQuestion& q) {
    thread_local std::optional<ProtocolQuestion> kept_for;
    thread_local std::optional<PlainContact> kept;
    ProtocolQuestion of_system = q;
    of_system.id = of_system.quantity = "";
    of_system.mass = of_system.samples = 0;
    of_system.tau = 0;
    if (kept_for != of_system) {
        kept_for = of_system;
        try {
            kept.emplace(q).settle();
        } catch (const NoPlainAnswer&) { // the same holds for the next question
            kept.reset();
        }
    }
    return kept;
}

// The answer for a contact that rests during a part of every period, or permanently.
std::optional<Value> answer_of_steady_motion(const ProtocolQuestion& q, double frame) {
    const PlainSystem s = plain_system(q);
    const Phasors held = held_response(s);
    const bool may_rest = s.mu * s.beta >= modulus(held[s.size()]);
    if (may_rest && s.mu <= 1) return answer_of_stuck_motion(q, s, held, frame);
    const std::optional<PlainContact>& motion = settled(q); // from rest the contact may never come to rest for good
    if (may_rest && (!motion || motion->rests())) return answer_of_stuck_motion(q, s, held, frame);
    return motion ? read_off(*motion, q, frame) : std::nullopt;
}

Value regime(const ProtocolQuestion& q, const PlainModes& m, const Choices& c) {
    if (c.beyond_the_boundary) return {{}, "continuous"};
    if (m.beta < plain_limit(m, c, plain_demand(m, c, false))) return {{}, "continuous"};
    return {{}, m.beta >= sticking_limit(q, m, c) ? "permanent_sticking" : "stick_slip"};
}

// Force that the load brings to the contact if inertia alone counts, over that of a unit force on the contact, which is the load
// of (86). Throws NoPlainAnswer if the load of a base or wall grows with the frequency.
double share_at_high_frequency(const ProtocolQuestion& q, const PlainSystem& s) {
    if (is_of_the_paper(q)) return 1;
    const bool damped = !s.C.rowwise().sum().isZero(0);
    if (q.base_motion == "wall" || (q.base_motion == "alone" && damped)) throw NoPlainAnswer();
    const PlainVector pull = solved(s.M, s.w);
    return modulus({pull.dot(s.p), pull.dot(s.p_i)}) / pull.dot(s.w);
}

// The numbers of the closed form.
std::vector<double> numbers_of(const ProtocolQuestion& q, const PlainModes& m, const Choices& c, Index k) {
    const std::string& name = q.quantity;
    if (name == "natural_frequency_ratios") return list_of(m.r_n);
    if (name == "modal_frequency_ratios") return list_of(m.R);
    if (name == "mode_shape_products") return list_of(m.psi.row(k).cwiseProduct(m.psi.row(m.j)));
    if (name == "complex_response") return {m.V[k].real(), m.V[k].imag()};
    if (name == "first_damping_function") return {m.U[k]};
    if (name == "second_damping_function") return {m.G[k]};
    if (name == "H_j") return {m.H_j};
    if (name == "S_j") return {plain_demand(m, c, false)};
    if (name == "beta_lim_exact" || name == "beta_lim_paper")
        return {plain_limit(m, c, plain_demand(m, c, name == "beta_lim_paper"))};
    if (name == "beta_lim_approximate") return {approximate_limit(m, c)};
    if (name == "beta_lim_sticking") return {sticking_limit(q, m, c)};
    if (name == "beta_lim_high_frequency") return {share_at_high_frequency(q, m) * 2 / elementary::hypot(2 * m.mu, pi)};
    if (name == "amplitude") {
        const double x = largest_displacement(m, c, k).second;
        return {k == m.j ? x : std::abs(x)};
    }
    if (name == "phase") return {wrapped_angle(phase_of_mass(m, c, k))};
    if (name == "amplitude_monoharmonic") return {monoharmonic_amplitude(m, c, k)};
    if (name == "phase_monoharmonic")
        return {wrapped_angle(plain_phase(m, c) + elementary::atan2(monoharmonic(m, c, k).v, monoharmonic(m, c, k).x))};
    if (name == "initial_displacement") return {plain_start(m, c, k).x};
    if (name == "initial_velocity") return {plain_start(m, c, k).v};
    if (name == "displacement") return {plain_motion(m, c, k, q.tau).x};
    if (name == "motion_under_force")
        return sampled(q, [&](double tau) { return plain_motion(m, c, k, tau - plain_phase(m, c)).x; }).numbers;
    return name == "stops_per_period" ? std::vector<double>{0} : std::vector<double>{};
}

// Adds a row: that of a mass in another frame, where its complex response function is V. The row.
Index add_row_in_frame(PlainModes& m, Index k, const Phasor& V) {
    const Index row = m.V.size();
    m.psi.conservativeResize(row + 1, Eigen::NoChange);
    m.psi.row(row) = m.psi.row(k);
    m.V = (Phasors(row + 1) << m.V, V).finished();
    m.U = (PlainVector(row + 1) << m.U, m.U[k]).finished();
    m.G = (PlainVector(row + 1) << m.G, m.G[k]).finished();
    return row;
}

// The answer to a question; of the motion in a frame that moves by frame cos(tau).
std::optional<Value> computed(const ProtocolQuestion& q, const Choices& c, double frame = 0) {
    PlainModes m = plain_modes(q, c);
    Index k = m.j;
    if (quantity(q.quantity).of_mass && (q.mass != 0 || q.contact_with == 0)) {
        if (q.mass < 1 || q.mass > m.size()) return std::nullopt;
        k = q.mass - 1;
    }
    if (frame != 0) {
        const bool as_given = frame == m.frame && q.loads.empty(); // else a mistake is made
        k = add_row_in_frame(m, k, as_given ? plain_response_from_ground(m)[k] : m.V[k] + frame);
    }
    if (m.coupled && asks_for(q, {"modal_frequency_ratios", "mode_shape_products"})) return std::nullopt;
    if (q.quantity == "regime") return regime(q, m, c);
    const bool of_motion =
        asks_for(q, {"amplitude", "phase", "motion_under_force", "stops_per_period", "stop_durations", "rest_interval"});
    if (of_motion && !slides(m, c)) return c.closed_form_alone ? std::nullopt : answer_of_steady_motion(q, frame);
    if (q.quantity == "rest_interval") return std::nullopt;
    return Value{numbers_of(q, m, c, k), ""};
}

// The answer about the motion that is seen from the ground, where the frame moves so many times as far as it does.
std::optional<Value> computed_from_ground(ProtocolQuestion q, double times_frame) {
    if (q.base_motion.empty()) throw NoPlainAnswer();
    const PlainSystem s = plain_system(q);
    const bool over_base = q.quantity == "transmissibility";
    q.quantity = q.quantity == "absolute_phase" ? "phase" : "amplitude";
    std::optional<Value> value = computed(q, {}, times_frame * s.frame);
    if (value && over_base) value->numbers.front() /= s.base;
    return value;
}

} // namespace

double plain_sticking_limit_by_88(const ProtocolQuestion& q, bool by_modes) {
    if (q.contact == q.load) return 1 / q.mu;
    const PlainSystem s = plain_system(q);
    const Index j = q.contact - 1, l = q.load - 1;
    // The masses on the load's side of the contact, and the spring between them and it.
    const Phasor x = l < j ? response_of_part(q, s, 0, j, l, j - 1, by_modes)
                           : response_of_part(q, s, j + 1, s.size(), l - j - 1, 0, by_modes);
    return q.stiffness_ratios[static_cast<std::size_t>(l < j ? j : j + 1)] * modulus(x) / q.mu;
}

double plain_sticking_limit_without_damping(const ProtocolQuestion& q) {
    const PlainSystem s = plain_system(q);
    const Phasors X = held_response(s).head(s.size());
    const PlainVector elastic = s.K * s.w;
    return modulus({elastic.dot(X.real()) - s.w.dot(s.p), elastic.dot(X.imag()) - s.w.dot(s.p_i)}) / q.mu;
}

double plain_demand(const PlainModes& m, const Choices& c, bool of_paper) {
    if (c.demand_at_start) return m.H_j + m.sum_of_squares;
    if (of_paper || c.maximum_of_each_mode) return sum_of_maxima(m, c);
    return largest(m, c, [&](double tau) { return plain_demand_at(m, tau, c.demand_as_printed); });
}

double plain_limit(const PlainModes& m, const Choices& c, double S) {
    const double by_S = limit_by(m, S);
    if (c.without_load_condition || (c.sliding_beyond_68 && limit_by(m, m.H_j - m.mu * m.sum_of_squares) < by_S)) return by_S;
    return c.load_of_each_mode ? std::min(by_S, approximate_limit(m, c)) : limit_by(m, std::max(S, demand_at_rest(m)));
}

std::optional<Value> where_finite(const std::function<std::optional<Value>()>& answer) {
    try {
        std::optional<Value> value = answer();
        if (!value || std::ranges::all_of(value->numbers, [](double x) { return std::isfinite(x); })) return value;
    } catch (const NoPlainAnswer&) { // there is none
    }
    return std::nullopt;
}

Value sampled(const ProtocolQuestion& q, const std::function<double(double tau)>& f) {
    Value value;
    for (int n = 0; n < q.samples; ++n) value.numbers.push_back(f(2 * pi * n / q.samples));
    return value;
}

double wrapped_angle(double angle) {
    const double reduced = std::remainder(angle, 2 * pi);
    return reduced <= -pi ? reduced + 2 * pi : reduced;
}

std::optional<Value> plain_answer(const ProtocolQuestion& q) {
    return where_finite([&] { return quantity(q.quantity).absolute ? computed_from_ground(q, 1) : computed(q, {}); });
}

std::optional<Value> plain_answer_in_frame(const ProtocolQuestion& q, double times_frame) {
    return where_finite([&] { return computed_from_ground(q, times_frame); });
}

std::optional<Value> plain_answer(const ProtocolQuestion& q, const Choices& c) {
    if (!is_of_the_paper(q) || quantity(q.quantity).absolute) return std::nullopt;
    return where_finite([&] { return computed(q, c); });
}

std::vector<std::optional<Value>> answers_of_transient(const ProtocolQuestion& q, int first, int last) {
    std::vector<std::optional<Value>> answers;
    PlainContact motion(q);
    for (int n = 1; n <= last; ++n) {
        motion.run();
        if (n >= first) answers.push_back(read_off(motion, q));
    }
    return answers;
}

std::optional<Value> answer_of_creep(const ProtocolQuestion& q, double width) {
    if (q.mass != q.contact || !is_of_the_paper(q)) return std::nullopt;
    const Phasor force = held_response(plain_system(q)).tail(1)[0];
    const double share = modulus(force) / q.beta;
    if (!(share < 1)) return std::nullopt;
    // The integral of the velocity from 0 to s, by the midpoint rule: the integrand is smooth and of period 2 pi.
    const auto path = [&](double s) {
        constexpr int steps = 2048;
        double sum = 0;
        for (int n = 0; n < steps; ++n) {
            const double x = share * elementary::cos(s * (n + 0.5) / steps);
            sum += elementary::log((1 + x) / (1 - x));
        }
        return width * sum * s / (2 * steps);
    };
    if (q.quantity == "amplitude") return Value{{std::abs(path(pi / 2))}, ""};
    if (q.quantity != "motion_under_force") return std::nullopt;
    return sampled(q, [&](double tau) { return path(std::remainder(tau + argument(force), 2 * pi)); });
}

} // namespace denhartog::conformance
