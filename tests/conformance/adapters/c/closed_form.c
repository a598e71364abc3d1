#include "closed_form.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

int keeps_rules(const Scene* s) {
    int good = s->N >= 1 && s->N <= MOST && s->j >= 0 && s->j < s->N && s->l >= 0 && s->l < s->N && s->mu >= 1 && s->r > 0;
    good = good && s->beta >= 0 && isfinite(s->mu + s->r + s->beta) && s->gamma[0] == 1 && s->kappa[0] == 1;
    for (int i = 0; good && i < s->N; ++i)
        good = s->gamma[i] > 0 && s->kappa[i] > 0 && s->zeta[i] >= 0 && isfinite(s->gamma[i] + s->kappa[i] + s->zeta[i]);
    return good;
}

/* K = F^T F, where F takes displacements to the roots of the springs' energies. Jacobi's rotations Q make the columns of
   F gamma^(-1/2) orthogonal: their lengths are the natural frequency ratios and gamma^(-1/2) Q the mode shapes (15). */
static void modes(Scene* s) {
    double F[MOST][MOST] = {{0}}, Q[MOST][MOST] = {{0}}, length[MOST] = {0}; /* [column][row] */
    for (int i = 0; i < s->N; ++i) {
        Q[i][i] = 1, F[i][i] = sqrt(s->kappa[i] / s->gamma[i]);
        if (i > 0) F[i - 1][i] = -sqrt(s->kappa[i] / s->gamma[i - 1]);
    }
    for (int sweep = 0; sweep < 40; ++sweep)
        for (int i = 0; i < s->N; ++i)
            for (int k = i + 1; k < s->N; ++k) {
                double a = 0, b = 0, c = 0;
                for (int m = 0; m < s->N; ++m) a += F[i][m] * F[i][m], b += F[k][m] * F[k][m], c += F[i][m] * F[k][m];
                if (fabs(c) <= 1e-17 * sqrt(a) * sqrt(b)) continue;
                const double t = 2 * c / (b - a + copysign(hypot(b - a, 2 * c), b - a)), cosine = 1 / hypot(1, t);
                for (int m = 0; m < s->N; ++m) {
                    const double f = F[i][m], q = Q[i][m];
                    F[i][m] = cosine * (f - t * F[k][m]), F[k][m] = cosine * (t * f + F[k][m]);
                    Q[i][m] = cosine * (q - t * Q[k][m]), Q[k][m] = cosine * (t * q + Q[k][m]);
                }
            }
    for (int i = 0; i < s->N; ++i)
        for (int m = 0; m < s->N; ++m) length[i] = hypot(length[i], F[i][m]);
    for (int i = 0; i < s->N; ++i) {
        int place = 0;
        for (int m = 0; m < s->N; ++m) place += length[m] < length[i] || (length[m] == length[i] && m < i);
        s->r_n[place] = length[i];
        for (int k = 0; k < s->N; ++k) s->phi[k][place] = Q[i][k] / sqrt(s->gamma[k]);
    }
}

static double complex complex_response(double R, double zeta) { /* (23), divided so that no square overflows */
    const double a = (1 - R) * (1 + R), b = 2 * zeta * R;
    return fabs(a) >= b ? (1 - I * (b / a)) / (a + b * (b / a)) : (a / b - I) / (b + a * (a / b));
}

/* 1 - d, q (A.8) and R q' (A.9) of a mode at x = tau / R; from zeta = 1 on by its two rates of decay a and 1 / a. */
static void free_motion(double x, double zeta, double* one_less_d, double* q, double* R_q_prime) {
    if (zeta < 1) {
        const double w = sqrt((1 - zeta) * (1 + zeta)), E = exp(-zeta * x), half = sin(w * x / 2);
        *q = E * sin(w * x) / w, *R_q_prime = E * cos(w * x) - zeta * *q;
        *one_less_d = -expm1(-zeta * x) + 2 * E * half * half - zeta * *q;
    } else {
        const double w_1 = sqrt(zeta - 1) * sqrt(zeta + 1), a = 1 / (zeta + w_1);
        *q = exp(-a * x) * (w_1 > 0 ? -expm1(-2 * w_1 * x) / (2 * w_1) : x), *R_q_prime = exp(-(zeta + w_1) * x) - a * *q;
        *one_less_d = -expm1(-a * x) - a * *q;
    }
}

/* [sinh(delta) / delta - sin(theta) / theta] / x^2 of (29), x = pi / R, which cancels at large R: the sum over n >= 1 of
   D_n / (2n+1)!, D_n = (X^n - Y^n) / (X - Y), X = delta^2, Y = -theta^2 (for zeta > 1 it is positive). */
static double bracket(double x, double zeta) {
    const double X = x * zeta * (x * zeta), Y = (zeta - 1) * x * ((zeta + 1) * x);
    double sum = 0, term = 1.0 / 6, power = Y / 6;
    for (int n = 1; n < 40; ++n, power *= Y / (2 * n * (2 * n + 1.0))) {
        sum += term;
        term = (X * term + power) / ((2 * n + 2) * (2 * n + 3.0));
    }
    return sum;
}

/* u (28), g (29). Both are scaled by E = exp(-delta), so that nothing overflows at small R, and cosh(delta) + cos(theta) is a sum
   of squares, so that nothing cancels where it is nearly zero, with c = cos(theta / 2): 2 E (...) = (1 - E)^2 + 4 E c^2. */
static void damping_functions(double R, double zeta, double* u, double* g) {
    const double x = pi / R, delta = zeta * x, E = exp(-delta), F = -expm1(-delta);
    if (zeta < 1) {
        const double w = sqrt((1 - zeta) * (1 + zeta)), y = zeta * zeta / (1 + w) / (2 * R); /* (1 - w) / (2 R) */
        double si = sin(pi * (w / (2 * R))), c = cos(pi * (w / (2 * R)));
        if (zeta < 0.5) { /* theta / 2 = pi / (2 R) - pi y: its quarter turns are taken off exactly, before pi comes in */
            int quarters;
            const double rest = remquo(1, R, &quarters), angle = pi * (rest / (2 * R) - y), sign = quarters & 2 ? -1 : 1;
            si = sign * (quarters & 1 ? cos(angle) : sin(angle)), c = sign * (quarters & 1 ? -sin(angle) : cos(angle));
        }
        const double D = F * F + 4 * E * c * c;
        *u = 4 * E * si * c / (R * w * D);
        *g = R < 1.25 ? (F * (1 + E) - 4 * E * (zeta / w) * si * c) / D : 2 * E * delta * x * x * bracket(x, zeta) / D;
    } else { /* cos(theta) and sin(theta) / w with w imaginary */
        const double w_1 = sqrt(zeta - 1) * sqrt(zeta + 1), b = zeta + w_1, a = 1 / b, D = (1 + exp(-a * x)) * (1 + exp(-b * x));
        double one_less_d, q, rate;
        free_motion(x, zeta, &one_less_d, &q, &rate);
        *u = 2 * q / R / D, *g = (F * (1 + E) - 2 * zeta * q) / D;
        if (delta <= 4)
            *g = 2 * E * delta * x * x * bracket(x, zeta) / D;
        else if (w_1 * x > 1 && a * x < 3)
            *g = (b * tanh(a * x / 2) - a * tanh(b * x / 2)) / (2 * w_1);
    }
}

static double s_i(double tau, double R, double zeta, double u, double g) { /* (57) as corrected; at 0 and pi its limits (71) */
    const double x = tau / R;
    double one_less_d, q, difference; /* R q' - cos tau */
    if (tau <= 0) return 1 + g + 2 * zeta * R * u;
    if (tau >= pi) return g + 2 * zeta * R * u - 1;
    if (tau > pi / 2 && zeta * pi / R < 1 && zeta < 1) return -s_i(pi - tau, R, -zeta, u, -g); /* from the end, backwards */
    free_motion(x, zeta, &one_less_d, &q, &difference);
    if (zeta < 1) { /* cos(w x) - cos(tau) as a product: near R = 1 it is small, and u large */
        const double w = sqrt((1 - zeta) * (1 + zeta)), w_x_less_tau = (1 - R - zeta * zeta / (1 + w)) * x;
        difference = expm1(-zeta * x) * cos(w * x) - 2 * sin((w * x + tau) / 2) * sin(w_x_less_tau / 2) - zeta * q;
    } else {
        const double b = zeta + sqrt(zeta - 1) * sqrt(zeta + 1), half = sin(tau / 2);
        difference = expm1(-b * x) - q / b + 2 * half * half;
    }
    return ((1 + g) * R * q - u * R * (R * difference)) / sin(tau);
}

static double sum_of_s(const Scene* s, int mode, double tau) { /* psi_ji^2 s_i, of one mode or summed over all (56) */
    double S = 0;
    for (int i = 0; i < s->N; ++i)
        if (mode == ALL_MODES || mode == i) S += pow(s->phi[s->j][i] / s->r, 2) * s_i(tau, s->R[i], s->zeta[i], s->u[i], s->g[i]);
    return S;
}

double displacement(const Scene* s, int k, double tau, double* velocity) {
    if (tau >= pi) { /* (25) */
        const double mirrored = displacement(s, k, tau - pi, velocity);
        return *velocity = -*velocity, -mirrored;
    }
    /* V_k exp i(tau + phi_j), where V_j exp(i phi_j) is root - i beta U_j (36), (37) */
    const double complex Z = s->V[k] / s->V[s->j] * (s->root - I * s->beta * s->U[s->j]) * cexp(I * tau);
    double x = creal(Z);
    *velocity = -cimag(Z);
    for (int i = 0; i < s->N; ++i) {
        const double weight = s->beta * s->phi[k][i] * s->phi[s->j][i] / s->r_n[i] / s->r_n[i]; /* beta psi_ki psi_ji R_i^2 */
        double one_less_d, q, R_q_prime;
        free_motion(tau / s->R[i], s->zeta[i], &one_less_d, &q, &R_q_prime);
        x += weight * (one_less_d - s->g[i] * (1 - one_less_d) - s->u[i] * s->R[i] * q);
        *velocity += weight * ((1 + s->g[i]) * q / s->R[i] - s->u[i] * R_q_prime);
    }
    return x;
}

static double size_of_x(const Scene* s, int k, double tau) {
    double velocity;
    return fabs(displacement(s, k, tau < pi ? tau : 0, &velocity));
}

/* Largest value over [0, pi]: samples, closer where the motions of modes start, then golden sections about every local one. */
static double maximum(double f(const Scene*, int, double), const Scene* s, int which, double* where) {
    const int samples = (int)fmin(50000, 200 + 30 / s->R[s->N - 1]);
    double best = -INFINITY, before = -INFINITY, value = f(s, which, 0), left = 0, t = 0;
    for (int n = 1; n <= samples + 1; ++n) {
        const double right = n < samples ? pi * pow((double)n / samples, 2) : pi;
        const double after = n > samples ? -INFINITY : f(s, which, right);
        if (value > best) best = value, *where = t;
        double a = left, c = right, step = c - a;
        while (value >= before && value >= after && step > fmin(1e-8, 1e-8 * s->R[s->N - 1])) {
            step *= 0.61803398874989485;
            const double f_left = f(s, which, c - step), f_right = f(s, which, a + step);
            if (fmax(f_left, f_right) > best) best = fmax(f_left, f_right), *where = f_left > f_right ? c - step : a + step;
            if (f_left > f_right)
                c = a + step;
            else
                a = c - step;
        }
        left = t, t = right, before = value, value = after;
    }
    return best;
}

double wrapped(double angle) { return angle - 2 * pi * ceil((angle - pi) / (2 * pi)); }

double amplitude(const Scene* s, int k, double* phase) {
    double t, velocity;
    *phase = s->regime == PERMANENT_STICKING ? wrapped(-carg(s->X_held[k])) : s->phi_j;
    if (s->regime == PERMANENT_STICKING) return cabs(s->X_held[k]);
    if (k == s->j) return s->X_j;
    maximum(size_of_x, s, k, &t);
    const double h = fmin(1e-3, 1e-2 * s->R[s->N - 1]);
    double a = fmax(0, t - h), b = fmin(pi * (1 - 1e-15), t + h); /* the instant more sharply: zero velocity */
    const double sign = displacement(s, k, t, &velocity) < 0 ? -1 : 1;
    for (int n = 0; n < 60; ++n) {
        displacement(s, k, t = (a + b) / 2, &velocity);
        if (sign * velocity > 0)
            a = t;
        else
            b = t;
    }
    *phase = wrapped(s->phi_j + t + (sign < 0) * pi);
    return fabs(displacement(s, k, t, &velocity));
}

double motion_under_force(const Scene* s, int k, double tau) {
    double velocity;
    if (s->regime == PERMANENT_STICKING) return creal(s->X_held[k] * cexp(I * tau));
    tau = fmod(tau - s->phi_j + 4 * pi, 2 * pi);
    return displacement(s, k, tau, &velocity);
}

/* The masses under the load while the contact is held, (K - r^2 M + i C) X = P by elimination, where the unknown at the contact
   is not X_j, which is zero, but the force that holds it (75), (88). Returns the size of that force. */
static double hold_contact(Scene* s) {
    double complex Z[MOST][MOST + 1] = {{0}}, z;
    for (int k = 0; k < s->N; ++k) {
        Z[k][k] += s->kappa[k] + (k + 1 < s->N ? s->kappa[k + 1] : 0) - s->gamma[k] * s->r * s->r;
        if (k > 0) Z[k][k - 1] -= s->kappa[k], Z[k - 1][k] -= s->kappa[k];
        for (int m = 0; m < s->N; ++m)
            for (int i = 0; i < s->N; ++i) /* (19) */
                Z[k][m] += I * 2 * s->zeta[i] * s->r_n[i] * s->r * s->gamma[k] * s->phi[k][i] * s->gamma[m] * s->phi[m][i];
    }
    for (int k = 0; k < s->N; ++k) Z[k][s->j] = k == s->j ? -1 : 0;
    Z[s->l][s->N] = 1;
    for (int c = 0; c < s->N; ++c) {
        int pivot = c;
        if (c == s->j) continue; /* the force is in row j alone */
        for (int k = c; k < s->N; ++k) pivot = k != s->j && cabs(Z[k][c]) > cabs(Z[pivot][c]) ? k : pivot;
        for (int m = 0; m <= s->N; ++m) z = Z[c][m], Z[c][m] = Z[pivot][m], Z[pivot][m] = z;
        for (int k = 0; k < s->N; ++k)
            for (int m = s->N; k != c && m >= c; --m) Z[k][m] -= Z[k][c] / Z[c][c] * Z[c][m];
    }
    for (int k = 0; k < s->N; ++k) s->X_held[k] = k == s->j ? 0 : Z[k][s->N] / Z[k][k];
    return cabs(Z[s->j][s->N] / Z[s->j][s->j]);
}

void solve_scene(Scene* s) {
    const int j = s->j;
    double t, S_paper = 0, softness = 0; /* of the springs from the ground to the contact */
    modes(s);
    s->H_j = 0;
    for (int i = 0; i < s->N; ++i) {
        s->R[i] = s->r / s->r_n[i];
        s->v[i] = complex_response(s->R[i], s->zeta[i]);
        damping_functions(s->R[i], s->zeta[i], &s->u[i], &s->g[i]);
        s->H_j += pow(s->phi[j][i] / s->r, 2) * (s->g[i] + 2 * s->zeta[i] * s->R[i] * s->u[i]);
        if (i <= j) softness += 1 / s->kappa[i];
    }
    for (int k = 0; k < s->N; ++k) {
        s->V[k] = s->U[k] = s->G[k] = 0;
        for (int i = 0; i < s->N; ++i) {
            const double weight = s->phi[k][i] / s->r_n[i] / s->r_n[i]; /* psi_ki psi_ji R_i^2 = phi_ki phi_ji / r_n,i^2 */
            s->V[k] += weight * s->phi[s->l][i] * s->v[i];
            s->U[k] += weight * s->phi[j][i] * s->u[i], s->G[k] += weight * s->phi[j][i] * s->g[i];
        }
    }
    s->S_j = maximum(sum_of_s, s, ALL_MODES, &t);
    for (int i = 0; i < s->N; ++i) S_paper += maximum(sum_of_s, s, i, &t);
    const double demand = s->H_j + s->mu / (s->gamma[j] * s->r * s->r), size = cabs(s->V[j]), load = hold_contact(s);
    s->exact = size / hypot(s->U[j], fmax(s->S_j, demand));
    s->paper = size / hypot(s->U[j], fmax(S_paper, demand));
    s->approximate = size / hypot(s->U[j], demand);
    s->sticking = load / s->mu;
    s->rest = (s->mu * s->beta - load) * softness;
    s->regime = s->beta < s->exact ? CONTINUOUS : s->beta >= s->sticking ? PERMANENT_STICKING : STICK_SLIP;
    s->root = sqrt((size - s->beta * fabs(s->U[j])) * (size + s->beta * fabs(s->U[j])));
    s->X_j = s->root - s->beta * s->G[j];
    s->phi_j = wrapped(atan2(-s->beta * s->U[j], s->root) - carg(s->V[j]));
}
