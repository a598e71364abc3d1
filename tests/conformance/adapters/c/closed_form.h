/* The steady motion of a chain with one Coulomb contact, where it slides throughout or rests for ever, in closed form: Marino and
   Cicirello, JSV 535 (2022) 117085. Numbers in brackets are its equations, with the corrections in the ledger of denhartog.
   Modes with zeta >= 1, which the paper leaves out, obey them with w = i w_1: all stays real. j, k, l count from 0 here. */
#include <complex.h>
static const double pi = 3.14159265358979323846;
enum { MOST = 64, ALL_MODES = -1, CONTINUOUS = 0, STICK_SLIP, STICKING, AT_A_POLE };
typedef struct {
    int N, j, l, regime, samples;                /* masses, mass in contact, loaded mass; instants to follow the fastest mode */
    double mu, r, beta;                          /* (3), (10), (11) */
    double gamma[MOST], kappa[MOST], zeta[MOST]; /* m_i / m_1 (9), k_i / k_1 (73), damping ratios of the modes (18) */
    double r_n[MOST], phi[MOST][MOST]; /* omega_i sqrt(m_1 / k_1) (15), ascending; shapes, mass by mode, psi = phi / r (17) */
    double R[MOST], u[MOST], g[MOST];  /* (22), (28), (29) */
    double complex V[MOST], W[MOST], X[MOST];   /* (33); V_k exp(i phi_j); amplitudes while the contact is held (88) */
    double U[MOST], G[MOST], H_j, S_j, phi_j;   /* (34), (35), (64), largest sum over modes of (57), (39) */
    double exact, paper, approximate, sticking; /* friction ratios that part the regimes: (69), (69) with (56), (67), (88) */
    double rest;                                /* a contact held may rest from minus to plus this (74) */
} Scene;
typedef struct {
    double x, slope, tau; /* a value at an instant, and a number with the sign of its slope */
} Point;
void solve_scene(Scene* s);                       /* from N, j, l, mu, r, beta, gamma, kappa and zeta, all the others */
Point motion(const Scene* s, int k, double time); /* x_k by (46) and its derivative, tau = 0 at the maximum of x_j */
Point amplitude(const Scene* s, int k);           /* and as tau its lag behind the force: (38), (39), (47), or held */
