// The functions of balls by Arb. Root, exponential, sine and cosine of the last argument are remembered, as formulas ask for
// them more than once.
#include "denhartog/number/ball.hpp"

namespace denhartog {
namespace {

template <class Function>
Ball by(Function function, const Ball& x) {
    Ball r;
    function(r.a, x.a, ball_bits);
    return r;
}

template <class Function>
Ball by(Function function, const Ball& x, const Ball& y) {
    Ball r;
    function(r.a, x.a, y.a, ball_bits);
    return r;
}

// The argument of the last call. Formulas ask for the exponential, the sine and the cosine of one argument several times.
struct LastArgument {
    Ball x{};
    slong bits = 0;
    bool is(const Ball& other) {
        if (bits == ball_bits && arb_equal(x.a, other.a) != 0) return true;
        x = other;
        bits = ball_bits;
        return false;
    }
};

template <void (*function)(arb_t, const arb_t, slong)>
const Ball& remembered(const Ball& x) {
    thread_local LastArgument last;
    thread_local Ball value;
    if (!last.is(x)) function(value.a, x.a, ball_bits);
    return value;
}

const SineCosine<Ball>& sine_cosine_of(const Ball& x) {
    thread_local LastArgument last;
    thread_local SineCosine<Ball> both;
    if (!last.is(x)) arb_sin_cos(both.s.a, both.c.a, x.a, ball_bits);
    return both;
}

double bound(void (*end)(arf_t, const arb_t, slong), const Ball& x, arf_rnd_t rounding) {
    arf_t t;
    arf_init(t);
    end(t, x.a, MAG_BITS + 60);
    const double d = arf_get_d(t, rounding);
    arf_clear(t);
    return d;
}

} // namespace

Ball PiOf<Ball>::value() {
    Ball r;
    arb_const_pi(r.a, ball_bits);
    return r;
}

Ball Ball::within(double from, double to) {
    Ball x;
    arf_t low, high;
    arf_init(low);
    arf_init(high);
    arf_set_d(low, from);
    arf_set_d(high, to);
    arb_set_interval_arf(x.a, low, high, ball_bits);
    arf_clear(low);
    arf_clear(high);
    return x;
}

Ball Ball::of_text(const std::string& text) {
    Ball x;
    if (arb_set_str(x.a, text.c_str(), ball_bits) != 0) arb_indeterminate(x.a);
    return x;
}

double Ball::low() const { return bound(arb_get_lbound_arf, *this, ARF_RND_FLOOR); }

double Ball::high() const { return bound(arb_get_ubound_arf, *this, ARF_RND_CEIL); }

Ball sqrt(const Ball& x) { return remembered<arb_sqrt>(x); }
Ball root_of_positive(const Ball& x) { return by(arb_sqrtpos, x); }

Ball exp(const Ball& x) { return remembered<arb_exp>(x); }
Ball sin(const Ball& x) { return sine_cosine_of(x).s; }
Ball cos(const Ball& x) { return sine_cosine_of(x).c; }

Ball sinh(const Ball& x) { return by(arb_sinh, x); }
Ball cosh(const Ball& x) { return by(arb_cosh, x); }

Ball atan2(const Ball& y, const Ball& x) {
    if (x < Ball(0) && y.may_vanish() && !y.is_zero()) return PiOf<Ball>::value() + by(arb_atan2, -y, -x);
    return by(arb_atan2, y, x);
}

Ball wrapped_in_balls(const Ball& angle) {
    if (!angle.finite()) return angle;
    constexpr double narrow = 1e-9; // a ball of more turns is known by its midpoint alone
    const Ball pi = PiOf<Ball>::value(), turns = (angle / pi - 1) / 2;
    Ball whole;
    arf_ceil(arb_midref(whole.a), arb_midref(turns.a));
    if (turns.radius() < narrow && !(turns > whole - 1)) whole -= 1; // -pi is taken to pi
    return angle - 2 * whole * pi;
}

Ball abs(const Ball& x) {
    Ball r;
    arb_abs(r.a, x.a);
    return r;
}

Ball larger(const Ball& x, const Ball& y) { return by(arb_max, x, y); }

Ball either(const Ball& x, const Ball& y) { return by(arb_union, x, y); }

Ball narrower(const Ball& x, const Ball& y) {
    return !y.finite() || (x.finite() && mag_cmp(arb_radref(x.a), arb_radref(y.a)) <= 0) ? x : y;
}

Ball power_of_two(slong n) {
    Ball r(1);
    arb_mul_2exp_si(r.a, r.a, n);
    return r;
}

Ball middle(const Ball& x) {
    Ball r;
    arb_get_mid_arb(r.a, x.a);
    return r;
}

Ball radius_of(const Ball& x) {
    Ball r;
    arb_get_rad_arb(r.a, x.a);
    return r;
}

Ball upper_bound_of(const Ball& x) {
    Ball r;
    arb_get_ubound_arf(arb_midref(r.a), x.a, ball_bits);
    return r;
}

Ball widened(Ball x, const Ball& radius) {
    arb_add_error(x.a, radius.a);
    return x;
}

} // namespace denhartog
