#include "denhartog/reference/series.hpp"

namespace denhartog::reference {

SineCosineSeries sine_cosine_series(const Series& x) {
    SineCosineSeries both;
    both.s.c[0] = sin(x.c[0]);
    both.c.c[0] = cos(x.c[0]);
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
