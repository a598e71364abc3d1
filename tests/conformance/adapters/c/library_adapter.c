/* The library answers the questions of `denhartog conform` in the plain dialect, through denhartog.h. */
#include <denhartog.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64, ROOM = 1 << 14 }; /* masses; numbers of an answer */

static double number(void) { /* the next word of the question */
    const char* word = strtok(NULL, " \n");
    return word ? strtod(word, NULL) : -1;
}

static size_t count(void) { /* the next word, 0 where it is below */
    const double word = number();
    return word > 0 ? (size_t)word : 0;
}

int main(void) {
    static const char* const regimes[] = {"continuous", "stick_slip", "permanent_sticking"};
    static char line[1 << 16];
    static double x[ROOM], ratios[3][MOST];
    if (!fgets(line, sizeof line, stdin)) return 1;
    for (puts("denhartog-conform 1 plain the library"); fflush(stdout), fgets(line, sizeof line, stdin);) {
        const char *id = strtok(line, " \n"), *quantity = strtok(NULL, " \n");
        const size_t N = count(), contact = count(), load = count(), mass = count(), samples = count();
        const double tau = number(), mu = number(), r = number(), beta = number();
        const int samples_matter = !strcmp(quantity, "motion_under_force"), word = !strcmp(quantity, "regime");
        int status = N > MOST || samples > ROOM ? DH_ERROR_MEMORY : DH_OK;
        dh_system* system = NULL;
        size_t n = 0;
        for (size_t i = 0; N <= MOST && i < 3 * N; ++i) ratios[i / N][i % N] = number();
        const char* more = strtok(NULL, " \n");
        const int of_paper = !more || !strpbrk(more, "_l"); /* contact_with, loads, base_motion, a matrix */
        if (more) status = DH_ERROR_SIZE;
        if (status == DH_OK) status = dh_system_from_ratios(N, ratios[0], ratios[1], ratios[2], contact, load, &system);
        if (status == DH_OK)
            status = dh_quantity(system, quantity, r, beta, mu, mass, tau, samples_matter ? samples : ROOM, x, &n);
        if (!of_paper)
            printf("%s skip not a scene of the paper", id);
        else if (status == DH_ERROR_INPUT || status == DH_ERROR_SIZE)
            printf("%s reject %s", id, system ? dh_last_message() : dh_status_text(status));
        else if (status != DH_OK)
            printf("%s skip %s", id, status == DH_ERROR_MEMORY ? dh_status_text(status) : dh_last_message());
        else if (word)
            printf("%s value %s", id, regimes[(int)x[0]]);
        else
            printf("%s value", id);
        for (size_t i = 0; status == DH_OK && !word && i < n; ++i) printf(" %.17g", x[i]);
        puts("");
        dh_system_destroy(system);
    }
}
