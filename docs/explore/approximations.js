// Other ways to compute the steady motion: the paper's Runge-Kutta with events, friction regularised by tanh, harmonic balance.
// Cost is counted in evaluations of the friction law: one a stage of Runge-Kutta, one a sample of the harmonic balance.
'use strict';
const { ContactMotion, eliminated, stateAt } = require('../../tests/conformance/adapters/javascript/contact_motion.js');
const { PI, abs, cos, sin, max, min, hypot, sign, sqrt, tanh } = Math;

// Dormand & Prince's pair of orders 5 and 4, whose fourth-order interpolant locates the events.
const nodes = [0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1, 1];
const rows = [
    [],
    [1 / 5],
    [3 / 40, 9 / 40],
    [44 / 45, -56 / 15, 32 / 9],
    [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
    [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
    [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
];
const low = [5179 / 57600, 0, 7571 / 16695, 393 / 640, -92097 / 339200, 187 / 2100, 1 / 40];
const dense = [
    -12715105075 / 11282082432,
    0,
    87487479700 / 32700410799,
    -10690763975 / 1880347072,
    701980252875 / 199316789632,
    -1453857185 / 822651844,
    69997945 / 29380423,
];

// One step of length h from y with first stage k1: { y, error, k }, six evaluations more.
function dormandPrince(f, tau, y, h, k1) {
    const k = [k1];
    let next = y;
    for (let s = 1; s < 7; ++s) {
        next = y.map((yi, i) => {
            let sum = 0;
            for (let n = 0; n < s; ++n) sum += rows[s][n] * k[n][i];
            return yi + h * sum;
        });
        k.push(f(tau + nodes[s] * h, next));
    }
    const error = y.map((_, i) => {
        let sum = 0;
        for (let n = 0; n < 7; ++n) sum += ((rows[6][n] ?? 0) - low[n]) * k[n][i];
        return h * sum;
    });
    return { y: next, error, k };
}
const between = (y, { y: next, k }, h, t, i) => {
    const rise = next[i] - y[i],
        b = h * k[0][i] - rise;
    let curl = 0;
    for (let n = 0; n < 7; ++n) curl += dense[n] * k[n][i];
    return y[i] + t * (rise + (1 - t) * (b + t * (rise - h * k[6][i] - b + (1 - t) * h * curl)));
};
// Integrates y' = f from tau to end; ends early where the guard, a function of (tau, y), falls to zero.
function* steps(f, tau, y, end, tolerance, guard) {
    let h = 0.05,
        k1 = f(tau, y);
    while (tau < end) {
        h = min(h, end - tau);
        const step = dormandPrince(f, tau, y, h, k1),
            error = max(...step.error.map((e, i) => abs(e) / (tolerance + tolerance * max(abs(y[i]), abs(step.y[i])))));
        if (!(error <= 1)) {
            h *= Number.isFinite(error) ? max(0.1, 0.9 * error ** -0.2) : 0.1;
            if (h < 1e-13) throw new RangeError('the step falls below 1e-13');
            yield null;
            continue;
        }
        const from = y,
            length = h,
            at = (t) => from.map((_, i) => between(from, step, length, t, i));
        let t = 1;
        if (guard && guard(tau + h, step.y) < 0) {
            // bisection on the interpolant
            let a = 0,
                b = 1;
            for (let n = 0; n < 50; ++n) {
                const m = (a + b) / 2;
                if (guard(tau + m * h, at(m)) < 0) b = m;
                else a = m;
            }
            t = b;
        }
        const before = { tau, h, t, at };
        tau = t < 1 ? tau + t * h : tau + h >= end ? end : tau + h;
        y = t < 1 ? at(t) : step.y;
        k1 = step.k[6];
        yield { ...before, to: tau, y, event: t < 1 };
        if (t < 1) return;
        h *= min(5, max(0.2, 0.9 * max(error, 1e-10) ** -0.2));
    }
}
// The right side of (6) as a system of first order; the friction force of the contact is given.
function rightSide(motion, friction, count) {
    const { N, K, C, mass, l, j } = motion;
    return (held) => (tau, y) => {
        ++count.evaluations;
        const out = new Array(2 * N);
        for (let k = 0; k < N; ++k) {
            let f = k === l ? cos(tau) : 0;
            for (let i = 0; i < N; ++i) f -= K[k][i] * y[i] + C[k][i] * y[N + i];
            if (k === j) f += friction(y[N + j]);
            out[k] = y[N + k];
            out[N + k] = f / mass[k];
        }
        if (held) out[j] = out[N + j] = 0;
        return out;
    };
}
// The last of `periods` periods at `samples` instants, in the way of Section 3.1: ode45's pair, events, sticking by (74).
// A generator: yields between steps, returns { samples: [tau][mass], evaluations }.
function* rungeKutta(scene, { tolerance, periods, samples, most }) {
    const motion = new ContactMotion(scene),
        { N, j, holds } = motion,
        count = { evaluations: 0 },
        end = 2 * PI * periods;
    let tau = 0,
        y = new Array(2 * N).fill(0),
        direction = 0,
        out = [];
    const loadAt = (t, z) => motion.load(z.slice(0, N), z.slice(N), t);
    const start = loadAt(0, y);
    if (abs(start) > holds) direction = sign(start);
    while (tau < end) {
        const f = rightSide(motion, () => -direction * motion.beta, count)(direction === 0),
            from = tau;
        const guard = direction ? (t, z) => (t - from > 1e-9 ? direction * z[N + j] : 1) : (t, z) => holds - abs(loadAt(t, z));
        let event = false;
        for (const step of steps(f, tau, y, end, tolerance, guard)) {
            yield;
            if (count.evaluations > most) throw new RangeError('more than ' + most + ' evaluations');
            if (!step) continue;
            collect(out, step, end, samples, N);
            ({ to: tau, y, event } = step);
        }
        if (!event) continue;
        const load = loadAt(tau, y);
        y = Array.from(y);
        if (direction) {
            y[N + j] = 0;
            direction = abs(load) <= holds ? 0 : sign(load);
        } else direction = sign(load);
    }
    return { samples: out, evaluations: count.evaluations };
}
// Motion with beta tanh(v / epsilon) in place of beta sgn(v): no events, and no rest.
function* regularised(scene, { epsilon, tolerance, periods, samples, most }) {
    const motion = new ContactMotion(scene),
        { N } = motion,
        count = { evaluations: 0 },
        end = 2 * PI * periods,
        out = [];
    const f = rightSide(motion, (v) => -motion.beta * tanh(v / epsilon), count)(false);
    for (const step of steps(f, 0, new Array(2 * N).fill(0), end, tolerance, null)) {
        yield;
        if (count.evaluations > most) throw new RangeError('more than ' + most + ' evaluations');
        if (step) collect(out, step, end, samples, N);
    }
    return { samples: out, evaluations: count.evaluations };
}
function collect(out, { tau, to, h, at }, end, samples, N) {
    for (; out.length < samples; ) {
        const wanted = end - 2 * PI + (2 * PI * out.length) / samples;
        if (wanted > to) return;
        out.push(at((wanted - tau) / h).slice(0, N));
    }
}
// Harmonic balance with the odd harmonics up to n: friction is a force of these harmonics, found so that in time it is what
// Coulomb's law makes of it and of the velocity, lambda = projection of lambda + rho v on [-beta, beta]. Newton's method on it.
// The law has mu = 1 here: with mu > 1 it jumps, and the projection has no fixed point of few harmonics.
function* harmonicBalance(scene, { harmonics, samples }) {
    const motion = new ContactMotion(scene),
        { N, j, l, K, C, mass, beta } = motion,
        orders = [];
    for (let n = 1; n <= harmonics; n += 2) orders.push(n);
    const size = 2 * orders.length,
        S = max(64, 8 * (harmonics + 1));
    // Response of every mass to a unit force of harmonic n on mass k: (K - n^2 M + i n C) X = e_k, real and imaginary part.
    const response = (n, k) => {
        const A = [];
        for (const half of [0, 1])
            for (let a = 0; a < N; ++a) {
                const re = K[a].map((y, b) => y - (a === b ? n * n * mass[a] : 0)),
                    im = C[a].map((y) => n * y);
                A.push([...(half ? im : re), ...(half ? re : im.map((y) => -y)), !half && a === k ? 1 : 0]);
            }
        const x = eliminated(A);
        return x && Array.from({ length: N }, (_, a) => [x[a], x[N + a]]);
    };
    const ofLoad = response(1, l),
        ofContact = orders.map((n) => response(n, j));
    if (!ofLoad || ofContact.some((x) => !x)) throw new RangeError('a mode without damping at its resonance');
    const waves = orders.map((n) => Array.from({ length: S }, (_, s) => [cos((n * 2 * PI * s) / S), sin((n * 2 * PI * s) / S)]));
    // f(tau) = sum of c_n cos n tau + s_n sin n tau; displacement of harmonic n under it: Re{(c - i s) X exp(i n tau)}.
    const velocity = (unknown) =>
        orders.map((n, h) => {
            const [c, s] = [unknown[2 * h], unknown[2 * h + 1]],
                [X, Y] = ofContact[h][j],
                load = n === 1 ? ofLoad[j] : [0, 0];
            const re = load[0] - (c * X + s * Y),
                im = load[1] - (c * Y - s * X); // friction opposes: force -lambda
            return [-n * im, -n * re]; // of cos and sin of the velocity
        });
    // The slope of the projection that brings v to lambda: of the size of what resists the contact's velocity.
    const rho = 1 / max(1e-9, ...orders.map((n, h) => n * hypot(...ofContact[h][j])));
    let evaluations = 0,
        unknown = new Array(size).fill(0),
        best = Infinity;
    const residualOf = (u) => {
        const v = velocity(u),
            residual = new Array(size).fill(0),
            slides = [];
        for (let s = 0; s < S; ++s) {
            let lambda = 0,
                speed = 0;
            for (let h = 0; h < orders.length; ++h) {
                const [a, b] = waves[h][s];
                lambda += u[2 * h] * a + u[2 * h + 1] * b;
                speed += v[h][0] * a + v[h][1] * b;
            }
            ++evaluations;
            const trial = lambda + rho * speed,
                force = max(-beta, min(beta, trial));
            slides.push(abs(trial) > beta);
            for (let h = 0; h < orders.length; ++h)
                for (const part of [0, 1]) residual[2 * h + part] -= (2 / S) * force * waves[h][s][part];
        }
        return { residual: residual.map((y, n) => y + u[n]), slides };
    };
    const zero = velocity(new Array(size).fill(0)),
        columns = Array.from({ length: size }, (_, n) => {
            const unit = new Array(size).fill(0);
            unit[n] = 1;
            return velocity(unit).map(([a, b], h) => [a - zero[h][0], b - zero[h][1]]);
        });
    let iterations = 0,
        state = residualOf(unknown);
    for (; iterations < 60; ++iterations) {
        yield;
        best = hypot(...state.residual);
        if (best <= 1e-13) break;
        // Derivative of the projection: where the contact holds, that of lambda + rho v; else none.
        const A = Array.from({ length: size }, (_, n) => {
            const row = new Array(size + 1).fill(0);
            row[n] = 1;
            row[size] = -state.residual[n];
            return row;
        });
        for (let n = 0; n < size; ++n)
            for (let s = 0; s < S; ++s) {
                if (state.slides[s]) continue;
                let rise = waves[n >> 1][s][n & 1];
                for (let h = 0; h < orders.length; ++h)
                    rise += rho * (columns[n][h][0] * waves[h][s][0] + columns[n][h][1] * waves[h][s][1]);
                for (let m = 0; m < size; ++m) A[m][n] -= (2 / S) * rise * waves[m >> 1][s][m & 1];
            }
        const step = eliminated(A);
        if (!step) break;
        let part = 1,
            next = null,
            tried = null;
        for (; part > 1 / 200; part /= 2) {
            next = unknown.map((y, n) => y + part * step[n]);
            tried = residualOf(next);
            if (hypot(...tried.residual) < best * (1 - part / 10)) break;
        }
        if (part <= 1 / 200) break;
        [unknown, state] = [next, tried];
    }
    const out = Array.from({ length: samples }, (_, s) =>
        Array.from({ length: N }, (_, k) =>
            orders.reduce((sum, n, h) => {
                const [c, b] = [unknown[2 * h], unknown[2 * h + 1]],
                    [X, Y] = ofContact[h][k],
                    load = n === 1 ? ofLoad[k] : [0, 0];
                const t = (n * 2 * PI * s) / samples;
                return sum + (load[0] - (c * X + b * Y)) * cos(t) - (load[1] - (c * Y - b * X)) * sin(t);
            }, 0),
        ),
    );
    return {
        samples: out,
        evaluations,
        iterations,
        residual: hypot(...state.residual),
        converged: hypot(...state.residual) <= 1e-8,
    };
}
// Largest difference of the contact's displacement from the exact motion, over its amplitude.
function errorOf(samples, steady, j) {
    let worst = 0;
    for (const [s, x] of samples.entries()) worst = max(worst, abs(x[j] - stateAt(steady, (2 * PI * s) / samples.length).x[j]));
    return steady.masses[j].amplitude > 0 ? worst / steady.masses[j].amplitude : NaN; // it never moves
}
module.exports = { rungeKutta, regularised, harmonicBalance, errorOf };
