// A point of a scene in the bits of the moment. Read `point_in_balls`, whose damping is that of
// `scene_in_balls`. `with_enough_bits` doubles the bits until that is enough, and `WrittenNumbers` writes what is proved.
#include "denhartog/answer/reference_point.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog {

using namespace reference;

namespace {

// A scene with the nearest damping that each mode has by itself, (18). Whatever the modes of a cluster are, that of each
// is between the least and the largest eigenvalue of their block.
SceneInBalls by_themselves(SceneInBalls s, const ModesInBalls& m, BallMatrix D) {
    for (const ModeCluster& c : m.clusters) {
        const auto first = static_cast<slong>(c.first), last = static_cast<slong>(c.last);
        Ball all = D(first, first), squares(0);
        for (slong i = first; i < last; ++i) {
            all = either(all, D(i, i));
            for (slong k = first; k < last; ++k) {
                if (!(i == k ? D(i, i) - D(first, first) : D(i, k)).may_vanish()) throw Unproved(Why::modes_may_coincide);
                if (i != k) squares += D(i, k) * D(i, k);
            }
        }
        for (slong i = first; i < last; ++i) D(i, i) = widened(all, root_of_positive(squares));
    }
    for (slong i = 0; i < s.N(); ++i) s.zeta.push_back(D(i, i) * s.r * m.R[static_cast<std::size_t>(i)] / 2);
    return s;
}

// Rules of a scene that double may be too coarse to see broken.
void check_in_balls(const SceneInBalls& s) {
    if (s.mu < Ball(1)) throw InputError("mu", rule_of_mu, printed(s.mu, 40).decimal);
    for (const auto& [name, A] :
         {std::pair<const char*, const BallMatrix&>{"mass_matrix", s.M}, {"stiffness_matrix", s.K}, {"damping_matrix", s.C}})
        for (slong i = 0; i < A.rows(); ++i)
            for (slong k = 0; k < i; ++k)
                if (!arb_overlaps(A(i, k).a, A(k, i).a))
                    throw InputError(name, "must be symmetric",
                                     printed(A(i, k), 40).decimal + " and " + printed(A(k, i), 40).decimal);
}

// True of a damping matrix that couples the modes by less than a part.
bool hardly_couples(const BallMatrix& D, const Ball& part) {
    for (slong i = 0; i < D.rows(); ++i)
        for (slong k = 0; k < D.rows(); ++k)
            if (i != k && !(D(i, k) * D(i, k) <= part * part * D(i, i) * D(k, k))) return false;
    return true;
}

// True of a damping matrix so near to one that leaves the modes by themselves: the commutator is no more than a tolerance.
bool counts_as_modal(const ModesInBalls& m, const BallMatrix& D, double tolerance) {
    const Commutator c = commutator_of(m, D);
    const Ball most = Ball(tolerance) * Ball(tolerance) * c.size;
    if (!(c.apart <= most || c.apart > most)) throw Unproved({Why::coupling_may_count, 0});
    return c.apart <= most;
}

// (56) of the modes by themselves, where the coupling by a damping matrix makes no difference to (69) that anybody could measure.
std::optional<Ball> paper_limit_of_modes(const SceneInBalls& s, const Ball& exact) {
    const auto b = if_proved([&]() -> std::optional<Boundary<Ball>> {
                       ModesInBalls m = modes_in_balls(s);
                       const BallMatrix D = damping_of_modes(s, m);
                       if (!hardly_couples(D, Ball(hardly_coupled))) return std::nullopt;
                       const SceneInBalls apart = by_themselves(s, m, D);
                       m.zeta = apart.zeta;
                       if (!are_told_apart(m)) return std::nullopt;
                       return boundary_in_balls(apart, responses_of_modes(apart, std::move(m)));
                   }).value_or(std::nullopt);
    if (!b) return std::nullopt;
    const Ball change = abs(b->exact - exact), most = Ball(hardly_changed) * exact;
    if (change > most) return std::nullopt;
    if (!(change <= most)) throw Unproved({Why::coupling_may_count, 1});
    return b->paper;
}

// d.ddde+00, rounded to nearest.
std::string decimal_of(const Ball& x, int digits) {
    if (arf_is_zero(arb_midref(x.a)) != 0) return "0";
    mpfr_t exact;
    mpfr_init2(exact, std::max<slong>(arf_bits(arb_midref(x.a)), 2));
    arf_get_mpfr(exact, arb_midref(x.a), MPFR_RNDN);
    mpfr_exp_t exponent = 0;
    char* text = mpfr_get_str(nullptr, &exponent, 10, static_cast<std::size_t>(digits), exact, MPFR_RNDN);
    std::string all = text;
    mpfr_free_str(text);
    mpfr_clear(exact);
    const std::size_t first = all.front() == '-' ? 1 : 0;
    if (digits > 1) all.insert(first + 1, ".");
    const long power = exponent - 1;
    std::string exponent_in_words = std::to_string(std::abs(power));
    if (exponent_in_words.size() < 2) exponent_in_words.insert(0, "0");
    return all + (power < 0 ? "e-" : "e+") + exponent_in_words;
}

// Frees, at the end of a thread, the constants that Arb keeps for it.
struct ConstantsOfBalls {
    ~ConstantsOfBalls() { flint_cleanup(); }
};

} // namespace

Refusal with_enough_bits(const SceneSource& source, slong first, slong most,
                         const std::function<bool(const SceneSource& paid, slong bits, bool last)>& attempt) {
    const ScenePaidFor scene(source);
    thread_local const ConstantsOfBalls freed_at_its_end;
    const auto N = static_cast<slong>(number_of_masses(source->in_double().system));
    for (slong bits = first;; bits = std::min(2 * bits, most)) {
        const Tried<bool> enough = tried([&] {
            pay(scene.source()->effort, N * N * (N + 8) * (bits / 64) / 4);
            const Bits all(bits);
            bits_of_search = 64 * (bits / first);
            return attempt(scene.source(), bits, bits == most);
        });
        if (enough.is_answered() && *enough.value) return {};
        const bool disproved = enough.outcome == Outcome::disproved;
        if (!enough.is_answered() && !disproved && enough.outcome != Outcome::unproved) return enough;
        if (!disproved && bits != most) continue;
        return {Outcome::digits_missing,
                Why::not_proved + (enough.is_answered() ? Reasons(Why::bits_too_few, bits) : enough.why)};
    }
}

const StuckInBalls& required_stuck(const PointInBalls& p) {
    if (!p.stuck) throw Unproved(Why::may_resonate_held);
    return *p.stuck;
}

void require_sliding(const PointInBalls& p) {
    if (*p.scene.beta >= p.boundary->exact) throw Disproved(Why::does_not_slide);
    if (!(*p.scene.beta < p.boundary->exact)) throw Unproved({Why::may_be_boundary, 0});
}

BallMatrix damping_of_modes(const SceneInBalls& s, const ModesInBalls& m) {
    const BallMatrix Psi = shapes_of(m);
    return transposed(Psi) * s.C * Psi;
}

Commutator commutator_of(const ModesInBalls& m, const BallMatrix& D) {
    Ball apart(0), squares_of_K(0), squares_of_C(0);
    for (slong i = 0; i < D.rows(); ++i) {
        const auto k_i = [&](slong k) { return 1 / (m.R[static_cast<std::size_t>(k)] * m.R[static_cast<std::size_t>(k)]); };
        squares_of_K += k_i(i) * k_i(i);
        for (slong k = 0; k < D.rows(); ++k) {
            squares_of_C += D(i, k) * D(i, k);
            const Ball part = (k_i(i) - k_i(k)) * D(i, k);
            apart += part * part;
        }
    }
    return {apart, squares_of_K * squares_of_C};
}

SceneInBalls scene_as_given(const SceneSource& source) {
    Scene<Ball> scene;
    source->in_balls(scene);
    if (!scene.r) scene.r = Ball(1);
    SceneInBalls s = in_matrices(scene);
    s.kept = source->kept_modes;
    s.effort = source->effort;
    check_in_balls(s);
    return s;
}

SceneInBalls scene_in_balls(const SceneSource& source) {
    SceneInBalls s = scene_as_given(source);
    const double tolerance = source->in_double().system.damping_tolerance;
    if (s.zeta.empty() && tolerance > 0) {
        const ModesInBalls m = modes_in_balls(s);
        const BallMatrix D = damping_of_modes(s, m);
        if (!counts_as_modal(m, D, tolerance)) return with_load_of_base(std::move(s));
        s = by_themselves(s, m, D);
        s.C = BallMatrix();
    }
    return with_load_of_base(std::move(s));
}

SceneInBalls scene_at_one(const SceneSource& source) {
    SceneInBalls s = scene_in_balls(at_frequency(source, 1));
    if (s.base_motion == BaseMotion::none) return s;
    const SceneInBalls there = scene_in_balls(source);
    s.p = there.p;
    s.p_i = there.p_i;
    return s;
}

SceneInBalls damped_scene_in_balls(const SceneSource& source) {
    SceneInBalls s = scene_in_balls(source);
    if (!s.zeta.empty()) s.C = damping_matrix_in_balls(s, modes_in_balls(s));
    return s;
}

PointInBalls point_in_balls(const SceneSource& source, bool needs_boundary) {
    PointInBalls p{scene_in_balls(source)};
    ModesInBalls modes;
    if (!p.scene.zeta.empty()) {
        modes = modes_in_balls(p.scene);
        p.scene.C = damping_matrix_in_balls(p.scene, modes);
    }
    const bool modal = !p.scene.zeta.empty() && are_told_apart(modes);
    p.stuck = stuck_in_balls(p.scene);
    if (p.stuck) p.sticking = sticking_limit_in_balls(p.scene, *p.stuck);
    (void)if_proved(
        [&] {
            ResponsesInBalls r = modal ? responses_of_modes(p.scene, modes) : responses_of_state(p.scene);
            const Complex<Ball>& V_j = r.V[r.contact()];
            if (modal && !modes.clusters.empty() && V_j.re.may_vanish() && V_j.im.may_vanish())
                r = responses_of_state(p.scene); // where the load does not reach the contact it is zero, and not next to it
            r.modes = std::move(modes);
            const Complex<Ball>& V = r.V[r.contact()];
            if (!(V.re.finite() && V.im.finite())) throw Unproved(Why::may_resonate);
            p.boundary = boundary_in_balls(p.scene, r);
            if (p.scene.zeta.empty())
                p.boundary->paper = paper_limit_of_modes(p.scene, p.boundary->exact).value_or(p.boundary->paper);
            p.responses = std::move(r);
            return true;
        },
        needs_boundary);
    return p;
}

Certified printed(const Ball& x, int digits) {
    Certified number;
    number.proved = true;
    if (!x.finite()) {
        number.error = std::numeric_limits<double>::infinity();
        return number;
    }
    number.value = static_cast<double>(x);
    Ball written(0);
    if (digits > most_digits_of_a_double) {
        number.decimal = decimal_of(x, digits);
        const Bits enough(std::max<slong>(ball_bits, arf_bits(arb_midref(x.a)) + 64));
        written = Ball::of_text(number.decimal);
    } else {
        written = Ball(number.value);
    }
    number.error = abs(written - x).high();
    return number;
}

Certified WrittenNumbers::shown(const Ball& x) const {
    if (!x.finite()) throw Unproved(Why::no_bound);
    const Certified number = printed(x, digits_);
    if (!std::isfinite(number.value) && digits_ <= most_digits_of_a_double)
        throw PrecisionError({Why::out_of_double, 0}, Outcome::out_of_range);
    return number;
}

Certified WrittenNumbers::relative(const Ball& x) {
    count(x.is_zero() ? Ball(0) : radius_of(x) / abs(x));
    Certified number = shown(x);
    // Doubles are few next to zero; what is below them all is told by its bound.
    if (number.decimal.empty() && number.value != 0) count(Ball(number.error) / abs(x) / 2);
    return number;
}

SolvedMass WrittenNumbers::mass(const Ball& amplitude, const std::optional<Ball>& phase, bool asked, const Ball& largest) {
    Ball nothing = largest;
    arb_mul_2exp_si(nothing.a, nothing.a, -static_cast<slong>(bits_of_digit * digits_) - 32);
    if (amplitude.is_zero() || (last_ && amplitude.may_vanish() && amplitude <= nothing))
        return {shown(widened(Ball(0), upper_bound_of(amplitude))), std::nullopt, std::nullopt};
    SolvedMass out{relative(amplitude), std::nullopt, std::nullopt};
    if (phase) out.phase = asked ? absolute(*phase) : shown(*phase);
    return out;
}

void WrittenNumbers::count(const Ball& error) {
    const Ball tolerance = 1 / Ball::of_text("4e" + std::to_string(digits_));
    enough_ = enough_ && error.finite() && error < tolerance;
    largest_ = std::max(largest_, error.finite() ? error.high() : std::numeric_limits<double>::infinity());
}

} // namespace denhartog
