#include "closed_form.h"
#include <math.h>
#include <stdlib.h>
static double dot(const double* x, const double* y, int N) { return N == 0 ? 0 : *x * *y + dot(x + 1, y + 1, N - 1); }
static int ascending(const void* a, const void* b) { return (*(double*)a > *(double*)b) - (*(double*)a < *(double*)b); }
/* K = B^T B with the stretched springs as rows of B: rotations make columns of B orthogonal, their lengths are r_n (15), (17). */
static void natural_modes(Scene* s) {
    double B[MOST][2 * MOST] = {{0}}; /* column by column; below each of B's stands that of the shapes */
    const int N = s->N;
    for (int i = 0; i < N; ++i) {
        B[i][i] = sqrt(s->kappa[i] / s->gamma[i]);
        B[i][i + 1] = i + 1 < N ? -sqrt(s->kappa[i + 1] / s->gamma[i]) : 0;
        B[i][N + i] = 1 / sqrt(s->gamma[i]);
    }
    for (int n = 0; n < 40 * N * N; ++n) {
        double *const p = B[n / N % N], *const q = B[n % N];
        const double pp = dot(p, p, N), qq = dot(q, q, N), pq = dot(p, q, N), h = (qq - pp) / (2 * pq);
        const double t = copysign(1, h) / (fabs(h) + hypot(1, h)), c = 1 / hypot(1, t);
        for (int m = 0; m < 2 * N && p < q && fabs(pq) > 1e-17 * sqrt(pp) * sqrt(qq); ++m) {
            const double p_m = p[m];
            p[m] = c * (p_m - t * q[m]);
            q[m] = c * (t * p_m + q[m]);
        }
    }
    for (int i = 0; i < N; ++i) B[i][0] = sqrt(dot(B[i], B[i], N));
    qsort(B, N, sizeof *B, ascending); /* by the first number of each column */
    for (int i = 0; i < N; ++i) {
        s->r_n[i] = B[i][0];
        for (int k = 0; k < N; ++k) s->phi[k][i] = B[i][N + k];
    }
}
typedef struct {
    double less_d, q, Rq_prime, difference; /* 1 - d, q, R q', R q' - cos tau */
} Free;
/* The free motion of a mode, (A.8), (A.9), without cancellation for tau -> 0 and R -> infinity. From zeta = 1 on it decays at two
   rates, a = zeta - w_1 and b = zeta + w_1 = 1 / a with w_1 = sqrt(zeta^2 - 1). */
static Free free_motion(double tau, double R, double zeta) {
    const double x = tau / R, w = sqrt(fabs(1 - zeta)) * sqrt(1 + zeta), b = zeta + w, a = zeta < 1 ? zeta : 1 / b;
    const double q = exp(-a * x) * (zeta < 1 ? sin(w * x) / w : w > 0 ? -expm1(-2 * w * x) / (2 * w) : x);
    const double fast = zeta < 1 ? exp(-zeta * x) * cos(w * x) : exp(-b * x);
    const double cosines = -2 * sin((w * x + tau) / 2) * sin(((1 - R) - zeta * zeta / (1 + w)) * x / 2); /* cos(w x) - cos(tau) */
    const double less_cos = zeta < 1 ? expm1(-zeta * x) * cos(w * x) + cosines : expm1(-b * x) + 2 * pow(sin(tau / 2), 2);
    const int early = fmax(1, 2 * zeta) * x < 1; /* there 1 - d by its power series: m'' + 2 zeta m' + m = 1 */
    double less_d = early ? 0 : zeta < 1 ? 1 - (fast + a * q) : -expm1(-a * x) - a * q;
    for (double k = 2, before = 0, term = x * x / 2, next; early && k < 22; ++k, before = term, term = next) {
        less_d += term;
        next = -(2 * zeta * x * k * term + x * x * before) / (k * (k + 1));
    }
    return (Free){less_d, q, fast - a * q, less_cos - a * q};
}
/* u (28), g (29), with D = 2 E (cosh delta + cos theta) as a sum of squares or a product: it is zero at a pole. */
static void damping_functions(double R, double zeta, double* u, double* g) {
    const double x = pi / R, delta = zeta * x, E = exp(-delta), F = -expm1(-delta);
    const double w = sqrt(fabs(1 - zeta)) * sqrt(1 + zeta), b = zeta + w, a = 1 / b;
    double q = free_motion(pi, R, zeta).q, cos_half = cos(w * x / 2); /* E sin(theta) / w, cos(theta / 2) */
    if (zeta < 0.5) { /* theta / 2 = pi / (2 R) - pi (1 - w) / (2 R): its quarter turns are taken off before pi comes in */
        int quarters;
        const double rest = remquo(1, R, &quarters), half = pi * (rest - zeta * zeta / (1 + w)) / (2 * R);
        q = E * sin(2 * half) / w * (quarters % 2 == 0 ? 1 : -1);
        cos_half = quarters % 2 == 0 ? cos(half) : sin(half); /* but for its sign */
    }
    const double D = zeta < 1 ? F * F + 4 * E * cos_half * cos_half : (1 + exp(-a * x)) * (1 + exp(-b * x));
    *u = 2 * q / (R * D);
    *g = zeta < 1 ? (F * (1 + E) - 2 * zeta * q) / D : tanh(a * x / 2) - a * R * *u;
    if (fmax(1, zeta) * x > 4) return;
    *g = 0; /* sinh(delta)/delta - sin(theta)/theta = sum of D_k x^2k/(2k+1)!, D_{k+1} = zeta^2 D_k + (-w^2)^k: nothing cancels */
    for (double n = 4, term = x * x / 6, power = term; n < 82; n += 2) {
        *g += 2 * E * delta * term / D;
        power *= (zeta - 1) * x * ((zeta + 1) * x) / (n * (n + 1));
        term = delta * delta * term / (n * (n + 1)) + power;
    }
}
/* Where f is largest, by steps from 0 to pi. Instants crowd at 0, as heavy damping is quick; the slope is bisected. */
static Point largest(Point f(const Scene*, int, double), const Scene* s, int which, int steps) {
    const double step = pi / s->samples;
    Point best = f(s, which, 0), before = best;
    for (int n = 0; n < 200 + steps; ++n) {
        const Point after = f(s, which, n < 200 ? 1e-9 * pow(step / 1e-9, n / 200.0) : step * (n - 199));
        Point a = before, b = after, middle = after;
        for (int i = 0; i < 60 && before.slope > 0 && !(after.slope > 0); ++i) {
            middle = f(s, which, (a.tau + b.tau) / 2);
            *(middle.slope > 0 ? &a : &b) = middle;
        }
        if (middle.x > best.x) best = middle;
        before = after;
    }
    return best;
}
/* Sum over modes, or one, of psi_ji^2 times (57) as corrected, 0 < tau < pi, or its limit (71) at 0; that at pi is less. */
static Point demand(const Scene* s, int which, double tau) {
    double N = 0, N_prime = 0; /* N: the sum times sin tau */
    for (int i = 0; i < s->N; ++i) {
        if (which != i && which != ALL_MODES) continue;
        const double psi_j_squared = pow(s->phi[s->j][i] / s->r, 2), R = s->R[i], u = s->u[i], one_g = 1 + s->g[i];
        const Free f = free_motion(tau, R, s->zeta[i]);
        N += psi_j_squared * (one_g * R * f.q - u * R * R * f.difference);
        N_prime += psi_j_squared * (one_g * f.Rq_prime + u * R * (2 * s->zeta[i] * f.Rq_prime + f.q - R * sin(tau)));
    }
    return tau > 0 ? (Point){N / sin(tau), N_prime * sin(tau) - N * cos(tau), tau} : (Point){N_prime, 0, 0};
}
Point motion(const Scene* s, int k, double time) {
    const double half = floor(time / pi), tau = fmax(0, time - half * pi), sign = fmod(half, 2) == 0 ? 1 : -1; /* (25) */
    double complex Z = s->W[k] * cexp(I * tau);                                                                /* x - i x' */
    for (int i = 0; i < s->N; ++i) {
        const double weight = s->beta * s->phi[k][i] * s->phi[s->j][i] / s->r_n[i] / s->r_n[i]; /* beta psi_ki psi_ji R_i^2 */
        const Free f = free_motion(tau, s->R[i], s->zeta[i]);
        Z += weight * (f.less_d - s->g[i] * (1 - f.less_d) - s->u[i] * s->R[i] * f.q);
        Z -= I * (weight * ((1 + s->g[i]) * f.q / s->R[i] - s->u[i] * f.Rq_prime));
    }
    return (Point){sign * creal(Z), -sign * cimag(Z), time};
}
static Point size_of(Point p) { return (Point){fabs(p.x), p.x * p.slope, p.tau}; }
static Point size_of_x(const Scene* s, int k, double tau) { return size_of(motion(s, k, tau)); }
Point amplitude(const Scene* s, int k) {
    if (s->regime == STICKING) return (Point){cabs(s->X[k]), 0, -carg(s->X[k])};
    const Point most = k == s->j ? motion(s, k, 0) : largest(size_of_x, s, k, s->samples); /* (38) */
    return (Point){fabs(most.x), 0, s->phi_j + most.tau + (motion(s, k, most.tau).x < 0) * pi};
}
/* Contact held, (88): (K - r^2 M + i C) X = P by elimination, the unknown at the contact being the force that holds it (75). */
static void hold_contact(Scene* s) {
    double complex Z[MOST][MOST + 1] = {{0}}, z;
    const int N = s->N, j = s->j;
    for (int k = 0; k < N; ++k)
        for (int n = 0; n < N; ++n) {
            Z[k][n] = k == n ? s->kappa[k] + (k + 1 < N ? s->kappa[k + 1] : 0) - s->r * s->r * s->gamma[k] : 0;
            if (abs(k - n) == 1) Z[k][n] = -s->kappa[k > n ? k : n];
            for (int i = 0; i < N; ++i) /* (19) */
                Z[k][n] += I * (2 * s->zeta[i] * s->r_n[i] * s->r * s->gamma[k] * s->phi[k][i] * s->gamma[n] * s->phi[n][i]);
        }
    for (int k = 0; k < N; ++k) Z[k][j] = -(k == j);
    Z[s->l][N] = 1;
    for (int c = 0; c < N; ++c) {
        int pivot = c;
        if (c == j) continue; /* the force is in row j alone */
        for (int k = c; k < N; ++k) pivot = k != j && cabs(Z[k][c]) > cabs(Z[pivot][c]) ? k : pivot;
        for (int n = 0; n <= N; ++n) z = Z[c][n], Z[c][n] = Z[pivot][n], Z[pivot][n] = z;
        for (int k = 0; k < N; ++k)
            for (int n = N; k != c && n >= c; --n) Z[k][n] -= Z[k][c] / Z[c][c] * Z[c][n];
    }
    for (int k = 0; k < N; ++k) s->X[k] = k == j ? 0 : Z[k][N] / Z[k][k];
    s->sticking = cabs(Z[j][N]) / s->mu;
    for (int k = 0; k <= j; ++k) s->rest += s->mu * (s->beta - s->sticking) / s->kappa[k];
}
void solve_scene(Scene* s) {
    const int j = s->j;
    double S_paper = 0;
    natural_modes(s);
    for (int k = 0; k < s->N; ++k) s->V[k] = s->U[k] = s->G[k] = s->H_j = s->rest = 0;
    for (int i = 0; i < s->N; ++i) {
        const double R = s->R[i] = s->r / s->r_n[i];
        const double complex v = 1 / ((1 - R) * (1 + R) + I * (2 * s->zeta[i] * R)); /* (23) */
        damping_functions(R, s->zeta[i], &s->u[i], &s->g[i]);
        s->H_j += pow(s->phi[j][i] / s->r, 2) * (s->g[i] + 2 * s->zeta[i] * R * s->u[i]);
        for (int k = 0; k < s->N; ++k) {
            const double weight = s->phi[k][i] / s->r_n[i] / s->r_n[i]; /* psi_k psi_j R^2 = phi_k phi_j / r_n^2 */
            s->V[k] += weight * s->phi[s->l][i] * v;
            s->U[k] += weight * s->phi[j][i] * s->u[i];
            s->G[k] += weight * s->phi[j][i] * s->g[i];
        }
    }
    s->samples = 64 * (int)fmin(4096, ceil(2 + s->r_n[s->N - 1] / s->r)); /* the fastest mode turns w / (2 R) times */
    s->S_j = largest(demand, s, ALL_MODES, s->samples - 1).x;
    for (int i = 0; i < s->N; ++i) S_paper += largest(demand, s, i, s->samples - 1).x; /* (56): the modes' own maxima */
    hold_contact(s);
    const double least = s->H_j + s->mu / (s->gamma[j] * s->r * s->r), V_j = cabs(s->V[j]), bU = s->beta * s->U[j];
    s->exact = V_j / hypot(s->U[j], fmax(s->S_j, least));
    s->paper = V_j / hypot(s->U[j], fmax(S_paper, least));
    s->approximate = V_j / hypot(s->U[j], least);
    s->regime = isnan(s->exact) ? AT_A_POLE : s->beta < s->exact ? CONTINUOUS : s->beta >= s->sticking ? STICKING : STICK_SLIP;
    const double complex W_j = sqrt((V_j - bU) * (V_j + bU)) - I * bU; /* (36), (37) */
    s->phi_j = carg(W_j) - carg(s->V[j]);
    for (int k = 0; k < s->N; ++k) s->W[k] = k == j ? W_j : s->V[k] * (W_j / s->V[j]);
}
