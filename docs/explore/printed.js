// Each equation that does not hold as the text at hand prints it, as curves: as printed and as corrected, over what shows it
// best. The printed forms are those of src/denhartog/formulas/as_printed.hpp. Verdicts and losses are the ledger's; none stands
// here.
'use strict';
const { ContactMotion, eliminated, stateAt } = require('../../tests/conformance/adapters/javascript/contact_motion.js');
const { PI, sin, cos, exp, sqrt, abs, hypot, max, min, sign, atan2, cosh, sinh } = Math;

const w = (zeta) => sqrt(1 - zeta * zeta);
const psi = (c, m, k) => m.phi[k] / c.r;
const overModes = (c, f) => c.modes.reduce((s, m) => s + f(m), 0);
const argument = ([re, im]) => atan2(im, re);
// d and q of (A.8), d' and q' of (A.9).
function free(tau, R, zeta) {
    const e = exp((-zeta * tau) / R),
        C = cos((w(zeta) * tau) / R),
        S = sin((w(zeta) * tau) / R),
        q = (e * S) / w(zeta);
    return { d: e * C + zeta * q, q, d_prime: -q / R, q_prime: (e * C - zeta * q) / R, e, C, S };
}
const bracesPrinted = (tau, { R, zeta, u, g }) => {
    const { e, C, S } = free(tau, R, zeta);
    return 1 - (1 + g) * e * (S + (zeta / w(zeta)) * C) - ((u * R) / w(zeta)) * e * S;
};
const braces = (tau, { R, zeta, u, g }) => {
    const { d, q } = free(tau, R, zeta);
    return 1 - (1 + g) * d - u * R * q;
};
// Values of the closed form at tau = 0, by modes: eta_i0, eta'_i0 = psi_i^T M x(0), from the corrected start.
function modal(c, m) {
    const { start, phi_j } = c.slide(),
        of = (n) => start.reduce((s, x, k) => s + c.r ** 2 * c.gamma[k] * psi(c, m, k) * x[n], 0);
    return { eta_0: of(0), eta_prime_0: of(1), phi_j };
}
const angleOf = (c, k) => argument(c.V[k]) - argument(c.V[c.j]);
const ratioOf = (c, k) => hypot(...c.V[k]) / hypot(...c.V[c.j]);
const rootOf = (c) => sqrt(max(0, hypot(...c.V[c.j]) ** 2 - (c.beta * c.U[c.j]) ** 2));
const mass46 = (form) => (c, tau, k) => {
    const { W } = c.slide();
    return (
        W[k][0] * cos(tau) -
        W[k][1] * sin(tau) +
        c.beta * overModes(c, (m) => ((m.phi[k] * m.phi[c.j]) / m.r_n ** 2) * form(tau, m))
    );
};
const mode40 = (form) => (c, tau, k, i) => {
    const m = c.modes[i],
        { eta_0, eta_prime_0 } = modal(c, m),
        p = psi(c, m, c.j) * m.R ** 2 * c.beta;
    return (eta_0 + p * m.g) * cos(tau) + (eta_prime_0 + p * m.u) * sin(tau) + p * form(tau, m);
};
const velocityA7 = (first) => (c, tau, k, i) => {
    const m = c.modes[i],
        { eta_0, eta_prime_0, phi_j } = modal(c, m),
        f = free(tau, m.R, m.zeta),
        p = m.R ** 2;
    const v = (angle) => m.v[0] * cos(angle) - m.v[1] * sin(angle); // Re{v exp(i angle)}
    return (
        first * f.d_prime * eta_0 +
        m.R * f.q_prime * eta_prime_0 -
        psi(c, m, c.j) * p * f.d_prime * c.beta -
        psi(c, m, c.l) * p * ((sin(tau) + f.d_prime) * v(phi_j) + (cos(tau) - m.R * f.q_prime) * v(phi_j - PI / 2))
    );
};
// (50), (51) and the root of their squares.
const cosinePrinted = (c, k) =>
    ratioOf(c, k) * rootOf(c) * cos(angleOf(c, k)) + c.beta * c.U[c.j] * sin(angleOf(c, k)) - c.beta * c.G[k];
function amplitude52(c, k, turn) {
    const D = angleOf(c, k),
        U_k = c.U[k],
        G_k = c.G[k],
        { beta } = c;
    return sqrt(
        hypot(...c.V[k]) ** 2 +
            beta ** 2 * (G_k ** 2 + U_k ** 2) -
            2 *
                beta *
                ratioOf(c, k) *
                (rootOf(c) * (G_k * cos(D) + turn * U_k * sin(D)) + beta * c.U[c.j] * (G_k * sin(D) + U_k * cos(D))),
    );
}
// The largest of f over (0, pi): sampled, with the ends of the half-period left out.
function greatest(f) {
    let most = -Infinity;
    for (let n = 1; n < 400; ++n) most = max(most, f((PI * n) / 400));
    return most;
}
const integrandPrinted = (tau, { R, zeta, u, g }) => {
    const { e, C, S, q } = free(tau, R, zeta);
    return ((1 + g) * R * q - u * R * R * e * (S + (zeta / w(zeta)) * C)) / sin(tau);
};
const integrand = (tau, { R, zeta, u, g }) => {
    const { q, q_prime } = free(tau, R, zeta);
    return ((1 + g) * R * q - u * R * R * (R * q_prime - cos(tau))) / sin(tau);
};
const printedDemand = (c) => overModes(c, (m) => m.psi_j_squared * greatest((tau) => integrandPrinted(tau, m)));
const limit = (c, S) => hypot(...c.V[c.j]) / hypot(c.U[c.j], S);
const staticDemand = (c, side = 1) => c.H_j + (side * c.mu) / (c.gamma[c.j] * c.r ** 2);
// Smallest beta at which one of the modal inequalities (59), (63) fails, each with its own right side psi_ji mu beta.
function modalLimit(c) {
    const most = hypot(...c.V[c.j]) / max(1e-300, abs(c.U[c.j])),
        scene = (beta) => c.withFriction(beta);
    const fails = (beta) => {
        const at = scene(beta),
            V_j = at.V[at.j],
            size = hypot(...V_j),
            bU = beta * at.U[at.j],
            root = sqrt(max(0, size ** 2 - bU ** 2));
        const turn = [(root * V_j[0] - bU * V_j[1]) / size ** 2, (-bU * V_j[0] - root * V_j[1]) / size ** 2]; // exp(i phi_j)
        return at.modes.some((m) => {
            const v = m.v[0] * turn[0] - m.v[1] * turn[1],
                p = psi(at, m, at.j);
            const eta_0 = psi(at, m, at.l) * m.R ** 2 * v - p * m.R ** 2 * m.g * beta; // (26)
            return !(abs(eta_0 - beta * p * ((1 - m.R ** 2) * m.g + 2 * m.zeta * m.R * m.u)) > p * at.mu * beta);
        });
    };
    const cap = min(most, 4);
    for (let n = 1; n <= 200; ++n)
        if (fails((cap * n) / 200)) {
            let [a, b] = [(cap * (n - 1)) / 200, (cap * n) / 200];
            for (let t = 0; t < 40; ++t) [a, b] = fails((a + b) / 2) ? [a, (a + b) / 2] : [(a + b) / 2, b];
            return a;
        }
    return cap;
}
// (88) by the spring between the contact and its neighbour on the side of the load.
function spring88(c) {
    const { gamma, kappa, modes, j, l, r, mu } = c;
    if (j === l) return 1 / mu;
    const N = gamma.length,
        from = j > l ? 0 : j + 1,
        to = j > l ? j : N,
        masses = gamma.slice(from, to);
    const K = masses.map((_, a) =>
        masses.map((_, b) =>
            a === b
                ? kappa[from + a] + (from + a + 1 < N ? kappa[from + a + 1] : 0)
                : abs(a - b) === 1
                  ? -kappa[from + max(a, b)]
                  : 0,
        ),
    );
    const C = masses.map((_, a) =>
        masses.map((_, b) =>
            overModes(c, (m) => 2 * m.zeta * m.r_n * gamma[from + a] * m.phi[from + a] * gamma[from + b] * m.phi[from + b]),
        ),
    );
    const n = masses.length,
        rows = []; // (K - r^2 M + i r C) X = e_l as a real system
    for (const half of [0, 1])
        for (let a = 0; a < n; ++a) {
            const real = K[a].map((y, b) => y - (a === b ? r * r * masses[a] : 0)),
                imaginary = C[a].map((y) => r * y);
            rows.push([
                ...(half ? imaginary : real),
                ...(half ? real : imaginary.map((y) => -y)),
                !half && from + a === l ? 1 : 0,
            ]);
        }
    const X = eliminated(rows),
        next = j > l ? n - 1 : 0;
    return ((j > l ? kappa[j] : kappa[j + 1]) * hypot(X[next], X[n + next])) / mu;
}
// At the resonance of mode i: what (81) and (82) are made of, by (77), (78), (80).
function atResonance(c, i, k) {
    const r = c.modes[i].r_n,
        at = new ContactMotion({ ...c.scene, r }),
        m = at.modes[i];
    const pk = psi(at, m, k),
        pj = psi(at, m, at.j),
        pl = psi(at, m, at.l),
        t = PI * m.zeta;
    return { V: abs(pk * pl) / (2 * m.zeta), G: (pk * pj * sinh(t)) / (cosh(t) - 1), U_k: at.U[k], U_j: at.U[at.j], pk, pj, at };
}
const motionOver = (scene) => {
    let found;
    return (tau, k) => stateAt((found ??= new ContactMotion(scene).steady()), tau).x[k];
};

const tauHalf = { name: 'τ', label: 'τ, from the maximum of x_j', from: 0, to: PI, key: null };
const over = {
    tau: tauHalf,
    r: { name: 'r', label: 'frequency ratio r', from: 0.1, to: 2.5, key: 'r' },
    beta: { name: 'β', label: 'friction ratio β', from: 0, to: 1, key: 'b' },
    mu: { name: 'μ', label: 'static over kinetic friction μ', from: 1, to: 2, key: 'mu' },
};
const two = 'N=2&g=1&k=1&z=0.1&j=2&l=1&r=0.9&b=0.2';
// A curve is f(c, x, k, i): c the exact motion at the slider's scene with the axis at x, k the mass, i the mode.
const equations = [
    {
        eq: ['46', '41'],
        what: 'displacement of mass k over the half-period',
        y: 'x_k',
        over: over.tau,
        open: two,
        slides: true,
        of: 'mass',
        printed: mass46(bracesPrinted),
        corrected: mass46(braces),
        how: 'Sine and cosine are exchanged. As printed the motion does not start where (38) says, and its halves do not meet.',
    },
    {
        eq: ['40', 'A.15'],
        what: 'displacement of mode i over the half-period',
        y: 'η_i',
        over: over.tau,
        open: two,
        slides: true,
        of: 'mode',
        printed: mode40(bracesPrinted),
        corrected: mode40(braces),
        how: 'The same bracket, one mode at a time.',
    },
    {
        eq: ['A.7'],
        what: 'velocity of mode i over the half-period',
        y: 'η_i′',
        over: over.tau,
        open: two,
        slides: true,
        of: 'mode',
        printed: velocityA7(-1),
        corrected: velocityA7(1),
        how: 'The first term has the opposite sign.',
    },
    {
        eq: ['44'],
        what: 'displacement of mass k when the contact turns',
        y: 'x_k0',
        over: over.beta,
        open: two,
        slides: true,
        of: 'mass',
        printed: (c, x, k) => -c.beta * c.G[k] + ratioOf(c, k) * rootOf(c) * cos(angleOf(c, k)),
        corrected: (c, x, k) => c.slide().start[k][0],
        how: 'Its real part leaves out what friction adds by the angle between the two masses. For the contact both are one.',
    },
    {
        eq: ['45'],
        what: 'velocity of mass k when the contact turns',
        y: 'x_k0′',
        over: over.beta,
        open: two,
        slides: true,
        of: 'mass',
        printed: (c, x, k) => c.beta * (ratioOf(c, k) * c.U[c.j] * cos(angleOf(c, k)) - c.U[k]),
        corrected: (c, x, k) => c.slide().start[k][1],
        how: 'Its real part leaves out the root times the sine of the angle between the two masses.',
    },
    {
        eq: ['49'],
        what: 'one-harmonic motion of mass k over the half-period',
        y: 'x_k',
        over: over.tau,
        open: two,
        slides: true,
        of: 'mass',
        printed: (c, tau, k) => {
            // Re{x_k0 cos + x_k0' sin} with the complex (44), (45)
            const D = angleOf(c, k),
                a = ratioOf(c, k) * rootOf(c),
                b = c.beta * ratioOf(c, k) * c.U[c.j];
            return (a * cos(D) - c.beta * c.G[k]) * cos(tau) + (b * cos(D) - c.beta * c.U[k]) * sin(tau);
        },
        corrected: (c, tau, k) => {
            const [x, v] = c.slide().start[k];
            return x * cos(tau) + v * sin(tau);
        },
        how: 'The initial values of (44) and (45) are complex, so that the two expressions differ. The second is right.',
    },
    {
        eq: ['50'],
        what: 'cosine part of the one-harmonic motion of mass k',
        y: 'X_kC',
        over: over.beta,
        open: two,
        slides: true,
        of: 'mass',
        printed: (c, x, k) => cosinePrinted(c, k),
        corrected: (c, x, k) => c.slide().start[k][0],
        how: 'The ratio of the moduli multiplies the first term alone; it belongs to both.',
    },
    {
        eq: ['52'],
        what: 'one-harmonic amplitude of mass k',
        y: 'X_k',
        over: over.beta,
        open: two,
        slides: true,
        of: 'mass',
        printed: (c, x, k) => amplitude52(c, k, 1),
        corrected: (c, x, k) => hypot(...c.slide().start[k]),
        how: 'One sign: that of the first damping function times the sine of the angle.',
    },
    {
        eq: ['57'],
        what: 'what the maximum of mode i is taken of',
        y: 's_i(τ)',
        over: over.tau,
        open: two + '&i=1',
        of: 'mode',
        ends: true,
        printed: (c, tau, k, i) => integrandPrinted(tau, c.modes[i]),
        corrected: (c, tau, k, i) => integrand(tau, c.modes[i]),
        how: 'Another bracket, and a cosine that is left out: as printed it has no finite value at the ends of the half-period.',
    },
    {
        eq: ['70'],
        what: 'expansion of s_i for small τ',
        y: 's_i(τ)',
        over: { ...tauHalf, to: 0.6 },
        open: two + '&i=1',
        of: 'mode',
        printed: (c, tau, k, i) => {
            const { R, zeta, u, g } = c.modes[i],
                a = 1 - (zeta * tau) / R;
            return (1 + g) * a - (u * R * R * (1 - a * a)) / tau;
        },
        corrected: (c, tau, k, i) => {
            const { R, zeta, u, g } = c.modes[i],
                a = 1 - (zeta * tau) / R;
            return (1 + g) * a - (u * R * R * (a * a - 1)) / tau;
        },
        first: (c, tau, k, i) => integrand(tau, c.modes[i]),
        how: 'The bracket has the opposite sign; the third line is (57) as corrected, which the expansion is to follow at τ = 0.',
    },
    {
        eq: ['56'],
        what: 'boundary of sliding throughout',
        y: 'β_lim',
        over: { ...over.r, to: 1.2 },
        open: 'N=5&g=1&k=1&z=0.001&j=4&l=1&r=0.38&b=0.1',
        heavy: true,
        limit: true,
        printed: (c) => limit(c, max(c.S_dj(), staticDemand(c))),
        corrected: (c) => c.beta_lim(c.demand()),
        how: 'The sum of the largest values of the modes is not the largest value of their sum: it is reached at other instants.',
    },
    {
        eq: ['69'],
        what: 'boundary of sliding throughout, with (56) and (57) as printed',
        y: 'β_lim',
        over: over.r,
        open: 'N=1&g=1&k=1&z=0.05&j=1&l=1&r=0.6&b=0.4',
        heavy: true,
        limit: true,
        printed: (c) => limit(c, max(printedDemand(c), staticDemand(c))),
        corrected: (c) => c.beta_lim(c.demand()),
        how:
            'The boundary itself is right with the maximum as corrected. As printed the maximum has no bound at τ = 0; ' +
            'the curve takes 400 instants.',
    },
    {
        eq: ['59', '63'],
        what: 'boundary by the condition at the turning point',
        y: 'β',
        over: over.r,
        open: 'N=2&g=1&k=1&z=0.05&j=2&l=1&r=0.9&b=0.2',
        limit: true,
        printed: modalLimit,
        corrected: (c) => limit(c, staticDemand(c)),
        how: 'An inequality for each mode does not follow from the one for their sum: the load on the contact is the sum.',
    },
    {
        eq: ['68'],
        what: 'the second branch of the condition at the turning point',
        y: 'β',
        over: over.r,
        open: 'N=2&g=1&k=1&z=0.05&j=2&l=1&r=0.9&b=0.2',
        limit: true,
        printed: (c) => limit(c, staticDemand(c, -1)),
        corrected: (c) => (staticDemand(c, -1) > 0 ? limit(c, staticDemand(c, -1)) : NaN),
        how: 'It is a boundary only where H_j exceeds μ/(γ_j r²). Elsewhere no β fulfils this branch, and there is no curve.',
    },
    {
        eq: ['81'],
        what: 'amplitude of mass k at the resonance of mode i',
        y: 'X_k',
        over: over.beta,
        open: 'N=2&g=1&k=1&z=0.05&j=2&l=1&r=0.618&b=0.2',
        of: 'both',
        at: 'resonance',
        printed: (c, x, k, i) => {
            const { V, G, U_k, U_j } = atResonance(c, i, k),
                b = c.beta;
            return sqrt(V * V + b * b * (G * G + U_k * U_k) - b * (2 * V * abs(G) - abs(U_j) * abs(U_k)));
        },
        corrected: (c, x, k, i) => {
            const { V, G, U_k, U_j, pk, pj } = atResonance(c, i, k),
                b = c.beta;
            return sqrt(V * V + b * b * (G * G + U_k * U_k) - 2 * b * (V * abs(G) + b * (pk / pj) * U_j * U_k));
        },
        how: 'The product of the first damping functions has another sign and lacks a factor.',
    },
    {
        eq: ['82'],
        what: 'amplitude of mass k at the resonance of mode i',
        y: 'X_k',
        over: over.beta,
        open: 'N=1&g=1&k=1&z=0.05&j=1&l=1&r=1&b=0.2',
        of: 'both',
        at: 'resonance',
        printed: (c, x, k, i) => {
            const { V, G } = atResonance(c, i, k);
            return hypot(c.beta * abs(G), V);
        },
        corrected: (c, x, k, i) => {
            const { V, G } = atResonance(c, i, k);
            return abs(V - c.beta * abs(G));
        },
        how: 'Without the bars of a modulus V is −i times its size at resonance, so that friction would raise the peak.',
    },
    {
        eq: ['86'],
        what: 'boundary of sliding at high frequency, load on the contact',
        y: 'β_∞',
        over: over.mu,
        open: 'N=1&g=1&k=1&z=0.05&j=1&l=1&mu=1.5&r=2.5&b=0.3',
        printed: (c) => 2 / sqrt(4 * c.mu + PI ** 2),
        corrected: (c) => 2 / sqrt(4 * c.mu ** 2 + PI ** 2),
        how: 'μ stands where its square belongs; with μ = 1, the only value of the figures, nothing shows.',
    },
    {
        eq: ['88'],
        what: 'boundary of permanent sticking',
        y: 'β*_lim',
        over: over.r,
        open: 'N=2&g=1&k=1&z=0.1&j=2&l=1&r=0.9&b=0.2',
        limit: true,
        printed: spring88,
        corrected: (c) => c.held().limit,
        how: 'The spring’s force alone holds the contact as printed; the damping forces of the moving masses act on it too.',
    },
    {
        eq: ['2'],
        what: 'friction force over a period',
        y: 'F_f / P',
        over: { ...over.tau, to: 2 * PI, label: 'τ, from the maximum of the force' },
        open: 'N=1&g=1&k=1&z=0.05&j=1&l=1&r=0.5&b=0.4',
        steps: true,
        printed: (c, tau) => -c.beta * sign(stateAt((c.found ??= c.steady()), tau).x[c.j]),
        corrected: (c, tau) => {
            const { direction, x, v } = stateAt((c.found ??= c.steady()), tau % c.found.period);
            return direction ? -direction * c.beta : -c.load(x, v, tau);
        },
        how: 'The displacement stands under sgn, without its dot. While the contact rests, friction takes what the load asks for.',
    },
    {
        eq: ['4', '16'],
        what: 'displacement of the contact over a period',
        y: 'x_j',
        over: { ...over.tau, to: 2 * PI, label: 'τ, from the maximum of the force' },
        open: 'N=2&g=1&k=1&z=0.05&j=2&l=1&r=0.9&b=0.2',
        steps: true,
        printed: (c, tau) => (c.other ??= motionOver({ ...c.scene, load: c.scene.contact }))(tau, c.j),
        corrected: (c, tau) => (c.own ??= motionOver(c.scene))(tau, c.j),
        how: 'One vector stands for load and friction: the load would act on the mass in contact. With j = l nothing shows.',
    },
    {
        eq: ['5'],
        what: 'displacement of 1 mm under P = 1 N, without dimension',
        y: 'x̄',
        over: { name: 'k_1', label: 'stiffness k_1 in N/mm', from: 0.2, to: 4, key: null, at: 2 },
        open: '',
        printed: () => 1,
        corrected: (c, x) => x,
        how: 'The stiffness ratio κ_1 = 1 stands where the stiffness k_1 belongs.',
    },
    {
        eq: ['A.12'],
        what: 'v cos φ_j of mode i from the two conditions',
        y: 'v cos φ_j',
        over: over.beta,
        open: two,
        slides: true,
        of: 'mode',
        printed: (c, x, k, i) => conditions(c, i, true),
        corrected: (c, x, k, i) => conditions(c, i, false),
        how: 'The natural frequency stands where the coefficient 𝒬 of (A.11) belongs.',
    },
];
function conditions(c, i, withOmega) {
    // (A.12), first half, with v taken out of (A.11)
    const m = c.modes[i],
        { eta_0, eta_prime_0 } = modal(c, m),
        f = free(PI, m.R, m.zeta),
        l = psi(c, m, c.l),
        p = psi(c, m, c.j),
        { R } = m;
    const A = -l * R * R * (1 + f.d),
        B = l * R ** 3 * f.q,
        C = (1 + f.d) * eta_0 + R * f.q * eta_prime_0 + p * R * R * (1 - f.d) * c.beta;
    const P = l * R * f.q,
        Q = withOmega ? 1 / R : l * R * R * (1 + R * f.q_prime);
    const last = (-f.q / R) * eta_0 + (1 + R * f.q_prime) * eta_prime_0 + p * R * f.q * c.beta;
    return (B * last - C * Q) / (A * Q - B * P);
}
// The exact motion of a scene, which the curves take: it keeps the scene.
const exactly = (scene) => Object.assign(new ContactMotion(scene), { scene });
// One value of a curve of an entry; NaN where the form has none there, or holds for sliding alone and the contact stops.
function value(entry, curve, c, x, k, i) {
    try {
        if (entry.slides && c.regime() !== 'continuous') return NaN;
        const y = curve(c, x, min(k, c.gamma.length - 1), min(i, c.gamma.length - 1));
        return Number.isFinite(y) ? y : NaN;
    } catch (fault) {
        if (fault instanceof RangeError) return NaN; // the contact does not slide throughout, or a mode is at a pole
        throw fault;
    }
}
// The scene with the axis at x: its variable, where the axis is one of the scene.
const at = (entry, scene, x) =>
    ({ r: { ...scene, r: x }, b: { ...scene, beta: x }, mu: { ...scene, mu: x } })[entry.over.key] ?? scene;
module.exports = { equations, exactly, value, at };
