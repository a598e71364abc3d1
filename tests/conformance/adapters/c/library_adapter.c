/* The library answers the questions of `denhartog conform` in the plain dialect, through denhartog.h. */
#include <denhartog.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double x[1 << 20], work[1 << 20]; /* answers of up to that many numbers */
static const char* const regimes[] = {"continuous", "stick_slip", "permanent_sticking"};

static double number(void) { /* the next word of the question */
    const char* word = strtok(NULL, " \n");
    return word ? strtod(word, NULL) : -1;
}

static size_t count(void) { /* the next word, 0 where it is below */
    const double word = number();
    return word > 0 ? (size_t)word : 0;
}

static int ascending(const void* a, const void* b) { return (*(double*)a > *(double*)b) - (*(double*)a < *(double*)b); }

/* The numbers of a quantity into x, how many into n: -1 where there are none, -2 for a quantity not known. Returns a status. */
static int answer(const dh_system* s, const char* q, size_t k, size_t samples, double tau, double mu, double r, double beta,
                  int* n) {
    dh_boundary b = {.size = sizeof b};
    dh_sliding_mass slide = {.size = sizeof slide};
    dh_summary all = {.size = sizeof all};
    dh_mass mass = {.size = sizeof mass};
    dh_solution* solution;
    size_t N, j;
    dh_system_masses(s, &N, &j, NULL);
    double *V = work, *U = V + 2 * N, *G = U + N, *H = G + N, *S = H + 1;
    int status = DH_OK;
    *n = (int)N;
    if (!strcmp(q, "natural_frequency_ratios")) return dh_natural_frequency_ratios(s, N, x, NULL);
    if (!strcmp(q, "modal_frequency_ratios")) return dh_modal_functions(s, r, N, x, NULL, NULL, NULL);
    if (!strcmp(q, "mode_shape_products")) {
        status = dh_mode_shapes(s, r, N * N, work);
        for (size_t i = 0; i < N; ++i) x[i] = work[(k - 1) * N + i] * work[(j - 1) * N + i];
        return status;
    }
    *n = 1;
    if (!strcmp(q, "beta_lim_high_frequency")) return dh_high_frequency_limit(s, mu, x);
    if (!strcmp(q, "displacement")) return dh_displacement(s, r, beta, mu, k, 1, &tau, x);
    if (strstr(q, "beta_lim_")) {
        status = dh_boundaries(s, r, mu, &b);
        *x = q[9] == 'e' ? b.exact : q[9] == 'p' ? b.paper : q[9] == 'a' ? b.approximate : b.sticking;
        *n = q[9] == 's' && !b.sticking_exists ? -1 : 1;
    } else if (strstr(q, "complex_") || strstr(q, "damping") || !strcmp(q, "H_j") || !strcmp(q, "S_j")) {
        status = dh_sums(s, r, N, V, U, G, H, *q == 'S' ? S : NULL);
        x[0] = *q == 'c' ? V[2 * k - 2] : *q == 'f' ? U[k - 1] : *q == 's' ? G[k - 1] : *q == 'H' ? *H : *S;
        x[1] = V[2 * k - 1], *n = *q == 'c' ? 2 : 1;
    } else if (strstr(q, "initial_") || strstr(q, "_monoharmonic")) {
        status = dh_sliding_motion(s, r, beta, mu, k, &slide);
        x[0] = strstr(q, "initial_d")   ? slide.initial_displacement
               : strstr(q, "initial_v") ? slide.initial_velocity
               : *q == 'a'              ? slide.amplitude_monoharmonic
                                        : slide.phase_monoharmonic;
    } else if ((status = dh_solve(s, r, beta, mu, 12, &solution)) == DH_OK) {
        status = dh_solution_summary(solution, &all);
        *n = -2;
        if (!strcmp(q, "regime")) x[0] = all.regime, *n = 1;
        if (!strcmp(q, "amplitude")) status = dh_solution_mass(solution, k, &mass), x[0] = mass.amplitude, *n = 1;
        if (!strcmp(q, "phase")) status = dh_solution_mass(solution, k, &mass), x[0] = mass.phase, *n = mass.moves ? 1 : -1;
        if (!strcmp(q, "stops_per_period")) x[0] = (double)all.stops / all.periods, *n = 1;
        if (!strcmp(q, "rest_interval")) x[0] = all.rest_to, *n = all.rest_interval_exists ? 1 : -1;
        if (!strcmp(q, "stop_durations")) {
            status = dh_solution_stops(solution, *n = (int)all.stops, work, work + all.stops);
            for (size_t i = 0; i < all.stops; ++i) x[i] = work[all.stops + i] - work[i];
            qsort(x, all.stops, sizeof *x, ascending);
        }
        if (!strcmp(q, "motion_under_force")) {
            status = dh_solution_motion(solution, samples, samples * N, work, NULL);
            for (size_t i = 0; i < samples; ++i) x[i] = work[i * N + k - 1];
            *n = all.periods == 1 ? (int)samples : -1;
        }
        dh_solution_destroy(solution);
    }
    return status;
}

int main(void) {
    static char line[1 << 16];
    double ratios[3][64];
    if (!fgets(line, sizeof line, stdin)) return 1;
    for (puts("denhartog-conform 1 plain the library"); fflush(stdout), fgets(line, sizeof line, stdin);) {
        const char *id = strtok(line, " \n"), *q = strtok(NULL, " \n");
        const size_t N = count(), j = count(), l = count(), k = count(), samples = count();
        const double tau = number(), mu = number(), r = number(), beta = number();
        dh_system* s = NULL;
        int n = 0;
        for (size_t i = 0; N <= 64 && i < 3 * N; ++i) ratios[i / N][i % N] = number();
        const int rules = k <= N && mu >= 1 && r > 0 && beta >= 0 && isfinite(mu + r + beta);
        int status = !rules ? DH_ERROR_INPUT : N > 64 || samples > 1 << 14 ? DH_ERROR_MEMORY : DH_OK;
        if (status == DH_OK) status = dh_system_from_ratios(N, ratios[0], ratios[1], ratios[2], j, l, &s);
        if (status == DH_OK) status = answer(s, q, k ? k : 1, samples, tau, mu, r, beta, &n);
        if (status == DH_ERROR_INPUT || status == DH_ERROR_SIZE)
            printf("%s reject %s", id, dh_status_text(status));
        else if (status != DH_OK || n < 0)
            printf("%s skip %s", id, status ? dh_status_text(status) : "there is no such number here");
        else if (!strcmp(q, "regime"))
            printf("%s value %s", id, regimes[(int)x[0]]);
        else
            printf("%s value", id);
        for (int i = 0; status == DH_OK && i < n && strcmp(q, "regime"); ++i) printf(" %.17g", x[i]);
        puts("");
        dh_system_destroy(s);
    }
}
