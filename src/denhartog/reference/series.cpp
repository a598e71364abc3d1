#include "denhartog/reference/series.hpp"

namespace denhartog::reference {

Series over_stretch(const Series& at_middle, const Ball& off, const Ball& constant, const Ball& size, const Ball& speed) {
    Series r;
    std::array<Ball, 6> held;
    held[0] = constant;
    mag_t most, rate; // bounds of a term, and of the speed
    mag_init(most);
    mag_init(rate);
    arb_get_mag(most, size.a);
    arb_get_mag(rate, speed.a);
    for (int n = 0; n < 6; ++n) {
        if (n > 0) mag_mul(most, most, rate);
        if (n > 1) mag_div_ui(most, most, static_cast<ulong>(n));
        arb_add_error_mag(held[n].a, most);
    }
    mag_clear(most);
    mag_clear(rate);
    r.c[4] = both_hold(at_middle.c[4] + 5 * off * held[5], held[4]);
    r.c[3] = both_hold(at_middle.c[3] + 4 * off * r.c[4], held[3]);
    r.c[2] = both_hold(at_middle.c[2] + 3 * off * r.c[3], held[2]);
    r.c[1] = both_hold(at_middle.c[1] + off * (2 * at_middle.c[2] + 3 * off * r.c[3]), held[1]);
    r.c[0] = both_hold(at_middle.c[0] + off * (at_middle.c[1] + off * (at_middle.c[2] + off * r.c[3])), held[0]);
    return r;
}

SineCosineSeries sine_cosine_series(const Series& x) {
    SineCosineSeries both;
    both.s.c[0] = sin(x.c[0]);
    both.c.c[0] = cos(x.c[0]);
    if (x.is_time()) { // every derivative is one of the two
        both.s.c = {both.s.c[0], both.c.c[0], -both.s.c[0] / 2, -both.c.c[0] / 6, both.s.c[0] / 24};
        both.c.c = {both.c.c[0], -both.s.c[0], -both.c.c[0] / 2, both.s.c[0] / 6, both.c.c[0] / 24};
        return both;
    }
    for (int n = 1; n < 5; ++n) {
        for (int k = 1; k <= n; ++k) {
            if (x.c[k].is_zero()) continue;
            both.s.c[n] += k * x.c[k] * both.c.c[n - k];
            both.c.c[n] -= k * x.c[k] * both.s.c[n - k];
        }
        both.s.c[n] = both.s.c[n] / n;
        both.c.c[n] = both.c.c[n] / n;
    }
    return both;
}

Series exp(const Series& x) {
    Series e;
    e.c[0] = exp(x.c[0]);
    for (int n = 1; n < 5; ++n) {
        for (int k = 1; k <= n; ++k)
            if (!x.c[k].is_zero()) e.c[n] += k * x.c[k] * e.c[n - k];
        e.c[n] = e.c[n] / n;
    }
    return e;
}

} // namespace denhartog::reference
