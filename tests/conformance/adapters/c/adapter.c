/* The closed form answers the questions of `denhartog conform` in the plain dialect. */
#include "closed_form.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double number(void) { /* the next word of the question */
    const char* word = strtok(NULL, " \n");
    return word ? strtod(word, NULL) : -1;
}

/* The numbers of a quantity into x. Returns how many, or 0 where the closed form has none. */
static int answer(const Scene* s, const char* q, int k, int samples, double tau, double* x) { /* clang-format off */
    double v_0, v, phase = 0, size = 0, x_0 = displacement(s, k, 0, &v_0), x_tau = displacement(s, k, tau, &v);
    const int slides = s->regime == CONTINUOUS, j = s->j, moves = s->regime != STICK_SLIP, bears = s->j == s->l;
    if (moves && (!strcmp(q, "amplitude") || !strcmp(q, "phase"))) size = amplitude(s, k, &phase);
    const struct { const char* name; int known; double value; } one[] = {
        {"H_j", 1, s->H_j}, {"S_j", 1, s->S_j}, {"first_damping_function", 1, s->U[k]}, {"second_damping_function", 1, s->G[k]},
        {"beta_lim_exact", 1, s->exact}, {"beta_lim_paper", 1, s->paper}, {"beta_lim_approximate", 1, s->approximate},
        {"beta_lim_sticking", 1, s->sticking}, {"beta_lim_high_frequency", bears, 1 / hypot(s->mu, acos(0))}, /* (86) */
        {"rest_interval", s->regime == PERMANENT_STICKING, s->rest}, {"amplitude", moves, size}, {"phase", size > 0, phase},
        {"initial_displacement", slides, x_0}, {"initial_velocity", slides, v_0}, {"displacement", slides, x_tau},
        {"amplitude_monoharmonic", slides, hypot(x_0, v_0)}, /* (52) */
        {"phase_monoharmonic", slides, wrapped(s->phi_j + atan2(v_0, x_0))}}; /* (53) */
    for (size_t i = 0; i < sizeof one / sizeof *one; ++i)
        if (!strcmp(q, one[i].name)) return x[0] = one[i].value, one[i].known;
    if (!strcmp(q, "complex_response")) return x[0] = creal(s->V[k]), x[1] = cimag(s->V[k]), 2;
    const int motion = !strcmp(q, "motion_under_force"), shapes = !strcmp(q, "mode_shape_products");
    const int natural = !strcmp(q, "natural_frequency_ratios"), modal = !strcmp(q, "modal_frequency_ratios");
    for (int n = 0; n < samples && motion; ++n) x[n] = motion_under_force(s, k, 4 * acos(0) * n / samples);
    for (int i = 0; i < s->N && !motion; ++i)
        x[i] = natural ? s->r_n[i] : modal ? s->R[i] : s->phi[k][i] / s->r * s->phi[j][i] / s->r;
    return motion ? moves * samples : natural || modal || shapes ? s->N : 0;
}

int main(void) {
    static char line[1 << 16];
    static double x[1 << 14], tau; /* no answer is longer */
    static Scene s;
    static const char* const regimes[] = {"continuous", "stick_slip", "permanent_sticking"};
    if (!fgets(line, sizeof line, stdin)) return 1;
    for (puts("denhartog-conform 1 plain closed form in C"); fflush(stdout), fgets(line, sizeof line, stdin);) {
        const char *id = strtok(line, " \n"), *q = strtok(NULL, " \n");
        s.N = (int)number(), s.j = (int)number() - 1, s.l = (int)number() - 1;
        int k = (int)number() - 1, samples = (int)number(), count = 0, finite = 1;
        tau = number(), s.mu = number(), s.r = number(), s.beta = number();
        double* const ratios[] = {s.gamma, s.kappa, s.zeta};
        for (int i = 0; s.N <= MOST && i < 3 * s.N; ++i) ratios[i / s.N][i % s.N] = number();
        const int good = keeps_rules(&s) && k >= -1 && k < s.N && samples >= 0 && samples <= 1 << 14;
        if (good) solve_scene(&s), count = answer(&s, q, k < 0 ? 0 : k, samples, tau, x);
        for (int i = 0; i < count; ++i) finite = finite && isfinite(x[i]);
        if (!good) printf("%s reject a ratio, a mass or mu, r, beta breaks its rule", id);
        else if (!strcmp(q, "regime")) printf("%s value %s", id, regimes[s.regime]);
        else printf("%s %s", id, count > 0 && finite ? "value" : "skip the closed form has no number here");
        for (int i = 0; i < count && finite; ++i) printf(" %.17g", x[i]);
        puts("");
    }
}
