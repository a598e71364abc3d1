// The steady motion of a chain with one Coulomb contact, in closed form: Marino & Cicirello, JSV 535 (2022) 117085.
// Numbers in brackets are its equations, with the corrections that the ledger of denhartog lists. Forms other than the paper's
// equal them and keep their digits. Modes with zeta >= 1, which the paper leaves out, obey them with w = i w_1: all stays real.
'use strict';
const { PI, abs, sqrt, exp, expm1, sin, cos, tanh, atan2, hypot, max, min, floor, ceil } = Math;
const sum = (values) => values.reduce((a, b) => a + b, 0);
const less = (a, b) => [a[0] - b[0], a[1] - b[1]];
const times = (a, b) => [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]; // complex numbers are pairs
const over = (a, b) => { // by Smith's rule: no square leaves the range
    if (abs(b[0]) < abs(b[1])) return over([a[1], -a[0]], [b[1], -b[0]]);
    const t = b[1] / b[0], d = b[0] + b[1] * t;
    return [(a[0] + a[1] * t) / d, (a[1] - a[0] * t) / d];
};

// r_i = omega_i sqrt(m_1/k_1), ascending, and phi with phi^T diag(gamma) phi = 1, (15), (17): psi = phi / r.
// K = B^T B with the stretched springs as rows of B: rotations make columns of B orthogonal, r_i are their lengths.
function naturalModes(gamma, kappa) {
    const columns = gamma.map((m, i) => ({
        b: gamma.map((_, n) => (n === i ? sqrt(kappa[n] / m) : n === i + 1 ? -sqrt(kappa[n] / m) : 0)),
        v: gamma.map((_, n) => (n === i ? 1 : 0)),
    }));
    const dot = (x, y) => sum(x.map((xi, i) => xi * y[i]));
    for (let sweep = 0; sweep < 30; ++sweep)
        for (const P of columns)
            for (const Q of columns.slice(columns.indexOf(P) + 1)) {
                const pp = dot(P.b, P.b), qq = dot(Q.b, Q.b), pq = dot(P.b, Q.b);
                if (abs(pq) <= 1e-16 * sqrt(pp * qq)) continue;
                const h = (qq - pp) / (2 * pq), t = (h < 0 ? -1 : 1) / (abs(h) + hypot(1, h)), c = 1 / hypot(1, t), s = c * t;
                const turn = (x, y) => x.forEach((xi, i) => { [x[i], y[i]] = [c * xi - s * y[i], s * xi + c * y[i]]; });
                for (const part of ['b', 'v']) turn(P[part], Q[part]);
            }
    const modes = columns.map(({ b, v }) => ({ r_n: hypot(...b), phi: v.map((vk, k) => vk / sqrt(gamma[k])) }));
    return modes.sort((m, n) => m.r_n - n.r_n);
}
// zeta >= 1: rates a = zeta - w_1 and b = zeta + w_1 = 1 / a with w_1 = sqrt(zeta^2 - 1), and q_i at tau = R x.
function decay(x, zeta) {
    const w_1 = sqrt(zeta - 1) * sqrt(zeta + 1), a = 1 / (zeta + w_1);
    return [a, zeta + w_1, exp(-a * x) * (w_1 > 0 ? -expm1(-2 * w_1 * x) / (2 * w_1) : x)];
}
// sinh(zeta x)/(zeta x) - sin(w x)/(w x) = sum of D_k x^2k/(2k+1)!, D_{k+1} = zeta^2 D_k + (-w^2)^k: nothing cancels.
function sinhcLessSinc(x, zeta) {
    const X = (zeta * x) ** 2, Y = (zeta - 1) * x * ((zeta + 1) * x); // Y = -(w x)^2
    let term = x * x / 6, power = term, total = 0;
    for (let k = 1; k < 40; ++k) {
        total += term;
        power *= Y / ((2 * k + 2) * (2 * k + 3));
        term = X * term / ((2 * k + 2) * (2 * k + 3)) + power;
    }
    return total;
}
// v_di (23), u_di (28), g_i (29): 1 - R^2 as a product, D = 2 E (cosh delta + cos theta) as a sum of squares.
function modeFunctions(R, zeta) {
    const v = over([1, 0], [(1 - R) * (1 + R), 2 * zeta * R]), x = PI / R, delta = PI * zeta / R, E = exp(-delta);
    if (zeta >= 1) {
        const [a, b, q] = decay(x, zeta), D = (1 + exp(-a * x)) * (1 + exp(-b * x)), u = 2 * q / (R * D);
        // sinh delta - zeta S = (sinh delta - sinh w_1 x) - a S with S = sinh(w_1 x)/w_1
        return { v, u, g: zeta * x <= 4 ? 2 * E * delta * sinhcLessSinc(x, zeta) / D : tanh(a * x / 2) - a * R * u };
    }
    const w = sqrt((1 - zeta) * (1 + zeta));
    let sinTheta = sin(PI * w / R), cosHalfTheta = cos(PI * w / R / 2);
    if (zeta < 0.5) { // theta = pi (n + y), n the odd number next to 1 / R; 1 - n R is exact with R in two parts
        const n = 2 * floor(1 / R / 2) + 1, R_high = Math.fround(R);
        const y = ((1 - n * R_high) - n * (R - R_high) - zeta * zeta / (1 + w)) / R;
        sinTheta = -sin(PI * y);
        cosHalfTheta = sin(PI * y / 2); // but for its sign
    }
    const D = expm1(-delta) ** 2 + 4 * E * cosHalfTheta ** 2; // zero at a pole: then u and g are no finite numbers
    const g = x <= 4 ? 2 * E * delta * sinhcLessSinc(x, zeta) / D
        : (-expm1(-delta) * (1 + E) - 2 * zeta * E * sinTheta / w) / D;
    return { v, u: 2 * E * sinTheta / (R * w * D), g };
}
// 1 - d_i, q_i, R_i q_i' and R_i q_i' - cos tau from (A.8), (A.9), without cancellation for tau -> 0 and R -> infinity.
function freeMotion(tau, R, zeta) {
    const x = tau / R;
    let free;
    if (zeta < 1) {
        const w = sqrt((1 - zeta) * (1 + zeta)), E = exp(-zeta * x), C = cos(w * x), q = E * sin(w * x) / w;
        const cosines = -2 * sin((w * x + tau) / 2) * sin(((1 - R) - zeta * zeta / (1 + w)) * x / 2); // cos(w x) - cos(tau)
        free = [1 - (E * C + zeta * q), q, E * C - zeta * q, expm1(-zeta * x) * C + cosines - zeta * q];
    } else {
        const [a, b, q] = decay(x, zeta);
        free = [-expm1(-a * x) - a * q, q, exp(-b * x) - a * q, expm1(-b * x) - a * q + 2 * sin(tau / 2) ** 2];
    }
    if (max(1, 2 * zeta) * x < 1) { // there 1 - d by its power series: m'' + 2 zeta m' + m = 1
        free[0] = 0;
        for (let k = 2, before = 0, term = x * x / 2; k < 22; ++k) {
            free[0] += term;
            [before, term] = [term, -(2 * zeta * x * k * term + x * x * before) / (k * (k + 1))];
        }
    }
    return free;
}
// [value, slope, tau] where f = [value, a number with the sign of its slope] is largest; the slope is bisected where it turns.
function largest(f, taus) {
    const points = taus.map((tau) => [...f(tau), tau]);
    for (let n = 1; n < taus.length; ++n) {
        if (!(points[n - 1][1] > 0) || points[n][1] > 0) continue;
        let a = taus[n - 1], b = taus[n];
        for (let i = 0; i < 60; ++i) [a, b] = f((a + b) / 2)[1] > 0 ? [(a + b) / 2, b] : [a, (a + b) / 2];
        points.push([...f(a), a]);
    }
    return points.reduce((p, q) => (q[0] > p[0] ? q : p));
}
// Solves A x = b, complex, by elimination with the largest pivot.
function solve(A, b) {
    const rows = A.map((row, i) => [...row, b[i]]);
    for (let p = 0; p < rows.length; ++p) {
        const size = (row) => hypot(...row[p]), best = rows.slice(p).reduce((s, t) => (size(t) > size(s) ? t : s));
        rows.splice(rows.indexOf(best), 1);
        rows.splice(p, 0, best.map((z) => over(z, best[p])));
        rows.forEach((row, i) => { if (i !== p) rows[i] = row.map((z, n) => less(z, times(row[p], rows[p][n]))); });
    }
    return rows.map((row) => row[rows.length]);
}
class ClosedForm {
    constructor({ mass_ratios, stiffness_ratios, damping_ratios, contact, load, mu, r, beta }) {
        Object.assign(this, { gamma: mass_ratios, kappa: stiffness_ratios, j: contact - 1, l: load - 1, mu, r, beta });
        this.modes = naturalModes(this.gamma, this.kappa).map(({ r_n, phi }, i) => { // R_i by (22)
            const R = r / r_n, zeta = damping_ratios[i];
            return { r_n, phi, R, zeta, ...modeFunctions(R, zeta), psi_j_squared: (phi[this.j] / r) ** 2 };
        });
        const sumAt = (k, n, f) => sum(this.modes.map((m) => m.phi[k] * m.phi[n] / m.r_n ** 2 * f(m))); // psi_k psi_n R^2
        this.V = this.gamma.map((_, k) => [sumAt(k, this.l, (m) => m.v[0]), sumAt(k, this.l, (m) => m.v[1])]); // (33)
        this.U = this.gamma.map((_, k) => sumAt(k, this.j, (m) => m.u)); // (34)
        this.G = this.gamma.map((_, k) => sumAt(k, this.j, (m) => m.g)); // (35)
        this.H_j = sum(this.modes.map((m) => m.psi_j_squared * (m.g + 2 * m.zeta * m.R * m.u))); // (64)
        this.samples = 64 * min(4096, ceil(2 + 1 / min(...this.modes.map((m) => m.R)))); // fastest mode: w / (2 R) turns
    }
    // Largest sum over modes of psi_ji^2 times (57) as corrected, 0 < tau < pi, or its limit (71) at 0; that at pi is less.
    demand(modes = this.modes) {
        const at = (tau) => {
            let N = 0, N_prime = 0; // the sum times sin tau, and its derivative
            for (const { R, zeta, u, g, psi_j_squared } of modes) {
                const [, q, Rq_prime, difference] = freeMotion(tau, R, zeta);
                N += psi_j_squared * ((1 + g) * R * q - u * R * R * difference);
                N_prime += psi_j_squared * ((1 + g) * Rq_prime + u * R * (2 * zeta * Rq_prime + q - R * sin(tau)));
            }
            return [N / sin(tau), N_prime * sin(tau) - N * cos(tau)];
        };
        const taus = Array.from({ length: this.samples - 1 }, (_, n) => PI * (n + 1) / this.samples);
        const early = Array.from({ length: 200 }, (_, n) => 1e-9 * (taus[0] / 1e-9) ** (n / 200)); // heavy damping is quick
        const at_0 = sum(modes.map((m) => m.psi_j_squared * (1 + m.g + 2 * m.zeta * m.R * m.u)));
        return max(at_0, largest(at, [...early, ...taus])[0]);
    }
    S_dj() { return sum(this.modes.map((m) => this.demand([m]))); } // (56): the modes' own maxima
    beta_lim(S) { // (67), (69)
        return hypot(...this.V[this.j]) / hypot(this.U[this.j], max(S, this.H_j + this.mu / (this.gamma[this.j] * this.r ** 2)));
    }
    // Contact held, (88): X_k in x_k = Re{X_k exp(i tau)}; the least beta that does it; how far from zero it may rest.
    held() {
        const { gamma, kappa, modes, mu, r, j, l } = this, N = gamma.length, others = [...gamma.keys()].filter((k) => k !== j);
        const spring = (a, b) => (a === b ? kappa[a] + (a + 1 < N ? kappa[a + 1] : 0) : abs(a - b) === 1 ? -kappa[max(a, b)] : 0);
        const Z = (a, b) => [spring(a, b) - (a === b ? r * r * gamma[a] : 0), // K - r^2 M + i C, C by (19)
            sum(modes.map((m) => 2 * m.zeta * m.r_n * r * gamma[a] * m.phi[a] * gamma[b] * m.phi[b]))];
        const moving = solve(others.map((a) => others.map((b) => Z(a, b))), others.map((a) => [a === l ? 1 : 0, 0]));
        const load = others.map((a, n) => times(Z(j, a), moving[n])).reduce(less, [l === j ? 1 : 0, 0]); // with its sign turned
        const X = [...moving.slice(0, j), [0, 0], ...moving.slice(j)], limit = hypot(...load) / mu;
        return { X, limit, rest: mu * (this.beta - limit) * sum(kappa.slice(0, j + 1).map((k) => 1 / k)) };
    }
    regime() {
        const limit = this.beta_lim(this.demand());
        if (Number.isNaN(limit)) throw new RangeError('a mode without damping at its resonance');
        return this.beta < limit ? 'continuous' : this.beta >= this.held().limit ? 'permanent_sticking' : 'stick_slip';
    }
    // phi_j, (39), and V_dk exp(i phi_j) with (36), (37): V_dj exp(i phi_j) = root - i beta U_dj.
    slide() {
        if (this.regime() !== 'continuous') throw new RangeError('the contact does not slide throughout');
        const V_j = this.V[this.j], size = hypot(...V_j), bU = this.beta * this.U[this.j], root = sqrt((size - bU) * (size + bU));
        const W = this.V.map((V, k) => (k === this.j ? [root, -bU] : times(V, over([root, -bU], V_j))));
        const start = W.map((w, k) => [w[0] - this.beta * this.G[k], -w[1] - this.beta * this.U[k]]); // (44), (45) as corrected
        return { phi_j: atan2(-bU, root) - atan2(V_j[1], V_j[0]), W, start };
    }
    // x_k by (46) as corrected, and its derivative; tau = 0 at the maximum of x_j, x_k(tau + pi) = -x_k(tau).
    motion(k, W, time) {
        const half = floor(time / PI), tau = max(0, time - half * PI), sign = half % 2 ? -1 : 1;
        let [x, x_prime] = times(W[k], [cos(tau), sin(tau)]);
        x_prime = -x_prime;
        for (const { phi, r_n, R, zeta, u, g } of this.modes) {
            const weight = this.beta * phi[k] * phi[this.j] / r_n ** 2, [less_d, q, Rq_prime] = freeMotion(tau, R, zeta);
            x += weight * (less_d - g * (1 - less_d) - u * R * q);
            x_prime += weight * ((1 + g) * q / R - u * Rq_prime);
        }
        return [sign * x, sign * x_prime];
    }
    amplitudeAndPhase(k) {
        if (this.regime() === 'permanent_sticking') return this.held().X.map((X) => [hypot(...X), -atan2(X[1], X[0])])[k];
        const { phi_j, W, start } = this.slide();
        if (k === this.j) return [start[k][0], phi_j]; // (38), (39)
        const taus = Array.from({ length: this.samples + 1 }, (_, n) => PI * n / this.samples);
        const size = ([x, x_prime]) => [abs(x), x * x_prime];
        const [amplitude, , tau] = largest((time) => size(this.motion(k, W, time)), taus);
        return [amplitude, phi_j + tau + (this.motion(k, W, tau)[0] < 0 ? PI : 0)]; // (47)
    }
    motionUnderForce(k, taus) { // tau = 0 at the maximum of the force
        const held = this.regime() === 'permanent_sticking' && this.held(), { phi_j, W } = held || this.slide();
        return taus.map((tau) => (held ? times(held.X[k], [cos(tau), sin(tau)])[0] : this.motion(k, W, tau - phi_j)[0]));
    }
}
module.exports = ClosedForm;
module.exports.modeFunctions = modeFunctions;
