// Tests the numbers of the explorable pages without a browser. Usage: node engine_test.js; exit status 1 if a sentence does not hold.
// The kit grades the motion itself, through tests/conformance/adapters/javascript/adapter.js.
'use strict';
const assert = require('assert');
const fs = require('fs');
const path = require('path');
const explore = path.join(__dirname, '../../docs/explore');
const { ContactMotion, stateAt, zeros, valueAt } = require('../conformance/adapters/javascript/contact_motion.js');
const F = require(explore + '/printed.js'),
    A = require(explore + '/approximations.js'),
    D = require(explore + '/digits.js');
const P = require(explore + '/page.js');

let seed = 20220601;
const random = () => {
    seed = (seed * 48271) % 2147483647;
    return seed / 2147483647;
};
const between = (a, b) => a + (b - a) * random();
function scene(regime, { N = 1 + Math.floor(5 * random()), mu = 1 } = {}) {
    // a seeded scene whose regime is the one wanted
    for (;;) {
        const some = (a, b) => Array.from({ length: N }, (_, n) => (n === 0 ? 1 : between(a, b)));
        const s = {
            mass_ratios: some(0.5, 2),
            stiffness_ratios: some(0.5, 2),
            damping_ratios: Array.from({ length: N }, () => between(0.005, 0.2)),
            contact: 1 + Math.floor(N * random()),
            load: 1 + Math.floor(N * random()),
            mu,
            r: between(0.15, 2),
            beta: 0,
        };
        const c = new ContactMotion(s),
            limit = c.beta_lim(c.demand()),
            sticking = c.held().limit;
        s.beta =
            regime === 'continuous'
                ? limit * between(0.05, 0.95)
                : regime === 'stick_slip'
                  ? limit + (sticking - limit) * between(0.05, 0.95)
                  : sticking * between(1.05, 2);
        if (new ContactMotion(s).regime() === regime) return s;
    }
}
const drain = (search) => {
    for (;;) {
        const { done, value } = search.next();
        if (done) return value;
    }
};
let failed = 0,
    sentences = 0;
function holds(sentence, check) {
    ++sentences;
    try {
        check();
    } catch (fault) {
        ++failed;
        console.error(sentence + '\n    ' + fault.message);
    }
}
const near = (x, y, tolerance, what) => assert.ok(Math.abs(x - y) <= tolerance, `${what}: ${x} against ${y}`);

holds('all zeros of a polynomial are found, and none is added', () => {
    for (let n = 0; n < 200; ++n) {
        const roots = Array.from({ length: 1 + Math.floor(6 * random()) }, () => between(-0.5, 1.5)).sort((a, b) => a - b);
        const p = roots.reduce((q, x) => [...q, 0].map((_, i) => (i > 0 ? q[i - 1] : 0) - x * (q[i] ?? 0)), [1]);
        const wanted = roots.filter((x) => x > 0 && x <= 1),
            found = zeros(p);
        assert.strictEqual(found.length, wanted.length, `of ${roots}`);
        found.forEach((x, i) => near(x, wanted[i], 1e-5, 'a zero')); // ill-conditioned where two are close
        assert.ok(
            zeros(
                p.map((y) => -y),
                true,
            )[0] === found[0],
        );
    }
});
holds('the closed form is a motion: followed from event to event it returns to itself, and never rests', () => {
    for (let n = 0; n < 60; ++n) {
        const { closes, stops } = new ContactMotion(scene('continuous')).steady();
        assert.ok(closes < 1e-11, 'it misses itself by ' + closes);
        assert.strictEqual(stops.length, 0);
    }
});
holds('from a start that (44) gives as printed the motion does not return to itself', () => {
    const c = new ContactMotion({
        mass_ratios: [1, 1],
        stiffness_ratios: [1, 1],
        damping_ratios: [0.1, 0.1],
        contact: 2,
        load: 1,
        mu: 1,
        r: 0.9,
        beta: 0.2,
    });
    const entry = F.equations.find((e) => e.eq[0] === '44'),
        { z } = c.formula(),
        off = entry.printed(c, 0.2, 0) - entry.corrected(c, 0.2, 0);
    assert.ok(c.steady({ z: { x: [z.x[0] + off, z.x[1]], v: z.v }, h: 1 }).closes > 1e-3);
});
holds('a steady motion with stops is a fixed point, found within a number of evaluations', () => {
    for (let n = 0; n < 60; ++n) {
        const s = scene('stick_slip'),
            c = new ContactMotion(s),
            { closes, stops, h } = c.steady();
        assert.ok(closes < 1e-10, `${JSON.stringify(s)} misses itself by ${closes}`);
        assert.ok(stops.length >= 1 && h === 1);
        assert.ok(c.evaluations < 400000, `${c.evaluations} evaluations for ${JSON.stringify(s)}`);
    }
});
holds('a small step of a slider costs a few evaluations, as the search starts from the motion before', () => {
    const s = {
        mass_ratios: [1, 1, 1, 1, 1],
        stiffness_ratios: [1, 1, 1, 1, 1],
        damping_ratios: [0.05, 0.05, 0.05, 0.05, 0.05],
        contact: 3,
        load: 1,
        mu: 1,
        r: 0.9,
        beta: 0.7,
    };
    const { z } = new ContactMotion(s).steady(),
        next = new ContactMotion({ ...s, beta: 0.705 });
    next.steady(drain(next.search(z)));
    assert.ok(next.evaluations < 20000, next.evaluations + ' evaluations');
});
holds('a contact that is held stays where it is', () => {
    for (let n = 0; n < 30; ++n) {
        const c = new ContactMotion(scene('permanent_sticking')),
            found = c.steady();
        assert.ok(
            found.phases.length === 1 && found.phases[0].direction === 0 && found.closes < 1e-11,
            JSON.stringify([found.closes, found.phases.length]),
        );
    }
});
holds('every equation that does not hold as printed shows where its page opens, and the corrected form has a value there', () => {
    for (const entry of F.equations) {
        const s = P.sceneOf(P.stateOf(P.sceneDefaults, '#' + entry.open)),
            { from, to, key } = entry.over;
        let most = 0,
            values = 0;
        for (let n = 1; n < 20; ++n) {
            const x = from + ((to - from) * n) / 20,
                c = F.exactly(F.at(entry, s, x)),
                [a, b] = ['printed', 'corrected'].map((form) => F.value(entry, entry[form], c, x, 0, 0));
            if (Number.isFinite(b)) ++values;
            if (Number.isFinite(a)) most = Math.max(most, Number.isFinite(b) ? Math.abs(a - b) / Math.max(Math.abs(b), 1e-3) : 1);
        }
        assert.ok(values > 0 && most > 1e-4, `(${entry.eq}) over ${key ?? 'its axis'}: ${values} values, ${most} apart`);
    }
});
holds('the corrected forms of the motion agree with the motion from event to event', () => {
    for (let n = 0; n < 25; ++n) {
        const s = scene('continuous'),
            c = F.exactly(s),
            found = c.steady(),
            { phi_j, start } = c.slide(),
            k = Math.floor(c.gamma.length * random()),
            tau = between(0, Math.PI);
        const at = (t) => stateAt(found, (((t + phi_j) % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI)),
            of = (eq, x, i = 0) => {
                const e = F.equations.find((f) => f.eq.includes(eq));
                return e.corrected(c, x, k, i);
            };
        near(of('46', tau), at(tau).x[k], 1e-10, '(46)');
        near(of('44', 0), at(0).x[k], 1e-10, '(44)');
        near(of('45', 0), at(0).v[k], 1e-10, '(45)');
        near(of('52', 0), Math.hypot(...start[k]), 1e-12, '(52)');
        const modes = c.modes.map((m, i) => [(m.phi[k] / c.r) * of('40', tau, i), (m.phi[k] / c.r) * of('A.7', tau, i)]);
        near(
            modes.reduce((sum, y) => sum + y[0], 0),
            at(tau).x[k],
            1e-9,
            '(40), summed over the modes',
        );
        near(
            modes.reduce((sum, y) => sum + y[1], 0),
            at(tau).v[k],
            1e-9,
            '(A.7), summed over the modes',
        );
        const m = c.modes[0],
            turn = m.v[0] * Math.cos(phi_j) - m.v[1] * Math.sin(phi_j);
        near(of('A.12', 0), turn, 1e-8 * Math.hypot(...m.v), '(A.12)');
    }
});
holds('Runge-Kutta, regularised friction and harmonic balance tend to the exact motion, each with its own effort', () => {
    for (const s of [scene('stick_slip', { N: 1 }), scene('continuous', { N: 2 })]) {
        s.damping_ratios = s.damping_ratios.map(() => 0.15);
        const c = new ContactMotion(s),
            found = c.steady(),
            error = (run) => {
                const { samples, evaluations } = drain(run);
                return [A.errorOf(samples, found, c.j), evaluations];
            };
        const rk = [1e-3, 1e-6, 1e-9].map((tolerance) =>
            error(A.rungeKutta(s, { tolerance, periods: 40, samples: 64, most: 1e7 })),
        );
        const tanh = [0.1, 0.01].map((epsilon) =>
            error(A.regularised(s, { epsilon, tolerance: 1e-8, periods: 40, samples: 64, most: 1e7 })),
        );
        const hb = [1, 9, 25].map((harmonics) => error(A.harmonicBalance(s, { harmonics, samples: 64 })));
        for (const [name, all] of Object.entries({ rk, tanh, hb }))
            for (let n = 1; n < all.length; ++n)
                assert.ok(all[n][0] < all[n - 1][0] && all[n][1] > 0, `${name}: ${JSON.stringify(all)} for ${JSON.stringify(s)}`);
        assert.ok(rk[2][0] < 1e-6 && tanh[1][0] < tanh[0][0] / 5 && hb[2][0] < hb[0][0] / 5, JSON.stringify([rk, tanh, hb]));
    }
});
holds('the reference is the same in twice the bits, and the shipped form is near it where the printed one is not', () => {
    for (let n = 0; n < 60; ++n) {
        const R = (1 / (2 * Math.floor(5 * random()) + 1)) * (1 + 10 ** between(-12, -3)),
            zeta = 10 ** between(-12, -3);
        const exact = D.reference(R, zeta),
            again = D.reference(R, zeta, 840),
            shipped = D.shipped(R, zeta),
            printed = D.printed(R, zeta);
        assert.deepStrictEqual(exact, again);
        for (const key of ['u', 'g']) {
            assert.ok(
                D.unitsApart(shipped[key], exact[key]) <= 64,
                `${key}(${R}, ${zeta}): ${shipped[key]} against ${exact[key]}`,
            );
            assert.ok(D.digitsOf(printed[key], exact[key]) < 15.9);
        }
    }
    const a = D.arithmetic(200);
    assert.ok(D.toDouble(a.pi, 200) === Math.PI && D.toDouble(a.exponential(a.one), 200) === Math.E);
    assert.ok(valueAt([1, 2, 3], 2) === 17);
});
holds('each equation of the ledger has a place to be seen, on a page that is there, in a state that the page knows', () => {
    const places = JSON.parse(fs.readFileSync(explore + '/places.json', 'utf8'));
    const all = JSON.parse(fs.readFileSync(explore + '/../ledger/equations.json', 'utf8')).map((row) => row.equation);
    assert.deepStrictEqual(Object.keys(places), all);
    const own = { machine: [], plane: ['q', 'rmax', 'bmax', 'on'], printed: ['eq', 'm', 'i', 'x'], digits: ['n', 'd', 'side'] };
    for (const [eq, place] of Object.entries(places)) {
        const [page, hash = ''] = place.split('#'),
            keys = own[page.replace('.html', '')];
        assert.ok(keys && fs.existsSync(path.join(explore, page)), `(${eq}) leads to ${page}`);
        for (const part of hash.split('&').filter(Boolean))
            assert.ok([...P.sceneKeys, ...keys].includes(part.split('=')[0]), `(${eq}) asks for ${part}`);
        assert.strictEqual(P.brokenRule(P.sceneOf(P.stateOf(P.sceneDefaults, hash))), null);
    }
    for (const { eq } of F.equations)
        for (const one of eq) assert.ok(places[one].startsWith('printed.html#eq=' + eq[0]), `(${one}) leads to ${places[one]}`);
});
holds('a state that breaks a rule is told with quantity, rule and value', () => {
    const of = (hash) => P.brokenRule(P.sceneOf(P.stateOf(P.sceneDefaults, hash)));
    assert.match(of('mu=0.5'), /^mu must be at least 1, but is 0.5$/);
    assert.match(of('r=0'), /^r must be positive, but is 0$/);
    assert.match(of('b=-1'), /^beta must not be negative, but is -1$/);
    assert.match(of('N=2&g=1,-2'), /^mass ratios, number 2 must be positive, but is -2$/);
    assert.match(of('g=2'), /^the first of the mass ratios must be 1, but is 2$/);
    assert.match(of('z=x'), /damping ratio 1 must not be negative, but is NaN/);
});
console.log(`${sentences - failed} of ${sentences} sentences hold`);
process.exit(failed ? 1 : 0);
