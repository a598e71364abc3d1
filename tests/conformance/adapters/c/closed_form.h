/* The steady motion of a chain with a Coulomb contact, where the contact slides throughout or rests for ever: the closed form of
   Marino & Cicirello, JSV 535 (2022) 117085, as corrected. Numbers in brackets are its equations; j, k, l count from 0 here. */
#include <complex.h>

enum { MOST = 64, ALL_MODES = -1 };
enum { CONTINUOUS, STICK_SLIP, PERMANENT_STICKING };

typedef struct {
    int N, j, l;                                 /* number of masses, mass in contact, loaded mass */
    double mu, r, beta;                          /* (3), (10), (11) */
    double gamma[MOST], kappa[MOST], zeta[MOST]; /* m_i / m_1 (9), k_i / k_1 (73), modal damping ratios (18) */
    double r_n[MOST], phi[MOST][MOST];           /* omega_i sqrt(m_1 / k_1) (15); shapes, mass by mode, psi = phi / r (17) */
    double R[MOST], u[MOST], g[MOST];            /* (22), (28), (29) */
    double complex v[MOST], V[MOST];             /* (23), (33) */
    double U[MOST], G[MOST], H_j, S_j;           /* (34), (35), (64), largest sum over modes of (57) */
    double exact, paper, approximate, sticking;  /* friction ratios that part the regimes: (69), (69) with (56), (67), (88) */
    double root, X_j, phi_j;                     /* (38), (39), where the contact slides throughout */
    double complex X_held[MOST];                 /* amplitudes while the contact is held (88) */
    double rest;                                 /* it may then rest from minus to plus this (74) */
    int regime;
} Scene;

int keeps_rules(const Scene* s);                                          /* of the first three lines */
void solve_scene(Scene* s);                                               /* from these, all the others */
double displacement(const Scene* s, int k, double tau, double* velocity); /* (46), tau = 0 at the maximum of x_j */
double amplitude(const Scene* s, int k, double* phase);                   /* (38), (39), (47), or with the contact held */
double motion_under_force(const Scene* s, int k, double tau);             /* tau = 0 at the maximum of the force */
double wrapped(double angle);                                             /* to (-pi, pi] */
