// Power series of degree four in time, with bounds over a stretch: sine, cosine and the exponential of a series.
#include "denhartog/reference/series.hpp"

namespace denhartog::reference {

Series over_stretch(const Series& at_middle, const Ball& off, const Ball& constant, const Ball& size, const Ball& speed) {
    std::array<Ball, 6> most{size};
    for (int n = 1; n < 6; ++n) most[n] = most[n - 1] * speed / n;
    return over_stretch(at_middle, off, constant, most);
}

Series over_stretch(const Series& at_middle, const Ball& off, const Ball& constant, const std::array<Ball, 6>& most) {
    Series r;
    std::array<Ball, 6> held;
    for (int n = 0; n < 6; ++n) held[n] = widened(n == 0 ? constant : Ball(0), most[n]);
    r.c[4] = narrower(at_middle.c[4] + 5 * off * held[5], held[4]);
    r.c[3] = narrower(at_middle.c[3] + 4 * off * r.c[4], held[3]);
    r.c[2] = narrower(at_middle.c[2] + 3 * off * r.c[3], held[2]);
    r.c[1] = narrower(at_middle.c[1] + off * (2 * at_middle.c[2] + 3 * off * r.c[3]), held[1]);
    r.c[0] = narrower(at_middle.c[0] + off * (at_middle.c[1] + off * (at_middle.c[2] + off * r.c[3])), held[0]);
    return r;
}

SineCosineSeries sine_cosine_series(const Series& x) {
    SineCosineSeries both;
    const Ball s = both.s.c[0] = sin(x.c[0]), c = both.c.c[0] = cos(x.c[0]);
    if (x.is_time()) { // every derivative is one of the two
        both.s.c = {s, c, -s / 2, -c / 6, s / 24};
        both.c.c = {c, -s, -c / 2, s / 6, c / 24};
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
