/* The closed form answers the questions of `denhartog conform` in the plain dialect. */
#include "closed_form.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static double wrapped(double angle) { return angle - 2 * pi * ceil((angle - pi) / (2 * pi)); } /* to (-pi, pi] */
static int keeps_rules(const Scene* s) {
    int good = s->N >= 1 && s->N <= MOST && s->j >= 0 && s->j < s->N && s->l >= 0 && s->l < s->N && s->mu >= 1 && s->r > 0;
    good = good && s->beta >= 0 && isfinite(s->mu + s->r + s->beta) && s->gamma[0] == 1 && s->kappa[0] == 1;
    for (int i = 0; good && i < s->N; ++i)
        good = s->gamma[i] > 0 && s->kappa[i] > 0 && s->zeta[i] >= 0 && isfinite(s->gamma[i] + s->kappa[i] + s->zeta[i]);
    return good;
}
/* The numbers of a quantity into x. Returns how many, or 0 where the closed form has none. */
static int answer(const Scene* s, const char* q, int k, int samples, double tau, double* x) { /* clang-format off */
    const int slides = s->regime == CONTINUOUS, held = s->regime == STICKING, moves = slides || held, bears = s->j == s->l;
    const Point start = motion(s, k, 0), at_tau = motion(s, k, tau);
    const Point most = moves && (!strcmp(q, "amplitude") || !strcmp(q, "phase")) ? amplitude(s, k) : start;
    const double phase = wrapped(most.tau), limit = 2 / hypot(2 * s->mu, pi); /* (86) */
    const double X_1 = hypot(start.x, start.slope), phase_1 = wrapped(s->phi_j + atan2(start.slope, start.x)); /* (52), (53) */
    double shape[MOST];
    for (int i = 0; i < s->N; ++i) shape[i] = s->phi[k][i] / s->r * s->phi[s->j][i] / s->r;
    for (int n = 0; n < samples; ++n) /* motion under the force */
        x[n] = held ? creal(s->X[k] * cexp(I * (2 * pi * n / samples))) : motion(s, k, 2 * pi * n / samples - s->phi_j).x;
    const struct { const char* name; int count; const double* from; } table[] = {
        {"natural_frequency_ratios", s->N, s->r_n}, {"modal_frequency_ratios", s->N, s->R}, {"mode_shape_products", s->N, shape},
        {"complex_response", 2, (const double*)&s->V[k]}, {"first_damping_function", 1, &s->U[k]}, {"H_j", 1, &s->H_j},
        {"second_damping_function", 1, &s->G[k]}, {"S_j", 1, &s->S_j}, {"amplitude", moves, &most.x},
        {"phase", moves && most.x > 0, &phase}, {"amplitude_monoharmonic", slides, &X_1},
        {"phase_monoharmonic", slides, &phase_1}, {"initial_displacement", slides, &start.x}, {"beta_lim_exact", 1, &s->exact},
        {"initial_velocity", slides, &start.slope}, {"displacement", slides, &at_tau.x}, {"beta_lim_paper", 1, &s->paper},
        {"beta_lim_approximate", 1, &s->approximate}, {"beta_lim_sticking", 1, &s->sticking}, {"rest_interval", held, &s->rest},
        {"beta_lim_high_frequency", bears, &limit}, {"motion_under_force", moves * samples, x}};
    for (size_t i = 0; i < sizeof table / sizeof *table; ++i)
        if (!strcmp(q, table[i].name)) return memmove(x, table[i].from, table[i].count * sizeof *x), table[i].count;
    return 0;
}
int main(void) {
    static const char* const regimes[] = {"continuous", "stick_slip", "permanent_sticking"};
    static char line[1 << 16], id[1 << 16], q[1 << 16];
    static Scene s; static double x[1 << 14], tau; /* no answer is longer */
    if (!fgets(line, sizeof line, stdin)) return 1;
    for (puts("denhartog-conform 1 plain closed form in C"); fflush(stdout), fgets(line, sizeof line, stdin); puts("")) {
        int k, samples, count = 0, finite = 1, end = 0;
        sscanf(line, "%s%s%d%d%d%d%d%lf%lf%lf%lf%n", id, q, &s.N, &s.j, &s.l, &k, &samples, &tau, &s.mu, &s.r, &s.beta, &end);
        double* const ratios[] = {s.gamma, s.kappa, s.zeta};
        char* p = line + end;
        for (int i = 0; s.N <= MOST && i / 3 < s.N; ++i) ratios[i / s.N][i % s.N] = *p == ' ' ? strtod(p, &p) : -1;
        --s.j, --s.l;
        const int good = end > 0 && *p == '\n' && keeps_rules(&s) && k >= 0 && k <= s.N && samples >= 0 && samples <= 1 << 14;
        if (good) solve_scene(&s), count = answer(&s, q, k > 0 ? k - 1 : 0, samples, tau, x);
        for (int i = 0; i < count; ++i) finite = finite && isfinite(x[i]);
        if (end > 0 && strpbrk(line + end, "_l")) printf("%s skip not a scene of the paper", id); /* contact_with, loads, ... */
        else if (!good) printf("%s reject a ratio, a mass or mu, r, beta breaks its rule", id);
        else if (!strcmp(q, "regime") && s.regime != AT_A_POLE) printf("%s value %s", id, regimes[s.regime]);
        else printf("%s %s", id, count > 0 && finite ? "value" : "skip the closed form has no number here");
        for (int i = 0; i < count && finite; ++i) printf(" %.17g", x[i]);
    }
}
