// The motion from event to event: (6) with friction (2), (3) and the sticking conditions (74), (75), no step to choose.
// Between two events (6) is linear. Its Taylor series is summed to rounding over short steps, and the first event in a step is
// isolated by the signs of Bernstein coefficients, so that none is missed. A steady motion is a fixed point of the map over
// half-periods, found by Newton's method with the exact Jacobian. Displacements are in
// units of P / k_1; tau = 0 at the largest force.
'use strict';
const ClosedForm = require('./closed_form.js');
const degree = 24; // of the Taylor polynomials; a step is at most 1.6 over the fastest rate: 1.6^24 / 24! < 1e-18

// Polynomials on [0, 1], by ascending powers.
const valueAt = (p, t) => {
    let y = 0;
    for (let n = p.length - 1; n >= 0; --n) y = y * t + p[n];
    return y;
};
const slopeAt = (p, t) => {
    let y = 0;
    for (let n = p.length - 1; n > 0; --n) y = y * t + n * p[n];
    return y;
};
const derivative = (p) => Array.from({ length: p.length - 1 }, (_, n) => (n + 1) * p[n + 1]);
function bernstein(p) {
    // b_i = sum over k <= i of binomial(i, k) / binomial(d, k) p_k
    const d = p.length - 1,
        b = Array.from(p);
    for (let k = 1, binomial = 1; k <= d; ++k) b[k] /= binomial *= (d - k + 1) / k;
    for (let level = 1; level <= d; ++level) for (let i = d; i >= level; --i) b[i] += b[i - 1];
    return b;
}
function signChanges(b) {
    let changes = 0,
        last = 0;
    for (const y of b)
        if (y !== 0) {
            if (last * y < 0) ++changes;
            last = y;
        }
    return changes;
}
function halves(b) {
    // de Casteljau at 1/2
    const left = [],
        right = Array.from(b);
    for (let n = b.length; n > 0; --n) {
        left.push(right[0]);
        for (let i = 0; i + 1 < n; ++i) right[i] = (right[i] + right[i + 1]) / 2;
    }
    return [left, right];
}
function bisected(p, a, b) {
    // the one zero between a and b, by Newton's steps kept in the bracket
    let falls = valueAt(p, a) > valueAt(p, b),
        t = (a + b) / 2;
    for (let n = 0; n < 100 && b - a > 1e-17; ++n) {
        const y = valueAt(p, t);
        if (y === 0) return t;
        if (y > 0 === falls) a = t;
        else b = t;
        let next = t - y / slopeAt(p, t);
        if (!(next > a && next < b)) next = (a + b) / 2;
        if (abs(next - t) <= 1e-17) return next;
        t = next;
    }
    return t;
}
const { abs, max, min, hypot, PI, cos, sin, ceil } = Math;
// All zeros of p in (0, 1], or the first alone; a place where p only touches zero is divided until 40 halvings see no more of it.
function zeros(p, first = false, b = bernstein(p), from = 0, to = 1, depth = 0, found = []) {
    const changes = signChanges(b);
    if (changes === 0) {
        if (b[b.length - 1] === 0) found.push(to);
    } else if (changes === 1 && b[0] !== 0 && b[b.length - 1] !== 0) {
        found.push(bisected(p, from, to));
    } else if (depth === 40) {
        found.push(from);
    } else {
        const [left, right] = halves(b),
            middle = (from + to) / 2;
        zeros(p, first, left, from, middle, depth + 1, found);
        if (!(first && found.length)) zeros(p, first, right, middle, to, depth + 1, found);
    }
    return found;
}

// r^2 M x'' + r C x' + K x + beta e_j sgn(x_j') = e_l cos(tau), (6) with (8), (19); the contact free to slide or held.
class ContactMotion extends ClosedForm {
    constructor(scene) {
        super(scene);
        const { gamma, kappa, modes, mu, r, beta } = this,
            N = gamma.length;
        Object.assign(this, { N, holds: mu * beta, evaluations: 0, steps: 0 });
        this.mass = gamma.map((m) => r * r * m);
        this.K = gamma.map((_, a) =>
            gamma.map((_, b) => (a === b ? kappa[a] + (a + 1 < N ? kappa[a + 1] : 0) : abs(a - b) === 1 ? -kappa[max(a, b)] : 0)),
        );
        this.C = gamma.map((_, a) =>
            gamma.map((_, b) =>
                modes.reduce((s, m) => s + 2 * m.zeta * m.r_n * r * gamma[a] * m.phi[a] * gamma[b] * m.phi[b], 0),
            ),
        );
        this.rate = max(1, ...modes.map((m) => (m.r_n * (1 + 2 * m.zeta)) / r));
    }
    // The system under another friction ratio; numbers without friction are not computed again.
    withFriction(beta) {
        return Object.assign(Object.create(this), {
            beta,
            holds: this.mu * beta,
            evaluations: 0,
            steps: 0,
            found: undefined,
            known: undefined,
        });
    }
    demand(modes) {
        return modes ? super.demand(modes) : (this.known_demand ??= super.demand());
    }
    regime() {
        return (this.known ??= super.regime());
    }
    // Taylor coefficients of every displacement over [tau, tau + h], in powers of (time - tau) / h. Direction: 1, -1 or 0, held.
    // With `driven` false: those of a deviation, which neither force nor friction acts on.
    step(x, v, tau, h, direction, driven = true) {
        const { N, j, l, mass, K, C } = this,
            a = [],
            h2 = h * h;
        for (let k = 0; k < N; ++k) {
            const p = new Float64Array(degree + 1);
            p[0] = x[k];
            p[1] = k === j && direction === 0 ? 0 : h * v[k];
            a.push(p);
        }
        const wave = [cos(tau), -sin(tau), -cos(tau), sin(tau)];
        for (let n = 0, power = driven ? h2 : 0; n + 2 <= degree; power *= h / ++n) {
            // power: h^2 h^n / n!
            ++this.evaluations;
            const hn = h * (n + 1),
                scale = (n + 1) * (n + 2);
            for (let k = 0; k < N; ++k) {
                if (k === j && direction === 0) continue;
                let f = k === l ? power * wave[n % 4] : 0;
                if (n === 0 && k === j && driven) f -= h2 * this.beta * direction;
                const row = C[k],
                    springs = K[k];
                for (let i = 0; i < N; ++i) f -= hn * row[i] * a[i][n + 1] + h2 * springs[i] * a[i][n];
                a[k][n + 2] = f / (mass[k] * scale);
            }
        }
        return a;
    }
    // The load on the contact without friction, over a step: (75) with its sign.
    loadOver(a, tau, h) {
        const { N, j, l, K, C } = this,
            wave = [cos(tau), -sin(tau), -cos(tau), sin(tau)],
            load = new Float64Array(degree);
        for (let n = 0, power = 1; n < degree; power *= h / ++n) {
            let f = l === j ? power * wave[n % 4] : 0;
            for (let i = 0; i < N; ++i) f -= K[j][i] * a[i][n] + (C[j][i] * (n + 1) * a[i][n + 1]) / h;
            load[n] = f;
        }
        return load;
    }
    load(x, v, tau) {
        const { j, l, K, C } = this;
        return x.reduce((f, xk, k) => f - K[j][k] * xk - C[j][k] * v[k], l === j ? cos(tau) : 0);
    }
    // The motion from { x, v } at tau_0 to tau_1: phases with their steps; with deviations the derivative of its end as well.
    run(start, tau_0, tau_1, withDeviations = false) {
        const { N, j, holds, beta, mass } = this;
        let x = Array.from(start.x),
            v = Array.from(start.v),
            tau = tau_0;
        let direction = Math.sign(v[j]),
            order = 0;
        if (direction === 0) {
            const load = this.load(x, v, tau);
            if (abs(load) > holds) [direction, order] = [Math.sign(load), 1];
        }
        const phases = [];
        let deviations =
            withDeviations &&
            Array.from({ length: 2 * N }, (_, n) => ({
                x: x.map((_, k) => (k === n ? 1 : 0)),
                v: x.map((_, k) => (k + N === n && !(k === j && direction === 0) ? 1 : 0)),
            }));
        const longest = 1.6 / this.rate;
        let phase = null;
        while (tau < tau_1) {
            if (!phase) phases.push((phase = { direction, from: tau, to: tau, steps: [], at: x[j] }));
            if (++this.steps > 400000 || phases.length > 20000) throw new RangeError('the motion takes too many steps to follow');
            const left = tau_1 - tau,
                h = left <= longest ? left : left < 2 * longest ? left / 2 : longest;
            const a = this.step(x, v, tau, h, direction);
            let t = 1,
                next = null,
                slope = 0;
            if (direction !== 0) {
                const velocity = Array.from(a[j].subarray(1 + order), (y, n) => direction * y * (n + 1 + order));
                const [zero] = zeros(velocity, true);
                if (zero !== undefined && (zero > 0 || order === 0)) {
                    t = zero;
                    next = 'rest';
                }
            } else {
                const load = this.loadOver(a, tau, h);
                for (const side of [1, -1]) {
                    const margin = Array.from(load, (y, n) => (n === 0 ? holds : 0) - side * y);
                    const [zero] = margin[0] <= 0 ? [0] : zeros(margin, true);
                    if (zero !== undefined && (zero < t || next === null)) {
                        t = zero;
                        next = side;
                    }
                }
                if (next) slope = slopeAt(load, t) / h;
            }
            const last = tau + t * h >= tau_1 ? tau_1 : tau + t * h;
            phase.steps.push({ tau, h, length: last - tau, a });
            x = a.map((p) => valueAt(p, t));
            v = a.map((p) => slopeAt(p, t) / h);
            if (deviations)
                deviations = deviations.map((d) => {
                    const p = this.step(d.x, d.v, tau, h, direction, false);
                    return { x: p.map((q) => valueAt(q, t)), v: p.map((q) => slopeAt(q, t) / h) };
                });
            order = 0;
            phase.to = tau = last;
            if (!next) continue;
            v[j] = 0;
            const load = this.load(x, v, tau),
                before = direction;
            if (next === 'rest') [direction, order] = abs(load) <= holds ? [0, 0] : [Math.sign(load), 1];
            else [direction, order] = [next, holds > beta ? 1 : 2];
            // The event moves by -(deviation of its guard) / (rate of the guard); the acceleration of the contact jumps there.
            const acceleration = (d) => (d === 0 ? 0 : (load - d * beta) / mass[j]),
                jump = acceleration(before) - acceleration(direction);
            if (deviations && before !== 0)
                for (const d of deviations) d.v[j] = direction === 0 ? 0 : d.v[j] - (jump * d.v[j]) / acceleration(before);
            else if (deviations && jump !== 0) for (const d of deviations) d.v[j] -= (jump * this.load(d.x, d.v, PI / 2)) / slope;
            phase = null;
        }
        return { phases, end: { x, v }, deviations };
    }
    // z -> (-1)^h times the state h half-periods later.
    map(z, h, withDeviations = false) {
        const run = this.run(z, 0, h * PI, withDeviations),
            sign = h % 2 ? -1 : 1;
        const flat = ({ x, v }) => [...x, ...v].map((y) => sign * y);
        return { run, image: this.state(flat(run.end)), columns: run.deviations && run.deviations.map(flat) };
    }
    state(z) {
        return { x: z.slice(0, this.N), v: z.slice(this.N) };
    }
    // Fixed point of the map over h half-periods by Newton's method from z, steps halved where the residual does not fall.
    fixedPoint(z, h) {
        const n = 2 * this.N,
            flat = (s) => [...s.x, ...s.v];
        let at = flat(z),
            best = null,
            part = 1,
            newton = null;
        for (let tries = 0; tries < 40; ++tries) {
            const { image, columns, run } = this.map(this.state(at), h, true),
                d = flat(image).map((y, i) => y - at[i]);
            const residual = hypot(...d),
                size = hypot(...at);
            if (!Number.isFinite(residual)) return null;
            if (best && residual >= best.residual * (1 - part / 8)) {
                if (best.residual <= 1e-11 * (1 + best.size)) return best;
                part /= 2;
                if (part < 1 / 64) return null;
            } else {
                best = { z: this.state(at), at, residual, size, columns, run };
                if (residual <= 1e-15 * size) return best;
                part = 1;
                newton = eliminated(
                    Array.from({ length: n }, (_, row) => [
                        ...columns.map((column, k) => (k === row ? 1 : 0) - column[row]),
                        d[row],
                    ]),
                );
                if (!newton) return null;
            }
            at = best.at.map((y, i) => y + part * newton[i]);
        }
        return best && best.residual <= 1e-10 * (1 + best.size) ? best : null;
    }
    // The search for the steady motion that follows from rest at zero with the force at its maximum, or with mu = 1 from `start`:
    // yields the state after each half-period, returns the fixed point { z, h, residual }.
    *search(start = null) {
        const flat = (s) => [...s.x, ...s.v],
            apart = (a, b) => hypot(...flat(a).map((y, i) => y - flat(b)[i]));
        const nearby = start && this.mu === 1 && this.fixedPoint(start, 1);
        if (nearby) return { ...nearby, h: 1, half_periods: 0 };
        let z = this.state(new Array(2 * this.N).fill(0)),
            recent = [z];
        for (let done = 0, next = 6; ; next = min(1024, 2 * next)) {
            for (; done < next; ++done) {
                const { run, image } = this.map(z, 1);
                if (run.phases.every((p) => p.direction === 0) && this.restsForEver(z)) return this.stateOfRest();
                z = image;
                recent = [...recent.slice(-16), z];
                yield z;
            }
            const repeats = (h) => (recent.length > h ? apart(z, recent[recent.length - 1 - h]) : Infinity);
            const lengths = [1, 2, 3, 4, 5, 6, 8, 10, 12, 14, 16].filter(
                (h, n, all) => n === 0 || 2 * repeats(h) < min(...all.slice(0, n).map(repeats)),
            );
            for (const h of this.mu === 1 ? [1] : lengths) {
                const found = this.fixedPoint(z, h);
                if (found && (this.mu === 1 || (this.attracts(found.columns) && this.approaches(z, found.z, h))))
                    return { ...found, h, half_periods: done };
                yield z;
            }
            if (done >= 1024) throw new RangeError('no periodic motion was found in 512 periods');
        }
    }
    steadyStickSlip() {
        for (const search = this.search(); ; ) {
            const { done, value } = search.next();
            if (done) return value;
        }
    }
    attracts(columns) {
        // whether high powers of the Jacobian vanish
        let J = columns;
        for (let n = 0; n < 10; ++n)
            J = J.map((column) => column.map((_, row) => column.reduce((s, y, k) => s + J[k][row] * y, 0)));
        return J.every((column) => column.every((y) => abs(y) < 0.5));
    }
    approaches(z, fixed, h) {
        const apart = (a) => hypot(...a.x.map((y, k) => y - fixed.x[k]), ...a.v.map((y, k) => y - fixed.v[k])),
            first = apart(z);
        for (let n = 0; n < 256; ++n) {
            const now = apart(z);
            if (now <= first / 16 || now <= 1e-11) return true;
            z = this.map(z, h).image;
        }
        return apart(z) < first / 2;
    }
    // True if the contact, held in z, rests for ever. The load on it is that of the steady held motion, that of its own place,
    // and that of the free motion of the others, which is bounded by their energy and so never grows.
    restsForEver(z) {
        const { N, j, K, C, mass } = this,
            others = [...Array(N).keys()].filter((k) => k !== j),
            { X, limit } = this.held();
        const product = (a, b) => a.reduce((s, y, n) => s + y * b[n], 0),
            k_j = others.map((k) => K[j][k]);
        // Where the others stand still for a unit displacement of the contact.
        const follow = eliminated(others.map((a) => [...others.map((k) => K[a][k]), -K[a][j]]));
        const margin = this.holds - this.mu * limit - abs((K[j][j] + product(k_j, follow)) * z.x[j]);
        const dx = others.map((k, n) => z.x[k] - X[k][0] - follow[n] * z.x[j]),
            dv = others.map((k) => z.v[k] + X[k][1]);
        const pull = others.map((a) =>
                product(
                    others.map((k) => K[a][k]),
                    dx,
                ),
            ),
            energy =
                product(dx, pull) +
                product(
                    dv,
                    others.map((k, n) => mass[k] * dv[n]),
                );
        const damping = others.reduce((s, k) => s + C[j][k] ** 2 / mass[k], 0),
            weight = Math.sqrt(max(0, -product(k_j, follow))) + Math.sqrt(damping);
        return weight * Math.sqrt(energy) < margin;
    }
    // A state of the steady motion at tau = 0 by its formula: at rest at zero, or sliding throughout.
    stateOfRest() {
        const { X } = this.held();
        return { z: { x: X.map(([re]) => re), v: X.map(([, im]) => 0 - im) }, h: 1, residual: 0, half_periods: 0 };
    }
    // The one that the boundaries tell, or null where it has to be searched for.
    formula() {
        const regime = this.regime();
        if (regime !== 'continuous') return regime === 'stick_slip' ? null : this.stateOfRest();
        const { phi_j, W } = this.slide(),
            at = this.gamma.map((_, k) => this.motion(k, W, -phi_j));
        return { z: { x: at.map(([x]) => x), v: at.map(([, v]) => v) }, h: 1, residual: 0, half_periods: 0 };
    }
    // The steady motion over its period, in any regime: what the pages draw.
    steady(fixed = this.formula() || this.steadyStickSlip()) {
        const { j } = this,
            { z, h, residual, half_periods } = fixed;
        const periods = h % 2 ? h : h / 2,
            run = this.run(z, 0, 2 * PI * periods),
            period = 2 * PI * periods;
        // With mu = 1 the boundaries tell the regime; above, the motion from rest may be another than they have in mind.
        const lasting = run.phases.filter((p) => p.to > p.from),
            held = lasting.filter((p) => p.direction === 0);
        const met = held.length === 0 ? 'continuous' : held.length < lasting.length ? 'stick_slip' : 'permanent_sticking';
        const regime = this.mu > 1 ? met : this.regime();
        const closes = max(...run.end.x.map((x, k) => abs(x - z.x[k])), ...run.end.v.map((v, k) => abs(v - z.v[k])));
        const stops = stopsOf(run.phases, period);
        const masses = z.x.map((_, k) =>
            k === j && regime === 'permanent_sticking' ? { amplitude: 0, tau: NaN, x: 0 } : largestOf(run.phases, k),
        );
        const rest = stops.find(({ from, to }) =>
            [0, period].some((turn) => masses[j].tau + turn >= from && masses[j].tau + turn <= to),
        );
        if (rest && regime === 'stick_slip') masses[j].tau = rest.from; // the contact rests at its largest displacement
        for (const m of masses) m.lag = wrapped(m.tau + (m.x < 0 ? PI : 0));
        return { regime, z, h, periods, period, residual, half_periods, closes, phases: run.phases, stops, masses };
    }
    // As in ClosedForm, but for a contact that stops as well.
    withStops() {
        return this.regime() === 'stick_slip' && (this.found ??= this.steady());
    }
    amplitudeAndPhase(k) {
        const found = this.withStops();
        return found ? [found.masses[k].amplitude, found.masses[k].lag] : super.amplitudeAndPhase(k);
    }
    motionUnderForce(k, taus) {
        const found = this.withStops();
        return found ? taus.map((tau) => stateAt(found, tau).x[k]) : super.motionUnderForce(k, taus);
    }
    stops() {
        return this.withStops() ? this.found.stops : [];
    }
    stopsPerPeriod() {
        return this.withStops() ? this.found.stops.length / this.found.periods : 0;
    }
}
// Solves the augmented rows by elimination with the largest pivot; null where they are singular.
function eliminated(rows) {
    const n = rows.length;
    for (let p = 0; p < n; ++p) {
        let best = p;
        for (let i = p + 1; i < n; ++i) if (abs(rows[i][p]) > abs(rows[best][p])) best = i;
        [rows[p], rows[best]] = [rows[best], rows[p]];
        if (!(abs(rows[p][p]) > 1e-300)) return null;
        for (let i = p + 1; i < n; ++i) {
            const f = rows[i][p] / rows[p][p];
            if (f !== 0) for (let k = p; k <= n; ++k) rows[i][k] -= f * rows[p][k];
        }
    }
    const y = new Array(n);
    for (let p = n - 1; p >= 0; --p)
        y[p] = rows[p].slice(p + 1, n).reduce((s, a, i) => s - a * y[p + 1 + i], rows[p][n]) / rows[p][p];
    return y;
}
// Rests of positive length, { from, to, at }, from in [0, period); one across the end of the period is one.
function stopsOf(phases, period) {
    const rests = phases.filter((p) => p.direction === 0 && p.to > p.from).map((p) => ({ from: p.from, to: p.to, at: p.at }));
    const merged = [];
    for (const p of rests) {
        // two rests that follow each other without motion between are one
        const last = merged[merged.length - 1];
        if (last && last.to === p.from) last.to = p.to;
        else merged.push({ ...p });
    }
    if (merged.length > 1 && merged[0].from === 0 && merged[merged.length - 1].to >= period) {
        const tail = merged.pop();
        merged[0] = { from: tail.from, to: merged[0].to + period, at: tail.at };
        merged.push(merged.shift());
    }
    return merged;
}
const wrapped = (phi) => phi - 2 * PI * ceil((phi - PI) / (2 * PI)); // to (-pi, pi]
// Largest displacement of mass k over the motion, and where it is first.
function largestOf(phases, k) {
    let best = { amplitude: 0, tau: NaN, x: 0 };
    const take = (x, tau) => {
        if (abs(x) > best.amplitude * (1 + 4e-16)) best = { amplitude: abs(x), tau, x };
    };
    for (const { steps } of phases)
        for (const { tau, h, length, a } of steps) {
            const p = Array.from(a[k]),
                end = length / h;
            take(p[0], tau);
            take(valueAt(p, end), tau + length);
            let reach = 0;
            for (const y of bernstein(p)) reach = max(reach, abs(y));
            if (reach > best.amplitude * (1 + 1e-15))
                for (const t of zeros(derivative(p))) if (t <= end) take(valueAt(p, t), tau + h * t);
        }
    return best;
}
// Displacements and velocities of every mass at tau, 0 <= tau <= period.
function stateAt({ phases }, tau) {
    let n = 0;
    while (n + 1 < phases.length && phases[n].to <= tau) ++n;
    const { steps, direction } = phases[n];
    let s = 0;
    while (s + 1 < steps.length && steps[s].tau + steps[s].length <= tau) ++s;
    const { h, a } = steps[s],
        t = (tau - steps[s].tau) / h;
    return { direction, x: a.map((p) => valueAt(p, t)), v: a.map((p) => slopeAt(p, t) / h) };
}
module.exports = { ContactMotion, stateAt, eliminated, zeros, valueAt, derivative, wrapped };
